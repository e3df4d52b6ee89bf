// SPDX-License-Identifier: MIT
//
// Several pictures on one page, with headings and captions: SVG text made of SVG texts.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "bankshot/draw/style.hpp"

namespace bankshot {

struct Plate {
  std::string svg;                     ///< a picture of draw/svg.hpp
  std::string title{};                 ///< above it
  std::vector<std::string> caption{};  ///< below it, line by line
};

struct Chapter {
  std::string title, subtitle;
  std::vector<Plate> plates;
};

struct PageStyle {
  int columns = 1;
  double plate = 1000;  ///< px, the width of a plate
  double ratio = 0;     ///< of the space for a picture, height over width; 0: a row is as high as its highest
  double letter = 18;   ///< px, of captions
  std::string title{}, subtitle{};
  Theme theme = Theme::light;
};

std::string draw_page(std::span<const Chapter> chapters, const PageStyle& style);

}  // namespace bankshot
