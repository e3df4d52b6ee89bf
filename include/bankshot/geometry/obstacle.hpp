// SPDX-License-Identifier: MIT
//
// What balls bounce off, before any ball is there: pieces of the cushions' nose lines, straight or round, each
// with an end. They are made of a table once; a Boundary moves them into the table by the radius of a ball.
//   segment  from one point to another; the table lies on its left
//   bend     part of a circle: a corner that points into the table is one of radius 0, between the normals of
//            the two segments that meet there
// A ball of radius R meets a segment where its centre is R from the line and its foot inside the segment, a bend
// where its centre is R + radius from the bend's centre, in a direction between the two normals.
#pragma once

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
  Vec2d middle;   ///< unit, into the table: the normal half way along it
  double half;    ///< rad: it extends so far to either side of that
  Contact contact{};
  Contact before{}, after{};  ///< the segments that it joins, tangent to both
};

struct Obstacles {
  std::vector<Segment> segments;  ///< in the order of the outline
  std::vector<Bend> bends;
};

Obstacles obstacles(const Table& table);

}  // namespace bankshot
