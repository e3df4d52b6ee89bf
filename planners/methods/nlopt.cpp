// SPDX-License-Identifier: MIT
//
// Planners `nlopt-*`: NLopt in (aim, speed), or in the aim alone. One table of methods.
// Without derivatives the objective is the natural one, the squared miss of the real path plus the
// squared error of the arrival speed; it jumps wherever the sequence of cushions does. With a gradient
// it is the squared residual of a locked sequence, which does not. Local methods start at the images,
// global ones search the whole box of bounds. The best point found is moved onto the root along its
// own cushion sequence (locked.hpp) and certified.
// Cost: thousands of simulations. Guarantee: none. Random draws are seeded: same puzzle, same answer.
#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "planners/images/unfold.hpp"
#include "planners/locked/residual.hpp"
#include "planners/methods/methods.hpp"
#include "planners/proof/prove.hpp"

namespace bankshot::planning {
namespace {

enum class Scope { local, gradient, global };
struct Method {
  const char* name;
  nlopt_algorithm algorithm;
  Scope scope;
  int evaluations;  ///< most, a start
};
constexpr Method bobyqa{"nlopt-bobyqa", NLOPT_LN_BOBYQA, Scope::local, 300};
constexpr Method sbplx{"nlopt-sbplx", NLOPT_LN_SBPLX, Scope::local, 1000};
constexpr Method slsqp{"nlopt-slsqp", NLOPT_LD_SLSQP, Scope::gradient, 100};
constexpr Method direct{"nlopt-direct", NLOPT_GN_DIRECT_L, Scope::global, 20000};
constexpr Method crs{"nlopt-crs", NLOPT_GN_CRS2_LM, Scope::global, 20000};
constexpr Method mlsl{"nlopt-mlsl", NLOPT_G_MLSL_LDS, Scope::global, 20000};
constexpr unsigned long seed = 1;  ///< of CRS's and MLSL's draws

/// Worse than any miss: what a launch costs that never has the bounces asked.
constexpr double wrong_bounces = 1;

struct Objective {
  Search& s;
  nlopt_opt optimiser;
  double fixed_speed;
  Launch best{};
  double least = std::numeric_limits<double>::infinity();

  Launch launch(const double* x) const { return {s.one_unknown() ? fixed_speed : x[1], wrap_angle(x[0])}; }

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

double evaluate(unsigned, const double* x, double*, void* data) { return (*static_cast<Objective*>(data))(x); }

/// The squared residual of one locked sequence and its gradient, in (aim, speed).
struct LockedObjective {
  Search& s;
  LockedAim aim;
  double fixed_speed;

  double operator()(const double* x, double* gradient) const {
    const double speed = s.one_unknown() ? fixed_speed : x[1];
    const auto l = linearise(s, aim, {speed, x[0]});
    if (gradient) std::fill(gradient, gradient + (s.one_unknown() ? 1 : 2), 0.0);
    if (!l) return wrong_bounces;
    if (gradient) gradient[0] = 2 * (l->r[0] * l->by_aim[0] + l->r[1] * l->by_aim[1]);
    if (gradient && !s.one_unknown()) gradient[1] = 2 * (l->r[0] * l->by_speed[0] + l->r[1] * l->by_speed[1]) / speed;
    return l->r[0] * l->r[0] + l->r[1] * l->r[1];
  }
};

double evaluate_locked(unsigned, const double* x, double* gradient, void* data) {
  return (*static_cast<LockedObjective*>(data))(x, gradient);
}

using Optimiser = std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)>;

Optimiser make(nlopt_algorithm algorithm, unsigned unknowns, int evaluations) {
  Optimiser opt(nlopt_create(algorithm, unknowns), &nlopt_destroy);
  nlopt_set_maxeval(opt.get(), evaluations);
  nlopt_set_stopval(opt.get(), 1e-20);
  nlopt_set_xtol_rel(opt.get(), 1e-13);
  return opt;
}

/// Minimises inside the bounds, from `start`; any status: what counts is the best point seen, left in x.
void minimise(const Search& s, nlopt_opt opt, const Range& angles, const Launch& start, double (&x)[2]) {
  const double low[2] = {angles.low, s.puzzle.speed.low}, high[2] = {angles.high, s.puzzle.speed.high};
  nlopt_set_lower_bounds(opt, low);
  nlopt_set_upper_bounds(opt, high);
  x[0] = std::clamp(start.angle, low[0], high[0]);
  x[1] = std::clamp(start.speed, low[1], high[1]);
  double value = 0;
  nlopt_srand(seed);  // the calling thread's generator
  nlopt_optimize(opt, x, &value);
}

/// Optimises from one start and certifies what it leads to.
void run(Search& s, const Method& m, const Range& angles, const Launch& start) {
  const unsigned unknowns = s.one_unknown() ? 1 : 2;
  const Optimiser opt = make(m.algorithm, unknowns, m.evaluations);
  Objective objective{s, opt.get(), start.speed};
  nlopt_set_min_objective(opt.get(), evaluate, &objective);
  if (m.algorithm == NLOPT_G_MLSL_LDS) {
    constexpr int local_evaluations = 60;
    const Optimiser local = make(bobyqa.algorithm, unknowns, local_evaluations);
    nlopt_set_local_optimizer(opt.get(), local.get());
  }
  double x[2];
  minimise(s, opt.get(), angles, start, x);
  if (!std::isfinite(objective.least)) return;
  std::vector<Contact> contacts;
  const Replay r = replay(s, objective.best, Goal::of(s), &contacts);
  contacts.resize(std::min(contacts.size(), static_cast<std::size_t>(std::max(0, r.bounces))));
  const auto root = refine(s, objective.best, contacts);
  certify(s, root.value_or(objective.best), static_cast<int>(contacts.size()), m.name);
}

void run_locked(Search& s, const Method& m, const Range& angles, const Launch& start, const LockedAim& aim) {
  const Optimiser opt = make(m.algorithm, s.one_unknown() ? 1 : 2, m.evaluations);
  LockedObjective objective{s, aim, start.speed};
  nlopt_set_min_objective(opt.get(), evaluate_locked, &objective);
  double x[2];
  minimise(s, opt.get(), angles, start, x);
  const Launch best{s.one_unknown() ? start.speed : x[1], wrap_angle(x[0])};
  certify_root(s, aim, solve_locked(s, aim, best).value_or(best), m.name);
}

Range all_angles(const Search& s) { return s.puzzle.angle.value_or(Range{0, radians(360)}); }

double some_speed(const Search& s) {
  const Range& v = s.puzzle.speed;
  return s.one_unknown() ? fixed_speed(s) : (v.low + v.high) / 2;
}

void from_images(Search& s, const Method& m) {
  const Range angles = all_angles(s);
  const bool straight = is_straight(s.puzzle.physics), locked = m.scope == Scope::gradient;
  Unfolding images(s, !straight, restitution(s.puzzle.physics).at_rest, locked);
  while (const auto c = images.next()) {
    if (s.enough()) return;
    const double angle = c->angle < angles.low ? c->angle + radians(360) : c->angle;
    if (locked) {
      const std::vector<Contact> contacts = images.contacts(*c);
      const LockedAim aim{s, contacts, c->target};
      if (const auto speed = speed_at(s, aim, c->angle, c->distance)) run_locked(s, m, angles, {*speed, angle}, aim);
      continue;
    }
    double speed = some_speed(s);
    if (straight) speed = launch_speed(s, c->angle, trace(s, c->angle, Goal::exactly(s, c->bounces))).value_or(speed);
    run(s, m, angles, {speed, angle});
  }
}

void anywhere(Search& s, const Method& m) {
  if (s.spent()) return;
  const Range angles = all_angles(s);
  run(s, m, angles, {some_speed(s), (angles.low + angles.high) / 2});
}

}  // namespace

void nlopt_bobyqa(Search& s) { from_images(s, bobyqa); }
void nlopt_sbplx(Search& s) { from_images(s, sbplx); }
void nlopt_slsqp(Search& s) { from_images(s, slsqp); }
void nlopt_direct(Search& s) { anywhere(s, direct); }
void nlopt_crs(Search& s) { anywhere(s, crs); }
void nlopt_mlsl(Search& s) { anywhere(s, mlsl); }

}  // namespace bankshot::planning
