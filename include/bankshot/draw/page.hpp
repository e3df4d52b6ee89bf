// SPDX-License-Identifier: MIT
//
// Combines several SVG pictures on one page, with headings and captions.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "bankshot/draw/style.hpp"

namespace bankshot {

struct Plate {
  std::string svg;                     ///< a picture from draw/svg.hpp
  std::string title{};                 ///< above it
  std::vector<std::string> caption{};  ///< below it, line by line
};

struct Chapter {
  std::string title, subtitle;
  std::vector<Plate> plates;
};

struct PageStyle {
  int columns = 1;
  double plate = 1000;  ///< width of a plate [px]
  double ratio = 0;     ///< height over width of the space for a picture; 0: a row is as high as its tallest picture
  double letter = 18;   ///< font size of captions [px]
  std::string title{}, subtitle{};
  Theme theme = Theme::light;
};

std::string draw_page(std::span<const Chapter> chapters, const PageStyle& style);

}  // namespace bankshot
