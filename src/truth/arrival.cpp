// SPDX-License-Identifier: MIT
#include "truth/arrival.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>

#include "bankshot/numbers/tolerances.hpp"
#include "truth/follow.hpp"

namespace bankshot::truth {
namespace {

/// Two bounces less apart than this are one instant to a run in double [s].
constexpr double one_instant = 1e-12;

/// Two at one instant match in either order.
bool same_order(const std::vector<Contact>& asked, const std::vector<const TruthEvent*>& met) {
  if (asked.size() != met.size()) return false;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    if (met[i]->contact == asked[i]) continue;
    const bool swapped = i + 1 < asked.size() && met[i + 1]->time - met[i]->time <= one_instant &&
                         met[i]->contact == asked[i + 1] && met[i + 1]->contact == asked[i];
    if (!swapped) return false;
    ++i;
  }
  return true;
}

Path beside(Run run, double turned, double pushed) {
  run.turned = turned, run.pushed = pushed;
  return run_truth(run);
}

/// Up to and with event `last`.
bool same_events(const Path& a, const Path& b, std::size_t last) {
  if (a.events.size() <= last || b.events.size() <= last) return false;
  for (std::size_t i = 0; i <= last; ++i)
    if (a.events[i].kind != b.events[i].kind || a.events[i].contact != b.events[i].contact) return false;
  return true;
}

/// The event whose arc arrives: after n bounces, the nearest to the time claimed.
std::size_t arriving(const Path& path, int n, double time, bool stops) {
  std::optional<std::size_t> best;
  const auto late = [&](std::size_t i) {
    return std::abs((stops ? path.events[i].time : path.events[i].passing.time) - time);
  };
  int bounces = 0;
  for (std::size_t i = 0; i < path.events.size(); ++i) {
    if (bounces == n && (!best || late(i) < late(*best))) best = i;
    bounces += path.events[i].kind == EventKind::cushion;
  }
  return best.value_or(path.events.size());
}

/// Of a ball that is sent on: the arc on which it arrives, the last where it falls, or the event of its rest.
std::size_t arriving_of(const Path& path, int ball, double time, bool stops) {
  const auto falls = [&](const TruthEvent& e) { return e.ball == ball && e.kind == EventKind::pocket; };
  const auto fall = std::ranges::find_if(path.events, falls);
  if (fall != path.events.end() && fall != path.events.begin() && fall->time - time <= one_instant * (1 + time) * 1e3)
    return static_cast<std::size_t>(fall - path.events.begin()) - 1;
  std::optional<std::size_t> best;
  const auto late = [&](std::size_t i) {
    return std::abs((stops ? path.events[i].time : path.events[i].passing.time) - time);
  };
  for (std::size_t i = 0; i < path.events.size(); ++i)
    if (path.events[i].ball == ball && path.events[i].kind == (stops ? EventKind::rest : EventKind::slide_to_roll) &&
        (!best || late(i) < late(*best)))
      best = i;
  return best.value_or(path.events.size());
}

/// Metres between two arrivals: of where the ball rests, or across the line of travel.
double apart(const TruthEvent& a, const TruthEvent& b, bool stops) {
  if (stops) return norm((a.state.at - b.state.at) + (a.at_rest - b.at_rest));
  return std::abs((a.passing.lateral - b.passing.lateral) + (a.passing.lateral_rest - b.passing.lateral_rest));
}

}  // namespace

struct Scene::Goal {
  int min, max;
  const std::vector<Contact>* sequence;
  const Onward* then = nullptr;  ///< what the ball that is sent on is to do; null: as the puzzle asks
  double time;                   ///< s, when the arrival is claimed; of several passes the nearest to it counts
  double slack = 0;              ///< m, beyond `within`
};

/// Lines in one direction into a pocket.
class LineIn {
 public:
  LineIn(const Boundary& boundary, const Circle& rim, const Vec2d& heading)
      : boundary_(boundary), rim_(rim), u_(heading / norm(heading)), left_{-u_.y, u_.x} {}

  bool enters(double offset) const {
    const auto least = room(offset);
    return least && *least >= -boundary_.touch;
  }

  std::optional<double> room(double offset) const {
    if (!(std::abs(offset) <= rim_.radius)) return {};
    const double ahead = std::sqrt(std::max(rim_.radius * rim_.radius - offset * offset, 0.0));
    const Vec2d entry = rim_.centre + left_ * offset - u_ * ahead;
    const auto at = [&](double back) { return boundary_.clearance(entry - u_ * back); };
    if (boundary_.jaws.empty()) return at(0);
    double low = 0, high = 0;  // m back to the table
    for (const Wall& w : boundary_.walls) {
      const double inside = dot(w.normal, entry) - w.offset, slope = -dot(w.normal, u_);
      if (inside < 0 && !(slope > 0)) return {};
      if (inside < 0) high = std::max(high, -inside / slope);
    }
    constexpr int samples = 48, halvings = 60;
    double least = at(0), nearest = 0;
    for (int i = 1; i <= samples; ++i)
      if (const double r = at(high * i / samples); r < least) least = r, nearest = high * i / samples;
    low = std::max(0.0, nearest - high / samples), high = std::min(high, nearest + high / samples);
    for (int i = 0; i < halvings; ++i) {
      const double a = low + (high - low) * 0.4, b = low + (high - low) * 0.6;
      (at(a) < at(b) ? high : low) = at(a) < at(b) ? b : a;
    }
    return std::min(least, at(low));
  }

  /// Of lines from `in`, which enters, towards `out`: the last that does.
  double last(double in, double out) const {
    constexpr int steps = 100;
    const double from = in, to = out;
    for (int i = 1; i <= steps; ++i) {
      out = from + (to - from) * i / steps;
      if (enters(out)) {
        in = out;
        continue;
      }
      for (double middle = (in + out) / 2; middle != in && middle != out; middle = (in + out) / 2)
        (enters(middle) ? in : out) = middle;
      return in;
    }
    return to;
  }

 private:
  const Boundary& boundary_;
  const Circle& rim_;
  Vec2d u_, left_;
};

std::optional<double> room_of_line(const Boundary& boundary, const Circle& rim, const Vec2d& heading, double offset) {
  return LineIn(boundary, rim, heading).room(offset);
}

double exact_offset(const Boundary& boundary, const Circle& rim, const Vec2d& heading, double own) {
  if (rim.radius <= tolerance::point_pocket * boundary.diagonal) return 0;
  const LineIn line(boundary, rim, heading);
  constexpr int grid = 400;
  std::optional<double> in;
  const bool enters = line.enters(own);
  if (enters) in = own;
  for (int i = 0; i <= grid && !enters; ++i) {
    const double offset = rim.radius * (2.0 * i / grid - 1);
    if ((!in || std::abs(offset - own) < std::abs(*in - own)) && line.enters(offset)) in = offset;
  }
  if (!in) return NAN;
  const double low = line.last(*in, -rim.radius), high = line.last(*in, rim.radius), eighth = (high - low) / 8;
  return std::clamp(0.0, low + eighth, high - eighth);
}

Scene::Scene(const Puzzle& p) : puzzle(p), boundary(p.table, p.ball.body, p.others), physics_(refined(p.physics)) {
  const auto asked = arrival_range(p);
  const Then* const then = then_of(p.target);
  const bool point =
      then ? std::holds_alternative<PointTarget>(then->target) : std::holds_alternative<PointTarget>(p.target);
  stops_ = point && asked && asked->high == 0;
  if (then)
    for (const Ball& other : p.others) others_.emplace_back(p.table, other.body);
}

Run Scene::run(const Launch& launch, const LaunchSpin& spin, int cushions) const {
  Run r{boundary, physics_,
        launched(puzzle.ball.at, puzzle.ball.body.radius, direction(launch.angle) * launch.speed, spin), cushions + 1,
        4L * cushions + 100};
  const Then* const then = then_of(puzzle.target);
  const auto* point = then ? std::get_if<PointTarget>(&then->target) : std::get_if<PointTarget>(&puzzle.target);
  if (point) r.target = point->at;
  return r;
}

ShotRequest Scene::request_of(const Launch& launch, const LaunchSpin& spin) const {
  return {{}, puzzle.table, puzzle.physics, puzzle.ball, puzzle.others, launch, spin, {}};
}

Path Scene::truth_of(const Launch& launch, const LaunchSpin& spin, int cushions, double turned, double pushed) const {
  Run r = run(launch, spin, cushions);
  r.turned = turned, r.pushed = pushed;
  const ShotRequest all = request_of(launch, spin);
  if (then_of(puzzle.target)) r.all = &all;
  return run_truth(r);
}

Path Scene::double_of(const Launch& launch, const LaunchSpin& spin, int cushions) const {
  Run r = in_double(launch, spin, cushions);
  const ShotRequest all = request_of(launch, spin);
  if (then_of(puzzle.target)) r.all = &all;
  return run_double(r);
}

const Boundary& Scene::boundary_of(int ball) const {
  return ball == 0 ? boundary : *std::next(others_.begin(), ball - 1);
}

Arrived Scene::at_point(Arrived a, const Passing& p) const {
  a.why = "";
  a.time = p.time, a.speed = p.speed, a.passed = p.miss, a.at = p.at;
  return a;
}

double Scene::miss(const Arrived& there) const {
  if (!there.taken_by) return there.passed;
  const Circle& rim = *boundary_of(there.ball).rim(there.taken_by);
  if (const auto* ball = std::get_if<BallTarget>(&puzzle.target); ball && !ball->then)
    return std::abs(there.offset + rim.radius * std::sin(ball->cut));
  return std::abs(there.offset - exact_offset(boundary_of(there.ball), rim, there.heading, there.offset));
}

Arrived Scene::taken(Arrived a, const TruthEvent& e, const TruthEvent& line) const {
  a.why = "";
  a.time = e.time, a.speed = norm(e.state.velocity), a.at = e.state.at;
  const Circle& rim = *boundary_of(e.ball).rim(e.contact);
  a.taken_by = e.contact;
  a.offset = -line.passing.lateral;
  a.heading = line.passing.velocity;
  if (rim.radius > 0) a.incidence = std::sqrt(std::max(1 - std::pow(e.passing.lateral / rim.radius, 2), 1e-12));
  return a;
}

Arrived Scene::judge_sent(const Path& path, const Goal& goal) const {
  const BallTarget& asked = std::get<BallTarget>(puzzle.target);
  const Then& then = *asked.then;
  const auto* point = std::get_if<PointTarget>(&then.target);
  const CushionRule rule = goal.then ? CushionRule::in_order(goal.then->cushions) : then.cushions;
  const double within = point ? point->within + goal.slack : 0;
  Arrived out;
  std::vector<const TruthEvent*> met, its;
  const TruthEvent *hit = nullptr, *jaw = nullptr;
  bool found = false;
  const auto fails = [&](std::string why) {
    if (!found) out.why = std::move(why);
    return out;
  };
  const auto counts = [&] {
    return static_cast<int>(its.size()) >= rule.min && (!rule.sequence || same_order(*rule.sequence, its));
  };
  for (const TruthEvent& e : path.events) {
    if (!hit) {
      if (e.ball != 0 || e.kind == EventKind::slide_to_roll) continue;
      if (e.kind == EventKind::cushion) {
        if (static_cast<int>(met.size()) == goal.max)
          return fails(fmt::format("meets {} before the ball", contact_name(puzzle.table, e.contact)));
        met.push_back(&e);
        out.cushions.push_back(e.contact);
      } else if (e.kind == EventKind::ball) {
        out.in_order = !goal.sequence || same_order(*goal.sequence, met);
        const bool wanted =
            std::ranges::count(asked.balls, e.contact.index) > 0 && !(goal.then && goal.then->ball != e.contact.index);
        if (!wanted || static_cast<int>(met.size()) < goal.min)
          return fails(fmt::format("runs into {}", contact_name(puzzle, e.contact)));
        hit = &e;
        out.ball = e.contact.index;
        out.hit = e.passing;
      } else if (e.kind != EventKind::jaw) {
        return fails("touches no ball");
      }
      continue;
    }
    const bool ours = e.ball == 0 || e.ball == out.ball || e.contact == Contact::ball(out.ball);
    if (e.kind == EventKind::ball && ours) return fails(fmt::format("touches {}", contact_name(puzzle, e.contact)));
    if (e.ball != out.ball) continue;
    if (point && !stops_ && counts() && e.kind == EventKind::slide_to_roll && e.passing.miss <= within &&
        (!found || std::abs(e.passing.time - goal.time) < std::abs(out.time - goal.time))) {
      out = at_point(std::move(out), e.passing);
      found = true;
    }
    switch (e.kind) {
      case EventKind::cushion:
        if (!(e.time > hit->time)) break;
        if (static_cast<int>(its.size()) == rule.max || found)
          return fails(fmt::format("sends it to {} before the target", contact_name(puzzle.table, e.contact)));
        its.push_back(&e);
        out.onward.push_back(e.contact);
        break;
      case EventKind::jaw:
        if (!jaw) jaw = &e;
        out.rattles = true;
        break;
      case EventKind::pocket: {
        const auto* pocket = std::get_if<PocketTarget>(&then.target);
        if (!pocket || (pocket->pocket && Contact::pocket(*pocket->pocket) != e.contact) || !counts())
          return fails(fmt::format("sends it into pocket {}", contact_name(puzzle.table, e.contact)));
        return taken(std::move(out), e, jaw ? *jaw : e);
      }
      case EventKind::rest: {
        if (!stops_ || !counts()) return fails("sends it not as far as the target");
        const double miss = norm((e.state.at - point->at) + e.at_rest);
        if (miss > within) return fails(fmt::format("sends it to rest {:.6g} m from the target", miss));
        return at_point(std::move(out), {.time = e.time, .speed = 0, .at = e.state.at, .velocity = {}, .miss = miss});
      }
      default:
        break;
    }
  }
  return fails("sends it past the target");
}

Arrived Scene::judge(const Path& path, const Goal& goal) const {
  if (then_of(puzzle.target)) return judge_sent(path, goal);
  const auto* point = std::get_if<PointTarget>(&puzzle.target);
  const double within = point ? point->within + goal.slack : 0;
  Arrived out;
  std::vector<const TruthEvent*> met;
  const auto counts = [&] { return static_cast<int>(met.size()) >= goal.min && out.in_order; };
  const auto update = [&] { out.in_order = !goal.sequence || same_order(*goal.sequence, met); };
  update();
  bool found = false;
  const TruthEvent* jaw = nullptr;  // the first touched of those of a pocket that is asked for
  const auto fails = [&](std::string why) {
    if (!found) out.why = std::move(why);
    return out;
  };
  for (const TruthEvent& e : path.events) {
    if (point && !stops_ && counts() && e.passing.miss <= within &&
        (!found || std::abs(e.passing.time - goal.time) < std::abs(out.time - goal.time))) {
      out = at_point(std::move(out), e.passing);
      found = true;
    }
    switch (e.kind) {
      case EventKind::cushion:
        if (static_cast<int>(met.size()) == goal.max || found)
          return fails(fmt::format("meets {} before the target", contact_name(puzzle.table, e.contact)));
        met.push_back(&e);
        out.cushions.push_back(e.contact);
        update();
        break;
      case EventKind::jaw: {
        const auto* pocket = std::get_if<PocketTarget>(&puzzle.target);
        if (pocket && !jaw && pocket->pocket.value_or(e.contact.jaw_pocket()) == e.contact.jaw_pocket()) jaw = &e;
        out.rattles = true;
        break;
      }
      case EventKind::slide_to_roll:
        break;
      case EventKind::pocket: {
        const auto* pocket = std::get_if<PocketTarget>(&puzzle.target);
        if (!pocket || (pocket->pocket && Contact::pocket(*pocket->pocket) != e.contact) || !counts())
          return fails(fmt::format("falls into pocket {}", contact_name(puzzle.table, e.contact)));
        return taken(std::move(out), e, jaw ? *jaw : e);
      }
      case EventKind::ball: {
        const auto* ball = std::get_if<BallTarget>(&puzzle.target);
        if (!ball || std::ranges::count(ball->balls, e.contact.index) == 0 || !counts())
          return fails(fmt::format("runs into {}", contact_name(puzzle, e.contact)));
        out = taken(std::move(out), e, e);
        const double reach = boundary.rim(e.contact)->radius, most = radians(90.0);
        const auto offset = [&](double cut) { return -reach * std::sin(std::clamp(cut, -most, most)); };
        if (out.offset < offset(ball->cut + ball->within) - goal.slack ||
            out.offset > offset(ball->cut - ball->within) + goal.slack)
          out.why = fmt::format("meets {} at another cut", contact_name(puzzle, e.contact));
        return out;
      }
      case EventKind::rest: {
        if (!stops_ || !counts()) return fails("stops before the target");
        const double miss = norm((e.state.at - point->at) + e.at_rest);
        if (miss > within) return fails(fmt::format("stops {:.6g} m from the target", miss));
        return at_point(std::move(out), {.time = e.time, .speed = 0, .at = e.state.at, .velocity = {}, .miss = miss});
      }
      default:
        return fails("passes by the target");
    }
  }
  return fails("passes by the target");
}

Arrived Scene::replay(const Launch& launch, const Shot& claim, double slack) const {
  const int n = static_cast<int>(claim.cushions.size());
  return judge(truth_of(launch, claim.spin, n),
               {n, n, &claim.cushions, claim.then ? &*claim.then : nullptr, claim.arrival.time, slack});
}

std::optional<double> Scene::condition(const Shot& shot) const {
  constexpr double step = 1e-14;  // what is left out is of this size; the values have 32 digits
  const int n = static_cast<int>(shot.cushions.size());
  Run base = run(shot.launch, shot.spin, n);
  const ShotRequest all = request_of(shot.launch, shot.spin);
  if (shot.then) base.all = &all;
  if (!stops_) base.target = shot.arrival.at;
  const Path path = run_truth(base);
  const std::size_t arrives = shot.then ? arriving_of(path, shot.then->ball, shot.arrival.time, stops_)
                                        : arriving(path, n, shot.arrival.time, stops_);
  const auto moved = [&](double turned, double pushed) -> std::optional<double> {
    // On one side of the shot its path may meet other cushions.
    for (const double side : {step, -step}) {
      const Path other = beside(base, side * turned, side * pushed);
      if (same_events(other, path, arrives)) return apart(other.events[arrives], path.events[arrives], stops_) / step;
    }
    return {};
  };
  const auto by_aim = moved(1, 0), by_speed = moved(0, 1);
  if (!by_aim || !by_speed) return {};
  return std::max(*by_aim, *by_speed);
}

Run Scene::in_double(const Launch& launch, const LaunchSpin& spin, int cushions) const {
  const Run r = run(launch, spin, cushions);
  return {boundary, puzzle.physics, r.start, r.cushions, r.events, r.target};
}

bool Scene::seems_made(const Launch& launch, const Shot& claim) const {
  const int n = static_cast<int>(claim.cushions.size());
  return launch.speed > 0 && judge(double_of(launch, claim.spin, n),
                                   {n, n, &claim.cushions, claim.then ? &*claim.then : nullptr, claim.arrival.time})
                                 .made();
}

double Scene::chance(const Shot& shot, int draws) const {
  std::mt19937_64 engine(static_cast<std::uint64_t>(draws));
  const auto uniform = [&] { return (static_cast<double>(engine() >> 11) + 0.5) * 0x1p-53; };
  const CushionRule& rule = puzzle.cushions;
  const Goal goal{rule.min, rule.max, rule.sequence ? &*rule.sequence : nullptr, nullptr, shot.arrival.time};
  int made = 0;
  for (int i = 0; i < draws; ++i) {
    const double size = std::sqrt(-2 * std::log(uniform())), turn = radians(360) * uniform();  // Box and Muller
    const Launch l{shot.launch.speed + puzzle.noise.speed * size * std::cos(turn),
                   wrap_angle(shot.launch.angle + puzzle.noise.angle * size * std::sin(turn))};
    if (!(l.speed > 0)) continue;
    made += judge(double_of(l, shot.spin, rule.max), goal).made();
  }
  return static_cast<double>(made) / draws;
}

}  // namespace bankshot::truth
