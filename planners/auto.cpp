// SPDX-License-Identifier: MIT
//
// Planner `auto`: the cheapest sure step first. Images are exact where paths unfold; a sweep of the
// aim adds what they cannot see (reflex vertices, dead cushions); Levenberg–Marquardt and then a
// global search are for what is left, and are not run when the images proved that nothing is.
#include "planners/planners.hpp"

namespace bankshot::planning {

void automatic(Search& s) {
  image(s);
  if (!s.complete && !s.cut) sweep(s);
  if (s.shots.empty() && !s.complete && !s.cut) ceres(s);
  if (s.shots.empty() && !s.complete && !s.cut) nlopt_direct(s);
}

}  // namespace bankshot::planning
