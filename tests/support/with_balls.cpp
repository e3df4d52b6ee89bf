// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>

#include "bankshot/geometry/boundary.hpp"
#include "support/family_makers.hpp"
#include "support/nearness.hpp"

namespace bankshot::test::make {
namespace {

/// Returns true when a ball can stand there, outside every pocket.
bool stands(const Boundary& boundary, const Vec2d& at) {
  return !(boundary.clearance(at) < 0) && !boundary.pocket_around(at);
}

/// Draws a ball that the path does not touch: anywhere, or beside the path with a gap of as little as a nanometre.
std::optional<Ball> beside_path(Random& r, const Puzzle& p, const Trajectory& t) {
  Ball ball{{}, p.ball.body, std::to_string(p.others.size() + 1)};
  if (r.chance(0.2)) ball.body.radius *= r.uniform(0.7, 1.25);
  const double apart = touching_distance(p.ball.body, ball.body);
  const Vec2d low = p.table.lowest(), high = p.table.highest();
  ball.at = {r.uniform(low.x, high.x), r.uniform(low.y, high.y)};
  if (r.chance(0.6)) {
    const Leg& leg = t.legs[static_cast<std::size_t>(r.integer(0, static_cast<int>(t.legs.size()) - 1))];
    const double s = leg.duration * r.uniform(0, 1);
    const Vec2d v = leg.arc.tangent(s), left = perpendicular(v) / norm(v);
    ball.at = leg.arc.position(s) + left * ((r.chance(0.5) ? 1 : -1) * (apart + r.log_uniform(1e-9, 0.05)));
  }
  const auto clear = [&](const Ball& other) {
    return norm(ball.at - other.at) >= touching_distance(other.body, ball.body);
  };
  if (!stands(Boundary(p.table, ball.body), ball.at) || !std::ranges::all_of(p.others, clear)) return {};
  if (nearest_on(t, ball.at) < apart + 5e-10) return {};
  return ball;
}

/// Scatters balls over the table.
void scatter(Random& r, Puzzle& p) {
  const Vec2d low = p.table.lowest(), high = p.table.highest();
  const int count = r.integer(1, 7);
  for (int tries = 0; tries < 200 && static_cast<int>(p.others.size()) < count; ++tries) {
    Ball ball{{}, p.ball.body, std::to_string(p.others.size() + 1)};
    if (r.chance(0.2)) ball.body.radius *= r.uniform(0.7, 1.25);
    ball.at = {r.uniform(low.x, high.x), r.uniform(low.y, high.y)};
    const auto clear = [&](const Ball& o) { return norm(ball.at - o.at) >= touching_distance(o.body, ball.body); };
    if (!stands(Boundary(p.table, ball.body), ball.at) || !clear(p.ball)) continue;
    if (std::ranges::all_of(p.others, clear)) p.others.push_back(ball);
  }
}

}  // namespace

Made kicks(Random& r, Model model, int bounces) {
  for (;;) {
    Made made = random_puzzle(r, families[r.integer(0, 2)], model, bounces);
    Puzzle& p = made.puzzle;
    if (!(p.ball.body.radius > 0)) continue;
    scatter(r, p);
    if (p.others.empty()) continue;
    ShotRequest shot{{}, p.table, p.physics, p.ball, p.others, made.launch, p.spin, {}};
    shot.until.cushions = (bounces < 0 ? most_bounces : bounces) + 1;
    const Trajectory t = simulate(shot);
    const auto met = std::ranges::find(t.events, EventKind::ball, &Record::kind);
    const auto other = [](const Record& e) { return e.kind == EventKind::pocket || e.kind == EventKind::jaw; };
    if (met == t.events.end() || std::any_of(t.events.begin(), met, other)) continue;
    made.bounces = static_cast<int>(
        std::count_if(t.events.begin(), met, [](const Record& e) { return e.kind == EventKind::cushion; }));
    if (bounces >= 0 && made.bounces != bounces) continue;
    Vec2d before = start_state(shot).velocity;
    for (const Leg& leg : t.legs)
      if (leg.ball == 0 && leg.begin < met->time) before = leg.arc.velocity_at(leg.duration);
    const Vec2d apart = met->other.at - met->state.at;
    const double cut = std::atan2(cross(before, apart), dot(before, apart)), speed = norm(before);
    if (!(speed > 1e-3) || !(std::abs(cut) < radians(89.99))) continue;
    p.target = BallTarget{.balls = {met->contact.index}, .cut = cut};
    p.arrive.reset();
    p.speed = {made.launch.speed / 2, made.launch.speed * 2};
    if (r.chance(0.4))
      p.speed = {made.launch.speed, made.launch.speed};
    else if (!is_ideal(p.physics))
      p.arrive = Range{speed, speed};
    std::vector<Contact> contacts = t.sequence();
    contacts.resize(static_cast<std::size_t>(made.bounces));
    p.cushions = r.chance(0.5) ? CushionRule::in_order(contacts) : CushionRule::exactly(made.bounces);
    return made;
  }
}

namespace {

/// The result of a chain of object balls that touches nothing else.
struct Sent {
  int ball = 0;  ///< the first object ball
  int before = 0;
  std::vector<Contact> cushions{};  ///< of the cue ball
  Then then{};
  double arrival = 0;
};

CushionRule some_rule(Random& r, const std::vector<Contact>& cushions) {
  return r.chance(0.5) ? CushionRule::in_order(cushions) : CushionRule::exactly(static_cast<int>(cushions.size()));
}

/// Reads the chain from a trajectory. `links` is the number of contacts between object balls.
std::optional<Sent> sent_by(Random& r, const Trajectory& t, std::size_t links, std::size_t most) {
  Sent s;
  std::vector<Contact> its;
  int on_its_way = 0;
  double hit = 0, end = forever;
  const Record* fell = nullptr;
  const Record* rest = nullptr;
  for (const Record& e : t.events) {
    if (e.kind == EventKind::start || e.kind == EventKind::slide_to_roll) continue;
    if (e.kind == EventKind::ball) {
      const bool ours = e.ball == on_its_way || e.contact.index == on_its_way;
      const int other = e.ball == on_its_way ? e.contact.index : e.ball;
      if (on_its_way == 0 && ours) {
        s.ball = other;
      } else if (ours && other != 0 && s.then.links.size() < links && other != s.ball) {
        if (its.size() > most) return {};
        s.then.links.push_back({some_rule(r, its), other});
      } else {
        end = e.time;
        break;
      }
      on_its_way = other, hit = e.time;
      its.clear();
      continue;
    }
    if (s.ball == 0) {
      if (e.kind != EventKind::cushion) return {};
      s.cushions.push_back(e.contact);
      continue;
    }
    if (e.ball != on_its_way) continue;
    if (e.kind == EventKind::jaw) {
      end = e.time;
      break;
    }
    if (e.kind == EventKind::cushion && e.time > hit) its.push_back(e.contact);
    if (e.kind == EventKind::pocket) {
      fell = &e;
      break;
    }
    if (e.kind == EventKind::rest) {
      rest = &e;
      end = e.time;  // it may be touched again
      break;
    }
  }
  s.before = static_cast<int>(s.cushions.size());
  if (s.ball == 0 || s.then.links.size() < links) return {};
  if (fell) {
    s.then.target = PocketTarget{fell->contact.index};
    s.arrival = norm(fell->state.velocity);
  } else if (rest && r.chance(0.5)) {
    s.then.target = PointTarget{rest->state.at};
  } else {
    std::vector<const Leg*> legs;
    for (const Leg& leg : t.legs)
      if (leg.ball == on_its_way && leg.begin >= hit && leg.begin + leg.arc.seconds(leg.duration) <= end)
        legs.push_back(&leg);
    if (legs.empty()) return {};
    const Leg& leg = *legs[static_cast<std::size_t>(r.integer(0, static_cast<int>(legs.size()) - 1))];
    const double p = leg.duration * r.uniform(0.05, 1);
    s.then.target = PointTarget{leg.arc.position(p)};
    s.arrival = norm(leg.arc.velocity_at(p));
    if (!(s.arrival > 1e-3)) return {};
    const auto bounced = [&](const Record& e) {
      return e.ball == on_its_way && e.kind == EventKind::cushion && e.time > hit && e.time <= leg.begin;
    };
    its.resize(std::min(its.size(), static_cast<std::size_t>(std::ranges::count_if(t.events, bounced))));
  }
  if (its.size() > most) return {};
  s.then.cushions = some_rule(r, its);
  return s;
}

enum class Wanted { any, pocket, rest };

/// Draws a shot that sends object balls on. `before` and `after` are the bounces of the cue ball and of the last ball,
/// -1 for any up to three.
Made sends(Random& r, Model model, int before, int after, Wanted wanted, std::size_t links = 0) {
  for (;;) {
    Made made = random_puzzle(r, families[r.integer(0, 1)], model);
    Puzzle& p = made.puzzle;
    if (!(p.ball.body.radius > 0) || (wanted == Wanted::pocket && p.table.pockets.empty())) continue;
    scatter(r, p);
    if (p.others.empty()) continue;
    for (int tries = 0; tries < 40; ++tries) {
      const Ball& ball = p.others[static_cast<std::size_t>(r.integer(0, static_cast<int>(p.others.size()) - 1))];
      const Vec2d way = ball.at - p.ball.at;
      made.launch = {r.log_uniform(0.3, 8), radians(r.uniform(0, 360))};
      if (before == 0 || (before < 0 && r.chance(0.5)))
        made.launch.angle = wrap_angle(std::atan2(way.y, way.x) +
                                       std::asin(std::min(1.0, touching_distance(ball.body, p.ball.body) / norm(way))) *
                                           r.uniform(-1, 1));
      ShotRequest shot{{}, p.table, p.physics, p.ball, p.others, made.launch, p.spin, {}};
      if (is_ideal(p.physics)) shot.until.cushions = 20;
      const Trajectory t = simulate(shot);
      const auto s = sent_by(r, t, links, 3);
      if (!s || (before >= 0 ? s->before != before : s->before > 3) || (after >= 0 && s->then.cushions->max != after))
        continue;
      const auto* point = std::get_if<PointTarget>(&s->then.target);
      if ((wanted == Wanted::pocket && point) || (wanted == Wanted::rest && (!point || s->arrival > 0))) continue;
      p.target = ObjectBallTarget{.balls = {s->ball}, .then = s->then};
      p.arrive.reset();
      p.speed = {made.launch.speed / 2, made.launch.speed * 2};
      if (s->arrival > 0 && r.chance(0.3))
        p.speed = {made.launch.speed, made.launch.speed};
      else if (!is_ideal(p.physics))
        p.arrive = Range{s->arrival, s->arrival};
      made.bounces = s->before;
      p.cushions = some_rule(r, s->cushions);
      return made;
    }
  }
}

/// Returns the first two ball contacts when the cue ball touches two different balls.
std::optional<std::pair<const Record*, const Record*>> two_contacts(const Trajectory& t) {
  const Record* first = nullptr;
  for (const Record& e : t.events) {
    if (e.kind == EventKind::pocket || e.kind == EventKind::jaw) return {};
    if (e.kind != EventKind::ball) continue;
    if (e.ball != 0 || (first && first->contact == e.contact)) return {};
    if (first) return std::pair(first, &e);
    first = &e;
  }
  return {};
}

}  // namespace

Made pots(Random& r, Model model, int) { return sends(r, model, 0, 0, Wanted::pocket); }
Made banks(Random& r, Model model, int cushions) {
  return sends(r, model, 0, cushions < 0 ? r.integer(1, 3) : cushions, Wanted::pocket);
}
Made kick_pots(Random& r, Model model, int cushions) {
  return sends(r, model, cushions < 0 ? r.integer(1, 2) : cushions, 0, Wanted::pocket);
}
Made kick_banks(Random& r, Model model, int cushions) {
  const int n = cushions < 0 ? r.integer(1, 2) : cushions;
  return sends(r, model, n, n, Wanted::pocket);
}
Made sent_to_rest(Random& r, Model model, int cushions) { return sends(r, model, -1, cushions, Wanted::rest); }
Made sent_past(Random& r, Model model, int) { return sends(r, model, -1, -1, Wanted::any); }

Made combinations(Random& r, Model model, int) {
  return sends(r, model, r.chance(0.7) ? 0 : 1, -1, Wanted::any, r.chance(0.85) ? 1 : 2);
}

Made caroms(Random& r, Model model, int bounces) {
  for (;;) {
    Made made = random_puzzle(r, families[r.integer(0, 1)], model);
    Puzzle& p = made.puzzle;
    if (!(p.ball.body.radius > 0)) continue;
    scatter(r, p);
    for (int tries = 0; tries < 40 && p.others.size() > 1; ++tries) {
      made.launch = {r.log_uniform(0.5, 8), radians(r.uniform(0, 360))};
      ShotRequest shot{{}, p.table, p.physics, p.ball, p.others, made.launch, p.spin, {}};
      shot.until.cushions = 8;
      const Trajectory t = simulate(shot);
      const auto met = two_contacts(t);
      if (!met) continue;
      const Record& second = *met->second;
      std::vector<Contact> contacts;
      for (const Record& e : t.events)
        if (e.kind == EventKind::cushion && e.ball == 0 && &e < &second) contacts.push_back(e.contact);
      made.bounces = static_cast<int>(contacts.size());
      if (made.bounces > 6 || (bounces >= 0 && made.bounces != bounces)) continue;
      Vec2d before{};
      for (const Leg& leg : t.legs)
        if (leg.ball == 0 && leg.begin < second.time) before = leg.arc.velocity_at(leg.duration);
      const Vec2d apart = second.other.at - second.state.at;
      const double cut = std::atan2(cross(before, apart), dot(before, apart)), speed = norm(before);
      if (!(speed > 1e-2) || !(std::abs(cut) < radians(89.99))) continue;
      CaromTarget target{met->first->contact.index, {.balls = {second.contact.index}}};
      if (r.chance(0.5)) target.second.cut = cut, target.second.within = radians(5.0);
      p.target = target;
      p.arrive.reset();
      p.speed = {made.launch.speed / 2, made.launch.speed * 2};
      if (r.chance(0.3))
        p.speed = {made.launch.speed, made.launch.speed};
      else if (!is_ideal(p.physics))
        p.arrive = r.chance(0.5) ? Range{speed, speed} : Range{0.2, std::max(5.0, speed)};
      if (p.arrive && !p.arrive->fixed() && speed < p.arrive->low) p.arrive->low = speed / 2;
      p.cushions = some_rule(r, contacts);
      return made;
    }
  }
}

Made obstacles(Random& r, Model model, int bounces) {
  for (;;) {
    Made made = random_puzzle(r, families[r.integer(0, 2)], model, bounces);
    Puzzle& p = made.puzzle;
    if (!(p.ball.body.radius > 0)) continue;
    ShotRequest shot{{}, p.table, p.physics, p.ball, {}, made.launch, p.spin, {}};
    shot.until.cushions = made.bounces + 1;
    const Trajectory t = simulate(shot);
    const int count = r.integer(1, 8);
    for (int tries = 0; tries < 100 && static_cast<int>(p.others.size()) < count; ++tries)
      if (const auto ball = beside_path(r, p, t)) p.others.push_back(*ball);
    if (!p.others.empty()) return made;
  }
}

}  // namespace bankshot::test::make
