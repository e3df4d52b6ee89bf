// SPDX-License-Identifier: MIT
#include "bankshot/draw/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bankshot/draw/page.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "io/draw/path.hpp"
#include "io/draw/table.hpp"

namespace bankshot {
namespace {

using namespace drawing;

constexpr double mm = 1000;

ShotRequest played(const Recording& recording, const FittedShot& shot, const Physics& physics) {
  ShotRequest out = recording.scene;
  out.physics = physics;
  out.ball.at = shot.at;
  out.launch = shot.launch;
  out.spin = shot.spin;
  double last = 0;
  for (const Track& track : recording.tracks)
    if (!track.samples.empty()) last = std::max(last, track.samples.back().time);
  if (last > 0) out.until.time = std::max(0.0, last - shot.start);
  return out;
}

/// Rounds up to 1, 2 or 5 times a power of ten, for the length of a scale.
double rounded_up(double x) {
  const double power = std::pow(10, std::floor(std::log10(x)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * power >= x) return step * power;
  return 10 * power;
}

/// Draws the distances over time below the table. Values beyond the scale are drawn at its end.
void draw_distances(Canvas& c, const Recording& recording, const FittedShot& shot, const Trajectory& path) {
  constexpr double height = 150, gap = 26, letters = 15;
  const double left = c.at(c.table.lowest()).x, right = c.at(c.table.highest()).x;
  const double top = c.bottom + gap, low = top + height;
  double last = shot.start, largest = 1e-4;
  std::size_t i = 0;
  for (const Track& track : recording.tracks)
    for (const Sample& s : track.samples) {
      last = std::max(last, s.time);
      if (shot.counted[i]) largest = std::max(largest, shot.distances[i]);
      ++i;
    }
  const double scale = rounded_up(mm * largest);
  const auto x = [&](double time) {
    return left + (right - left) * (time - shot.start) / std::max(1e-9, last - shot.start);
  };
  const auto y = [&](double distance) { return low - height * std::min(1.0, mm * distance / scale); };
  for (const Record& e : path.events)
    if (is_bounce(e.kind) && e.ball == 0)
      c.add(R"(<line x1="{0:.1f}" y1="{1:.1f}" x2="{0:.1f}" y2="{2:.1f}" stroke="{3}" stroke-dasharray="3 4"/>)",
            x(shot.start + e.time), top, low, c.c.faint);
  c.add(R"(<path d="M{0:.1f} {1:.1f}V{2:.1f}H{3:.1f}" fill="none" stroke="{4}"/>)", left, top, low, right, c.c.faint);
  c.words({left - 8, top + letters / 2}, fmt::format("{:g}", scale),
          {.size = letters, .colour = c.c.faint, .anchor = "end"});
  c.words({left - 8, low}, "0", {.size = letters, .colour = c.c.faint, .anchor = "end"});
  c.words({(left + right) / 2, low + 1.4 * letters},
          fmt::format("mm from the path, over {:.2g} s; dashed: bounces", last - shot.start),
          {.size = letters, .colour = c.c.faint, .anchor = "middle"});
  i = 0;
  for (const Track& track : recording.tracks)
    for (const Sample& s : track.samples) {
      const bool counts = shot.counted[i];
      c.circle({x(s.time), y(shot.distances[i++])}, counts ? 2.4 : 3.4,
               fmt::format(R"(fill="{}")", counts ? c.c.paths[0] : c.c.target));
    }
  c.bottom = low + 2 * letters;
}

Plate plate(const Recording& recording, const FittedShot& shot, const Physics& physics, const PictureStyle& style) {
  const ShotRequest request = played(recording, shot, physics);
  const Trajectory all = simulate(request), path = path_of(all, 0);
  Canvas c(request.table, style);
  draw_table(c, style.words);
  draw_path(c, request.ball, path, {.colour = c.c.paths[0], .width = 1.6, .ghosts = false});
  for (const Ball& other : request.others) draw_other(c, other, other.at);
  std::size_t i = 0;
  for (const Track& track : recording.tracks)
    for (const Sample& s : track.samples) {
      const bool counts = shot.counted[i++];
      c.circle(c.at(s.at), counts ? 2.4 : 4, fmt::format(R"(fill="{}")", counts ? c.c.aim : c.c.target));
    }
  draw_ball(c, request.ball, request.ball.at);
  draw_distances(c, recording, shot, path);
  Plate out{.svg = c.document("a fitted shot")};
  out.title = fmt::format("{}: {:.2g} mm", shot.id.empty() ? "a shot" : shot.id, mm * shot.rms);
  out.caption = {fmt::format("{:.3f} m/s at {:.2f}°, {} cushions; top {:.2f}, side {:.2f}", shot.launch.speed,
                             degrees(shot.launch.angle), shot.cushions, shot.spin.top, shot.spin.side),
                 fmt::format("{} samples, {} outliers{}", shot.samples, shot.outliers,
                             shot.unexplained > 0 ? fmt::format(", {} not followed", shot.unexplained) : "")};
  return out;
}

/// Lists the coefficients, one per line with value and error; held ones are grey.
Plate coefficients(const Fit& fit, const PictureStyle& style) {
  constexpr double letters = 26, line = 40, width = 1000, values = 620;
  const Colours& c = colours(style.theme);
  std::string lines;
  double y = line;
  const auto add = [&](const std::string& name, const std::string& value, const char* colour) {
    lines += fmt::format(
        R"(<text x="60" y="{0:.0f}" fill="{1}">{2}</text><text x="{3:.0f}" y="{0:.0f}" fill="{1}">{4}</text>)", y,
        colour, name, values, value);
    y += line;
  };
  for (const FittedCoefficient& p : fit.parameters)
    add(p.name, fmt::format("{:.5g} ± {:.1g}", p.value, p.error), c.ink);
  for (const HeldCoefficient& h : fit.held) add(h.name, fmt::format("{:.5g}, held", h.value), c.faint);
  return {
      .svg = fmt::format(
          R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0:.0f} {1:.0f}" width="{0:.0f}" height="{1:.0f}" font-family="sans-serif" font-size="{2:.0f}">{3}</svg>)",
          width, y, letters, lines),
      .title = "What they say of the table"};
}

}  // namespace

std::string draw(std::span<const Recording> recordings, const Fit& fit, const PictureStyle& style) {
  Chapter shots;
  shots.plates.push_back(coefficients(fit, style));
  for (std::size_t i = 0; i < recordings.size(); ++i)
    shots.plates.push_back(plate(recordings[i], fit.shots[i], fit.physics, style));
  return draw_page({&shots, 1}, {.columns = 2,
                                 .title = fmt::format("A table from {} shots", fit.shots.size()),
                                 .subtitle = fmt::format("a coordinate of a sample errs by {:.2g} mm", mm * fit.sigma),
                                 .theme = style.theme});
}

}  // namespace bankshot
