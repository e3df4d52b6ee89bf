// SPDX-License-Identifier: MIT
//
// Acceptance of a pocket: the straight lines along which a rolling ball drops into it, from all directions and at all
// offsets from its centre, at one speed. Every ball is simulated until it drops, rests, or is 1.5 times as far from the
// pocket as at its start.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "bankshot/scene/scene.hpp"

namespace bankshot {

/// `past`: the ball meets no jaw and does not drop, or no ball fits on that line.
enum class Entry { past, out, rattles, clean };
const char* name(Entry entry);  ///< "past", "comes-out", "rattles-in", "clean"

/// Result for one pocket at one speed, at whole degrees.
struct Acceptance {
  static constexpr double step = 0.0005;  ///< m, from one line to the next

  double speed = 0;              ///< m/s, where the ball starts, three mouths away
  int steepest = 0;              ///< degrees: lines from -steepest to steepest can lead in ...
  int widest = 0;                ///< steps: ... with offsets from -widest to widest
  std::vector<Entry> entries{};  ///< angle by angle, the offsets of each in order

  /// Returns the entry of one line. Its direction of travel is `degrees`, anticlockwise from straight out of the table.
  /// Its offset from the centre of the capture circle is `steps`, positive if it passes on the left of the centre.
  Entry at(int degrees, int steps) const {
    const int row = steps + widest;
    return offsets(degrees)[static_cast<std::size_t>(row)];
  }
  std::span<const Entry> offsets(int degrees) const {
    const int column = degrees + steepest, lines = 2 * widest + 1;
    return std::span(entries).subspan(static_cast<std::size_t>(column) * static_cast<std::size_t>(lines),
                                      static_cast<std::size_t>(lines));
  }
  /// Returns the width of a strip of as many parallel lines as have at least this entry, `rattles` or `clean` [m].
  double width(int degrees, Entry at_least) const;
};

/// Simulates balls that roll naturally, by the scene's laws. Throws InvalidInput for a pocket away from all rails.
Acceptance acceptance(const Scene& scene, int pocket, double speed);

/// Returns CSV: the header speed_m_per_s,angle_deg,offset_m,entry and one row per line of travel.
std::string to_csv(std::span<const Acceptance> windows);

}  // namespace bankshot
