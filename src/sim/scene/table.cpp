// SPDX-License-Identifier: MIT
#include "bankshot/scene/table.hpp"

#include <algorithm>
#include <cmath>

#include "bankshot/scene/ball.hpp"

namespace bankshot {

Vec2d Table::lowest() const {
  Vec2d low = vertices.front();
  for (const Vec2d& v : vertices) low = {std::min(low.x, v.x), std::min(low.y, v.y)};
  return low;
}

Vec2d Table::highest() const {
  Vec2d high = vertices.front();
  for (const Vec2d& v : vertices) high = {std::max(high.x, v.x), std::max(high.y, v.y)};
  return high;
}

double Table::diagonal() const { return norm(highest() - lowest()); }

bool Table::is_rectangle() const {
  if (vertices.size() != 4) return false;
  const Vec2d a = vertices[0], c = vertices[2];
  return vertices[1] == Vec2d{c.x, a.y} && vertices[3] == Vec2d{a.x, c.y} && a.x < c.x && a.y < c.y;
}

Table polygon_table(std::vector<Vec2d> vertices) {
  Table t{std::move(vertices), {}, {}};
  for (std::size_t i = 0; i < t.vertices.size(); ++i) t.cushions.push_back("c" + std::to_string(i));
  return t;
}

Table rectangle_table(double length, double width) {
  return {{{0, 0}, {length, 0}, {length, width}, {0, width}}, {"bottom", "right", "top", "left"}, {}};
}

std::vector<Pocket> six_pockets(const Table& rectangle, Mouth mouth) {
  const auto [x0, y0] = rectangle.lowest();
  const auto [x1, y1] = rectangle.highest();
  const double middle = x0 + (x1 - x0) / 2, corner = mouth.corner / 2, side = mouth.middle / 2;
  return {{"bottom-left", {x0, y0}, corner}, {"bottom-middle", {middle, y0}, side}, {"bottom-right", {x1, y0}, corner},
          {"top-left", {x0, y1}, corner},    {"top-middle", {middle, y1}, side},    {"top-right", {x1, y1}, corner}};
}

std::vector<Pocket> six_pockets_with_jaws(const Table& rectangle, const JawShapes& jaws) {
  std::vector<Pocket> pockets = six_pockets(rectangle, Mouth{jaws.corner.mouth, jaws.middle.mouth});
  const Vec2d centre = (rectangle.lowest() + rectangle.highest()) / 2;
  for (std::size_t i = 0; i < pockets.size(); ++i) {
    Pocket& p = pockets[i];
    const bool middle = i % 3 == 1;
    const JawShape& shape = middle ? jaws.middle : jaws.corner;
    const auto sign = [](double x) { return x > 0 ? 1.0 : -1.0; };
    const Vec2d out = p.at - centre,
                back = middle ? Vec2d{0, sign(out.y)} : Vec2d{sign(out.x), sign(out.y)} / std::sqrt(2.0);
    p.jaws = Jaws{p.at, shape.mouth, shape.angle, shape.tip, jaws.depth};
    p.at += back * shape.set_back;
    p.radius = shape.capture;
  }
  return pockets;
}

const JawShapes pool_7ft_jaws{
    {0.118, radians(142), 0.021, 0.062, 0.0417}, {0.137, radians(104), 0.008, 0.0645, 0.0685}, 0.0508};

JawShapes with_mouth(JawShapes jaws, Mouth mouth) {
  jaws.corner.mouth = mouth.corner;
  jaws.middle.mouth = mouth.middle;
  return jaws;
}

Mouth scaled(Mouth mouth, double by) { return {mouth.corner * by, mouth.middle * by}; }

JawShapes scaled(const JawShapes& jaws, double by) {
  const auto shape = [&](const JawShape& s) {
    return JawShape{s.mouth * by, s.angle, s.tip * by, s.capture * by, s.set_back * by};
  };
  return {shape(jaws.corner), shape(jaws.middle), jaws.depth * by};
}

namespace {

const JawShapes snooker_jaws{
    {0.083, radians(135), 0.0889, 0.0889, 0.06735}, {0.087, radians(90), 0.0669, 0.05319, 0.05159}, 0.04763};

}  // namespace

const std::vector<TablePreset>& table_presets() {
  constexpr Mouth pool_9ft{0.116, 0.129}, snooker{0.083, 0.087};
  static const std::vector<TablePreset> presets{
      {"pool-7ft", 1.9812, 0.9906, {0.028575, 0.170097}, pool_7ft_mouth, {}, pool_7ft_jaws},
      {"pool-8ft", 2.2352, 1.1176, {0.028575, 0.170097}, pool_7ft_mouth, {}, pool_7ft_jaws},
      {"pool-9ft", 2.54, 1.27, {0.028575, 0.170097}, pool_9ft, {}, with_mouth(pool_7ft_jaws, pool_9ft)},
      {"snooker-12ft", 3.569, 1.778, {0.02625, 0.1406}, snooker, 0.03675, snooker_jaws},
      {"carom-10ft", 2.84, 1.42, {0.03075, 0.21}, {}, 0.037},
      {"seed", 2.5, 1.25, {0.0285, 0.17}, {}},
  };
  return presets;
}

const TablePreset* find_table_preset(std::string_view name) {
  const auto& all = table_presets();
  const auto it = std::find_if(all.begin(), all.end(), [&](const auto& p) { return p.name == name; });
  return it == all.end() ? nullptr : &*it;
}

PocketView view(const Table& table, const Pocket& pocket) {
  std::vector<Vec2d> outs;
  for (std::size_t i = 0, n = table.vertices.size(); i < n; ++i) {
    const Vec2d from = table.vertices[i], along = table.vertices[(i + 1) % n] - from, u = along / norm(along);
    const Vec2d to = pocket.place() - from, out = -perpendicular(u);
    const double s = dot(to, u), half = pocket.half();
    if (std::abs(dot(to, out)) < half && s > -half && s < norm(along) + half) outs.push_back(out);
  }
  Vec2d sum{};
  for (const Vec2d& out : outs) sum += out;
  if (!(norm(sum) > 0)) return {{}, 0};
  PocketView seen{sum / norm(sum), radians(90)};
  for (const Vec2d& out : outs)
    seen.half_view = std::min(seen.half_view, radians(90) - std::acos(std::min(1.0, dot(seen.out, out))));
  return seen;
}

Table make_table(const TablePreset& preset, bool jaws) {
  Table t = rectangle_table(preset.length, preset.width);
  if (preset.mouth)
    t.pockets = jaws && preset.jaws ? six_pockets_with_jaws(t, *preset.jaws) : six_pockets(t, *preset.mouth);
  return t;
}

}  // namespace bankshot
