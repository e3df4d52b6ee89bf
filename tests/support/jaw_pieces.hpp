// SPDX-License-Identifier: MIT
//
// Places where a ball touches the jaws of a preset's pockets, and the pieces opposite them in a mirror.
#pragma once

#include <algorithm>
#include <cmath>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/scene/table.hpp"
#include "support/random_puzzle.hpp"

namespace bankshot::test {

/// A preset with jaws, and the boundary for the centre of its ball.
struct JawTable {
  explicit JawTable(const TablePreset& of) : preset(of), table(make_table(of, true)), boundary(table, of.body) {}
  static JawTable draw(Random& r) {
    constexpr const char* names[] = {"pool-7ft", "pool-8ft", "pool-9ft", "snooker-12ft"};
    return JawTable(*find_table_preset(names[r.integer(0, 3)]));
  }

  const TablePreset& preset;
  Table table;
  Boundary boundary;

  /// Draws a facing or tip that exists on this table.
  Contact draw_jaw(Random& r) const {
    for (;;) {
      const Contact jaw = Contact::jaw(r.integer(0, 5), r.integer(0, 3));
      const bool faced = boundary.jaws[static_cast<std::size_t>(jaw.jaw_pocket())].faced;
      if (faced || !boundary.line(jaw)) return jaw;
    }
  }
  /// Draws a centre of a ball that touches the jaw.
  Vec2d touching(Contact jaw, Random& r) const {
    if (const Wall* const facing = boundary.line(jaw))
      return facing->from + (facing->to - facing->from) * r.uniform(0, 1);
    const Circle& tip = *boundary.rim(jaw);
    const double half = std::acos(tip.extent), middle = std::atan2(tip.middle.y, tip.middle.x);
    return tip.centre + direction(middle + half * r.uniform(-1, 1)) * tip.radius;
  }
  /// Returns the place with left and right swapped.
  Vec2d mirrored(const Vec2d& at) const { return {preset.length - at.x, at.y}; }
  Contact mirrored(Contact jaw) const {
    const auto nearest = [&](const Vec2d& at) {
      const auto apart = [&](const Pocket& p) { return norm(p.at - at); };
      return static_cast<int>(std::ranges::min_element(table.pockets, {}, apart) - table.pockets.begin());
    };
    const Vec2d at = table.pockets[static_cast<std::size_t>(jaw.jaw_pocket())].at;
    return Contact::jaw(nearest(mirrored(at)), 3 - jaw.jaw_piece());
  }
};

}  // namespace bankshot::test
