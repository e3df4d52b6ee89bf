// SPDX-License-Identifier: MIT
//
// How far a ball has come.
#pragma once

#include <span>

#include "bankshot/simulate/trajectory.hpp"

namespace bankshot {

/// Metres that a ball covers in t seconds of an arc: ∫|v + a t| dt, split along and across a; written so that nothing
/// cancels where a is small.
double length(const Arc<double>& arc, double t);

/// Seconds from the first of these legs of one ball until it has covered `metres`; forever, where that lies beyond.
double time_to_length(std::span<const Leg> legs, double metres);

}  // namespace bankshot
