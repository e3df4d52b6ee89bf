// SPDX-License-Identifier: MIT
#pragma once

#include "bankshot/simulate/trajectory.hpp"

namespace bankshot {

/// A shot with other balls on the table; the request is valid.
Trajectory record_many(const ShotRequest& request);

}  // namespace bankshot
