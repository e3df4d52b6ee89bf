// SPDX-License-Identifier: MIT
#include "io/draw/canvas.hpp"

#include <algorithm>

#include "io/answer/sights.hpp"
#include "io/draw/escape.hpp"

namespace bankshot::drawing {
namespace {

// Pixels.
constexpr double longer_side = 900;
constexpr double margin = 26;  // space above and below the rails, for names and numbers
constexpr double side_margin = 42;
constexpr double bare_margin = 4;    // margin of a picture without words
constexpr double least_width = 860;  // page width that leaves room for captions below a narrow table
// A rail is 14 cm wide and its rubber 5 cm; the width in pixels is limited to keep the picture readable.
constexpr double rail_metres = 0.14, least_rail = 38, most_rail = 64, nose_part = 0.36;

}  // namespace

Canvas::Canvas(const Table& t, const PictureStyle& style)
    : table(t), c(colours(style.theme)), low_(t.lowest()), high_(t.highest()) {
  const Vec2d size = high_ - low_;
  scale_ = longer_side / std::max(size.x, size.y);
  rail = std::clamp(px(rail_metres), least_rail, most_rail);
  nose = nose_part * rail;
  sight = std::clamp(px(sight_distance(t)), nose + 5, rail - 6);
  double room = rail;
  for (const Pocket& p : t.pockets) {  // leaves room for pockets that reach beyond the rail
    const double inside =
        std::max({std::min(p.at.x - low_.x, high_.x - p.at.x), std::min(p.at.y - low_.y, high_.y - p.at.y), 0.0});
    room = std::max(room, px(std::max(0.0, p.radius - inside)) + nose);
  }
  top_ = room + (style.words ? margin : bare_margin);
  width = style.words ? std::max(least_width, px(size.x) + 2 * (room + side_margin)) : px(size.x) + 2 * top_;
  left_ = (width - px(size.x)) / 2;
  bottom = px(size.y) + 2 * top_;
}

void Canvas::circle(const Vec2d& p, double radius, std::string_view style) {
  add(R"(<circle cx="{:.1f}" cy="{:.1f}" r="{:.1f}" {}/>)", p.x, p.y, radius, style);
}

void Canvas::line(const std::vector<Vec2d>& points, std::string_view tag, std::string_view style) {
  std::string list;
  for (const Vec2d& p : points) {
    const Vec2d q = at(p);
    list += fmt::format("{}{:.2f},{:.2f}", list.empty() ? "" : " ", q.x, q.y);
  }
  add(R"(<{} points="{}" {}/>)", tag, list, style);
}

void Canvas::words(const Vec2d& p, std::string_view text, const Words& w) {
  add(R"(<text x="{:.1f}" y="{:.1f}" font-size="{:.0f}" fill="{}"{}{}{}>{}</text>)", p.x, p.y, w.size, w.colour,
      std::string_view(w.anchor) == "start" ? "" : fmt::format(R"( text-anchor="{}")", w.anchor),
      w.bold ? R"( font-weight="bold")" : "",
      w.turned == 0 ? "" : fmt::format(R"~( transform="rotate({:.0f} {:.1f} {:.1f})")~", w.turned, p.x, p.y),
      escaped(std::string(text)));
}

std::string Canvas::document(std::string_view title) const {
  return fmt::format(
      R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0:.0f} {1:.0f}" width="{0:.0f}" height="{1:.0f}" font-family="Helvetica, Arial, 'DejaVu Sans', sans-serif">)"
      "\n<title>{2}</title>\n<rect width=\"100%\" height=\"100%\" fill=\"{3}\"/>\n{4}</svg>\n",
      width, bottom, escaped(std::string(title)), c.page, body_);
}

double width_of(std::string_view text, double size) {
  constexpr double letter = 0.56;  // width over size, in the widest of the named fonts
  const auto letters = std::count_if(text.begin(), text.end(), [](char b) { return (b & 0xC0) != 0x80; });
  return letter * size * static_cast<double>(letters);
}

}  // namespace bankshot::drawing
