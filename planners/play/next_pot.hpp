// SPDX-License-Identifier: MIT
//
// An estimate of the best straight pot of a ball, by geometry alone: no simulation. An error of the aim turns the
// object ball by d1 / (2R cos cut), with d1 from the cue ball to the ghost, so at the pocket, d2 away, its offset has
// the deviation s = error of aim · d1 · d2 / (2R cos cut). The chance is that of a normal error to stay inside the
// pocket's gap, which counts wider where jaws and rails lead a ball in. Cost: about 2 µs.
// It sees no banks, no kicks and no scratches.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "bankshot/geometry/aim_point.hpp"
#include "planners/problem.hpp"

namespace bankshot::planning::play {

class NextPot {
 public:
  /// `pockets`: those into which balls may fall.
  explicit NextPot(const Puzzle& puzzle, const PocketTarget& pockets = {});

  struct Best {
    double chance = 0;
    int ball = 0, pocket = -1;  ///< pocket of the table; -1: none can be reached
    double forgives = 0;        ///< so many standard errors of the aim
    Vec2d line{};               ///< unit, the cue ball's way
  };
  /// Returns the best pot of a next ball from where the balls are: the cue ball first, none where one has fallen. Where
  /// no ball of the order is left, its chance is 1.
  Best best(const PottingOrder& order, std::span<const std::optional<Vec2d>> places) const {
    return pots(order, places).front();
  }
  /// Returns all pots of the next balls, the best first. Never empty: the last resort is none that can be made.
  std::vector<Best> pots(const PottingOrder& order, std::span<const std::optional<Vec2d>> places) const;

 private:
  struct Mouth {
    AimPoint point;
    Vec2d into;  ///< unit, to its middle
    bool corner;
    bool jaws;

    /// Returns by how much the gap is wider on either side for a ball in this direction [m].
    double wider(const Vec2d& way) const;
  };

  /// Returns the pot of a ball into a pocket; it forgives 0 if it cannot be made.
  Best pot(const Mouth& mouth, int ball, std::span<const std::optional<Vec2d>> places) const;
  bool is_blocked(const Vec2d& from, const Vec2d& to, int ball, int by,
                  std::span<const std::optional<Vec2d>> places) const;
  const Body& body(int ball) const;

  const Puzzle& puzzle_;
  std::vector<Mouth> mouths_{};
};

/// Returns whether a ball can be hit directly from where the cue ball is: a part of it is not hidden by other balls.
bool can_be_hit(const Puzzle& puzzle, int ball, std::span<const std::optional<Vec2d>> places);

}  // namespace bankshot::planning::play
