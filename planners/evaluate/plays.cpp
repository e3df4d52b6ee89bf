// SPDX-License-Identifier: MIT
#include "planners/evaluate/plays.hpp"

#include <cmath>
#include <vector>

#include "bankshot/scene/coefficients.hpp"
#include "planners/evaluate/draws.hpp"

namespace bankshot::planning {
namespace {

/// Moves a ball, but not beyond where a centre can be. A move that would drop it leaves it where it stands.
void move(const Table& table, Ball& ball, const Vec2d& by) {
  const Boundary boundary(table, ball.body);
  const Vec2d at = boundary.moved_inside(ball.at + by, 2 * ball.body.radius);
  if (!boundary.pocket_around(at)) ball.at = at;
}

/// Moves the second ball away from the first, until they touch, if they overlap.
void keep_apart(const Ball& first, Ball& second) {
  const Vec2d between = second.at - first.at;
  const double apart = norm(between), reach = touching_distance(first.body, second.body);
  if (apart < reach && apart > 0) second.at += between * ((reach - apart) / apart);
}

/// Moves the balls to where a draw puts them; `normal`: two numbers a ball.
void move_balls(Puzzle& p, const double* normal) {
  const auto draw = [&](Ball& ball) {
    move(p.table, ball, Vec2d{normal[0], normal[1]} * p.noise.at);
    normal += 2;
  };
  draw(p.ball);
  for (Ball& ball : p.others) draw(ball);
  for (std::size_t i = 0; i < p.others.size(); ++i) {
    keep_apart(p.ball, p.others[i]);
    for (std::size_t j = 0; j < i; ++j) keep_apart(p.others[j], p.others[i]);
  }
}

}  // namespace

void each_play(const SearchRequest& request, const Launch& launch, int count, const Play& play, int skipped) {
  const Noise& noise = request.puzzle().noise;
  const double radius = request.puzzle().ball.body.radius;
  constexpr std::size_t of_launch = 4;
  const std::size_t places = noise.at > 0 ? 2 * (1 + request.puzzle().others.size()) : 0;
  const DrawnPhysics physics(request.puzzle().physics);
  Draws draws(of_launch + places + physics.count());
  for (int i = 0; i < skipped; ++i) draws.next();
  for (int i = 0; i < count; ++i) {
    const std::vector<double>& z = draws.next();
    const Launch struck{launch.speed + noise.speed_at(launch.speed) * z[0],
                        wrap_angle(launch.angle + noise.angle * z[1])};
    if (!(struck.speed > 0)) continue;
    LaunchSpin spin = request.spin;
    spin.side += noise.side_of(radius) * z[2];
    spin.top += noise.top_of(radius) * z[3];
    if (places == 0 && physics.count() == 0) {
      if (!play(request.spinning(spin), struck)) return;
      continue;
    }
    Puzzle puzzle = request.puzzle();
    if (places > 0) move_balls(puzzle, z.data() + of_launch);
    if (physics.count() > 0) puzzle.physics = physics.draw(z.data() + of_launch + places, puzzle.ball.body);
    SearchRequest own(puzzle);
    own.spin = spin;
    if (!play(own, struck)) return;
  }
}

}  // namespace bankshot::planning
