// SPDX-License-Identifier: MIT
#include "app/report/figure.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>

extern char** environ;

namespace bankshot::app::report {
namespace {

// Pixels.
constexpr int width = 960, right = 14, top = 30, bottom = 52, legend_row = 22, legend_columns = 4;

/// Colours that most readers with reduced colour vision can tell apart, dark enough for thin lines. The first curve,
/// ours, is black.
constexpr const char* colours[] = {"#111111", "#0072b2", "#d55e00", "#009e73", "#b8489a",
                                   "#c58b00", "#3aa3dc", "#7a6fd0", "#8b5a2b", "#7f7f7f"};
constexpr int marks[] = {7, 5, 9, 11, 13, 4, 6, 8, 10, 12};

/// Escapes `text` so that gnuplot's enhanced mode shows it unchanged.
std::string plain(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (std::strchr("_@&~^{}", c)) out += "\\\\";
    if (c == '"') out += '\\';
    out += c;
  }
  return out;
}

/// Quotes a file name for gnuplot; within double quotes it would run what stands in back quotes.
std::string quoted(const std::string& file) {
  std::string out = "'";
  for (const char c : file) out += c == '\'' ? "''" : std::string(1, c);
  return out + "'";
}

/// Returns whether the axes can show the point; a logarithmic axis shows only positive numbers.
bool shown(const Axis& x, const Axis& y, const Point& p) {
  const auto fits = [](const Axis& axis, double v) { return std::isfinite(v) && (!axis.logarithmic || v > 0); };
  return fits(x, p.x) && fits(y, p.y);
}

void widen(std::optional<Range>& r, double v) {
  if (!r) r = Range{v, v};
  r->low = std::min(r->low, v);
  r->high = std::max(r->high, v);
}

/// Returns the range of all points of the panels on one axis, with some space at both ends.
Range extent(std::span<const Panel> panels, Axis Panel::*axis, double Point::*number) {
  std::optional<Range> r;
  for (const Panel& panel : panels)
    for (const Curve& c : panel.curves)
      for (const Point& p : c.points)
        if (shown(panel.x, panel.y, p)) widen(r, p.*number);
  const bool logarithmic = !panels.empty() && (panels.front().*axis).logarithmic;
  if (!r) return logarithmic ? Range{0.1, 10} : Range{0, 1};
  constexpr double room = 0.05;
  if (logarithmic) {
    const double by = std::pow(r->high / r->low, room) * 1.3;
    r = Range{r->low / by, r->high * by};
    constexpr double few = 1e3;  // whole decades, so that there are ticks with numbers
    if (r->high / r->low > few) return *r;
    return {std::pow(10, std::floor(std::log10(r->low))), std::pow(10, std::ceil(std::log10(r->high)))};
  }
  const double by = r->high > r->low ? room * (r->high - r->low) : 0.5;
  return {r->low - by, r->high + by};
}

/// Returns the commands that set an axis's range, ticks and label.
std::string set_axis(char name, const Axis& axis, const Range& range) {
  std::string out = axis.logarithmic ? fmt::format("set logscale {0}\nset format {0} \"10^{{%T}}\"\n", name)
                                     : fmt::format("unset logscale {0}\nset format {0} \"%g\"\n", name);
  out += fmt::format("set {}range [{:.6g}:{:.6g}]\n", name, range.low, range.high);
  if (!axis.names.empty()) {
    out += fmt::format("set {}tics (", name);
    for (std::size_t i = 0; i < axis.names.size(); ++i)
      out += fmt::format("{}\"{}\" {}", i ? ", " : "", plain(axis.names[i]), -static_cast<int>(i));
    out += ")\n";
  } else if (axis.logarithmic) {
    constexpr double most_ticks = 6;
    const double decades = std::log10(range.high / range.low), step = std::max(1.0, std::ceil(decades / most_ticks));
    out += fmt::format("set {}tics {:.0e}\nset m{}tics {}\n", name, std::pow(10, step), name,
                       step > 1 ? static_cast<int>(step) : 1);
  } else {
    out += fmt::format("set {0}tics autofreq\nset m{0}tics 1\n", name);
  }
  return out + fmt::format("set {}label \"{}\"\n", name, plain(axis.label));
}

/// The names of curves; the number of a name gives its colour and mark.
struct Names {
  std::vector<std::string> common;
  std::vector<std::string> apart;  ///< names in panels that are legends

  explicit Names(const Figure& f) : common(f.names) {
    for (const Panel& p : f.panels) apart.insert(apart.end(), p.legend.begin(), p.legend.end());
    for (const Panel& p : f.panels)
      for (const Curve& c : p.curves)
        if (!holds(common, c.name) && !holds(apart, c.name)) common.push_back(c.name);
  }
  std::size_t number(const std::string& name) const {
    const auto& in = holds(apart, name) ? apart : common;
    return static_cast<std::size_t>(std::find(in.begin(), in.end(), name) - in.begin());
  }
  static bool holds(const std::vector<std::string>& in, const std::string& name) {
    return std::find(in.begin(), in.end(), name) != in.end();
  }
};

std::string style(const Names& names, const std::string& name, Curve::Style kind) {
  const std::size_t i = names.number(name);
  const std::string colour = colours[i % std::size(colours)];
  if (kind == Curve::Style::dashes) return fmt::format("with lines dashtype 2 linewidth 1.2 linecolor \"{}\"", colour);
  const double size = kind == Curve::Style::points || i == 0 ? 0.65 : 0.5;
  return fmt::format("with {} linewidth {} pointtype {} pointsize {} linecolor \"{}\"",
                     kind == Curve::Style::points ? "points" : "linespoints", i == 0 ? 2.2 : 1.4,
                     marks[i % std::size(marks)], size, colour);
}

/// Returns the entries of a plot that shows nothing but its key.
std::string key_of(const Figure& f, const Names& names, const std::vector<std::string>& shown_names) {
  std::string out;
  for (const std::string& name : shown_names) {
    Curve::Style kind = Curve::Style::line_points;
    for (auto p = f.panels.rbegin(); p != f.panels.rend(); ++p)  // the style where the name first appears
      for (const Curve& c : p->curves)
        if (c.name == name) kind = c.style;
    out += fmt::format("{}NaN {} title \"{}\"", out.empty() ? "plot " : ", \\\n     ", style(names, name, kind),
                       plain(name));
  }
  return out + "\n";
}

constexpr const char* with_axes =
    "set border 3 linecolor \"#555555\" linewidth 0.8\nset tics nomirror textcolor \"#333333\" scale 0.6,0.3\n"
    "set grid linecolor \"#e4e4e4\" linewidth 0.6, linecolor \"#e4e4e4\" linewidth 0.6\n";
constexpr const char* without_axes =
    "unset border\nunset tics\nunset xlabel\nunset ylabel\nunset title\nunset logscale\nunset grid\nset xrange "
    "[0:1]\nset yrange [0:1]\n";

std::string draw_legend_panel(const Figure& f, const Panel& p, const Names& names) {
  return std::string(without_axes) + "set key center left vertical Left reverse maxcols 1 samplen 2.2\n" +
         key_of(f, names, p.legend) + "set key off\n" + with_axes;
}

std::string draw_panel(const Panel& p, const Names& names, int number) {
  std::string data, plots;
  const auto add = [&](const std::string& what) { plots += (plots.empty() ? "plot " : ", \\\n     ") + what; };
  std::vector<std::string> lines;
  int block = 0;
  for (const Curve& c : p.curves) {
    const std::string name = fmt::format("$p{}c{}", number, block++);
    data += name + " << EOD\n";
    bool band = false, any = false;
    for (const Point& point : c.points) {
      if (!shown(p.x, p.y, point)) continue;
      data += fmt::format("{:.8g} {:.8g} {:.8g} {:.8g}\n", point.x, point.y, point.low, point.high);
      band = band || point.low != point.high;
      any = true;
    }
    data += "EOD\n";
    if (!any) continue;
    const std::size_t i = names.number(c.name);
    if (band)
      add(fmt::format(
          "{} using 1:3:4 with filledcurves fillstyle transparent solid 0.12 noborder fillcolor \"{}\" notitle", name,
          colours[i % std::size(colours)]));
    lines.push_back(fmt::format("{} using 1:2 {} notitle", name, style(names, c.name, c.style)));
  }
  for (auto line = lines.rbegin(); line != lines.rend(); ++line) add(*line);  // the first on top
  if (plots.empty()) plots = "plot NaN notitle";
  const Range x = p.x.range.value_or(extent({&p, 1}, &Panel::x, &Point::x)),
              y = p.y.range.value_or(extent({&p, 1}, &Panel::y, &Point::y));
  return data + fmt::format("set title \"{}\" offset 0,-0.6\n", plain(p.title)) + set_axis('x', p.x, x) +
         set_axis('y', p.y, y) + plots + "\n";
}

/// Draws a strip below all panels that holds their common legend.
std::string draw_legend(const Figure& f, const Names& names, int height, int strip) {
  return without_axes +
         fmt::format(
             "set lmargin at screen 0.02\nset rmargin at screen 0.98\nset tmargin at screen {:.5f}\nset bmargin at "
             "screen 0.0\n"
             "set key center center horizontal Left reverse maxcols {} samplen 2.2 width 1\n",
             static_cast<double>(strip) / height, legend_columns) +
         key_of(f, names, names.common);
}

}  // namespace

void share_x(std::span<Panel> panels) {
  const Range r = extent(panels, &Panel::x, &Point::x);
  for (Panel& p : panels) p.x.range = r;
}

void share_y(std::span<Panel> panels) {
  const Range r = extent(panels, &Panel::y, &Point::y);
  for (Panel& p : panels) p.y.range = r;
}

std::string gnuplot_script(const Figure& f, const std::string& svg) {
  const Names names(f);
  const int panels = static_cast<int>(f.panels.size()), rows = (panels + f.columns - 1) / f.columns;
  const int strip =
      names.common.empty()
          ? 4
          : 10 + legend_row * ((static_cast<int>(names.common.size()) + legend_columns - 1) / legend_columns);
  const int height = rows * f.row_height + strip;
  std::string out = fmt::format(
      "set terminal svg size {},{} fixed enhanced font \"sans-serif,12\" background \"#ffffff\"\nset output {}\nset "
      "encoding utf8\nset "
      "multiplot\nset key off\n"
      "{}set xlabel offset 0,0.4\nset ylabel offset 0.6,0\n",
      width, height, quoted(svg), with_axes);
  for (int i = 0; i < panels; ++i) {
    const int row = i / f.columns, column = i % f.columns;
    const double across = static_cast<double>(width) / f.columns;
    const auto x = [&](double pixel) { return (column * across + pixel) / width; };
    const auto y = [&](double pixel) { return 1 - (row * f.row_height + pixel) / height; };
    out += fmt::format(
        "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\nset tmargin at screen {:.5f}\nset bmargin at "
        "screen {:.5f}\n",
        x(f.left), x(across - right), y(top), y(f.row_height - bottom));
    const Panel& p = f.panels[static_cast<std::size_t>(i)];
    out += p.legend.empty() ? draw_panel(p, names, i) : draw_legend_panel(f, p, names);
  }
  if (!names.common.empty()) out += draw_legend(f, names, height, strip);
  return out + "unset multiplot\n";
}

namespace {

/// Runs gnuplot with one argument and returns its exit code. Without `loud` its output is discarded.
int run_with(std::string argument, bool loud) {
  std::string program = "gnuplot";
  char* arguments[] = {program.data(), argument.data(), nullptr};
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  if (!loud) posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const int problem = posix_spawnp(&child, "gnuplot", &files, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&files);
  if (problem == ENOENT) throw DrawingError("gnuplot is not installed (apt-get install gnuplot-nox)");
  if (problem) throw DrawingError(fmt::format("gnuplot cannot be run: {}", std::strerror(problem)));
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

void find_gnuplot() {
  if (run_with("--version", false) != 0) throw DrawingError("gnuplot (package gnuplot-nox) does not run");
}

void run_gnuplot(const std::string& script) {
  if (run_with(script, true) != 0)
    throw DrawingError(fmt::format("gnuplot (package gnuplot-nox) cannot draw {}", script));
}

}  // namespace bankshot::app::report
