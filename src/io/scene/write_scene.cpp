// SPDX-License-Identifier: MIT
#include "io/scene/write_scene.hpp"

#include "bankshot/geometry/boundary.hpp"

namespace bankshot {
namespace {

/// Returns the keys from which a table with jaws was made.
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
    for (const Vec2d& v : t.vertices) j["vertices"].push_back(pair_json(v));
    j["names"] = t.cushions;
  }
  if (j.contains("jaws")) return j;
  j["pockets"] = "none";
  if (t.pockets.empty()) return j;
  j["pockets"] = Json::array();
  for (const Pocket& p : t.pockets)
    j["pockets"].push_back({{"name", p.name}, {"at", pair_json(p.at)}, {"radius", p.radius}});
  return j;
}

Json friction_json(const BallFriction& f) {
  return f.constant() ? Json(f.fast) : Json{{"a", f.fast}, {"b", f.more}, {"c", f.fades}};
}

/// Adds the covariance of the coefficients.
Json with_errors(Json j, const Physics& p) {
  if (!p.errors) return j;
  const std::size_t n = p.errors->names.size();
  Json rows = Json::array();
  for (std::size_t i = 0; i < n; ++i) {
    Json& row = rows.emplace_back(Json::array());
    for (std::size_t k = 0; k < n; ++k) row.push_back(p.errors->covariance[i * n + k]);
  }
  j["covariance"] = {{"names", p.errors->names}, {"matrix", std::move(rows)}};
  return j;
}

}  // namespace

Json pair_json(const Vec2d& p) { return Json::array({p.x, p.y}); }

Json id_json(const std::string& id) { return id.empty() ? Json() : parse_document(id); }

Json ball_json(const Ball& b) { return {{"at", pair_json(b.at)}, {"radius", b.body.radius}, {"mass", b.body.mass}}; }

Json others_json(const std::vector<Ball>& others, const Body& struck) {
  Json list = Json::array();
  for (const Ball& other : others) {
    Json ball{{"id", other.id}, {"at", pair_json(other.at)}};
    if (other.body.radius != struck.radius) ball["radius"] = other.body.radius;
    if (other.body.mass != struck.mass) ball["mass"] = other.body.mass;
    list.push_back(std::move(ball));
  }
  return list;
}

Json spin_json(const LaunchSpin& s) { return {{"top", s.top}, {"side", s.side}, {"masse", s.masse}}; }

Json launch_json(const Launch& launch, const LaunchSpin& spin) {
  return {{"speed", launch.speed}, {"angle", exact_degrees(launch.angle)}, {"spin", spin_json(spin)}};
}

Json table_json(const Table& t, const Vec2d& tilt) {
  Json j = level_table_json(t);
  if (!(tilt == Vec2d{})) j["tilt"] = pair_json(tilt);
  if (Json own = own_json(t); !own.empty()) j["cushions"] = std::move(own);
  return j.size() == 1 && j.contains("preset") ? j["preset"] : j;
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
    return with_errors(std::move(j), p);
  }
  const SlideRoll& m = std::get<SlideRoll>(p.motion);
  if (!model_of(p.cushion).in_files)
    throw InvalidInput("/physics/cushion", "a custom cushion is a function: JSON has no words for it");
  Json cushion{{"model", model_of(p.cushion).key}, {"restitution", bounce}};
  const auto write = [&](const CushionCoefficient& c, double number) { cushion[std::string(c.key())] = number; };
  std::visit([&](const auto& law) { for_each_coefficient(law, write); }, p.cushion);
  Json j{{"model", "spin"},
         {"sliding_friction", m.sliding_friction},
         {"rolling_friction", of_speed(m.rolling_friction)},
         {"spinning_friction", m.spinning_friction},
         {"g", m.g},
         {"cushion", std::move(cushion)}};
  if (!(p.ball_ball == BallBall{}))
    j["ball_ball"] = {{"restitution", p.ball_ball.restitution}, {"friction", friction_json(p.ball_ball.friction)}};
  return with_errors(std::move(j), p);
}

}  // namespace bankshot
