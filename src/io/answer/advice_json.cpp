// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bankshot/learn/advise.hpp"
#include "io/scene/write_scene.hpp"

namespace bankshot {
namespace {

/// Converts angles to degrees, as used in files.
double in_file(const PlayerError& e, double value) { return e.name == "angle" ? degrees(value) : value; }
Json interval(const PlayerError& e, const Range& r) {
  const auto end = [&](double v) { return std::isfinite(v) ? Json(in_file(e, v)) : Json(); };
  return Json::array({end(r.low), end(r.high)});
}

Json noise_json(const Advice& advice) {
  Json j = Json::object();
  for (const PlayerError& e : advice.errors) j[e.name] = in_file(e, e.sigma);
  return j;
}

std::string one_error(const PlayerError& e) {
  constexpr double percent = 100;
  const auto number = [&](double v) {
    return e.name == "angle" ? fmt::format("{:.3f}", degrees(v)) : fmt::format("{:.3f}", v);
  };
  const std::string unit = e.name == "angle" ? " degrees" : e.name == "speed" ? " m/s" : " of a natural roll";
  if (e.sigma == 0) return fmt::format(" {}: not told by these attempts.", e.name);
  std::string out = fmt::format(" {}: {}{} ({} to {}", e.name == "angle" ? "aim" : e.name, number(e.sigma), unit,
                                number(e.sigma_interval.low), number(e.sigma_interval.high));
  if (!e.bias_is_told) return out + ").";
  if (e.bias_interval.low <= 0 && e.bias_interval.high >= 0) return out + ", no bias seen).";
  const bool more = e.bias > 0;
  if (e.name == "angle")
    return out + fmt::format("), {} degrees to the {} on average.", number(std::abs(e.bias)), more ? "left" : "right");
  if (e.name == "speed")
    return out + fmt::format("), {:.1f} % too {} on average.", percent * std::abs(e.bias), more ? "hard" : "soft");
  return out + fmt::format("), {} too {} on average.", number(std::abs(e.bias)),
                           e.name == "top" ? (more ? "high" : "low") : (more ? "far to the right" : "far to the left"));
}

Json shot_json(const Shot& s) { return launch_json(s.launch, s.spin); }

}  // namespace

std::string message_of(const Advice& advice) {
  constexpr double percent = 100;
  const auto left_out = std::ranges::count(advice.attempts, true, &AttemptError::left_out);
  std::string out = fmt::format("{} attempts", advice.attempts.size());
  if (left_out > 0) out += fmt::format(", {} of them left out: no launch explains them, or they are miscues", left_out);
  out += ". One standard deviation (and where it lies with 95 %):";
  for (const PlayerError& e : advice.errors) out += one_error(e);
  if (advice.shots.empty()) return out;
  const auto best = advice.shots.begin();
  if (!best->solved) return out + " None of the puzzles has a shot.";
  return out +
         fmt::format(
             " Of {} puzzles choose {}: made {:.0f} % of the time. Choosing by this noise and not by the puzzles' "
             "own gains {:.1f} % in the choice of a puzzle, {:.1f} % in the choice of a shot within one.",
             advice.shots.size(), best->id.empty() ? "the first" : best->id, percent * best->success,
             percent * advice.gain_by_puzzle, percent * advice.gain_by_shot);
}

std::string to_json(const Advice& advice) {
  Json j = Json::object();
  j["noise"] = noise_json(advice);
  j["errors"] = Json::array();
  for (const PlayerError& e : advice.errors) {
    Json error{{"name", e.name}, {"sigma", in_file(e, e.sigma)}, {"interval", interval(e, e.sigma_interval)}};
    error["bias"] = nullptr;
    if (e.bias_is_told) error["bias"] = {{"mean", in_file(e, e.bias)}, {"interval", interval(e, e.bias_interval)}};
    j["errors"].push_back(std::move(error));
  }
  j["attempts"] = Json::array();
  for (const AttemptError& a : advice.attempts) {
    Json attempt{{"id", id_json(a.id)}};
    if (a.measured && !a.left_out) {
      attempt["error"] = {{"angle", degrees(a.angle)}, {"speed", a.speed}, {"side", a.side}, {"top", a.top}};
      attempt["rms"] = a.rms;
    }
    if (a.left_out) attempt["left_out"] = true;
    j["attempts"].push_back(std::move(attempt));
  }
  j["shots"] = Json::array();
  for (const Choice& c : advice.shots) {
    Json choice{{"id", id_json(c.id)}};
    if (c.solved) {
      choice["shot"] = shot_json(c.shot);
      choice["success"] = c.success;
      choice["usual"] = {{"shot", shot_json(c.usual)}, {"success", c.success_of_usual}};
    }
    j["shots"].push_back(std::move(choice));
  }
  if (!advice.shots.empty()) j["gain"] = {{"by_puzzle", advice.gain_by_puzzle}, {"by_shot", advice.gain_by_shot}};
  j["message"] = message_of(advice);
  return write_json(j);
}

std::string noise_of(const Advice& advice) { return write_json(noise_json(advice)); }

}  // namespace bankshot
