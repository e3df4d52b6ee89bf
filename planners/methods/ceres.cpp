// SPDX-License-Identifier: MIT
//
// Planner `ceres`: Levenberg–Marquardt (ceres::TinySolver) on dual-number derivatives of the
// locked-sequence residual, in (aim, ln speed) or in the aim alone.
// Seeds: the images of unfold.hpp with their sequences; on tables with reflex vertices also a fan of
// aims with the sequences their traces meet. Cost: about ten locked simulations a seed. Guarantee: none beyond the
// certificate; it finds the root its seed leads to.
#include <set>

#include "planners/images/unfold.hpp"
#include "planners/locked/residual.hpp"
#include "planners/methods/methods.hpp"
#include "planners/proof/prove.hpp"

namespace bankshot::planning {
namespace {

constexpr int fan = 720;  // aims tried as seeds where no image exists: every half degree

/// Refines one image along one sequence; true when it leads to a root, a shot or not.
bool from_seed(Search& s, double angle, double length, const std::vector<Contact>& contacts, const Vec2d& target,
               bool quickly) {
  const LockedAim aim{s, contacts, target};
  const auto speed = speed_at(s, aim, angle, length);
  if (!speed) return false;
  const Launch seed{*speed, angle};
  constexpr Neighbourhood wide{0.3, 0.5};
  const auto root = quickly ? newton(s, aim, seed, wide) : solve_locked(s, aim, seed);
  if (root) certify_root(s, aim, *root, "image+ceres");
  return root.has_value();
}

/// Ratios of the normal to the tangential loss to unfold with, as shares of the cushion's own
/// restitution: spin changes the rebound's angle, and one of these comes near it.
constexpr double shares[] = {1, 0.8, 1.2, 0.6, 1.5};

void from_fan(Search& s) {
  const CushionRule& rule = s.puzzle.cushions;
  for (int i = 0; i < fan; ++i)
    for (int n = rule.min; n <= rule.max; ++n) {
      if (s.enough()) return;
      const double angle = radians(360.0 / fan) * i;
      std::vector<Contact> contacts;
      trace(s, angle, Goal::exactly(s, n), &contacts);
      if (s.puzzle.cushions.sequence) contacts = *s.puzzle.cushions.sequence;
      if (static_cast<int>(contacts.size()) == n)
        for (const Vec2d& target : s.aim_points()) from_seed(s, angle, s.boundary.diagonal, contacts, target, false);
    }
}

}  // namespace

void image_seeds(Search& s, bool quickly) {
  const bool straight = is_straight(s.puzzle.physics);
  std::set<std::pair<std::vector<Contact>, std::pair<double, double>>>
      settled;  // a sequence with a root has hardly ever another
  for (const double share : shares) {
    Unfolding images(s, !straight, share * restitution(s.puzzle.physics).at_rest, true);
    while (const auto c = images.next()) {
      if (s.enough()) return;
      std::pair key{images.contacts(*c), std::pair{c->target.x, c->target.y}};
      if (!straight && settled.contains(key)) continue;
      if (from_seed(s, c->angle, c->distance, key.first, c->target, quickly)) settled.insert(std::move(key));
    }
    if (straight || !images.whole()) return;
    if (s.puzzle.cushions.sequence && !s.shots.empty()) return;
  }
}

void ceres(Search& s) {
  image_seeds(s, false);
  if (!s.boundary.unfolds()) from_fan(s);
}

}  // namespace bankshot::planning
