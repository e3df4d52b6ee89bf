// SPDX-License-Identifier: MIT
//
// The affine map of an unfolding: from the table to its image beyond some cushions.
#pragma once

#include <cmath>

#include "bankshot/numbers/vec.hpp"

namespace bankshot::planning {

struct Affine {
  double xx = 1, xy = 0, yx = 0, yy = 1;
  Vec2d shift{};

  Vec2d apply(const Vec2d& p) const { return {xx * p.x + xy * p.y + shift.x, yx * p.x + yy * p.y + shift.y}; }
  /// Returns the direction on the table, of arbitrary length, that maps to the direction `d` in the image.
  Vec2d back(const Vec2d& d) const {
    const Vec2d adjoint{yy * d.x - xy * d.y, xx * d.y - yx * d.x};
    return xx * yy - xy * yx < 0 ? -adjoint : adjoint;
  }
  /// Returns the Frobenius norm over √2: 1 for a reflection, never less than half the largest stretch.
  double stretch() const { return std::sqrt((xx * xx + xy * xy + yx * yx + yy * yy) / 2); }
};

}  // namespace bankshot::planning
