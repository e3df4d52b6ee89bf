// SPDX-License-Identifier: MIT
//
// Planner `auto`: the cheapest sure step first. Images are exact where paths unfold; a sweep of the
// aim adds what they cannot see (reflex vertices, dead cushions); Levenberg–Marquardt and then a
// global search are for what is left, and are not run when the images proved that nothing is.
// With spin images are only seeds: the steps of planners/steps follow, in the order of their numbers.
#include <algorithm>

#include "planners/methods/methods.hpp"
#include "planners/methods/nlopt.hpp"
#include "planners/stop.hpp"

namespace bankshot::planning::methods {
namespace {

using namespace settings::automatic;

/// A route by straight cushions unfolds to one line, so its image is its only shot.
bool settled(const Question& q, const Ledger& ledger, const Findings& found) {
  if (found.complete || ledger.cut() || stop::satisfied(q, found)) return true;
  const auto straight = [&](const Meeting& m) { return q.boundary.line(m.with) != nullptr; };
  return q.route && !found.shots.empty() && std::ranges::all_of(*q.route, straight);
}

/// One arrival speed aimed for, or one launch speed.
void with_spin(const Question& q, Ledger& ledger, Findings& found) {
  const auto nothing_yet = [&] { return stop::nothing_yet(ledger, found); };
  steps::images(q, ledger, found);
  if (ledger.cut()) return;
  // What blocks a pocket's centre is often there; a point's hardly ever: so parts of points come last.
  steps::Parts parts;
  const bool pocket = q.captures();
  if (q.route && nothing_yet()) {
    steps::fan(q, ledger, found);
    if (pocket) parts.climb(q, ledger, found);
  }
  if (q.all() || nothing_yet()) steps::map(q, ledger, found, steps::usual_spacing(q));
  if (stop::more_wanted(q, ledger, found)) steps::along(q, ledger, found);
  if (pocket) {
    parts.climb(q, ledger, found);
    parts.bisect(q, ledger, found, first_share_of_parts);
  }
  if (nothing_yet()) steps::map(q, ledger, found, fine);
  if (q.route && nothing_yet()) steps::map(q, ledger, found, as_it_occurs);
  parts.climb(q, ledger, found);
  if (pocket && nothing_yet()) steps::map(q, ledger, found, finest);
  parts.climb(q, ledger, found);
  parts.bisect(q, ledger, found, 1);
  if (nothing_yet()) search_box(q, ledger, found, steps::word::global);
}

/// Where the end of a range of arrival speeds that is preferred is out of reach: its other end, its middle,
/// then launches at the bounds of their own speed, which arrive as they may.
void with_spin_over_range(const Question& q, Ledger& ledger, Findings& found) {
  with_spin(q, ledger, found);
  if (!q.arrival || q.arrival->fixed()) return;
  const Range& arrive = *q.arrival;
  for (const double asked : {arrive.low + arrive.high - q.asked, (arrive.low + arrive.high) / 2}) {
    if (!stop::nothing_yet(ledger, found)) return;
    with_spin(q.asking(asked), ledger, found);
  }
  for (const double speed : {q.puzzle.speed.high, q.puzzle.speed.low}) {
    if (!stop::nothing_yet(ledger, found) || !(speed > 0)) return;
    with_spin(q.launched_at(speed), ledger, found);
  }
}

}  // namespace

void automatic(const Question& q, Ledger& ledger, Findings& found) {
  if (!is_straight(q.puzzle.physics)) return with_spin_over_range(q, ledger, found);
  image(q, ledger, found);
  if (!settled(q, ledger, found)) sweep(q, ledger, found);
  if (stop::nothing_yet(ledger, found) && !found.complete) ceres(q, ledger, found);
  if (stop::nothing_yet(ledger, found) && !found.complete) search_box(q, ledger, found, steps::word::global);
}

}  // namespace bankshot::planning::methods
