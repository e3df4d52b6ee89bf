// SPDX-License-Identifier: MIT
#include "planners/learn/unknowns.hpp"

#include <algorithm>

#include "bankshot/scene/coefficients.hpp"

namespace bankshot::planning {

LaunchUnknowns unknowns_of(const ShotRequest& s, double start) {
  const bool spins = carries_spin(s.physics);
  return {start,       s.ball.at.x, s.ball.at.y, s.launch.speed, s.launch.angle, spins ? s.spin.top : 0,
          s.spin.side, s.spin.masse};
}

ShotRequest with_launch(ShotRequest s, const LaunchUnknowns& u) {
  s.ball.at = {u[x], u[y]};
  s.launch = {u[speed], wrap_angle(u[angle])};
  if (carries_spin(s.physics)) s.spin = {u[top], u[side], u[masse]};
  return s;
}

std::vector<Fittable> coefficients_of(const Physics& physics, const Body& body, bool meets_balls) {
  // Bounds are wider than the range of real tables; a guess is how much tables differ.
  std::vector<Fittable> known{
      {"sliding_friction", 0.02, 1, 0.1, 0},
      {"rolling_friction", 1e-4, 0.1, 0.005, 0},
      {"rolling_friction.at_rest", 1e-4, 0.1, 0.005, 0},
      {"rolling_friction.per_speed", 1e-6, 0.05, 0.003, 0},
      {"friction", 1e-4, 0.1, 0.005, 0},
      {"spinning_friction", 1e-3, 0.05, 0.01, 0},
      {"restitution", 0.05, 1, 0.1, 0},
      {"cushion.restitution", 0.05, 1, 0.1, 0},
      {"cushion.restitution.at_rest", 0.05, 1, 0.15, 0},
      {"cushion.restitution.per_speed", -0.5, 1, 0.1, 0},
      {"cushion.restitution.per_speed2", -0.5, 0.5, 0.05, 0},
      {"ball_ball.restitution", 0.5, 1, 0.05, 0},
      {"ball_ball.friction", 0, 1, 0.05, 0},
      {"ball_ball.friction.a", 0, 0.2, 0.01, 0},
      {"ball_ball.friction.b", 0, 0.5, 0.05, 0},
      {"ball_ball.friction.c", 0, 10, 0.5, 0},
      {"tilt.x", -0.05, 0.05, 0.005, 0},
      {"tilt.y", -0.05, 0.05, 0.005, 0},
  };
  for (const CushionCoefficient* c : cushion_coefficients) {
    const double scale = c->scale(body.radius);
    known.push_back({std::string(c->name), c->fit_low * scale, c->fit_high * scale, c->spread * scale, 0});
  }
  std::vector<Fittable> out;
  VariedPhysics<one_varies> varied(physics);
  for (const auto& named : varied.coefficients(meets_balls)) {
    const auto found = std::ranges::find(known, named.name, &Fittable::name);
    if (found == known.end()) continue;
    out.push_back(*found);
    out.back().start = std::clamp(named.at.front()->a, found->low, found->high);
    // A slope of 0 has no direction, so it has no derivatives.
    constexpr double hardly = 1e-6;
    if (named.name == "tilt.x") out.back().start = physics.tilt.x == 0 ? hardly : physics.tilt.x;
  }
  out.push_back({"camera.scale", 0.9, 1.1, 0.02, 1});
  out.push_back({"camera.x", -0.2, 0.2, 0.02, 0});
  out.push_back({"camera.y", -0.2, 0.2, 0.02, 0});
  return out;
}

const Fittable& Common::fittable(const std::string& name) const {
  return *std::ranges::find(known, name, &Fittable::name);
}

void Common::add(const std::string& name) {
  names.push_back(name);
  values.push_back(fittable(name).start);
}

Physics Common::physics() const {
  Physics out = base;
  for (std::size_t k = 0; k < names.size(); ++k)
    for (double* const place : coefficient(out, names[k])) *place = values[k];
  return out;
}

template <int N>
Varying<N>::Varying(const Physics& from, bool meets_balls) : physics(from), named_(physics.coefficients(meets_balls)) {}

template <int N>
std::vector<Dual<N>*> Varying<N>::places(const std::string& name) {
  if (name == "camera.scale") return {&scale};
  if (name == "camera.x") return {&offset.x};
  if (name == "camera.y") return {&offset.y};
  return std::ranges::find(named_, name, &VariedPhysics<N>::Named::name)->at;
}

template <int N>
void Varying<N>::set(const std::vector<std::string>& names, const double* values, int first) {
  if (names != names_) {
    names_ = names;
    at_.clear();
    for (const std::string& name : names) at_.push_back(places(name));
    leans = std::ranges::any_of(names, [](const std::string& name) { return name.starts_with("tilt"); });
  }
  for (std::size_t k = 0; k < at_.size(); ++k)
    for (Dual<N>* const place : at_[k])
      *place = first < 0 ? Dual<N>(values[k]) : Dual<N>(values[k], first + static_cast<int>(k));
}

template struct Varying<launch_varies>;
template struct Varying<all_vary>;

}  // namespace bankshot::planning
