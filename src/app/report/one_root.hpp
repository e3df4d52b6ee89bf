// SPDX-License-Identifier: MIT
//
// One root along one locked sequence, found with and without derivatives, for `report` to compare. The planners
// themselves use dual numbers.
#pragma once

#include <vector>

#include "bankshot/scene/puzzle.hpp"

namespace bankshot::app::report {

/// dual: Newton's method with a Jacobian by dual numbers, one simulation per step. forward, central: Newton's method
/// with differences, three and five simulations per step. none: BOBYQA on the squared distance.
enum class Derivatives { dual, forward, central, none };

struct Iterate {
  long simulations;
  double seconds;  ///< since the start
  double miss;     ///< m, the least so far
};

/// Starts from the image of a puzzle that gives its sequence and asks the ball to rest at a point. Empty if the image
/// gives no seed. Ends when the miss no longer matters, or after enough steps. `clock` returns seconds.
std::vector<Iterate> approach(const Puzzle& puzzle, Derivatives derivatives, double (*clock)());

}  // namespace bankshot::app::report
