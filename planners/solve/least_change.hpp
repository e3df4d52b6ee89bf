// SPDX-License-Identifier: MIT
//
// Newton's method of least change on a branch, inside bounds: of all launches that solve its equations the nearest.
// How many coordinates are free makes no difference. Sizes and lengths are in the scales of the coordinates.
// Cost: one locked simulation a step, five steps from a launch nearby. Guarantee: none; a replay verifies the launch.
// Source: Allgower & Georg, Introduction to Numerical Continuation Methods, SIAM 2003, eq. 3.2.2.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "planners/search_request.hpp"
#include "planners/solve/point.hpp"

namespace bankshot::planning::branch {

/// Bounds on the coordinates of a launch.
struct Box {
  Vector low, high;
  bool free(int i) const { return low[i] < high[i]; }
};

/// Returns the request's bounds; a fixed spin has equal ends.
Box box_of(const SearchRequest& request);
/// Returns the coordinates that are free, in order.
std::vector<int> free_of(const Box& box);
/// Returns the aim, turned by whole turns to where it is nearest to the middle of its bounds [rad].
double near_window(double angle, const std::optional<Range>& window);

/// Numbers that must be 0 at a launch: at most two for where it passes, and one for its speed.
struct Equations {
  std::array<Value, 3> each{};
  std::size_t count = 0;
  void add(const Value& v) { each[count++] = v; }
  std::span<const Value> all() const& { return std::span(each).first(count); }
  std::span<const Value> all() const&& = delete;
};

/// Returns the equations for where a point passes.
Equations passes(const Point& p);
/// Returns the equation of the arrival speed: its square less the square asked, over the larger of that and 1 m²/s².
Value speed_off(const Point& p, double square);

/// Changes over which a locked path bends little.
const Vector& scales();
/// Returns the largest part of a step.
double size_of(const Vector& step);
/// Cuts a step to the longest.
Vector cut(const Vector& step);

/// Returns the least step that brings `kept` to 0, and `wanted` as near to 0 as what they leave free can. A coordinate
/// that would leave the box stays at its bound. It is not finite where a number of the equations is not.
Vector least_step(std::span<const Value> kept, std::span<const Value> wanted, const Box& box, const Vector& x);

/// Returns the launch inside the box near `x` at which the equations are 0; none where such steps come no nearer.
/// `equations_at`: none where the branch does not exist. `tolerance`: size of the last step; the error left is about
/// its square.
std::optional<Vector> least_change(Vector x, const Box& box, double tolerance,
                                   const std::function<std::optional<Equations>(const Vector&)>& equations_at);

}  // namespace bankshot::planning::branch
