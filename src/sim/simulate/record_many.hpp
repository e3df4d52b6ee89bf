// SPDX-License-Identifier: MIT
#pragma once

#include "bankshot/simulate/trajectory.hpp"

namespace bankshot {

/// Simulates a shot with other balls on the table. The request must be valid.
Trajectory record_many(const ShotRequest& request);

}  // namespace bankshot
