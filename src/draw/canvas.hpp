// SPDX-License-Identifier: MIT
//
// A table in pixels: where a point in metres lies in the picture, and the elements that are put there, in order. The
// page holds the table with its rails and a margin for marks, and grows downwards for what stands below.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "bankshot/scene/table.hpp"
#include "draw/colours.hpp"

namespace bankshot::drawing {

struct Words {
  double size = 15;  ///< px
  std::string_view colour;
  const char* anchor = "start";  ///< or middle, end
  bool bold = false;
  double turned = 0;  ///< degrees, clockwise
};

class Canvas {
 public:
  Canvas(const Table& table, const PictureStyle& style);

  double px(double metres) const { return metres * scale_; }
  Vec2d at(const Vec2d& p) const { return {left_ + px(p.x - low_.x), top_ + px(high_.y - p.y)}; }
  /// A direction on the table as one of the picture, whose y runs downwards.
  static Vec2d flipped(const Vec2d& u) { return {u.x, -u.y}; }

  template <class... A>
  void add(fmt::format_string<A...> f, A&&... args) {
    body_ += fmt::format(f, std::forward<A>(args)...) + "\n";
  }
  void circle(const Vec2d& px_at, double radius_px, std::string_view style);
  /// `tag`: polyline or polygon; the points in metres.
  void line(const std::vector<Vec2d>& points, std::string_view tag, std::string_view style);
  void words(const Vec2d& px_at, std::string_view text, const Words& w);

  const Table& table;
  const Colours& c;
  double rail = 0, nose = 0;  ///< px, widths of the whole rail and of its cushion
  double sight = 0;           ///< px, of the diamonds behind the nose line
  double width = 0;           ///< px, of the page
  double bottom = 0;          ///< px, how far down the page is filled

  std::string document(std::string_view title) const;

 private:
  Vec2d low_, high_;
  double scale_, left_, top_;
  std::string body_;
};

/// About as wide as a text is [px]: letters of a sans serif.
double width_of(std::string_view text, double size);

}  // namespace bankshot::drawing
