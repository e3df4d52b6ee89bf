// SPDX-License-Identifier: MIT
//
// 08: simulate a break with fifteen balls until all rest. The events of all balls are in one list. With a file name,
// it draws the paths.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "bankshot/bankshot.hpp"
#include "bankshot/numbers/random.hpp"

int main(int argc, char** argv) {
  using namespace bankshot;
  const Scene scene = preset_scene("pool-9ft");
  // No rack is perfect: the gaps between balls are about half a millimetre.
  const double step = 2 * scene.ball.body.radius + 5e-4, row = step * std::sqrt(0.75);
  Random random(2);
  const auto off = [&] { return random.uniform(-1.2e-4, 1.2e-4); };
  ShotRequest shot{.table = scene.table, .physics = scene.physics, .ball = scene.ball, .launch = {9, radians(359)}};
  shot.ball.at = {0.5, 0.61};
  const int rack[] = {1, 9, 2, 10, 8, 3, 11, 4, 12, 5, 6, 13, 7, 14, 15};
  for (int i = 0, k = 0; i < 5; ++i)
    for (int j = 0; j <= i; ++j, ++k)
      shot.others.push_back(
          {{1.905 + i * row + off(), 0.635 + (j - i / 2.0) * step + off()}, scene.ball.body, std::to_string(rack[k])});

  const Trajectory path = simulate(shot);
  const auto count = [&](EventKind kind) { return std::ranges::count(path.events, kind, &Record::kind); };
  fmt::print("{} contacts of two balls, {} with cushions, {:.2f} s\n", count(EventKind::ball),
             count(EventKind::cushion), path.events.back().time);
  for (const Record& e : path.events)
    if (e.kind == EventKind::pocket)
      fmt::print("{:<3} falls into {} after {:.2f} s\n", ball_of(shot, e.ball).id, contact_name(shot.table, e.contact),
                 e.time);
  const Record& cue = end_of(path, 0);
  fmt::print("the cue ball is {} ({:.3f}, {:.3f}) m\n",
             path.end == EventKind::rest ? "at rest at" : "gone, last seen at", cue.state.at.x, cue.state.at.y);
  if (argc > 1) std::ofstream(argv[1]) << draw(shot, path);
}
