// SPDX-License-Identifier: MIT
//
// The roots that a map finds, sequence by sequence. A node of the map predicts where the root of its sequence lies;
// a prediction within reach seeds Newton's method on the locked path, unless that leads to a root that is known.
// Each root becomes a shot, or a lead. What one seed cannot see is sought besides: the other root of a pair across a
// fold or a kink, and roots of sequences that were seen but gave none.
#pragma once

#include <array>
#include <limits>
#include <string_view>
#include <vector>

#include "planners/locked/residual.hpp"
#include "planners/methods/methods.hpp"

namespace bankshot::planning {

/// Cells from a node to a root that it may seed.
inline constexpr double seed_reach = 1.5;

class Roots {
 public:
  Roots(Search& s, const Spacing& cell, std::string_view planner) : s_(s), cell_(cell), planner_(planner) {}

  /// A node that meets these cushions, and how it misses the target.
  void visit(const LockedAim& aim, const Launch& node, const Linear& linear);

  /// Sequences that were visited and have no root yet: from the nodes that came nearest.
  void seek_rest();

  /// Nothing more is looked for: one sequence hardly ever has two roots.
  bool done() const {
    return s_.spent() || s_.satisfied() || (s_.puzzle.cushions.sequence && !s_.all && !s_.shots.empty());
  }

 private:
  /// Of one sequence and target.
  struct Root {
    std::vector<Contact> contacts;
    Vec2d target;
    Launch launch;
  };
  static constexpr double none = std::numeric_limits<double>::infinity();
  struct Nearest {
    Launch launch{};
    double miss = none;  ///< of the residual
  };
  /// A sequence and target that were visited, and the nodes that came nearest.
  struct Seen {
    std::vector<Contact> contacts;
    Vec2d target;
    std::array<Nearest, 3> nearest{};
  };
  template <class Of>
  static bool belongs(const Of& x, const LockedAim& aim) {
    return x.target == aim.target && std::ranges::equal(x.contacts, aim.contacts);
  }

  Seen& seen(const LockedAim& aim);
  void keep_nearest(const LockedAim& aim, const Launch& node, double miss);
  bool known(const LockedAim& aim, const Launch& l, double cells) const;
  void add(const LockedAim& aim, const Launch& root);
  void across_fold(const LockedAim& aim, const Launch& root);
  bool beside_last(const LockedAim& aim) const;
  std::optional<Launch> after_last(const LockedAim& aim, const Launch& from);

  Search& s_;
  Spacing cell_;
  std::string_view planner_;
  std::vector<Root> roots_{};
  std::vector<Seen> seen_{};
  std::size_t last_seen_ = 0;
};

}  // namespace bankshot::planning
