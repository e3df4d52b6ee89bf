// SPDX-License-Identifier: MIT
#include "bankshot/scene/coefficients.hpp"

#include <algorithm>
#include <cmath>

namespace bankshot {
namespace {

using Places = std::vector<double*>;

/// Returns the coefficient of a restitution law that `part` names; empty names the constant.
Places of_restitution(Restitution& e, std::string_view part) {
  if (part.empty() || part == ".at_rest") return {&e.at_rest};
  if (part == ".per_speed") return {&e.per_speed};
  if (part == ".per_speed2") return {&e.per_speed2};
  return {};
}

Places of_cushion(Physics& p, std::string_view key) {
  constexpr std::string_view e = "restitution";
  if (key.starts_with(e))
    return std::visit([&](auto& law) { return of_restitution(law.restitution, key.substr(e.size())); }, p.cushion);
  for (const CushionCoefficient* c : cushion_coefficients)
    if (c->key() == key)
      if (double* const place = find_coefficient(p.cushion, *c)) return {place};
  return {};
}

Places of_cloth(Physics& p, SlideRoll& cloth, std::string_view name) {
  RollingFriction& rolling = cloth.rolling_friction;
  if (name == "sliding_friction") {
    if (double* const its = cloth_friction(p.cushion)) return {&cloth.sliding_friction, its};
    return {&cloth.sliding_friction};
  }
  if (name == "rolling_friction" || name == "rolling_friction.at_rest") return {&rolling.at_rest};
  if (name == "rolling_friction.per_speed") return {&rolling.per_speed};
  if (name == "spinning_friction") return {&cloth.spinning_friction};
  return {};
}

Places of_balls(BallBall& law, std::string_view name) {
  if (name == "restitution") return {&law.restitution};
  if (name == "friction" || name == "friction.a") return {&law.friction.fast};
  if (name == "friction.b") return {&law.friction.more};
  if (name == "friction.c") return {&law.friction.fades};
  return {};
}

double kept(std::string_view name, double value, const Body& body) {
  for (const CushionCoefficient* c : cushion_coefficients) {
    if (c->name != name) continue;
    const double inside = c->open ? 1e-6 : 0;  // an open end itself is invalid
    return std::clamp(value, (c->low + inside) * c->scale(body.radius), (c->high - inside) * c->scale(body.radius));
  }
  if (name.ends_with("restitution") || name.ends_with("restitution.at_rest")) return std::clamp(value, 0.0, 1.0);
  return name.find("restitution.") == std::string_view::npos ? std::max(value, 0.0) : value;
}

/// Returns the Cholesky factor of a covariance that may be singular. A direction without error stays without.
std::vector<double> cholesky(std::vector<double> a, std::size_t n) {
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t k = 0; k < j; ++k)
      for (std::size_t i = j; i < n; ++i) a[i * n + j] -= a[i * n + k] * a[j * n + k];
    const double root = a[j * n + j] > 0 ? std::sqrt(a[j * n + j]) : 0;
    for (std::size_t i = j; i < n; ++i) a[i * n + j] = root > 0 ? a[i * n + j] / root : 0;
  }
  return a;
}

}  // namespace

std::vector<double*> coefficient(Physics& p, std::string_view name) {
  constexpr std::string_view of_a_cushion = "cushion.", of_two_balls = "ball_ball.";
  if (name == "tilt.x") return {&p.tilt.x};
  if (name == "tilt.y") return {&p.tilt.y};
  if (is_ideal(p)) return {};
  if (name.starts_with(of_two_balls)) return of_balls(p.ball_ball, name.substr(of_two_balls.size()));
  if (auto* cloth = std::get_if<SlideRoll>(&p.motion))
    return name.starts_with(of_a_cushion) ? of_cushion(p, name.substr(of_a_cushion.size())) : of_cloth(p, *cloth, name);
  if (name == "friction") return {&std::get<Rolling>(p.motion).friction};
  return of_cushion(p, name);
}

DrawnPhysics::DrawnPhysics(const Physics& physics) : middle_(physics) {
  if (!physics.errors) return;
  names_ = physics.errors->names;
  root_ = cholesky(physics.errors->covariance, names_.size());
  middle_.errors.reset();
}

Physics DrawnPhysics::draw(const double* normal, const Body& body) const {
  Physics out = middle_;
  const std::size_t n = names_.size();
  for (std::size_t i = 0; i < n; ++i) {
    double off = 0;
    for (std::size_t k = 0; k <= i; ++k) off += root_[i * n + k] * normal[k];
    for (double* const place : coefficient(out, names_[i])) *place = kept(names_[i], *place + off, body);
  }
  return out;
}

}  // namespace bankshot
