// SPDX-License-Identifier: MIT
//
// The outline of the mouth of a pocket with jaws, for pictures.
#pragma once

#include <array>

#include "bankshot/geometry/obstacle.hpp"

namespace bankshot {

/// Returns the outline of the cloth between two jaws. It goes from a rail round a tip to the second point, along the
/// facing, across, along the other facing, and round the other tip to the last point, on a rail.
std::array<Vec2d, 6> mouth(const Table& table, const JawPieces& jaws);

}  // namespace bankshot
