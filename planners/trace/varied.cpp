// SPDX-License-Identifier: MIT
#include "planners/trace/varied.hpp"
#include "bankshot/simulate/with_physics.hpp"

#include <array>
#include <cstddef>

#include "planners/settings.hpp"

namespace bankshot::planning {
namespace {

template <class C>
VariedLaw<C> varied_law(const CustomCushion& law) {
  return law;
}
template <class C, template <class> class Law>
VariedLaw<C> varied_law(const Law<double>& law) {
  return typename VariedAs<C, Law<double>>::type{with_numbers<C>(law)};
}

template <class C>
VariedCushion<C> varied(const CushionVariant& cushion) {
  return {std::visit([](const auto& law) { return varied_law<C>(law); }, cushion)};
}

template <class C>
TiltedOf<C> varied_motion(const Physics& physics) {
  const Tilted from = tilted(physics);
  TiltedOf<C> out;
  out.sliding_friction = C(from.sliding_friction);
  out.rolling_friction = {C(from.rolling_friction.at_rest), C(from.rolling_friction.per_speed)};
  out.spinning_friction = C(from.spinning_friction);
  out.g = from.g;
  out.always_rolls = from.always_rolls;
  const bool level = is_level(physics);
  out.rise = {C(level ? settings::sensitivity::least_rise : from.rise.x), C(from.rise.y)};
  return out;
}

/// Returns whether any derivative of x is not 0.
template <class C>
bool varies(const C& x) {
  for (int k = 0; k < static_cast<int>(sizeof(x.v) / sizeof(double)); ++k)
    if (x.v[static_cast<std::size_t>(k)] != 0) return true;
  return false;
}

constexpr int of_ball = 6;  // velocity, spin, and the restitution at this speed
template <template <class> class Law, class C>
constexpr int of_impact = of_ball + static_cast<int>(count_numbers<Law<C>>());

/// Computes a bounce with derivatives by the first M of the numbers of the ball and of the law.
template <int M, template <class> class Law, class C>
void bounce_in(const Chained<Law, C>& law, const Body& body, State<C>& s, const Vec2d& away) {
  using Few = Dual<M>;
  std::array<C, of_impact<Law, C>> before{s.velocity.x, s.velocity.y, s.spin.x,
                                          s.spin.y,     s.spin.z,     law.restitution(-dot(to<C>(away), s.velocity))};
  std::size_t next = of_ball;
  for_each_number(law, [&](const C& number) { before[next++] = number; });
  const auto few = [&](int k) {
    const double its = before[static_cast<std::size_t>(k)].a;
    return k < M ? Few(its, k) : Few(its);
  };
  State<Few> end{to<Few>(value(s.at)), {few(0), few(1)}, {few(2), few(3), few(4)}};
  Law<Few> of_few;
  of_few.restitution = {few(5)};
  of_few.tolerance = law.tolerance;
  int k_of_law = of_ball;
  for_each_number(of_few, [&](Few& number) { number = few(k_of_law++); });
  of_few.bounce(body, end, away);
  const auto chain = [&](C& out, const Few& of) {
    out = C(of.a);
    for (std::size_t k = 0; k < M; ++k) out += (before[k] - before[k].a) * of.v[k];
  };
  chain(s.velocity.x, end.velocity.x);
  chain(s.velocity.y, end.velocity.y);
  chain(s.spin.x, end.spin.x);
  chain(s.spin.y, end.spin.y);
  chain(s.spin.z, end.spin.z);
}

}  // namespace

template <template <class> class Law, class C>
void Chained<Law, C>::bounce(const Body& body, State<C>& s, const Vec2d& away) const {
  bool any = false;
  for_each_number(*this, [&](const C& number) { any = any || varies(number); });
  if (any)
    bounce_in<of_impact<Law, C>>(*this, body, s, away);
  else
    bounce_in<of_ball>(*this, body, s, away);
}

template <class C>
template <class N>
void VariedCushion<C>::bounce(const Body& body, State<C>& s, const Vec2<N>& away) const {
  std::visit([&](const auto& cushion) { cushion.bounce(body, s, away); }, law);
}

template <int N>
VariedPhysics<N>::VariedPhysics(const Physics& physics)
    : origin(physics),
      level(is_level(physics)),
      motion(varied_motion<C>(physics)),
      cushion(varied<C>(physics.cushion)) {
  const BallBall law = collisions(physics);
  balls = {C(law.restitution), {C(law.friction.fast), C(law.friction.more), C(law.friction.fades)}, law.lasts};
}

template <int N>
std::vector<typename VariedPhysics<N>::Named> VariedPhysics<N>::coefficients(bool meets_balls) {
  std::vector<Named> out;
  if (is_ideal(origin)) return out;
  const bool spins = !motion.always_rolls;
  const auto restitution = [&](const std::string& name, RestitutionOf<C>& e) {
    if (e.constant()) return out.push_back({name, {&e.at_rest}});
    out.push_back({name + ".at_rest", {&e.at_rest}});
    out.push_back({name + ".per_speed", {&e.per_speed}});
    if (e.per_speed2.a != 0) out.push_back({name + ".per_speed2", {&e.per_speed2}});
  };
  RollingFrictionOf<C>& rolling = motion.rolling_friction;
  if (spins) {
    out.push_back({"sliding_friction", {&motion.sliding_friction}});
    const auto add = [&]([[maybe_unused]] auto& law) {
      if constexpr (requires { law.sliding_friction; }) out.back().at.push_back(&law.sliding_friction);
    };
    std::visit(add, cushion.law);
  }
  if (rolling.per_speed.a == 0) {
    out.push_back({spins ? "rolling_friction" : "friction", {&rolling.at_rest}});
  } else {
    out.push_back({"rolling_friction.at_rest", {&rolling.at_rest}});
    out.push_back({"rolling_friction.per_speed", {&rolling.per_speed}});
  }
  if (spins) out.push_back({"spinning_friction", {&motion.spinning_friction}});
  const std::string of_cushion = spins ? "cushion." : "";
  std::visit(
      [&](auto& law) {
        if constexpr (!std::is_same_v<std::decay_t<decltype(law)>, CustomCushion>) {
          restitution(of_cushion + "restitution", law.restitution);
          for_each_coefficient(law, [&](const CushionCoefficient& c, C& place) {
            out.push_back({std::string(c.name), {&place}});
          });
        }
      },
      cushion.law);
  if (meets_balls) {
    out.push_back({"ball_ball.restitution", {&balls.restitution}});
    BallFrictionOf<C>& f = balls.friction;
    if (f.constant()) {
      if (spins) out.push_back({"ball_ball.friction", {&f.fast}});
    } else {
      out.push_back({"ball_ball.friction.a", {&f.fast}});
      out.push_back({"ball_ball.friction.b", {&f.more}});
      out.push_back({"ball_ball.friction.c", {&f.fades}});
    }
  }
  out.push_back({"tilt.x", {&motion.rise.x}});
  out.push_back({"tilt.y", {&motion.rise.y}});
  return out;
}

template <int N>
using Varies = VariedCushion<Dual<N>>;
template void Varies<one_varies>::bounce(const Body&, State<Dual<one_varies>>&, const Vec2d&) const;
template void Varies<one_varies>::bounce(const Body&, State<Dual<one_varies>>&, const Vec2<Dual<one_varies>>&) const;
template void Varies<launch_varies>::bounce(const Body&, State<Dual<launch_varies>>&, const Vec2d&) const;
template void Varies<launch_varies>::bounce(const Body&, State<Dual<launch_varies>>&,
                                            const Vec2<Dual<launch_varies>>&) const;
template void Varies<all_vary>::bounce(const Body&, State<Dual<all_vary>>&, const Vec2d&) const;
template void Varies<all_vary>::bounce(const Body&, State<Dual<all_vary>>&, const Vec2<Dual<all_vary>>&) const;
template struct VariedPhysics<one_varies>;
template struct VariedPhysics<launch_varies>;
template struct VariedPhysics<all_vary>;

}  // namespace bankshot::planning
