// SPDX-License-Identifier: MIT
#pragma once

#include "bankshot/scene/json.hpp"
#include "planners/play/rest.hpp"
#include "planners/verify/aftermath.hpp"

namespace bankshot::test {

/// A pot of ball 1 into the top right pocket, with a leave and free spin, and the launch `x` near its exact line.
struct OnePot {
  Puzzle puzzle = read_puzzle(R"({"table": "pool-9ft",
    "ball": {"at": [0.635, 0.4], "spin": {"top": [-1, 1], "side": [-0.75, 0.75]}},
    "others": [{"id": "1", "at": [1.6, 0.9]}], "target": {"ball": "1", "pocket": "top-right"}, "cushions": 0,
    "leave": {"point": [1.9, 0.4]}})");
  planning::SearchRequest request{puzzle};
  planning::EvaluationBudget budget{100000};
  std::vector<StandingBall> standing{{1, request.problem->whole->balls()[1].boundary, puzzle.others[0].at}};
  Route hit{{0, Contact::ball(1)}};
  planning::Branch branch{request, hit, request.problem->aim_points.front()};
  planning::branch::Vector x = planning::branch::vector_of({2.4, 0.49}, {0.2, 0.4, 0});

  planning::play::CuePath path(const planning::branch::Vector& at) {
    const planning::SearchRequest own = request.spinning(planning::branch::spin_of(at));
    return {planning::play_out(own, budget, planning::branch::launch_of(at)).cue, standing};
  }
};

}  // namespace bankshot::test
