// SPDX-License-Identifier: MIT
#include "bankshot/simulate/camera.hpp"

#include <cmath>
#include <vector>

namespace bankshot {
namespace {

/// Returns two independent normal draws (Box and Muller 1958).
Vec2d normal_pair(Random& random) {
  const double u = random.uniform(0, 1), turn = random.uniform(0, 2 * 3.14159265358979323846);
  return Vec2d{std::cos(turn), std::sin(turn)} * std::sqrt(-2 * std::log1p(-u));
}

Physics untold(const Physics& p, const Body& body) {
  if (is_ideal(p)) return ideal_physics();
  return carries_spin(p) ? spin_physics(body) : rolling_physics();
}

}  // namespace

Recording film(const ShotRequest& shot, const Trajectory& t, const Camera& camera, Random& random) {
  const auto seen = [&](const Vec2d& at) { return at + normal_pair(random) * camera.noise; };
  std::vector<Track> tracks(shot.others.size() + 1);
  std::vector<char> moved(tracks.size()), fell(tracks.size());
  moved[0] = 1;
  for (const Record& e : t.events) {
    if (e.kind == EventKind::ball)
      moved[static_cast<std::size_t>(e.ball)] = moved[static_cast<std::size_t>(e.contact.index)] = 1;
    if (e.kind == EventKind::pocket) fell[static_cast<std::size_t>(e.ball)] = 1;
  }
  std::vector<double> next(tracks.size());
  sample(shot, t, camera.rate, [&](double time, int ball, const State<double>& s) {
    const auto k = static_cast<std::size_t>(ball);
    const double number = std::round(time * camera.rate);
    if (!moved[k] || std::abs(time - number / camera.rate) > 1e-12 || number < next[k]) return;  // a sample at an event
    next[k] = number + 1;
    const bool dropped = random.chance(camera.drop), astray = random.chance(camera.outliers);
    Vec2d at = seen(s.at);
    if (astray) at += Vec2d{random.uniform(-1, 1), random.uniform(-1, 1)} * camera.astray;
    if (!dropped) tracks[k].samples.push_back({number / camera.rate, at});
  });
  for (std::size_t k = 0; k < tracks.size(); ++k) {
    tracks[k].ball = static_cast<int>(k);
    if (t.end == EventKind::rest && moved[k] && !fell[k])
      tracks[k].rest = seen(end_of(t, static_cast<int>(k)).state.at);
  }
  Recording out;
  out.scene.id = shot.id;
  out.scene.table = shot.table;
  out.scene.ball = shot.ball;
  out.scene.others = shot.others;
  out.scene.physics = untold(shot.physics, shot.ball.body);
  out.scene.ball.at = seen(shot.ball.at);
  for (Ball& other : out.scene.others) other.at = seen(other.at);
  for (Track& track : tracks)
    if (track.samples.size() > 2 || track.rest) out.tracks.push_back(std::move(track));
  return out;
}

}  // namespace bankshot
