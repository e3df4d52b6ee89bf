// SPDX-License-Identifier: MIT
#include "planners/locked/varied.hpp"

#include "planners/settings.hpp"

namespace bankshot::planning {
namespace {

template <class C>
RestitutionOf<C> varied(const Restitution& e) {
  return {C(e.at_rest), C(e.per_speed), C(e.per_speed2)};
}

template <class C>
VariedCushion<C> varied(const CushionVariant& cushion) {
  struct Of {
    VariedLaw<C> operator()(const Mirror& c) const { return MirrorOf<C>{varied<C>(c.restitution)}; }
    VariedLaw<C> operator()(const Han2005& c) const {
      return Han2005Of<C>{C(c.height), varied<C>(c.restitution), C(c.friction)};
    }
    VariedLaw<C> operator()(const Mathavan2010& c) const {
      return VariedMathavan<C>{
          {C(c.height), varied<C>(c.restitution), C(c.friction), C(c.sliding_friction), c.tolerance}};
    }
    VariedLaw<C> operator()(const Stronge& c) const {
      return StrongeOf<C>{C(c.height), varied<C>(c.restitution), C(c.friction), C(c.frequency_ratio)};
    }
    VariedLaw<C> operator()(const CustomCushion& c) const { return c; }
  };
  return {std::visit(Of{}, cushion)};
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

/// Any of its derivatives.
template <class C>
bool varies(const C& x) {
  for (int k = 0; k < static_cast<int>(sizeof(x.v) / sizeof(double)); ++k)
    if (x.v[static_cast<std::size_t>(k)] != 0) return true;
  return false;
}

/// Bounces with derivatives by the first M of nine numbers: velocity, spin, restitution at this speed, height,
/// friction, friction of the cloth.
template <int M, class C>
void bounce_in(const VariedMathavan<C>& law, const Body& body, State<C>& s, const Vec2d& away) {
  using Few = Dual<M>;
  const C before[] = {s.velocity.x, s.velocity.y, s.spin.x,
                      s.spin.y,     s.spin.z,     law.restitution(-dot(to<C>(away), s.velocity)),
                      law.height,   law.friction, law.sliding_friction};
  const auto few = [&](int k) {
    const double its = before[static_cast<std::size_t>(k)].a;
    return k < M ? Few(its, k) : Few(its);
  };
  State<Few> end{to<Few>(value(s.at)), {few(0), few(1)}, {few(2), few(3), few(4)}};
  Mathavan2010Of<Few>{few(6), {few(5)}, few(7), few(8), law.tolerance}.bounce(body, end, away);
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

template <class C>
void VariedMathavan<C>::bounce(const Body& body, State<C>& s, const Vec2d& away) const {
  constexpr int of_ball = 6, all = 9;
  if (varies(this->height) || varies(this->friction) || varies(this->sliding_friction))
    bounce_in<all>(*this, body, s, away);
  else
    bounce_in<of_ball>(*this, body, s, away);
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
    if (auto* c = std::get_if<VariedMathavan<C>>(&cushion.law)) out.back().at.push_back(&c->sliding_friction);
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
        if constexpr (!std::is_same_v<std::decay_t<decltype(law)>, CustomCushion>)
          restitution(of_cushion + "restitution", law.restitution);
        if constexpr (requires { law.height; }) {
          out.push_back({"cushion.friction", {&law.friction}});
          out.push_back({"cushion.height", {&law.height}});
        }
        if constexpr (requires { law.frequency_ratio; })
          out.push_back({"cushion.frequency_ratio", {&law.frequency_ratio}});
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

template struct VariedMathavan<Dual<one_varies>>;
template struct VariedMathavan<Dual<launch_varies>>;
template struct VariedMathavan<Dual<all_vary>>;
template struct VariedPhysics<one_varies>;
template struct VariedPhysics<launch_varies>;
template struct VariedPhysics<all_vary>;

}  // namespace bankshot::planning
