// SPDX-License-Identifier: MIT
#include "io/scene/read_shot.hpp"

#include <algorithm>
#include <type_traits>

#include "bankshot/numbers/angle.hpp"
#include "bankshot/scene/in_hand.hpp"
#include "bankshot/scene/settle.hpp"
#include "io/format/shot_keys.hpp"
#include "io/scene/read_physics.hpp"
#include "io/scene/read_table.hpp"

namespace bankshot {
namespace {

/// Returns whether the place of the cue ball is left to the planner.
bool is_in_hand(const Reader& at) { return !at.is_array() || (at.size() > 0 && at.items().front().is_array()); }

/// Reads where the cue ball may be placed.
InHand read_in_hand(const Reader& at, const Reader& table, const Table& shape) {
  if (at.is_string()) {
    if (at.text() != format::hand_words[0])
      at.fail(R"(is no place; it may be "anywhere", a polygon, or {"behind": "head-string"})");
    return {};
  }
  if (at.is_array()) {
    InHand polygon{InHand::Where::polygon};
    for (const Reader& vertex : at.items()) polygon.vertices.push_back(vertex.point());
    constexpr std::size_t fewest = 3;
    if (polygon.vertices.size() < fewest) at.fail("must have at least 3 vertices");
    return polygon;
  }
  at.only(format::behind);
  const Reader line = at.need("behind");
  line.word("line", format::hand_lines);
  const Reader name = table.is_object() && table.find("preset") ? table.need("preset") : table;
  InHand behind{InHand::Where::behind_head_string};
  const Vec2d low = shape.lowest(), size = shape.highest() - low;
  if (name.is_string() && name.text().starts_with("pool")) {
    const double quarter = size.x / 4;
    behind.vertices = {low, low + Vec2d{quarter, 0}, low + Vec2d{quarter, size.y}, low + Vec2d{0, size.y}};
  } else if (name.is_string() && name.text().starts_with("snooker")) {
    // The D of the World Snooker rules: a half circle of 11.5 inches on the baulk line, 29 inches from the cushion.
    constexpr double inch = 0.0254, baulk = 29 * inch, radius = 11.5 * inch;
    constexpr int corners = 48;
    for (int i = 0; i <= corners; ++i)
      behind.vertices.push_back(low + Vec2d{baulk, size.y / 2} +
                                direction(radians(90.0 + 180.0 * i / corners)) * radius);
  } else {
    line.fail("is a line of pool and snooker tables");
  }
  return behind;
}

/// Sets where the cue ball may be placed, and one such place.
void put_in_hand(const Reader& doc, Puzzle& p) {
  const Reader at = doc.need("ball").need("at");
  p.in_hand = read_in_hand(at, doc.need("table"), p.table);
  // A grid that finds a gap of half a ball.
  const std::vector<Vec2d> free = free_places(p, std::max(p.ball.body.radius, p.table.diagonal() / 500));
  if (free.empty()) at.fail("has no free place for the cue ball");
  p.ball.at = free.front();
}

/// Reads the cue ball; `ball` holds the defaults. Its place may be left out where it is in hand.
Ball read_ball(const Reader& scene, Ball ball, bool may_be_in_hand) {
  const Reader r = scene.need("ball");
  r.only(format::ball);
  const Reader at = r.need("at");
  if (!may_be_in_hand || !is_in_hand(at)) ball.at = at.point();
  r.read(format::ball["radius"], ball.body.radius);
  r.read(format::ball["mass"], ball.body.mass);
  return ball;
}

/// Reads the other balls; the cue ball's body gives the defaults.
std::vector<Ball> read_others(const Reader& scene, const Body& struck) {
  std::vector<Ball> others;
  const auto list = scene.find("others");
  if (!list) return others;
  for (const Reader& r : list->items()) {
    r.only(format::other);
    Ball& ball = others.emplace_back(Ball{r.need("at").point(), struck, std::string(r.need("id").text())});
    r.read(format::other["radius"], ball.body.radius);
    r.read(format::other["mass"], ball.body.mass);
  }
  return others;
}

LaunchSpin read_spin(const Reader& r) {
  r.only(format::launch_spin);
  LaunchSpin spin;
  r.read(format::launch_spin["top"], spin.top);
  r.read(format::launch_spin["side"], spin.side);
  r.read(format::launch_spin["masse"], spin.masse);
  return spin;
}

}  // namespace

LaunchSpin read_spin(const Reader& r, const Physics& physics, bool printed) {
  if (carries_spin(physics)) return read_spin(r);
  if (printed && r.is_object()) {
    const LaunchSpin spin = read_spin(r);
    if (spin.top == 1 && spin.side == 0 && spin.masse == 0) return {};
  }
  r.fail("needs the physics \"spin\": in \"ideal\" and \"rolling\" the ball rolls from the start");
}

std::string read_id(const Reader& doc, std::string written) {
  if (const auto r = doc.find("id"); r && !r->is_string() && !r->is_number()) r->fail("must be a string or a number");
  return written;
}

Units read_units(const Reader& doc) {
  const auto r = doc.is_object() ? doc.find("unit") : std::nullopt;
  if (!r) return {};
  constexpr double sizes[] = {1, 0.01, 0.001, 0.0254};
  const std::size_t unit = r->word("unit", format::length_units);
  if (unit < std::size(sizes)) return {sizes[unit], {sizes[unit], sizes[unit]}};
  const Reader table = doc.need("table");
  const Table shape = read_table(table, default_ball(table).body.radius);
  if (!shape.is_rectangle()) r->fail("needs a rectangular table");
  constexpr double along = 8, across = 4;
  const Vec2d size = shape.highest() - shape.lowest();
  return {1, {size.x / along, size.y / across}};
}

template <class Scene>
void read_setting(const Reader& doc, Scene& s) {
  const Reader table = doc.need("table");
  constexpr bool puzzle = std::is_same_v<Scene, Puzzle>;
  s.ball = read_ball(doc, default_ball(table), puzzle);
  s.table = read_table(table, s.ball.body.radius);
  s.others = read_others(doc, s.ball.body);
  s.physics = read_physics(doc, s.ball, s.others);
  if constexpr (puzzle)
    if (is_in_hand(doc.need("ball").need("at"))) put_in_hand(doc, s);
  const auto asked = doc.find("settle");
  // A table with too few vertices is refused later.
  if (asked && asked->boolean() && s.table.vertices.size() >= 3) s.settled = settle(s.table, s.ball, s.others);
}
template void read_setting(const Reader& doc, Puzzle& scene);
template void read_setting(const Reader& doc, ShotRequest& scene);

bool read_launch(const Reader& doc, ShotRequest& s) {
  const auto shot = doc.find("shot");
  if (shot) shot->only(format::launch);
  if (const auto own = shot ? shot->find("spin") : std::nullopt)
    s.spin = read_spin(*own, s.physics, true);
  else if (const auto of_ball = doc.need("ball").find("spin"))
    s.spin = read_spin(*of_ball, s.physics, false);
  if (shot) s.launch = {shot->need(format::launch["speed"]), wrap_angle(radians(shot->need("angle").number()))};
  return shot.has_value();
}

std::vector<Contact> read_sequence(const Reader& list, const Table& table) {
  if (list.size() > static_cast<std::size_t>(max_cushions)) list.fail("must have at most 20000 cushions");
  const std::vector<std::string_view> names(table.cushions.begin(), table.cushions.end());
  std::vector<Contact> out;
  for (const Reader& item : list.items()) {
    const auto found = find_cushion(table, item.text());
    out.push_back(found ? *found : Contact::rail(static_cast<int>(item.word("cushion", names))));
  }
  return out;
}

}  // namespace bankshot
