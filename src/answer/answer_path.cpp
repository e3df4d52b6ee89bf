// SPDX-License-Identifier: MIT
#include "answer/answer_path.hpp"

#include <array>

#include "bankshot/simulate/trajectory.hpp"
#include "simulate/csv.hpp"

namespace bankshot {

void write_points(JsonWriter& w, const Puzzle& p, const Shot& shot) {
  const ShotRequest request = as_request(p, shot);
  w.key("path");
  w.open('[');
  std::array<double, 3> before{-1, 0, 0};
  sample(request, simulate(request), usual_rate, [&](double time, int ball, const State<double>& s) {
    if (ball != 0) return;
    const std::array<double, 3> point{time, s.at.x, s.at.y};
    if (point == before) return;  // two events in one instant
    before = point;
    w.open('[');
    for (const double v : point) w.number(v);
    w.close(']');
  });
  w.close(']');
}

std::string to_csv(const Puzzle& p, const Answer& a, bool numbered) {
  std::string out = std::string(csv_header) + (numbered ? ",shot\n" : "\n");
  for (std::size_t i = 0; i < a.shots.size(); ++i) {
    const ShotRequest request = as_request(p, a.shots[i]);
    const std::string end = numbered ? "," + std::to_string(i + 1) + "\n" : "\n";
    sample(request, simulate(request), usual_rate, [&](double time, int ball, const State<double>& s) {
      out += csv_row(time, csv_field(ball_of(request, ball).id), s) + end;
    });
  }
  return out;
}

}  // namespace bankshot
