// SPDX-License-Identifier: MIT
//
// Writes pictures to files: as SVG or, if librsvg was present at the build, as PNG. Also the flags that ask for
// pictures.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/files.hpp"
#include "bankshot/draw/style.hpp"

namespace bankshot::app {

/// Writes a PNG if the name ends in .png, else the SVG itself.
void write_picture(const std::string& path, const std::string& svg);

/// Returns whether the name ends in .csv, packed or not.
bool is_table(const std::string& path);

/// Checks a file name: returns why no picture can be written there, or an empty text.
std::string picture_name(const std::string& path);

/// Adds the option -o of a command that writes `what` (.svg, .png), a table (.csv), or both.
void add_output_option(CLI::App& command, std::vector<std::string>& files, const std::string& what);

/// Writes each file; `table()` and `picture()` return the text of either kind.
template <class Table, class Picture>
void write_outputs(const std::vector<std::string>& files, const Table& table, const Picture& picture) {
  for (const std::string& file : files) is_table(file) ? write_file(file, table()) : write_picture(file, picture());
}

struct PictureFlags {
  std::string svg, png;
  PictureStyle style{};

  /// Writes the pictures asked for. `draw(style)` returns the SVG text and runs only if a picture is wanted.
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
