// SPDX-License-Identifier: MIT
#include "planners/search.hpp"

#include <algorithm>

#include "bankshot/numbers/tolerances.hpp"

namespace bankshot::planning {

namespace {

Physics roughly(Physics p) {
  if (auto* m = std::get_if<Mathavan2010>(&p.cushion)) m->tolerance = std::max(m->tolerance, tolerance::rough_impact);
  return p;
}

}  // namespace

Search::Search(const Puzzle& p, bool find_all, bool find_first)
    : puzzle(p),
      boundary(p.table, p.ball.radius),
      rough(roughly(p.physics)),
      all(find_all),
      first(find_first),
      arrival(arrival_range(p)),
      stop(point() && arrival && arrival->high == 0) {
  if (arrival) asked = p.prefer == Prefer::soft ? arrival->low : arrival->high;
  if (const PointTarget* t = point()) {
    aim_points_ = {t->at};
    return;
  }
  for (const Circle& pocket : boundary.pockets)
    if (wanted(pocket.contact)) aim_points_.push_back(pocket.centre);
}

double Search::reach(const Vec2d& aim_point) const {
  if (const PointTarget* t = point()) return t->within;
  for (const Circle& pocket : boundary.pockets)
    if (pocket.centre == aim_point) return pocket.radius;
  return 0;
}

const Vec2d& Search::nearest_aim_point(const Vec2d& arrived) const {
  const auto nearer = [&](const Vec2d& a, const Vec2d& b) { return norm(a - arrived) < norm(b - arrived); };
  return *std::min_element(aim_points_.begin(), aim_points_.end(), nearer);
}

double Search::nearest_reach(const Vec2d& arrived) const { return reach(nearest_aim_point(arrived)); }

void Search::remember(const NearMiss& m) {
  if (m.miss < near.miss) near = m;
  for (Counted& c : failures) {
    if (!c.failure.like(m.failure)) continue;
    ++c.times;
    if (m.failure.foul == Foul::too_fast) c.failure.speed = std::min(c.failure.speed, m.failure.speed);
    if (m.failure.foul == Foul::too_slow) c.failure.speed = std::max(c.failure.speed, m.failure.speed);
    return;
  }
  failures.push_back({m.failure, 1});
}

bool Search::touches(int contact) const {
  const double slack = boundary.touch;
  const auto walls = static_cast<int>(boundary.walls.size());
  if (contact < walls) {
    const Wall& w = boundary.walls[static_cast<std::size_t>(contact)];
    const double s = dot(w.along, puzzle.ball.at);
    return dot(w.normal, puzzle.ball.at) - w.offset <= slack && s >= w.begin - slack && s <= w.end + slack;
  }
  for (const Circle& tip : boundary.tips)
    if (tip.contact == contact) return norm(puzzle.ball.at - tip.centre) - tip.radius <= slack;
  return false;
}

bool Search::centred(double miss) const { return miss <= tolerance::exact_miss * boundary.diagonal; }

bool Search::frozen() const {
  const auto contacts = 2 * static_cast<int>(boundary.walls.size());
  for (int i = 0; i < contacts; ++i)
    if (touches(i)) return true;
  return false;
}

bool Search::into_touched_wall(const Vec2d& direction) const {
  for (std::size_t i = 0; i < boundary.walls.size(); ++i)
    if (dot(boundary.walls[i].normal, direction) < 0 && touches(static_cast<int>(i))) return true;
  for (const Circle& tip : boundary.tips)
    if (dot(puzzle.ball.at - tip.centre, direction) < 0 && touches(tip.contact)) return true;
  return false;
}

}  // namespace bankshot::planning
