// SPDX-License-Identifier: MIT
#include "bankshot/scene/table.hpp"

#include <algorithm>

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

const std::vector<TablePreset>& table_presets() {
  static const std::vector<TablePreset> presets{
      {"pool-7ft", 1.9812, 0.9906, {0.028575, 0.170097}, pool_7ft_mouth},
      {"pool-8ft", 2.2352, 1.1176, {0.028575, 0.170097}, pool_7ft_mouth},
      {"pool-9ft", 2.54, 1.27, {0.028575, 0.170097}, Mouth{0.116, 0.129}},
      {"snooker-12ft", 3.569, 1.778, {0.02625, 0.1406}, Mouth{0.083, 0.087}, 0.03675},
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

Table make_table(const TablePreset& preset) {
  Table t = rectangle_table(preset.length, preset.width);
  if (preset.mouth) t.pockets = six_pockets(t, *preset.mouth);
  return t;
}

}  // namespace bankshot
