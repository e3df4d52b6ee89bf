// SPDX-License-Identifier: MIT
//
// The balls of a shot as they start, each with the table as it sees it, which is made once for each size.
//   const Starts starts(request);
//   ManyBalls sim(starts.balls(), motion, cushion, collisions(request.physics));   // simulate/many_balls.hpp
#pragma once

#include <list>
#include <span>
#include <vector>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/simulate/trajectory.hpp"

namespace bankshot {

/// The boundary is the ball's own: that of its radius.
template <class T>
struct BallStart {
  const Boundary* boundary;
  State<T> state;
  int number = -1;  ///< by which it is told as a contact; its place in the list where there is none
};

class Starts {
 public:
  /// The struck ball is the first. Of a valid request.
  explicit Starts(const ShotRequest& request);
  Starts(const Starts&) = delete;
  Starts& operator=(const Starts&) = delete;

  std::span<const BallStart<double>> balls() const { return balls_; }

 private:
  std::list<Boundary> boundaries_;  ///< which stay where they are
  std::vector<BallStart<double>> balls_;
};

}  // namespace bankshot
