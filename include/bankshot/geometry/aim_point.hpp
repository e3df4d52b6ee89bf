// SPDX-License-Identifier: MIT
//
// The aim points of a target, built once for a table and a ball. They tell where seeds aim, what counts as reached, how
// wide the target is, and the miss.
//   point   the centre passes within `within` of it, or comes to rest there: one aim point
//   pocket  the ball falls into it: one aim point for each arc of its circle where a ball can enter, usually one; "any
//           pocket" has those of every pocket
//   ball    the cue ball touches it, before any other ball or off a first one: one aim point for each ball of a list
#pragma once

#include <optional>
#include <vector>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/geometry/opening.hpp"
#include "bankshot/scene/target.hpp"

namespace bankshot {

struct Puzzle;

/// Offsets [m, see opening.hpp] of the lines of travel that touch a ball at the allowed cuts: −2 √(R1 R2) sin cut.
struct Cuts {
  double low, exact, high;
  bool operator==(const Cuts&) const = default;
};

/// An aim point: one point that a planner aims at to reach the target.
struct AimPoint {
  Vec2d at{};                  ///< the point, or the pocket's centre
  double reach = 0;            ///< m; `within`, the capture radius, or the touching distance of two balls
  int ball = 0;                ///< number of the ball that must reach it: the cue ball or an object ball
  Contact taken_by{};          ///< the pocket or ball that ends the path; none: the ball passes or rests here
  Opening opening{};           ///< for a pocket
  std::optional<Cuts> cuts{};  ///< for a ball

  bool operator==(const AimPoint&) const = default;
  bool captures() const { return bool(taken_by); }
  bool drops() const { return taken_by.kind == ContactKind::pocket; }
  /// Returns the distance from the aim point at which the ball arrives [m].
  double capture() const { return captures() ? reach : 0; }
  /// Returns the distance [m] from an arrival to the point, the arc of the pocket's circle, or the touching circle of
  /// the ball.
  double apart(const Vec2d& arrived) const;
  /// Returns the offsets [m, see opening.hpp] of the lines along the unit vector u that lead here. `near` is one of
  /// them.
  template <class T>
  Gap<T> gap(const Vec2<T>& u, double near) const {
    if (cuts) return {T(cuts->low), T(cuts->high)};
    return drops() ? opening.gap(u, near) : Gap<T>{T(-reach), T(reach)};
  }
  /// Returns the offset of the exact line; 0 for a point.
  template <class T>
  T exact_offset(const Vec2<T>& u, double near) const {
    if (cuts) return T(cuts->exact);
    return drops() ? opening.gap(u, near).exact() : T(0);
  }
};

/// Returns the aim points of a target for the ball of this boundary, in the order of the pockets or of the listed
/// balls.
std::vector<AimPoint> aim_points_of(const Target& target, const Boundary& boundary);

/// Returns the aim points of the balls that must reach the target.
std::vector<AimPoint> aim_points_of(const Puzzle& puzzle);

}  // namespace bankshot
