// SPDX-License-Identifier: MIT
#include "planners/proof/prove.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "bankshot/numbers/tolerances.hpp"
#include "planners/merit/robustness.hpp"

namespace bankshot::planning {
namespace {

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
      s.remember({{bound, angle}, n, t.replay.miss, {foul, {}, needed}});
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
  std::vector<Contact> contacts;
  const Replay r = replay(s, launch, Goal::exactly(s, bounces), &contacts);
  if (!r.made || !fast_as_asked(s, r) || !(off_centre || s.centred(r.miss))) {
    s.remember({launch, bounces, r.miss, r.failure});
    return false;
  }
  for (Shot& known : s.shots) {
    if (!same_launch(known, launch) || std::abs(known.arrival.time - r.arrival.time) * launch.speed > same_arrival(s))
      continue;
    if (known.cushions.size() <= contacts.size()) return true;
    std::swap(known, s.shots.back());  // the bounce at the target itself is one too many
    s.shots.pop_back();
    break;
  }
  Shot shot{.launch = launch,
            .spin = s.puzzle.spin,
            .cushion_stick = r.cushion_stick,
            .cushions = std::move(contacts),
            .arrival = r.arrival,
            .miss = r.miss};
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
