// SPDX-License-Identifier: MIT
//
// What stands below the table: a title, rows of words, a picture of the ball with the tip's place, legends.
#pragma once

#include <span>

#include "answer/words.hpp"
#include "draw/canvas.hpp"

namespace bankshot::drawing {

/// `tip`: whose tip is shown beside the rows; none without.
void draw_caption(Canvas& c, const std::string& title, std::span<const Row> rows, const ShotRequest* tip = nullptr);

struct Swatch {
  std::string label, colour;
};

/// One line after another, as many entries in each as fit.
void draw_legend(Canvas& c, std::span<const Swatch> entries);

struct Entry {
  int number;  ///< on the disc, in the path's colour
  std::string_view colour;
  std::string words;
};

/// In two columns, down the first and then the second.
void draw_list(Canvas& c, const std::string& title, std::span<const Entry> entries);

}  // namespace bankshot::drawing
