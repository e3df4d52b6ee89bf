// SPDX-License-Identifier: MIT
//
// Checks the rules for a table, its balls and its physics, in puzzles and shots. A violation throws InvalidInput with
// the JSON path of the offending value.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/scene/puzzle.hpp"

namespace bankshot::validation {

[[noreturn]] void fail(const std::string& path, const std::string& reason);

/// Returns the path of an item of a list.
std::string at(std::string_view list, std::size_t i);

void need_finite(double v, const std::string& path);

/// Checks that a ball with centre `p` is on the table; `what` names the point in the error message.
void check_inside(const Boundary& boundary, const Vec2d& p, const std::string& path, std::string_view what);

/// Checks everything except the other balls. Returns the boundary for the cue ball.
Boundary check_scene(const Table& table, const Ball& ball, const Physics& physics);

void check_others(const Table& table, const Boundary& boundary, const Ball& struck, const std::vector<Ball>& others,
                  const Physics& physics);

}  // namespace bankshot::validation
