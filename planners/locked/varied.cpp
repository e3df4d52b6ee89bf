// SPDX-License-Identifier: MIT
#include "planners/locked/varied.hpp"

#include "planners/settings.hpp"

namespace bankshot::planning {
namespace {

RestitutionOf<Varied> varied(const Restitution& e) {
  return {Varied(e.at_rest), Varied(e.per_speed), Varied(e.per_speed2)};
}

VariedCushion varied(const CushionVariant& cushion) {
  struct Of {
    VariedLaw operator()(const Mirror& c) const { return MirrorOf<Varied>{varied(c.restitution)}; }
    VariedLaw operator()(const Han2005& c) const {
      return Han2005Of<Varied>{Varied(c.height), varied(c.restitution), Varied(c.friction)};
    }
    VariedLaw operator()(const Mathavan2010& c) const {
      return VariedMathavan{c, varied(c.restitution), Varied(c.height), Varied(c.friction), Varied(c.sliding_friction)};
    }
    VariedLaw operator()(const Stronge& c) const {
      return StrongeOf<Varied>{Varied(c.height), varied(c.restitution), Varied(c.friction), Varied(c.frequency_ratio)};
    }
    VariedLaw operator()(const CustomCushion& c) const { return c; }
  };
  return {std::visit(Of{}, cushion)};
}

TiltedOf<Varied> varied_motion(const Physics& physics) {
  const Tilted plain = tilted(physics);
  TiltedOf<Varied> out;
  out.sliding_friction = Varied(plain.sliding_friction);
  out.rolling_friction = {Varied(plain.rolling_friction.at_rest), Varied(plain.rolling_friction.per_speed)};
  out.spinning_friction = Varied(plain.spinning_friction);
  out.g = plain.g;
  out.always_rolls = plain.always_rolls;
  const bool level = is_level(physics);
  out.rise = {Varied(level ? settings::sensitivity::least_rise : plain.rise.x), Varied(plain.rise.y)};
  return out;
}

}  // namespace

void VariedMathavan::bounce(const Body& body, State<Varied>& s, const Vec2d& away) const {
  Mathavan2010 law = plain;
  law.restitution = {restitution.at_rest.a, restitution.per_speed.a, restitution.per_speed2.a};
  law.friction = friction.a;
  const State<double> before{value(s.at), value(s.velocity), {s.spin.x.a, s.spin.y.a, s.spin.z.a}};
  law.bounce(body, s, away);
  const auto add = [&](double& coefficient, const Varied& varied) {
    if (varied.v[0] == 0) return;
    const double middle = coefficient, step = settings::sensitivity::difference;
    const auto after = [&](double its) {
      State<double> end = before;
      coefficient = its;
      law.bounce(body, end, away);
      return end;
    };
    const State<double> low = after(middle - step), high = after(middle + step);
    coefficient = middle;
    const double by = varied.v[0] / (2 * step);
    const auto move = [&](Varied& x, double from, double to) { x.v[0] += (to - from) * by; };
    move(s.velocity.x, low.velocity.x, high.velocity.x);
    move(s.velocity.y, low.velocity.y, high.velocity.y);
    move(s.spin.x, low.spin.x, high.spin.x);
    move(s.spin.y, low.spin.y, high.spin.y);
    move(s.spin.z, low.spin.z, high.spin.z);
  };
  add(law.restitution.at_rest, restitution.at_rest);
  add(law.restitution.per_speed, restitution.per_speed);
  add(law.restitution.per_speed2, restitution.per_speed2);
  add(law.height, height);
  add(law.friction, friction);
  add(law.sliding_friction, sliding_friction);
}

VariedPhysics::VariedPhysics(const Physics& physics)
    : ideal(is_ideal(physics)),
      level(is_level(physics)),
      motion(varied_motion(physics)),
      cushion(varied(physics.cushion)) {
  const BallBall law = collisions(physics);
  balls = {Varied(law.restitution),
           {Varied(law.friction.fast), Varied(law.friction.more), Varied(law.friction.fades)},
           law.lasts};
}

std::vector<VariedPhysics::Named> VariedPhysics::coefficients(bool meets_balls) {
  std::vector<Named> out;
  if (ideal) return out;
  const bool spins = !motion.always_rolls;
  const auto restitution = [&](const std::string& name, RestitutionOf<Varied>& e) {
    if (e.constant()) return out.push_back({name, {&e.at_rest}});
    out.push_back({name + ".at_rest", {&e.at_rest}});
    out.push_back({name + ".per_speed", {&e.per_speed}});
    if (e.per_speed2.a != 0) out.push_back({name + ".per_speed2", {&e.per_speed2}});
  };
  RollingFrictionOf<Varied>& rolling = motion.rolling_friction;
  if (spins) {
    out.push_back({"sliding_friction", {&motion.sliding_friction}});
    if (auto* c = std::get_if<VariedMathavan>(&cushion.law)) out.back().at.push_back(&c->sliding_friction);
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
    BallFrictionOf<Varied>& f = balls.friction;
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

}  // namespace bankshot::planning
