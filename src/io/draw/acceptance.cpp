// SPDX-License-Identifier: MIT
#include "bankshot/draw/acceptance.hpp"

#include <fmt/format.h>

#include <cmath>

#include "bankshot/draw/page.hpp"
#include "bankshot/geometry/opening.hpp"
#include "io/draw/colours.hpp"
#include "io/draw/escape.hpp"

namespace bankshot {
namespace {

/// Returns the colour of an entry. The colours are dark, medium and light (reversed on a dark page), so that they
/// differ in print, too.
const char* fill(Entry entry, Theme theme) {
  constexpr const char* on_paper[] = {"none", "#ccd3da", "#e59a2f", "#1d6b4a"};
  constexpr const char* on_screen[] = {"none", "#39424c", "#b56f1d", "#8ff0c6"};
  return (theme == Theme::light ? on_paper : on_screen)[static_cast<int>(entry)];
}

/// The window of one speed, in pixels.
class Plot {
 public:
  Plot(const Acceptance& window, Theme theme) : w_(window), theme_(theme), c_(drawing::colours(theme)) {
    // The plot ends a little beyond the largest offset at which a line enters the pocket.
    for (int k = 0; k <= w_.widest; ++k)
      for (int degree = -w_.steepest; degree <= w_.steepest; ++degree)
        if (w_.at(degree, k) >= Entry::rattles || w_.at(degree, -k) >= Entry::rattles) highest_ = k;
    highest_ = std::min(w_.widest, highest_ + highest_ / 5 + 1);
  }

  void entries() {
    add(R"(<g shape-rendering="crispEdges">)");
    for (int degree = -w_.steepest; degree <= w_.steepest; ++degree)
      for (int k = -highest_; k <= highest_;) {
        const Entry entry = w_.at(degree, k);
        const int from = k;
        while (k <= highest_ && w_.at(degree, k) == entry) ++k;
        if (entry != Entry::past) bar(degree, from, k, fill(entry, theme_));
      }
    add("</g>");
  }

  void axes() {
    const double low = y(-highest_), high = y(highest_);
    for (int degree = -w_.steepest / 10 * 10; degree <= w_.steepest; degree += 10) {
      grid(x(degree), low, x(degree), high);
      words(x(degree), low + 24, "middle", fmt::format("{}°", degree));
    }
    const int each = highest_ * mm() > 60 ? 20 : 10;
    const int most = static_cast<int>(highest_ * mm()) / each * each;
    for (int offset = -most; offset <= most; offset += each) {
      grid(left, y(offset / mm()), right, y(offset / mm()));
      words(left - 8, y(offset / mm()) + 5, "end", fmt::format("{}", offset));
    }
    words((left + right) / 2, low + 48, "middle", "direction of travel, from straight in");
    add(R"~(<text x="20" y="{0:.0f}" font-size="16" fill="{1}" text-anchor="middle" transform="rotate(-90 20 {0:.0f})">offset of the line, to the left, mm</text>)~",
        (low + high) / 2, c_.faint);
  }

  void exact_line(const Scene& scene, const Boundary& boundary, std::size_t pocket) {
    const auto arcs = openings(boundary, boundary.pockets[pocket]);
    const Vec2d out = view(scene.table, scene.table.pockets[pocket]).out;
    std::string path;
    for (int degree = -w_.steepest; degree <= w_.steepest && !arcs.empty(); ++degree) {
      const double a = radians(degree);
      const auto gap = arcs.front().gap(out * std::cos(a) + perpendicular(out) * std::sin(a), 0);
      if (gap.low < gap.high)
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x(degree), y(gap.exact() / Acceptance::step));
    }
    if (!path.empty())
      add(R"(<path d="{}" fill="none" stroke="{}" stroke-width="4"/><path d="{}" fill="none" stroke="{}" stroke-width="2"/>)",
          path, c_.page, path, c_.target);
  }

  void legend() {
    double at = left;
    const auto entry = [&](const char* label, const std::string& swatch) {
      add(R"~(<g transform="translate({:.0f} {:.0f})">{}</g>)~", at, y(-highest_) + 64, swatch);
      words(at + 30, y(-highest_) + 78, "start", label);
      at += 60 + 9.5 * static_cast<double>(std::string_view(label).size());
    };
    const auto box = [&](Entry e) {
      return fmt::format(R"(<rect width="22" height="16" fill="{}"/>)", fill(e, theme_));
    };
    entry("clean", box(Entry::clean));
    entry("off a jaw or a rail, and in", box(Entry::rattles));
    entry("off a jaw, and out", box(Entry::out));
    entry("exact line", fmt::format(R"(<path d="M0 8h22" stroke="{}" stroke-width="2"/>)", c_.target));
  }

  std::string document(const std::string& title) const {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 1000 {0:.0f}\" width=\"1000\" height=\"{0:.0f}\" "
        "font-family=\"sans-serif\">\n<title>{1}</title>\n{2}</svg>\n",
        y(-highest_) + 96, escaped(title), body_);
  }

 private:
  static constexpr double left = 80, right = 980, top = 10, height = 400;
  static constexpr double mm() { return 1e3 * Acceptance::step; }

  double x(double degree) const { return left + (right - left) * (degree + w_.steepest + 0.5) / (2 * w_.steepest + 1); }
  double y(double steps) const { return top + height * (0.5 - steps / (2 * highest_ + 1)); }

  template <class... A>
  void add(fmt::format_string<A...> f, A&&... args) {
    body_ += fmt::format(f, std::forward<A>(args)...) + "\n";
  }
  void bar(int degree, int from, int to, const char* colour) {
    const double a = x(degree - 0.5), b = x(degree + 0.5), low = y(from - 0.5), high = y(to - 0.5);
    add(R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" fill="{}"/>)", a, high, b - a + 0.5,
        low - high + 0.5, colour);
  }
  void grid(double x1, double y1, double x2, double y2) {
    add(R"(<path d="M{:.1f} {:.1f}L{:.1f} {:.1f}" stroke="{}" stroke-width="1" stroke-opacity="0.3"/>)", x1, y1, x2, y2,
        c_.faint);
  }
  void words(double px, double py, const char* anchor, const std::string& text) {
    add(R"(<text x="{:.1f}" y="{:.1f}" font-size="16" fill="{}" text-anchor="{}">{}</text>)", px, py, c_.ink, anchor,
        escaped(text));
  }

  const Acceptance& w_;
  Theme theme_;
  const drawing::Colours& c_;
  int highest_ = 1;
  std::string body_;
};

}  // namespace

std::string draw(const Scene& scene, int pocket, std::span<const Acceptance> windows, Theme theme) {
  const Boundary boundary(scene.table, scene.ball.body);
  const std::string& name = scene.table.pockets[static_cast<std::size_t>(pocket)].name;
  Chapter chapter{"What pocket " + name + " takes", "balls that roll at it along straight lines", {}};
  for (const Acceptance& w : windows) {
    Plot plot(w, theme);
    plot.entries();
    plot.axes();
    plot.exact_line(scene, boundary, static_cast<std::size_t>(pocket));
    plot.legend();
    const std::string speed = fmt::format("{:g} m/s", w.speed);
    chapter.plates.push_back({plot.document(speed), speed, {}});
  }
  return draw_page(std::array{chapter}, {.letter = 20, .theme = theme});
}

}  // namespace bankshot
