// SPDX-License-Identifier: MIT
#include "io/scene/read_table.hpp"

#include <algorithm>

#include "io/format/scene_keys.hpp"
#include "io/scene/read_physics.hpp"

namespace bankshot {
namespace {

/// Reads the own coefficients of each cushion.
std::vector<RailCushion> read_own_cushions(const Reader& table, const Table& shape) {
  const auto r = table.find("cushions");
  if (!r) return {};
  const std::vector<std::string_view> names(shape.cushions.begin(), shape.cushions.end());
  std::vector<RailCushion> own(names.size());
  for (const auto& [name, rail] : r->members()) {
    const auto found = std::ranges::find(names, name);
    if (found == names.end()) rail.fail("is no cushion of this table" + known_words(name, names));
    rail.only(format::own_cushion);
    RailCushion& cushion = own[static_cast<std::size_t>(found - names.begin())];
    if (const auto v = rail.find("restitution")) cushion.restitution = read_restitution(*v);
    if (const auto v = rail.find("friction")) cushion.friction = v->number(format::own_cushion["friction"].bounds);
  }
  return own;
}

Mouth read_mouth(const Reader& table, Mouth m) {
  const auto r = table.find("mouth");
  if (!r) return m;
  r->only(format::mouth);
  r->read(format::mouth["corner"], m.corner);
  r->read(format::mouth["middle"], m.middle);
  return m;
}

bool wants_jaws(const Reader& table, bool usual) {
  const auto r = table.find("jaws");
  return r ? r->boolean() : usual;
}

/// Reads a preset with changes.
Table changed(const Reader& table, const TablePreset& preset) {
  table.only(format::preset);
  const bool jaws = wants_jaws(table, preset.mouth.has_value());
  if (!preset.mouth) {
    if (jaws) table.find("jaws")->fail("needs pockets, and this table has none");
    if (const auto mouth = table.find("mouth")) mouth->fail("is the size of pockets, and this table has none");
    return make_table(preset);
  }
  TablePreset own = preset;
  own.mouth = read_mouth(table, *preset.mouth);
  own.jaws = with_mouth(*preset.jaws, *own.mouth);
  return make_table(own, jaws);
}

std::vector<Pocket> read_pockets(const Reader& table, const Table& shape, double radius) {
  const auto r = table.find("pockets");
  if (r && r->is_string() && r->word("layout of pockets", format::layouts) == 1) {
    if (!shape.is_rectangle()) r->fail("needs a rectangle; list the pockets of a polygon");
    const double scale = radius / Body{}.radius;
    const Mouth mouth = read_mouth(table, scaled(pool_7ft_mouth, scale));
    if (!wants_jaws(table, false)) return six_pockets(shape, mouth);
    return six_pockets_with_jaws(shape, with_mouth(scaled(pool_7ft_jaws, scale), mouth));
  }
  if (wants_jaws(table, false)) table.find("jaws")->fail("needs the pockets \"six\", or a preset");
  if (const auto mouth = table.find("mouth"))
    mouth->fail("is the size of the pockets \"six\", which are not asked for");
  if (!r || r->is_string()) return {};
  if (!r->is_array()) r->fail("must be \"none\", \"six\" or a list of pockets");
  std::vector<Pocket> pockets;
  for (const Reader& p : r->items()) {
    p.only(format::pocket);
    const double capture = p.need(format::pocket["radius"]);
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

const TablePreset* preset_of(const Reader& table) {
  if (table.is_string()) return &table_presets()[table.word("table", format::table_names)];
  const auto r = table.is_object() ? table.find("preset") : std::nullopt;
  return r ? &table_presets()[r->word("table", format::table_names)] : nullptr;
}

Ball default_ball(const Reader& table) {
  Ball ball{};
  if (const TablePreset* const p = preset_of(table)) ball.body = p->body;
  return ball;
}

Table read_table(const Reader& table, double radius) {
  const TablePreset* const preset = preset_of(table);
  if (table.is_string()) return make_table(*preset);
  if (!table.is_object()) table.fail("must be the name of a table or an object");
  if (preset) {
    Table shape = changed(table, *preset);
    shape.own = read_own_cushions(table, shape);
    return shape;
  }
  Table shape;
  if (table.find("vertices")) {
    table.only(format::polygon);
    shape = read_polygon(table);
  } else {
    table.only(format::rectangle);
    const double length = table.need(format::rectangle["length"]);
    shape = rectangle_table(length, table.need(format::rectangle["width"]));
  }
  if (shape.vertices.size() >= 3) shape.pockets = read_pockets(table, shape, radius);
  shape.own = read_own_cushions(table, shape);
  return shape;
}

}  // namespace bankshot
