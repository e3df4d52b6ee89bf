// SPDX-License-Identifier: MIT
#pragma once

#include "planners/verify/prove.hpp"
#include "support/catch.hpp"

namespace bankshot::test {

/// Returns the shot of a launch that makes the target; any other launch fails the test.
inline Shot shot_of(const planning::SearchRequest& request, const Launch& launch,
                    planning::Demand demand = planning::Demand::made) {
  planning::EvaluationBudget budget(1);
  const planning::Proof proof = planning::prove(request, budget, launch, planning::Goal::of(request, demand));
  REQUIRE(proof.holds());
  return proof.shot;
}

}  // namespace bankshot::test
