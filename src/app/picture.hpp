// SPDX-License-Identifier: MIT
//
// Pictures to files, as SVG or, where librsvg was there at the build, as PNG; and the flags that ask for them.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/files.hpp"
#include "bankshot/draw/style.hpp"

namespace bankshot::app {

/// As PNG where the name ends so.
void write_picture(const std::string& path, const std::string& svg);

/// Its name ends in .csv, packed or not.
bool is_table(const std::string& path);

/// A check of a file's name: why no picture can go there, empty when one can.
std::string picture_name(const std::string& path);

/// -o of a command that writes `what` (.svg, .png) or a table (.csv), or both.
void add_output_option(CLI::App& command, std::vector<std::string>& files, const std::string& what);

/// Functions without arguments that make the text of either.
template <class Table, class Picture>
void write_outputs(const std::vector<std::string>& files, const Table& table, const Picture& picture) {
  for (const std::string& file : files) is_table(file) ? write_file(file, table()) : write_picture(file, picture());
}

struct PictureFlags {
  std::string svg, png;
  PictureStyle style{};

  /// `draw(style)` makes the SVG text; it runs only when a picture is wanted.
  template <class Draw>
  void write(const Draw& draw) const {
    if (svg.empty() && png.empty()) return;
    const std::string text = draw(style);
    if (!svg.empty()) write_file(svg, text);
    if (!png.empty()) write_picture(png, text);
  }
};

void add_theme_flag(CLI::App& command, Theme& theme);
void add_picture_flags(CLI::App& command, PictureFlags& flags);

}  // namespace bankshot::app
