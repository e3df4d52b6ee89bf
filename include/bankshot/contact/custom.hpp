// SPDX-License-Identifier: MIT
//
// A cushion of your own: a law in double that changes the ball's motion in the frame of the cushion it meets
// (cushion_frame.hpp). n points into the cushion, so vn > 0 before and vn <= 0 after.
//
//   const CushionLawOf law([](const Body&, InCushionFrame<double>& f) { f.vn *= -0.8; });  // must outlive the physics
//   Physics physics = spin_physics();
//   physics.cushion = CustomCushion{.law = &law, .restitution = 0.8};
//
// testing/cushion_promises.hpp tests whether a law keeps what planners rely on.
// Properties:
//  1. Derivatives are central differences of the law, with ten calls per bounce, right to about 1e-9. If a step
//     crosses a switch of the law, such as from sticking to sliding, they are a mean of both sides.
//  2. The law runs in double, even inside a simulation of 50 digits.
//  3. If the law leaves the ball moving into the cushion, vn becomes 0 and the ball stays there. If it gives a number
//     that is not finite, bounce() throws std::domain_error.
//  4. No allocation; the other cushions pay nothing for it.
// JSON cannot describe such a law: a puzzle with a custom cushion can be solved, but not written.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "bankshot/contact/cushion_frame.hpp"
#include "bankshot/contact/cushion_registry.hpp"
#include "bankshot/motion/arc.hpp"

namespace bankshot {

class CushionLaw {
 public:
  virtual ~CushionLaw() = default;
  virtual void impact(const Body& body, InCushionFrame<double>& f) const = 0;
};

/// A law made from a function.
template <class F>
class CushionLawOf final : public CushionLaw {
 public:
  explicit CushionLawOf(F f) : f_(std::move(f)) {}
  void impact(const Body& body, InCushionFrame<double>& f) const override { f_(body, f); }

 private:
  F f_;
};

namespace detail::custom {

template <class T>
using Numbers = std::array<T, 5>;

inline Numbers<double> after(const CushionLaw& law, const Body& body, const Numbers<double>& x) {
  InCushionFrame<double> f{x[0], x[1], x[2], x[3], x[4]};
  law.impact(body, f);
  if (!std::isfinite(f.vn + f.vt + f.wn + f.wt + f.wz))
    throw std::domain_error("the law of a custom cushion gave a number that is not finite");
  return {f.vn, f.vt, f.wn, f.wt, f.wz};
}

/// Adds to each result the derivatives of the inputs, times those of the law.
template <class T>
void add_derivatives(const CushionLaw& law, const Body& body, const Numbers<T>& before, const Numbers<double>& at,
                     Numbers<T>& result) {
  constexpr double step = 1e-5;  // relative to the size; truncation and rounding errors are then about equal
  const double v = std::hypot(at[0], at[1]) + body.radius * std::hypot(at[2], at[3], at[4]);
  for (std::size_t i = 0; i < at.size(); ++i) {
    double h = step * (i < 2 ? v : v / body.radius);
    if (i == 0) h = std::min(h, at[0] / 2);  // the law is asked only about balls that move into the cushion
    Numbers<double> low = at, high = at;
    low[i] -= h;
    high[i] += h;
    const Numbers<double> a = after(law, body, low), b = after(law, body, high);
    const T change = before[i] - T(at[i]);  // 0, with the derivatives of the input
    for (std::size_t k = 0; k < result.size(); ++k) result[k] += change * ((b[k] - a[k]) / (high[i] - low[i]));
  }
}

}  // namespace detail::custom

template <class T, class N>
inline void CustomCushion::bounce(const Body& body, State<T>& s, const Vec2<N>& away) const {
  InCushionFrame<T> f = into_frame(s, away);
  if (!(value(f.vn) > 0)) return;
  const detail::custom::Numbers<T> before{f.vn, f.vt, f.wn, f.wt, f.wz};
  detail::custom::Numbers<double> plain;
  for (std::size_t i = 0; i < plain.size(); ++i) plain[i] = static_cast<double>(value(before[i]));
  const detail::custom::Numbers<double> out = detail::custom::after(*law, body, plain);
  detail::custom::Numbers<T> result;
  for (std::size_t i = 0; i < out.size(); ++i) result[i] = T(out[i]);
  if constexpr (has_derivatives<T>) detail::custom::add_derivatives(*law, body, before, plain, result);
  f = {result[0], result[1], result[2], result[3], result[4]};
  if (value(f.vn) > 0) f.vn = T(0);
  out_of_frame(f, away, s);
}

}  // namespace bankshot
