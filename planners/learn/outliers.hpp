// SPDX-License-Identifier: MIT
//
// How much a camera errs, and the samples that it saw wrong.
#pragma once

#include "planners/learn/seen.hpp"

namespace bankshot::planning {

using Recordings = std::vector<const Recording*>;

/// m: how much one coordinate of a sample errs, from what neighbours do not share.
double noise_of(const Recordings& recordings);

/// Before anything is fitted: samples that neither those before them, nor those after them, nor both lead to.
void mark_apart(Seen& seen);

/// Samples that lie apart from their neighbours, and farther than these from each other: what a camera sees wrong for a
/// moment, not what a law gets wrong.
void mark_outliers(Seen& seen, const Common& common);

}  // namespace bankshot::planning
