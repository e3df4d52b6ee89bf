// SPDX-License-Identifier: MIT
#include "planners/learn/launch.hpp"

#include <algorithm>
#include <cmath>

#include "planners/learn/goodness.hpp"
#include "planners/learn/least_squares.hpp"
#include "planners/learn/settings.hpp"

namespace bankshot::planning {
namespace {

using namespace settings::learn;

/// Returns the times at which the cue ball meets a cushion, a jaw or a ball, by the recording's clock.
std::vector<double> bounces(const Seen& seen, const Common& common, Spent& work) {
  std::vector<double> times;
  const auto shot = play(seen, common, seen.last - seen.launch[start_time] + after_bounce, work);
  if (!shot) return times;
  for (const Record& e : shot->events)
    if (e.ball == 0 && (is_bounce(e.kind) || e.kind == EventKind::ball))
      times.push_back(seen.launch[start_time] + e.time);
  return times;
}

bool same(const std::vector<Told>& a, const std::vector<Told>& b) {
  return std::ranges::equal(a, b,
                            [](const Told& s, const Told& t) { return s.before == t.before && s.route == t.route; });
}

/// Returns the end of the window after the first bounce later than `later_than`; forever if that is all there is.
double next_window(const Seen& seen, const Common& common, double later_than, Spent& work) {
  const auto times = bounces(seen, common, work);
  const auto next = std::ranges::upper_bound(times, later_than);
  return next == times.end() || *next + after_bounce >= seen.last ? forever : *next + after_bounce;
}

/// Returns the end of the first window. If the track shows a bounce, it is the same for all launches, so that they
/// compare.
double first_window(const Seen& seen, const Common& common, Spent& work) {
  if (seen.bounced == forever) return next_window(seen, common, -forever, work);
  return seen.bounced + after_bounce < seen.last ? seen.bounced + after_bounce : forever;
}

struct Begin {
  LaunchUnknowns launch;
  bool before_bounce = false;  ///< velocity before a bounce that precedes the first samples
};

/// Returns launches with which a track may begin. The velocity is the median of those between its first samples that
/// moved. If these may lie beyond a bounce, the velocity before it is added.
std::vector<Begin> launches_of_track(const Seen& seen) {
  std::vector<Begin> out;
  const auto& tracks = seen.recording.tracks;
  if (tracks.empty() || tracks.front().ball != 0 || tracks.front().samples.empty()) return out;
  const std::vector<Sample>& s = tracks.front().samples;
  const Vec2d stood = seen.recording.scene.ball.at;
  const double moved = 5 * seen.sigma + 2e-3;
  std::size_t m = 0;
  while (m + 2 < s.size() && (norm(s[m].at - stood) < moved || norm(s[m + 1].at - stood) < moved)) ++m;
  constexpr std::size_t few = 5;
  const std::size_t last = std::min(m + few, s.size());
  std::vector<double> vx, vy;
  for (std::size_t i = m; i < last; ++i)
    for (std::size_t j = i + 1; j < last; ++j) {
      const Vec2d v = (s[j].at - s[i].at) / (s[j].time - s[i].time);
      vx.push_back(v.x), vy.push_back(v.y);
    }
  if (vx.empty()) return out;
  const auto add = [&](const Vec2d& v, bool before_bounce = false) {
    const double fast = std::max(norm(v), least_speed);
    for (const Begin& other : out) {
      constexpr double nearly = 0.98;
      const double a = other.launch[angle];
      if (dot(Vec2d{std::cos(a), std::sin(a)}, v) > nearly * norm(v)) return;
    }
    ShotRequest shot = seen.recording.scene;
    shot.launch = {fast, std::atan2(v.y, v.x)};
    shot.spin = {};
    const double first = s[m].time - norm(s[m].at - stood) / fast;
    out.push_back({unknowns_of(shot, m > 0 ? std::max(first, s[m - 1].time) : first), before_bounce});
  };
  const Vec2d v{median(vx), median(vy)};
  add(v);
  if (m + 1 < s.size()) add((s[m + 1].at - s[m].at) / (s[m + 1].time - s[m].time));
  const double way = norm(v) * (s[last - 1].time - s[m].time) + norm(s[m].at - stood);
  for (const Wall& w : seen.stand.struck().walls)
    if (dot(w.normal, stood) - w.offset < way && dot(w.normal, v) > 0) add(v - w.normal * (2 * dot(w.normal, v)), true);
  return out;
}

struct Candidate {
  double off;
  LaunchUnknowns launch;
  double rank;  ///< candidates of lower rank are tried first
};

/// Returns the launches that fit the first part, best first.
std::vector<Candidate> candidates(Seen& seen, const Common& common, Spent& work) {
  std::vector<Candidate> found;
  const Recording& r = seen.recording;
  const double begins = r.tracks.empty() || r.tracks.front().samples.empty() ? 0 : r.tracks.front().samples[0].time;
  const auto add = [&](bool before_bounce = false) {
    ++work.restarts;
    seen.window = first_window(seen, common, work);
    const double off = fit_window(seen, common, work);
    if (off < forever) found.push_back({off, seen.launch, before_bounce ? off * rare : off});
  };
  if (r.launch_given) seen.launch = unknowns_of(r.scene, begins), add();
  for (const auto& [first, before_bounce] : launches_of_track(seen)) {
    seen.launch = first;
    if (!carries_spin(common.base)) add(before_bounce);
    for (const double t : first_tops)
      for (const double s : first_sides) {
        if (!carries_spin(common.base)) break;
        seen.launch = first;
        seen.launch[top] = t, seen.launch[side] = s;
        add(before_bounce);
      }
  }
  std::ranges::sort(found, {}, &Candidate::rank);
  return found;
}

bool alike(const LaunchUnknowns& a, const LaunchUnknowns& b) {
  return std::abs(a[speed] - b[speed]) < 1e-3 && std::abs(a[top] - b[top]) < 0.01 && std::abs(a[side] - b[side]) < 0.01;
}

/// Returns whether the ball bounces before its first sample.
bool bounces_unseen(const Seen& seen, const Common& common, Spent& work) {
  const auto& tracks = seen.recording.tracks;
  if (tracks.empty() || tracks.front().ball != 0 || tracks.front().samples.empty()) return false;
  const auto times = bounces(seen, common, work);
  return !times.empty() && times.front() < tracks.front().samples.front().time;
}

/// Fits the launch anew; the former one stays unless `better(distance)`. Returns whether it was replaced.
template <class Better>
bool replaced(Seen& seen, const Common& common, Spent& work, const Better& better) {
  const double until = seen.window;
  const LaunchUnknowns launch = seen.launch;
  const std::vector<Told> told = seen.told;
  if (better(fit_anew(seen, common, until, work))) return true;
  seen.launch = launch, seen.told = told, seen.window = until;
  return false;
}

}  // namespace

std::optional<Trajectory> play(const Seen& seen, const Common& common, std::optional<double> seconds, Spent& work) {
  ++work.simulations;
  ShotRequest shot = with_launch(seen.recording.scene, seen.launch);
  shot.physics = common.physics();
  if (seconds) shot.until.time = std::max(0.0, *seconds);
  try {
    return simulate(shot);
  } catch (const InvalidInput&) {  // during a fit a launch may begin beside the table
    return {};
  }
}

bool tell(Seen& seen, const Common& common, Spent& work) {
  constexpr double beyond = 0.1;  // s; a contact just after the window may move into it during the fit
  const double until = std::max(0.0, std::min(seen.window, seen.last) - seen.launch[start_time]) + beyond;
  const bool to_rest = seen.window >= seen.last &&
                       std::ranges::any_of(seen.recording.tracks, [](const Track& t) { return t.rest.has_value(); });
  const auto shot = play(seen, common, to_rest ? std::nullopt : std::optional(until), work);
  if (!shot) return false;
  for (std::size_t k = 0; k < seen.told.size(); ++k)
    seen.told[k] = told_of(*shot, seen.recording.tracks[k].ball, to_rest ? forever : until);
  if (const auto& cushions = seen.recording.cushions; cushions && seen.recording.scene.others.empty())
    for (Told& told : seen.told) told.route = route_by(*cushions);
  return true;
}

double fit_window(Seen& seen, const Common& common, Spent& work) {
  double off = forever;
  for (int round = 0; round < 3; ++round) {
    const std::vector<Told> before = seen.told;
    if (!tell(seen, common, work)) return forever;
    if (round > 0 && same(before, seen.told)) break;
    off = solve_launch(seen, common, work);
  }
  return off;
}

double fit_on(Seen& seen, const Common& common, double until, Spent& work) {
  seen.window = std::min(until, first_window(seen, common, work));
  for (;;) {
    const double off = fit_window(seen, common, work);
    if (!(off < forever) || seen.window == until) return off;
    seen.window = std::min(until, next_window(seen, common, seen.window, work));
  }
}

bool fit_farther(Seen& seen, const Common& common, Spent& work) {
  if (seen.window == forever) return false;
  seen.window = next_window(seen, common, seen.window, work);
  fit_window(seen, common, work);
  return true;
}

double fit_anew(Seen& seen, const Common& common, double until, Spent& work) {
  Candidate best{forever, seen.launch, forever};
  std::vector<LaunchUnknowns> tried;
  for (const Candidate& c : candidates(seen, common, work)) {
    if (std::ranges::any_of(tried, [&](const LaunchUnknowns& other) { return alike(other, c.launch); })) continue;
    tried.push_back(c.launch);
    seen.launch = c.launch;
    if (const double off = fit_on(seen, common, until, work); off < best.off) best = {off, seen.launch, off};
    if (!is_off(seen, common) || tried.size() == followed) break;
  }
  seen.launch = best.launch;
  seen.window = until;
  tell(seen, common, work);
  return best.off;
}

double fit_side(Seen& seen, const Common& common, Spent& work) {
  double best = fit_window(seen, common, work);
  constexpr double hardly = 0.06, some = 0.12, much = 0.4;
  if (!carries_spin(common.base) || std::abs(seen.launch[side]) > hardly) return best;
  LaunchUnknowns launch = seen.launch;
  const LaunchUnknowns first = launch;
  for (const double start : {some, -some, much, -much}) {
    seen.launch = first;
    seen.launch[side] = start;
    if (const double off = fit_window(seen, common, work); off < best) best = off, launch = seen.launch;
  }
  seen.launch = launch;
  tell(seen, common, work);
  return best;
}

bool look_again(Seen& seen, const Common& common, Spent& work) {
  const double off = fit_side(seen, common, work);
  constexpr double clearly = 0.98;
  return is_off(seen, common) && replaced(seen, common, work, [&](double now) { return now < clearly * off; });
}

bool look_for_usual(Seen& seen, const Common& common, Spent& work) {
  if (seen.left_out || !bounces_unseen(seen, common, work)) return false;
  const double off = fit_window(seen, common, work);
  return replaced(seen, common, work, [&](double now) {
    return now < rare * off && !is_off(seen, common) && !bounces_unseen(seen, common, work);
  });
}

double fit_first_part(Seen& seen, const Common& common, Spent& work) {
  const std::vector<Candidate> found = candidates(seen, common, work);
  if (found.empty()) return forever;
  seen.launch = found.front().launch;
  seen.window = first_window(seen, common, work);
  return fit_window(seen, common, work);
}

}  // namespace bankshot::planning
