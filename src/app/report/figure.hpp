// SPDX-License-Identifier: MIT
//
// Figures as data, drawn by gnuplot: panels of curves with bands, one legend below them all.
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
  double low, high;  ///< of the band; equal to y without one
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
  std::vector<std::string> names{};  ///< of 0, −1, −2 ... on an axis of names
};

struct Panel {
  std::string title;
  Axis x, y;
  std::vector<Curve> curves;
  /// Not empty: no axes, only a legend of these names, which the common one then leaves out; they begin anew with
  /// the first colour.
  std::vector<std::string> legend{};
};

struct Figure {
  std::vector<Panel> panels;
  int columns = 1;
  int row_height = 250;              ///< of 960 pixels across
  int left = 72;                     ///< pixels for labels and ticks of y
  std::vector<std::string> names{};  ///< of curves, in the legend's order; others follow
};

/// Gives these panels the same range of x, or of y: that of all their points.
void share_x(std::span<Panel> panels);
void share_y(std::span<Panel> panels);

/// The commands that make gnuplot draw the figure into `svg`.
std::string gnuplot_script(const Figure& figure, const std::string& svg);

/// gnuplot cannot be run, or fails.
class DrawingError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws DrawingError, with one line that names the package, when there is no gnuplot.
void find_gnuplot();
/// Runs gnuplot on a script; throws likewise.
void run_gnuplot(const std::string& script);

}  // namespace bankshot::app::report
