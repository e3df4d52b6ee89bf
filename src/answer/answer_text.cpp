// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/plan/answer.hpp"
#include "bankshot/simulate/trajectory.hpp"

namespace bankshot {
namespace {

/// Where on a cushion, in words: on a rectangle in diamonds (8 spaces on long rails, 4 on short).
std::string place_on(const Table& table, Contact contact, const Vec2d& at) {
  if (contact.kind != ContactKind::rail) return "the corner";
  const auto i = static_cast<std::size_t>(contact.index);
  const Vec2d a = table.vertices[i], b = table.vertices[(i + 1) % table.vertices.size()];
  if (!table.is_rectangle())
    return fmt::format("{:.0f} % along from vertex {}", 100 * dot(at - a, b - a) / dot(b - a, b - a), i);
  const Vec2d size = table.highest() - table.lowest(), local = at - table.lowest();
  const bool horizontal = a.y == b.y;
  const double along = horizontal ? local.x : local.y, side = horizontal ? size.x : size.y;
  const int spaces = side >= std::max(size.x, size.y) ? 8 : 4;
  return fmt::format("{:.3f} m, diamond {:.2f} of {} from the {}", along, spaces * along / side, spaces,
                     horizontal ? "left" : "bottom");
}

std::string interval(const std::array<std::optional<double>, 2>& m, double unit, std::string_view name) {
  if (!m[0] && !m[1]) return fmt::format("any {}", name);
  const auto side = [&](const std::optional<double>& v, char sign) {
    return v ? fmt::format("{}{:.3g}", sign, std::abs(*v) * unit) : sign == '-' ? "any less" : "any more";
  };
  return fmt::format("{} to {} {}", side(m[0], '-'), side(m[1], '+'), name);
}

/// The cue's tip on the ball: 2/5 R for each unit of spin.
std::string where_to_hit(const Puzzle& p, const LaunchSpin& spin) {
  const double up = 400 * p.ball.body.radius * spin.top, right = 400 * p.ball.body.radius * spin.side;
  if (up == 0 && right == 0) return "in the centre";
  std::string text;
  if (up != 0) text = fmt::format("{:.1f} mm {} the centre", std::abs(up), up > 0 ? "above" : "below");
  if (right != 0)
    text +=
        fmt::format("{}{:.1f} mm to the {}", text.empty() ? "" : ", ", std::abs(right), right > 0 ? "right" : "left");
  return text;
}

void describe(std::string& out, const Puzzle& p, const Shot& shot) {
  const auto row = [&](std::string_view what, const std::string& text) {
    out += fmt::format("  {:<10}{}\n", what, text);
  };
  row("aim", fmt::format("{:.4f} degrees", degrees(shot.launch.angle)));
  row("speed", fmt::format("{:.4f} m/s", shot.launch.speed));
  if (is_straight(p.physics) && p.ball.body.radius > 0)
    row("hit", fmt::format("{:.1f} mm above the centre, so that it rolls from the start", 400 * p.ball.body.radius));
  if (!is_straight(p.physics)) row("hit", where_to_hit(p, shot.spin));
  if (shot.cushions.empty()) {
    row("cushions", "none");
  } else {
    constexpr std::size_t most_named = 12;
    std::string names;
    for (std::size_t i = 0; i < std::min(most_named, shot.cushions.size()); ++i)
      names += (i ? ", " : "") + contact_name(p.table, shot.cushions[i]);
    if (shot.cushions.size() > most_named) names += fmt::format(" and {} more", shot.cushions.size() - most_named);
    row("cushions", names);
    ShotRequest first = as_request(p, shot);
    first.until.cushions = 1;
    const Trajectory path = simulate(first);
    row("first at", place_on(p.table, shot.cushions[0], path.events.back().state.at));
  }
  row("arrives",
      fmt::format("after {:.2f} s at {:.3f} m/s, {:.1e} m off", shot.arrival.time, shot.arrival.speed, shot.miss));
  if (shot.margin) {
    row("margin", interval(shot.margin->angle, degrees(1), "degrees of aim"));
    row("", interval(shot.margin->speed, 1, "m/s of speed"));
  }
  if (shot.success) row("chance", fmt::format("{:.0f} % for the player given", 100 * *shot.success));
  // An answer that was read from its JSON does not know this.
  if (const double moved = norm(shot.by_angle) * radians(0.1); moved > 0)
    row("note", fmt::format("0.1 degrees of aim moves the arrival by {:.0f} mm", 1e3 * moved));
}

}  // namespace

std::string to_text(const Puzzle& p, const Answer& a) {
  std::string out = fmt::format("{}: {}\n", name(a.status), a.message);
  for (std::size_t i = 0; i < a.shots.size(); ++i) {
    if (a.shots.size() > 1) out += fmt::format("\nshot {} of {}\n", i + 1, a.shots.size());
    describe(out, p, a.shots[i]);
  }
  if (a.nearest)
    out += fmt::format("  nearest   {:.4f} degrees at {:.4f} m/s: {:.3g} m off; it {}\n",
                       degrees(a.nearest->shot.launch.angle), a.nearest->shot.launch.speed, a.nearest->shot.miss,
                       a.nearest->why);
  return out;
}

}  // namespace bankshot
