// SPDX-License-Identifier: MIT
//
// The lag speed: players compare other speeds with it.
#pragma once

#include <optional>

#include "bankshot/scene/puzzle.hpp"

namespace bankshot {

/// Returns the least launch speed [m/s] with which a ball on this table goes up it and back, as in the lag for the
/// break: from a quarter of its length, along its middle, over two cushions. Balls, pockets and spin of the scene do
/// not matter. None if the table is no rectangle or no ball comes back.
std::optional<double> lag_speed(const ShotRequest& scene);

}  // namespace bankshot
