// SPDX-License-Identifier: MIT
#include "support/family_makers.hpp"

#include <algorithm>
#include <cmath>

#include "bankshot/geometry/boundary.hpp"
#include "support/forward.hpp"

namespace bankshot::test::make {
namespace {

/// Returns the parameter at which a rolling ball has slowed down to `speed` on a leg.
std::optional<double> when_slowed_to(const Leg& leg, double speed) {
  double fast = 0, slow = leg.duration;
  if (norm(leg.arc.velocity_at(fast)) <= speed) return {};
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    const double p = (fast + slow) / 2;
    (norm(leg.arc.velocity_at(p)) > speed ? fast : slow) = p;
  }
  return fast;
}

/// Draws a place on a random cushion line, sometimes in the corner at its end.
Vec2d on_cushion(Random& r, const Boundary& b, Vec2d& along) {
  const Wall& w = b.walls[static_cast<std::size_t>(r.integer(0, static_cast<int>(b.walls.size()) - 1))];
  along = w.along;
  return w.from + (w.to - w.from) * (r.chance(0.2) ? 0 : r.uniform(0, 1));
}

/// Returns the parameter at which a leg is `gap` from the cushion that it leaves or meets.
std::optional<double> beside_cushion(Random& r, const Boundary& b, const Leg& leg, double gap) {
  double near = r.chance(0.5) ? 0 : leg.duration, far = leg.duration / 2;
  const auto off = [&](double p) { return b.clearance(leg.arc.position(p)); };
  if (!(off(near) < gap && off(far) > gap)) return {};
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    const double p = (near + far) / 2;
    (off(p) < gap ? near : far) = p;
  }
  return near;
}

/// Draws a straight shot to a place on a cushion line, which it passes or rests on.
std::optional<Made> straight_to_line(Random& r, ShotRequest shot) {
  const Boundary boundary(shot.table, shot.ball.body);
  Vec2d along{};
  const Vec2d target = on_cushion(r, boundary, along), way = target - shot.ball.at;
  const double length = norm(way);
  if (!(length > 0.1) || is_ideal(shot.physics)) return {};
  shot.spin.side = shot.spin.masse = 0;  // so that the path does not curve
  shot.launch = {1, wrap_angle(std::atan2(way.y, way.x))};
  // The path to rest is proportional to the square of the launch speed, so one shot on a huge table gives all of them.
  ShotRequest open = shot;
  open.table = rectangle_table(1e3, 1e3);
  open.ball.at = {500, 500};
  const Trajectory t = simulate(open);
  const double to_rest = std::sqrt(length / t.length);
  Deed deed{PointTarget{target}, 0, 0, true};
  if (r.chance(0.7)) {
    shot.launch.speed = to_rest * r.log_uniform(1.05, 3);
    open.launch = shot.launch;
    open.until.length = length;
    deed = {PointTarget{target}, norm(simulate(open).events.back().state.velocity), 0, false};
  } else {
    shot.launch.speed = to_rest;
  }
  shot.until.cushions = 1;
  const Trajectory seen = simulate(shot);
  if (seen.end == EventKind::pocket) return {};
  return asked(r, shot, seen, deed);
}

}  // namespace

Made slow_friction(Random& r, Model model, int bounces) {
  return first_valid([&]() -> std::optional<Made> {
    const bool carom = r.chance(0.3);
    const TablePreset& preset = *find_table_preset("carom-10ft");
    ShotRequest shot = usual_shot(r, has_spin(model) ? model : Model::spin);
    if (carom) {
      shot.table = make_table(preset);
      shot.ball.body = preset.body;
      shot.physics = spin_physics(preset.body, preset.nose());
      const auto at = random_place(r, Boundary(shot.table, shot.ball.body), shot.table);
      shot.ball.at = at.value();
    }
    auto& motion = std::get<SlideRoll>(shot.physics.motion);
    motion.rolling_friction = RollingFriction{r.log_uniform(0.003, 0.03), r.log_uniform(1e-4, 0.05)};
    const int most = bounces < 0 ? 3 : bounces;
    shot.until.cushions = most + 1;
    const Trajectory t = simulate(shot);
    if (t.end != EventKind::rest || t.legs.empty()) return {};
    const double slow = r.log_uniform(2e-3, 0.1);
    const auto p = when_slowed_to(t.legs.back(), slow);
    if (!p) return {};
    const auto deed = r.chance(0.2) ? its_rest(t) : passed(shot, t, t.legs.back(), *p);
    if (!deed || deed->bounces < bounces || deed->bounces > most) return {};
    return asked(r, shot, t, *deed);
  });
}

Made frozen(Random& r, Model model, int bounces) {
  return ask_for_some(r, bounces, 3, [&] {
    ShotRequest shot = usual_shot(r, model);
    if (r.chance(0.3)) {
      shot.table = random_polygon(r, true);
      shot.table.pockets.clear();
    }
    Vec2d along{};
    shot.ball.at = on_cushion(r, Boundary(shot.table, shot.ball.body), along);
    return std::optional(shot);
  });
}

Made rail_hugging(Random& r, Model model, int bounces) {
  constexpr double least = 1e-5, widest = 1e-3;
  const int most = bounces < 0 ? 3 : bounces;
  return first_valid([&]() -> std::optional<Made> {
    ShotRequest shot = usual_shot(r, model);
    if (r.chance(0.5)) {  // nearly along a cushion, so that the last leg is too
      const double off = r.log_uniform(1e-3, 0.3);
      shot.launch.angle = wrap_angle(radians(90) * r.integer(0, 3) + (r.chance(0.5) ? off : -off));
    }
    shot.until.cushions = most + 1;
    const Trajectory t = simulate(shot);
    if (t.legs.empty()) return {};
    const Boundary boundary(shot.table, shot.ball.body);
    std::optional<Deed> deed = its_rest(t);
    const auto hugs = [&] {
      const double gap = deed ? boundary.clearance(std::get<PointTarget>(deed->target).at) : 0;
      return least < gap && gap < widest;
    };
    if (!hugs()) {
      const Leg& leg = t.legs[static_cast<std::size_t>(r.integer(0, static_cast<int>(t.legs.size()) - 1))];
      const auto p = beside_cushion(r, boundary, leg, r.log_uniform(least, widest));
      deed = p ? passed(shot, t, leg, *p) : std::nullopt;
    }
    if (!deed || deed->bounces < bounces || deed->bounces > most) return {};
    return asked(r, shot, t, *deed);
  });
}

Made hexagon(Random& r, Model model, int bounces) {
  return ask_for_some(r, bounces, 3, [&] {
    ShotRequest shot = usual_shot(r, model);
    const int n = r.integer(5, 8);
    const double size = r.log_uniform(0.5, 2), crooked = r.chance(0.4) ? 0 : r.log_uniform(1e-9, 1e-2);
    std::vector<Vec2d> v;
    for (int i = 0; i < n; ++i) {
      const double angle = radians(360) * (i + crooked * r.uniform(-1, 1)) / n;
      v.push_back({size * std::cos(angle), size * std::sin(angle)});
    }
    shot.table = polygon_table(std::move(v));
    const auto at = random_place(r, Boundary(shot.table, shot.ball.body), shot.table);
    shot.ball.at = r.chance(0.2) ? Vec2d{0, 0} : at.value();
    return std::optional(shot);
  });
}

Made on_line(Random& r, Model model, int bounces) {
  const int most = bounces < 0 ? 3 : bounces;
  return first_valid([&]() -> std::optional<Made> {
    ShotRequest shot = usual_shot(r, model);
    if (bounces <= 0 && r.chance(0.4)) return straight_to_line(r, shot);
    shot.until.cushions = most + 1;
    const Trajectory t = simulate(shot);
    if (t.cushions == 0) return {};
    // The point is the end of a leg at a cushion, passed before or after the bounce.
    const int k = r.integer(1, t.cushions);
    int seen = 0;
    for (const Record& e : t.events) {
      if (e.kind != EventKind::cushion || ++seen != k) continue;
      Deed deed{PointTarget{e.state.at}, norm(e.state.velocity), k, false};
      if (r.chance(0.5)) {
        const auto leg = std::find_if(t.legs.rbegin(), t.legs.rend(), [&](const Leg& l) { return l.begin < e.time; });
        if (leg == t.legs.rend()) return {};
        deed.arrival = norm(leg->arc.velocity_at(leg->duration));
        --deed.bounces;
      }
      if (deed.bounces < bounces || deed.bounces > most || !(deed.arrival > 1e-3)) return {};
      return asked(r, shot, t, deed);
    }
    return {};
  });
}

}  // namespace bankshot::test::make
