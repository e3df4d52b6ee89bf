// SPDX-License-Identifier: MIT
#include "support/family_makers.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "bankshot/geometry/boundary.hpp"
#include "support/forward.hpp"

namespace bankshot::test::make {
namespace {

/// Moves the shot to another table, to a random place there.
std::optional<ShotRequest> moved_to(Random& r, ShotRequest shot, Table table) {
  shot.table = std::move(table);
  const auto at = random_place(r, Boundary(shot.table, shot.ball.body), shot.table);
  if (!at) return {};
  shot.ball.at = *at;
  return shot;
}

Table triangle(Random& r) {
  const double least = radians(12), a = r.log_uniform(least, radians(150)), b = r.log_uniform(least, radians(150));
  const double c = radians(180) - a - b, size = r.log_uniform(0.5, 4);
  if (c < least) return triangle(r);
  const double reach = size * std::sin(b) / std::sin(c);
  return polygon_table({{0, 0}, {size, 0}, {reach * std::cos(a), reach * std::sin(a)}});
}

Table l_shape(Random& r) {
  const double a = r.uniform(1, 3), b = r.uniform(1, 3), c = a * r.uniform(0.3, 0.7), d = b * r.uniform(0.3, 0.7);
  return polygon_table({{0, 0}, {a, 0}, {a, d}, {c, d}, {c, b}, {0, b}});
}

Table u_shape(Random& r) {
  const double a = r.uniform(1.5, 3), b = r.uniform(1, 2), left = a * r.uniform(0.2, 0.4),
               right = a * r.uniform(0.6, 0.8), floor = b * r.uniform(0.25, 0.7);
  return polygon_table({{0, 0}, {a, 0}, {a, b}, {right, b}, {right, floor}, {left, floor}, {left, b}, {0, b}});
}

Table star(Random& r) {
  const int tips = r.integer(3, 6);
  const double size = r.uniform(1, 2), waist = size * r.uniform(0.35, 0.6);
  std::vector<Vec2d> v;
  for (int i = 0; i < 2 * tips; ++i) {
    const double reach = i % 2 ? waist : size, angle = radians(180) * i / tips;
    v.push_back({reach * std::cos(angle), reach * std::sin(angle)});
  }
  return polygon_table(std::move(v));
}

/// Draws a speed after Froude's law: on a table n times as long the same shot is played at √n times the speed.
double usual_speed(Random& r, double length) { return std::sqrt(length) * r.log_uniform(0.2, 5); }

}  // namespace

Made slender(Random& r, Model model, int bounces) {
  return ask_for_some(r, bounces, [&] {
    const double length = r.log_uniform(1, 5);
    Table table = rectangle_table(length, length / 10);
    ShotRequest shot = usual_shot(r, model);
    if (r.chance(0.2)) table.pockets = six_pockets(table, pool_7ft_mouth);
    return moved_to(r, shot, table);
  });
}

Made sizes(Random& r, Model model, int bounces) {
  double diagonal = 1;
  Made m = ask_for_some(r, bounces, [&] {
    const double length = r.log_uniform(2e-3, 1e3), width = length * r.uniform(0.4, 1);
    Table table = rectangle_table(length, width);
    diagonal = table.diagonal();
    if (r.chance(0.4)) {
      const auto far = [&] { return r.log_uniform(1, 1e4) * (r.chance(0.5) ? 1 : -1); };
      const Vec2d by{far(), far()};
      for (Vec2d& v : table.vertices) v += by;
    }
    ShotRequest shot = usual_shot(r, model);
    shot.ball.body.radius = diagonal * r.uniform(0.005, 0.04);
    shot.physics = usual_physics(model, shot.ball.body);
    shot.launch.speed = usual_speed(r, length);
    return moved_to(r, shot, table);
  });
  if (auto* point = std::get_if<PointTarget>(&m.puzzle.target)) point->within = 0.003 * diagonal;
  return m;
}

Made triangles(Random& r, Model model, int bounces) {
  return ask_for_some(r, bounces, [&] { return moved_to(r, usual_shot(r, model), triangle(r)); });
}

Made shapes(Random& r, Model model, int bounces) {
  return ask_for_some(r, bounces, [&] {
    const int kind = r.integer(0, 2);
    return moved_to(r, usual_shot(r, model), kind == 0 ? l_shape(r) : kind == 1 ? u_shape(r) : star(r));
  });
}

Made edge_pockets(Random& r, Model model, int bounces) {
  return ask_for_some(r, bounces, [&] {
    Table table = random_polygon(r, r.chance(0.7));
    const std::size_t edges = table.vertices.size();
    for (std::size_t i = 0; i < edges; ++i) {
      if (r.chance(0.5)) continue;
      const Vec2d from = table.vertices[i], to = table.vertices[(i + 1) % edges];
      table.pockets.push_back(
          {"p" + std::to_string(i), from + (to - from) * r.uniform(0.1, 0.9), 0.028575 * r.uniform(1.2, 2.5)});
    }
    return moved_to(r, usual_shot(r, model), table);
  });
}

Made extremes(Random& r, Model model, int bounces) {
  return ask_for_some(r, bounces, [&] {
    ShotRequest shot = usual_shot(r, model);
    const Restitution restitution{r.chance(0.2) ? 1 : r.uniform(0.3, 1)};
    const double friction = r.chance(0.2) ? 0 : r.chance(0.2) ? 5 : r.uniform(0.05, 1);
    const double height = shot.ball.body.radius * (r.chance(0.2) ? 1.02 : r.chance(0.2) ? 1.6 : r.uniform(1.02, 1.6));
    if (auto* mirror = std::get_if<Mirror>(&shot.physics.cushion); mirror && !is_ideal(shot.physics))
      mirror->restitution = restitution;
    if (auto* han = std::get_if<Han2005>(&shot.physics.cushion)) *han = {height, restitution, friction};
    if (auto* mathavan = std::get_if<Mathavan2010>(&shot.physics.cushion)) {
      mathavan->height = height;
      mathavan->restitution = restitution;
      mathavan->friction = friction;
    }
    if (has_spin(model)) do
        shot.spin = {r.uniform(-2.4, 1.5), r.uniform(-1.2, 1.2), r.chance(0.5) ? r.uniform(-2, 2) : 0};
      while (std::hypot(shot.spin.top, shot.spin.side) >= 2.5);  // the tip would miss the ball
    return std::optional(shot);
  });
}

Made many_cushions(Random& r, Model model, int bounces) {
  const int n = bounces < 0 ? r.integer(6, 12) : bounces;
  return ask_for_some(r, n, [&] {
    ShotRequest shot = usual_shot(r, model);
    shot.table.pockets.clear();
    shot.launch.speed = r.log_uniform(3, 10) * std::sqrt(shot.table.diagonal() / 2);
    return std::optional(shot);
  });
}

Made fast(Random& r, Model model, int bounces) {
  return ask_for_some(r, bounces, [&] {
    ShotRequest shot = usual_shot(r, model);
    shot.launch.speed = r.log_uniform(10, 30);
    return std::optional(shot);
  });
}

}  // namespace bankshot::test::make
