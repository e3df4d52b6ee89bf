// SPDX-License-Identifier: MIT
#include "sim/plan/played.hpp"

#include "bankshot/simulate/trajectory.hpp"

namespace bankshot {

State<double> state_on_arrival(const Puzzle& puzzle, const Shot& shot) {
  return end_of(simulate(as_request(puzzle, shot)), shot.arriving()).state;
}

void sample_played(const Puzzle& puzzle, const Shot& shot,
                   const std::function<void(double, int, const State<double>&)>& visit) {
  const ShotRequest request = as_request(puzzle, shot);
  sample(request, simulate(request), usual_rate, visit);
}

}  // namespace bankshot
