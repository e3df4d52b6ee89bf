// SPDX-License-Identifier: MIT
//
// The noise of a camera, and the samples that it saw wrong.
#pragma once

#include "planners/learn/seen.hpp"

namespace bankshot::planning {

using Recordings = std::vector<const Recording*>;

/// Returns the standard error [m] of one coordinate of a sample, from differences between neighbours.
double noise_of(const Recordings& recordings);

/// Marks samples before anything is fitted: those to which the samples before, after and around them do not lead.
void mark_apart(Seen& seen);

/// Marks samples that lie apart from their neighbours, and farther than these from each other. A camera errs so for a
/// moment, but a law does not.
void mark_outliers(Seen& seen, const Common& common);

}  // namespace bankshot::planning
