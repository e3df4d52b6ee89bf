// SPDX-License-Identifier: MIT
//
// What a pocket offers to a ball that comes straight: the arc of its circle where a ball's centre can be.
// A line in direction u is told by its *offset*, its distance from the pocket's centre, positive where the line passes
// on the left of that centre as the ball travels. Lines that enter through the arc fill an interval of offsets, the
// *gap*. With jaws the gap holds those that touch none of them: a line may pass the round tip at either end of the arc
// no nearer than a tangent of it. The *exact line* is the one nearest to the centre that keeps an eighth of the gap
// from both its ends. Worked number: a corner pocket of radius 58 mm and a ball of 28.575 mm: the arc is that
// from 29.5° to 60.5°, its ends 31 mm apart. Seen along the bisector the gap is ±15.4 mm and the exact line has offset
// 0; seen 30° beside it the gap goes from 15.5 to 42 mm, and the exact line, 3.3 mm inside it, has offset 18.8 mm.
#pragma once

#include <algorithm>
#include <vector>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/numbers/scalar.hpp"

namespace bankshot {

/// Offsets [m] of the lines in one direction that lead straight in.
template <class T>
struct Gap {
  T low, high;

  /// The offset of the exact line: clamp(0, low + w/8, high − w/8), w the width.
  T exact() const {
    const T eighth = (high - low) / 8;
    if (low + eighth > T(0)) return low + eighth;
    return high - eighth < T(0) ? high - eighth : T(0);
  }
};

/// The tip of a jaw beside an opening, from the pocket's centre.
struct OpeningTip {
  Vec2d centre{};     ///< m
  double radius = 0;  ///< m, for the centre of a ball; 0: there is none
  Vec2d middle{};     ///< unit: of its extent
  double least = 0;   ///< cosine of half its extent

  bool operator==(const OpeningTip&) const = default;
};

struct Opening {
  double radius = 0;      ///< m, of the circle
  Vec2d first{}, last{};  ///< m, from its centre to the ends of the arc, anticlockwise; equal where it is whole
  OpeningTip tips[2]{};   ///< beside those ends

  bool operator==(const Opening&) const = default;
  bool whole() const { return first == last; }
  /// Whether a ray from the centre goes through the arc.
  bool covers(const Vec2d& ray) const;
  /// From a point, given from the centre, to the nearest of the arc [m].
  double distance(const Vec2d& from_centre) const;

  /// Seen along the unit vector u. Of an arc that is seen in two parts, the one where the offset `near` is; of one that
  /// only shows its back, nothing: both ends where its first bit will appear.
  template <class T>
  Gap<T> gap(const Vec2<T>& u, double near) const {
    Gap<T> out = into_circle(u, near);
    pass_tip(u, tips[0], 1, out);
    pass_tip(u, tips[1], -1, out);
    if (out.high < out.low) out.low = out.high = (out.low + out.high) / 2;
    return out;
  }

 private:
  /// As if nothing stood before the circle.
  template <class T>
  Gap<T> into_circle(const Vec2<T>& u, double near) const {
    const T left(radius), right(-radius);
    if (whole()) return {right, left};
    const Vec2d way = value(u);
    const bool sees_first = !(dot(first, way) > 0), sees_last = !(dot(last, way) > 0);
    // Anticlockwise along the side of the circle that is seen is from left to right.
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

  /// `side`: 1 where the tip is on the left of the line, else -1.
  template <class T>
  void pass_tip(const Vec2<T>& u, const OpeningTip& tip, int side, Gap<T>& gap) const {
    if (!(tip.radius > 0)) return;
    const Vec2d way = value(u), towards_line{side * way.y, -side * way.x}, met = tip.centre + towards_line * tip.radius;
    // The tangent's point is not on the tip, or the ball has fallen before.
    if (dot(tip.middle, towards_line) < tip.least || dot(met, met) < radius * radius) return;
    const T bound = cross(u, to<T>(tip.centre)) - T(side * tip.radius);
    if (side > 0 && bound < gap.high) gap.high = bound;
    if (side < 0 && bound > gap.low) gap.low = bound;
  }
};

/// The arcs of a pocket's circle, as walls and tips cut it. A pocket without a size has one that is whole;
/// one whose jaws are too narrow has none.
std::vector<Opening> openings(const Boundary& boundary, const Circle& pocket);

}  // namespace bankshot
