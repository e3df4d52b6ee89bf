// SPDX-License-Identifier: MIT
//
// Figures as data, drawn by gnuplot: panels of curves with bands, and one legend below them all.
#pragma once

#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/report/measure.hpp"
#include "bankshot/scene/puzzle.hpp"

namespace bankshot::app::report {

struct Point {
  double x, y;
  double low, high;  ///< ends of the band; equal to y if there is none
};

struct Curve {
  std::string name;  ///< curves of one name have one colour and one entry in the legend
  std::vector<Point> points;
  enum class Style { line_points, points, dashes } style = Style::line_points;
};

struct Axis {
  std::string label;
  bool logarithmic = false;
  std::optional<Range> range{};
  std::vector<std::string> names{};  ///< labels of 0, −1, −2 ... on an axis of names
};

struct Panel {
  std::string title;
  Axis x, y;
  std::vector<Curve> curves;
  /// If not empty, the panel has no axes and shows only a legend of these names. The common legend leaves them out, and
  /// their colours begin again with the first.
  std::vector<std::string> legend{};
};

struct Figure {
  std::vector<Panel> panels;
  int columns = 1;
  int row_height = 250;              ///< pixels; a figure is 960 pixels wide
  int left = 72;                     ///< pixels for labels and ticks of y
  std::vector<std::string> names{};  ///< names of curves, in the legend's order; others follow
};

/// Gives these panels the same range of x, or of y, which covers all their points.
void share_x(std::span<Panel> panels);
void share_y(std::span<Panel> panels);

/// Returns the commands that make gnuplot draw the figure into `svg`.
std::string gnuplot_script(const Figure& figure, const std::string& svg);

/// gnuplot cannot be run, or it fails.
class DrawingError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws DrawingError, with one line that names the package, if there is no gnuplot.
void find_gnuplot();
/// Runs gnuplot on a script; throws DrawingError if that fails.
void run_gnuplot(const std::string& script);

}  // namespace bankshot::app::report
