// SPDX-License-Identifier: MIT
//
// A shot played anew, for what its answer does not hold: printers ask here and simulate nothing themselves.
#pragma once

#include <functional>

#include "bankshot/plan/shot.hpp"

namespace bankshot {

/// Returns the state of the ball that arrives, at its arrival.
State<double> state_on_arrival(const Puzzle& puzzle, const Shot& shot);

/// Calls `visit(time, ball, state)` for every ball at each event up to the arrival, and 60 times a second between
/// events; time in seconds.
void sample_played(const Puzzle& puzzle, const Shot& shot,
                   const std::function<void(double time, int ball, const State<double>& state)>& visit);

}  // namespace bankshot
