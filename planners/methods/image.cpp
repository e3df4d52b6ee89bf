// SPDX-License-Identifier: MIT
//
// Planner `image`: the exact aims of `ideal` and `rolling` from unfolding, nearest image first.
// Cost: one trace and one replay a candidate. Guarantee: on a table without reflex vertices every route that occurs is
// tried. If nothing is found, this certifies that no shot reaches the target's centre. Parts of the target beside its
// centre are then searched on a grid of aims.
// Fails: restitution 0 (the unfolding is singular) and bounces on reflex vertices (not straight).
// Source: the method of images: on a table unfolded at each cushion it meets, a path that bounces is one straight line;
// restitution below 1 stretches the image (unfold.hpp).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "planners/methods/methods.hpp"
#include "planners/propose/aim.hpp"
#include "planners/propose/unfold.hpp"
#include "planners/propose/window.hpp"
#include "planners/stop.hpp"

namespace bankshot::planning::methods {
namespace {

double stretch(const SearchRequest& request) { return restitution(request.puzzle().physics).at_rest; }

/// Tries every centred candidate; returns whether all were tried.
bool centred(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found) {
  Unfolding candidates(request, {.restitution = stretch(request)});
  while (const auto c = candidates.next()) {
    if (budget.spent()) return false;
    certify_aim(request, budget, found, c->angle, c->bounces, word::unfold);
    if (!stop::enough_images(request, found, candidates.shortest_first())) continue;
    if (request.puzzle().prefer == Prefer::robust && !request.first() && candidates.next())
      found.add_note(fmt::format("compared the {} shortest shots", found.shots.size()));
    return true;
  }
  if (candidates.too_long() > 0)
    found.remember({{}, std::numeric_limits<double>::infinity(), {FailureReason::too_long}});
  if (!candidates.whole()) found.add_note("there are too many cushion sequences to try them all");
  return candidates.whole();
}

/// Returns the aims of a candidate's window that the puzzle's bounds leave: at most two pieces.
std::vector<Range> allowed(const SearchRequest& request, const Image& c) {
  const double low = c.angle + c.low, high = c.angle + c.high;
  if (!request.angle) return {{low, high}};
  std::vector<Range> pieces;
  for (const double turn : {-radians(360), 0.0, radians(360)}) {
    const Range piece{std::max(low + turn, request.angle->low), std::min(high + turn, request.angle->high)};
    if (piece.low <= piece.high) pieces.push_back(piece);
  }
  return pieces;
}

/// Searches for off-centre shots; returns whether a ray may reach some part of the target at all.
bool beside_centre(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found) {
  Unfolding parts(request, {.parts = true, .restitution = stretch(request)});
  bool some_part = false;
  while (const auto c = parts.next()) {
    if (budget.spent()) break;
    if (!(c->low < c->high)) continue;
    for (const Range& aims : allowed(request, *c)) {
      some_part = true;
      reach_part(request, budget, found, aims, c->angle, settings::aims_across, Goal::exactly(request, c->bounces),
                 word::unfold);
    }
  }
  return some_part;
}

}  // namespace

void image(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found) {
  const bool whole = centred(request, budget, found);
  const bool dead = stretch(request) == 0;
  found.complete = whole && request.problem->boundary.unfolds() && !dead;
  if (!found.shots.empty() || budget.cut() || !whole) return;
  const bool some_part = beside_centre(request, budget, found);
  if (!request.problem->boundary.jaws.empty()) return;  // jaws may turn a ball in whose line leads nowhere
  // Without obstacles and bounds on the speed every ray of a window is made. So if none was found, there is none.
  const bool no_obstacle = request.problem->boundary.strictly_convex && request.problem->boundary.pockets.empty() &&
                           request.problem->boundary.balls.empty();
  found.proved = found.complete && (!some_part || (no_obstacle && is_ideal(request.puzzle().physics))) &&
                 !(no_obstacle && found.rounding_decided);
}

}  // namespace bankshot::planning::methods
