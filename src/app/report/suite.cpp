// SPDX-License-Identifier: MIT
#include "app/report/suite.hpp"
#include "bankshot/plan/generate.hpp"

#include <cmath>

#include "bankshot/simulate/trajectory.hpp"

namespace bankshot::app::report {
namespace {

constexpr double length = 2.54, width = 1.27, radius = 0.028575;

int cushions_of(Level level, int i) {
  if (level == Level::medium) return 3;
  return (level == Level::easy ? 1 : 4) + i / 2 % 2;
}

/// Draws a shot that ends after exactly so many cushions.
ShotRequest shot_with(Random& draw, const Physics& physics, int cushions) {
  for (;;) {
    ShotRequest shot{.table = rectangle_table(length, width), .physics = physics};
    shot.ball.at = {draw.uniform(radius, length - radius), draw.uniform(radius, width - radius)};
    shot.launch = {draw.log_uniform(0.5, 8), draw.uniform(0, radians(360))};
    if (is_ideal(physics)) {
      shot.launch.speed = 1;
      shot.until.length = draw.uniform(0.5, 8);
    }
    if (bankshot::simulate(shot).cushions == cushions) return shot;
  }
}

}  // namespace

const char* name(Level level) {
  constexpr const char* names[] = {"easy", "medium", "hard"};
  return names[static_cast<int>(level)];
}

std::vector<Puzzle> suite(const Physics& physics, Level level, int count) {
  Random draw(7 + static_cast<std::uint64_t>(level));
  std::vector<Puzzle> out;
  for (int i = 0; i < count; ++i) {
    const int cushions = cushions_of(level, i);
    const ShotRequest shot = shot_with(draw, physics, cushions);
    const Trajectory t = bankshot::simulate(shot);
    Puzzle p{.table = shot.table,
             .physics = physics,
             .ball = shot.ball,
             .target = PointTarget{t.events.back().state.at},
             .cushions = i % 2 == 0 ? CushionRule::in_order(t.sequence()) : CushionRule::exactly(cushions),
             .prefer = Prefer::soft};
    if (!is_ideal(physics)) p.arrive = Range{0, 0};
    out.push_back(p);
  }
  return out;
}

}  // namespace bankshot::app::report
