// SPDX-License-Identifier: MIT
#include "planners/learn/seen.hpp"
#include "bankshot/simulate/with_physics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "planners/learn/settings.hpp"

namespace bankshot::planning {
namespace {

/// Returns the state right after the launch; its unknowns vary as the numbers 0 to 7.
template <int N>
State<Dual<N>> start_of(const LaunchUnknowns& u, const Physics& physics, double radius) {
  using T = Dual<N>;
  const auto var = [&](LaunchIndex k) { return T(u[k], static_cast<int>(k)); };
  const T along = var(angle), v = var(speed);
  State<T> s{{var(x), var(y)}, {cos(along) * v, sin(along) * v}, {T(0), T(0), T(0)}};
  if (!carries_spin(physics)) return s;
  const Vec2<T> u_ = s.velocity / T(radius), rolled = perpendicular(u_);
  const T t = var(top), m = var(masse);
  s.spin = {rolled.x * t + u_.x * m, rolled.y * t + u_.y * m, v / T(radius) * var(side)};
  return s;
}

template <int N>
Way<Dual<N>> way_of(const Seen& seen, const Told& told, const Varying<N>& varying, const State<Dual<N>>& start,
                    double lasts) {
  return varying.physics.with_motion(varying.leans || !varying.physics.level, [&](const auto& motion) {
    return way_of(seen.stand, varying.physics.balls, motion, varying.physics.cushion, told, start, lasts);
  });
}

/// Calls `see(track, sample)` for each sample up to the window that is no outlier.
template <class See>
void each_used(const Seen& seen, See&& see) {
  for (std::size_t k = 0; k < seen.recording.tracks.size(); ++k) {
    const std::size_t n = seen.followed(k);
    for (std::size_t i = 0; i < n; ++i)
      if (!seen.outlier[k][i]) see(k, i);
  }
}

bool uses_rest(const Seen& seen, std::size_t track) {
  return seen.recording.tracks[track].rest && !(seen.window < seen.last) && seen.told[track].until == forever;
}

/// Returns the factor that turns a distance into one whose square is Huber's loss: a square up to k, linear beyond
/// (Huber 1964).
template <class T>
T huber(const T& square, double k) {
  if (!(square.a > k * k)) return T(1);
  const T far = sqrt(square);
  return sqrt(2 * k * far - k * k) / far;
}

double wrap_half(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

}  // namespace

Seen::Seen(const Recording& r, double usual)
    : recording(r), stand(r.scene), noise(r.sigma.value_or(usual)), sigma(noise), told(r.tracks.size()) {
  for (const Track& track : r.tracks) {
    outlier.emplace_back(track.samples.size(), 0);
    if (!track.samples.empty()) last = std::max(last, track.samples.back().time);
  }
  using namespace settings::learn;
  const Vec2d stood = r.scene.ball.at;
  const bool timed = !r.tracks.empty() && !r.tracks.front().samples.empty();
  expected = {timed ? r.tracks.front().samples[0].time : 0, stood.x, stood.y, 0, 0, middle_of_top, 0, 0};
  spread = {spread_of_start, noise, noise, forever, forever, spread_of_spin, spread_of_spin, spread_of_masse};
  const bool sampled = std::ranges::any_of(r.tracks, [](const Track& track) { return !track.samples.empty(); });
  if (sampled || !r.launch_given) return;  // places of rest alone do not determine a launch: it stays as given
  launch = expected = unknowns_of(r.scene, 0);
  spread[speed] = known_speed * expected[speed], spread[angle] = known_angle;
  spread[top] = spread[side] = known_spin;
}

std::size_t Seen::followed(std::size_t track) const {
  const std::vector<Sample>& s = recording.tracks[track].samples;
  const auto is_followed = [&](const Sample& sample) {
    return sample.time <= window && sample.time - launch[start_time] <= told[track].until;
  };
  return static_cast<std::size_t>(std::ranges::partition_point(s, is_followed) - s.begin());
}

int Seen::samples_used() const {
  int n = 0;
  each_used(*this, [&](auto, auto) { ++n; });
  return n;
}

SeenCost::SeenCost(const Seen& seen, const std::vector<std::string>& names, const Physics& physics)
    : seen_(seen), names_(names), launch_only_(physics, !seen.recording.scene.others.empty()) {
  if (!names.empty()) all_ = std::make_unique<Varying<all_vary>>(physics, !seen.recording.scene.others.empty());
  mutable_parameter_block_sizes()->push_back(launch_size);
  if (!names.empty()) mutable_parameter_block_sizes()->push_back(static_cast<int>(names.size()));
  int rests = 0;
  for (std::size_t k = 0; k < seen.recording.tracks.size(); ++k) rests += uses_rest(seen, k);
  set_num_residuals(2 * (seen.samples_used() + rests) +
                    static_cast<int>(launch_size - std::ranges::count(seen.spread, forever)));
}

bool SeenCost::Evaluate(const double* const* blocks, double* residuals, double** jacobians) const {
  if (jacobians && !names_.empty() && jacobians[1]) {
    all_->set(names_, blocks[1], launch_size);
    evaluate(*all_, blocks, residuals, jacobians);
  } else {
    if (!names_.empty()) launch_only_.set(names_, blocks[1], -1);
    evaluate(launch_only_, blocks, residuals, jacobians);
  }
  return std::all_of(residuals, residuals + num_residuals(), [](double r) { return std::isfinite(r); });
}

template <int N>
void SeenCost::evaluate(Varying<N>& varying, const double* const* blocks, double* residuals, double** jacobians) const {
  using T = Dual<N>;
  const ShotRequest& scene = seen_.recording.scene;
  LaunchUnknowns u;
  std::copy_n(blocks[0], launch_size, u.begin());
  std::size_t row = 0;
  const auto put = [&](const T& r) {
    residuals[row] = r.a;
    for (std::size_t b = 0, from = 0; jacobians && b < parameter_block_sizes().size(); ++b) {
      const auto size = static_cast<std::size_t>(parameter_block_sizes()[b]);
      if (jacobians[b]) std::copy_n(r.v.begin() + static_cast<long>(from), size, jacobians[b] + row * size);
      from += size;
    }
    ++row;
  };
  const auto put_place = [&](const Vec2<T>& place, const Vec2d& at) {
    Vec2<T> off{(varying.offset.x + varying.scale * place.x - at.x) / seen_.sigma,
                (varying.offset.y + varying.scale * place.y - at.y) / seen_.sigma};
    if (seen_.robust > 0) off = off * huber(T(dot(off, off)), seen_.robust);
    put(off.x);
    put(off.y);
  };
  const State<T> start = start_of<N>(u, scene.physics, scene.ball.body.radius);
  const T t0(u[start_time], static_cast<int>(start_time));
  bool rests = false;
  for (std::size_t k = 0; k < seen_.recording.tracks.size(); ++k) rests = rests || uses_rest(seen_, k);
  const double lasts = rests ? forever : std::min(seen_.window, seen_.last) - u[start_time];
  std::optional<Way<T>> way;
  std::size_t of = 0;
  const auto follow = [&](std::size_t k) {
    if (!way || of != k) way.emplace(way_of<N>(seen_, seen_.told[k], varying, start, lasts)), of = k;
  };
  each_used(seen_, [&](std::size_t k, std::size_t i) {
    follow(k);
    const Sample& sample = seen_.recording.tracks[k].samples[i];
    put_place(way->at(sample.time - t0), sample.at);
  });
  for (std::size_t k = 0; k < seen_.recording.tracks.size(); ++k)
    if (uses_rest(seen_, k)) follow(k), put_place(way->end(), *seen_.recording.tracks[k].rest);
  for (std::size_t k = 0; k < launch_size; ++k) {
    if (seen_.spread[k] == forever) continue;
    T it(u[k], static_cast<int>(k));
    if (k == x) it = varying.offset.x + varying.scale * it;
    if (k == y) it = varying.offset.y + varying.scale * it;
    T off = it - seen_.expected[k];
    if (k == angle) off.a = wrap_half(off.a);
    put(off / seen_.spread[k]);
  }
}

std::vector<std::vector<Vec2d>> misses(const Seen& seen, const Common& common) {
  Varying<launch_varies> varying(common.base, !seen.recording.scene.others.empty());
  varying.set(common.names, common.values.data(), -1);
  const ShotRequest& scene = seen.recording.scene;
  const auto start = start_of<launch_varies>(seen.launch, scene.physics, scene.ball.body.radius);
  std::vector<std::vector<Vec2d>> out;
  for (std::size_t k = 0; k < seen.recording.tracks.size(); ++k) {
    const auto way = way_of<launch_varies>(seen, seen.told[k], varying, start, forever);
    auto& of = out.emplace_back();
    for (const Sample& s : seen.recording.tracks[k].samples) {
      const auto at = way.at(Dual<launch_varies>(s.time - seen.launch[start_time]));
      of.push_back(s.at -
                   Vec2d{varying.offset.x.a + varying.scale.a * at.x.a, varying.offset.y.a + varying.scale.a * at.y.a});
    }
  }
  return out;
}

}  // namespace bankshot::planning
