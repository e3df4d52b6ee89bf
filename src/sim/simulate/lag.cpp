// SPDX-License-Identifier: MIT
#include "sim/simulate/lag.hpp"

#include "bankshot/simulate/trajectory.hpp"

namespace bankshot {

std::optional<double> lag_speed(const ShotRequest& shot) {
  if (!shot.table.is_rectangle() || deceleration(shot.physics) == 0) return {};
  ShotRequest lag = shot;
  const Vec2d low = shot.table.lowest(), size = shot.table.highest() - low;
  const bool wide = size.x >= size.y;
  lag.table.pockets.clear();
  lag.others.clear();
  lag.spin = {};
  lag.ball.at = low + (wide ? Vec2d{size.x / 4, size.y / 2} : Vec2d{size.x / 2, size.y / 4});
  lag.launch.angle = wide ? 0 : radians(90);
  lag.until = {.time = {}, .cushions = 2, .length = {}};
  const auto comes_back = [&](double speed) {
    lag.launch.speed = speed;
    return simulate(lag).cushions == 2;
  };
  constexpr double fastest = 20;  // m/s; faster than any break
  double slow = 0, fast = fastest;
  if (!comes_back(fast)) return {};
  for (int i = 0; i < 20; ++i) (comes_back((slow + fast) / 2) ? fast : slow) = (slow + fast) / 2;
  return fast;
}

}  // namespace bankshot
