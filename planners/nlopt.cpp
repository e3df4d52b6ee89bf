// SPDX-License-Identifier: MIT
//
// Planners `nlopt-*`: NLopt on the natural objective, the squared miss of the real path plus the
// squared error of the arrival speed, in (aim, speed) or in the aim alone. One table of methods.
// Local methods start at the images, global ones search the whole box of bounds. The best point
// found is moved onto the root along its own cushion sequence (locked.hpp) and certified.
// Cost: thousands of simulations. Guarantee: none; the objective jumps wherever the sequence does.
#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "planners/locked.hpp"
#include "planners/planners.hpp"
#include "planners/unfold.hpp"
#include "planners/verify.hpp"

namespace bankshot::planning {
namespace {

struct Method {
  const char* name;
  nlopt_algorithm algorithm;
  bool global;
  int evaluations;  ///< most, a start
};
constexpr Method bobyqa{"nlopt-bobyqa", NLOPT_LN_BOBYQA, false, 300};
constexpr Method direct{"nlopt-direct", NLOPT_GN_DIRECT_L, true, 20000};

/// Worse than any miss: what a launch costs that never has the bounces asked.
constexpr double wrong_bounces = 1;

struct Objective {
  Search& s;
  nlopt_opt optimiser;
  double fixed_speed;
  Launch best{};
  double least = std::numeric_limits<double>::infinity();

  Launch launch(const double* x) const {
    return {s.one_unknown() ? fixed_speed : x[1], wrap_angle(x[0])};
  }

  double operator()(const double* x) {
    if (s.spent()) {
      nlopt_force_stop(optimiser);
      return std::isfinite(least) ? least : wrong_bounces;
    }
    const Launch l = launch(x);
    const Replay r = replay(s, l, Goal::of(s));
    double value = std::pow(std::min(r.miss / s.boundary.diagonal, 1.0), 2);
    if (!r.made && r.failure.foul != Foul::missed) value += wrong_bounces;
    if (s.arrival && !s.stop) {
      const double v = r.arrival.speed, asked = std::clamp(v, s.arrival->low, s.arrival->high);
      value += std::pow((v - asked) / std::max(1.0, asked), 2);
    }
    if (value < least) least = value, best = l;
    return value;
  }
};

double evaluate(unsigned, const double* x, double*, void* data) {
  return (*static_cast<Objective*>(data))(x);
}

/// Optimises from one start and certifies what it leads to.
void run(Search& s, const Method& m, const Range& angles, const Launch& start) {
  const unsigned unknowns = s.one_unknown() ? 1 : 2;
  const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> opt(nlopt_create(m.algorithm, unknowns), &nlopt_destroy);
  Objective objective{s, opt.get(), start.speed};
  const double low[2] = {angles.low, s.puzzle.speed.low}, high[2] = {angles.high, s.puzzle.speed.high};
  nlopt_set_lower_bounds(opt.get(), low);
  nlopt_set_upper_bounds(opt.get(), high);
  nlopt_set_min_objective(opt.get(), evaluate, &objective);
  nlopt_set_maxeval(opt.get(), m.evaluations);
  nlopt_set_stopval(opt.get(), 1e-20);
  nlopt_set_xtol_rel(opt.get(), 1e-13);
  double x[2] = {std::clamp(start.angle, low[0], high[0]), std::clamp(start.speed, low[1], high[1])};
  double value = 0;
  nlopt_optimize(opt.get(), x, &value);  // any status: what counts is the best point seen
  if (!std::isfinite(objective.least)) return;
  std::vector<int> contacts;
  const Replay r = replay(s, objective.best, Goal::of(s), &contacts);
  contacts.resize(std::min(contacts.size(), static_cast<std::size_t>(std::max(0, r.bounces))));
  const auto root = refine(s, objective.best, contacts);
  certify(s, root.value_or(objective.best), static_cast<int>(contacts.size()), m.name);
}

Range all_angles(const Search& s) { return s.puzzle.angle.value_or(Range{0, radians(360)}); }

double some_speed(const Search& s) {
  const Range& v = s.puzzle.speed;
  return is_ideal(s.puzzle.physics) ? std::clamp(1.0, v.low, v.high) : (v.low + v.high) / 2;
}

}  // namespace

void nlopt_bobyqa(Search& s) {
  const Range angles = all_angles(s);
  Unfolding images(s, false, restitution(s.puzzle.physics).at_rest);
  while (const auto c = images.next()) {
    if (s.spent() || (!s.all && s.shots.size() >= 32)) return;
    double speed = some_speed(s);
    if (is_straight(s.puzzle.physics))
      speed = launch_speed(s, c->angle, trace(s, c->angle, Goal::exactly(s, c->bounces))).value_or(speed);
    const double angle = c->angle < angles.low ? c->angle + radians(360) : c->angle;
    run(s, bobyqa, angles, {speed, angle});
  }
}

void nlopt_direct(Search& s) {
  if (s.spent()) return;
  const Range angles = all_angles(s);
  run(s, direct, angles, {some_speed(s), (angles.low + angles.high) / 2});
}

}  // namespace bankshot::planning
