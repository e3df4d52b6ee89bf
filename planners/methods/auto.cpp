// SPDX-License-Identifier: MIT
//
// Planner `auto`: the cheapest sure step first. Images are exact where paths unfold; a sweep of the
// aim adds what they cannot see (reflex vertices, dead cushions); Levenberg–Marquardt and then a
// global search are for what is left, and are not run when the images proved that nothing is.
#include <algorithm>

#include "planners/methods/methods.hpp"
#include "planners/steps/parts.hpp"

namespace bankshot::planning {
namespace {

/// A sequence of straight cushions unfolds to one line, so its image is its only shot.
bool settled(const Search& s) {
  const auto& names = s.puzzle.cushions.sequence;
  return s.complete || s.cut || s.satisfied() ||
         (names && !s.shots.empty() &&
          std::all_of(names->begin(), names->end(), [&](Contact c) { return s.boundary.line(c) != nullptr; }));
}

/// Parts of the targets of new leads; those without a shot are kept in `tried`.
void beside_centre(Search& s, std::vector<Search::Lead>& tried) {
  for (Search::Lead& lead : s.leads) {
    if (!s.shots.empty() || s.spent()) break;
    reach_part(s, lead, "part");
    tried.push_back(std::move(lead));
  }
  s.leads.clear();
}

/// A bisection may still find a part: the target is less than its own size away, at a speed that is allowed, or nearly.
bool hopeful(const Search& s, const Search::Lead& lead) {
  constexpr double nearly = 1.3;
  const Range& v = s.puzzle.speed;
  return lead.half > 0 && lead.room > -s.reach(lead.target) && lead.launch.speed > v.low / nearly &&
         lead.launch.speed < v.high * nearly;
}

/// The hopeful leads that came nearest, until this share of what is left of the budget is used.
void thoroughly(Search& s, std::vector<Search::Lead>& tried, double share) {
  const auto until = s.simulations + static_cast<long>(share * static_cast<double>(s.puzzle.budget - s.simulations));
  std::sort(tried.begin(), tried.end(), [](const auto& a, const auto& b) { return a.room < b.room; });
  for (; !tried.empty() && s.shots.empty() && !s.spent() && s.simulations < until; tried.pop_back())
    if (hopeful(s, tried.back())) reach_part_thoroughly(s, tried.back(), "part");
}

bool nothing_yet(const Search& s) { return s.shots.empty() && !s.cut; }

/// Images are only seeds, refinement finds the root, and maps what has no seed. Then parts of targets
/// whose centre something blocks: it often does at a pocket, hardly ever at a point.
void search_with_spin(Search& s) {
  constexpr Spacing fine{radians(0.7), 0.08, true}, real{radians(2), 0.12, true, false},
      finest{radians(0.8), 0.05, true, false};
  const bool point = s.point(), given = s.puzzle.cushions.sequence.has_value();
  std::vector<Search::Lead> tried;
  image_seeds(s, true);
  if (s.cut) return;
  if (given && nothing_yet(s)) {
    fan_out(s, {});
    if (!point) beside_centre(s, tried);
  }
  if (s.all || nothing_yet(s)) sweep(s);
  if ((s.all && !s.cut) || nothing_yet(s)) along_touched(s);
  if (!point) {
    beside_centre(s, tried);
    thoroughly(s, tried, 0.2);
  }
  if (nothing_yet(s)) map(s, fine);
  if (given && nothing_yet(s)) map(s, real);
  beside_centre(s, tried);
  if (!point && nothing_yet(s)) map(s, finest);
  beside_centre(s, tried);
  thoroughly(s, tried, 1);
  if (nothing_yet(s)) nlopt_direct(s);
}

/// Where the end of a range of arrival speeds that is preferred is out of reach: its other end, its middle,
/// then launches at the bounds of their own speed, which arrive as they may.
void with_spin(Search& s) {
  search_with_spin(s);
  if (!s.arrival || s.arrival->fixed()) return;
  const Range& arrive = *s.arrival;
  const double preferred = s.asked;
  for (const double asked : {arrive.low + arrive.high - preferred, (arrive.low + arrive.high) / 2}) {
    if (!nothing_yet(s)) return;
    s.asked = asked;
    search_with_spin(s);
  }
  for (const double speed : {s.puzzle.speed.high, s.puzzle.speed.low}) {
    if (!nothing_yet(s) || !(speed > 0)) return;
    s.pinned = speed;
    search_with_spin(s);
  }
  s.pinned.reset();
}

}  // namespace

void automatic(Search& s) {
  if (!is_straight(s.puzzle.physics)) return with_spin(s);
  image(s);
  if (!settled(s)) sweep(s);
  if (nothing_yet(s) && !s.complete) ceres(s);
  if (nothing_yet(s) && !s.complete) nlopt_direct(s);
}

}  // namespace bankshot::planning
