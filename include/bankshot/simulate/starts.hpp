// SPDX-License-Identifier: MIT
//
// The balls of a shot as they start, each with the table as it sees it. That is made once for each ball size.
//   const Starts starts(request);
//   ManyBalls sim(starts.balls(), motion, cushion, collisions(request.physics));   // simulate/many_balls.hpp
#pragma once

#include <list>
#include <span>
#include <vector>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/simulate/trajectory.hpp"

namespace bankshot {

/// Start of one ball. The boundary is that for its radius.
template <class T>
struct BallStart {
  const Boundary* boundary;
  State<T> state;
  int number = -1;  ///< number as a contact; its place in the list if negative
};

class Starts {
 public:
  /// Takes a valid request. The cue ball comes first.
  explicit Starts(const ShotRequest& request);
  Starts(const Starts&) = delete;
  Starts& operator=(const Starts&) = delete;

  std::span<const BallStart<double>> balls() const { return balls_; }

 private:
  std::list<Boundary> boundaries_;  ///< a list, so that they stay where they are
  std::vector<BallStart<double>> balls_;
};

}  // namespace bankshot
