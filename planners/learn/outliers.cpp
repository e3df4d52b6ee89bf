// SPDX-License-Identifier: MIT
#include "planners/learn/outliers.hpp"

#include <algorithm>
#include <cmath>

#include "planners/learn/goodness.hpp"
#include "planners/learn/settings.hpp"

namespace bankshot::planning {

using settings::learn::outlier;

namespace {

/// Returns for each sample whether it lies apart: samples before it, after it and around it all fail to lead to it.
std::vector<char> apart(const std::vector<Sample>& s, double noise) {
  constexpr double bends = 20;  // m/s², more than on any cloth
  const auto leads = [&](std::size_t a, std::size_t b, std::size_t to) {
    const double share = (s[to].time - s[a].time) / (s[b].time - s[a].time), far = s[to].time - s[b].time;
    const Vec2d at = s[a].at + (s[b].at - s[a].at) * share;
    const double errs = noise * std::sqrt(1 + share * share + (1 - share) * (1 - share));
    return norm(s[to].at - at) < outlier * errs + bends * far * far;
  };
  std::vector<char> out(s.size(), 0);
  for (std::size_t i = 0; i < s.size() && s.size() > 6; ++i) {
    const auto fits = [&](std::size_t a, std::size_t b) { return a < s.size() && b < s.size() && leads(a, b, i); };
    out[i] = !(fits(i - 1, i + 1) || fits(i - 2, i - 1) || fits(i + 1, i + 2) || fits(i - 3, i - 1) ||
               fits(i + 1, i + 3) || fits(i - 2, i + 1) || fits(i - 1, i + 2));
  }
  return out;
}

/// Adds third differences of four samples at even times, none of them an outlier; their variance is 20 sigma squared.
void add_thirds(const std::vector<Sample>& samples, const std::vector<char>& out, std::vector<double>& thirds) {
  for (std::size_t i = 3; i < samples.size(); ++i) {
    const Sample* s = &samples[i - 3];
    const double step = s[1].time - s[0].time;
    if (std::abs(s[2].time - s[1].time - step) > 0.1 * step || std::abs(s[3].time - s[2].time - step) > 0.1 * step)
      continue;
    if (out[i - 3] || out[i - 2] || out[i - 1] || out[i]) continue;
    const Vec2d d = (s[3].at - s[0].at) - (s[2].at - s[1].at) * 3.0;
    thirds.push_back(std::abs(d.x)), thirds.push_back(std::abs(d.y));
  }
}

/// Returns when the cue ball first turns back at a straight cushion, between two samples that approach and two that
/// leave.
double first_bounce(const Seen& seen) {
  const auto& tracks = seen.recording.tracks;
  if (tracks.empty() || tracks.front().ball != 0 || !seen.recording.scene.others.empty()) return forever;
  std::vector<Sample> s;
  for (std::size_t i = 0; i < tracks.front().samples.size(); ++i)
    if (!seen.outlier.front()[i]) s.push_back(tracks.front().samples[i]);
  const double clearly = outlier * seen.noise;
  for (std::size_t i = 2; i + 2 < s.size(); ++i)
    for (const Wall& w : seen.stand.struck().walls) {
      const auto gap = [&](std::size_t k) { return dot(w.normal, s[k].at) - w.offset; };
      const double came = gap(i - 2) - gap(i - 1), left = gap(i + 2) - gap(i + 1);
      if (gap(i) > gap(i - 1) || gap(i) > gap(i + 1) || came < clearly || left < clearly) continue;
      const double step = s[i - 1].time - s[i - 2].time, met = s[i - 1].time + gap(i - 1) * step / came;
      if (std::abs(met - s[i].time) < 2 * step) return std::clamp(met, s[i - 1].time, s[i + 1].time);
    }
  return forever;
}

}  // namespace

double noise_of(const Recordings& recordings) {
  constexpr double least = 1e-5, usual = 1e-3;
  double noise = forever;  // outliers are found once the noise is nearly known
  for (int round = 0; round < 3; ++round) {
    std::vector<double> thirds;
    for (const Recording* r : recordings)
      for (const Track& track : r->tracks) add_thirds(track.samples, apart(track.samples, noise), thirds);
    if (thirds.empty()) return usual;
    noise = std::max(least, of_median * median(thirds) / std::sqrt(20.0));
  }
  return noise;
}

void mark_apart(Seen& seen) {
  for (std::size_t k = 0; k < seen.outlier.size(); ++k)
    seen.outlier[k] = apart(seen.recording.tracks[k].samples, seen.noise);
  seen.bounced = first_bounce(seen);
}

void mark_outliers(Seen& seen, const Common& common) {
  constexpr std::size_t around = 3;
  const auto off = misses(seen, common);
  for (std::size_t k = 0; k < off.size(); ++k)
    for (std::size_t i = 0; i < off[k].size(); ++i) {
      std::vector<double> xs, ys, sizes;
      const std::size_t from = i < around ? 0 : i - around, to = std::min(off[k].size(), i + around + 1);
      for (std::size_t j = from; j < to; ++j)
        if (j != i) xs.push_back(off[k][j].x), ys.push_back(off[k][j].y);
      const Vec2d middle{median(xs), median(ys)};
      for (std::size_t j = from; j < to; ++j)
        if (j != i) sizes.push_back(norm(off[k][j] - middle));
      seen.outlier[k][i] = norm(off[k][i] - middle) > outlier * std::max(seen.noise, median(sizes));
    }
}

}  // namespace bankshot::planning
