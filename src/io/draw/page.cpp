// SPDX-License-Identifier: MIT
#include "bankshot/draw/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "io/draw/colours.hpp"
#include "io/draw/escape.hpp"

namespace bankshot {
namespace {

/// Returns a picture's svg element, placed and sized. Its title stays as a tooltip.
std::string placed(const std::string& svg, double x, double y, double width, double height) {
  const std::string box_key = "viewBox=\"";
  const auto box = svg.find(box_key), end = svg.find('"', box + box_key.size()), body = svg.find('>') + 1;
  return fmt::format(R"(<svg x="{:.0f}" y="{:.0f}" width="{:.0f}" height="{:.0f}" {} font-family="sans-serif">{})", x,
                     y, width, height, svg.substr(box, end + 1 - box), svg.substr(body));
}

/// Returns height over width of a picture, from its viewBox.
double ratio_of(const std::string& svg) {
  double x = 0, y = 0, width = 1, height = 1;
  std::istringstream(svg.substr(svg.find("viewBox=\"") + 9)) >> x >> y >> width >> height;
  return height / width;
}

class Page {
 public:
  explicit Page(const PageStyle& style)
      : style_(style),
        gap_(style.plate * 0.09),
        margin_(style.plate * (style.columns > 1 ? 0.2 : 0.06)),
        width_(2 * margin_ + style.columns * style.plate + (style.columns - 1) * gap_),
        y_(margin_),
        c_(drawing::colours(style.theme)) {}

  void heading(const std::string& title, const std::string& subtitle, double size) {
    if (title.empty()) return;
    y_ += 1.2 * size;
    text(width_ / 2, y_, size, c_.ink, title, "middle");
    if (!subtitle.empty()) text(width_ / 2, y_ += 0.75 * size, 0.48 * size, c_.faint, subtitle, "middle", true);
    const double half = 0.12 * width_;
    body_ += fmt::format(R"(<path d="M{:.0f} {:.0f}h{:.0f}" stroke="{}" stroke-width="1.5"/>)", width_ / 2 - half,
                         y_ += 0.5 * size, 2 * half, c_.faint) +
             "\n";
    y_ += 0.5 * size;
  }

  void plates(std::span<const Plate> all) {
    const double line = 1.35 * style_.letter;
    for (std::size_t i = 0; i < all.size();) {
      const std::size_t row = std::min(all.size() - i, static_cast<std::size_t>(style_.columns));
      std::size_t lines = 0;
      const bool titled = std::any_of(all.begin() + static_cast<long>(i), all.begin() + static_cast<long>(i + row),
                                      [](const Plate& p) { return !p.title.empty(); });
      double ratio = style_.ratio;
      for (std::size_t k = 0; k < row && style_.ratio == 0; ++k) ratio = std::max(ratio, ratio_of(all[i + k].svg));
      const double picture = style_.plate * ratio, top = y_ + (titled ? 1.5 * line : 0);
      for (std::size_t k = 0; k < row; ++k, ++i) {
        const Plate& p = all[i];
        const double x = margin_ + static_cast<double>(k) * (style_.plate + gap_);
        if (titled) text(x, y_ + line, 1.15 * style_.letter, c_.ink, p.title, "start");
        body_ += placed(p.svg, x, top, style_.plate, picture);
        for (std::size_t n = 0; n < p.caption.size(); ++n)
          text(x, top + picture + line * static_cast<double>(n + 1), style_.letter, n == 0 ? c_.ink : c_.faint,
               p.caption[n], "start");
        lines = std::max(lines, p.caption.size());
      }
      y_ = top + picture + line * (static_cast<double>(lines) + 1.4);
    }
  }

  std::string document() const {
    const double height = y_ + 0.5 * margin_;
    return fmt::format(
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0:.0f} {1:.0f}" width="{0:.0f}" height="{1:.0f}" font-family="Georgia, 'DejaVu Serif', serif">)"
        "\n<title>{2}</title>\n<rect width=\"100%\" height=\"100%\" fill=\"{3}\"/>\n{4}</svg>\n",
        width_, height, escaped(style_.title), c_.page, body_);
  }

 private:
  void text(double x, double y, double size, const char* colour, const std::string& words, const char* anchor,
            bool italic = false) {
    body_ += fmt::format(R"(<text x="{:.0f}" y="{:.0f}" font-size="{:.1f}" fill="{}" text-anchor="{}"{}>{}</text>)", x,
                         y, size, colour, anchor, italic ? R"( font-style="italic")" : "", escaped(words)) +
             "\n";
  }

  const PageStyle& style_;
  double gap_, margin_, width_;
  double y_;  ///< px; height of the filled part of the page
  const drawing::Colours& c_;
  std::string body_;
};

}  // namespace

std::string draw_page(std::span<const Chapter> chapters, const PageStyle& style) {
  Page page(style);
  page.heading(style.title, style.subtitle, 4 * style.letter);
  for (const Chapter& c : chapters) {
    page.heading(c.title, c.subtitle, 2 * style.letter);
    page.plates(c.plates);
  }
  return page.document();
}

}  // namespace bankshot
