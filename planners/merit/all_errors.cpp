// SPDX-License-Identifier: MIT
#include "planners/merit/all_errors.hpp"

#include <cmath>
#include <vector>

#include "bankshot/scene/coefficients.hpp"
#include "planners/merit/draws.hpp"
#include "planners/merit/settings.hpp"
#include "planners/proof/replay.hpp"

namespace bankshot::planning {
namespace {

/// A draw moves the ball, but not beyond where a centre can be; one that would drop it leaves it where it stands.
void move(const Table& table, Ball& ball, const Vec2d& by) {
  const Boundary boundary(table, ball.body);
  const Vec2d at = boundary.moved_inside(ball.at + by, 2 * ball.body.radius);
  if (!boundary.pocket_around(at)) ball.at = at;
}

/// The second moves away from the first.
void keep_apart(const Ball& first, Ball& second) {
  const Vec2d between = second.at - first.at;
  const double apart = norm(between), reach = touching_distance(first.body, second.body);
  if (apart < reach && apart > 0) second.at += between * ((reach - apart) / apart);
}

/// The balls where a draw puts them; `normal`: two numbers a ball.
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

double success_under_all_errors(const SearchRequest& request, EvaluationBudget& budget, const Shot& shot) {
  const Noise& noise = request.puzzle().noise;
  const double radius = request.puzzle().ball.body.radius;
  constexpr std::size_t launch = 4;
  const std::size_t places = noise.at > 0 ? 2 * (1 + request.puzzle().others.size()) : 0;
  const DrawnPhysics physics(request.puzzle().physics);
  Draws draws(launch + places + physics.count());
  long made = 0;
  for (int i = 0; i < settings::all_errors::draws; ++i) {
    const std::vector<double>& z = draws.next();
    const Launch struck{shot.launch.speed + noise.speed_at(shot.launch.speed) * z[0],
                        wrap_angle(shot.launch.angle + noise.angle * z[1])};
    if (!(struck.speed > 0)) continue;
    LaunchSpin spin = shot.spin;
    spin.side += noise.side_of(radius) * z[2];
    spin.top += noise.top_of(radius) * z[3];
    const auto try_it = [&](const SearchRequest& own) {
      made += replay(own, budget, struck, Goal::counted(own, shot)).made;
    };
    if (places == 0 && physics.count() == 0) {
      try_it(request.spinning(spin));
      continue;
    }
    Puzzle puzzle = request.puzzle();
    if (places > 0) move_balls(puzzle, z.data() + launch);
    if (physics.count() > 0) puzzle.physics = physics.draw(z.data() + launch + places, puzzle.ball.body);
    SearchRequest own(puzzle);
    own.spin = spin;
    try_it(own);
  }
  return static_cast<double>(made) / settings::all_errors::draws;
}

}  // namespace bankshot::planning
