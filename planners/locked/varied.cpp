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
Restitution plain(const RestitutionOf<C>& e) {
  return {e.at_rest.a, e.per_speed.a, e.per_speed2.a};
}

template <class C>
VariedCushion<C> varied(const CushionVariant& cushion) {
  struct Of {
    VariedLaw<C> operator()(const Mirror& c) const { return MirrorOf<C>{varied<C>(c.restitution)}; }
    VariedLaw<C> operator()(const Han2005& c) const {
      return Han2005Of<C>{C(c.height), varied<C>(c.restitution), C(c.friction)};
    }
    VariedLaw<C> operator()(const Mathavan2010& c) const {
      return VariedMathavan<C>{c, varied<C>(c.restitution), C(c.height), C(c.friction), C(c.sliding_friction)};
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

/// Bounces with the five derivatives that an impact has, and chains those of the state through them: the impact is
/// integrated, and in few derivatives that is quick.
template <class C>
void chain(const Mathavan2010& law, const Body& body, State<C>& s, const Vec2d& away) {
  using Few = Dual<5>;
  C* const members[] = {&s.velocity.x, &s.velocity.y, &s.spin.x, &s.spin.y, &s.spin.z};
  State<Few> few{to<Few>(value(s.at)),
                 {Few(s.velocity.x.a, 0), Few(s.velocity.y.a, 1)},
                 {Few(s.spin.x.a, 2), Few(s.spin.y.a, 3), Few(s.spin.z.a, 4)}};
  law.bounce(body, few, away);
  const Few* const ends[] = {&few.velocity.x, &few.velocity.y, &few.spin.x, &few.spin.y, &few.spin.z};
  const C before[] = {*members[0], *members[1], *members[2], *members[3], *members[4]};
  for (std::size_t i = 0; i < std::size(members); ++i) {
    C end(ends[i]->a);
    for (std::size_t k = 0; k < std::size(before); ++k) end += (before[k] - before[k].a) * ends[i]->v[k];
    *members[i] = end;
  }
}

/// Any of its derivatives.
template <class C>
bool varies(const C& x) {
  for (int k = 0; k < static_cast<int>(sizeof(x.v) / sizeof(double)); ++k)
    if (x.v[static_cast<std::size_t>(k)] != 0) return true;
  return false;
}

}  // namespace

template <class C>
Mathavan2010 VariedMathavan<C>::law() const {
  Mathavan2010 out = origin;
  out.restitution = plain(restitution);
  out.height = height.a;
  out.friction = friction.a;
  out.sliding_friction = sliding_friction.a;
  return out;
}

template <class C>
void VariedMathavan<C>::bounce(const Body& body, State<C>& s, const Vec2d& away) const {
  Mathavan2010 changed = law();
  const State<double> before = value(s);
  chain(changed, body, s, away);
  const auto add = [&](double& coefficient, const C& varied) {
    if (!varies(varied)) return;
    const double middle = coefficient, step = settings::sensitivity::difference;
    const auto after = [&](double its) {
      State<double> end = before;
      coefficient = its;
      changed.bounce(body, end, away);
      return end;
    };
    const State<double> low = after(middle - step), high = after(middle + step);
    coefficient = middle;
    const auto move = [&](C& x, double from, double to) { x += (varied - varied.a) * ((to - from) / (2 * step)); };
    move(s.velocity.x, low.velocity.x, high.velocity.x);
    move(s.velocity.y, low.velocity.y, high.velocity.y);
    move(s.spin.x, low.spin.x, high.spin.x);
    move(s.spin.y, low.spin.y, high.spin.y);
    move(s.spin.z, low.spin.z, high.spin.z);
  };
  add(changed.restitution.at_rest, restitution.at_rest);
  add(changed.restitution.per_speed, restitution.per_speed);
  add(changed.restitution.per_speed2, restitution.per_speed2);
  add(changed.height, height);
  add(changed.friction, friction);
  add(changed.sliding_friction, sliding_friction);
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
