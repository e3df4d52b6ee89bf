// SPDX-License-Identifier: MIT
#include "bankshot/draw/map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "bankshot/draw/page.hpp"
#include "io/draw/caption.hpp"
#include "io/draw/path.hpp"
#include "io/draw/table.hpp"

namespace bankshot {
namespace {

/// Nine colours of the map viridis (Smith and van der Walt, 2015, CC0). Its lightness rises evenly, so that it
/// reads the same to colour-blind people and in print.
constexpr std::array<std::array<double, 3>, 9> viridis{{{68, 1, 84},
                                                        {71, 44, 122},
                                                        {59, 81, 139},
                                                        {44, 113, 142},
                                                        {33, 144, 141},
                                                        {39, 173, 129},
                                                        {92, 200, 99},
                                                        {170, 220, 50},
                                                        {253, 231, 37}}};

/// Above this value, a dark arrow is more visible on the colour than a white one.
constexpr double light = 0.55;

/// Interpolates linearly between the colours; `part` is from 0 to 1.
std::string colour(double part) {
  const double x = std::clamp(part, 0.0, 1.0) * (viridis.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(x), viridis.size() - 2);
  const double t = x - static_cast<double>(i);
  std::array<int, 3> c{};
  for (std::size_t k = 0; k < 3; ++k)
    c[k] = static_cast<int>(std::lround(viridis[i][k] + t * (viridis[i + 1][k] - viridis[i][k])));
  return fmt::format("#{:02x}{:02x}{:02x}", c[0], c[1], c[2]);
}

const Shot* shot_from(const StartMap& m, std::size_t i) {
  return m.starts[i] == Start::legal && !m.answers[i].shots.empty() ? &m.answers[i].shots.front() : nullptr;
}

/// Draws one table; `part` maps a shot to its place on the colour scale.
template <class Part>
std::string heat(const Puzzle& p, const StartMap& m, std::vector<LegendEntry> legend, const std::string& title,
                 Theme theme, Part&& part) {
  const drawing::Colours& c = drawing::colours(theme);
  std::vector<Cell> cells;
  bool without = false, unknown = false;
  for (std::size_t i = 0; i < m.starts.size(); ++i) {
    if (m.starts[i] != Start::legal) continue;
    const Vec2d half = m.grid.cell / 2.0, at = m.grid.at(i);
    const Shot* s = shot_from(m, i);
    const bool cut = m.answers[i].status == Status::budget;
    unknown = unknown || (!s && cut);
    without = without || (!s && !cut);
    const char* const none = cut ? c.faint : c.page;
    cells.push_back({at - half, at + half, s ? colour(part(*s)) : none,
                     s ? std::optional(s->launch.angle) : std::nullopt, s && part(*s) > light ? "#222" : "#fff"});
  }
  if (without) legend.push_back({"no shot", c.page});
  if (unknown) legend.push_back({"out of budget", c.faint});
  if (cells.size() < m.starts.size()) legend.push_back({"no start", c.cloth});
  return draw(p, cells, legend, title, {.theme = theme});
}

/// The colours of probabilities.
std::vector<LegendEntry> shares() {
  std::vector<LegendEntry> legend;
  for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0})
    legend.push_back({fmt::format("{:.0f} %", 100 * part), colour(part)});
  return legend;
}

/// Draws a narrow triangle that points along the aim.
void draw_arrow(drawing::Canvas& c, const Cell& cell) {
  const Vec2d size = cell.high - cell.low, middle = c.at(cell.low + size / 2.0);
  const double half = 0.38 * c.px(std::min(size.x, size.y));
  constexpr double least = 3, slender = 0.42;  // px; width over length
  if (!cell.aim || half < least) return;
  const Vec2d u = drawing::Canvas::flipped(direction(*cell.aim)) * half, side = perpendicular(u) * slender;
  const Vec2d tip = middle + u, a = side - u * 2.0, b = side * -2.0;
  c.add(R"(<path class="aim" d="M{:.1f} {:.1f}l{:.1f} {:.1f}l{:.1f} {:.1f}z" fill="{}" fill-opacity="0.7"/>)", tip.x,
        tip.y, a.x, a.y, b.x, b.y, cell.ink);
}

}  // namespace

std::string draw(const Puzzle& puzzle, std::span<const Cell> cells, std::span<const LegendEntry> legend,
                 const std::string& title, const PictureStyle& style) {
  drawing::Canvas c(puzzle.table, style);
  drawing::draw_table(c, style.words);
  constexpr double seam = 0.5;  // px; cells overlap by this, so that no cloth shows between them
  c.add(R"(<g shape-rendering="crispEdges">)");
  for (const Cell& cell : cells) {
    const Vec2d a = c.at({cell.low.x, cell.high.y}), b = c.at({cell.high.x, cell.low.y});
    c.add(R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" fill="{}"/>)", a.x, a.y, b.x - a.x + seam,
          b.y - a.y + seam, cell.fill);
  }
  c.add("</g>");
  for (const Cell& cell : cells) draw_arrow(c, cell);
  drawing::draw_holes(c);
  drawing::draw_target(c, puzzle);
  for (const Ball& other : puzzle.others) drawing::draw_other(c, other, other.at);
  std::vector<drawing::Swatch> swatches;
  for (const LegendEntry& entry : legend) swatches.push_back({entry.label, entry.colour});
  drawing::draw_legend(c, swatches);
  return c.document(title);
}

std::string draw(const Puzzle& p, const StartMap& m, Theme theme) {
  double slowest = HUGE_VAL, fastest = 0;
  bool has_success = false;
  for (std::size_t i = 0; i < m.starts.size(); ++i)
    if (const Shot* s = shot_from(m, i)) {
      slowest = std::min(slowest, s->launch.speed);
      fastest = std::max(fastest, s->launch.speed);
      has_success = has_success || s->robustness.success;
    }
  std::vector<LegendEntry> speed;
  for (int i = 0; i <= 4; ++i) {
    const double part = i / 4.0;
    // Slow is light, so that both maps are light at good starts. The scale is even in ln speed.
    if (i == 0 ? fastest > 0 : fastest > slowest)
      speed.push_back({fmt::format("{:.3g} m/s", slowest * std::pow(fastest / slowest, part)), colour(1 - part)});
  }
  Chapter page{"", "", {}};
  if (has_success)
    page.plates.push_back(
        {heat(p, m, shares(), "success", theme, [](const Shot& s) { return s.robustness.success.value_or(0); }),
         "How robust? The success of the best shot from here",
         {}});
  const double decades = fastest > slowest ? std::log(fastest / slowest) : 1;
  page.plates.push_back({heat(p, m, speed, "speed", theme,
                              [&](const Shot& s) { return 1 - std::log(s.launch.speed / slowest) / decades; }),
                         "How slow? Its launch speed",
                         {}});
  return draw_page(std::array{page}, {.letter = 20, .theme = theme});
}

std::string draw(const Puzzle& p, const ValueMap& m, Theme theme) {
  std::vector<Cell> cells;
  for (std::size_t i = 0; i < m.starts.size(); ++i)
    if (const Vec2d half = m.grid.cell / 2.0, at = m.grid.at(i); m.starts[i] == Start::legal)
      cells.push_back({at - half, at + half, colour(m.values[i].value)});
  std::vector<LegendEntry> legend = shares();
  if (cells.size() < m.starts.size()) legend.push_back({"no start", drawing::colours(theme).cloth});
  const Chapter page{
      "",
      "",
      {{draw(p, cells, legend, "value", {.theme = theme}), "How likely is the best straight pot from here?", {}}}};
  return draw_page(std::array{page}, {.letter = 20, .theme = theme});
}

}  // namespace bankshot
