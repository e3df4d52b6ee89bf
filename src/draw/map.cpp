// SPDX-License-Identifier: MIT
#include "bankshot/draw/map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "bankshot/draw/page.hpp"

namespace bankshot {
namespace {

constexpr const char* hole = "#f4f1ea";
constexpr const char* cloth = "#1f7a4d";

/// Of the colour map viridis (Smith and van der Walt, 2015, CC0): its lightness rises evenly, so that it
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

/// Above this part a dark line is seen better on it than a white one.
constexpr double light = 0.55;

/// Between two of its colours in a straight line; `part` from 0 to 1.
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

/// One table; `part` of a shot picks its colour.
template <class Part>
std::string heat(const Puzzle& p, const StartMap& m, std::vector<LegendEntry> legend, const std::string& title,
                 Part&& part) {
  std::vector<Cell> cells;
  bool holes = false;
  for (std::size_t i = 0; i < m.starts.size(); ++i) {
    if (m.starts[i] != Start::legal) continue;
    const Vec2d half = m.grid.cell / 2.0, at = m.grid.at(i);
    const Shot* s = shot_from(m, i);
    holes = holes || !s;
    cells.push_back({at - half, at + half, s ? colour(part(*s)) : hole,
                     s ? std::optional(s->launch.angle) : std::nullopt, s && part(*s) > light ? "#222" : "#fff"});
  }
  if (holes) legend.push_back({"no shot", hole});
  if (cells.size() < m.starts.size()) legend.push_back({"no start", cloth});
  return draw(p, cells, legend, title);
}

}  // namespace

std::string draw(const Puzzle& p, const StartMap& m) {
  double slowest = HUGE_VAL, fastest = 0;
  bool success = false;
  for (std::size_t i = 0; i < m.starts.size(); ++i)
    if (const Shot* s = shot_from(m, i)) {
      slowest = std::min(slowest, s->launch.speed);
      fastest = std::max(fastest, s->launch.speed);
      success = success || s->success;
    }
  std::vector<LegendEntry> chance, speed;
  for (int i = 0; i <= 4; ++i) {
    const double part = i / 4.0;
    chance.push_back({fmt::format("{:.0f} %", 100 * part), colour(part)});
    // Slow is light: both maps are light where a player would like to be. Evenly in ln speed.
    if (i == 0 ? fastest > 0 : fastest > slowest)
      speed.push_back({fmt::format("{:.3g} m/s", slowest * std::pow(fastest / slowest, part)), colour(1 - part)});
  }
  Chapter page{"", "", {}};
  if (success)
    page.plates.push_back({heat(p, m, chance, "chance", [](const Shot& s) { return s.success.value_or(0); }),
                           "How robust? The chance that the best shot from here is made",
                           {}});
  const double decades = fastest > slowest ? std::log(fastest / slowest) : 1;
  page.plates.push_back(
      {heat(p, m, speed, "speed", [&](const Shot& s) { return 1 - std::log(s.launch.speed / slowest) / decades; }),
       "How slow? Its launch speed",
       {}});
  return draw_page(std::array{page}, {.letter = 20});
}

}  // namespace bankshot
