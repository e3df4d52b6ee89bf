// SPDX-License-Identifier: MIT
#include "bankshot/scene/settle.hpp"

#include <algorithm>
#include <cstddef>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/numbers/tolerances.hpp"

namespace bankshot {
namespace {

using Balls = std::vector<Ball*>;

double overlap(const Ball& a, const Ball& b) { return touching_distance(a.body, b.body) - norm(b.at - a.at); }

double worst_overlap(const Balls& balls) {
  double worst = 0;
  for (std::size_t i = 0; i < balls.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) worst = std::max(worst, overlap(*balls[i], *balls[j]));
  return worst;
}

/// Sweeps once over all pairs.
void push_apart(const Balls& balls, const std::vector<Boundary>& boundaries) {
  for (std::size_t i = 0; i < balls.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      Ball &a = *balls[i], &b = *balls[j];
      const double by = overlap(a, b);
      if (!(by > 0)) continue;
      const Vec2d between = b.at - a.at, half = between * (by / 2 / norm(between));
      a.at = boundaries[i].moved_inside(a.at - half, tolerance::settled_overlap);
      b.at = boundaries[j].moved_inside(b.at + half, tolerance::settled_overlap);
    }
}

}  // namespace

std::vector<Vec2d> settle(const Table& table, Ball& cue, std::vector<Ball>& others) {
  constexpr int most_sweeps = 1000;  // a tight rack of 15 balls needs about a tenth
  Balls balls{&cue};
  for (Ball& other : others) balls.push_back(&other);
  std::vector<Vec2d> moves;
  for (const Ball* ball : balls) moves.push_back(ball->at);
  const double before = worst_overlap(balls);
  const bool needed = before > tolerance::overlap && before <= tolerance::settled_overlap;
  std::vector<Boundary> boundaries;
  for (const Ball* ball : balls)
    if (needed) boundaries.emplace_back(table, ball->body);
  bool apart = !needed;
  for (int sweep = 0; sweep < most_sweeps && !apart; ++sweep) {
    push_apart(balls, boundaries);
    apart = worst_overlap(balls) <= tolerance::overlap;
  }
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const Vec2d from = moves[i];
    moves[i] = balls[i]->at - from;
    if (!apart) moves[i] = {}, balls[i]->at = from;
  }
  return moves;
}

}  // namespace bankshot
