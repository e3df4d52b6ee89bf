// SPDX-License-Identifier: MIT
//
// Where a ball drops, seen from the pocket's exact line.
#pragma once

#include <algorithm>
#include <cmath>

#include "bankshot/geometry/opening.hpp"

namespace bankshot::test {

/// How far the exact line is on the left of that of a ball that enters a pocket here [m]; v need not be a unit vector.
/// The gap is the library's, which tests/unit/opening_test.cpp holds against its definition.
inline double left_of_drop(const Boundary& boundary, Contact pocket, const Vec2d& at, const Vec2d& v) {
  const Circle& rim = *boundary.rim(pocket);
  const Vec2d from_centre = at - rim.centre, u = v / norm(v);
  const auto arcs = openings(boundary, rim);
  const auto arc = std::ranges::min_element(arcs, {}, [&](const Opening& o) { return o.distance(from_centre); });
  const double offset = cross(u, from_centre);
  return arc->gap(u, offset).exact() - offset;
}

}  // namespace bankshot::test
