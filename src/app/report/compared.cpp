// SPDX-License-Identifier: MIT
#include "app/report/compared.hpp"

#include <cmath>

#include "bankshot/motion/launched.hpp"
#include "bankshot/scene/ball.hpp"
#include "bankshot/simulate/simulator.hpp"
#include "bankshot/simulate/with_physics.hpp"

namespace bankshot::app::report {
namespace {

constexpr double length = 2.54, width = 1.27;  // m, of a 9-foot table
constexpr double radius = 0.028575;
constexpr double longest = 8;  // s; a slow ball that rolls for long would only cost the steppers time

std::vector<double> decades(double from, double to, double a_decade) {
  std::vector<double> out;
  const int n = static_cast<int>(std::lround(std::log10(from / to) * a_decade));
  for (int i = 0; i <= n; ++i) out.push_back(from * std::pow(10, -i / a_decade));
  return out;
}

/// Returns the moment half way between bounce number `cushions` and the next event; 0 if there are fewer bounces.
template <class Sim>
double moment(Sim sim, int cushions) {
  int met = 0;
  for (;;) {
    const double begin = sim.time();
    const Event e = sim.step();
    if (met == cushions) return sim.time() > begin ? begin + (sim.time() - begin) / 2 : 0;
    if (e.final()) return 0;
    if (e.kind == EventKind::cushion) ++met;
  }
}

}  // namespace

std::vector<Series> stepping_series(double least) {
  using Method = Scheme::Method;
  const std::vector<double> steps = decades(0.1, least, 2), tolerances = decades(1e-3, 1e-12, 1);
  return {{"Euler, clamped (seed article)", {Method::euler, false}, steps},
          {"semi-implicit Euler", {Method::semi_implicit, false}, steps},
          {"Runge–Kutta 4", {Method::rk4, false}, steps},
          {"Runge–Kutta 4, events located", {Method::rk4, true}, steps},
          {"Dormand–Prince, events located", {Method::dormand_prince, true}, tolerances}};
}

const Boundary& comparison_table(bool pockets) {
  static const Boundary plain(rectangle_table(length, width), {radius});
  static const Boundary with_pockets = [] {
    Table t = rectangle_table(length, width);
    t.pockets = six_pockets(t, Mouth{0.116, 0.129});
    return Boundary(t, {radius});
  }();
  return pockets ? with_pockets : plain;
}

Timed timed_shot(Random& draw, const Physics& physics, int cushions) {
  for (;;) {
    const Vec2d at{draw.uniform(radius, length - radius), draw.uniform(radius, width - radius)};
    const double speed = draw.log_uniform(1, 8), aim = draw.uniform(0, radians(360));
    LaunchSpin spin{draw.uniform(-0.5, 1), draw.uniform(-0.5, 0.5), 0};
    if (!carries_spin(physics)) spin = {1, 0, 0};
    const Timed shot{launched(at, radius, direction(aim) * speed, spin), 0};
    const double until = with_physics(physics, [&](const auto& motion, const auto& cushion) {
      return moment(Simulator(comparison_table(), motion, cushion, shot.start), cushions);
    });
    if (until > 0 && until < longest) return {shot.start, until};
  }
}

State<double> by_events(const Boundary& boundary, const Physics& physics, const Timed& shot) {
  return with_physics(physics, [&](const auto& motion, const auto& cushion) {
    Simulator sim(boundary, motion, cushion, shot.start);
    while (!sim.step(shot.until - sim.time()).final()) {
    }
    State<double> s = sim.state();
    s.spin = motion.spin(boundary.body, s);
    return s;
  });
}

}  // namespace bankshot::app::report
