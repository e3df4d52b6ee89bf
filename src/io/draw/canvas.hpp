// SPDX-License-Identifier: MIT
//
// The picture of a table in pixels. It converts metres to pixels and collects SVG elements in drawing order. The page
// holds the table with its rails and a margin, and grows downwards for captions.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "bankshot/scene/table.hpp"
#include "io/draw/colours.hpp"

namespace bankshot::drawing {

struct Words {
  double size = 15;  ///< px
  std::string_view colour;
  const char* anchor = "start";  ///< "start", "middle" or "end"
  bool bold = false;
  double turned = 0;  ///< degrees, clockwise
};

class Canvas {
 public:
  Canvas(const Table& table, const PictureStyle& style);

  double px(double metres) const { return metres * scale_; }
  Vec2d at(const Vec2d& p) const { return {left_ + px(p.x - low_.x), top_ + px(high_.y - p.y)}; }
  /// Converts a direction on the table to one in the picture, whose y axis points down.
  static Vec2d flipped(const Vec2d& u) { return {u.x, -u.y}; }

  template <class... A>
  void add(fmt::format_string<A...> f, A&&... args) {
    body_ += fmt::format(f, std::forward<A>(args)...) + "\n";
  }
  void circle(const Vec2d& px_at, double radius_px, std::string_view style);
  /// Adds a polyline or polygon, as `tag` says, through points in metres.
  void line(const std::vector<Vec2d>& points, std::string_view tag, std::string_view style);
  void words(const Vec2d& px_at, std::string_view text, const Words& w);

  const Table& table;
  const Colours& c;
  double rail = 0, nose = 0;  ///< px; widths of the whole rail and of its cushion
  double sight = 0;           ///< px; distance of the diamonds behind the nose line
  double width = 0;           ///< px; width of the page
  double bottom = 0;          ///< px; height of the filled part of the page

  std::string document(std::string_view title) const;

 private:
  Vec2d low_, high_;
  double scale_, left_, top_;
  std::string body_;
};

/// Returns the approximate width of a text in a sans serif font [px].
double width_of(std::string_view text, double size);

}  // namespace bankshot::drawing
