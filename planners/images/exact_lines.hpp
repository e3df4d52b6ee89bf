// SPDX-License-Identifier: MIT
//
// Where to aim in an image: points on the exact lines of a mark (geometry/opening.hpp) that a straight ray from the ball
// can follow. An eighth inside a gap between two ends A and B is a line through the fixed point (7 A + B)/8; between an
// end A and a tangent of the circle, one that passes 7 A/8 at an eighth of the radius. So five lines are all there can be:
// each is found on its own, and kept where it is the exact one in the direction it has.
#pragma once

#include <array>
#include <cstddef>

#include "bankshot/scene/target.hpp"
#include "planners/images/affine.hpp"

namespace bankshot::planning {

class ExactLines {
 public:
  /// As a ball at `from` sees the mark in an image. Where no line is exact, the mark itself.
  ExactLines(const Mark& mark, const Affine& image, const Vec2d& from);

  const Vec2d* begin() const { return points_.data(); }
  const Vec2d* end() const { return points_.data() + size_; }

 private:
  std::array<Vec2d, 5> points_{};  ///< m, on the table
  std::size_t size_ = 0;
};

}  // namespace bankshot::planning
