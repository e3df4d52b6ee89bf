// SPDX-License-Identifier: MIT
#include "planners/learn/bounds.hpp"

namespace bankshot::planning {

void bound_launch(ceres::Problem& problem, Seen& seen) {
  double* const block = seen.launch.data();
  const auto keep = [&](LaunchIndex k, double low, double high) {
    block[k] = std::min(std::max(block[k], low), high);
    problem.SetParameterLowerBound(block, static_cast<int>(k), low);
    problem.SetParameterUpperBound(block, static_cast<int>(k), high);
  };
  constexpr double fastest = 20, most_spin = 2, most_masse = 1;
  // The ball stands where its centre can be.
  const Boundary& boundary = seen.stand.struck();
  double left = -forever, right = forever, bottom = -forever, above = forever;
  for (const Wall& w : boundary.walls) {
    if (w.normal.x == 1) left = w.offset;
    if (w.normal.x == -1) right = -w.offset;
    if (w.normal.y == 1) bottom = w.offset;
    if (w.normal.y == -1) above = -w.offset;
  }
  if (boundary.strictly_convex || boundary.unfolds()) {
    if (left > -forever && right < forever) keep(x, left, right);
    if (bottom > -forever && above < forever) keep(y, bottom, above);
  }
  keep(speed, least_speed, fastest);
  keep(top, -most_spin, most_spin);
  keep(side, -most_spin, most_spin);
  keep(masse, -most_masse, most_masse);
}

}  // namespace bankshot::planning
