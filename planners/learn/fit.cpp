// SPDX-License-Identifier: MIT
#include "bankshot/learn/fit.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "planners/learn/goodness.hpp"
#include "planners/learn/launch.hpp"
#include "planners/learn/least_squares.hpp"
#include "planners/learn/models.hpp"
#include "planners/learn/predict.hpp"

namespace bankshot {
namespace planning {
namespace {

/// Returns whether a coefficient counts as physics; tilt and camera do not.
bool is_of_physics(const std::string& name) { return !name.starts_with("tilt") && !name.starts_with("camera"); }

/// Returns the known coefficients that match the names asked for; without any, all of the physics.
std::vector<std::string> names_asked(const std::vector<Fittable>& known, const std::vector<std::string>& free) {
  const auto is_part = [](const std::string& name, const std::string& of) {
    return name == of || name.starts_with(of + ".");
  };
  for (const std::string& of : free)
    if (of != "launch" && std::ranges::none_of(known, [&](const Fittable& f) { return is_part(f.name, of); }))
      throw InvalidInput("", "\"" + of + "\" is nothing that this physics lets a fit move");
  std::vector<std::string> out;
  for (const Fittable& f : known)
    if (free.empty() ? is_of_physics(f.name)
                     : std::ranges::any_of(free, [&](const std::string& of) { return is_part(f.name, of); }))
      out.push_back(f.name);
  return out;
}

FittedShot fitted_shot(const Seen& seen, const Common& common, Spent& work) {
  const ShotRequest shot = with_launch(seen.recording.scene, seen.launch);
  FittedShot out{
      .id = shot.id, .start = seen.launch[start_time], .at = shot.ball.at, .launch = shot.launch, .spin = shot.spin};
  Distances off = distances(seen, common);
  out.rms = off.rms;
  out.samples = off.samples, out.outliers = off.outliers, out.unexplained = off.unexplained;
  out.distances = std::move(off.each);
  out.counted = std::move(off.counted);
  if (const auto played = play(seen, common, seen.last - out.start, work)) out.cushions = played->cushions;
  return out;
}

std::vector<FittedShot> fitted_shots(const Learnt& l, Spent& work) {
  std::vector<FittedShot> out;
  for (const Seen& seen : l.shots) out.push_back(fitted_shot(seen, l.common, work));
  return out;
}

/// Returns the mean square residual per degree of freedom, in sigmas; errors of the coefficients are scaled by it.
double left_over(const Learnt& l, const std::vector<FittedShot>& shots) {
  double sum = 0;
  auto rows = -static_cast<double>(l.common.names.size());
  auto seen = l.shots.begin();
  for (const FittedShot& shot : shots) {
    const Seen& its = *seen++;
    if (its.left_out) continue;
    const double off = shot.rms / its.sigma;
    sum += shot.samples * off * off;
    rows += 2 * shot.samples - launch_size;
  }
  return rows > 0 ? sum / rows : 1;
}

/// Writes the coefficients with their errors and correlations.
void tell_coefficients(const Common& common, const Eigen::MatrixXd& covariance, Fit& out) {
  const auto m = static_cast<Eigen::Index>(common.names.size());
  std::vector<Eigen::Index> of_physics;
  for (Eigen::Index i = 0; i < m; ++i) {
    const auto k = static_cast<std::size_t>(i);
    FittedCoefficient& p = out.parameters.emplace_back(FittedCoefficient{common.names[k], common.values[k], 0});
    if (p.name == "camera.scale") out.camera_scale = p.value;
    if (p.name == "camera.x") out.camera_offset.x = p.value;
    if (p.name == "camera.y") out.camera_offset.y = p.value;
    if (covariance.size() == 0) continue;
    if (is_of_physics(p.name)) of_physics.push_back(i);
    p.error = std::sqrt(covariance(i, i));
    for (Eigen::Index j = 0; j < m; ++j) {
      out.covariance.push_back(covariance(i, j));
      constexpr double close = 0.9;
      if (j != i && std::abs(covariance(i, j)) > close * std::sqrt(covariance(i, i) * covariance(j, j)))
        p.correlated_with.push_back(common.names[static_cast<std::size_t>(j)]);
    }
  }
  if (covariance.size() == 0) return;
  CoefficientErrors& errors = out.physics.errors.emplace();
  for (const Eigen::Index i : of_physics) {
    errors.names.push_back(common.names[static_cast<std::size_t>(i)]);
    for (const Eigen::Index j : of_physics) errors.covariance.push_back((covariance(i, j) + covariance(j, i)) / 2);
  }
}

/// Properties that the recordings share before anything is learnt.
struct Given {
  Physics physics;
  Body body;
  bool meets_balls = false;
};

Given given_by(const Recordings& recordings) {
  const ShotRequest& first = recordings.front()->scene;
  Given out{first.physics, first.ball.body};
  for (const Recording* r : recordings) {
    if (r->scene.physics.motion.index() != first.physics.motion.index())
      throw InvalidInput("/physics", "is of another model than the first recording's: one fit has one");
    out.meets_balls = out.meets_balls || !r->scene.others.empty();
  }
  return out;
}

Asked asked(const Given& given, const FitWish& wish) {
  const Physics physics = with_laws(given.physics, wish, given.body);
  return {physics, names_asked(coefficients_of(physics, given.body, given.meets_balls), wish.free),
          std::max(1, wish.threads)};
}

/// The table learnt from all shots, and how well others predict the shots that were left out.
struct Tried {
  Learnt learnt;
  double seconds = 0;  ///< time that learning from all of them took
  std::vector<Prediction> predictions{};
};

/// Learns from all shots; `group` 0: no shots are left out and predicted.
Tried try_out(const Recordings& all, const Asked& asked, int group, Spent& work,
              const std::function<void(double)>& progress) {
  const double fits = 1 + (group > 0 ? std::ceil(static_cast<double>(all.size()) / group) : 0);
  const auto begin = std::chrono::steady_clock::now();
  Tried out{learn(all, asked, work, [&](double share) { progress(share / fits); })};
  out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (group > 0)
    out.predictions =
        held_out(all, asked, group, work, [&](double share) { progress((1 + (fits - 1) * share) / fits); });
  return out;
}

/// Returns how well a law predicts [m], or how well it follows the shots if there was nothing to predict.
double score(const ModelScore& law, const std::vector<Prediction>& predictions) {
  const bool any = std::ranges::any_of(predictions, [](const Prediction& p) { return p.samples > 0; });
  return any ? law.predicted : law.fitted;
}

/// Returns the law that best predicts shots left out. Laws whose impacts are integrated are not tried: that would take
/// about ten times as long.
Tried best_model(const Recordings& all, const Given& given, const FitWish& wish, Fit& out, Spent& work,
                 const std::function<void(double)>& progress) {
  std::vector<std::string> models;
  for (const CushionModel& model : cushion_registry)
    if (model.tried_by_fit) models.emplace_back(model.key);
  constexpr FitWish::BySpeed laws[] = {FitWish::BySpeed::constant, FitWish::BySpeed::linear};
  const auto tries = static_cast<double>(models.size() * std::size(laws));
  const int group = wish.holdout > 0 ? wish.holdout : std::max(1, static_cast<int>(all.size()) / 4);
  std::optional<Tried> best;
  double least = forever;
  for (const std::string& model : models)
    for (const FitWish::BySpeed restitution : laws) {
      FitWish one = wish;
      one.model = model, one.restitution = restitution;
      const Asked its = asked(given, one);
      const auto tried = static_cast<double>(out.models.size());
      Tried t = try_out(all, its, group, work, [&](double share) { progress((tried + share) / tries); });
      out.models.push_back({model_name(its.base), median_rms(fitted_shots(t.learnt, work)), median_rms(t.predictions)});
      const double its_score = score(out.models.back(), t.predictions);
      if (best && !(its_score < least)) continue;
      least = its_score, out.model = out.models.back().model;
      best.emplace(std::move(t));
    }
  return std::move(*best);
}

}  // namespace
}  // namespace planning

std::vector<std::string> fit_names(const Physics& physics) {
  std::vector<std::string> out;
  for (const auto& f : planning::coefficients_of(physics, Body{}, true)) out.push_back(f.name);
  return out;
}

Fit fit(std::span<const Recording> recordings, const FitWish& wish) {
  using namespace planning;
  if (recordings.empty()) throw InvalidInput("", "there is no recording to fit");
  Recordings all;
  for (const Recording& r : recordings) all.push_back(&r);
  const auto progress = [&](double share) {
    if (wish.progress) wish.progress(share);
  };
  const Given given = given_by(all);
  Fit out;
  Spent work;
  Tried tried = wish.model == "any" ? best_model(all, given, wish, out, work, progress)
                                    : try_out(all, asked(given, wish), wish.holdout, work, progress);
  Learnt& l = tried.learnt;
  out.shots = fitted_shots(l, work);
  const double excess = left_over(l, out.shots);
  out.sigma = l.noise * std::sqrt(excess);
  out.physics = l.common.physics();
  restore_tolerance(out.physics);
  tell_coefficients(l.common, covariance(l.shots, l.common) * excess, out);
  out.held = l.held;
  out.seconds = tried.seconds;
  out.predictions = std::move(tried.predictions);
  if (out.predictions.empty() && wish.predict)
    for (const Recording* r : all) out.predictions.push_back(predict(*r, l.common, l.noise, work));
  out.simulations = work.simulations;
  out.restarts = work.restarts;
  progress(1);
  return out;
}

}  // namespace bankshot
