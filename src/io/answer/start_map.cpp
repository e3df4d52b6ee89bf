// SPDX-License-Identifier: MIT
#include "bankshot/plan/start_map.hpp"
#include "bankshot/plan/place_value.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bankshot/geometry/aim_point.hpp"
#include "bankshot/geometry/boundary.hpp"

namespace bankshot {
namespace {

std::string number(const std::optional<double>& v, double unit = 1) {
  return v ? fmt::format("{}", *v * unit + 0.0) : "";
}

std::string row(const Puzzle& p, const Answer& a) {
  if (a.shots.empty()) return std::string(name(a.status)) + ",,,,,,,,,,,,";
  const Shot& s = a.shots.front();
  std::string cushions;
  for (const Contact c : s.path.cushions) cushions += (cushions.empty() ? "" : " ") + contact_name(p.table, c);
  const Margin m = s.robustness.margin.value_or(Margin{});
  return fmt::format("solved,{},{},{},{},{},{},{},{},{},{},{},{}", s.launch.speed, exact_degrees(s.launch.angle),
                     cushions, s.path.arrival.time, s.path.arrival.speed, number(s.robustness.success),
                     number(m.angle[0], degrees(1)), number(m.angle[1], degrees(1)), number(m.speed[0]),
                     number(m.speed[1]), s.verification.miss, s.verification.condition);
}

}  // namespace

const char* name(Start start) {
  constexpr const char* names[] = {"legal", "in-cushion", "in-pocket", "in-ball", "at-target"};
  return names[static_cast<int>(start)];
}

StartGrid::StartGrid(const Puzzle& p, int nx, int ny) : columns(nx), rows(ny) {
  const Vec2d R{p.ball.body.radius, p.ball.body.radius};
  low = p.table.lowest() + R;
  const Vec2d size = p.table.highest() - R - low;
  cell = {size.x / nx, size.y / ny};
}

Vec2d StartGrid::at(std::size_t i) const {
  const auto n = static_cast<std::size_t>(columns);
  return {low.x + cell.x * (static_cast<double>(i % n) + 0.5), low.y + cell.y * (static_cast<double>(i / n) + 0.5)};
}

Start start_at(const Puzzle& p, const Boundary& boundary, const Vec2d& at) {
  if (boundary.clearance(at) < 0) return Start::cushion;
  if (boundary.pocket_around(at)) return Start::pocket;
  for (const Circle& ball : boundary.balls)
    if (norm(at - ball.centre) < ball.radius) return Start::ball;
  const auto there = [&](const AimPoint& aim_point) {
    return !aim_point.captures() && aim_point.ball == 0 && norm(at - aim_point.at) <= aim_point.reach;
  };
  return std::ranges::any_of(aim_points_of(p), there) ? Start::target : Start::legal;
}

std::vector<Start> starts_on(const Puzzle& p, const StartGrid& grid) {
  const Boundary boundary(p.table, p.ball.body, p.others);
  std::vector<Start> starts;
  for (std::size_t i = 0; i < grid.size(); ++i) starts.push_back(start_at(p, boundary, grid.at(i)));
  return starts;
}

std::string to_csv(const Puzzle& p, const StartMap& map) {
  std::string out =
      "x_m,y_m,status,speed_m_per_s,angle_deg,cushions,time_s,arrival_speed_m_per_s,success,margin_angle_down_deg,"
      "margin_angle_up_deg,"
      "margin_speed_down_m_per_s,margin_speed_up_m_per_s,miss_m,condition_m_per_rad\n";
  for (std::size_t i = 0; i < map.starts.size(); ++i) {
    const Vec2d at = map.grid.at(i);
    const bool legal = map.starts[i] == Start::legal;
    out += fmt::format("{},{},{}\n", at.x, at.y,
                       legal ? row(p, map.answers[i]) : std::string(name(map.starts[i])) + ",,,,,,,,,,,,");
  }
  return out;
}

std::string to_csv(const Puzzle& p, const ValueMap& map) {
  std::string out = "x_m,y_m,status,value,ball,pocket\n";
  for (std::size_t i = 0; i < map.starts.size(); ++i) {
    const Vec2d at = map.grid.at(i);
    const PlaceValue& v = map.values[i];
    out += fmt::format("{},{},{},", at.x, at.y, name(map.starts[i]));
    if (map.starts[i] == Start::legal) out += fmt::format("{}", v.value);
    out += v.pocket >= 0 ? fmt::format(",{},{}\n", p.others[static_cast<std::size_t>(v.ball) - 1].id,
                                       contact_name(p.table, Contact::pocket(v.pocket)))
                         : ",,\n";
  }
  return out;
}

}  // namespace bankshot
