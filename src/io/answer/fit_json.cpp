// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "bankshot/learn/fit.hpp"
#include "io/scene/write_scene.hpp"

namespace bankshot {
namespace {

Json shot_json(const FittedShot& s) {
  Json j{{"id", id_json(s.id)},    {"shot", launch_json(s.launch, s.spin)},
         {"at", pair_json(s.at)},  {"start", s.start},
         {"cushions", s.cushions}, {"rms", s.rms},
         {"samples", s.samples},   {"outliers", s.outliers}};
  if (s.unexplained > 0) j["unexplained"] = s.unexplained;
  return j;
}

double median(std::vector<double> v) {
  if (v.empty()) return 0;
  std::ranges::sort(v);
  const std::size_t n = v.size();
  return n % 2 ? v[n / 2] : (v[n / 2 - 1] + v[n / 2]) / 2;
}

std::vector<double> rms_of(std::span<const FittedShot> shots, int least_cushions) {
  std::vector<double> out;
  for (const FittedShot& s : shots)
    if (s.samples > 0 && s.cushions >= least_cushions) out.push_back(s.rms);
  return out;
}

std::vector<double> rms_of(std::span<const Prediction> predictions) {
  std::vector<double> out;
  for (const Prediction& p : predictions)
    if (p.samples > 0) out.push_back(p.rms);
  return out;
}

std::string list(const std::vector<std::string>& names) {
  std::string out;
  for (std::size_t i = 0; i < names.size(); ++i)
    out += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return out;
}

}  // namespace

double median_rms(std::span<const FittedShot> shots, int least_cushions) {
  return median(rms_of(shots, least_cushions));
}
double median_rms(std::span<const Prediction> predictions) { return median(rms_of(predictions)); }

std::string message_of(const Fit& fit) {
  constexpr double mm = 1000;
  constexpr int many = 3;
  long samples = 0, outliers = 0, unexplained = 0;
  for (const FittedShot& s : fit.shots) samples += s.samples, outliers += s.outliers, unexplained += s.unexplained;
  std::string out = fmt::format(
      "{} shots, {} samples and {} outliers: half of the shots within {:.2g} mm (root mean square); a coordinate errs "
      "by "
      "{:.2g} mm.",
      fit.shots.size(), samples, outliers, mm * median_rms(fit.shots), mm * fit.sigma);
  if (const auto long_ones = rms_of(fit.shots, many); !long_ones.empty() && long_ones.size() < fit.shots.size())
    out += fmt::format(" Of {} with {} or more bounces half are within {:.2g} mm.", long_ones.size(), many,
                       mm * median(long_ones));
  if (unexplained > 0)
    out +=
        fmt::format(" {} samples come after a contact that the fit does not follow, and were not used.", unexplained);
  for (const HeldCoefficient& h : fit.held)
    out += h.like.empty() ? fmt::format(" The recordings say too little of {}: it is held at {:.4g}.", h.name, h.value)
                          : fmt::format(" The recordings cannot tell {} from {}: it is held at {:.4g}.", h.name,
                                        list(h.like), h.value);
  if (!fit.models.empty()) {
    std::string scores;
    for (const ModelScore& m : fit.models)
      scores += fmt::format("{}{} {:.2g} mm", scores.empty() ? "" : "; ", m.model, mm * m.predicted);
    out += fmt::format(" Cushions after {} predict best what was left out: {}.", fit.model, scores);
  }
  if (const auto p = rms_of(fit.predictions); !p.empty())
    out += fmt::format(
        " From their first part, to 0.25 s after the first bounce, the rest of {} shots was predicted: half "
        "within {:.2g} mm.",
        p.size(), mm * median(p));
  return out;
}

std::string to_json(const Fit& fit) {
  Json j = Json::object();
  j["physics"] = physics_json(fit.physics);
  const auto fitted = [&](std::string_view name) {
    return std::ranges::find(fit.parameters, name, &FittedCoefficient::name) != fit.parameters.end();
  };
  if (!is_level(fit.physics)) j["tilt"] = pair_json(fit.physics.tilt);
  if (fitted("camera.scale") || fitted("camera.x") || fitted("camera.y"))
    j["camera"] = {{"scale", fit.camera_scale}, {"offset", pair_json(fit.camera_offset)}};
  j["parameters"] = Json::array();
  for (const FittedCoefficient& p : fit.parameters)
    j["parameters"].push_back(
        {{"name", p.name}, {"value", p.value}, {"error", p.error}, {"correlated_with", p.correlated_with}});
  j["held"] = Json::array();
  for (const HeldCoefficient& h : fit.held)
    j["held"].push_back({{"name", h.name}, {"value", h.value}, {"like", h.like}});
  j["shots"] = Json::array();
  for (const FittedShot& s : fit.shots) j["shots"].push_back(shot_json(s));
  j["sigma"] = fit.sigma;
  if (!fit.models.empty()) {
    j["models"] = Json::array();
    for (const ModelScore& m : fit.models)
      j["models"].push_back({{"model", m.model}, {"rms", m.fitted}, {"predicted", m.predicted}});
  }
  j["holdout"] = nullptr;
  if (!fit.predictions.empty()) {
    Json shots = Json::array();
    for (const Prediction& p : fit.predictions)
      shots.push_back({{"id", id_json(p.id)}, {"rms", p.rms}, {"samples", p.samples}});
    j["holdout"] = {{"rms", median_rms(fit.predictions)}, {"shots", std::move(shots)}};
  }
  j["simulations"] = fit.simulations;
  j["restarts"] = fit.restarts;
  j["message"] = message_of(fit);
  return write_json(j);
}

std::string physics_of(const Fit& fit) { return write_json(physics_json(fit.physics)); }

}  // namespace bankshot
