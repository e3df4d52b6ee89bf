// SPDX-License-Identifier: MIT
//
// What a pocket takes: balls that roll at it along straight lines, from all sides and beside its centre, at one speed.
// Every ball is simulated, until it drops, rests, or is farther from the pocket than it began.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "bankshot/scene/scene.hpp"

namespace bankshot {

/// past: it meets no jaw and does not drop, or no ball has room on that line.
enum class Entry { past, out, rattles, clean };
const char* name(Entry entry);  ///< "past", "comes-out", "rattles-in", "clean"

/// Of a pocket at one speed, at whole degrees.
struct Acceptance {
  static constexpr double step = 0.0005;  ///< m, from one line to the next

  double speed = 0;              ///< m/s, where the ball sets out, three mouths away
  int steepest = 0;              ///< degrees: lines from -steepest to steepest can lead in ...
  int widest = 0;                ///< steps: ... with offsets from -widest to widest
  std::vector<Entry> entries{};  ///< angle by angle, the offsets of each in order

  /// `degrees`: of the line of travel, anticlockwise from straight out of the table. `steps`: of its offset from the
  /// centre of the capture circle, positive where it passes on the left of it.
  Entry at(int degrees, int steps) const {
    const int row = steps + widest;
    return offsets(degrees)[static_cast<std::size_t>(row)];
  }
  std::span<const Entry> offsets(int degrees) const {
    const int column = degrees + steepest, lines = 2 * widest + 1;
    return std::span(entries).subspan(static_cast<std::size_t>(column) * static_cast<std::size_t>(lines),
                                      static_cast<std::size_t>(lines));
  }
  /// So wide is a strip of parallel lines as many as drop, or as are clean [m].
  double width(int degrees, Entry at_least) const;
};

/// The ball rolls naturally, by the scene's laws. Throws InvalidInput of a pocket in the open.
Acceptance acceptance(const Scene& scene, int pocket, double speed);

/// speed_m_per_s,angle_deg,offset_m,entry: a row a line, with a header.
std::string to_csv(std::span<const Acceptance> windows);

}  // namespace bankshot
