// SPDX-License-Identifier: MIT
#include "io/answer/launch_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bankshot/scene/tip.hpp"
#include "io/answer/sights.hpp"
#include "sim/simulate/lag.hpp"

namespace bankshot {
namespace {

/// Returns D. Alciatore's name of a speed (billiards.colostate.edu/faq/speed/typical) in miles per hour. He has no name
/// between the power shot, up to 10, and the powerful break, from 25.
std::string_view pace(double mph) {
  if (mph < 1) return "soft touch";
  if (mph < 2) return "slow";
  if (mph < 4) return "medium";
  if (mph < 7) return "fast";
  if (mph < 10) return "power shot";
  return mph < 25 ? "harder than a power shot" : "powerful break";
}

std::string side_words(double v, std::string_view more, std::string_view less) {
  return fmt::format("{:.1f} mm {}", 1e3 * std::abs(v), v > 0 ? more : less);
}

}  // namespace

std::string beside_words(const Vec2d& at, const Vec2d& aim, const Vec2d& centre) {
  constexpr double seen = 5e-4;  // m
  const double right = cross(aim, centre - at) / norm(aim);
  return std::abs(right) < seen ? "through its middle"
                                : fmt::format("{:.0f} mm {} of its middle as the ball rolls", 1e3 * std::abs(right),
                                              right > 0 ? "right" : "left");
}

bool aims_into(const ShotRequest& r, const Pocket& pocket) {
  const Vec2d aim = direction(r.launch.angle), to = pocket.place() - r.ball.at;
  return dot(aim, to) > 0 && std::abs(cross(aim, to)) < pocket.half();
}

std::string aim_words(const ShotRequest& r, const Pocket* straight_into) {
  const Vec2d aim = direction(r.launch.angle);
  const std::string angle = fmt::format(" ({:.2f} degrees)", degrees(r.launch.angle));
  if (straight_into && aims_into(r, *straight_into))
    return "straight at " + straight_into->name + ", " + beside_words(r.ball.at, aim, straight_into->place()) + angle;
  const auto s = sight(r.table, r.ball.at, aim);
  if (!s) return fmt::format("{:.2f} degrees", degrees(r.launch.angle));
  const auto i = static_cast<std::size_t>(s->cushion);
  const std::string& cushion = r.table.cushions[i];
  if (!r.table.is_rectangle())
    return fmt::format("{:.0f} % of the way along cushion {} from vertex v{}", 100 * s->part, cushion, i) + angle;
  const bool level = r.table.vertices[i].y == r.table.vertices[(i + 1) % 4].y;
  const char *first = level ? "left" : "bottom", *last = level ? "right" : "top";
  const int all = diamonds_along(r.table, s->cushion);
  const double beyond = std::max(-s->diamonds, s->diamonds - all);
  if (beyond > 0)
    return fmt::format("{:.2f} diamonds beyond the {} end of the {} rail", beyond, s->diamonds < 0 ? first : last,
                       cushion) +
           angle;
  return fmt::format("diamond {:.2f} of {} on the {} rail, counted from the {}", s->diamonds, all, cushion, first) +
         angle;
}

std::string speed_words(const ShotRequest& r) {
  constexpr double mile_an_hour = 0.44704;  // m/s
  const double v = r.launch.speed, mph = v / mile_an_hour;
  const auto lag = lag_speed(r);
  return fmt::format("{}: {:.2f} m/s, {:.1f} mph", pace(mph), v, mph) +
         (lag ? fmt::format(", {:.1f} times lag speed", v / *lag) : "");
}

std::string tip_words(const ShotRequest& r) {
  const LaunchSpin& s = r.spin;
  Tip tip = tip_of(!carries_spin(r.physics) ? LaunchSpin{.top = 1} : s, r.ball.body.radius);
  std::string raised;
  if (s.masse != 0) {
    if (!(s.masse * s.side > 0)) return "no cue gives this spin: a ball curves towards the side that it is struck on";
    const double cue = std::atan(s.masse / s.side);
    raised = fmt::format(", the cue raised by {:.0f} degrees and seen along it", degrees(cue));
    tip.up *= std::cos(cue);
  }
  std::string text;
  if (tip.up != 0) text = side_words(tip.up, "above", "below") + " the centre";
  if (tip.right != 0) text += (text.empty() ? "" : ", ") + side_words(tip.right, "to the right", "to the left");
  if (text.empty()) text = "in the centre";
  if (!carries_spin(r.physics)) return text + ", so that it rolls from the start";
  if (may_miscue(s))
    raised += fmt::format("; a miscue is likely: {:.0f} % of the radius from the centre, where half is the limit",
                          100 * tip_of(s, 1).from_centre());
  return text + raised;
}

std::string noise_words(const Noise& n) {
  std::vector<std::string> parts{fmt::format("{:.3g} degrees of aim", degrees(n.angle))};
  std::string speed = n.speed > 0 || n.speed_share == 0 ? fmt::format("{:.3g} m/s", n.speed) : "";
  if (n.speed_share > 0)
    speed += fmt::format("{}{:.3g} %", speed.empty() ? "" : " together with ", 100 * n.speed_share);
  parts.push_back(speed + " of speed");
  if (n.tip > 0) parts.push_back(fmt::format("{:.3g} mm of where the tip meets the ball", n.tip * 1000));
  if (n.side > 0) parts.push_back(fmt::format("{:.3g} of side spin", n.side));
  if (n.top > 0) parts.push_back(fmt::format("{:.3g} of topspin", n.top));
  if (n.at > 0) parts.push_back(fmt::format("{:.3g} mm of where the balls are", n.at * 1000));
  std::string out;
  for (std::size_t i = 0; i < parts.size(); ++i)
    out += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  return out;
}

std::string player_words(const Noise& n) {
  const auto all = players();
  // Without the physics `spin`, the tip has no error.
  const auto is_same = [&](const Player& player) {
    Noise noise = player.noise;
    if (n.tip == 0) noise.tip = 0;
    return noise == n;
  };
  const auto known = std::ranges::find_if(all, is_same);
  if (n.none()) return "a player without errors";
  return (known == all.end() ? "a player" : std::string(known->about)) + " who errs by " + noise_words(n);
}

}  // namespace bankshot
