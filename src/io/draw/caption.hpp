// SPDX-License-Identifier: MIT
//
// Draws what appears below the table: a title, rows of text, a picture of the tip position on the ball, legends.
#pragma once

#include <span>

#include "io/answer/words.hpp"
#include "io/draw/canvas.hpp"

namespace bankshot::drawing {

/// Draws a title and rows. If `tip` is given, its tip position is shown beside the rows.
void draw_caption(Canvas& c, const std::string& title, std::span<const Row> rows, const ShotRequest* tip = nullptr);

struct Swatch {
  std::string label, colour;
};

/// Draws the entries line by line, as many per line as fit.
void draw_legend(Canvas& c, std::span<const Swatch> entries);

struct Entry {
  int number;  ///< number on a disc in the path's colour
  std::string_view colour;
  std::string words;
};

/// Draws the entries in two columns, first down the left one.
void draw_list(Canvas& c, const std::string& title, std::span<const Entry> entries);

}  // namespace bankshot::drawing
