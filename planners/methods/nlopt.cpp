// SPDX-License-Identifier: MIT
//
// Planners `nlopt-*`: NLopt in (aim, speed), or in the aim alone. One table of methods.
// Without derivatives the objective is the natural one: the squared miss of the real path plus the squared error of the
// arrival speed. It jumps wherever the route does. With a gradient it is the squared residual of a locked path, which
// does not jump. Local methods start at the images, global ones search the whole box of bounds. The best point found is
// moved onto the root along its own route (solve/levenberg_marquardt.hpp) and verified.
// Cost: thousands of simulations. Guarantee: none. Random draws are seeded: same puzzle, same answer.
#include <nlopt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "planners/methods/methods.hpp"
#include "planners/methods/nlopt.hpp"
#include "planners/propose/aim.hpp"
#include "planners/propose/unfold.hpp"
#include "planners/solve/levenberg_marquardt.hpp"
#include "planners/solve/speed.hpp"
#include "planners/stop.hpp"
#include "planners/verify/certify.hpp"

namespace bankshot::planning::methods {
namespace {

using namespace settings::nlopt;

/// A launch that never has the bounces asked costs this. No squared miss is larger, counted by the diagonal's square.
constexpr double most_miss = 1;

enum class Scope { local, gradient, global };
struct Optimisation {
  const char* name;
  nlopt_algorithm algorithm;
  Scope scope;
  int evaluations;  ///< most evaluations from one start
};
constexpr Optimisation bobyqa{"nlopt-bobyqa", NLOPT_LN_BOBYQA, Scope::local, local_evaluations};
constexpr Optimisation sbplx{"nlopt-sbplx", NLOPT_LN_SBPLX, Scope::local, local_evaluations};
constexpr Optimisation slsqp{"nlopt-slsqp", NLOPT_LD_SLSQP, Scope::gradient, local_evaluations};
constexpr Optimisation direct{"nlopt-direct", NLOPT_GN_DIRECT_L, Scope::global, global_evaluations};
constexpr Optimisation crs{"nlopt-crs", NLOPT_GN_CRS2_LM, Scope::global, global_evaluations};
constexpr Optimisation mlsl{"nlopt-mlsl", NLOPT_G_MLSL_LDS, Scope::global, global_evaluations};

struct Objective {
  const SearchRequest& request;
  EvaluationBudget& budget;
  nlopt_opt optimiser;
  double fixed_speed;
  Launch best{};
  double least = std::numeric_limits<double>::infinity();

  Launch launch(const double* x) const { return {request.one_unknown() ? fixed_speed : x[1], wrap_angle(x[0])}; }

  double operator()(const double* x) {
    if (budget.spent()) {
      nlopt_force_stop(optimiser);
      return std::isfinite(least) ? least : most_miss;
    }
    const Launch l = launch(x);
    const Replay r = replay(request, budget, l, Goal::of(request));
    double value = std::pow(std::min(r.miss / request.problem->boundary.diagonal, 1.0), 2);
    if (!r.made && r.failure.reason != FailureReason::missed) value += most_miss;
    if (request.arrival && !request.stop) {
      const double v = r.path.arrival.speed, asked = std::clamp(v, request.arrival->low, request.arrival->high);
      value += std::pow((v - asked) / std::max(1.0, asked), 2);
    }
    if (value < least) least = value, best = l;
    return value;
  }
};

double evaluate(unsigned, const double* x, double*, void* data) { return (*static_cast<Objective*>(data))(x); }

/// The squared residual of one locked path and its gradient, in (aim, speed).
struct LockedObjective {
  Branch aim;
  EvaluationBudget& budget;
  double fixed_speed;

  double operator()(const double* x, double* gradient) const {
    const bool two = !aim.request.one_unknown();
    const double speed = two ? x[1] : fixed_speed;
    const auto l = linearise(aim, budget, {speed, x[0]});
    if (gradient) std::fill(gradient, gradient + (two ? 2 : 1), 0.0);
    if (!l) return most_miss;
    if (gradient) gradient[0] = 2 * (l->r[0] * l->by_aim(0) + l->r[1] * l->by_aim(1));
    if (gradient && two) gradient[1] = 2 * (l->r[0] * l->by_speed(0) + l->r[1] * l->by_speed(1)) / speed;
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
  nlopt_set_stopval(opt.get(), small_enough);
  nlopt_set_xtol_rel(opt.get(), least_step);
  return opt;
}

/// Minimises inside the bounds, from `start`. Any status will do: the best point seen counts, and is left in x.
void minimise(const SearchRequest& request, nlopt_opt opt, const Range& angles, const Launch& start, double (&x)[2]) {
  const double low[2] = {angles.low, request.speed.low}, high[2] = {angles.high, request.speed.high};
  nlopt_set_lower_bounds(opt, low);
  nlopt_set_upper_bounds(opt, high);
  x[0] = std::clamp(start.angle, low[0], high[0]);
  x[1] = std::clamp(start.speed, low[1], high[1]);
  double value = 0;
  nlopt_srand(seed);  // the calling thread's generator
  nlopt_optimize(opt, x, &value);
}

class Planner {
 public:
  /// `step` names it in answers.
  Planner(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, const Optimisation& method,
          std::string_view step)
      : request_(request), budget_(budget), found_(found), method_(method), step_(step) {}

  void anywhere() {
    if (!budget_.spent()) run({some_speed(), (angles_.low + angles_.high) / 2});
  }

  void from_images() {
    const bool straight = is_straight(request_.puzzle().physics), locked = method_.scope == Scope::gradient;
    const double e = restitution(request_.puzzle().physics).at_rest;
    Unfolding images(request_, {.parts = !straight, .restitution = e, .keep_routes = locked});
    while (const auto c = images.next()) {
      if (stop::enough_seeds(request_, budget_, found_)) return;
      const double angle = c->angle < angles_.low ? c->angle + radians(360) : c->angle;
      if (locked) {
        const Route route = images.route(*c);
        const Branch aim{request_, route, request_.problem->aim_points[c->aim_point]};
        if (const auto speed = speed_at(aim, budget_, c->angle, c->distance)) run_locked({*speed, angle}, aim);
        continue;
      }
      double speed = some_speed();
      if (straight) {
        const Trace t = trace(request_, budget_, c->angle, Goal::exactly(request_, c->bounces));
        speed = launch_speed(request_, found_, c->angle, t).value_or(speed);
      }
      run({speed, angle});
    }
  }

 private:
  /// Optimises from one start and verifies what it leads to.
  void run(const Launch& start) {
    const unsigned unknowns = request_.one_unknown() ? 1 : 2;
    const Optimiser opt = make(method_.algorithm, unknowns, method_.evaluations);
    Objective objective{request_, budget_, opt.get(), start.speed};
    nlopt_set_min_objective(opt.get(), evaluate, &objective);
    if (method_.algorithm == NLOPT_G_MLSL_LDS) {
      const Optimiser local = make(bobyqa.algorithm, unknowns, mlsl_local_evaluations);
      nlopt_set_local_optimizer(opt.get(), local.get());
    }
    double x[2];
    minimise(request_, opt.get(), angles_, start, x);
    if (!std::isfinite(objective.least)) return;
    const Replay r = replay(request_, budget_, objective.best, Goal::of(request_));
    const Route route = route_by(r.path.cushions);
    std::vector<Launch> launches;
    for (const AimPoint& aim_point : request_.problem->aim_points)
      if (const auto root = solve_locked({request_, route, aim_point}, budget_, objective.best))
        launches.push_back(*root);
    if (launches.empty()) launches.push_back(objective.best);
    for (const Launch& launch : launches) certify(request_, budget_, found_, launch, r.bounces(), step_);
  }

  void run_locked(const Launch& start, const Branch& aim) {
    const Optimiser opt = make(method_.algorithm, request_.one_unknown() ? 1 : 2, method_.evaluations);
    LockedObjective objective{aim, budget_, start.speed};
    nlopt_set_min_objective(opt.get(), evaluate_locked, &objective);
    double x[2];
    minimise(request_, opt.get(), angles_, start, x);
    const Launch best{request_.one_unknown() ? start.speed : x[1], wrap_angle(x[0])};
    certify_root(aim, budget_, found_, solve_locked(aim, budget_, best).value_or(best), step_);
  }

  double some_speed() const {
    const Range& v = request_.speed;
    return request_.one_unknown() ? request_.fixed_speed() : (v.low + v.high) / 2;
  }

  const SearchRequest& request_;
  EvaluationBudget& budget_;
  SearchResult& found_;
  const Optimisation& method_;
  std::string_view step_;
  Range angles_ = request_.angle.value_or(whole_turn);
};

template <const Optimisation& method>
void plan(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found) {
  Planner planner(request, budget, found, method, method.name);
  method.scope == Scope::global ? planner.anywhere() : planner.from_images();
}

}  // namespace

void search_box(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, std::string_view step) {
  Planner(request, budget, found, direct, step).anywhere();
}

std::span<const Method> nlopt_methods() {
  static constexpr std::array list{
      Method{{bobyqa.name, "local search without derivatives from the images (NLopt BOBYQA)"}, plan<bobyqa>},
      Method{{sbplx.name, "the same by subspaces of simplices (NLopt SBPLX)"}, plan<sbplx>},
      Method{{slsqp.name, "from the images along a locked sequence, dual-number gradient (NLopt SLSQP)"}, plan<slsqp>},
      Method{{direct.name, "global search over aim and speed (NLopt DIRECT-L)"}, plan<direct>},
      Method{{crs.name, "the same by controlled random search (NLopt CRS2)"}, plan<crs>},
      Method{{mlsl.name, "the same by many local searches (NLopt MLSL with BOBYQA)"}, plan<mlsl>},
  };
  return list;
}

}  // namespace bankshot::planning::methods
