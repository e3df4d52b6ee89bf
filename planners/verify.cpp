// SPDX-License-Identifier: MIT
#include "planners/verify.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "bankshot/simulate/simulator.hpp"
#include "bankshot/tolerances.hpp"
#include "planners/robustness.hpp"

namespace bankshot::planning {
namespace {

/// Follows the bounces against a requested sequence; two at one instant match in either order.
class SequenceCheck {
 public:
  explicit SequenceCheck(const std::vector<int>* wanted) : wanted_(wanted) {}

  bool accepts(int k, const Event& e) {
    if (!wanted_) return true;
    const auto at = [&](int i) { return (*wanted_)[static_cast<std::size_t>(i)]; };
    if (swapped_ >= 0) return e.same_instant && std::exchange(swapped_, -1) == e.index;
    if (at(k) == e.index) return true;
    if (k + 1 < static_cast<int>(wanted_->size()) && at(k + 1) == e.index) {
      swapped_ = at(k);
      return true;
    }
    return false;
  }
  /// A swap still waits for its second bounce.
  bool open() const { return swapped_ >= 0; }

 private:
  const std::vector<int>* wanted_;
  int swapped_ = -1;
};

/// A simulation against a goal, leg by leg.
template <class Motion, class Cushion>
class Follower {
 public:
  Follower(const Search& s, const Motion& motion, const Cushion& cushion, const Launch& launch,
           const Goal& goal, bool tracing)
      : s_(s), goal_(goal), tracing_(tracing), stop_(s.stop && !tracing), check_(goal.sequence),
        sim_(s.boundary, motion, cushion,
             launched(s.puzzle.ball.at, s.puzzle.ball.radius, direction(launch.angle) * launch.speed, s.puzzle.spin)),
        out_{{}, SpeedAccount(deceleration(s.puzzle.physics))} {}

  Trace run(std::vector<int>* contacts) {
    for (;;) {
      const Event e = sim_.step();
      if (look_along_arc(e)) return out_;
      if (tracing_) {
        out_.account.add(sim_.arc(), sim_.travelled());
        if (out_.account.beyond(s_.puzzle.speed.high)) return fail(Foul::too_long, -1);
      }
      switch (e.kind) {
        case EventKind::cushion:
          if (k_ == goal_.max) return fail(Foul::extra_cushion, e.index);
          if (!check_.accepts(k_, e)) return fail(Foul::wrong_cushion, e.index);
          ++k_;
          if (!std::is_same_v<Cushion, Mirror> && !(dot(sim_.normal(e.index), sim_.state().velocity) > 0)) out_.replay.cushion_stick = true;
          if (contacts) contacts->push_back(e.index);
          break;
        case EventKind::slide_to_roll:
          break;
        case EventKind::pocket:
          return pocketed(e.index);
        case EventKind::rest:
          return rest();
        case EventKind::horizon:
          return fail(Foul::missed, -1);
      }
    }
  }

 private:
  bool counts() const { return k_ >= goal_.min && !check_.open(); }

  /// Closest approach to the target on the arc just travelled; true when a point is made there.
  bool look_along_arc(const Event& e) {
    const PointTarget* target = s_.point();
    if (stop_ || !counts()) return false;
    if (target) {
      const bool near = look_at(target->at) <= target->within;
      // A ball that still comes nearer when its slide ends is closest on the next arc.
      return near && (closest_ < sim_.travelled() || e.kind != EventKind::slide_to_roll) && arrive_at_point();
    }
    if (tracing_)
      for (const Vec2d& centre : s_.aim_points()) look_at(centre);
    return false;
  }

  double look_at(const Vec2d& target) {
    const double t = closest_time(sim_.arc(), sim_.travelled(), target);
    const Vec2d at = sim_.arc().position(t);
    const double miss = norm(at - target);
    closest_ = t;
    if (miss < out_.replay.miss) {
      out_.replay.miss = miss;
      const Arc<double>& arc = sim_.arc();
      out_.replay.arrival = {sim_.time() - arc.seconds(sim_.travelled()) + arc.seconds(t), norm(arc.velocity_at(t)), at};
    }
    return miss;
  }

  bool arrive_at_point() {
    if (tracing_) out_.account.add(sim_.arc(), closest_);
    out_.replay.made = true;
    out_.replay.bounces = k_;
    return true;
  }

  Trace pocketed(int pocket) {
    if (s_.point() || !s_.wanted(pocket) || !counts()) return fail(Foul::pocketed, pocket);
    const State<double>& now = sim_.state();
    const Vec2d to_centre = s_.boundary.pockets[static_cast<std::size_t>(pocket)].centre - now.at;
    out_.replay.made = true;
    out_.replay.bounces = k_;
    // A ball that stops on the circle still has the line of its last arc.
    const Vec2d heading = norm(now.velocity) > 0 ? now.velocity : sim_.arc().velocity;
    out_.replay.miss = std::abs(cross(heading, to_centre)) / norm(heading);
    out_.replay.arrival = {sim_.time(), norm(now.velocity), now.at};
    return out_;
  }

  Trace rest() {
    const PointTarget* target = s_.point();
    if (!target || !stop_ || !counts()) return fail(Foul::fell_short, -1);
    out_.replay.miss = norm(sim_.state().at - target->at);
    out_.replay.arrival = {sim_.time(), 0, sim_.state().at};
    out_.replay.bounces = k_;
    out_.replay.made = out_.replay.miss <= target->within;
    if (!out_.replay.made) out_.replay.failure = {Foul::missed};
    return out_;
  }

  Trace fail(Foul foul, int index) {
    // Where the target was passed with the bounces asked, that is the miss; else how near the
    // ball was when it went wrong.
    if (!(out_.replay.miss < std::numeric_limits<double>::infinity())) {
      for (const Vec2d& p : s_.aim_points())
        out_.replay.miss = std::min(out_.replay.miss, norm(sim_.state().at - p));
      out_.replay.arrival = {sim_.time(), norm(sim_.state().velocity), sim_.state().at};
    } else if (foul == Foul::extra_cushion) {
      foul = Foul::missed;
      index = -1;
    }
    out_.replay.failure = {foul, index};
    out_.replay.bounces = k_;
    return out_;
  }

  const Search& s_;
  const Goal& goal_;
  bool tracing_;  ///< only the shape matters: pass the target, and keep account of the speed
  bool stop_;
  SequenceCheck check_;
  Simulator<double, Motion, Cushion> sim_;
  int k_ = 0;
  double closest_ = 0;  ///< s into the arc
  Trace out_;
};

/// Brings a number that rounding carried just outside its bounds back in.
bool inside(double& v, const Range& r) {
  const double slack = tolerance::bound * std::max(1.0, std::abs(r.high));
  if (v < r.low - slack || v > r.high + slack) return false;
  v = std::clamp(v, r.low, r.high);
  return true;
}

bool inside_angle(double& angle, const std::optional<Range>& bounds) {
  if (!bounds) return true;
  constexpr double turn = radians(360);
  for (double a : {angle, angle + turn, angle - turn})
    if (inside(a, *bounds)) return angle = wrap_angle(a), true;
  return false;
}

/// Metres between two arrivals of one launch that are one: a bounce at the target lies between them.
double same_arrival(const Search& s) { return 10 * tolerance::exact_miss * s.boundary.diagonal; }

bool same_launch(const Shot& a, const Launch& b) {
  return std::abs(angle_difference(a.launch.angle, b.angle)) < tolerance::same_aim &&
         std::abs(a.launch.speed - b.speed) <= tolerance::exact_speed * std::max(1.0, b.speed);
}

bool fast_as_asked(const Search& s, const Replay& r) {
  if (!s.arrival || s.stop) return true;
  const double slack = tolerance::exact_speed * std::max(1.0, s.arrival->high);
  return r.arrival.speed >= s.arrival->low - slack && r.arrival.speed <= s.arrival->high + slack;
}

/// Rounding, not geometry, may have decided: the path meets a corner, or ends on a cushion line.
bool rounding_may_matter(const Replay& r) {
  const Foul f = r.failure.foul;
  return f == Foul::wrong_cushion || f == Foul::extra_cushion || f == Foul::fell_short || f == Foul::missed;
}

}  // namespace

void SpeedAccount::add(const Arc<double>& arc, double t) {
  const double now2 = dot(arc.velocity, arc.velocity);
  gain *= now2 / before2_;
  loss *= now2 / before2_;
  before2_ = now2;
  if (t > 0) loss += 2 * deceleration_ * norm(arc.position(t) - arc.at);
}

Replay replay(Search& s, const Launch& launch, const Goal& goal, std::vector<int>* contacts) {
  const Replay r = with_physics(s.puzzle.physics, [&](const auto& motion, const auto& cushion) {
    return Follower(s, motion, cushion, launch, goal, false).run(contacts).replay;
  });
  s.spend(static_cast<std::size_t>(r.bounces));
  return r;
}

Trace trace(Search& s, double angle, const Goal& goal, std::vector<int>* contacts) {
  const Mirror mirror{restitution(s.puzzle.physics)};
  const Trace t = Follower(s, Ideal{}, mirror, {1, angle}, goal, true).run(contacts);
  s.spend(static_cast<std::size_t>(t.replay.bounces));
  return t;
}

double fixed_speed(const Search& s) {
  if (s.pinned) return *s.pinned;
  const Range& bounds = s.puzzle.speed;
  return is_ideal(s.puzzle.physics) ? std::clamp(1.0, bounds.low, bounds.high) : bounds.low;
}

std::optional<double> launch_speed(Search& s, double angle, const Trace& t, bool off_centre) {
  const Range& bounds = s.puzzle.speed;
  const int n = t.replay.bounces;
  const auto speed_for = [&](double v) { return std::sqrt((v * v + t.account.loss) / t.account.gain); };
  double low = bounds.low, high = bounds.high;
  if (is_ideal(s.puzzle.physics)) return fixed_speed(s);
  if (s.arrival) {
    low = speed_for(s.arrival->low);
    high = speed_for(s.arrival->high);
    const auto refuse = [&](Foul foul, double needed, double bound) {
      s.remember({{bound, angle}, n, t.replay.miss, {foul, -1, needed}});
      return std::nullopt;
    };
    // Resting beside the target's centre may still be resting within it.
    if (off_centre && s.stop) return std::clamp(low, bounds.low, bounds.high);
    if (!inside(low, bounds) && low > bounds.high) return refuse(Foul::too_fast, low, bounds.high);
    if (!inside(high, bounds) && high < bounds.low) return refuse(Foul::too_slow, high, bounds.low);
    low = std::max(low, bounds.low);
    high = std::min(high, bounds.high);
  }
  // On a path that does not depend on the speed, more speed only carries the ball on, so it is
  // the most robust and the quickest.
  return s.puzzle.prefer == Prefer::soft ? low : high;
}

namespace {

bool try_launch(Search& s, const Launch& proposed, int bounces, std::string_view planner, bool off_centre) {
  const CushionRule& rule = s.puzzle.cushions;
  if (bounces < rule.min || bounces > rule.max) return false;
  Launch launch{proposed.speed, wrap_angle(radians(degrees(proposed.angle)))};
  if (!inside_angle(launch.angle, s.puzzle.angle)) {
    s.remember({launch, bounces, std::numeric_limits<double>::max(), {Foul::outside_aim}});
    return false;
  }
  if (!inside(launch.speed, s.puzzle.speed)) return false;
  std::vector<int> contacts;
  const Replay r = replay(s, launch, Goal::exactly(s, bounces), &contacts);
  if (!r.made || !fast_as_asked(s, r) || !(off_centre || s.centred(r.miss))) {
    s.remember({launch, bounces, r.miss, r.failure});
    return false;
  }
  for (Shot& known : s.shots) {
    if (!same_launch(known, launch) || std::abs(known.arrival.time - r.arrival.time) * launch.speed > same_arrival(s)) continue;
    if (known.cushions.size() <= contacts.size()) return true;
    std::swap(known, s.shots.back());  // the bounce at the target itself is one too many
    s.shots.pop_back();
    break;
  }
  Shot shot{.launch = launch, .spin = s.puzzle.spin, .cushion_stick = r.cushion_stick, .cushions = std::move(contacts), .arrival = r.arrival, .miss = r.miss};
  shot.planner = planner;
  shot.simulations = s.simulations;
  first_order(s, shot);
  s.shots.push_back(std::move(shot));
  return true;
}

}  // namespace

bool certify(Search& s, const Launch& proposed, int bounces, std::string_view planner, bool off_centre) {
  if (!s.measure) return try_launch(s, proposed, bounces, planner, off_centre);
  const auto begin = std::chrono::steady_clock::now();
  const bool certified = try_launch(s, proposed, bounces, planner, off_centre);
  s.certify_us += std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count();
  return certified;
}

bool certify_aim(Search& s, double angle, int bounces, std::string_view planner, bool off_centre) {
  const Goal goal = Goal::exactly(s, bounces);
  Replay last;
  std::optional<Failure> first;
  bool alike = true;  // on both sides of the aim a path fails for one reason, unless it runs through a corner
  const auto attempt = [&](double a, double shorter) {
    const Trace t = trace(s, a, goal);
    last = t.replay;
    if (!t.replay.made) {
      if (!first) first = t.replay.failure;
      alike = alike && first->like(last.failure);
      s.remember({{s.puzzle.speed.high, a}, bounces, t.replay.miss, t.replay.failure});
      return false;
    }
    const auto speed = launch_speed(s, a, t, off_centre);
    return speed && !s.spent() && certify(s, {*speed * (1 - shorter), a}, bounces, planner, off_centre);
  };
  if (attempt(angle, 0)) return true;
  if (off_centre || !(last.made || rounding_may_matter(last))) return false;
  // The trace runs at unit speed, so its time bounds the metres that a radian moves the target by.
  const double path = std::max(last.arrival.time, 1e-3 * s.boundary.diagonal);
  const double step = tolerance::nudge * s.boundary.diagonal / path;
  // A path through corners was likely asked at a round angle, which the image has to rounding only.
  const double rounded = radians(std::round(degrees(angle) * 1e9) / 1e9);
  const bool round = std::abs(rounded - angle) < step;
  if (round && !s.spent() && attempt(rounded, 0)) return true;
  // Two cushions met in one instant at the speed that is given need not be at the trace's.
  if (round && s.one_unknown() && !s.spent() && certify(s, {fixed_speed(s), rounded}, bounces, planner)) return true;
  for (const double k : {0.0, 1.0, -1.0, 10.0, -10.0})
    for (const double shorter : {0.0, step}) {
      if (s.spent()) return false;
      const bool tried = k == 0 && shorter == 0;
      if (!tried && (shorter == 0 || s.stop) && attempt(angle + k * step, shorter)) return true;
    }
  s.rounding_decided = s.rounding_decided || !alike;
  return false;
}

}  // namespace bankshot::planning
