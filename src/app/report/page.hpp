// SPDX-License-Identifier: MIT
//
// The report as a page that opens offline, and as Markdown. Each section opens with a question and says what was
// measured. One figure and one table follow, and a conclusion from the numbers in a few plain sentences.
#pragma once

#include <string>
#include <vector>

#include "app/report/figure.hpp"

namespace bankshot::app::report {

struct Numbers {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  /// Number of leading columns with text, set left; the others are numbers, set right.
  std::size_t text_columns = 1;
};

/// Raw numbers, written to NAME.csv.
struct Csv {
  std::string name, text;
};

struct Section {
  std::string name{};  ///< base name of its files
  std::string title{};
  std::string question{};  ///< that the section answers
  std::string about{};     ///< what was measured, and how
  Figure figure{};
  std::string caption{};
  Numbers table{};
  std::string conclusion{};  ///< a few sentences for a layman, from the numbers
  std::vector<Csv> data{};
};

struct Page {
  std::string caption;  ///< machine, compiler, commit, and number of shots
  std::vector<Section> sections;
};

/// `figures`: the SVG text of each section; empty if none could be drawn.
std::string to_html(const Page& page, const std::vector<std::string>& figures);
std::string to_markdown(const Page& page, const std::vector<std::string>& figures);

}  // namespace bankshot::app::report
