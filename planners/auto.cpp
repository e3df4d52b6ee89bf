// SPDX-License-Identifier: MIT
//
// Planner `auto`: the cheapest sure step first. Images are exact where paths unfold; a sweep of the
// aim adds what they cannot see (reflex vertices, dead cushions); Levenberg–Marquardt and then a
// global search are for what is left, and are not run when the images proved that nothing is.
#include <algorithm>

#include "planners/part.hpp"
#include "planners/planners.hpp"

namespace bankshot::planning {
namespace {

/// A sequence of straight cushions unfolds to one line, so its image is its only shot.
bool settled(const Search& s) {
  const auto& names = s.puzzle.cushions.sequence;
  const auto walls = static_cast<int>(s.boundary.walls.size());
  return s.complete || s.cut ||
         (names && !s.shots.empty() && std::all_of(names->begin(), names->end(), [&](int c) { return c < walls; }));
}

/// Images are only seeds, refinement finds the root, and the map what has no seed. Then parts of
/// targets whose centre something blocks.
void with_spin(Search& s) {
  ceres(s);
  if (s.cut) return;
  if (s.shots.empty() || s.all) sweep(s);
  const std::vector<Search::Lead> leads = std::move(s.leads);
  for (std::size_t i = 0; i < leads.size() && s.shots.empty() && !s.spent(); ++i) reach_part(s, leads[i], "sweep");
  if (s.shots.empty() && !s.cut) nlopt_direct(s);
}

}  // namespace

void automatic(Search& s) {
  if (!is_straight(s.puzzle.physics)) return with_spin(s);
  image(s);
  if (!settled(s)) sweep(s);
  if (s.shots.empty() && !s.complete && !s.cut) ceres(s);
  if (s.shots.empty() && !s.complete && !s.cut) nlopt_direct(s);
}

}  // namespace bankshot::planning
