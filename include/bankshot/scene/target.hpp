// SPDX-License-Identifier: MIT
//
// The target of a puzzle, as the puzzle gives it. Planners use its aim points (geometry/aim_point.hpp) and the
// functions below. Its kinds matter to the format, to defaults and validation, and to the 50-digit judge.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "bankshot/geometry/contact.hpp"
#include "bankshot/numbers/angle.hpp"
#include "bankshot/numbers/vec.hpp"

namespace bankshot {

/// The centre passes through `at`, or rests there if the required arrival speed is 0.
struct PointTarget {
  Vec2d at;
  double within = 0.01;  ///< m; largest miss that counts as made
};

/// The ball falls into a pocket; no number means any pocket.
struct PocketTarget {
  std::optional<int> pocket{};
};

/// Bounces before the target: a count between min and max, or exactly `sequence` (contacts).
struct CushionRule {
  int min = 0, max = 3;
  std::optional<std::vector<Contact>> sequence{};

  static CushionRule exactly(int n) { return {n, n, {}}; }
  static CushionRule in_order(std::vector<Contact> contacts) {
    const int n = static_cast<int>(contacts.size());
    return {n, n, std::move(contacts)};
  }
};

inline constexpr int max_cushions = 20000;

/// A combination link: an object ball that the previous object ball touches.
struct Link {
  CushionRule cushions{0, 0, {}};  ///< cushions of the ball that touches it
  int ball = 0;
};

/// The object-ball path: the touched ball reaches this target, after cushions of its own. With combination links, each
/// ball hits the next, and the last one reaches the target.
struct Then {
  std::variant<PointTarget, PocketTarget> target{};
  std::optional<CushionRule> cushions{};  ///< rule for the last ball; none: no cushion
  std::vector<Link> links{};

  /// Returns the cushion rule of the n-th object ball, from 0.
  const CushionRule& cushions_of(std::size_t n) const {
    static const CushionRule no_cushions{0, 0, {}};
    return n < links.size() ? links[n].cushions : cushions ? *cushions : no_cushions;
  }
  /// Returns true for a pot without a cushion rule. Success and margin then count every fall into the pocket, by any
  /// rails or jaws.
  bool counts_any_fall() const { return !cushions && std::holds_alternative<PocketTarget>(target); }
};

inline constexpr double any_touch = radians(90.0);  ///< rad; every cut is within this angle of a full hit

/// The cue ball touches one of these balls. This is its first contact with a ball. The cut is the angle from its
/// velocity just before the hit to the line of centres, anticlockwise.
struct BallTarget {
  std::vector<int> balls{};        ///< k stands for the k-th of `others`, from 1
  std::optional<double> cut{};     ///< rad, between ±90°; above 0 the object ball leaves to the left
  std::optional<double> within{};  ///< rad; largest error of the cut, or of a full hit, that counts as made

  /// Returns the cut [rad]; without a cut, that of a full hit.
  double exact_cut() const { return cut.value_or(0); }
  /// Returns the tolerance of the cut [rad]. The default is 5° if a cut is given; otherwise any contact counts.
  double cut_within() const { return within ? *within : cut ? radians(5.0) : any_touch; }
  /// Returns true if any contact counts.
  bool any_contact() const { return cut_within() >= any_touch; }
};

/// The cue ball touches a first ball, and then a second.
struct CaromTarget {
  int first = 0;           ///< number of the ball that is touched first
  BallTarget second{};     ///< the second contact; it names one ball
  bool any_order = false;  ///< the two balls may be touched in either order
};

/// The cue ball touches one of these balls, which reaches a point or a pocket. With links it is a combination.
struct ObjectBallTarget {
  std::vector<int> balls{};  ///< as in BallTarget
  Then then{};
};

using Target = std::variant<PointTarget, PocketTarget, BallTarget, CaromTarget, ObjectBallTarget>;

// These functions tell what is asked of the balls, whatever the kind of target.

/// Returns true if a ball must fall into a pocket to reach the target.
bool is_pocket(const Target& target);
/// Returns true if the cue ball must touch a ball.
bool is_ball(const Target& target);
/// Return the point or pocket that the cue ball or an object ball must reach; null for other kinds of target.
const PointTarget* point_of(const Target& target);
const PocketTarget* pocket_of(const Target& target);
/// Returns the object-ball path; null if the cue ball itself reaches the target.
const Then* then_of(const Target& target);
/// Returns the contact at which the cue ball's path ends; null if it ends at a point or a pocket, or an object ball
/// goes on.
const BallTarget* touch_of(const Target& target);
/// Returns the first ball of a carom; 0 if there is none.
int first_of_carom(const Target& target);
/// Returns true if the target is a carom whose balls may be touched in either order.
bool is_in_any_order(const Target& target);
/// Returns a carom with this first ball, in this order only; other targets as they are.
Target in_order(Target target, int first);
/// Returns true if the cue ball's contact with a ball is not the end: an object ball goes on, or the cue ball goes on
/// to a second ball.
bool goes_on_after_contact(const Target& target);
/// Returns the balls one of which the cue ball must touch first; none if it need not touch any.
std::vector<int> touched_first(const Target& target);
/// Returns pointers to all ball numbers in a target.
std::vector<int*> balls_of(Target& target);

}  // namespace bankshot
