// SPDX-License-Identifier: MIT
//
// Planner `image`: the exact aims of `ideal` and `rolling` from unfolding, nearest image first.
// Cost: one trace and one replay a candidate. Guarantee: on a table without reflex vertices every
// cushion sequence that occurs is tried, so finding nothing is a proof as far as the target's
// centre goes; parts of the target beside its centre are then searched on a grid of aims.
// Fails: restitution 0 (the unfolding is singular) and bounces on reflex vertices (not straight).
// Source: planning.md's closed form, as affine images (unfold.hpp).
#include <fmt/format.h>

#include "planners/planners.hpp"
#include "planners/unfold.hpp"
#include "planners/verify.hpp"

namespace bankshot::planning {
namespace {

/// Shots to compare by success when images come shortest first: the first-order margin only falls
/// with the length, so later ones are worse unless a bound or a pocket makes the difference.
constexpr std::size_t enough_to_compare = 32;
/// Aims tried across the part of a target that a ray may reach.
constexpr int aims_across = 65;

bool enough(const Search& s, const Unfolding& images) {
  if (s.all || !images.shortest_first()) return false;
  return s.shots.size() >= (s.puzzle.prefer == Prefer::robust ? enough_to_compare : 1);
}

/// Every centred candidate; true when all were tried.
bool centred(Search& s) {
  Unfolding images(s, false);
  while (const auto c = images.next()) {
    if (s.spent()) return false;
    certify_aim(s, c->angle, c->bounces, "image");
    if (!enough(s, images)) continue;
    if (s.puzzle.prefer == Prefer::robust && images.next())
      s.note = fmt::format("compared the {} shortest shots", s.shots.size());
    return true;
  }
  if (!images.whole()) s.note = "there are too many cushion sequences to try them all";
  return images.whole();
}

/// The middle of the widest run of aims that are made, for one image of the target.
void off_centre(Search& s, const Candidate& c) {
  const Goal goal = Goal::exactly(s, c.bounces);
  const double step = (c.high - c.low) / aims_across;
  const auto aim = [&](double i) { return c.angle + c.low + (i + 0.5) * step; };
  int best_begin = 0, best = 0, begin = 0;
  for (int i = 0; i < aims_across; ++i) {
    if (s.spent()) return;
    if (!trace(s, aim(i), goal).replay.made) begin = i + 1;
    if (i + 1 - begin > best) best = i + 1 - begin, best_begin = begin;
  }
  if (best > 0) certify_aim(s, aim(best_begin + (best - 1) / 2.0), c.bounces, "image", true);
}

}  // namespace

void image(Search& s) {
  const bool whole = centred(s);
  const bool reflex = !s.boundary.tips.empty(), dead = s.puzzle.physics.cushion.restitution == 0;
  s.complete = whole && !reflex && !dead;
  if (!s.shots.empty() || s.cut) return;
  Unfolding parts(s, true);
  bool some_part = false;
  while (const auto c = parts.next()) {
    if (s.spent()) return;
    if (!(c->low < c->high)) continue;
    some_part = true;
    off_centre(s, *c);
  }
  if (!s.shots.empty()) s.note = "no line reaches the target's centre; this one reaches part of it";
  s.proved = s.complete && (!some_part || (s.boundary.strictly_convex && s.boundary.pockets.empty()));
}

}  // namespace bankshot::planning
