// SPDX-License-Identifier: MIT
//
// The rest of the cue ball along a given branch, with derivatives, and the launch that reaches the target and
// leaves the cue ball at a given place: two branches from one launch, that of the target and that of the cue ball.
// Unknowns are the coordinates of a branch (solve/point.hpp). Method: the equations of the target are kept; what they
// leave free brings the rest nearer by least change (solve/least_change.hpp). Where too little is free, the result is
// the nearest rest: Gauss and Newton's method.
// Cost: two locked simulations a step, five steps from a launch nearby. Guarantee: none; a replay verifies the launch.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "planners/solve/least_change.hpp"

namespace bankshot::planning::play {

using branch::Value;
using branch::Vector;

/// The cue ball's part of a shot.
struct CuePath {
  Route meetings;  ///< of the cue ball alone, up to its rest
  std::span<const StandingBall> standing;
};

/// Returns the place in which the cue ball comes to rest [m]; none where it does not follow these meetings.
std::optional<std::array<Value, 2>> rest_of(const SearchRequest& request, EvaluationBudget& budget, const CuePath& cue,
                                            const Vector& x, branch::Vary vary);

/// Returns the equations of a target at a point of its branch: that it is passed at the offset `shift` [m] from the
/// exact line, or where it rests; and the arrival speed, if only one will do.
branch::Equations equations_of(const Branch& aim, const branch::Point& point, double shift);

/// Returns the launch near `x` that reaches its target, `shift` metres beside the exact line, and rests at `wanted`, or
/// as near to it as it can.
std::optional<Vector> place(const Branch& aim, EvaluationBudget& budget, const CuePath& cue, const Vec2d& wanted,
                            const branch::Box& box, Vector x, double shift, branch::Vary vary);

/// Returns the launch beside `x` that reaches its target, by a change of the aim, and of the speed if the target has
/// two equations.
std::optional<Vector> on_target(const Branch& aim, EvaluationBudget& budget, const branch::Box& box, const Vector& x,
                                double shift);

}  // namespace bankshot::planning::play
