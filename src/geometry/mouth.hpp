// SPDX-License-Identifier: MIT
//
// The mouth of a pocket with jaws, as it is drawn.
#pragma once

#include <array>

#include "bankshot/geometry/obstacle.hpp"

namespace bankshot {

/// The cloth between two jaws: from a rail round its tip to the second point, along the facing, across, along the other
/// facing, and round the other tip to the last point, on a rail.
std::array<Vec2d, 6> mouth(const Table& table, const JawPieces& jaws);

}  // namespace bankshot
