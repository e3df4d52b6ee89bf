// SPDX-License-Identifier: MIT
#include "truth/hard_cases.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "bankshot/simulate/trajectory.hpp"

namespace bankshot::truth {
namespace {

constexpr double R = 0.028575;
using Cases = std::vector<HardCase>;

HardCase hard(std::string what, const ShotRequest& shot) {
  return {std::move(what), shot.table, shot.ball.body.radius, shot.physics, start_state(shot)};
}

/// Shots from the middle to the end of the second cushion, with an aim `off` radians beside it.
Cases corners() {
  Cases out;
  for (const Table& table : {rectangle_table(2, 1), polygon_table({{0, 0}, {2, 0}, {2.3, 1.1}, {0, 1}}),
                             polygon_table({{0, 0}, {2, 0}, {1.7, 1}, {0, 1}})})
    for (const double off :
         {0.0, 1e-16, -1e-16, 1e-15, -1e-15, 1e-13, -1e-13, 1e-10, -1e-10, 1e-6, -1e-6, 1e-3, -1e-3}) {
      ShotRequest shot = spin_shot({1, 0.5}, 2, 0);
      shot.table = table;
      const Vec2d d = Boundary(table, {R}).walls[1].to - shot.ball.at;
      shot.launch.angle = wrap_angle(std::atan2(d.y, d.x) + off);
      out.push_back(hard(fmt::format("aim {} beside the corner", off), shot));
    }
  return out;
}

/// Slides that end within 20 units in the last place of the cushion.
Cases coincidence() {
  Cases out;
  const double v = 2, slide = 12 * v * v / (49 * 0.2 * 9.81);
  for (int ulps = -20; ulps <= 20; ++ulps)
    out.push_back(
        hard(fmt::format("{} units before the cushion", ulps), spin_shot({2 - R - slide + ulps * 0x1p-52, 0.5}, v, 0)));
  return out;
}

/// Balls that move to the bottom cushion while friction pushes them away. The vertex of the parabola lies just beyond
/// the line, or just before it.
Cases curving() {
  Cases out;
  const SlideRoll motion;
  const double a = motion.sliding_friction * motion.g, vn = 0.25, turn = vn * vn / (2 * a);
  for (double depth = 1e-1; depth > 1e-14; depth /= 10)
    for (const double sign : {1.0, -1.0}) {
      const Vec2d v{0.2, -vn}, slip{0, -8};
      const State<double> start{{1, R + turn * (1 - sign * depth)}, v, {(slip.y - v.y) / R, (v.x - slip.x) / R, 0}};
      out.push_back({fmt::format("vertex {} of vn^2/2a beyond the line", sign * depth),
                     rectangle_table(2, 1),
                     R,
                     {motion, Mirror{0.9}},
                     start,
                     3});
    }
  return out;
}

Cases frozen() {
  Cases out;
  for (const double gap : {0.0, 1e-16, 1e-15, 1e-14, 1e-13, 1e-12, 2e-12, 1e-11, 1e-10, 1e-9})
    for (const double aim : {0.0, 1e-9, 0.5, 60.0, 90.0, 180.0, 200.0, 270.0, 359.9, 360 - 1e-6})
      for (const LaunchSpin& s : {LaunchSpin{}, LaunchSpin{.top = 1}, LaunchSpin{.top = -1.5, .side = 1},
                                  LaunchSpin{.masse = 2}, LaunchSpin{.masse = -2}})
        out.push_back(hard(fmt::format("gap {}, aim {}, spin {} {} {}", gap, aim, s.top, s.side, s.masse),
                           spin_shot({0.7, R + gap}, 1.5, aim, s)));
  return out;
}

/// Grazing bounces; the position of the bounce and the position of rest are tested.
Cases grazing() {
  Cases out;
  for (const double angle : {1e-1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10})
    for (const double reach : {0.1, 0.7, 0.9})
      for (const double top : {0.0, 1.0}) {
        ShotRequest shot = spin_shot({0.5, R + angle * reach}, 3, 0, {.top = top, .side = 0.3});
        shot.launch.angle = wrap_angle(-angle);
        HardCase c = hard(fmt::format("angle {}, reach {}, topspin {}", angle, reach, top), shot);
        out.push_back(c);
        c.cushions = 1;
        out.push_back(c);
      }
  return out;
}

Cases many_bounces() {
  Cases out;
  for (const int n : {20, 200, 2000, 20000}) {
    const ShotRequest shot{.table = rectangle_table(2.54, 1.27),
                           .physics = ideal_physics(),
                           .ball = {{0.635, 0.4}, R, 0.17},
                           .launch = {1, radians(53.1)}};
    HardCase c = hard(fmt::format("{} bounces", n), shot);
    c.cushions = n;
    c.events = 1000000;
    out.push_back(c);
  }
  return out;
}

Cases many_bounces_with_spin() {
  Cases out;
  for (const double e : {1.0, 0.98, 0.9}) {
    ShotRequest shot = spin_shot({0.635, 0.4}, 10, 53.1, {.top = 1});
    shot.physics = {SlideRoll{.rolling_friction = 0.001}, Mirror{e}};
    out.push_back(hard(fmt::format("restitution {}", e), shot));
    out.back().cushions = 300;
  }
  return out;
}

constexpr double R_ell = 0.0285;

ShotRequest towards_vertex(Vec2d from, double off, const Physics& physics) {
  const Vec2d d = Vec2d{1, 1} - from;
  return {.table = polygon_table({{0, 0}, {2, 0}, {2, 2}, {1, 2}, {1, 1}, {0, 1}}),
          .physics = physics,
          .ball = {from, R_ell, 0.17},
          .launch = {3, wrap_angle(std::atan2(d.y, d.x) + off)}};
}

Cases reflex() {
  Cases out;
  for (int i = -40; i <= 40; ++i)
    for (const LaunchSpin& spin :
         {LaunchSpin{}, LaunchSpin{.top = 1}, LaunchSpin{.top = -1, .side = 0.5, .masse = 0.5}}) {
      ShotRequest shot = towards_vertex({1.7, 0.2}, i * 1e-3, spin_physics({R_ell}));
      shot.spin = spin;
      out.push_back(hard(fmt::format("aim {} mrad beside the vertex", i), shot));
      out.back().cushions = 6;
    }
  return out;
}

/// Lines of travel that pass a vertex at R (1 ± δ). Those at R (1 − δ) hit it.
Cases grazing_vertex() {
  Cases out;
  for (double delta = 1e-2; delta > 1e-13; delta /= 10)
    for (const double sign : {1.0, -1.0}) {
      const Vec2d from{0.2, 0.2};
      const double beside = std::asin(R_ell * (1 + sign * delta) / norm(Vec2d{1, 1} - from));
      out.push_back(hard(fmt::format("passes at R (1 + {})", sign * delta),
                         towards_vertex(from, -beside, {Rolling{}, Mirror{0.9}})));
      out.back().cushions = 2;
    }
  return out;
}

Cases slip() {
  Cases out;
  for (const double delta : {1e-16, 2e-16, 5e-16, 1e-15, 2e-15, 1e-14, 1e-12, 1e-9, 1e-6, 1e-3})
    for (const double by : {delta, -delta}) {
      out.push_back(
          hard(fmt::format("topspin 1 + {}", by), spin_shot({0.3, 0.4}, 3, 10, {.top = 1 + by, .side = 0.5})));
      out.push_back(hard(fmt::format("masse {}", by), spin_shot({0.3, 0.4}, 3, 10, {.top = 1, .masse = by})));
    }
  return out;
}

Cases speeds() {
  Cases out;
  for (double v = 1e-6; v <= 30; v *= 3.1)
    for (const double aim : {3.0, 77.0, 211.0})
      for (const LaunchSpin& spin :
           {LaunchSpin{}, LaunchSpin{.top = 1.2, .side = -0.8}, LaunchSpin{.top = -1, .masse = 0.5}})
        out.push_back(hard(fmt::format("{} m/s, aim {}", v, aim), spin_shot({0.5, 0.3}, v, aim, spin)));
  return out;
}

/// One scene with lengths scaled by s and speeds by √s, and shifted.
Cases tables() {
  Cases out;
  constexpr double radius = 0.03125;
  for (const double s : {1e-3, 1e-2, 0.3, 7.0, 1e2, 1e3})
    for (const Vec2d& by : {Vec2d{0, 0}, Vec2d{1e-3, -1}, Vec2d{-100, 37}, Vec2d{1e4, -1e4}}) {
      if (norm(by) > 1e6 * s) continue;  // far from the origin, a small table has too few digits left
      Physics physics = spin_physics({radius * s});
      std::get<UsualCushion>(physics.cushion).height = 1.25 * radius * s;
      std::get<SlideRoll>(physics.motion).spinning_friction = 0.015;
      const ShotRequest shot{.table = polygon_table({Vec2d{0, 0} * s + by, Vec2d{2, 0} * s + by,
                                                     Vec2d{2.25, 1} * s + by, Vec2d{0, 1.125} * s + by}),
                             .physics = physics,
                             .ball = {Vec2d{0.5, 0.375} * s + by, {radius * s, 0.17}},
                             .launch = {3 * std::sqrt(s), radians(33)},
                             .spin = {.top = -0.5, .side = 0.75, .masse = 0.25}};
      out.push_back(hard(fmt::format("size {}, at {} {}", s, by.x, by.y), shot));
    }
  return out;
}

Cases endless() {
  Cases out;
  for (const double e : {0.0, 1e-12, 0.01, 0.1, 0.2, 0.3, 0.39, 0.4, 0.41})
    for (const double aim : {270.0, 269.0, 240.0, 200.0, 181.0}) {
      ShotRequest shot = spin_shot({1, 0.3}, 1.5, aim, {.top = 1});
      shot.physics.cushion = Mirror{e};
      out.push_back(hard(fmt::format("restitution {}, aim {}", e, aim), shot));
    }
  return out;
}

/// μr = 0.01 + b v, with b from values hidden by rounding to values that stop the ball within centimetres.
Cases friction_by_speed() {
  Cases out;
  for (const double b : {1e-18, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 1e-2, 1e-1, 1.0, 10.0})
    for (const double aim : {3.0, 33.0, 211.0})
      for (const LaunchSpin& spin : {LaunchSpin{.top = 1}, LaunchSpin{.top = -0.5, .side = 0.5, .masse = 0.3}}) {
        ShotRequest shot = spin_shot({0.5, 0.3}, 3, aim, spin);
        std::get<SlideRoll>(shot.physics.motion).rolling_friction = {0.01, b};
        out.push_back(hard(fmt::format("per speed {} s/m, aim {}, topspin {}", b, aim, spin.top), shot));
      }
  return out;
}

/// Cushions whose impacts are integrated. The cases have natural roll, whose slip on the cloth is 0; side spin that the
/// nose removes in the end; paths nearly along the cushion; and straight impacts, where both slips reach 0 at one
/// instant.
Cases integrated_impacts() {
  Cases out;
  for (const double aim : {270.0, 269.999999, 250.0, 225.0, 200.0, 183.0, 180.01})
    for (const double e : {0.0, 0.5, 0.85, 1.0})
      for (const LaunchSpin& spin : {LaunchSpin{.top = 1}, LaunchSpin{}, LaunchSpin{.top = 1, .side = 1.2},
                                     LaunchSpin{.top = -0.5, .side = -0.4}}) {
        ShotRequest shot = spin_shot({1.2, 0.3}, 1.5, aim, spin);
        shot.physics.cushion = FullestCushion{.height = 1.28 * R, .restitution = Restitution{e}};
        out.push_back(hard(fmt::format("aim {}, restitution {}, top {}, side {}", aim, e, spin.top, spin.side), shot));
        out.back().cushions = 4;
      }
  return out;
}

struct Class {
  std::string_view name;
  Cases (*cases)();
};

constexpr Class classes[] = {{"grazing", grazing},
                             {"corners", corners},
                             {"frozen to a cushion", frozen},
                             {"curving back", curving},
                             {"slip near 0", slip},
                             {"slide ends at a bounce", coincidence},
                             {"endless bouncing", endless},
                             {"speeds", speeds},
                             {"tables", tables},
                             {"many bounces", many_bounces},
                             {"many bounces with spin", many_bounces_with_spin},
                             {"reflex vertices", reflex},
                             {"grazing a reflex vertex", grazing_vertex},
                             {"friction by speed", friction_by_speed},
                             {"integrated impacts", integrated_impacts}};

}  // namespace

ShotRequest spin_shot(Vec2d at, double speed, double degrees_, LaunchSpin spin) {
  return {.table = rectangle_table(2, 1),
          .physics = spin_physics(),
          .ball = {at, R, 0.17},
          .launch = {speed, radians(degrees_)},
          .spin = spin};
}

std::vector<std::string_view> hard_classes() {
  std::vector<std::string_view> names;
  for (const Class& c : classes) names.push_back(c.name);
  return names;
}

Cases hard_cases(std::string_view name) {
  for (const Class& c : classes)
    if (c.name == name) return c.cases();
  throw std::invalid_argument(fmt::format("\"{}\" is no class of hard cases", name));
}

Compared compare_with_truth(const HardCase& c) {
  const Boundary boundary(c.table, {c.radius});
  return compare_with_truth({boundary, c.physics, c.start, c.cushions, c.events});
}

}  // namespace bankshot::truth
