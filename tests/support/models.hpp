// SPDX-License-Identifier: MIT
//
// Every motion and every cushion, with the ranges of their parameters, for the conformance suites. A new motion needs
// one more overload of `draw` and one more name in the list. Cushions come from their registry.
#pragma once

#include <tuple>

#include "bankshot/contact/cushion_registry.hpp"
#include "bankshot/contact/custom.hpp"
#include "bankshot/contact/han2005.hpp"
#include "bankshot/motion/ideal.hpp"
#include "bankshot/motion/rolling.hpp"
#include "bankshot/motion/slide_roll.hpp"
#include "bankshot/testing/cushion_promises.hpp"
#include "support/random_puzzle.hpp"

namespace bankshot::test {

inline constexpr double ball_radius = 0.028575;
inline constexpr Body body{ball_radius};

/// SlideRoll with rolling friction that grows with the speed. States that do not slide roll.
struct Dragging : SlideRoll {};

using Motions = std::tuple<Ideal, Rolling, SlideRoll, Dragging>;
template <class... Law>
std::tuple<Law...> tuple_of(const std::variant<Law...>&);
using Cushions = decltype(tuple_of(CushionVariant{}));

/// Allowed error of the integration of an impact, as a fraction of |v| + R|ω| (mathavan2010_digits_test.cpp); 0 for a
/// formula.
template <class Cushion>
inline constexpr double integration_error = CushionRow<Cushion>::model.integrated ? 10 * tolerance::impact : 0;

/// Draws a model. Without an overload below, a cushion has coefficients between the bounds of a fit.
template <class Model>
Model draw(Random& r) {
  Model law;
  law.restitution = Restitution{r.uniform(0, 1)};
  for_each_coefficient(law, [&](const CushionCoefficient& c, double& number) {
    number = r.uniform(c.fit_low, c.fit_high) * c.scale(ball_radius);
  });
  return law;
}

template <>
inline Ideal draw<Ideal>(Random&) {
  return {};
}
template <>
inline Rolling draw<Rolling>(Random& r) {
  return {.friction = r.log_uniform(0.003, 0.05)};
}
template <>
inline SlideRoll draw<SlideRoll>(Random& r) {
  return {.sliding_friction = r.uniform(0.05, 0.4),
          .rolling_friction = r.log_uniform(0.003, 0.05),
          .spinning_friction = r.log_uniform(0.003, 0.05)};
}
template <>
inline Dragging draw<Dragging>(Random& r) {
  Dragging d{draw<SlideRoll>(r)};
  d.rolling_friction.per_speed = r.log_uniform(1e-6, 1);
  return d;
}
template <>
inline Mirror draw<Mirror>(Random& r) {
  return {Restitution{r.uniform(0, 1)}};
}
template <>
inline Han2005 draw<Han2005>(Random& r) {
  return {.height = ball_radius * r.uniform(1.01, 1.7),
          .restitution = Restitution{r.uniform(0, 1)},
          .friction = r.uniform(0, 0.5)};
}

template <>
inline Mathavan2010 draw<Mathavan2010>(Random& r) {
  return {.height = ball_radius * r.uniform(1.05, 1.5),
          .restitution = Restitution{r.uniform(0, 1)},
          .friction = r.uniform(0, 0.4),
          .sliding_friction = r.uniform(0.05, 0.4)};
}

template <>
inline Stronge draw<Stronge>(Random& r) {
  return {.height = ball_radius * r.uniform(1.01, 1.7),
          .restitution = Restitution{r.uniform(0, 1)},
          .friction = r.uniform(0, 0.5),
          .frequency_ratio = r.uniform(1.02, 1.98)};
}

/// Han's law as a user would write it.
struct HanLaw final : CushionLaw {
  Han2005 han{};
  void impact(const Body& of, InCushionFrame<double>& f) const override {
    State<double> s;
    out_of_frame(f, Vec2d{0, 1}, s);
    han.bounce(of, s, Vec2d{0, 1});
    f = into_frame(s, Vec2d{0, 1});
  }
};
/// The result is valid until the next draw.
template <>
inline CustomCushion draw<CustomCushion>(Random& r) {
  static HanLaw law;
  law.han = draw<Han2005>(r);
  return {&law, law.han.restitution};
}

/// Draws a moving ball with any spin, over many decades of speed.
inline State<double> draw_state(Random& r) {
  const double v = r.log_uniform(1e-3, 20), w = v / ball_radius;
  return {{r.uniform(-2, 2), r.uniform(-2, 2)},
          direction(r.uniform(0, 6.28)) * v,
          {w * r.uniform(-2, 2), w * r.uniform(-2, 2), w * r.uniform(-2, 2)}};
}

/// Draws a state that the motion can have. With Dragging, half of the states roll, because only a rolling ball feels
/// friction that grows with the speed.
template <class Motion>
State<double> draw_state_of(const Motion& motion, Random& r) {
  State<double> s = draw_state(r);
  if constexpr (std::is_same_v<Motion, Dragging>)
    if (r.chance(0.5)) s.spin = natural_roll(s.velocity, body.radius);
  s.spin = motion.spin(body, s);
  return s;
}

inline double energy_of(const State<double>& s) { return bankshot::energy_of(s, ball_radius); }
inline double scale_of(const State<double>& s) { return bankshot::scale_of(s, ball_radius); }
inline double difference(const State<double>& a, const State<double>& b) {
  return bankshot::difference(a, b, ball_radius);
}

inline State<double> times(const State<double>& s, double k) {
  return {s.at, s.velocity * k, {s.spin.x * k, s.spin.y * k, s.spin.z * k}};
}

/// Returns one of the seven numbers of a state, for derivatives.
template <class T>
T& number_of(State<T>& s, int k) {
  T* const all[] = {&s.at.x, &s.at.y, &s.velocity.x, &s.velocity.y, &s.spin.x, &s.spin.y, &s.spin.z};
  return *all[k];
}

/// Estimates f'(0) by Ridders' extrapolation of central differences: the steps shrink by 1.4 and powers of h² are
/// removed. Returns the estimate and its error estimate (Ridders 1982; Press et al., dfridr).
struct Slope {
  double value, error;
};
template <class F>
Slope ridders(const F& f, double step) {
  constexpr int rows = 10;
  constexpr double shrink = 1.4;
  double table[rows][rows], h = step;
  Slope best{0, std::numeric_limits<double>::infinity()};
  for (int i = 0; i < rows; ++i, h /= shrink) {
    table[0][i] = (f(h) - f(-h)) / (2 * h);
    double factor = shrink * shrink;
    for (int j = 1; j <= i; ++j, factor *= shrink * shrink) {
      table[j][i] = (table[j - 1][i] * factor - table[j - 1][i - 1]) / (factor - 1);
      const double error =
          std::max(std::abs(table[j][i] - table[j - 1][i]), std::abs(table[j][i] - table[j - 1][i - 1]));
      if (error <= best.error) best = {table[j][i], error};
    }
  }
  return best;
}

}  // namespace bankshot::test
