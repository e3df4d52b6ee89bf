// SPDX-License-Identifier: MIT
//
// What balls bounce off, before any ball is there: pieces of the cushions' nose lines, straight or round, each
// with an end. They are made of a table once; a Boundary moves them into the table by the radius of a ball.
//   segment  from one point to another; the table lies on its left
//   bend     part of a circle: a corner that points into the table is one of radius 0, between the normals of
//            the two segments that meet there, and the tip of a rail at a pocket with jaws another
//   mouth    the gap in the rails at a pocket with jaws, and its four pieces: a ball whose centre leaves the table's
//            rectangle of centres does so through one of them
// A ball of radius R meets a segment where its centre is R from the line and its foot inside the segment, a bend
// where its centre is R + radius from the bend's centre, in a direction between the two normals.
#pragma once

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
  Vec2d middle;   ///< unit, into the table: the normal half way along it
  double half;    ///< rad: it extends so far to either side of that
  Contact contact{};
  Contact before{}, after{};  ///< the segments that it joins, tangent to both
};

/// Between `begin` and `end` along a rail [m from its start] there is no cushion.
struct Break {
  int rail;
  double begin, end;
};

struct JawPieces {
  std::vector<Break> breaks;       ///< of the rail before and the rail after, or of the one that both are
  std::array<Bend, 2> tips;        ///< in the order of the outline, as the facings
  std::array<Segment, 2> facings;  ///< of no length where the tips reach as deep
  bool faced() const { return !(facings[0].from == facings[0].to); }
};

struct Obstacles {
  std::vector<Segment> segments;  ///< whole rails, in the order of the outline
  std::vector<Bend> bends;        ///< corners that point into the table
  std::vector<JawPieces> jaws{};  ///< of every pocket, or none
};

Obstacles obstacles(const Table& table);

/// The corners of what is inside, anticlockwise; round tips are cut short.
std::vector<Vec2d> outline(const Table& table, const std::vector<JawPieces>& jaws);

}  // namespace bankshot
