// SPDX-License-Identifier: MIT
#include "io/scene/read_physics.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/format/scene_keys.hpp"
#include "io/scene/read_table.hpp"

namespace bankshot {

Restitution read_restitution(const Reader& r) {
  if (!r.is_object()) return r.number(format::cushion["restitution"].bounds);
  r.only(format::restitution_of_speed);
  Restitution e{r.need(format::restitution_of_speed["at_rest"]), r.need(format::restitution_of_speed["per_speed"])};
  r.read(format::restitution_of_speed["per_speed2"], e.per_speed2);
  return e;
}

namespace {

BallFriction read_ball_friction(const Reader& r) {
  if (!r.is_object()) return r.number(format::ball_ball["friction"].bounds);
  r.only(format::friction_of_slip);
  return {r.need(format::friction_of_slip["a"]), r.need(format::friction_of_slip["b"]),
          r.need(format::friction_of_slip["c"])};
}

RollingFriction read_rolling_friction(const Reader& r) {
  if (!r.is_object()) return r.number(format::spin_physics["rolling_friction"].bounds);
  r.only(format::friction_of_speed);
  const RollingFriction f{r.need(format::friction_of_speed["at_rest"]), r.need(format::friction_of_speed["per_speed"])};
  if (f.per_speed > 0 && f.at_rest == 0)
    r.need("at_rest").fail("must be greater than 0 where per_speed is: else the ball never comes to rest");
  return f;
}

/// Returns the models that have a coefficient, for an error message.
std::string models_with(const CushionCoefficient& coefficient) {
  std::string out;
  for (std::size_t i = 0; i < cushion_registry.size(); ++i) {
    CushionVariant law = default_cushion(i);
    if (find_coefficient(law, coefficient))
      out += fmt::format("{}\"{}\"", out.empty() ? "" : " and ", cushion_registry[i].key);
  }
  return out;
}

/// Reads a cushion. The cloth's `sliding_friction` may act during an impact, too. A coefficient of the usual law may
/// stand with any model, so that another one can be tried by its name alone.
CushionVariant read_cushion(const Reader& r, CushionVariant usual, double sliding_friction) {
  r.only(format::cushion);
  CushionVariant law = usual;
  if (const auto v = r.find("model")) {
    const std::string_view key = format::cushion_models[v->word("cushion model", format::cushion_models)];
    law = default_cushion(*find_cushion_model(key));
    take_coefficients(law, usual);
  }
  if (const auto v = r.find("restitution")) {
    const Restitution e = read_restitution(*v);
    std::visit([&](auto& its) { its.restitution = e; }, law);
  }
  for (const CushionCoefficient* c : cushion_coefficients) {
    double* const own = find_coefficient(law, *c);
    double* const place = own ? own : find_coefficient(usual, *c);
    if (const auto v = r.find(std::string(c->key())); v && !place)
      v->fail("is for the model " + models_with(*c) + " alone");
    if (place) r.read(format::key_of(*c), *place);
  }
  if (double* const of_cloth = cloth_friction(law)) *of_cloth = sliding_friction;
  return law;
}

CoefficientErrors read_covariance(const Reader& r) {
  r.only(format::covariance);
  CoefficientErrors out;
  for (const Reader& name : r.need("names").items())
    out.names.emplace_back(format::coefficient_names[name.word("coefficient", format::coefficient_names)]);
  const Reader matrix = r.need("matrix");
  const std::size_t n = out.names.size();
  if (!matrix.is_array() || matrix.size() != n) matrix.fail("must have a row for each name");
  for (const Reader& row : matrix.items()) {
    if (!row.is_array() || row.size() != n) row.fail("must have a number for each name");
    for (const Reader& number : row.items()) out.covariance.push_back(number.number());
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (out.covariance[i * n + i] < 0) matrix.fail("has a negative variance");
    for (std::size_t j = 0; j < i; ++j)
      if (out.covariance[i * n + j] != out.covariance[j * n + i]) matrix.fail("is not symmetric");
  }
  return out;
}

/// Returns the default height of the cushion nose [m]: the preset's, or one that suits the largest ball.
double usual_nose(const Reader& table, const Ball& ball, const std::vector<Ball>& others) {
  if (const TablePreset* const preset = preset_of(table)) return preset->nose();
  double largest = ball.body.radius;
  for (const Ball& other : others) largest = std::max(largest, other.body.radius);
  return 1.28 * largest;
}

Physics read_spin_physics(const Reader* r, const Body& body, double nose) {
  Physics p = spin_physics(body, nose);
  SlideRoll& motion = std::get<SlideRoll>(p.motion);
  if (!r) return p;
  r->only(format::spin_physics);
  r->read(format::spin_physics["sliding_friction"], motion.sliding_friction);
  if (const auto v = r->find("rolling_friction")) motion.rolling_friction = read_rolling_friction(*v);
  r->read(format::spin_physics["spinning_friction"], motion.spinning_friction);
  r->read(format::spin_physics["g"], motion.g);
  if (const auto v = r->find("cushion")) p.cushion = read_cushion(*v, p.cushion, motion.sliding_friction);
  if (const auto v = r->find("covariance")) p.errors = read_covariance(*v);
  if (const auto v = r->find("ball_ball")) {
    v->only(format::ball_ball);
    v->read(format::ball_ball["restitution"], p.ball_ball.restitution);
    if (const auto f = v->find("friction")) p.ball_ball.friction = read_ball_friction(*f);
  }
  return p;
}

Physics read_level_physics(const Reader& scene, const Ball& ball, double nose) {
  const auto r = scene.find("physics");
  if (r && !r->is_string() && !r->is_object()) r->fail("must be the name of a physics or an object");
  const Reader* overrides = r && r->is_object() ? &*r : nullptr;
  const Reader model = !r ? scene : r->is_string() ? *r : r->need("model");
  const std::size_t which = r ? model.word("physics", format::physics_names) : 2;
  if (which == 2) {
    if (ball.body.radius == 0)
      throw InvalidInput("/ball/radius", "0 is a point, which only the physics \"ideal\" and \"rolling\" know");
    return read_spin_physics(overrides, ball.body, nose);
  }
  if (which == 0) {
    if (overrides) r->only(format::ideal);
    return {Ideal{}, Mirror{1.0}};
  }
  Rolling rolling;
  Mirror mirror;
  BallBall balls;
  std::optional<CoefficientErrors> errors;
  if (overrides) {
    if (const auto v = r->find("covariance")) errors = read_covariance(*v);
    r->only(format::rolling);
    r->read(format::rolling["friction"], rolling.friction);
    r->read(format::rolling["restitution"], mirror.restitution.at_rest);
    r->read(format::rolling["g"], rolling.g);
    if (const auto v = r->find("ball_ball")) {
      v->only(format::rolling_balls);
      v->read(format::rolling_balls["restitution"], balls.restitution);
    }
  }
  return {rolling, mirror, balls, {}, std::move(errors)};
}

}  // namespace

Physics read_physics(const Reader& scene, const Ball& ball, const std::vector<Ball>& others) {
  const Reader table = scene.need("table");
  Physics p = read_level_physics(scene, ball, usual_nose(table, ball, others));
  const auto tilt = table.is_object() ? table.find("tilt") : std::nullopt;
  if (tilt) p.tilt = tilt->pair(format::tilt_key.bounds);
  return p;
}

}  // namespace bankshot
