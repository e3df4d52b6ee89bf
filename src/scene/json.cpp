// SPDX-License-Identifier: MIT
#include "bankshot/scene/json.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "bankshot/scene/boundary.hpp"
#include "json/reader.hpp"
#include "scene/read_table.hpp"

namespace bankshot {
namespace {

Ball read_ball(const Reader& scene, Ball ball) {
  const Reader r = scene.need("ball");
  r.only({"at", "radius", "mass", "spin"});
  ball.at = r.need("at").point();
  if (const auto v = r.find("radius")) ball.radius = v->at_least(0);
  if (const auto v = r.find("mass")) ball.mass = v->positive();
  if (const auto v = r.find("spin")) v->fail("needs the physics \"spin\", which is not supported yet");
  return ball;
}

Physics read_physics(const Reader& scene) {
  const auto r = scene.find("physics");
  if (!r)
    throw InvalidInput("/physics",
                       "this key is missing and its default, \"spin\", is not supported yet; "
                       "choose \"rolling\" or \"ideal\"");
  constexpr std::array<std::string_view, 3> presets{"ideal", "rolling", "spin"};
  if (!r->is_string() && !r->is_object()) r->fail("must be the name of a physics or an object");
  const Reader model = r->is_string() ? *r : r->need("model");
  const std::size_t which = model.word("physics", presets);
  if (which == 2) model.fail("is not supported yet; choose \"rolling\" or \"ideal\"");
  if (which == 0) {
    if (!r->is_string()) r->only({"model"});
    return ideal_physics();
  }
  Rolling rolling;
  Mirror mirror;
  if (!r->is_string()) {
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
  std::vector<std::string> all;
  const auto edges = static_cast<int>(table.cushions.size());
  for (int i = 0; i < 2 * edges; ++i) all.push_back(contact_name(table, i));
  std::vector<std::string_view> names(all.begin(), all.begin() + edges);
  std::vector<int> contacts;
  for (const Reader& item : r.items()) {
    const auto it = std::find(all.begin(), all.end(), item.text());
    contacts.push_back(it != all.end() ? static_cast<int>(it - all.begin())
                                       : static_cast<int>(item.word("cushion", names)));
  }
  return CushionRule::in_order(std::move(contacts));
}

Range read_angle(const Reader& r) {
  if (!r.is_array() || r.size() != 2) r.fail("must be a pair of degrees [from, to]");
  double from = r.items()[0].between(-360, 360), to = r.items()[1].between(-360, 720);
  constexpr double turn = 360, rounding = 1e-9;
  if (to - from > turn + rounding) r.fail("must span at most 360 degrees");
  const auto rotate = [&](double by) { from += by, to += by; };
  if (from < 0) rotate(turn);
  if (from >= turn) rotate(-turn);  // also -1e-20, which is a turn once a turn is added
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

std::string read_id(const Reader& r) {
  if (!r.is_string() && !r.is_number()) r.fail("must be a string or a number");
  return r.raw();
}

void read_choices(const Reader& doc, Puzzle& p) {
  if (const auto v = doc.find("prefer")) {
    constexpr std::array<std::string_view, 3> words{"robust", "soft", "quick"};
    p.prefer = static_cast<Prefer>(v->word("preference", words));
  }
  if (const auto v = doc.find("aim")) {
    constexpr std::array<std::string_view, 2> words{"centre", "safest"};
    if (v->word("aim", words) == 1) v->fail("is not supported yet");
  }
  if (const auto v = doc.find("noise")) p.noise = read_noise(*v);
  if (const auto v = doc.find("budget")) {
    v->only({"simulations"});
    p.budget = v->need("simulations").integer(0, std::numeric_limits<int>::max());
  }
}

}  // namespace

Puzzle read_puzzle(std::string_view text) {
  const Json json = parse_document(text);
  const Reader doc(json);
  doc.only({"id", "table", "physics", "ball", "others", "target", "cushions", "arrive", "speed",
            "angle", "prefer", "aim", "noise", "budget"});
  Puzzle p;
  if (const auto v = doc.find("id")) p.id = read_id(*v);
  const Reader table = doc.need("table");
  p.ball = read_ball(doc, default_ball(table));
  p.table = read_table(table, p.ball.radius);
  p.physics = read_physics(doc);
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
  const Json json = parse_document(text);
  const Reader doc(json);
  doc.only({"id", "table", "physics", "ball", "others", "shot", "until"});
  ShotRequest s;
  if (const auto v = doc.find("id")) s.id = read_id(*v);
  const Reader table = doc.need("table");
  s.ball = read_ball(doc, default_ball(table));
  s.table = read_table(table, s.ball.radius);
  s.physics = read_physics(doc);
  if (const auto v = doc.find("others"); v && !v->items().empty()) v->fail("is not supported yet");
  const Reader shot = doc.need("shot");
  shot.only({"speed", "angle", "spin"});
  if (const auto v = shot.find("spin")) v->fail("needs the physics \"spin\", which is not supported yet");
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

std::string read_id(std::string_view text) { return find_id(text); }

}  // namespace bankshot
