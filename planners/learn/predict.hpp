// SPDX-License-Identifier: MIT
//
// How well a learnt table tells the rest of a shot of which only the first part is known.
#pragma once

#include "planners/learn/learn.hpp"

namespace bankshot::planning {

/// The launch from the samples up to 0.25 s after the first bounce.
Prediction predict(const Recording& recording, const Common& common, double noise, Work& work);

/// Each recording left out once, in groups, and predicted by what the others taught. `progress` is told the share that
/// is done.
std::vector<Prediction> held_out(const Recordings& all, const Asked& asked, int group, Work& work,
                                 const std::function<void(double)>& progress);

}  // namespace bankshot::planning
