// SPDX-License-Identifier: MIT
#include "support/random_puzzle.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/simulate/trajectory.hpp"

namespace bankshot::test {
namespace {

Table random_table(Random& r, Family family) {
  if (family == Family::convex) return random_polygon(r, true);
  if (family == Family::reflex) return random_polygon(r, false);
  if (family == Family::discrete) return rectangle_table(r.integer(1, 3), r.integer(1, 2));
  const double length = r.log_uniform(0.5, 6);
  return rectangle_table(length, length * r.uniform(0.4, 1));
}

Vec2d random_place(Random& r, const Boundary& b, const Table& t, Family family) {
  const Vec2d low = t.lowest(), high = t.highest();
  for (;;) {
    Vec2d p{r.uniform(low.x, high.x), r.uniform(low.y, high.y)};
    if (family == Family::discrete) {
      // Eighths of the range of the centre, its corners and edges included.
      const double R = b.body.radius;
      p = {low.x + R + (high.x - low.x - 2 * R) * r.integer(0, 8) / 8,
           low.y + R + (high.y - low.y - 2 * R) * r.integer(0, 8) / 8};
    }
    if (b.clearance(p) >= -1e-13 * b.diagonal && !b.pocket_around(p)) return p;
  }
}

Physics random_physics(Random& r, Model model, Family family, double radius) {
  if (model == Model::ideal) return ideal_physics();
  if (model == Model::spin) return spin_physics({radius});
  if (model == Model::mathavan) return {spin_physics({radius}).motion, Mathavan2010{.height = 1.28 * radius}};
  if (model == Model::tilted) {
    const double rise = r.log_uniform(1e-4, 5e-3), way = r.uniform(0, radians(360));
    Physics p = spin_physics({radius});
    p.tilt = {rise * std::cos(way), rise * std::sin(way)};
    return p;
  }
  if (model == Model::stronge) return {spin_physics({radius}).motion, Stronge{.height = 1.28 * radius}};
  if (family == Family::discrete) return {Rolling{.friction = 0.01}, Mirror{r.chance(0.5) ? 1.0 : 0.75}};
  const double friction = r.log_uniform(0.005, 0.05);
  return {Rolling{.friction = friction}, Mirror{r.uniform(0.5, 1)}};
}

}  // namespace

std::string name(Family family) {
  constexpr const char* names[] = {"uniform", "discrete", "convex", "reflex"};
  return names[static_cast<int>(family)];
}

Table random_polygon(Random& r, bool convex) {
  const int n = r.integer(3, 8);
  const double size = r.log_uniform(0.5, 4), stretch = r.uniform(0.5, 1);
  std::vector<Vec2d> v;
  for (int i = 0; i < n; ++i) {
    const double angle = radians(360) * (i + r.uniform(-0.35, 0.35)) / n;
    const double reach = size * (convex ? 1 : r.uniform(0.35, 1));
    v.push_back({reach * std::cos(angle), stretch * reach * std::sin(angle)});
  }
  return polygon_table(std::move(v));
}

Made random_puzzle(Random& r, Family family, Model model, int bounces) {
  const bool spins = model != Model::ideal && model != Model::rolling;
  for (;;) {
    ShotRequest shot;
    shot.table = random_table(r, family);
    const bool tiny = !spins && r.chance(0.2);
    shot.ball.body.radius = family == Family::discrete ? (tiny ? 0 : 0.0625) : tiny ? 0 : 0.0285;
    if (family != Family::convex && family != Family::reflex && r.chance(0.5) && shot.ball.body.radius > 0)
      shot.table.pockets = six_pockets(shot.table, {4.4 * shot.ball.body.radius, 4.8 * shot.ball.body.radius});
    const Boundary boundary(shot.table, shot.ball.body);
    // A narrow polygon may have no place for the ball.
    const Vec2d middle = (shot.table.lowest() + shot.table.highest()) / 2.0;
    if (boundary.clearance(middle) < 0) continue;
    shot.ball.at = random_place(r, boundary, shot.table, family);
    shot.physics = random_physics(r, model, family, shot.ball.body.radius);
    if (spins) shot.spin = {r.uniform(-1, 1.2), r.uniform(-1, 1), r.chance(0.2) ? r.uniform(-0.5, 0.5) : 0};
    shot.launch = {r.log_uniform(0.2, 10), radians(r.uniform(0, 360))};
    if (family == Family::discrete) shot.launch = {1.0 * r.integer(1, 4), wrap_angle(radians(15.0 * r.integer(0, 23)))};
    shot.until.cushions = std::max(bounces, most_bounces) + 1;
    const Trajectory t = simulate(shot);
    // A ball without radius that starts in a vertex must not bounce there.
    const bool in_vertex = std::ranges::find(shot.table.vertices, shot.ball.at) != shot.table.vertices.end();
    const auto at_start = [](const Record& e) { return e.kind == EventKind::cushion && e.time == 0; };
    if (shot.ball.body.radius == 0 && in_vertex && std::ranges::any_of(t.events, at_start)) continue;
    if (auto made = bounces < 0 ? ask(r, shot, t, 0, most_bounces) : ask(r, shot, t, bounces, bounces)) {
      made->puzzle.noise = {};
      return *made;
    }
  }
}

}  // namespace bankshot::test
