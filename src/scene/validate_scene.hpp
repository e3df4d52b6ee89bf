// SPDX-License-Identifier: MIT
//
// The rules that a table, its balls and its physics keep, in a puzzle as in a shot. What breaks one is thrown, with the
// JSON path of where it stands.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/scene/puzzle.hpp"

namespace bankshot::validation {

[[noreturn]] void fail(const std::string& path, const std::string& reason);

/// The path of an item of a list.
std::string at(std::string_view list, std::size_t i);

void need_finite(double v, const std::string& path);

/// `what`, a centre of a ball, is on the table.
void check_inside(const Boundary& boundary, const Vec2d& p, const std::string& path, std::string_view what);

/// All but the other balls. The boundary is that of the ball.
Boundary check_scene(const Table& table, const Ball& ball, const Physics& physics);

void check_others(const Table& table, const Boundary& boundary, const Ball& struck, const std::vector<Ball>& others,
                  const Physics& physics);

}  // namespace bankshot::validation
