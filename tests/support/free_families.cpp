// SPDX-License-Identifier: MIT
#include "support/family_makers.hpp"

#include <algorithm>
#include <cmath>

#include "support/forward.hpp"

namespace bankshot::test::make {
namespace {

/// Draws a range around `v` that reaches at most `down` below and `up` above it, and never below `least`.
Range around(Random& r, double v, double down, double up, double least) {
  return {std::max(least, v - down * r.uniform(0, 1)), v + up * r.uniform(0, 1)};
}

void bound_aim(Random& r, Made& m, double narrowest, double widest) {
  const auto side = [&] { return r.log_uniform(narrowest, widest); };
  const double low = wrap_angle(m.launch.angle - side());
  m.puzzle.angle = Range{low, low + wrap_angle(m.launch.angle - low) + side()};
}

void bound_speed(Random& r, Made& m, double narrowest, double widest) {
  const auto side = [&] { return m.launch.speed * r.log_uniform(narrowest, widest); };
  m.puzzle.speed = {std::max(m.launch.speed / 2, m.launch.speed - side()), m.launch.speed + side()};
}

Made usual(Random& r, Model model, int bounces) {
  return ask_for_some(r, bounces, 3, [&] { return usual_shot(r, model); });
}

/// Returns true when the tip meets the ball: its offset, 2/5 of the spin in units of R, is below 1.
bool on_ball(double top, double side) { return std::hypot(top, side) < 2.5; }

}  // namespace

Made arrive_range(Random& r, Model model, int bounces) {
  return first_valid([&]() -> std::optional<Made> {
    Made m = usual(r, model, bounces);
    if (!is_ideal(m.puzzle.physics)) {
      if (!m.puzzle.arrive) return {};
      const double seen = m.puzzle.arrive->low;
      m.puzzle.arrive = around(r, seen, seen, 2 * seen, 1e-3);
    }
    const double kind = r.uniform(0, 1);
    if (kind < 0.7) bound_aim(r, m, 1e-3, 1);
    if (kind > 0.4) bound_speed(r, m, 1e-3, 0.5);
    return m;
  });
}

Made spin_range(Random& r, Model model, int bounces) {
  return first_valid([&]() -> std::optional<Made> {
    Made m = usual(r, has_spin(model) ? model : Model::spin, bounces);
    const LaunchSpin& made = m.puzzle.spin;
    const double reach = r.chance(0.5) ? 1.2 : r.log_uniform(0.01, 0.5);
    const auto range = [&](double v, double share) {
      return r.chance(share) ? around(r, v, reach, reach, -1e300) : Range{v, v};
    };
    m.puzzle.spin_range = SpinRange{range(made.top, 0.8), range(made.side, 0.8), range(made.masse, 0.2)};
    const SpinRange& s = *m.puzzle.spin_range;
    if (s.top.fixed() && s.side.fixed() && s.masse.fixed()) return {};
    for (const double top : {s.top.low, s.top.high})
      for (const double side : {s.side.low, s.side.high})
        if (!on_ball(top, side)) return {};
    if (r.chance(0.5)) bound_aim(r, m, 1e-3, 1);
    return m;
  });
}

Made both_bounds(Random& r, Model model, int bounces) {
  return first_valid([&]() -> std::optional<Made> {
    Made m = usual(r, model, bounces);
    bound_aim(r, m, 1e-6, 1e-1);
    if (!m.puzzle.speed.fixed()) bound_speed(r, m, 1e-6, 1e-1);
    if (m.puzzle.arrive && r.chance(0.3)) m.puzzle.arrive = around(r, m.puzzle.arrive->low, 0.1, 0.1, 1e-3);
    return m;
  });
}

Made budgets(Random& r, Model model, int bounces) {
  using Make = Made (*)(Random&, Model, int);
  constexpr Make kinds[] = {usual, arrive_range, spin_range, both_bounds, edge_pockets};
  const Make make = kinds[has_spin(model) ? r.integer(0, 4) : 0];
  Made m = make(r, model, bounces);
  m.puzzle.budget = r.chance(0.1) ? r.integer(0, 2) : static_cast<long>(r.log_uniform(1, 3000));
  if (r.chance(0.4)) m.puzzle.aim = Aim::safest;
  if (r.chance(0.3)) m.puzzle.cushions = {0, 3, {}};
  return m;
}

}  // namespace bankshot::test::make
