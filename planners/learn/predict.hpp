// SPDX-License-Identifier: MIT
//
// Predicts the rest of a shot from its first part, with a learnt table.
#pragma once

#include "planners/learn/learn.hpp"

namespace bankshot::planning {

/// Predicts a shot from its samples up to 0.25 s after the first bounce.
Prediction predict(const Recording& recording, const Common& common, double noise, Spent& work);

/// Leaves out each recording once, in groups, and predicts it by what the others taught. `progress` gets the share that
/// is done.
std::vector<Prediction> held_out(const Recordings& all, const Asked& asked, int group, Spent& work,
                                 const std::function<void(double)>& progress);

}  // namespace bankshot::planning
