// SPDX-License-Identifier: MIT
#include "bankshot/plan/shot.hpp"

#include <cmath>

#include "bankshot/scene/tip.hpp"

namespace bankshot {

int Shot::contacts() const {
  std::size_t cushions_met = cushions.size();
  for (const Onward& ball : then) cushions_met += ball.cushions.size();
  return static_cast<int>(cushions_met) + jaws;
}

double cost_of(const Launch& launch, const LaunchSpin& spin) {
  constexpr double per_speed = 0.004, per_radius_of_tip = 0.02;
  return per_speed * launch.speed + per_radius_of_tip * tip_of(spin, 1).from_centre();
}

double cost_of(const Shot& shot) {
  constexpr double per_contact = 0.005;
  return per_contact * shot.contacts() + cost_of(shot.launch, shot.spin);
}

double fullness(const Puzzle& p, const Hit& hit) {
  const Ball& other = p.others[static_cast<std::size_t>(hit.ball) - 1];
  const double a = p.ball.body.radius, b = other.body.radius;
  return (a + b - norm(other.at - hit.at) * std::abs(std::sin(hit.cut))) / (2 * b);
}

}  // namespace bankshot
