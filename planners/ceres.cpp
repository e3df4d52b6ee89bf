// SPDX-License-Identifier: MIT
//
// Planner `ceres`: Levenberg–Marquardt (ceres::TinySolver) on dual-number derivatives of the
// locked-sequence residual, in (aim, ln speed) or in the aim alone.
// Seeds: the images of unfold.hpp with the sequence their trace meets; on tables with reflex
// vertices also a fan of aims. Cost: about ten locked simulations a seed. Guarantee: none beyond the
// certificate; it finds the root its seed leads to.
// Source: Ceres 2.1 tiny_solver.h. Its function_tolerance is compared with the absolute change of
// the cost, so it is set to 0 here.
#include <ceres/tiny_solver.h>
#include <ceres/tiny_solver_autodiff_function.h>

#include <algorithm>
#include <cmath>

#include "bankshot/simulate/locked.hpp"
#include "planners/planners.hpp"
#include "planners/robustness.hpp"
#include "planners/unfold.hpp"
#include "planners/verify.hpp"

namespace bankshot::planning {
namespace {

constexpr int fan = 720;  // aims tried as seeds where no image exists: every half degree

/// What a seed's locked path must hit.
struct Aim {
  const Search& s;
  std::span<const int> contacts;
  Vec2d target;
  double fixed_speed;

  double capture() const { return s.capture(s.reach(target)); }
  double asked_speed() const {
    return s.puzzle.prefer == Prefer::soft ? s.arrival->low : s.arrival->high;
  }
};

template <class T>
State<T> start_of(const Aim& a, const T& angle, const T& speed) {
  using std::cos, std::sin;
  return launched(a.s.puzzle.ball.at, a.s.puzzle.ball.radius, Vec2<T>{cos(angle), sin(angle)} * speed, a.s.puzzle.spin);
}

/// Where the locked path from `start` arrives; none when it never gets to its last leg.
template <class T>
std::optional<LockedArrival<T>> arrival_of(const Aim& a, const State<T>& start) {
  return with_physics(a.s.puzzle.physics, [&](const auto& motion, const auto& cushion) -> std::optional<LockedArrival<T>> {
    const auto path = follow_locked(a.s.boundary, motion, cushion, a.contacts, start);
    if (path.end != LockedEnd::complete || !(dot(path.state.velocity, path.state.velocity) > T(0))) return {};
    return arrive_locked(motion, path.state, a.target, a.capture(), a.s.stop);
  });
}

/// To stop at a point: where the ball rests, over the diagonal. Else [0]: signed lateral miss over
/// the diagonal, [1]: v² − s² abreast of the target (at capture for a pocket), over max(1, s²); v² is
/// continued below 0, by what rolling on would have cost, when the ball rests before.
template <class T>
void residuals_of(const Aim& a, const State<T>& start, T* r, bool two) {
  const auto arrival = arrival_of(a, start);
  const T diagonal(a.s.boundary.diagonal);
  const Vec2<T> heading = arrival ? arrival->heading : Vec2<T>{};
  if (!arrival || !(dot(heading, heading) > T(0))) {
    std::fill(r, r + (two ? 2 : 1), T(1e3));  // flat and high: the solver turns back or gives up
    return;
  }
  const Vec2<T> off = to<T>(a.target) - arrival->state.at;
  if (a.s.stop) {
    r[0] = off.x / diagonal;
    r[1] = off.y / diagonal;
    return;
  }
  const Vec2<T> u = heading / norm(heading);
  r[0] = cross(u, off) / diagonal;
  if (!two) return;
  T speed2 = dot(arrival->state.velocity, arrival->state.velocity);
  if (arrival->at_rest) speed2 = T(-2 * deceleration(a.s.puzzle.physics)) * dot(u, off);
  const double asked = a.asked_speed();
  r[1] = (speed2 - T(asked * asked)) / T(std::max(1.0, asked * asked));
}

template <int Unknowns>
struct Residual {
  const Aim& aim;
  template <class T>
  bool operator()(const T* x, T* r) const {
    using std::exp;
    const T speed = Unknowns == 2 ? T(exp(x[Unknowns - 1])) : T(aim.fixed_speed);
    const State<T> start = start_of(aim, x[0], speed);
    residuals_of(aim, start, r, Unknowns == 2);
    return true;
  }
};

template <int Unknowns>
std::optional<Launch> minimise(Search& s, const Aim& aim, const Launch& seed) {
  const Residual<Unknowns> residual{aim};
  using Function = ::ceres::TinySolverAutoDiffFunction<Residual<Unknowns>, Unknowns, Unknowns>;
  const Function function(residual);
  ::ceres::TinySolver<Function> solver;
  solver.options.max_num_iterations = 30;
  solver.options.function_tolerance = 0;
  solver.options.gradient_tolerance = 1e-18;
  solver.options.parameter_tolerance = 1e-16;
  solver.options.cost_threshold = 1e-28;
  typename ::ceres::TinySolver<Function>::Parameters x;
  x(0) = seed.angle;
  if constexpr (Unknowns == 2) x(1) = std::log(seed.speed);
  solver.Solve(function, &x);
  s.simulations += 1 + 2 * solver.summary.iterations;
  if (!x.allFinite() || !(solver.summary.final_cost < 1e-12)) return {};
  double speed = aim.fixed_speed;
  if constexpr (Unknowns == 2) speed = std::exp(x(1));
  return Launch{speed, wrap_angle(x(0))};
}

/// The launch speed with which the locked path at this aim arrives about as fast as asked: bisection
/// in ln v, where falling short counts as too slow. None where no speed gets there.
std::optional<double> speed_at(Search& s, const Aim& aim, double angle) {
  const Range& bounds = s.puzzle.speed;
  if (s.one_unknown()) return is_ideal(s.puzzle.physics) ? std::clamp(1.0, bounds.low, bounds.high) : bounds.low;
  const double asked = aim.asked_speed();
  const auto enough = [&](double v) {
    ++s.simulations;
    const auto arrival = arrival_of(aim, start_of(aim, angle, v));
    if (!arrival) return false;
    const Vec2d off = aim.target - arrival->state.at;
    if (arrival->at_rest) return dot(arrival->heading, off) < 0;
    return dot(arrival->state.velocity, arrival->state.velocity) >= asked * asked;
  };
  double low = std::max(bounds.low, 1e-3 * bounds.high), high = bounds.high;
  if (!enough(high)) return {};
  constexpr int halvings = 10;  // to about 1 %: a seed needs no more
  for (int i = 0; i < halvings; ++i) {
    const double middle = std::sqrt(low * high);
    (enough(middle) ? high : low) = middle;
  }
  return high;
}

/// Refines one image along one sequence.
bool from_seed(Search& s, double angle, const std::vector<int>& contacts, const Vec2d& target) {
  const Aim aim{s, contacts, target, 0};
  const auto speed = speed_at(s, aim, angle);
  if (!speed) return false;
  const auto launch = refine(s, {*speed, angle}, contacts);
  return launch && certify(s, *launch, static_cast<int>(contacts.size()), "image+ceres");
}

}  // namespace

std::optional<Launch> refine(Search& s, const Launch& seed, const std::vector<int>& contacts) {
  std::optional<Launch> best;
  double least = std::numeric_limits<double>::infinity();
  for (const Vec2d& target : s.aim_points()) {
    const Aim aim{s, contacts, target, seed.speed};
    const auto x = s.one_unknown() ? minimise<1>(s, aim, seed) : minimise<2>(s, aim, seed);
    if (!x) continue;
    const double moved = std::abs(angle_difference(x->angle, seed.angle));
    if (moved < least) best = x, least = moved;
  }
  return best;
}

/// Ratios of the normal to the tangential loss to unfold with, as shares of the cushion's own
/// restitution: spin changes the rebound's angle, and one of these comes near it.
constexpr double shares[] = {1, 0.8, 1.2, 0.6, 1.5};

void from_images(Search& s) {
  const bool straight = is_straight(s.puzzle.physics);
  for (const double share : shares) {
    Unfolding images(s, !straight, share * restitution(s.puzzle.physics).at_rest, true);
    while (const auto c = images.next()) {
      if (s.spent() || (!s.all && s.shots.size() >= 32)) return;
      from_seed(s, c->angle, images.contacts(*c), c->target);
    }
    if (straight || !images.whole()) return;
    if (s.puzzle.cushions.sequence && !s.shots.empty()) return;
  }
}

void from_fan(Search& s) {
  const CushionRule& rule = s.puzzle.cushions;
  for (int i = 0; i < fan; ++i)
    for (int n = rule.min; n <= rule.max; ++n) {
      if (s.spent() || (!s.all && s.shots.size() >= 32)) return;
      const double angle = radians(360.0 / fan) * i;
      std::vector<int> contacts;
      trace(s, angle, Goal::exactly(s, n), &contacts);
      if (s.puzzle.cushions.sequence) contacts = *s.puzzle.cushions.sequence;
      if (static_cast<int>(contacts.size()) == n)
        for (const Vec2d& target : s.aim_points()) from_seed(s, angle, contacts, target);
    }
}

void ceres(Search& s) {
  from_images(s);
  if (!s.boundary.tips.empty()) from_fan(s);
}

void first_order(const Search& s, Shot& shot) {
  using Jet = ::ceres::Jet<double, 2>;
  const Aim aim{s, shot.cushions, shot.arrival.at, 0};
  const Vec2d v = direction(shot.launch.angle) * shot.launch.speed, turned = perpendicular(v);
  // Derivatives with respect to the aim [rad] and to ln speed, at an exact direction.
  Vec2<Jet> velocity{Jet(v.x), Jet(v.y)};
  velocity.x.v = {turned.x, v.x};
  velocity.y.v = {turned.y, v.y};
  const State<Jet> start = launched(s.puzzle.ball.at, s.puzzle.ball.radius, velocity, s.puzzle.spin);
  const Vec2<Jet> end = with_physics(s.puzzle.physics, [&](const auto& motion, const auto& cushion) {
    const auto path = follow_locked(s.boundary, motion, cushion, aim.contacts, start);
    const auto arrival = arrive_locked(motion, path.state, aim.target, 0, s.stop);
    if (s.stop) return arrival.state.at;
    // Along the line of travel nothing is missed: only the lateral part counts.
    const Vec2<Jet> u = arrival.heading / norm(arrival.heading);
    const Vec2d line{-u.y.a, u.x.a};
    const Jet lateral = cross(u, to<Jet>(aim.target) - arrival.state.at);
    return Vec2<Jet>{lateral * line.x, lateral * line.y};
  });
  const double by_aim = std::hypot(end.x.v(0), end.y.v(0)), by_speed = std::hypot(end.x.v(1), end.y.v(1));
  shot.condition = std::max(by_aim, by_speed);
  const Noise& noise = s.puzzle.noise;
  const double spread = std::hypot(by_aim * noise.angle, by_speed * noise.speed / shot.launch.speed);
  shot.first_order = s.nearest_reach(shot.arrival.at) / spread;
}

}  // namespace bankshot::planning
