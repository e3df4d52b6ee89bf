// SPDX-License-Identifier: MIT
#include "io/draw/caption.hpp"

#include <algorithm>

#include "bankshot/scene/tip.hpp"

namespace bankshot::drawing {
namespace {

// Pixels.
constexpr double edge = 34, letter = 15, line = 23, title_letter = 19;

/// Breaks a text between words into lines of at most `width`.
std::vector<std::string> broken(const std::string& text, double width) {
  std::vector<std::string> lines{""};
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    const std::string longer = lines.back().empty() ? word : lines.back() + ' ' + word;
    if (width_of(longer, letter) > width && !lines.back().empty())
      lines.push_back(word);
    else
      lines.back() = longer;
    begin = end + 1;
  }
  return lines;
}

/// Draws the ball as the player sees it over the cue, with the circle of the miscue limit and the tip.
void draw_inset(Canvas& c, const ShotRequest& shot, const Vec2d& middle, double radius) {
  const double R = shot.ball.body.radius;
  const Tip tip = tip_of(!carries_spin(shot.physics) ? LaunchSpin{.top = 1} : shot.spin, R);
  c.circle(middle, radius, fmt::format(R"(fill="{}" stroke="{}" stroke-width="1.6")", c.c.ball, c.c.ball_edge));
  constexpr const char* thin = "#8b939d";
  c.add(R"(<path d="M{:.1f} {:.1f}h{:.1f}M{:.1f} {:.1f}v{:.1f}" stroke="{}" stroke-width="0.8"/>)", middle.x - radius,
        middle.y, 2 * radius, middle.x, middle.y - radius, 2 * radius, thin);
  c.circle(middle, radius * miscue_limit,
           fmt::format(R"(fill="none" stroke="{}" stroke-width="1" stroke-dasharray="4 3")", thin));
  const Vec2d at = middle + Vec2d{tip.right, -tip.up} * (radius / R);
  constexpr double tip_part = 0.115;  // contact radius of a 13 mm tip over the ball's radius
  c.circle(at, radius * tip_part, fmt::format(R"(fill="{}" stroke="#ffffff" stroke-width="1")", light.aim));
}

}  // namespace

void draw_caption(Canvas& c, const std::string& title, std::span<const Row> rows, const ShotRequest* tip) {
  constexpr double radius = 52, label = 88;
  const bool inset = tip && tip->ball.body.radius > 0;
  const double right = c.width - edge - (inset ? 2 * radius + 30 : 0), top = c.bottom + 8;
  double y = top + title_letter;
  c.words({edge, y}, title, {title_letter, c.c.ink, "start", true});
  y += 4;
  for (const Row& row : rows) {
    bool first = true;
    for (const std::string& text : broken(row.text, right - edge - label)) {
      y += line;
      if (first) c.words({edge, y}, row.what, {letter, c.c.faint});
      c.words({edge + label, y}, text, {letter, c.c.ink});
      first = false;
    }
  }
  c.bottom = y + edge * 0.7;
  if (!inset) return;
  const Vec2d middle{c.width - edge - radius, top + radius + 2};
  draw_inset(c, *tip, middle, radius);
  c.words(middle + Vec2d{0, radius + 18}, tip->spin.masse == 0 ? "where the tip meets it" : "seen along the cue",
          {12, c.c.faint, "middle"});
  c.bottom = std::max(c.bottom, middle.y + radius + 30);
}

void draw_legend(Canvas& c, std::span<const Swatch> entries) {
  constexpr double swatch = 26, gap = 26;
  double x = edge, y = c.bottom + 20;
  for (const Swatch& e : entries) {
    const double needs = swatch + 8 + width_of(e.label, letter);
    if (x > edge && x + needs > c.width - edge) x = edge, y += line;
    c.add(R"(<rect x="{:.0f}" y="{:.0f}" width="{:.0f}" height="7" rx="2" fill="{}" stroke="{}" stroke-width="0.5"/>)",
          x, y - 9, swatch, e.colour, c.c.faint);
    c.words({x + swatch + 8, y}, e.label, {letter, c.c.ink});
    x += needs + gap;
  }
  c.bottom = y + 16;
}

void draw_list(Canvas& c, const std::string& title, std::span<const Entry> entries) {
  c.bottom += 8;
  c.words({edge, c.bottom + title_letter}, title, {title_letter, c.c.ink, "start", true});
  const double top = c.bottom + title_letter + 8;
  const std::size_t rows = (entries.size() + 1) / 2;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Vec2d at{i < rows ? edge : c.width / 2, top + line * static_cast<double>(i % rows + 1)};
    c.circle(at + Vec2d{9, -5}, 9, fmt::format(R"(fill="{}")", entries[i].colour));
    c.words(at + Vec2d{9, -0.7}, std::to_string(entries[i].number), {12, c.c.halo, "middle", true});
    c.words(at + Vec2d{28, 0}, entries[i].words, {14, c.c.ink});
  }
  c.bottom = top + line * static_cast<double>(rows) + edge * 0.6;
}

}  // namespace bankshot::drawing
