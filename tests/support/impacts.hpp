// SPDX-License-Identifier: MIT
//
// Cushion impacts for the tests of mathavan2010: the published ones, and families of random ones. The cushion lies
// along x and the ball arrives towards +y.
#pragma once

#include <string>

#include "bankshot/contact/mathavan2010.hpp"
#include "bankshot/motion/launched.hpp"
#include "bankshot/scene/ball.hpp"
#include "support/random_puzzle.hpp"

namespace bankshot::test {

inline constexpr Vec2d away_from_cushion{0, -1};

/// A launch at a cushion.
struct Arrival {
  Body body;
  Mathavan2010 cushion;
  Vec2d velocity;
  LaunchSpin spin;
  std::string name;

  /// Returns the state at impact. The spin is computed in T, so natural roll has no slip in any scalar type.
  template <class T>
  State<T> state() const {
    return launched({0, 0}, body.radius, to<T>(velocity), spin);
  }
};

/// The two sets of parameters of mathavan2010_impacts.jsonl.
inline constexpr Body paper_ball{.radius = 0.02625}, pool_ball{.radius = 0.028575};
inline Mathavan2010 paper_cushion() {
  return {.height = 0.03675, .restitution = 0.98, .friction = 0.14, .sliding_friction = 0.212};
}
inline Mathavan2010 pool_cushion() {
  return {.height = 0.036576, .restitution = 0.85, .friction = 0.2, .sliding_friction = 0.2};
}

inline constexpr const char* impact_families[] = {"rolling",  "sliding", "side spin", "draw",
                                                  "any spin", "grazing", "discrete"};

inline Arrival random_arrival(Random& r, int family) {
  constexpr double restitutions[] = {0, 0.2, 0.85, 0.98, 1};
  const bool paper = r.chance(0.5);
  Arrival a{paper ? paper_ball : pool_ball, paper ? paper_cushion() : pool_cushion(), {}, {}, impact_families[family]};
  a.cushion.restitution = restitutions[r.integer(0, 4)];
  if (r.chance(0.3)) a.cushion.height = a.body.radius * r.uniform(1.05, 1.7);
  double incidence = r.uniform(0, radians(180));
  const double speed = r.log_uniform(0.05, 10);
  switch (family) {
    case 0:
      a.spin.top = 1;
      break;
    case 1:
      break;
    case 2:
      a.spin = {r.chance(0.5) ? 1.0 : 0.0, r.uniform(-2, 2), 0};
      break;
    case 3:
      a.spin.top = r.uniform(-1.5, 0);
      break;
    case 4:
      a.spin = {r.uniform(-2, 2), r.uniform(-2, 2), r.uniform(-1, 1)};
      break;
    case 5:
      incidence = r.log_uniform(1e-6, 0.1);
      a.spin = {r.chance(0.5) ? 1.0 : r.uniform(-1, 1), r.chance(0.5) ? 0.0 : r.uniform(-1, 1), 0};
      break;
    default:
      incidence = radians(15.0 * r.integer(1, 11));
      a.spin = {0.5 * r.integer(-2, 3), 0.5 * r.integer(-2, 2), 0};
  }
  a.velocity = direction(incidence) * speed;
  return a;
}

/// Returns the contacts that slid, in order. I is the cushion and C the cloth; a lower-case letter means that the
/// contact sticks, 0 that the cloth carries no force. The bar | stands between compression and restitution.
inline std::string sequence(const ImpactCourse& c) {
  std::string out;
  bool back = false;
  for (int i = 0; i < std::min(c.modes, static_cast<int>(c.mode.size())); ++i) {
    const unsigned m = c.mode[static_cast<std::size_t>(i)];
    const bool now = (m & 8) != 0;
    out += now && !back ? " | " : out.empty() ? "" : " ";
    back = now;
    out += m & 1 ? 'I' : 'i';
    out += m & 4 ? '0' : m & 2 ? 'C' : 'c';
  }
  return out;
}

}  // namespace bankshot::test
