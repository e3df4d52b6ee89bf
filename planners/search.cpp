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
      boundary(p.table, p.ball.body),
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
    if (wanted(pocket.contact.index)) aim_points_.push_back(pocket.centre);
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

bool Search::touches(Contact contact) const {
  const double slack = boundary.touch;
  if (const Wall* const w = boundary.line(contact)) {
    const double s = dot(w->along, puzzle.ball.at);
    return dot(w->normal, puzzle.ball.at) - w->offset <= slack && s >= w->begin - slack && s <= w->end + slack;
  }
  const Circle* const rim = boundary.rim(contact);
  return rim && norm(puzzle.ball.at - rim->centre) - rim->radius <= slack;
}

bool Search::centred(double miss) const { return miss <= tolerance::exact_miss * boundary.diagonal; }

bool Search::frozen() const {
  const auto touched = [&](const auto& obstacle) { return touches(obstacle.contact); };
  return std::ranges::any_of(boundary.walls, touched) || std::ranges::any_of(boundary.tips, touched);
}

bool Search::into_touched_wall(const Vec2d& direction) const {
  for (const Wall& w : boundary.walls)
    if (dot(w.normal, direction) < 0 && touches(w.contact)) return true;
  for (const Circle& tip : boundary.tips)
    if (dot(puzzle.ball.at - tip.centre, direction) < 0 && touches(tip.contact)) return true;
  return false;
}

}  // namespace bankshot::planning
