// SPDX-License-Identifier: MIT
#include "scene/read_table.hpp"

#include "format/scene_keys.hpp"

namespace bankshot {
namespace {

const TablePreset& read_preset(const Reader& r) { return table_presets()[r.word("table", format::table_names)]; }

/// A level one is all there is yet.
void read_tilt(const Reader& table) {
  const auto r = table.find("tilt");
  if (r && !(r->point() == Vec2d{0, 0})) r->fail("other than [0, 0] is not supported yet");
}

Mouth read_mouth(const Reader& table, double radius) {
  const double scale = radius / Body{}.radius;
  Mouth m{pool_7ft_mouth.corner * scale, pool_7ft_mouth.middle * scale};
  const auto r = table.find("mouth");
  if (!r) return m;
  r->only(format::mouth);
  r->read(format::mouth["corner"], m.corner);
  r->read(format::mouth["middle"], m.middle);
  return m;
}

std::vector<Pocket> read_pockets(const Reader& table, const Table& shape, double radius) {
  const auto r = table.find("pockets");
  if (r && r->is_string() && r->word("layout of pockets", format::layouts) == 1) {
    if (!shape.is_rectangle()) r->fail("needs a rectangle; list the pockets of a polygon");
    return six_pockets(shape, read_mouth(table, radius));
  }
  if (const auto mouth = table.find("mouth"))
    mouth->fail("is the size of the pockets \"six\", which are not asked for");
  if (!r || r->is_string()) return {};
  if (!r->is_array()) r->fail("must be \"none\", \"six\" or a list of pockets");
  std::vector<Pocket> pockets;
  for (const Reader& p : r->items()) {
    p.only(format::pocket);
    const double capture = p.need("radius").number(format::pocket["radius"].bounds);
    pockets.push_back({p.need("name").text(), p.need("at").point(), capture});
  }
  return pockets;
}

Table read_polygon(const Reader& table) {
  std::vector<Vec2d> vertices;
  for (const Reader& v : table.need("vertices").items()) vertices.push_back(v.point());
  Table shape = polygon_table(std::move(vertices));
  if (const auto names = table.find("names")) {
    if (names->items().size() != shape.vertices.size())
      names->fail("must name each edge once: " + std::to_string(shape.vertices.size()) + " names");
    shape.cushions.clear();
    for (const Reader& n : names->items()) shape.cushions.push_back(n.text());
  }
  return shape;
}

}  // namespace

Ball default_ball(const Reader& table) {
  Ball ball{};
  if (!table.is_string()) return ball;
  const TablePreset& p = read_preset(table);
  ball.body = p.body;
  return ball;
}

Table read_table(const Reader& table, double radius) {
  if (table.is_string()) return make_table(read_preset(table));
  if (!table.is_object()) table.fail("must be the name of a table or an object");
  read_tilt(table);
  if (const auto jaws = table.find("jaws"); jaws && jaws->boolean()) jaws->fail("is not supported yet");
  Table shape;
  if (table.find("vertices")) {
    table.only(format::polygon);
    shape = read_polygon(table);
  } else {
    table.only(format::rectangle);
    const double length = table.need("length").number(format::rectangle["length"].bounds);
    shape = rectangle_table(length, table.need("width").number(format::rectangle["width"].bounds));
  }
  if (shape.vertices.size() >= 3) shape.pockets = read_pockets(table, shape, radius);
  return shape;
}

}  // namespace bankshot
