// SPDX-License-Identifier: MIT
//
// The lateral offset of a drop from the pocket's exact line.
#pragma once

#include <algorithm>
#include <cmath>

#include "bankshot/geometry/opening.hpp"

namespace bankshot::test {

/// Returns how far the exact line lies to the left of the line of travel of a ball that enters a pocket at `at` [m]; v
/// need not be a unit vector. The opening comes from the library; tests/geometry/opening_test.cpp checks it against its
/// definition.
inline double left_of_drop(const Boundary& boundary, Contact pocket, const Vec2d& at, const Vec2d& v) {
  const Circle& rim = *boundary.rim(pocket);
  const Vec2d from_centre = at - rim.centre, u = v / norm(v);
  const auto arcs = openings(boundary, rim);
  const auto arc = std::ranges::min_element(arcs, {}, [&](const Opening& o) { return o.distance(from_centre); });
  const double offset = cross(u, from_centre);
  return arc->gap(u, offset).exact() - offset;
}

}  // namespace bankshot::test
