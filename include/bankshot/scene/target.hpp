// SPDX-License-Identifier: MIT
//
// What a shot must reach. A target is data, as the puzzle gives it; its *marks*, made once for a table and a ball,
// answer whatever is asked about it: where seeds aim, what counts as met, how wide it is, the miss. No other file asks
// which kind a target is, but for those that read and write the format and the 50-digit checker, which shares nothing.
//   point   the centre passes within `within` of it, or comes to rest there: one mark
//   pocket  the ball falls into it: a mark for each arc of its circle where a ball can enter, mostly one; any pocket:
//           those of each
#pragma once

#include <optional>
#include <string>
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

using Target = std::variant<PointTarget, PocketTarget>;

/// One place to aim at.
struct Mark {
  Vec2d at{};          ///< the point, or the pocket's centre
  double reach = 0;    ///< m: how far off still counts: `within`, or the radius of capture
  Contact taken_by{};  ///< the pocket that ends the path; none: the ball passes here, or rests
  Opening opening{};   ///< of a pocket

  bool operator==(const Mark&) const = default;
  bool captures() const { return taken_by.kind == ContactKind::pocket; }
  /// How far before the mark the ball arrives [m].
  double capture() const { return captures() ? reach : 0; }
  /// From where a ball arrived to the point, or to the arc of the pocket's circle [m].
  double apart(const Vec2d& arrived) const;
  /// What a shot along the unit vector u should have of a line's offset [m, see opening.hpp]: 0 of a point. `near`: the
  /// offset it has.
  template <class T>
  T exact_offset(const Vec2<T>& u, double near) const {
    return captures() ? opening.gap(u, near).exact() : T(0);
  }
};

/// In the order of pockets.
std::vector<Mark> marks_of(const Target& target, const Boundary& boundary);

/// Whether the ball must fall to reach it.
bool is_pocket(const Target& target);

/// As the end of a sentence about a ball: "into top-right", "to rest in the ring", "through the ring". `rests`: the
/// arrival speed asked is 0.
std::string in_words(const Target& target, const Table& table, bool rests);

}  // namespace bankshot
