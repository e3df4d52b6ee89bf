// SPDX-License-Identifier: MIT
#include "bankshot/scene/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "bankshot/geometry/boundary.hpp"
#include "json/reader.hpp"
#include "scene/read_table.hpp"

namespace bankshot {
namespace {

Ball read_ball(const Reader& scene, Ball ball) {
  const Reader r = scene.need("ball");
  r.only({"at", "radius", "mass", "spin"});
  ball.at = r.need("at").point();
  if (const auto v = r.find("radius")) ball.body.radius = v->at_least(0);
  if (const auto v = r.find("mass")) ball.body.mass = v->positive();
  return ball;
}

LaunchSpin read_spin(const Reader& r) {
  r.only({"top", "side", "masse"});
  LaunchSpin spin;
  const auto read = [&](const char* key, double& value) {
    if (const auto v = r.find(key)) value = v->number();
  };
  read("top", spin.top);
  read("side", spin.side);
  read("masse", spin.masse);
  return spin;
}

/// None when every spin is one number.
std::optional<SpinRange> read_spin_range(const Reader& r) {
  r.only({"top", "side", "masse"});
  SpinRange range;
  bool any = false;
  const auto read = [&](const char* key, Range& value) {
    const auto v = r.find(key);
    if (!v) return;
    value = v->range();
    any = any || v->is_array();
  };
  read("top", range.top);
  read("side", range.side);
  read("masse", range.masse);
  return any ? std::optional(range) : std::nullopt;
}

/// `printed`: answers print the natural roll that every shot has without the physics `spin`.
LaunchSpin read_spin(const Reader& r, const Physics& physics, bool printed) {
  if (!is_straight(physics)) return read_spin(r);
  if (printed && r.is_object()) {
    const LaunchSpin spin = read_spin(r);
    if (spin.top == 1 && spin.side == 0 && spin.masse == 0) return {};
  }
  r.fail("needs the physics \"spin\": in \"ideal\" and \"rolling\" the ball rolls from the start");
}

Restitution read_restitution(const Reader& r) {
  if (!r.is_object()) return r.between(0, 1);
  r.only({"at_rest", "per_speed"});
  return {r.need("at_rest").between(0, 1), r.need("per_speed").number()};
}

RollingFriction read_rolling_friction(const Reader& r) {
  if (!r.is_object()) return r.at_least(0);
  r.only({"at_rest", "per_speed"});
  const RollingFriction f{r.need("at_rest").at_least(0), r.need("per_speed").at_least(0)};
  if (f.per_speed > 0 && f.at_rest == 0)
    r.need("at_rest").fail("must be greater than 0 where per_speed is: else the ball never comes to rest");
  return f;
}

/// `sliding_friction` of the cloth acts in mathavan2010 also during the impact.
decltype(Physics::cushion) read_cushion(const Reader& r, Han2005 han, double sliding_friction) {
  constexpr std::array<std::string_view, 3> models{"han2005", "mathavan2010", "mirror"};
  r.only({"model", "restitution", "friction", "height"});
  std::size_t which = 0;
  if (const auto v = r.find("model")) which = v->word("cushion model", models);
  if (const auto v = r.find("restitution")) han.restitution = read_restitution(*v);
  if (const auto v = r.find("friction")) han.friction = v->at_least(0);
  if (const auto v = r.find("height")) han.height = v->number();
  if (which == 2) return Mirror{han.restitution};
  if (which == 1)
    return Mathavan2010{.height = han.height,
                        .restitution = han.restitution,
                        .friction = han.friction,
                        .sliding_friction = sliding_friction};
  return han;
}

Physics read_spin_physics(const Reader* r, const Reader& table, const Body& body) {
  const TablePreset* preset = table.is_string() ? find_table_preset(table.text()) : nullptr;
  Physics p = spin_physics(body, preset ? std::optional(preset->nose()) : std::nullopt);
  SlideRoll& motion = std::get<SlideRoll>(p.motion);
  Han2005& cushion = std::get<Han2005>(p.cushion);
  if (!r) return p;
  r->only({"model", "sliding_friction", "rolling_friction", "spinning_friction", "cushion", "ball_ball", "g"});
  if (const auto v = r->find("ball_ball")) v->fail("is not supported yet");
  if (const auto v = r->find("sliding_friction")) motion.sliding_friction = v->at_least(0);
  if (const auto v = r->find("rolling_friction")) motion.rolling_friction = read_rolling_friction(*v);
  if (const auto v = r->find("spinning_friction")) motion.spinning_friction = v->at_least(0);
  if (const auto v = r->find("g")) motion.g = v->positive();
  if (const auto v = r->find("cushion")) p.cushion = read_cushion(*v, cushion, motion.sliding_friction);
  return p;
}

Physics read_physics(const Reader& scene, const Ball& ball) {
  const auto r = scene.find("physics");
  const Reader table = scene.need("table");
  constexpr std::array<std::string_view, 3> presets{"ideal", "rolling", "spin"};
  if (r && !r->is_string() && !r->is_object()) r->fail("must be the name of a physics or an object");
  const Reader* overrides = r && r->is_object() ? &*r : nullptr;
  const Reader model = !r ? scene : r->is_string() ? *r : r->need("model");
  const std::size_t which = r ? model.word("physics", presets) : 2;
  if (which == 2) {
    if (ball.body.radius == 0)
      throw InvalidInput("/ball/radius", "0 is a point, which only the physics \"ideal\" and \"rolling\" know");
    return read_spin_physics(overrides, table, ball.body);
  }
  if (which == 0) {
    if (overrides) r->only({"model"});
    return {Ideal{}, Mirror{1.0}};
  }
  Rolling rolling;
  Mirror mirror;
  if (overrides) {
    r->only({"model", "friction", "restitution", "g"});
    if (const auto v = r->find("friction")) rolling.friction = v->at_least(0);
    if (const auto v = r->find("restitution")) mirror.restitution = v->between(0, 1);
    if (const auto v = r->find("g")) rolling.g = v->positive();
  }
  return {rolling, mirror};
}

Target read_target(const Reader& r, const Table& table) {
  if (r.find("ball")) r.find("ball")->fail("is not supported yet");
  if (const auto point = r.find("point")) {
    r.only({"point", "within"});
    PointTarget t{point->point()};
    if (const auto w = r.find("within")) t.within = w->positive();
    return t;
  }
  r.only({"pocket", "point", "ball"});
  const auto pocket = r.find("pocket");
  if (!pocket) r.fail("must have one of the keys \"point\", \"pocket\", \"ball\"");
  if (table.pockets.empty()) pocket->fail("cannot be reached: this table has no pockets");
  std::vector<std::string_view> names{"any"};
  for (const Pocket& p : table.pockets) names.push_back(p.name);
  const std::size_t which = pocket->word("pocket", names);
  if (which == 0) return PocketTarget{};
  return PocketTarget{static_cast<int>(which) - 1};
}

CushionRule read_cushions(const Reader& r, const Table& table) {
  if (r.is_number()) return CushionRule::exactly(r.integer(0, max_cushions));
  if (r.is_object()) {
    r.only({"min", "max"});
    CushionRule rule;
    if (const auto v = r.find("min")) rule.min = v->integer(0, max_cushions);
    rule.max = std::max(rule.max, rule.min);
    if (const auto v = r.find("max")) rule.max = v->integer(rule.min, max_cushions);
    return rule;
  }
  if (!r.is_array()) r.fail("must be a number, a list of cushions or {\"min\":, \"max\":}");
  if (r.size() > static_cast<std::size_t>(max_cushions)) r.fail("must have at most 20000 cushions");
  const std::vector<std::string_view> names(table.cushions.begin(), table.cushions.end());
  std::vector<Contact> contacts;
  for (const Reader& item : r.items()) {
    const auto found = find_cushion(table, item.text());
    contacts.push_back(found ? *found : Contact::rail(static_cast<int>(item.word("cushion", names))));
  }
  return CushionRule::in_order(std::move(contacts));
}

Range read_angle(const Reader& r) {
  if (!r.is_array() || r.size() != 2) r.fail("must be a pair of degrees [from, to]");
  double from = r.items()[0].between(-720, 720), to = r.items()[1].between(-720, 720);
  constexpr double turn = 360, rounding = 1e-9;
  if (to - from > turn + rounding) r.fail("must span at most 360 degrees");
  const auto rotate = [&](double by) { from += by, to += by; };
  while (from < 0) rotate(turn);
  while (from >= turn) rotate(-turn);  // also -1e-20, which is a turn once a turn is added
  while (to < from) to += turn;
  return {radians(from), radians(std::min(to, from + turn))};
}

Noise read_noise(const Reader& r) {
  r.only({"angle", "speed"});
  Noise n;
  if (const auto v = r.find("angle")) n.angle = radians(v->at_least(0));
  if (const auto v = r.find("speed")) n.speed = v->at_least(0);
  return n;
}

/// `written`: its text in the document.
std::string read_id(const Reader& doc, std::string written) {
  if (const auto r = doc.find("id"); r && !r->is_string() && !r->is_number()) r->fail("must be a string or a number");
  return written;
}

void read_choices(const Reader& doc, Puzzle& p) {
  if (const auto v = doc.find("prefer")) {
    constexpr std::array<std::string_view, 3> words{"robust", "soft", "quick"};
    p.prefer = static_cast<Prefer>(v->word("preference", words));
  }
  if (const auto v = doc.find("aim")) {
    constexpr std::array<std::string_view, 2> words{"centre", "safest"};
    p.aim = static_cast<Aim>(v->word("aim", words));
  }
  if (const auto v = doc.find("noise")) p.noise = read_noise(*v);
  if (const auto v = doc.find("budget")) {
    v->only({"simulations"});
    p.budget = v->need("simulations").count();
  }
}

}  // namespace

Puzzle read_puzzle(std::string_view text) {
  std::string id;
  const Json json = parse_document(text, &id);
  const Reader doc(json);
  doc.only({"id", "table", "physics", "ball", "others", "target", "cushions", "arrive", "speed", "angle", "prefer",
            "aim", "noise", "budget"});
  Puzzle p;
  p.id = read_id(doc, std::move(id));
  const Reader table = doc.need("table");
  p.ball = read_ball(doc, default_ball(table));
  p.table = read_table(table, p.ball.body.radius);
  p.physics = read_physics(doc, p.ball);
  if (const auto v = doc.need("ball").find("spin")) {
    if (!is_straight(p.physics)) p.spin_range = read_spin_range(*v);
    if (!p.spin_range) p.spin = read_spin(*v, p.physics, false);
  }
  if (const auto v = doc.find("others"); v && !v->items().empty()) v->fail("is not supported yet");
  p.target = read_target(doc.need("target"), p.table);
  if (const auto v = doc.find("cushions")) p.cushions = read_cushions(*v, p.table);
  if (const auto v = doc.find("speed")) p.speed = v->range();
  if (const auto v = doc.find("arrive")) {
    v->only({"speed"});
    p.arrive = v->need("speed").range();
  }
  if (const auto v = doc.find("angle")) p.angle = read_angle(*v);
  read_choices(doc, p);
  validate(p);
  return p;
}

ShotRequest read_shot(std::string_view text) {
  std::string id;
  const Json json = parse_document(text, &id);
  const Reader doc(json);
  doc.only({"id", "table", "physics", "ball", "others", "shot", "until"});
  ShotRequest s;
  s.id = read_id(doc, std::move(id));
  const Reader table = doc.need("table");
  s.ball = read_ball(doc, default_ball(table));
  s.table = read_table(table, s.ball.body.radius);
  s.physics = read_physics(doc, s.ball);
  if (const auto v = doc.need("ball").find("spin")) s.spin = read_spin(*v, s.physics, false);
  if (const auto v = doc.find("others"); v && !v->items().empty()) v->fail("is not supported yet");
  const Reader shot = doc.need("shot");
  shot.only({"speed", "angle", "spin"});
  if (const auto v = shot.find("spin")) s.spin = read_spin(*v, s.physics, true);
  s.launch = {shot.need("speed").at_least(0), wrap_angle(radians(shot.need("angle").number()))};
  if (const auto until = doc.find("until")) {
    until->only({"time", "cushions", "length"});
    if (const auto v = until->find("time")) s.until.time = v->at_least(0);
    if (const auto v = until->find("cushions")) s.until.cushions = v->integer(1, 1000000);
    if (const auto v = until->find("length")) s.until.length = v->at_least(0);
  }
  validate(s);
  return s;
}

Scene read_scene(std::string_view table, std::string_view physics) {
  const Json json{{"table", parse_document(table)}, {"physics", parse_document(physics)}};
  const Reader doc(json);
  Scene s;
  s.ball = default_ball(doc.need("table"));
  s.table = read_table(doc.need("table"), s.ball.body.radius);
  s.physics = read_physics(doc, s.ball);
  return s;
}

std::string read_id(std::string_view text) { return find_id(text); }

}  // namespace bankshot
