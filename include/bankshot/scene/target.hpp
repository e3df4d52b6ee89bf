// SPDX-License-Identifier: MIT
//
// What a shot must reach. A target is data, as the puzzle gives it; its *marks*, made once for a table and a ball,
// answer whatever is asked about it: where seeds aim, what counts as met, how wide it is, the miss. No other file asks
// which kind a target is, but for those that read and write the format and the 50-digit checker, which shares nothing.
//   point   the centre passes within `within` of it, or comes to rest there: one mark
//   pocket  the ball falls into it: a mark for each arc of its circle where a ball can enter, mostly one; any pocket:
//           those of each
//   ball    the struck ball touches it, before any other or off a first one: a mark for each ball of a list
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/geometry/opening.hpp"

namespace bankshot {

/// The centre passes through `at`, or rests there when the arrival speed asked is 0.
struct PointTarget {
  Vec2d at;
  double within = 0.01;  ///< m; how far off still counts as made
};

/// The ball drops into a pocket; no number means any pocket.
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

/// Of a combination: a ball that is touched in turn, by one that was sent on.
struct Link {
  CushionRule cushions{0, 0, {}};  ///< of the ball that touches it
  int ball = 0;
};

/// What a ball that was touched does: it reaches this, after cushions of its own. With links, each ball sends the next
/// one on, and the last reaches it.
struct Then {
  std::variant<PointTarget, PocketTarget> target{};
  std::optional<CushionRule> cushions{};  ///< of the last; none given: no cushion
  std::vector<Link> links{};

  /// Of the ball that is sent on as the n-th, from 0.
  const CushionRule& cushions_of(std::size_t n) const {
    static const CushionRule no_cushions{0, 0, {}};
    return n < links.size() ? links[n].cushions : cushions ? *cushions : no_cushions;
  }
  /// A pot without a rule of cushions: success and margin count every fall into the pocket, by any rails or jaws.
  bool counts_any_fall() const { return !cushions && std::holds_alternative<PocketTarget>(target); }
};

inline constexpr double any_touch = radians(90.0);  ///< rad: so far off a full hit every cut is

/// The struck ball touches one of these, its first contact with a ball; in a carom the second. The cut is the angle
/// from its velocity just before to the line of centres, anticlockwise.
struct BallTarget {
  std::vector<int> balls{};        ///< number k stands for the k-th of `others`
  std::optional<double> cut{};     ///< rad, inside a right angle; above 0 the other ball leaves to the left
  std::optional<double> within{};  ///< rad; how far off the cut, or a full hit, still counts as made
  std::optional<Then> then{};      ///< what counts instead of the cut
  std::optional<int> off{};        ///< of a carom: the ball that is touched before

  /// rad. Without a cut it is a full hit.
  double exact_cut() const { return cut.value_or(0); }
  /// rad. By default 5° beside a cut, and any contact without one.
  double cut_within() const { return within ? *within : cut ? radians(5.0) : any_touch; }
  /// Any contact counts.
  bool any_contact() const { return !then && cut_within() >= any_touch; }
};

using Target = std::variant<PointTarget, PocketTarget, BallTarget>;

/// Offsets of the lines of travel that touch a ball at a cut [m, see opening.hpp]: −2 √(R1 R2) sin cut.
struct Cuts {
  double low, exact, high;
  bool operator==(const Cuts&) const = default;
};

/// One place to aim at.
struct Mark {
  Vec2d at{};          ///< the point, or the pocket's centre
  double reach = 0;    ///< m: how far off still counts: `within`, the radius of capture, or where two balls touch
  int ball = 0;        ///< that is to reach it: the struck one, or one that it sends on
  Contact taken_by{};  ///< the pocket or ball that ends the path; none: the ball passes here, or rests
  Opening opening{};   ///< of a pocket
  std::optional<Cuts> cuts{};  ///< of a ball

  bool operator==(const Mark&) const = default;
  bool captures() const { return bool(taken_by); }
  bool drops() const { return taken_by.kind == ContactKind::pocket; }
  /// How far before the mark the ball arrives [m].
  double capture() const { return captures() ? reach : 0; }
  /// From where a ball arrived to the point, or to the arc of the pocket's circle [m].
  double apart(const Vec2d& arrived) const;
  /// Offsets of the lines along the unit vector u that lead there [m, see opening.hpp]. `near`: one of them.
  template <class T>
  Gap<T> gap(const Vec2<T>& u, double near) const {
    if (cuts) return {T(cuts->low), T(cuts->high)};
    return drops() ? opening.gap(u, near) : Gap<T>{T(-reach), T(reach)};
  }
  /// The one that is asked: 0 of a point.
  template <class T>
  T exact_offset(const Vec2<T>& u, double near) const {
    if (cuts) return T(cuts->exact);
    return drops() ? opening.gap(u, near).exact() : T(0);
  }
};

/// Of what the ball that sees this boundary is to reach; in the order of pockets, of balls as they are listed.
std::vector<Mark> marks_of(const Target& target, const Boundary& boundary);

/// Whether a ball must fall to reach it.
bool is_pocket(const Target& target);
/// Where some ball is to arrive, the struck one or one that it sends on; null of the other kinds.
const PointTarget* point_of(const Target& target);
const PocketTarget* pocket_of(const Target& target);
/// The ball that a carom is played off; 0 where there is none.
inline int off_of(const Target& target) {
  const auto* ball = std::get_if<BallTarget>(&target);
  return ball ? ball->off.value_or(0) : 0;
}
/// What the struck ball sends another to; null where it goes itself.
inline const Then* then_of(const Target& target) {
  const auto* ball = std::get_if<BallTarget>(&target);
  return ball && ball->then ? &*ball->then : nullptr;
}

}  // namespace bankshot
