// SPDX-License-Identifier: MIT
#include "bindings/many.hpp"

#include <cmath>

#include "bindings/in_parallel.hpp"

namespace bankshot::bindings {
namespace {

/// `request` is the scene; its launch is written over.
bankshot_end end_of(ShotRequest& request, const bankshot_launch& launch) {
  bankshot_end out{};
  out.kind = BANKSHOT_END_INVALID;
  out.pocket = -1;
  request.launch = {launch.speed, launch.angle};
  request.spin = {launch.top, launch.side, launch.masse};
  const bool finite = std::isfinite(launch.angle + launch.top + launch.side + launch.masse);
  if (!finite || !(launch.speed > 0 && std::isfinite(launch.speed))) return out;
  if (!carries_spin(request.physics)) {
    // Natural roll is what an answer prints there, and no spin of the launch's own.
    if (request.spin != LaunchSpin{} && request.spin != LaunchSpin{.top = 1}) return out;
    request.spin = {};
  }
  try {
    const Trajectory t = simulate(request);
    const Record& last = end_of(t, 0);
    const State<double>& s = last.state;
    out = {.time = last.time,
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
  } catch (const InvalidInput&) {
    out.kind = BANKSHOT_END_INVALID;
  }
  return out;
}

}  // namespace

void simulate_many(const ShotRequest& scene, std::span<const bankshot_launch> launches, bankshot_end* ends, int threads,
                   const std::atomic<bool>& stop) {
  constexpr std::size_t block = 64;
  in_parallel(
      launches.size(), block, threads, stop,
      [&](std::size_t begin, std::size_t end) {
        ShotRequest own = scene;
        for (std::size_t i = begin; i < end; ++i) ends[i] = end_of(own, launches[i]);
      },
      [] {});
}

}  // namespace bankshot::bindings
