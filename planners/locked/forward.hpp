// SPDX-License-Identifier: MIT
//
// The real path of a launch, and how it would miss each mark if its bounces ended after any number of them that the
// puzzle allows: what one node of a map sees. Cost: one simulation with dual numbers.
#pragma once

#include <vector>

#include "planners/locked/residual.hpp"

namespace bankshot::planning {

struct Passage {
  std::size_t bounces, mark;  ///< how many, and which of the question's
  Linear linear;
};

/// Where a bounce lies along its cushion [m], and how that changes with the aim [m/rad]; of a vertex nothing.
struct BouncePlace {
  double along = 0, by_aim = 0;
};

struct Forward {
  Route route;
  std::vector<BouncePlace> places;  ///< of the real path's bounces
  std::vector<Passage> passages;
  bool rests = false;  ///< the path ends by itself before all the bounces asked
};

/// `locked`: a route that is given is followed on its locked path.
void forward(const Question& q, Ledger& ledger, const Launch& launch, bool locked, Forward& out);

}  // namespace bankshot::planning
