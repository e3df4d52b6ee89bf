// SPDX-License-Identifier: MIT
//
// If a puzzle leaves its arrival speed or its spin free, its roots form curves and surfaces in the space of launches.
// Here a launch has five coordinates. A point of a branch is what its locked path does there, with derivatives by all
// of them. Worked number: a straight shot of 1 m into a pocket that may fall at 0.2 to 3 m/s has one such curve: aim 0,
// and any speed from 0.48 m/s, which arrives at 0.2, to 3.03.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "bankshot/scene/ball.hpp"
#include "planners/trace/residual.hpp"

namespace bankshot::planning::branch {

/// The coordinates of a launch: rad; ln of m/s; and the three spins in units of natural roll.
inline constexpr int aim = 0, log_speed = 1, top = 2, side = 3, masse = 4, coordinates = 5;
using Vector = Eigen::Matrix<double, coordinates, 1>;

Vector vector_of(const Launch& launch, const LaunchSpin& spin);
Launch launch_of(const Vector& x);
LaunchSpin spin_of(const Vector& x);

/// A number and its derivatives by the coordinates.
struct Value {
  double a = 0;
  Vector by = Vector::Zero();
};

/// A launch on a locked route, and what it does at the aim point.
struct Point {
  Vector x = Vector::Zero();
  int equations = 1;           ///< for where it passes: across the line of travel, or both coordinates where it rests
  std::array<Value, 2> off{};  ///< shares of the diagonal
  Value speed2{};  ///< m²/s² on arrival, as residual [1] counts it (trace/residual.hpp); not of a ball that rests
  Value time{};    ///< s
};

/// The coordinates that vary: the derivatives by spin cost twice as much.
enum class Vary { launch, spin_too };

/// Simulates a locked path once with dual numbers; none where the path never gets to its last leg.
std::optional<Point> look(const Branch& aim, EvaluationBudget& budget, const Vector& x, Vary vary);

}  // namespace bankshot::planning::branch
