// SPDX-License-Identifier: MIT
//
// Planner `image`: the exact aims of `ideal` and `rolling` from unfolding, nearest image first.
// Cost: one trace and one replay a candidate. Guarantee: on a table without reflex vertices every
// cushion sequence that occurs is tried, so finding nothing is a proof as far as the target's
// centre goes; parts of the target beside its centre are then searched on a grid of aims.
// Fails: restitution 0 (the unfolding is singular) and bounces on reflex vertices (not straight).
// Source: the method of images: on a table unfolded at each cushion it meets, a path that bounces is one straight line;
// restitution below 1 stretches the image (unfold.hpp).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "planners/images/unfold.hpp"
#include "planners/methods/methods.hpp"
#include "planners/proof/prove.hpp"
#include "planners/steps/parts.hpp"

namespace bankshot::planning {
namespace {

/// Aims tried across the part of a target that a ray may reach.
constexpr int aims_across = 33;

/// Where images come shortest first: the first-order margin only falls with the length, so later ones are
/// worse unless a bound or a pocket makes the difference.
bool enough(const Search& s, const Unfolding& images) {
  if (s.satisfied()) return true;
  if (s.all || !images.shortest_first()) return false;
  return s.shots.size() >= (s.puzzle.prefer == Prefer::robust ? Search::enough_to_compare : 1);
}

/// Every centred candidate; true when all were tried.
bool centred(Search& s) {
  Unfolding images(s, false, restitution(s.puzzle.physics).at_rest);
  while (const auto c = images.next()) {
    if (s.spent()) return false;
    certify_aim(s, c->angle, c->bounces, "image");
    if (!enough(s, images)) continue;
    if (s.puzzle.prefer == Prefer::robust && !s.first && images.next())
      s.add_note(fmt::format("compared the {} shortest shots", s.shots.size()));
    return true;
  }
  if (images.too_long() > 0) s.remember({{}, 0, std::numeric_limits<double>::infinity(), {Foul::too_long}});
  if (!images.whole()) s.add_note("there are too many cushion sequences to try them all");
  return images.whole();
}

/// What of a candidate's window of aims the puzzle's bounds leave: at most two pieces.
std::vector<Range> allowed(const Search& s, const Candidate& c) {
  const double low = c.angle + c.low, high = c.angle + c.high;
  if (!s.puzzle.angle) return {{low, high}};
  std::vector<Range> pieces;
  for (const double turn : {-radians(360), 0.0, radians(360)}) {
    const Range piece{std::max(low + turn, s.puzzle.angle->low), std::min(high + turn, s.puzzle.angle->high)};
    if (piece.low <= piece.high) pieces.push_back(piece);
  }
  return pieces;
}

/// Off-centre shots; true when a ray may reach some part of the target at all.
bool beside_centre(Search& s) {
  Unfolding parts(s, true, restitution(s.puzzle.physics).at_rest);
  bool some_part = false;
  while (const auto c = parts.next()) {
    if (s.spent()) break;
    if (!(c->low < c->high)) continue;
    for (const Range& aims : allowed(s, *c)) {
      some_part = true;
      reach_part(s, aims, c->angle, aims_across, Goal::exactly(s, c->bounces), "image");
    }
  }
  return some_part;
}

}  // namespace

void image(Search& s) {
  if (!is_straight(s.puzzle.physics)) return;  // a seed for ceres, no answer
  const bool whole = centred(s);
  const bool reflex = !s.boundary.tips.empty(), dead = restitution(s.puzzle.physics).at_rest == 0;
  s.complete = whole && !reflex && !dead;
  if (!s.shots.empty() || s.cut || !whole) return;
  const bool some_part = beside_centre(s);
  // Without obstacles and bounds on the speed every ray of a window is made: what is left is no shot.
  const bool no_obstacle = s.boundary.strictly_convex && s.boundary.pockets.empty();
  s.proved = s.complete && (!some_part || (no_obstacle && is_ideal(s.puzzle.physics))) && !s.frozen() &&
             !(no_obstacle && s.rounding_decided);
}

}  // namespace bankshot::planning
