// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/scene/json.hpp"
#include "json/document.hpp"

namespace bankshot {
namespace {

Json pair(double a, double b) { return Json::array({a, b}); }
Json pair(const Vec2d& p) { return pair(p.x, p.y); }
Json both(const Range& r) { return pair(r.low, r.high); }
Json range(const Range& r) { return r.fixed() ? Json(r.low) : both(r); }

/// A table with jaws is told by what it was made of.
Json jaws_json(const Table& t) {
  Table plain = t;
  plain.own.clear();
  for (const TablePreset& preset : table_presets())
    if (preset.jaws && plain == make_table(preset)) return {{"preset", preset.name}};
  const Mouth mouth{t.pockets[0].jaws->mouth, t.pockets[1].jaws->mouth};
  return {{"pockets", "six"}, {"jaws", true}, {"mouth", {{"corner", mouth.corner}, {"middle", mouth.middle}}}};
}

Json restitution_json(const Restitution& e) {
  if (e.constant()) return e.at_rest;
  Json j{{"at_rest", e.at_rest}, {"per_speed", e.per_speed}};
  if (e.per_speed2 != 0) j["per_speed2"] = e.per_speed2;
  return j;
}

Json own_json(const Table& t) {
  Json j = Json::object();
  for (std::size_t i = 0; i < t.own.size(); ++i) {
    if (!t.own[i].any()) continue;
    Json& rail = j[t.cushions[i]] = Json::object();
    if (t.own[i].restitution) rail["restitution"] = restitution_json(*t.own[i].restitution);
    if (t.own[i].friction) rail["friction"] = *t.own[i].friction;
  }
  return j;
}

Json level_table_json(const Table& t) {
  Json j = Json::object();
  if (!t.pockets.empty() && t.pockets[0].jaws) j = jaws_json(t);
  if (j.contains("preset")) return j;
  const Vec2d size = t.highest();
  const bool plain = t.is_rectangle() && t.lowest() == Vec2d{0, 0};
  if (plain && t.cushions == rectangle_table(size.x, size.y).cushions) {
    j["length"] = size.x;
    j["width"] = size.y;
  } else {
    j["vertices"] = Json::array();
    for (const Vec2d& v : t.vertices) j["vertices"].push_back(pair(v));
    j["names"] = t.cushions;
  }
  if (j.contains("jaws")) return j;
  j["pockets"] = "none";
  if (t.pockets.empty()) return j;
  j["pockets"] = Json::array();
  for (const Pocket& p : t.pockets)
    j["pockets"].push_back({{"name", p.name}, {"at", pair(p.at)}, {"radius", p.radius}});
  return j;
}

Json table_json(const Table& t, const Vec2d& tilt) {
  Json j = level_table_json(t);
  if (!(tilt == Vec2d{})) j["tilt"] = pair(tilt);
  if (Json own = own_json(t); !own.empty()) j["cushions"] = std::move(own);
  return j.size() == 1 && j.contains("preset") ? j["preset"] : j;
}

Json friction_json(const BallFriction& f) {
  return f.constant() ? Json(f.fast) : Json{{"a", f.fast}, {"b", f.more}, {"c", f.fades}};
}

Json physics_json(const Physics& p) {
  if (is_ideal(p)) return "ideal";
  const Restitution& e = restitution(p);
  const auto of_speed = [](const auto& f) {
    return f.per_speed == 0 ? Json(f.at_rest) : Json{{"at_rest", f.at_rest}, {"per_speed", f.per_speed}};
  };
  const Json bounce = restitution_json(e);
  if (const auto* r = std::get_if<Rolling>(&p.motion)) {
    Json j{{"model", "rolling"}, {"friction", r->friction}, {"restitution", bounce}, {"g", r->g}};
    if (p.ball_ball.restitution != BallBall{}.restitution) j["ball_ball"] = {{"restitution", p.ball_ball.restitution}};
    return j;
  }
  const SlideRoll& m = std::get<SlideRoll>(p.motion);
  if (std::holds_alternative<CustomCushion>(p.cushion))
    throw InvalidInput("/physics/cushion", "a custom cushion is a function: JSON has no words for it");
  Json cushion{{"model", "mirror"}, {"restitution", bounce}};
  if (const auto* h = std::get_if<Han2005>(&p.cushion))
    cushion = {{"model", "han2005"}, {"restitution", bounce}, {"friction", h->friction}, {"height", h->height}};
  if (const auto* c = std::get_if<Mathavan2010>(&p.cushion))
    cushion = {{"model", "mathavan2010"}, {"restitution", bounce}, {"friction", c->friction}, {"height", c->height}};
  if (const auto* c = std::get_if<Stronge>(&p.cushion))
    cushion = {{"model", "stronge"},
               {"restitution", bounce},
               {"friction", c->friction},
               {"height", c->height},
               {"frequency_ratio", c->frequency_ratio}};
  Json j{{"model", "spin"},
         {"sliding_friction", m.sliding_friction},
         {"rolling_friction", of_speed(m.rolling_friction)},
         {"spinning_friction", m.spinning_friction},
         {"g", m.g},
         {"cushion", std::move(cushion)}};
  if (!(p.ball_ball == BallBall{}))
    j["ball_ball"] = {{"restitution", p.ball_ball.restitution}, {"friction", friction_json(p.ball_ball.friction)}};
  return j;
}

Json cushions_json(const CushionRule& c, const Table& table) {
  if (!c.sequence) return c.min == c.max ? Json(c.min) : Json{{"min", c.min}, {"max", c.max}};
  Json names = Json::array();
  for (const Contact contact : *c.sequence) names.push_back(contact_name(table, contact));
  return names;
}

Json json_of(const PointTarget& target, const Puzzle&) {
  return {{"point", pair(target.at)}, {"within", target.within}};
}

Json json_of(const PocketTarget& target, const Puzzle& p) {
  return {{"pocket", target.pocket ? p.table.pockets[static_cast<std::size_t>(*target.pocket)].name : "any"}};
}

const std::string& id_of(const Puzzle& p, int ball) { return p.others[static_cast<std::size_t>(ball) - 1].id; }

/// Of the ball that is sent on as the n-th.
Json then_json(const Then& then, const Puzzle& p, std::size_t n = 0) {
  Json j = n < then.links.size() ? Json{{"ball", id_of(p, then.links[n].ball)}}
                                 : std::visit([&](const auto& t) { return json_of(t, p); }, then.target);
  j["cushions"] = cushions_json(then.cushions_of(n), p.table);
  if (n < then.links.size()) j["then"] = then_json(then, p, n + 1);
  return j;
}

Json json_of(const BallTarget& target, const Puzzle& p) {
  Json names = Json::array();
  if (target.off) names.push_back(id_of(p, *target.off));
  for (const int k : target.balls) names.push_back(id_of(p, k));
  Json j{{target.off ? "carom" : "ball", names.size() == 1 ? names.front() : names}};
  if (target.then) {
    j["then"] = then_json(*target.then, p);
  } else {
    j["cut"] = exact_degrees(target.cut);
    j["within"] = exact_degrees(target.within);
  }
  return j;
}

Json target_json(const Puzzle& p) {
  return std::visit([&](const auto& target) { return json_of(target, p); }, p.target);
}

Json others_json(const Puzzle& p) {
  Json list = Json::array();
  for (const Ball& other : p.others) {
    Json ball{{"id", other.id}, {"at", pair(other.at)}};
    if (other.body.radius != p.ball.body.radius) ball["radius"] = other.body.radius;
    if (other.body.mass != p.ball.body.mass) ball["mass"] = other.body.mass;
    list.push_back(std::move(ball));
  }
  return list;
}

Json noise_json(const Noise& n) {
  Json j{{"angle", exact_degrees(n.angle)}, {"speed", n.speed}};
  const auto put = [&](const char* key, double value) {
    if (value > 0) j[key] = value;
  };
  put("side", n.side);
  put("top", n.top);
  put("at", n.at);
  return j;
}

/// All but the scene.
Json question_json(const Puzzle& p) {
  constexpr const char* preferences[] = {"robust", "soft", "quick"};
  Json j = Json::object();
  if (!p.about.empty()) j["about"] = parse_document(p.about);
  j["ball"] = {{"at", pair(p.ball.at)}, {"radius", p.ball.body.radius}, {"mass", p.ball.body.mass}};
  if (!p.others.empty()) j["others"] = others_json(p);
  if (p.spin_range)
    j["ball"]["spin"] = {
        {"top", both(p.spin_range->top)}, {"side", both(p.spin_range->side)}, {"masse", both(p.spin_range->masse)}};
  else if (carries_spin(p.physics))
    j["ball"]["spin"] = {{"top", p.spin.top}, {"side", p.spin.side}, {"masse", p.spin.masse}};
  j["target"] = target_json(p);
  j["cushions"] = cushions_json(p.cushions, p.table);
  if (p.arrive) j["arrive"] = {{"speed", range(*p.arrive)}};
  j["speed"] = range(p.speed);
  if (p.angle) j["angle"] = pair(exact_degrees(p.angle->low), exact_degrees(p.angle->high));
  j["prefer"] = p.leave ? Json{{"leave", pair(*p.leave)}} : Json(preferences[static_cast<int>(p.prefer)]);
  if (p.aim == Aim::safest) j["aim"] = "safest";
  j["noise"] = noise_json(p.noise);
  j["budget"] = {{"simulations", p.budget}};
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
  if (auto* ball = std::get_if<BallTarget>(&plain.target)) {
    ball->within = ball->off && ball->cut == 0 ? any_touch : BallTarget{}.within;
    ball->cut = 0;
  }
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
