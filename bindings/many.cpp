// SPDX-License-Identifier: MIT
#include "bindings/many.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "bankshot/simulate/each.hpp"
#include "planners/in_parallel.hpp"

namespace bankshot::bindings {
namespace {

bankshot_end of_no_launch() {
  bankshot_end out{};
  out.kind = BANKSHOT_END_INVALID;
  out.pocket = -1;
  return out;
}

/// Returns the launch; none if it is invalid.
std::optional<Stroke> stroke_of(const bankshot_launch& l, bool spins) {
  const Stroke stroke{{l.speed, l.angle}, {l.top, l.side, l.masse}};
  if (!(l.speed > 0) || !std::isfinite(l.angle + l.top + l.side + l.masse)) return {};
  if (spins || stroke.spin == LaunchSpin{}) return stroke;
  // Answers print natural roll in physics without spin.
  if (stroke.spin == LaunchSpin{.top = 1}) return Stroke{stroke.launch};
  return {};
}

bankshot_end end_of(const Trajectory& t) {
  const Record& last = bankshot::end_of(t, 0);
  const State<double>& s = last.state;
  bankshot_end out{.time = last.time,
                   .length = t.length,
                   .x = s.at.x,
                   .y = s.at.y,
                   .vx = s.velocity.x,
                   .vy = s.velocity.y,
                   .wx = s.spin.x,
                   .wy = s.spin.y,
                   .wz = s.spin.z,
                   .cushions = t.cushions,
                   .kind = BANKSHOT_END_EVENTS,
                   .pocket = -1,
                   .reserved = 0};
  if (t.end == EventKind::rest) out.kind = BANKSHOT_END_REST;
  if (t.end == EventKind::horizon) out.kind = BANKSHOT_END_UNTIL;
  for (const Record& e : t.events)
    if (e.ball == 0 && e.kind == EventKind::pocket) out.kind = BANKSHOT_END_POCKETED, out.pocket = e.contact.index;
  return out;
}

}  // namespace

void simulate_many(const ShotRequest& scene, std::span<const bankshot_launch> launches, bankshot_end* ends, int threads,
                   const std::atomic<bool>& stop) {
  const bool spins = carries_spin(scene.physics);
  // Launches of a block share the setup of the scene. Small numbers of launches are still spread over threads.
  const std::size_t block = std::clamp<std::size_t>(launches.size() / 64, 1, 256);
  planning::in_parallel(
      launches.size(), block, threads, stop,
      [&](std::size_t begin, std::size_t end) {
        std::vector<Stroke> strokes;
        std::vector<std::size_t> numbers;
        for (std::size_t i = begin; i < end; ++i) {
          ends[i] = of_no_launch();
          if (const auto stroke = stroke_of(launches[i], spins)) strokes.push_back(*stroke), numbers.push_back(i);
        }
        simulate_each(scene, strokes, [&](std::size_t i, const Trajectory* t) {
          if (t) ends[numbers[i]] = end_of(*t);
        });
      },
      [] {});
}

}  // namespace bankshot::bindings
