// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "bankshot/plan/shot.hpp"
#include "planners/ledger.hpp"
#include "planners/question.hpp"

namespace bankshot::planning {

/// `success`: the chance that the target is made by any allowed cushions, under the player's errors;
/// success.cpp says how it is found. What `others` make, shots of the same puzzle, is looked for. At most
/// settings::success::most_samples simulations, fewer where the ledger ends.
void find_success(const Question& q, Ledger& ledger, Shot& shot, std::span<const Shot> others = {});

}  // namespace bankshot::planning
