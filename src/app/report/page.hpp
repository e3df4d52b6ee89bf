// SPDX-License-Identifier: MIT
//
// The report as a page that opens offline, and as Markdown: each section a paragraph on what was
// measured, one figure, one table, one sentence that follows from the numbers.
#pragma once

#include <string>
#include <vector>

#include "app/report/figure.hpp"

namespace bankshot::app::report {

struct Numbers {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  std::size_t text_columns = 1;  ///< the first of them, set left; the others are numbers, set right
};

/// Raw numbers, written to NAME.csv.
struct Csv {
  std::string name, text;
};

struct Section {
  std::string name{};  ///< of its files
  std::string title{};
  std::string about{};  ///< what was measured, and how
  Figure figure{};
  std::string caption{};
  Numbers table{};
  std::string conclusion{};  ///< one sentence, from the numbers
  std::vector<Csv> data{};
};

struct Page {
  std::string caption;  ///< machine, compiler, commit, and how many shots
  std::vector<Section> sections;
};

/// `figures`: the SVG text of each section; empty where none could be drawn.
std::string to_html(const Page& page, const std::vector<std::string>& figures);
std::string to_markdown(const Page& page, const std::vector<std::string>& figures);

}  // namespace bankshot::app::report
