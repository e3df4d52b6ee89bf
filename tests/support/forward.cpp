// SPDX-License-Identifier: MIT
#include "support/forward.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "support/drop.hpp"

namespace bankshot::test {
namespace {

constexpr double slowest_pass = 1e-3;  // m/s

int bounces_before(const Trajectory& t, const Leg& leg) {
  return static_cast<int>(std::count_if(t.events.begin(), t.events.end(), [&](const Record& e) {
    return e.kind == EventKind::cushion && e.time <= leg.begin;
  }));
}

struct Drop {
  int pocket;
  double left;  ///< how far the exact line lies to the left of the line of travel [m]
};

std::optional<Drop> drop_of(const Boundary& boundary, const Trajectory& t) {
  if (t.end != EventKind::pocket || t.events.size() < 2) return {};
  const Record& e = t.events[t.events.size() - 2];
  return Drop{e.contact.index, left_of_drop(boundary, e.contact, e.state.at, e.state.velocity)};
}

/// Returns true for a jaw shot. No puzzle is made from one, because planners look for shots without jaws first.
bool touches_jaws(const Trajectory& t) {
  return std::ranges::any_of(t.events, [](const Record& e) { return e.kind == EventKind::jaw; });
}

}  // namespace

std::optional<Deed> its_rest(const Trajectory& t) {
  if (touches_jaws(t)) return {};
  if (t.end != EventKind::rest || t.legs.empty()) return {};
  return Deed{PointTarget{t.events.back().state.at}, 0, t.cushions, true};
}

std::optional<Deed> passed(const ShotRequest& shot, const Trajectory& t, const Leg& leg, double p) {
  const State<double> there = state_on(shot, leg, p);
  const double speed = norm(there.velocity);
  if (touches_jaws(t)) return {};
  if (!(speed > slowest_pass)) return {};
  return Deed{PointTarget{there.at}, speed, bounces_before(t, leg), false};
}

std::optional<Deed> some_deed(Random& r, const ShotRequest& shot, const Trajectory& t, int least, int most) {
  std::optional<Deed> deed;
  if (t.legs.empty() || touches_jaws(t)) return {};
  if (t.end == EventKind::pocket) {
    const Record& e = t.events[t.events.size() - 2];
    deed = Deed{PocketTarget{e.contact.index}, norm(e.state.velocity), t.cushions, false};
  } else if (t.end == EventKind::rest && r.chance(0.5)) {
    deed = its_rest(t);
  } else {
    const Leg& leg = t.legs[static_cast<std::size_t>(r.integer(0, static_cast<int>(t.legs.size()) - 1))];
    deed = passed(shot, t, leg, std::min(leg.duration, 1e3) * r.uniform(0.05, 1));
  }
  if (deed && (deed->bounces < least || deed->bounces > most)) return {};
  return deed;
}

Made asked(Random& r, const ShotRequest& shot, const Trajectory& t, const Deed& deed) {
  Made m{
      {.table = shot.table, .physics = shot.physics, .ball = shot.ball, .spin = shot.spin}, shot.launch, deed.bounces};
  Puzzle& p = m.puzzle;
  p.target = deed.target;
  p.speed = {shot.launch.speed / 2, shot.launch.speed * 2};
  if (!deed.stops && r.chance(0.3))
    p.speed = {shot.launch.speed, shot.launch.speed};
  else if (!deed.stops && !is_ideal(shot.physics))
    p.arrive = Range{deed.arrival, deed.arrival};
  std::vector<Contact> contacts = t.sequence();
  contacts.resize(static_cast<std::size_t>(deed.bounces));
  p.cushions = r.chance(0.5) ? CushionRule::in_order(contacts) : CushionRule::exactly(deed.bounces);
  constexpr Prefer prefers[] = {Prefer::robust, Prefer::soft, Prefer::quick};
  p.prefer = prefers[r.integer(0, 2)];
  return m;
}

ShotRequest on_exact_line(const ShotRequest& shot) {
  constexpr int steps = 30;
  constexpr double first = 1e-6, exact = 1e-13;  // rad; fraction of the diagonal
  const Trajectory made = simulate(shot);
  const Boundary boundary(shot.table, shot.ball.body);
  const auto start = drop_of(boundary, made);
  if (!start) return shot;
  double a = shot.launch.angle, fa = start->left, b = a + first;
  for (int i = 0; i < steps; ++i) {
    ShotRequest turned = shot;
    turned.launch.angle = wrap_angle(b);
    const Trajectory t = simulate(turned);
    const auto drop = drop_of(boundary, t);
    if (!drop || drop->pocket != start->pocket || t.sequence() != made.sequence()) return shot;
    if (std::abs(drop->left) < exact * shot.table.diagonal()) return turned;
    const double next = b - drop->left * (b - a) / (drop->left - fa);
    if (!std::isfinite(next)) return shot;
    a = b, fa = drop->left, b = next;
  }
  return shot;
}

Made first_valid(const std::function<std::optional<Made>()>& draw) {
  for (;;) {
    try {
      if (auto made = draw()) {
        validate(made->puzzle);
        return std::move(*made);
      }
    } catch (const InvalidInput&) {
      continue;
    }
  }
}

Made ask_for_some(Random& r, int bounces, int most, const DrawShot& draw) {
  const int least = std::max(bounces, 0), limit = bounces < 0 ? most : bounces;
  return first_valid([&]() -> std::optional<Made> {
    std::optional<ShotRequest> shot = draw();
    if (!shot) return {};
    shot->until.cushions = limit + 1;
    Trajectory t = simulate(*shot);
    if (t.end == EventKind::pocket) {
      *shot = on_exact_line(*shot);
      t = simulate(*shot);
    }
    const auto deed = some_deed(r, *shot, t, least, limit);
    if (!deed) return {};
    return asked(r, *shot, t, *deed);
  });
}

std::optional<Vec2d> random_place(Random& r, const Boundary& b, const Table& table) {
  constexpr int enough = 1000;
  const Vec2d low = table.lowest(), high = table.highest();
  for (int i = 0; i < enough; ++i) {
    const Vec2d p{r.uniform(low.x, high.x), r.uniform(low.y, high.y)};
    if (b.clearance(p) >= 0 && !b.pocket_around(p)) return p;
  }
  return {};
}

bool has_spin(Model model) { return model != Model::ideal && model != Model::rolling; }

Physics usual_physics(Model model, const Body& body) {
  if (model == Model::ideal) return ideal_physics();
  if (model == Model::rolling) return rolling_physics();
  Physics p = spin_physics(body);
  if (model == Model::tilted) p.tilt = {0.002, -0.001};
  if (model == Model::stronge) p.cushion = Stronge{.height = 1.28 * body.radius};
  if (model == Model::mathavan) p.cushion = Mathavan2010{.height = 1.28 * body.radius};
  return p;
}

ShotRequest usual_shot(Random& r, Model model) {
  for (;;) {
    ShotRequest shot;
    const double kind = r.uniform(0, 1);
    shot.table = rectangle_table(2.54, 1.27);
    if (kind < 0.25) {
      shot.table = make_table(*find_table_preset("pool-9ft"));
    } else if (kind < 0.5) {
      const double length = r.log_uniform(0.5, 6);
      shot.table = rectangle_table(length, length * r.uniform(0.4, 1));
    }
    shot.physics = usual_physics(model, shot.ball.body);
    const Boundary boundary(shot.table, shot.ball.body);
    const auto at = random_place(r, boundary, shot.table);
    if (!at) continue;
    shot.ball.at = *at;
    if (has_spin(model)) shot.spin = {r.uniform(-1, 1.2), r.uniform(-1, 1), r.chance(0.2) ? r.uniform(-0.5, 0.5) : 0};
    shot.launch = {r.log_uniform(0.3, 8), radians(r.uniform(0, 360))};
    return shot;
  }
}

}  // namespace bankshot::test
