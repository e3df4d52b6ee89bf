// SPDX-License-Identifier: MIT
#include "io/answer/answer_path.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "io/simulate/csv.hpp"
#include "sim/plan/played.hpp"

namespace bankshot {
namespace {

using Points = std::vector<std::array<double, 3>>;  ///< s, m, m

void write(JsonWriter& w, const Points& points) {
  w.open('[');
  for (const auto& point : points) {
    w.open('[');
    for (const double v : point) w.number(v);
    w.close(']');
  }
  w.close(']');
}

bool moves(const Points& points) {
  const auto elsewhere = [&](const auto& p) { return p[1] != points.front()[1] || p[2] != points.front()[2]; };
  return std::ranges::any_of(points, elsewhere);
}

}  // namespace

void write_points(JsonWriter& w, const Puzzle& p, const Shot& shot) {
  std::vector<Points> paths(1 + p.others.size());
  sample_played(p, shot, [&](double time, int ball, const State<double>& s) {
    Points& points = paths[static_cast<std::size_t>(ball)];
    const std::array<double, 3> point{time, s.at.x, s.at.y};
    if (points.empty() || points.back() != point) points.push_back(point);  // two events in one instant
  });
  w.key("path");
  write(w, paths.front());
  if (std::none_of(paths.begin() + 1, paths.end(), moves)) return;
  w.key("paths");
  w.open('{');
  for (std::size_t k = 1; k < paths.size(); ++k)
    if (moves(paths[k])) w.name(p.others[k - 1].id), write(w, paths[k]);
  w.close('}');
}

std::string to_csv(const Puzzle& p, const Answer& a, bool numbered) {
  std::string out = std::string(csv_header) + (numbered ? ",shot\n" : "\n");
  for (std::size_t i = 0; i < a.shots.size(); ++i) {
    const ShotRequest request = as_request(p, a.shots[i]);
    const std::string end = numbered ? "," + std::to_string(i + 1) + "\n" : "\n";
    sample_played(p, a.shots[i], [&](double time, int ball, const State<double>& s) {
      out += csv_row(time, csv_field(ball_of(request, ball).id), s) + end;
    });
  }
  return out;
}

}  // namespace bankshot
