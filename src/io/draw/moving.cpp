// SPDX-License-Identifier: MIT
#include "io/draw/moving.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "io/draw/path.hpp"

namespace bankshot::drawing {
namespace {

constexpr double pause = 1;        // s; at the end
constexpr double seen = 0.3;       // px; smaller displacements are not visible
constexpr double ideal_lasts = 8;  // s; in ideal physics, where balls never rest

struct Seen {
  double time;
  Vec2d at;  ///< px
};

/// Keeps the points between the ends that linear motion between kept points would miss visibly (Ramer, 1972, with the
/// distance taken at equal times).
void keep_needed(const std::vector<Seen>& all, std::size_t first, std::size_t last, std::vector<Seen>& out) {
  double worst = seen;
  std::size_t far = last;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double span = all[last].time - all[first].time;
    const double share = span > 0 ? (all[i].time - all[first].time) / span : 0;
    const double off = norm(all[i].at - (all[first].at + (all[last].at - all[first].at) * share));
    if (off > worst) worst = off, far = i;
  }
  if (far == last) return;
  keep_needed(all, first, far, out);
  out.push_back(all[far]);
  keep_needed(all, far, last, out);
}

std::vector<Seen> needed(const std::vector<Seen>& all) {
  std::vector<Seen> out{all.front()};
  keep_needed(all, 0, all.size() - 1, out);
  out.push_back(all.back());
  return out;
}

struct Moving {
  std::vector<Seen> seen{};
  bool falls = false;
};

std::vector<Moving> moving(const Canvas& c, const ShotRequest& r, const Trajectory& t) {
  std::vector<Moving> balls(r.others.size() + 1);
  sample(r, t, usual_rate, [&](double time, int ball, const State<double>& s) {
    balls[static_cast<std::size_t>(ball)].seen.push_back({time, c.at(s.at)});
  });
  for (const Record& e : t.events)
    if (e.kind == EventKind::pocket) balls[static_cast<std::size_t>(e.ball)].falls = true;
  return balls;
}

/// Returns the attributes of an animation over `lasts` seconds.
std::string over(double lasts) { return fmt::format(R"(dur="{:.2f}s" repeatCount="indefinite")", lasts); }

void draw_at_start(Canvas& c, const ShotRequest& r, int ball, double opacity = 1) {
  const Ball& b = ball_of(r, ball);
  ball == 0 ? draw_ball(c, b, b.at, opacity) : draw_other(c, b, b.at, opacity);
}

}  // namespace

void draw_moving(Canvas& c, const ShotRequest& request) {
  ShotRequest r = request;
  r.until = {};
  if (is_ideal(r.physics)) r.until.time = ideal_lasts;
  const Trajectory t = simulate(r);
  const double lasts = t.events.back().time + pause;
  const std::vector<Moving> balls = moving(c, r, t);
  for (int ball = static_cast<int>(balls.size()); ball-- > 0;) {
    const auto& [all, falls] = balls[static_cast<std::size_t>(ball)];
    const std::vector<Seen> points = needed(all);
    const bool stands = std::ranges::all_of(points, [&](const Seen& s) { return norm(s.at - points[0].at) < seen; });
    if (stands) {
      draw_at_start(c, r, ball);
      continue;
    }
    constexpr double faint = 0.35;
    draw_at_start(c, r, ball, faint);
    std::string times, values;
    for (const Seen& s : points) {
      times += fmt::format("{:.5g};", s.time / lasts);
      values += fmt::format("{:.1f},{:.1f};", s.at.x - points[0].at.x, s.at.y - points[0].at.y);
    }
    c.add(
        R"(<g><animateTransform attributeName="transform" type="translate" {} keyTimes="{}1" values="{}{:.1f},{:.1f}"/>)",
        over(lasts), times, values, points.back().at.x - points[0].at.x, points.back().at.y - points[0].at.y);
    if (falls)
      c.add(R"(<animate attributeName="opacity" {} calcMode="discrete" keyTimes="0;{:.5g}" values="1;0"/>)",
            over(lasts), points.back().time / lasts);
    draw_at_start(c, r, ball);
    c.add("</g>");
  }
}

}  // namespace bankshot::drawing
