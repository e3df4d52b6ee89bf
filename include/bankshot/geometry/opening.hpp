// SPDX-License-Identifier: MIT
//
// The opening of a pocket: the arc of its circle where a ball's centre can enter in a straight line.
// A line in direction u is described by its *offset*, its distance from the pocket's centre. The offset is positive if
// the line passes on the left of that centre as the ball travels. Lines that enter through the arc fill an interval of
// offsets, the *gap*. With jaws the gap holds only lines that touch no jaw: at either end of the arc, a line may come
// no nearer to the round tip than a tangent. The *exact line* is the line nearest to the centre that keeps an eighth of
// the gap from both its ends.
// Example: a corner pocket of radius 58 mm and a ball of radius 28.575 mm. The arc goes from 29.5° to 60.5°, and its
// ends are 31 mm apart. Along the bisector the gap is ±15.4 mm and the exact line has offset 0. At 30° from the
// bisector the gap goes from 15.5 to 42 mm, and the exact line, 3.3 mm inside it, has offset 18.8 mm.
#pragma once

#include <algorithm>
#include <vector>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/numbers/scalar.hpp"

namespace bankshot {

/// The interval of offsets [m] of the lines in one direction that lead straight into the pocket.
template <class T>
struct Gap {
  T low, high;

  /// Returns the offset of the exact line: clamp(0, low + w/8, high − w/8), where w is the width.
  T exact() const {
    const T eighth = (high - low) / 8;
    if (low + eighth > T(0)) return low + eighth;
    return high - eighth < T(0) ? high - eighth : T(0);
  }
};

/// The tip of a jaw beside an opening, relative to the pocket's centre.
struct OpeningTip {
  Vec2d centre{};     ///< m
  double radius = 0;  ///< m; includes the ball's radius; 0 if there is no tip
  Vec2d middle{};     ///< unit vector to the middle of its arc
  double least = 0;   ///< cosine of half its arc

  bool operator==(const OpeningTip&) const = default;
};

struct Opening {
  double radius = 0;      ///< m; of the pocket's circle
  Vec2d first{}, last{};  ///< m; from the centre to the ends of the arc, anticlockwise; equal if it is a whole circle
  OpeningTip tips[2]{};   ///< beside the ends of the arc

  bool operator==(const Opening&) const = default;
  bool whole() const { return first == last; }
  /// Returns true if a ray from the centre goes through the arc.
  bool covers(const Vec2d& ray) const;
  /// Returns the distance [m] from a point, given relative to the centre, to the arc.
  double distance(const Vec2d& from_centre) const;

  /// Returns the gap along the unit vector u. If the visible arc has two parts, returns the one that holds the offset
  /// `near`. If only the back of the arc is visible, returns an empty gap at the offset where it would first appear.
  template <class T>
  Gap<T> gap(const Vec2<T>& u, double near) const {
    Gap<T> out = into_circle(u, near);
    pass_tip(u, tips[0], 1, out);
    pass_tip(u, tips[1], -1, out);
    if (out.high < out.low) out.low = out.high = (out.low + out.high) / 2;
    return out;
  }

 private:
  /// Returns the gap of the arc alone, without the tips of jaws.
  template <class T>
  Gap<T> into_circle(const Vec2<T>& u, double near) const {
    const T left(radius), right(-radius);
    if (whole()) return {right, left};
    const Vec2d way = value(u);
    const bool sees_first = !(dot(first, way) > 0), sees_last = !(dot(last, way) > 0);
    // On the visible side of the circle, anticlockwise means from left to right.
    const T high = cross(u, to<T>(first)), low = cross(u, to<T>(last));
    if (sees_first && sees_last) {
      if (!(high < low)) return {low, high};
      return 2 * near < value(low) + value(high) ? Gap<T>{right, high} : Gap<T>{low, left};
    }
    if (sees_first) return {right, high};
    if (sees_last) return {low, left};
    if (covers(-way)) return {right, left};
    const T end = cross(way, first + last) > 0 ? left : right;
    return {end, end};
  }

  /// Narrows the gap to lines that clear a tip. `side` is 1 if the tip is on the left of the line, otherwise -1.
  template <class T>
  void pass_tip(const Vec2<T>& u, const OpeningTip& tip, int side, Gap<T>& gap) const {
    if (!(tip.radius > 0)) return;
    const Vec2d way = value(u), towards_line{side * way.y, -side * way.x}, met = tip.centre + towards_line * tip.radius;
    // The tip does not matter if the point of tangency is not on it, or if the ball is captured before it gets there.
    if (dot(tip.middle, towards_line) < tip.least || dot(met, met) < radius * radius) return;
    const T bound = cross(u, to<T>(tip.centre)) - T(side * tip.radius);
    if (side > 0 && bound < gap.high) gap.high = bound;
    if (side < 0 && bound > gap.low) gap.low = bound;
  }
};

/// Returns the arcs of a pocket's circle that walls and tips leave open. A pocket of radius 0 has one whole circle; a
/// pocket whose jaws are too narrow has no arc.
std::vector<Opening> openings(const Boundary& boundary, const Circle& pocket);

}  // namespace bankshot
