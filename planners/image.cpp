// SPDX-License-Identifier: MIT
//
// Planner `image`: the exact aims of `ideal` and `rolling` from unfolding, nearest image first.
// Cost: one trace and one replay a candidate. Guarantee: on a table without reflex vertices every
// cushion sequence that occurs is tried, so finding nothing is a proof as far as the target's
// centre goes; parts of the target beside its centre are then searched on a grid of aims.
// Fails: restitution 0 (the unfolding is singular) and bounces on reflex vertices (not straight).
// Source: planning.md's closed form, as affine images (unfold.hpp).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "planners/planners.hpp"
#include "planners/unfold.hpp"
#include "planners/verify.hpp"

namespace bankshot::planning {
namespace {

/// Shots to compare by success when images come shortest first: the first-order margin only falls
/// with the length, so later ones are worse unless a bound or a pocket makes the difference.
constexpr std::size_t enough_to_compare = 32;
/// Aims tried across the part of a target that a ray may reach.
constexpr int aims_across = 33;
/// rad; where the bisection between two aims that fail differently gives up.
constexpr double narrowest = 1e-10;

bool enough(const Search& s, const Unfolding& images) {
  if (s.all || !images.shortest_first()) return false;
  return s.shots.size() >= (s.puzzle.prefer == Prefer::robust ? enough_to_compare : 1);
}

/// Every centred candidate; true when all were tried.
bool centred(Search& s) {
  Unfolding images(s, false, restitution(s.puzzle.physics).at_rest);
  while (const auto c = images.next()) {
    if (s.spent()) return false;
    certify_aim(s, c->angle, c->bounces, "image");
    if (!enough(s, images)) continue;
    if (s.puzzle.prefer == Prefer::robust && images.next())
      s.note = fmt::format("compared the {} shortest shots", s.shots.size());
    return true;
  }
  if (images.too_long() > 0) s.remember({{}, 0, std::numeric_limits<double>::infinity(), {Foul::too_long}});
  if (!images.whole()) s.note = "there are too many cushion sequences to try them all";
  return images.whole();
}

/// Finds aims that reach any part of one image of the target. Between two aims that fail for
/// different reasons may lie a window that is made: bisect there.
class PartOfTarget {
 public:
  PartOfTarget(Search& s, const Candidate& c) : s_(s), c_(c), goal_(Goal::exactly(s, c.bounces)) {}

  /// Certifies the middle of the first window found; what is near the centre comes first.
  bool find() {
    std::vector<Tried> row;
    for (int i = 0; i < aims_across; ++i) row.push_back(attempt(c_.low + (c_.high - c_.low) * i / (aims_across - 1)));
    std::vector<std::size_t> order(row.size() - 1);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return std::abs(row[a].offset) < std::abs(row[b].offset); });
    for (const std::size_t i : order) {
      if (s_.spent()) return false;
      if (const auto made = between(row[i], row[i + 1])) return certify_window(*made);
    }
    return false;
  }

 private:
  struct Tried {
    double offset;  ///< rad beside the candidate's angle
    Replay replay;
    bool like(const Tried& o) const {
      return replay.failure.foul == o.replay.failure.foul && replay.failure.index == o.replay.failure.index && replay.bounces == o.replay.bounces;
    }
  };

  Tried attempt(double offset) { return {offset, trace(s_, c_.angle + offset, goal_).replay}; }

  std::optional<double> between(const Tried& a, const Tried& b) {
    if (a.replay.made) return a.offset;
    if (b.replay.made) return b.offset;
    if (a.like(b) || b.offset - a.offset < narrowest || s_.spent()) return {};
    const Tried middle = attempt(a.offset + (b.offset - a.offset) / 2);
    if (const auto made = between(a, middle)) return made;
    return between(middle, b);
  }

  /// The end of the made window that begins at `made`, towards `limit`.
  double edge(double made, double limit) {
    double step = (limit - made) / 64;
    while (std::abs(made - limit) > narrowest && std::abs(step) > narrowest && !s_.spent()) {
      const bool fits = std::abs(step) < std::abs(limit - made) && attempt(made + step).replay.made;
      if (fits) made += step;
      step *= fits ? 1.5 : 0.5;
    }
    return made;
  }

  bool certify_window(double made) {
    const double middle = (edge(made, c_.low) + edge(made, c_.high)) / 2;
    return certify_aim(s_, c_.angle + middle, c_.bounces, "image", true) ||
           certify_aim(s_, c_.angle + made, c_.bounces, "image", true);
  }

  Search& s_;
  const Candidate& c_;
  Goal goal_;
};

}  // namespace

void image(Search& s) {
  if (!is_straight(s.puzzle.physics)) return;  // a seed for ceres, no answer
  const bool whole = centred(s);
  const bool reflex = !s.boundary.tips.empty(), dead = restitution(s.puzzle.physics).at_rest == 0;
  s.complete = whole && !reflex && !dead;
  if (!s.shots.empty() || s.cut || !whole) return;
  Unfolding parts(s, true, restitution(s.puzzle.physics).at_rest);
  bool some_part = false;
  while (const auto c = parts.next()) {
    if (s.spent()) return;
    if (!(c->low < c->high)) continue;
    some_part = true;
    PartOfTarget(s, *c).find();
  }
  if (!s.shots.empty()) s.note = "no line reaches the target's centre; this one reaches part of it";
  s.proved = s.complete && (!some_part || (s.boundary.strictly_convex && s.boundary.pockets.empty()));
}

}  // namespace bankshot::planning
