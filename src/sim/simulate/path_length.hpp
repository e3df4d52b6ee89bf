// SPDX-License-Identifier: MIT
//
// Computes path lengths.
#pragma once

#include <span>

#include "bankshot/simulate/trajectory.hpp"

namespace bankshot {

/// Returns the metres that a ball covers in t seconds of an arc: ∫|v + a t| dt, split along and across a. The formula
/// avoids cancellation for small a.
double length(const Arc<double>& arc, double t);

/// Returns the seconds from the start of the first leg of one ball until it has covered `metres`; forever if the legs
/// are shorter.
double time_to_length(std::span<const Leg> legs, double metres);

}  // namespace bankshot
