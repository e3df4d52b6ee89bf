// SPDX-License-Identifier: MIT
//
// Many launches of one scene, into an array: the hot path of the interfaces in C and Python.
#pragma once

#include <atomic>
#include <span>

#include "bankshot/bankshot.h"
#include "bankshot/simulate/trajectory.hpp"

namespace bankshot::bindings {

/// `ends[i]` for `launches[i]`, on so many threads (0: one for each core), until `stop`. The scene's own shot does not
/// count. Throws InvalidInput where the scene breaks a rule.
void simulate_many(const ShotRequest& scene, std::span<const bankshot_launch> launches, bankshot_end* ends, int threads,
                   const std::atomic<bool>& stop);

}  // namespace bankshot::bindings
