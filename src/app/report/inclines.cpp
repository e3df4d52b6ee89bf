// SPDX-License-Identifier: MIT
#include "app/report/inclines.hpp"

#include <cmath>
#include <vector>

namespace bankshot::app::report {
namespace {

/// Returns the clock σ at the moment `until`. The component of w across the slope shrinks by e^−Mσ. The boost of (|w|,
/// w) along the slope makes |w| + w·down shrink by e^−(M − pull)σ, which gives σ.
double clock_at(const detail::Incline<double>& law, const Vec2d& w, double until) {
  const Vec2d later = detail::before_stop(law, w, detail::stop_on(law, w).time - until);
  const auto sum = [&](const Vec2d& v) { return norm(v) + dot(law.down, v); };
  return std::log(sum(w) / sum(later)) / (law.friction - law.pull);
}

}  // namespace

Slipped series(const detail::Incline<double>& law, const Vec2d& w, double until, int terms, int steps) {
  const double h = clock_at(law, w, until) / steps;
  const auto size = static_cast<std::size_t>(terms);
  std::vector<double> on(size), across(size), speed(size);
  Slipped out{0, {0, 0}, w};
  for (int i = 0; i < steps; ++i) {
    on[0] = dot(law.down, out.w), across[0] = cross(law.down, out.w), speed[0] = norm(out.w);
    Vec2d moved{0, 0}, left{on[0], across[0]};
    double time = 0, power = h;
    for (std::size_t k = 0; k < size; ++k, power *= h) {
      const double by = 1 / static_cast<double>(k + 1);
      Vec2d product{0, 0};
      for (std::size_t j = 0; j <= k; ++j) product += Vec2d{on[k - j], across[k - j]} * speed[j];
      time += speed[k] * by * power;
      moved += product * (by * power);
      const double next_on = (law.pull * speed[k] - law.friction * on[k]) * by;
      const double next_across = -law.friction * across[k] * by;
      left += Vec2d{next_on, next_across} * power;
      if (k + 1 == size) break;
      on[k + 1] = next_on, across[k + 1] = next_across;
      speed[k + 1] = (law.pull * on[k] - law.friction * speed[k]) * by;
    }
    const auto on_table = [&](const Vec2d& v) { return law.down * v.x + perpendicular(law.down) * v.y; };
    out.time += time;
    out.moved += on_table(moved);
    out.w = on_table(left);
  }
  return out;
}

Slipped perturbed(const detail::Incline<double>& law, const Vec2d& w) {
  const double q = norm(w), M = law.friction;
  const Vec2d ahead = w / q, down = law.down * (law.pull / M);
  const double along = dot(down, ahead);
  const Vec2d aside = down - ahead * along;
  const double way = q * q / (2 * M);
  return {q / M * (1 + along), ahead * (way * (1 + along)) + aside * (way / 2), {0, 0}};
}

Slipped exactly(const detail::Incline<double>& law, const Vec2d& w) {
  const detail::Stop<double> stop = detail::stop_on(law, w);
  return {stop.time, stop.beyond + w * stop.time, {0, 0}};
}

Slipped exactly(const detail::Incline<double>& law, const Vec2d& w, double until) {
  const Slipped whole = exactly(law, w);
  const Vec2d later = detail::before_stop(law, w, whole.time - until);
  return {until, whole.moved - exactly(law, later).moved, later};
}

}  // namespace bankshot::app::report
