// SPDX-License-Identifier: MIT
//
// Simulates many launches of one scene into an array: the fast path of the C and Python interfaces.
#pragma once

#include <atomic>
#include <span>

#include "bankshot/bankshot.h"
#include "bankshot/simulate/trajectory.hpp"

namespace bankshot::bindings {

/// Writes the end of `launches[i]` to `ends[i]`, on the given number of threads (0: one per core), until `stop`. The
/// scene's own shot is not used. Throws InvalidInput if the scene breaks a rule.
void simulate_many(const ShotRequest& scene, std::span<const bankshot_launch> launches, bankshot_end* ends, int threads,
                   const std::atomic<bool>& stop);

}  // namespace bankshot::bindings
