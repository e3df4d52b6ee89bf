// SPDX-License-Identifier: MIT
#include "support/replay_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bankshot/simulate/trajectory.hpp"
#include "support/nearness.hpp"
#include "truth/line_in.hpp"

namespace bankshot::test {
namespace {

/// Returns true when the first `bounces` hits are those asked for; two hits at one instant may be swapped.
bool same_sequence(const std::vector<Contact>& asked, const std::vector<const Record*>& hits, std::size_t bounces) {
  if (hits.size() < bounces || asked.size() < bounces) return false;
  for (std::size_t i = 0; i < bounces; ++i) {
    if (hits[i]->contact == asked[i]) continue;
    const bool swapped = i + 1 < bounces && hits[i]->time == hits[i + 1]->time && hits[i]->contact == asked[i + 1] &&
                         hits[i + 1]->contact == asked[i];
    if (!swapped) return false;
    ++i;
  }
  return true;
}

bool same_sequence(const std::vector<Contact>& asked, const Trajectory& t, std::size_t bounces) {
  std::vector<const Record*> hits;
  for (const Record& e : t.events)
    if (e.kind == EventKind::cushion) hits.push_back(&e);
  return same_sequence(asked, hits, bounces);
}

double distance_to_path(const ShotRequest& shot, const Trajectory& t, const Vec2d& target, std::size_t bounces,
                        double& speed) {
  double best = 1e300;
  std::vector<double> hits;
  for (const Record& e : t.events)
    if (e.kind == EventKind::cushion) hits.push_back(e.time);
  for (const Leg& l : t.legs) {
    const auto before = std::count_if(hits.begin(), hits.end(), [&](double h) { return h <= l.begin; });
    if (static_cast<std::size_t>(before) != bounces) continue;
    // Ternary search on each of a few pieces: slow, but independent of the planners' geometry.
    const double end = std::min(l.duration, 1e4);
    constexpr int pieces = 8;
    for (int i = 0; i < pieces; ++i) {
      double low = end * i / pieces, high = end * (i + 1) / pieces;
      const auto off = [&](double time) { return norm(l.arc.position(time) - target); };
      for (int k = 0; k < 100; ++k) {
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        (off(a) < off(b) ? high : low) = off(a) < off(b) ? b : a;
      }
      // Rounding hides the minimum from the search at half the digits, or the search ends at the end of its piece.
      // Steps of Newton's method recover the other half.
      for (int k = 0; k < 5; ++k) {
        const Vec2d d = l.arc.position(low) - target, v = l.arc.tangent(low);
        const double better = low - dot(d, v) / (dot(v, v) + dot(d, l.arc.acceleration));
        if (better > 0 && better < end && off(better) <= off(low) * (1 + 1e-9)) low = better;
      }
      State<double> there = state_on(shot, l, low);  // the arc may be only a chord of the path
      Vec2d d = target - there.at;
      const double late = dot(d, there.velocity) / dot(there.velocity, there.velocity);
      const bool within = l.arc.chord && low + late > 0 && low + late < end;
      if (within) {
        there = state_on(shot, l, low + late);
        d = target - there.at;
      }
      const double distance = within ? std::abs(cross(there.velocity, d)) / norm(there.velocity) : norm(d);
      if (distance >= best) continue;
      best = distance;
      speed = norm(there.velocity);
    }
  }
  // A leg between two cushions met at one instant has no length, only its end.
  std::size_t k = 0;
  for (const Record& e : t.events)
    if (e.kind == EventKind::cushion && ++k == bounces && norm(e.state.at - target) < best) {
      best = norm(e.state.at - target);
      speed = norm(e.state.velocity);
    }
  return best;
}

/// Returns the bound of the puzzle that a launch breaks; empty when it keeps them all.
std::string bound_broken(const Puzzle& p, const Shot& shot) {
  constexpr double slack = 1e-9;  // rad; an aim is written in degrees
  const int n = static_cast<int>(shot.path.cushions.size());
  if (shot.launch.speed < p.speed.low || shot.launch.speed > p.speed.high) return "leaves the speed bounds";
  if (p.angle && wrap_angle(shot.launch.angle - p.angle->low + slack) > p.angle->high - p.angle->low + 2 * slack)
    return "leaves the aim's bounds";
  if (n < p.cushions.min || n > p.cushions.max) return "meets another number of cushions";
  const auto inside = [](double v, const Range& r) { return r.low - 1e-12 <= v && v <= r.high + 1e-12; };
  const SpinRange spin = p.spin_range.value_or(
      SpinRange{{p.spin.top, p.spin.top}, {p.spin.side, p.spin.side}, {p.spin.masse, p.spin.masse}});
  if (!inside(shot.spin.top, spin.top) || !inside(shot.spin.side, spin.side) || !inside(shot.spin.masse, spin.masse))
    return "has another spin than asked";
  return {};
}

/// Checks the object balls by a simulation of all balls.
Checked check_sent(const Puzzle& p, const ObjectBallTarget& asked, const Shot& shot) {
  const Then& then = asked.then;
  ShotRequest request{{}, p.table, p.physics, p.ball, p.others, shot.launch, shot.spin, {}};
  const bool rests = shot.path.arrival.speed == 0;
  request.until.time = shot.path.arrival.time * (1 + 1e-6) + 1e-6;
  const Trajectory t = simulate(request);
  const double exact = 1e-9 * p.table.diagonal(), allowed = exact + shot.verification.miss;
  if (shot.path.then.size() != 1 + then.links.size() || std::ranges::count(asked.balls, shot.path.then[0].ball) == 0)
    return {"sends no ball that is asked", 0};
  for (std::size_t i = 0; i < then.links.size(); ++i)
    if (shot.path.then[i + 1].ball != then.links[i].ball) return {"sends another ball than asked", 0};
  const int ball = shot.arriving();
  const bool is_point = std::holds_alternative<PointTarget>(then.target);
  std::vector<std::vector<const Record*>> met(1);  // by the cue ball, and by each object ball
  int on_its_way = 0;
  double hit = -1;
  const Record* fell = nullptr;
  std::vector<const Record*> in_doubt;  // a point on a cushion line is reached before or after the bounce
  for (const Record& e : t.events) {
    const bool later = e.time > shot.path.arrival.time - 1e-12;
    if (e.kind == EventKind::ball && !later) {
      const int other = e.ball == on_its_way ? e.contact.index : e.ball;
      const bool ours = e.ball == on_its_way || e.contact.index == on_its_way;
      if (!ours || met.size() > shot.path.then.size() || other != shot.path.then[met.size() - 1].ball)
        return {fmt::format("touches another ball at {} s", e.time), 0};
      met.emplace_back();
      on_its_way = other, hit = e.time;
    }
    if (e.kind == EventKind::pocket && e.ball == ball) fell = &e;
    if (e.kind == EventKind::pocket && e.ball == on_its_way && met.size() <= shot.path.then.size())
      return {"is pocketed first", 0};
    if (e.kind != EventKind::cushion || e.ball != on_its_way || !(e.time > hit)) continue;
    const bool at_arrival = hit >= 0 && std::abs(e.time - shot.path.arrival.time) < 1e-9 * std::max(1.0, e.time);
    if (at_arrival && is_point)
      in_doubt.push_back(&e);
    else if (!fell && (hit < 0 || !later || at_arrival))
      met.back().push_back(&e);
  }
  met.resize(1 + shot.path.then.size());
  Checked c;
  double miss = 0, speed = 0;
  if (const auto* point = std::get_if<PointTarget>(&then.target)) {
    const Record& end = end_of(t, ball);
    miss = rests ? norm(end.state.at - point->at) : 1e300;
    // Inside the disc, the ball may touch another ball before it is nearest; its path ends there.
    const auto ends = [&](const Record& e) {
      return e.kind == EventKind::ball && (e.ball == ball || e.contact.index == ball) && e.time > hit &&
             std::abs(e.time - shot.path.arrival.time) < 1e-9;
    };
    const bool touches = std::ranges::any_of(t.events, ends);
    for (const Leg& leg : t.legs) {
      if (rests || leg.ball != ball || (touches && miss < 1e300 && leg.begin > shot.path.arrival.time - 1e-9)) continue;
      const double s = leg.arc.parameter(shot.path.arrival.time - leg.begin);
      if (!(s >= -1e-9) || s > leg.duration + 1e-9) continue;
      const State<double> there = state_on(request, leg, s);
      const double off = norm(there.at - point->at), now = norm(there.velocity);
      const bool as_near = std::abs(off - miss) < exact;  // on both sides of a bounce
      const bool closer = std::abs(now - shot.path.arrival.speed) < std::abs(speed - shot.path.arrival.speed);
      if (as_near ? closer : off < miss) speed = now;
      miss = std::min(off, miss);
    }
    if (rests && norm(end.state.velocity) > 0) c.problem = "does not rest";
  } else {
    const auto& wanted = std::get<PocketTarget>(then.target).pocket;
    if (!fell || (wanted && fell->contact != Contact::pocket(*wanted))) return {"is not pocketed as asked", 0};
    const Boundary boundary(p.table, p.others[static_cast<std::size_t>(ball) - 1].body);
    const Circle& rim = *boundary.rim(fell->contact);
    const Vec2d v = fell->state.velocity;
    speed = norm(v);
    const double offset = cross(v, fell->state.at - rim.centre) / speed;
    miss = std::abs(offset - truth::exact_offset(boundary, rim, v, offset));
  }
  if (miss > allowed) c.problem = fmt::format("misses by {} m", miss);
  const auto differ = [](const std::vector<Contact>& wanted, const std::vector<const Record*>& hits) {
    return wanted.size() != hits.size() || !same_sequence(wanted, hits, wanted.size());
  };
  if (differ(shot.path.cushions, met[0]) || (p.cushions.sequence && differ(*p.cushions.sequence, met[0])))
    c.problem = "does not meet the cushions it names, or that are asked";
  for (std::size_t i = 0; i < shot.path.then.size(); ++i) {
    const CushionRule& rule = then.cushions_of(i);
    auto& its = met[i + 1];
    const bool last = i + 1 == shot.path.then.size();
    for (std::size_t k = 0; last && k < in_doubt.size() && its.size() < shot.path.then[i].cushions.size(); ++k)
      its.push_back(in_doubt[k]);
    if (differ(shot.path.then[i].cushions, its) || (rule.sequence && differ(*rule.sequence, its)) ||
        static_cast<int>(its.size()) < rule.min || static_cast<int>(its.size()) > rule.max)
      c.problem = "another ball does not meet the cushions it names, or that are asked";
  }
  if (const auto range = arrival_range(p); range && !rests && !shot.provenance.moved) {
    c.speed_error = std::max({0.0, range->low - speed, speed - range->high}) / std::max(1.0, range->high);
    if (c.speed_error > 1e-9) c.problem = fmt::format("arrives at {} m/s", speed);
  }
  if (const std::string broken = bound_broken(p, shot); !broken.empty()) c.problem = broken;
  return c;
}

/// Checks the first contact of the cue ball, or the second of a carom, by a simulation of all balls.
Checked check_touch(const Puzzle& p, const BallTarget& asked, const Shot& shot) {
  ShotRequest request{{}, p.table, p.physics, p.ball, p.others, shot.launch, shot.spin, {}};
  request.until.time = shot.path.arrival.time * (1 + 1e-6) + 1e-6;
  const Trajectory t = simulate(request);
  auto met = std::ranges::find(t.events, EventKind::ball, &Record::kind);
  if (met == t.events.end()) return {"touches no ball", 0};
  const int first = first_of_carom(p.target);
  if (first != 0) {
    if (met->ball != 0 || met->contact.index != first) return {"touches another ball first", 0};
    met = std::ranges::find(std::next(met), t.events.end(), EventKind::ball, &Record::kind);
    if (met == t.events.end() || met->ball != 0) return {"no second ball", 0};
  }
  const int ball = met->contact.index;
  if (std::ranges::count(asked.balls, ball) == 0) return {"touches ball " + std::to_string(ball), 0};
  const auto fell = [&](const Record& e) { return e.kind == EventKind::pocket && e.ball == 0; };
  if (std::any_of(t.events.begin(), met, fell)) return {"is pocketed first", 0};
  Vec2d before = start_state(request).velocity;
  for (const Leg& leg : t.legs)
    if (leg.ball == 0 && leg.begin < met->time) before = state_on(request, leg, leg.duration).velocity;
  const Vec2d apart = met->other.at - met->state.at;
  const double sine = cross(before, apart) / (norm(before) * norm(apart)), reach = norm(apart);
  const double miss = reach * std::abs(sine - std::sin(asked.exact_cut())),
               allowed = 1e-9 * p.table.diagonal() + shot.verification.miss;
  Checked c;
  if (miss > allowed) c.problem = fmt::format("misses the cut by {} m", miss);
  const std::size_t n = shot.path.cushions.size();
  std::vector<const Record*> bounces;
  for (auto e = t.events.begin(); e != met; ++e)
    if (e->kind == EventKind::cushion && e->ball == 0) bounces.push_back(&*e);
  if (bounces.size() != n || !same_sequence(shot.path.cushions, bounces, n) ||
      (p.cushions.sequence && !same_sequence(*p.cushions.sequence, bounces, n)))
    c.problem = "does not meet the cushions it names, or that are asked";
  if (const auto range = arrival_range(p); range && !shot.provenance.moved) {
    const double off = std::max(range->low - norm(before), norm(before) - range->high);
    c.speed_error = std::max(0.0, off) / std::max(1.0, range->high);
    if (c.speed_error > 1e-9) c.problem = fmt::format("touches at {} m/s", norm(before));
  }
  if (shot.path.hits.size() != (first != 0 ? 2U : 1U) || shot.path.hits.back().ball != ball ||
      std::abs(shot.path.hits.back().cut - std::asin(sine)) > 1e-6)
    c.problem = "says another contact";
  if (const std::string broken = bound_broken(p, shot); !broken.empty()) c.problem = broken;
  return c;
}

}  // namespace

Checked check_shot(const Puzzle& p, const Shot& shot) {
  if (const auto* sends = std::get_if<ObjectBallTarget>(&p.target)) return check_sent(p, *sends, shot);
  if (const BallTarget* const touch = touch_of(p.target)) return check_touch(p, *touch, shot);
  Checked c;
  ShotRequest request{{}, p.table, p.physics, p.ball, {}, shot.launch, shot.spin, {}};
  request.until.cushions = static_cast<int>(shot.path.cushions.size()) + 1;
  const Trajectory t = simulate(request);
  const std::size_t n = shot.path.cushions.size();
  const double allowed = 1e-9 * p.table.diagonal() + shot.verification.miss;
  double miss = 0, speed = 0;
  // With a range that includes 0, a shot with arrival speed 0 rests, and any other passes.
  const auto asked = arrival_range(p);
  const bool rests = asked && asked->low == 0 && (asked->high == 0 || shot.path.arrival.speed == 0);
  if (const auto* point = std::get_if<PointTarget>(&p.target)) {
    if (rests) {
      if (t.end != EventKind::rest || static_cast<std::size_t>(t.cushions) != n)
        c.problem = "does not rest after its bounces";
      miss = norm(t.events.back().state.at - point->at);
    } else {
      miss = distance_to_path(request, t, point->at, n, speed);
    }
  } else {
    const Record& drop = t.events.size() > 1 ? t.events[t.events.size() - 2] : t.events.back();
    const auto& wanted = std::get<PocketTarget>(p.target).pocket;
    if (t.end != EventKind::pocket || (wanted && drop.contact != Contact::pocket(*wanted)))
      return {"is not pocketed as asked", 0};
    const Boundary boundary(p.table, p.ball.body);
    const Circle& rim = *boundary.rim(drop.contact);
    speed = norm(drop.state.velocity);
    Vec2d at = drop.state.at, v = drop.state.velocity;
    // A ball that falls by the jaws is judged by the line on which it meets the first of them.
    const auto jaw = std::ranges::find_if(t.events, [&](const Record& e) {
      return e.kind == EventKind::jaw && e.contact.jaw_pocket() == drop.contact.index;
    });
    if (jaw != t.events.end()) {
      at = jaw->state.at;
      for (const Leg& leg : t.legs)
        if (leg.begin < jaw->time) v = state_on(request, leg, leg.duration).velocity;
    }
    const double offset = cross(v, at - rim.centre) / norm(v);
    miss = std::abs(offset - truth::exact_offset(boundary, rim, v, offset));
  }
  for (const Ball& other : p.others)
    if (nearest_on(t, other.at, shot.path.arrival.time) < touching_distance(p.ball.body, other.body) - allowed)
      c.problem = "touches ball " + other.id;
  if (miss > allowed) c.problem = fmt::format("misses by {} m", miss);
  if (!same_sequence(shot.path.cushions, t, n)) c.problem = "does not meet the cushions it names";
  if (p.cushions.sequence && !same_sequence(*p.cushions.sequence, t, n)) c.problem = "does not meet the cushions asked";
  if (const std::string broken = bound_broken(p, shot); !broken.empty()) c.problem = broken;
  if (asked && !rests && !shot.provenance.moved) {  // a moved shot may leave the root within what counts as made
    const double off = std::max(asked->low - speed, speed - asked->high);
    c.speed_error = std::max(0.0, off) / std::max(1.0, asked->high);
    if (c.speed_error > 1e-9) c.problem = fmt::format("arrives at {} m/s", speed);
  }
  return c;
}

}  // namespace bankshot::test
