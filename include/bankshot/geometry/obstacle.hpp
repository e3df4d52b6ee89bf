// SPDX-License-Identifier: MIT
//
// The obstacles of a table, independent of any ball: straight and round pieces of the cushions' nose lines. They are
// built once per table; a Boundary moves them into the table by the radius of a ball.
//   segment  a line from one point to another; the table lies on its left
//   bend     an arc. A corner that points into the table is a bend of radius 0 between the normals of the two segments
//            that meet there. The tip of a rail at a pocket with jaws is another.
//   mouth    the gap in the rails at a pocket with jaws, with its four jaw pieces. A centre leaves the rectangle of
//            centres only through a mouth.
// A ball of radius R meets a segment when its centre is R from the line and its foot lies inside the segment. It meets
// a bend when its centre is R + radius from the bend's centre, in a direction between the two normals.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "bankshot/geometry/contact.hpp"
#include "bankshot/scene/table.hpp"

namespace bankshot {

struct Segment {
  Vec2d from, to;  ///< m
  Contact contact{};
};

struct Bend {
  Vec2d centre;   ///< m
  double radius;  ///< m, >= 0
  Vec2d middle;   ///< unit normal at the middle of the arc, into the table
  double half;    ///< rad; the arc extends this far to either side of `middle`
  Contact contact{};
  Contact before{}, after{};  ///< the segments that it joins, tangent to both
};

/// An interval of a rail without cushion, from `begin` to `end` [m from the rail's start].
struct Break {
  int rail;
  double begin, end;
};

struct JawPieces {
  std::vector<Break> breaks;       ///< one in each of the two rails; a single one inside a rail
  std::array<Bend, 2> tips;        ///< in the order of the outline, like the facings
  std::array<Segment, 2> facings;  ///< of length 0 if the tips reach as deep
  bool faced() const { return !(facings[0].from == facings[0].to); }
};

struct Obstacles {
  std::vector<Segment> segments;  ///< whole rails, in the order of the outline
  std::vector<Bend> bends;        ///< corners that point into the table
  std::vector<JawPieces> jaws{};  ///< one for every pocket, or empty
};

Obstacles obstacles(const Table& table);

/// Returns the squared distance [m²] from a point to the segment from `a` to `b`; comparing squares avoids a root.
inline double square_to_segment(const Vec2d& p, const Vec2d& a, const Vec2d& b) {
  const Vec2d d = b - a;
  const double length2 = dot(d, d);
  const double s = length2 > 0 ? std::clamp(dot(p - a, d) / length2, 0.0, 1.0) : 0.0;
  const Vec2d off = p - (a + d * s);
  return dot(off, off);
}

/// Returns the corners of the table's inside, anticlockwise; round tips are cut short.
std::vector<Vec2d> outline(const Table& table, const std::vector<JawPieces>& jaws);

}  // namespace bankshot
