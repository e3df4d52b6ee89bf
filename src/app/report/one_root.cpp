// SPDX-License-Identifier: MIT
#include "app/report/one_root.hpp"

#if BANKSHOT_NLOPT
#include <nlopt.h>
#endif

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "bankshot/numbers/dual.hpp"
#include "planners/propose/unfold.hpp"
#include "planners/solve/newton.hpp"
#include "planners/solve/speed.hpp"
#include "planners/trace/arrival.hpp"

namespace bankshot::app::report {
namespace {

using namespace planning;

/// Position of rest less the target [m], as a function of aim and ln speed. Counts the simulations and keeps the least
/// miss.
struct Path {
  const Branch& aim;
  double (*clock)();
  double begin = clock();
  std::vector<Iterate> seen{};
  long simulations = 0;
  Work work{};

  template <class T>
  std::optional<Vec2<T>> off(const T& angle, const T& log_speed) {
    using std::exp;
    ++simulations;
    const T speed = exp(log_speed);
    const auto arrival = arrival_of(aim, start_of(aim.request, angle, speed), aim.request.puzzle().physics, work);
    if (!arrival) return {};
    return arrival->state.at - to<T>(aim.aim_point.at);
  }

  void note(const Vec2d& off_now) {
    const double miss = norm(off_now), least = seen.empty() ? miss : std::min(miss, seen.back().miss);
    seen.push_back({simulations, clock() - begin, least});
  }
};

std::optional<Linear> by_dual_numbers(Path& p, double angle, double log_speed) {
  const auto r = p.off(Dual<2>(angle, 0), Dual<2>(log_speed, 1));
  if (!r) return {};
  const Dual<2> both[] = {r->x, r->y};
  return linear<2>(both, 0);
}

/// Takes differences with steps near the best compromise of rounding and curvature: the square root and the cube root
/// of 2⁻⁵².
std::optional<Linear> by_differences(Path& p, double angle, double log_speed, bool central) {
  const double h = central ? 6e-6 : 1.5e-8;
  const auto r = p.off(angle, log_speed);
  if (!r) return {};
  Linear l{{r->x, r->y}, {}};
  for (std::size_t k = 0; k < 2; ++k) {
    const double by_angle = k == 0 ? h : 0, by_speed = k == 1 ? h : 0;
    const auto after = p.off(angle + by_angle, log_speed + by_speed);
    const auto before = central ? p.off(angle - by_angle, log_speed - by_speed) : r;
    if (!after || !before) return {};
    const Vec2d slope = (*after - *before) / (central ? 2 * h : h);
    l.by[0][k] = slope.x;
    l.by[1][k] = slope.y;
  }
  return l;
}

/// Runs Newton's method, with no step longer than those of the planners.
void newton_from(Path& p, const Launch& seed, Derivatives d) {
  constexpr int most_steps = 15;
  constexpr double step_aim = 0.3, step_speed = 0.5, settled = 1e-16;
  double angle = seed.angle, log_speed = std::log(seed.speed);
  for (int i = 0; i < most_steps; ++i) {
    const auto l = d == Derivatives::dual ? by_dual_numbers(p, angle, log_speed)
                                          : by_differences(p, angle, log_speed, d == Derivatives::central);
    if (!l) return;
    p.note({l->r[0], l->r[1]});
    const auto step = newton_step(*l, false);
    if (!step || !std::isfinite((*step)[0]) || !std::isfinite((*step)[1])) return;
    const double size = std::max(std::abs((*step)[0]) / step_aim, std::abs((*step)[1]) / step_speed),
                 damped = size > 1 ? 1 / size : 1;
    if (size < settled) return;
    angle += damped * (*step)[0];
    log_speed += damped * (*step)[1];
  }
}

#if BANKSHOT_NLOPT
double squared_distance(unsigned, const double* x, double*, void* data) {
  Path& p = *static_cast<Path*>(data);
  const auto off = p.off(x[0], x[1]);
  p.note(off.value_or(Vec2d{p.aim.request.problem->boundary.diagonal, 0}));
  const double r = norm(off.value_or(Vec2d{p.aim.request.problem->boundary.diagonal, 0}));
  return r * r;
}

void bobyqa_from(Path& p, const Launch& seed) {
  constexpr int evaluations = 200;
  const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> opt(nlopt_create(NLOPT_LN_BOBYQA, 2), &nlopt_destroy);
  const double first[2] = {0.02, 0.05};
  double x[2] = {seed.angle, std::log(seed.speed)}, value = 0;
  nlopt_set_maxeval(opt.get(), evaluations);
  nlopt_set_stopval(opt.get(), 1e-28);
  nlopt_set_xtol_rel(opt.get(), 1e-15);
  nlopt_set_initial_step(opt.get(), first);
  nlopt_set_min_objective(opt.get(), squared_distance, &p);
  nlopt_optimize(opt.get(), x, &value);
}
#else
void bobyqa_from(Path&, const Launch&) {}  // derivatives.cpp does not ask for it
#endif

}  // namespace

std::vector<Iterate> approach(const Puzzle& puzzle, Derivatives d, double (*clock)()) {
  const SearchRequest request(puzzle);
  EvaluationBudget budget(budget_of(puzzle));
  Unfolding images(request, {.parts = true, .restitution = restitution(puzzle.physics).at_rest, .keep_routes = true});
  while (const auto c = images.next()) {
    const Branch aim{request, *request.route, request.problem->aim_points[c->aim_point]};
    const auto speed = speed_at(aim, budget, c->angle, c->distance);
    if (!speed) continue;
    Path path{aim, clock};
    const Launch seed{*speed, c->angle};
    if (d == Derivatives::none)
      bobyqa_from(path, seed);
    else
      newton_from(path, seed, d);
    return path.seen;
  }
  return {};
}

}  // namespace bankshot::app::report
