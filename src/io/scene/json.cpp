// SPDX-License-Identifier: MIT
#include "bankshot/scene/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/scene/game.hpp"
#include "io/format/shot_keys.hpp"
#include "io/json/reader.hpp"
#include "io/scene/read_physics.hpp"
#include "io/scene/read_shot.hpp"
#include "io/scene/read_table.hpp"

namespace bankshot {
namespace {

/// Reads the ranges of spin; returns none if every spin is one number.
std::optional<SpinRange> read_spin_range(const Reader& r) {
  r.only(format::spins);
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

CushionRule read_cushions(const Reader& r, const Table& table) {
  if (r.is_number()) return CushionRule::exactly(r.integer(format::puzzle["cushions"].bounds));
  if (r.is_object()) {
    r.only(format::count);
    CushionRule rule;
    if (const auto v = r.find("min")) rule.min = v->integer(format::count["min"].bounds);
    rule.max = std::max(rule.max, rule.min);
    if (const auto v = r.find("max")) rule.max = v->integer(rule.min, max_cushions);
    return rule;
  }
  if (!r.is_array()) r.fail("must be a number, a list of cushions or {\"min\":, \"max\":}");
  return CushionRule::in_order(read_sequence(r, table));
}

std::vector<std::string_view> names_of(const Reader& r, const std::vector<Ball>& others) {
  if (others.empty()) r.fail("cannot be touched: there are no \"others\"");
  std::vector<std::string_view> names;
  for (const Ball& other : others) names.push_back(other.id);
  return names;
}

/// Reads the name of a ball and returns its number.
int read_ball(const Reader& r, const std::vector<Ball>& others) {
  return 1 + static_cast<int>(r.word("ball", names_of(r, others)));
}

/// Reads one ball, a list of balls, or "any", and returns their numbers.
std::vector<int> read_balls(const Reader& r, const std::vector<Ball>& others) {
  std::vector<std::string_view> names = names_of(r, others);
  std::vector<int> balls;
  if (r.is_array()) {
    for (const Reader& item : r.items()) balls.push_back(1 + static_cast<int>(item.word("ball", names)));
    return balls;
  }
  names.push_back("any");
  const std::size_t which = r.word("ball", names);
  if (which < others.size()) return {1 + static_cast<int>(which)};
  for (std::size_t i = 0; i < others.size(); ++i) balls.push_back(1 + static_cast<int>(i));
  return balls;
}

/// Reads the order in which balls are potted: one ball, a list of balls one after the other, or a list of lists of
/// which each allows any of its balls.
PottingOrder read_order(const Reader& r, const std::vector<Ball>& others) {
  if (!r.is_array()) return {{read_ball(r, others)}};
  PottingOrder order;
  for (const Reader& item : r.items())
    order.push_back(item.is_array() ? read_balls(item, others) : std::vector{read_ball(item, others)});
  std::set<int> known;
  for (const std::vector<int>& any : order)
    for (const int ball : any)
      if (!known.insert(ball).second)
        r.fail(
            fmt::format("names ball \"{}\" twice; it is potted once", others[static_cast<std::size_t>(ball) - 1].id));
  return order;
}

PointTarget read_point(const Reader& r) {
  PointTarget t{r.need("point").point()};
  r.read(format::to_point["within"], t.within);
  return t;
}

PocketTarget read_pocket(const Reader& r, const Table& table) {
  const Reader pocket = r.need("pocket");
  if (table.pockets.empty()) pocket.fail("cannot be reached: this table has no pockets");
  std::vector<std::string_view> names{"any"};
  for (const Pocket& p : table.pockets) names.push_back(p.name);
  const std::size_t which = pocket.word("pocket", names);
  if (which == 0) return {};
  return {static_cast<int>(which) - 1};
}

/// Adds the path of the ball that was touched last, recursively for combination links.
void read_then(const Reader& r, const Table& table, const std::vector<Ball>& others, Then& then) {
  std::optional<CushionRule> cushions;
  if (const auto v = r.find("cushions")) cushions = read_cushions(*v, table);
  if (const auto ball = r.find("ball")) {
    r.only(format::then_ball);
    then.links.push_back({cushions.value_or(CushionRule::exactly(0)), read_ball(*ball, others)});
    return read_then(r.need("then"), table, others, then);
  }
  then.cushions = std::move(cushions);
  if (r.find("point")) {
    r.only(format::then_point);
    then.target = read_point(r);
    return;
  }
  if (!r.find("pocket")) r.fail("must have one of the keys \"point\", \"pocket\", \"ball\"");
  r.only(format::then_pocket);
  then.target = read_pocket(r, table);
}

BallTarget read_touch(const Reader& r, std::vector<int> balls, const format::Bounds& within) {
  BallTarget t{.balls = std::move(balls)};
  if (const auto v = r.find("cut")) t.cut = radians(v->number());
  if (const auto v = r.find("within")) t.within = radians(v->number(within));
  return t;
}

Target read_ball_target(const Reader& r, const Table& table, const std::vector<Ball>& others) {
  if (const auto v = r.find("cushions"))
    v->fail("has no place here: those of the object ball stand in \"then\", those of the cue ball beside \"target\"");
  r.only(format::to_ball);
  std::vector<int> balls = read_balls(r.need("ball"), others);
  const auto then = r.find("then"), pocket = r.find("pocket");
  if (then && pocket) pocket->fail("is short for \"then\" with that pocket, which stands beside it");
  if (then || pocket)
    for (const char* key : {"cut", "within"})
      if (const auto other = r.find(key))
        other->fail(fmt::format("stands beside \"{}\", which says where the ball is to go", then ? "then" : "pocket"));
  if (pocket) return ObjectBallTarget{std::move(balls), {.target = read_pocket(r, table)}};
  if (!then) return read_touch(r, std::move(balls), format::to_ball["within"].bounds);
  ObjectBallTarget sends{.balls = std::move(balls)};
  read_then(*then, table, others, sends.then);
  // "any" excludes the balls of later combination links.
  if (const Reader ball = r.need("ball"); ball.is_string() && ball.text() == "any")
    for (const Link& link : sends.then.links) std::erase(sends.balls, link.ball);
  return sends;
}

CaromTarget read_carom(const Reader& r, const std::vector<Ball>& others) {
  r.only(format::carom);
  const Reader pair = r.need("carom");
  if (!pair.is_array() || pair.size() != 2) pair.fail("must be a pair of balls");
  if (others.empty()) pair.fail("cannot be touched: there are no \"others\"");
  const auto balls = pair.items();
  const int second = read_ball(balls[1], others), first = read_ball(balls[0], others);
  CaromTarget carom{first, read_touch(r, {second}, format::carom["within"].bounds)};
  if (const auto v = r.find("order")) carom.any_order = v->word("order", format::carom_orders) == 1;
  return carom;
}

Target read_target(const Reader& r, const Table& table, const std::vector<Ball>& others) {
  if (r.find("ball")) return read_ball_target(r, table, others);
  if (r.find("carom")) return read_carom(r, others);
  if (r.find("point")) {
    if (r.find("pocket")) r.fail("has a point and a pocket: one of them is the target");
    r.only(format::to_point);
    return read_point(r);
  }
  if (!r.find("pocket")) r.fail("must have one of the keys \"point\", \"pocket\", \"ball\", \"carom\", \"game\"");
  r.only(format::to_pocket);
  return read_pocket(r, table);
}

/// Reads what a game asks: its target, its leave, and a spin that is free where the puzzle gives none.
void read_game(const Reader& r, Puzzle& p) {
  r.only(format::game);
  const auto game = static_cast<Game>(r.need("game").word("game", format::games));
  const auto group = r.find("group"), order = r.find("order");
  if (group && game != Game::eight) group->fail("belongs to the game \"eight\" alone");
  if (order && game != Game::list) order->fail("belongs to the game \"list\" alone");
  if (p.others.empty()) r.fail("needs balls to pot, in \"others\"");
  if (p.table.pockets.empty()) r.fail("needs pockets, and this table has none");
  if (is_ideal(p.physics)) r.fail("needs balls that come to rest, and in ideal physics none does");
  if (game == Game::list)
    ask(p, game, read_order(r.need("order"), p.others));
  else if (game == Game::eight)
    ask(p, game,
        order_of_eight(
            static_cast<Group>(r.need("group", "; on an open table ask for each group, and take the better shot")
                                   .word("group", format::groups)),
            p.others));
  else
    ask(p, game, order_of(game, p.others));
}

Range read_angle(const Reader& r) {
  if (!r.is_array() || r.size() != 2) r.fail("must be a pair of degrees [from, to]");
  constexpr format::Bounds bounds = format::puzzle["angle"].bounds;
  double from = r.items()[0].number(bounds), to = r.items()[1].number(bounds);
  constexpr double turn = 360, rounding = 1e-9;
  if (to - from > turn + rounding) r.fail("must span at most 360 degrees");
  const auto rotate = [&](double by) { from += by, to += by; };
  while (from < 0) rotate(turn);
  while (from >= turn) rotate(-turn);  // also for -1e-20, which becomes a full turn by adding one
  while (to < from) to += turn;
  return {radians(from), radians(std::min(to, from + turn))};
}

Noise read_player(const Reader& r) {
  std::vector<std::string_view> names;
  for (const Player& player : players()) names.push_back(player.name);
  return players()[r.word("player", names)].noise;
}

Noise read_noise(const Reader& r) {
  if (!r.is_object()) return read_player(r);
  r.only(format::noise);
  const auto player = r.find("player");
  Noise n = player ? read_player(*player) : Puzzle{}.noise;
  if (r.find("speed")) n.speed_share = 0;
  if (const auto v = r.find("angle")) n.angle = radians(v->number(format::noise["angle"].bounds));
  r.read(format::noise["speed"], n.speed);
  r.read(format::noise["speed_share"], n.speed_share);
  if (const auto v = r.find("tip")) n.tip = v->number(format::noise["tip"].bounds);
  r.read(format::noise["side"], n.side);
  r.read(format::noise["top"], n.top);
  if (const auto v = r.find("at")) n.at = v->number(format::noise["at"].bounds);
  return n;
}

Leave read_leave(const Reader& r, const std::vector<Ball>& others) {
  if (!r.is_object()) r.fail("must have one of the keys \"point\", \"polygon\", \"for\", \"safe\", \"against\"");
  if (const auto v = r.find("polygon")) {
    r.only(format::leave_region);
    LeaveRegion region;
    for (const Reader& vertex : v->items()) region.vertices.push_back(vertex.point());
    return region;
  }
  if (const auto v = r.find("for")) {
    r.only(format::leave_for);
    return LeaveForNext{read_order(*v, others)};
  }
  if (const auto v = r.find("against")) {
    r.only(format::leave_against);
    return LeaveAgainst{read_order(*v, others)};
  }
  if (const auto v = r.find("safe")) {
    r.only(format::leave_safe);
    return LeaveSafe{read_balls(*v, others)};
  }
  if (!r.find("point")) r.fail("must have one of the keys \"point\", \"polygon\", \"for\", \"safe\", \"against\"");
  r.only(format::leave_place);
  LeavePlace place{r.need("point").point()};
  r.read(format::leave_place["within"], place.within);
  return place;
}

void read_choices(const Reader& doc, Puzzle& p) {
  if (const auto v = doc.find("leave")) p.leave = read_leave(*v, p.others);
  if (const auto v = doc.find("prefer")) {
    if (v->is_object()) {
      v->only(format::rest_near);
      p.rest_near = v->need("leave").point();
    } else {
      p.prefer = static_cast<Prefer>(v->word("preference", format::preferences));
    }
  }
  if (const auto v = doc.find("aim")) p.aim = static_cast<Aim>(v->word("aim", format::aims));
  if (const auto v = doc.find("noise")) {
    p.noise = read_noise(*v);
    // A player's tip error applies only in physics with spin.
    const bool own_tip = v->is_object() && v->find("tip");
    if (!own_tip && !carries_spin(p.physics)) p.noise.tip = 0;
  }
  if (const auto v = doc.find("budget")) {
    v->only(format::budget);
    p.budget = v->need("simulations").count();
  }
}

ShotRequest::Until read_until(const Reader& r) {
  r.only(format::until);
  ShotRequest::Until until;
  if (const auto v = r.find("time")) until.time = v->number(format::until["time"].bounds);
  if (const auto v = r.find("cushions")) until.cushions = v->integer(format::until["cushions"].bounds);
  if (const auto v = r.find("length")) until.length = v->length(format::until["length"].bounds);
  return until;
}

std::string about_of(const Json& doc) {
  const auto about = doc.find("about");
  return about == doc.end() ? "" : write_json(*about);
}

}  // namespace

Puzzle read_puzzle(std::string_view text) {
  std::string id;
  const Json json = parse_document(text, &id);
  const Units units = read_units(Reader(json));
  const Reader doc(json, "", units);
  doc.only(format::puzzle);
  Puzzle p;
  p.id = read_id(doc, std::move(id));
  p.about = about_of(json);
  read_setting(doc, p);
  if (const auto v = doc.need("ball").find("spin")) {
    if (carries_spin(p.physics)) p.spin_range = read_spin_range(*v);
    if (!p.spin_range) p.spin = read_spin(*v, p.physics, false);
  }
  if (const Reader target = doc.need("target"); target.find("game")) {
    for (const char* key : {"leave", "prefer", "arrive"})
      if (const auto v = doc.find(key)) v->fail("has no place beside a game, which plans where the cue ball stops");
    read_game(target, p);
    if (carries_spin(p.physics) && !doc.need("ball").find("spin")) p.spin_range = SpinRange{{-1, 1}, {-0.75, 0.75}, {}};
  } else {
    p.target = read_target(target, p.table, p.others);
  }
  if (const auto v = doc.find("cushions")) p.cushions = read_cushions(*v, p.table);
  if (const auto v = doc.find("speed")) p.speed = v->range();
  if (const auto v = doc.find("arrive")) {
    v->only(format::arrive);
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
  const Units units = read_units(Reader(json));
  const Reader doc(json, "", units);
  doc.only(format::shot);
  ShotRequest s;
  s.id = read_id(doc, std::move(id));
  read_setting(doc, s);
  doc.need("shot");
  read_launch(doc, s);
  if (const auto until = doc.find("until")) s.until = read_until(*until);
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

std::string read_about(std::string_view text) {
  if (text.find("\"about\"") == std::string_view::npos) return "";
  try {
    const Json json = parse_document(text);
    return json.is_object() ? about_of(json) : "";
  } catch (const InvalidInput&) {
    return "";
  }
}

}  // namespace bankshot
