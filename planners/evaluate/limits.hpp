// SPDX-License-Identifier: MIT
//
// The probability that normal errors of aim and speed break no limit, where every limit is known to first order. Errors
// are counted in the player's deviations; their plane is (aim, speed). The shot is made in a region of this plane:
// inside straight lines and, for a ball that must rest, an ellipse. With rho(t) the distance to its edge in direction
// t,
//   success = 1/2π ∫ (1 − exp(−rho²/2)) dt
// The directions are stretched with the region, so that a thin one is seen by as many of them as a wide one.
// Cost: no simulation; half a microsecond.
#pragma once

#include <vector>

#include "bankshot/numbers/dual.hpp"
#include "bankshot/scene/puzzle.hpp"

namespace bankshot::planning {

class Limits {
 public:
  /// Starts without limits, for a launch and its player.
  Limits(const Launch& launch, const Noise& noise)
      : per_rad_(noise.angle), per_log_(noise.speed_at(launch.speed) / launch.speed) {}

  /// Adds a limit: the shot is made while `room` stays above 0. Its derivatives are by aim [rad] and by ln speed.
  void keep(const Dual<2>& room) { add(room.a, in_deviations(room)); }
  /// Adds a limit whose slope is counted in deviations.
  void add(double room, const Vec2d& slope);
  /// Adds a limit: the shot is made while the ball rests within `reach` of the aim point.
  void rest(const Vec2<Dual<2>>& from_aim_point, double reach);
  /// Returns derivatives by aim and ln speed, in deviations.
  Vec2d in_deviations(const Dual<2>& d) const { return {d.v[0] * per_rad_, d.v[1] * per_log_}; }

  /// Returns whether all limits hold at the launch itself.
  bool hold() const;
  /// Returns a distance in this direction, in units of `towards`: until the first limit breaks, or, where some are
  /// broken, until the last of them holds again.
  double until(const Vec2d& towards) const;
  double until_all_hold(const Vec2d& towards) const;

  /// Returns the success. `across`: the direction in which the least error breaks a limit. `half`: half the width of
  /// the region there, in deviations.
  double success(const Vec2d& across, double half) const;
  /// Returns the success, with directions along the axes of the ellipse of `rest`.
  double success() const;

 private:
  struct Side {
    double room;
    Vec2d slope;
  };

  double per_rad_, per_log_;
  std::vector<Side> sides_{};
  double reach_ = 0;                               ///< m; 0: the ball need not rest
  Vec2d from_aim_point_{}, by_aim_{}, by_push_{};  ///< m, and m per deviation
};

}  // namespace bankshot::planning
