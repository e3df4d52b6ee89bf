// SPDX-License-Identifier: MIT
//
// Source: Ceres 2.1 tiny_solver.h and jet.h. TinySolver's function_tolerance is compared with the
// absolute change of the cost, so it is set to 0 here.
#include "planners/locked/residual.hpp"

// The compiler cannot see that TinySolver sets its cost before it reads it.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <ceres/tiny_solver.h>
#include <ceres/tiny_solver_autodiff_function.h>

#include <algorithm>
#include <cmath>

#include "bankshot/simulate/locked.hpp"
#include "bankshot/simulate/simulator.hpp"
#include "planners/merit/robustness.hpp"
#include "planners/proof/prove.hpp"

namespace bankshot::planning {
namespace {

/// Of the diagonal: a leg that begins this far past the target no longer leads to it.
constexpr double behind = 0.05;

template <class T>
State<T> start_of(const Search& s, const T& angle, const T& speed) {
  using std::cos, std::sin;
  return launched(s.puzzle.ball.at, s.puzzle.ball.body.radius, Vec2<T>{cos(angle), sin(angle)} * speed, s.puzzle.spin);
}

/// Where the locked path from `start` arrives; none when it never gets to its last leg.
template <class T>
std::optional<LockedArrival<T>> arrival_of(const LockedAim& a, const State<T>& start, const Physics& physics) {
  return with_physics(physics, [&](const auto& motion, const auto& cushion) -> std::optional<LockedArrival<T>> {
    const auto path = follow_locked(a.s.boundary, motion, cushion, a.contacts, start);
    if (path.end != LockedEnd::complete || !(dot(path.state.velocity, path.state.velocity) > T(0))) return {};
    return arrive_locked(motion, a.s.boundary.body, path.state, a.target, a.capture(), a.s.stop);
  });
}

/// False where the ball arrives with no direction.
template <class T>
bool residuals_of(const LockedAim& a, const LockedArrival<T>& arrival, T* r, bool two) {
  const Vec2<T>& heading = arrival.heading;
  if (!(dot(heading, heading) > T(0))) return false;
  const T diagonal(a.s.boundary.diagonal);
  const Vec2<T> off = to<T>(a.target) - arrival.state.at;
  if (a.s.stop) {
    r[0] = off.x / diagonal;
    r[1] = off.y / diagonal;
    return true;
  }
  const Vec2<T> u = heading / norm(heading);
  r[0] = cross(u, off) / diagonal;
  if (!two) return true;
  T speed2 = dot(arrival.state.velocity, arrival.state.velocity);
  if (arrival.at_rest) speed2 = T(-2 * deceleration(a.s.puzzle.physics)) * dot(u, off);
  const double asked = a.s.asked;
  r[1] = (speed2 - T(asked * asked)) / T(std::max(1.0, asked * asked));
  return true;
}

template <int Unknowns>
struct Residual {
  const LockedAim& aim;
  double fixed_speed;
  template <class T>
  bool operator()(const T* x, T* r) const {
    using std::exp;
    const T speed = Unknowns == 2 ? T(exp(x[Unknowns - 1])) : T(fixed_speed);
    const auto arrival = arrival_of(aim, start_of(aim.s, x[0], speed), aim.s.puzzle.physics);
    if (!arrival || !residuals_of(aim, *arrival, r, Unknowns == 2))
      std::fill(r, r + Unknowns, T(1e3));  // flat and high: the solver turns back or gives up
    return true;
  }
};

template <int Unknowns>
std::optional<Launch> minimise(Search& s, const LockedAim& aim, const Launch& seed) {
  const Residual<Unknowns> residual{aim, seed.speed};
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
  double speed = seed.speed;
  if constexpr (Unknowns == 2) speed = std::exp(x(1));
  return Launch{speed, wrap_angle(x(0))};
}

using Jet = ::ceres::Jet<double, 2>;

/// The launch with its derivatives by aim and ln speed, at an exact direction.
State<Jet> dual_start(const Search& s, const Launch& launch) {
  const Vec2d v = direction(launch.angle) * launch.speed, turned = perpendicular(v);
  Vec2<Jet> velocity{Jet(v.x), Jet(v.y)};
  velocity.x.v = {turned.x, v.x};
  velocity.y.v = {turned.y, v.y};
  return launched(s.puzzle.ball.at, s.puzzle.ball.body.radius, velocity, s.puzzle.spin);
}

Linear linear(const Jet (&r)[2]) { return {{r[0].a, r[1].a}, {r[0].v[0], r[1].v[0]}, {r[0].v[1], r[1].v[1]}}; }

/// Adds how a free leg from `state` misses each aim point.
template <class Motion>
void look(Search& s, const Motion& motion, const State<Jet>& state, Forward& out) {
  if (!(dot(state.velocity, state.velocity).a > 0)) return;
  const auto& points = s.aim_points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const LockedAim aim{s, out.contacts, points[i]};
    const LockedArrival<Jet> arrival = arrive_locked(motion, s.boundary.body, state, aim.target, aim.capture(), s.stop);
    Jet r[2] = {Jet(0), Jet(0)};
    if (!residuals_of(aim, arrival, r, !s.one_unknown())) continue;
    const Vec2<Jet> off = to<Jet>(aim.target) - arrival.state.at;
    const double ahead = dot(arrival.heading, off).a / norm(arrival.heading).a;
    if (!s.stop && !arrival.at_rest && ahead < -behind * s.boundary.diagonal) continue;
    out.passages.push_back({out.contacts.size(), i, linear(r)});
  }
}

}  // namespace

std::optional<Vec2d> newton_step(const Linear& l, bool one_unknown) {
  const double det = l.determinant(one_unknown);
  if (det == 0) return {};
  if (one_unknown) return Vec2d{-l.r[0] / det, 0};
  return Vec2d{(l.by_speed[0] * l.r[1] - l.by_speed[1] * l.r[0]) / det,
               (l.by_aim[1] * l.r[0] - l.by_aim[0] * l.r[1]) / det};
}

std::optional<Launch> newton(Search& s, const LockedAim& aim, const Launch& from, const Neighbourhood& near,
                             const Known& known) {
  constexpr int most_steps = 40;
  constexpr int usual_steps = 4;    // after which a step that does not come nearer jumps to and fro across a kink
  constexpr int patience = 12;      // steps, after which each must come nearer
  constexpr double settled = 1e-7;  // of a longest step; the step after it is exact to rounding
  Launch at = from, before = from;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < most_steps; ++i) {
    auto l = linearise(s, aim, at);
    const auto worse = [&] { return !l || (i >= usual_steps && !(l->size() < least)); };
    if (i > 0 && worse()) {  // a shorter step; also back from beyond the edge of the map
      at = {std::sqrt(at.speed * before.speed), (at.angle + before.angle) / 2};
      l = linearise(s, aim, at);
    }
    if (i >= patience && worse()) return {};
    before = at;
    if (l) least = std::min(least, l->size());
    const auto step = l ? newton_step(*l, s.one_unknown()) : std::nullopt;
    if (!step) return {};
    const double size = std::max(std::abs(step->x) / near.step_aim, std::abs(step->y) / near.step_speed);
    if (!std::isfinite(size)) return {};
    const double damped = size > 1 ? 1 / size : 1;
    at = {at.speed * std::exp(damped * step->y), at.angle + damped * step->x};
    if (known && known(at, size)) return {};
    if (size < settled) return Launch{at.speed, wrap_angle(at.angle)};
    if (std::abs(at.angle - from.angle) > near.far * near.step_aim ||
        std::abs(std::log(at.speed / from.speed)) > near.far * near.step_speed)
      return {};
  }
  return {};
}

std::optional<Launch> solve_locked(Search& s, const LockedAim& aim, const Launch& seed) {
  return s.one_unknown() ? minimise<1>(s, aim, seed) : minimise<2>(s, aim, seed);
}

std::optional<Linear> linearise(Search& s, const LockedAim& aim, const Launch& launch) {
  ++s.simulations;
  const auto arrival = arrival_of(aim, dual_start(s, launch), s.puzzle.physics);
  Jet r[2] = {Jet(0), Jet(0)};
  if (!arrival || !residuals_of(aim, *arrival, r, !s.one_unknown())) return {};
  return linear(r);
}

bool certify_root(Search& s, const LockedAim& aim, const Launch& root, std::string_view planner) {
  if (certify(s, root, static_cast<int>(aim.contacts.size()), planner)) return true;
  s.leads.push_back({root, {aim.contacts.begin(), aim.contacts.end()}, aim.target});
  return false;
}

std::optional<Launch> refine(Search& s, const Launch& seed, const std::vector<Contact>& contacts) {
  std::optional<Launch> best;
  double least = std::numeric_limits<double>::infinity();
  for (const Vec2d& target : s.aim_points()) {
    const auto x = solve_locked(s, {s, contacts, target}, seed);
    if (!x) continue;
    const double moved = std::abs(angle_difference(x->angle, seed.angle));
    if (moved < least) best = x, least = moved;
  }
  return best;
}

std::optional<double> speed_near(Search& s, const LockedAim& aim, double angle, double guess) {
  if (s.one_unknown()) return guess;
  constexpr int most_steps = 30;
  constexpr double settled = 1e-14, largest_step = 0.5;  // of ln v
  constexpr double beyond = 1.1;                         // how much further to look for the other side of the root
  double speed = guess, low = 0, high = std::numeric_limits<double>::infinity();
  for (int i = 0; i < most_steps; ++i) {
    const auto l = linearise(s, aim, {speed, angle});
    double next = 0;
    if (l) {
      // To stop, the point on the line of rests nearest to the target: a minimum, no change of sign.
      const double step = s.stop ? -(l->r[0] * l->by_speed[0] + l->r[1] * l->by_speed[1]) /
                                       (l->by_speed[0] * l->by_speed[0] + l->by_speed[1] * l->by_speed[1])
                                 : -l->r[1] / l->by_speed[1];
      if (std::abs(step) < settled) return speed;
      if (!s.stop) (l->r[1] > 0 ? high : low) = speed;
      next = speed * std::exp(std::clamp(step, -largest_step, largest_step));
    } else {
      low = speed;  // it does not get there
    }
    if (!(next > low && next < high))
      next = !(low > 0)                                       ? high / beyond
             : high < std::numeric_limits<double>::infinity() ? std::sqrt(low * high)
                                                              : low * beyond;
    if (high - low < settled * high) return speed;
    speed = next;
  }
  return {};
}

std::optional<double> speed_at(Search& s, const LockedAim& aim, double angle, double length) {
  if (s.one_unknown()) return fixed_speed(s);
  const double asked = s.asked * s.asked, slowing = 2 * deceleration(s.puzzle.physics);
  // By how much the squared speed of arrival exceeds the one asked, as if a ball that rests had to roll on.
  const auto excess = [&](double square) -> std::optional<double> {
    ++s.simulations;
    const auto arrival = arrival_of(aim, start_of(s, angle, std::sqrt(square)), s.rough);
    if (!arrival) return {};
    const Vec2d& v = arrival->state.velocity;
    if (!arrival->at_rest) return dot(v, v) - asked;
    const double short_of = dot(arrival->heading, aim.target - arrival->state.at) / norm(arrival->heading);
    return -slowing * short_of - asked;
  };
  const Range& bounds = s.puzzle.speed;
  const double slowest = std::max(bounds.low, 1e-3 * bounds.high);
  double low = slowest * slowest, high = bounds.high * bounds.high;
  const auto most = excess(high);
  if (!most || *most < 0) return {};
  // It is nearly linear in the square of the launch speed: bounces take a share of that, rolling the same from all.
  double at = high, over = *most, slope = (over + asked + slowing * length) / high;
  constexpr int most_steps = 12;
  for (int i = 0; i < most_steps; ++i) {
    const double next = at - over / slope;
    const bool inside = next > low && next < high;
    constexpr double near = 0.05;  // of the square
    if (inside && std::abs(next - at) < near * next) return std::sqrt(next);
    const double tried = inside ? next : std::sqrt(low * high);
    const auto e = excess(tried);
    (e && *e >= 0 ? high : low) = tried;
    if (!e) continue;
    if ((*e - over) / (tried - at) > 0) slope = (*e - over) / (tried - at);
    at = tried;
    over = *e;
  }
  return std::sqrt(high);
}

void forward(Search& s, const Launch& launch, bool locked, Forward& out) {
  out.contacts.clear();
  out.places.clear();
  out.passages.clear();
  out.rests = false;
  const CushionRule& rule = s.puzzle.cushions;
  with_physics(s.rough, [&](const auto& motion, const auto& cushion) {
    const State<Jet> start = dual_start(s, launch);
    if (rule.sequence && locked) {
      out.contacts = *rule.sequence;
      const auto path = follow_locked(s.boundary, motion, cushion, std::span<const Contact>(out.contacts), start);
      if (path.end == LockedEnd::complete) look(s, motion, path.state, out);
      out.rests = path.end == LockedEnd::fell_short;
      return;
    }
    Simulator sim(s.boundary, motion, cushion, start);
    for (;;) {
      const int k = static_cast<int>(out.contacts.size());
      if (k >= rule.min && (!rule.sequence || out.contacts == *rule.sequence)) look(s, motion, sim.state(), out);
      if (k == rule.max) return;
      Event e = sim.step();
      while (e.kind == EventKind::slide_to_roll) e = sim.step();
      out.rests = e.kind == EventKind::rest;
      if (e.kind != EventKind::cushion) return;
      out.contacts.push_back(e.contact);
      const Wall* const wall = s.boundary.line(e.contact);
      const Jet along = wall ? dot(wall->along, sim.state().at) : Jet(0);
      out.places.push_back({along.a, along.v(0)});
      if (rule.sequence && e.contact != (*rule.sequence)[static_cast<std::size_t>(k)]) return;
    }
  });
  s.spend(out.contacts.size());
}

void first_order(const Search& s, Shot& shot) {
  const Vec2d& target = shot.arrival.at;
  const State<Jet> start = dual_start(s, shot.launch);
  const Vec2<Jet> end = with_physics(s.puzzle.physics, [&](const auto& motion, const auto& cushion) {
    const auto path = follow_locked(s.boundary, motion, cushion, std::span<const Contact>(shot.cushions), start);
    const auto arrival = arrive_locked(motion, s.boundary.body, path.state, target, 0, s.stop);
    if (s.stop) return arrival.state.at;
    // Along the line of travel nothing is missed: only the lateral part counts.
    const Vec2<Jet> u = arrival.heading / norm(arrival.heading);
    const Vec2d line{-u.y.a, u.x.a};
    const Jet lateral = cross(u, to<Jet>(target) - arrival.state.at);
    return Vec2<Jet>{lateral * line.x, lateral * line.y};
  });
  const Vec2d by_log_speed{end.x.v(1), end.y.v(1)};
  shot.by_angle = {end.x.v(0), end.y.v(0)};
  shot.by_speed = by_log_speed / shot.launch.speed;
  shot.condition = std::max(norm(shot.by_angle), norm(by_log_speed));
  const Noise& noise = s.puzzle.noise;
  const double spread = std::hypot(norm(shot.by_angle) * noise.angle, norm(shot.by_speed) * noise.speed);
  shot.first_order = s.nearest_reach(shot.arrival.at) / spread;
}

}  // namespace bankshot::planning
