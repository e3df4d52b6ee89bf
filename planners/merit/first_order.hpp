// SPDX-License-Identifier: MIT
//
// What the derivatives of one locked path say of a shot: how the arrival moves with aim and speed, its condition, and
// the margin to first order. Cost: one simulation with dual numbers, which no ledger is charged.
#pragma once

#include "bankshot/plan/shot.hpp"
#include "planners/question.hpp"

namespace bankshot::planning {

/// Fills `by_angle`, `by_speed`, `condition` and `first_order`.
void add_first_order(const Question& q, Shot& shot);

}  // namespace bankshot::planning
