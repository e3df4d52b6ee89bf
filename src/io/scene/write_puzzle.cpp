// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/scene/game.hpp"
#include "bankshot/scene/json.hpp"
#include "io/format/puzzle_keys.hpp"
#include "io/scene/write_scene.hpp"

namespace bankshot {
namespace {

Json both(const Range& r) { return pair_json({r.low, r.high}); }
Json range(const Range& r) { return r.fixed() ? Json(r.low) : both(r); }

Json cushions_json(const CushionRule& c, const Table& table) {
  if (!c.sequence) return c.min == c.max ? Json(c.min) : Json{{"min", c.min}, {"max", c.max}};
  Json names = Json::array();
  for (const Contact contact : *c.sequence) names.push_back(contact_name(table, contact));
  return names;
}

Json json_of(const PointTarget& target, const Puzzle&) {
  return {{"point", pair_json(target.at)}, {"within", target.within}};
}

Json json_of(const PocketTarget& target, const Puzzle& p) {
  return {{"pocket", target.pocket ? p.table.pockets[static_cast<std::size_t>(*target.pocket)].name : "any"}};
}

const std::string& id_of(const Puzzle& p, int ball) { return p.others[static_cast<std::size_t>(ball) - 1].id; }

/// Returns the path of the n-th object ball as JSON.
Json then_json(const Then& then, const Puzzle& p, std::size_t n = 0) {
  Json j = n < then.links.size() ? Json{{"ball", id_of(p, then.links[n].ball)}}
                                 : std::visit([&](const auto& t) { return json_of(t, p); }, then.target);
  if (n < then.links.size() || then.cushions) j["cushions"] = cushions_json(then.cushions_of(n), p.table);
  if (n < then.links.size()) j["then"] = then_json(then, p, n + 1);
  return j;
}

Json names_of(const std::vector<int>& balls, const Puzzle& p) {
  Json names = Json::array();
  for (const int k : balls) names.push_back(id_of(p, k));
  return names.size() == 1 ? names.front() : names;
}

/// Returns one ball as its id, one ball after the other as a list, and choices as a list of lists.
Json order_json(const PottingOrder& order, const Puzzle& p) {
  const bool single = std::ranges::all_of(order, [](const auto& group) { return group.size() == 1; });
  if (single && order.size() == 1) return id_of(p, order.front().front());
  Json list = Json::array();
  for (const std::vector<int>& group : order) {
    Json names = Json::array();
    for (const int ball : group) names.push_back(id_of(p, ball));
    list.push_back(single ? names.front() : names);
  }
  return list;
}

Json with_cut(Json j, const BallTarget& target) {
  if (target.cut) j["cut"] = exact_degrees(*target.cut);
  if (target.within) j["within"] = exact_degrees(*target.within);
  return j;
}

Json json_of(const BallTarget& target, const Puzzle& p) {
  return with_cut({{"ball", names_of(target.balls, p)}}, target);
}

Json json_of(const CaromTarget& target, const Puzzle& p) {
  Json j = with_cut({{"carom", names_of({target.first, target.second.balls.front()}, p)}}, target.second);
  if (target.any_order) j["order"] = "any";
  return j;
}

Json json_of(const ObjectBallTarget& target, const Puzzle& p) {
  return {{"ball", names_of(target.balls, p)}, {"then", then_json(target.then, p)}};
}

Json game_json(const Puzzle& p) {
  const PottingOrder& order = order_of(p);
  Json j{{"game", format::games[static_cast<std::size_t>(*p.game)]}};
  if (p.game == Game::list) j["order"] = order_json(order, p);
  if (p.game == Game::eight) j["group"] = format::groups[static_cast<std::size_t>(own_group(p))];
  return j;
}

Json target_json(const Puzzle& p) {
  if (p.game) return game_json(p);
  return std::visit([&](const auto& target) { return json_of(target, p); }, p.target);
}

Json noise_json(const Noise& n) {
  Json j{{"angle", exact_degrees(n.angle)}, {"speed", n.speed}};
  const auto put = [&](const char* key, double value) {
    if (value > 0) j[key] = value;
  };
  put("speed_share", n.speed_share);
  put("tip", n.tip);
  put("side", n.side);
  put("top", n.top);
  put("at", n.at);
  return j;
}

Json json_of(const LeavePlace& place, const Puzzle&) {
  return {{"point", pair_json(place.at)}, {"within", place.within}};
}
Json json_of(const LeaveRegion& region, const Puzzle&) {
  Json vertices = Json::array();
  for (const Vec2d& vertex : region.vertices) vertices.push_back(pair_json(vertex));
  return {{"polygon", vertices}};
}
Json json_of(const LeaveForNext& next, const Puzzle& p) { return {{"for", order_json(next.order, p)}}; }
Json json_of(const LeaveAgainst& against, const Puzzle& p) { return {{"against", order_json(against.order, p)}}; }
Json json_of(const LeaveSafe& safe, const Puzzle& p) {
  Json names = Json::array();
  for (const int k : safe.balls) names.push_back(id_of(p, k));
  return {{"safe", names}};
}

Json in_hand_json(const InHand& hand) {
  if (hand.where == InHand::Where::anywhere) return format::hand_words[0];
  if (hand.where == InHand::Where::behind_head_string) return {{"behind", format::hand_lines[0]}};
  Json vertices = Json::array();
  for (const Vec2d& vertex : hand.vertices) vertices.push_back(pair_json(vertex));
  return vertices;
}

/// Returns everything except table and physics as JSON.
Json question_json(const Puzzle& p) {
  constexpr const char* preferences[] = {"robust", "soft", "quick"};
  Json j = Json::object();
  if (!p.about.empty()) j["about"] = parse_document(p.about);
  j["ball"] = ball_json(p.ball);
  if (p.in_hand) j["ball"]["at"] = in_hand_json(*p.in_hand);
  if (!p.others.empty()) j["others"] = others_json(p.others, p.ball.body);
  if (!p.settled.empty()) j["settle"] = true;
  if (p.spin_range)
    j["ball"]["spin"] = {
        {"top", both(p.spin_range->top)}, {"side", both(p.spin_range->side)}, {"masse", both(p.spin_range->masse)}};
  else if (carries_spin(p.physics))
    j["ball"]["spin"] = spin_json(p.spin);
  j["target"] = target_json(p);
  j["cushions"] = cushions_json(p.cushions, p.table);
  if (p.arrive) j["arrive"] = {{"speed", range(*p.arrive)}};
  j["speed"] = range(p.speed);
  if (p.angle) j["angle"] = pair_json({exact_degrees(p.angle->low), exact_degrees(p.angle->high)});
  if (!p.game)
    j["prefer"] =
        p.rest_near ? Json{{"leave", pair_json(*p.rest_near)}} : Json(preferences[static_cast<int>(p.prefer)]);
  if (p.leave && !p.game) j["leave"] = std::visit([&](const auto& wanted) { return json_of(wanted, p); }, *p.leave);
  if (p.aim) j["aim"] = *p.aim == Aim::safest ? "safest" : "centre";
  j["noise"] = noise_json(p.noise);
  if (p.budget) j["budget"] = {{"simulations", *p.budget}};
  return j;
}

}  // namespace

std::string write_puzzle(const Puzzle& p) {
  Json j = Json::object();
  j["table"] = table_json(p.table, p.physics.tilt);
  j["physics"] = physics_json(p.physics);
  j.update(question_json(p));
  return write_json(p.id, j);
}

std::string write_puzzle(const Puzzle& p, std::string_view table, std::string_view physics) {
  const Scene scene = read_scene(table, physics);
  Puzzle plain{.table = scene.table,
               .physics = scene.physics,
               .ball = scene.ball,
               .others = p.others,
               .target = p.target,
               .cushions = p.cushions};
  plain.ball.at = p.ball.at;
  if (auto* point = std::get_if<PointTarget>(&plain.target)) point->within = PointTarget{}.within;
  const auto forget = [](BallTarget& touch) { touch.within.reset(), touch.cut.reset(); };
  if (auto* ball = std::get_if<BallTarget>(&plain.target)) forget(*ball);
  if (auto* carom = std::get_if<CaromTarget>(&plain.target)) forget(carom->second);
  const Json said = question_json(p), untold = question_json(plain);
  Json j{{"table", parse_document(table)}, {"physics", parse_document(physics)}};
  const auto same = [](const Json& said_so, const Json& otherwise, const std::string& key) {
    return otherwise.contains(key) && otherwise.at(key) == said_so.at(key);
  };
  for (const auto& [key, value] : said.items())
    if (key == "ball" || key == "others" || key == "target" || key == "cushions" || !same(said, untold, key))
      j[key] = value;
  constexpr std::string_view always[] = {"at", "point", "pocket", "ball", "carom", "then"};
  for (const char* key : {"ball", "target"})
    for (const auto& [inner, value] : said.at(key).items())
      if (std::ranges::find(always, inner) == std::end(always) && same(said.at(key), untold.at(key), inner))
        j[key].erase(inner);
  if (j["ball"].contains("spin"))
    for (const char* key : {"top", "side", "masse"})
      if (j["ball"]["spin"][key] == 0) j["ball"]["spin"].erase(key);
  return write_json(p.id, j);
}

}  // namespace bankshot
