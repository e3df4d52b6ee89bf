// SPDX-License-Identifier: MIT
#include "planners/learn/outliers.hpp"

#include <algorithm>
#include <cmath>

#include "planners/learn/goodness.hpp"
#include "planners/learn/settings.hpp"

namespace bankshot::planning {

using settings::learn::outlier;

double noise_of(const Recordings& recordings) {
  std::vector<double> thirds;
  for (const Recording* r : recordings)
    for (const Track& track : r->tracks)
      for (std::size_t i = 3; i < track.samples.size(); ++i) {
        const Sample* s = &track.samples[i - 3];
        const double step = s[1].time - s[0].time;
        if (std::abs(s[2].time - s[1].time - step) > 0.1 * step || std::abs(s[3].time - s[2].time - step) > 0.1 * step)
          continue;
        const Vec2d d = (s[3].at - s[0].at) - (s[2].at - s[1].at) * 3.0;
        thirds.push_back(std::abs(d.x)), thirds.push_back(std::abs(d.y));
      }
  constexpr double least = 1e-5, usual = 1e-3;
  return thirds.empty() ? usual : std::max(least, of_median * median(thirds) / std::sqrt(20.0));
}

void mark_apart(Seen& seen) {
  constexpr double bends = 20;  // m/s², more than any cloth does
  for (std::size_t k = 0; k < seen.outlier.size(); ++k) {
    const std::vector<Sample>& s = seen.recording.tracks[k].samples;
    const auto leads = [&](std::size_t a, std::size_t b, std::size_t to) {
      const double share = (s[to].time - s[a].time) / (s[b].time - s[a].time), far = s[to].time - s[b].time;
      const Vec2d at = s[a].at + (s[b].at - s[a].at) * share;
      const double errs = seen.noise * std::sqrt(1 + share * share + (1 - share) * (1 - share));
      return norm(s[to].at - at) < outlier * errs + bends * far * far;
    };
    for (std::size_t i = 0; i < s.size(); ++i) {
      const auto fits = [&](std::size_t a, std::size_t b) { return a < s.size() && b < s.size() && leads(a, b, i); };
      const bool any = fits(i - 1, i + 1) || fits(i - 2, i - 1) || fits(i + 1, i + 2) || fits(i - 3, i - 1) ||
                       fits(i + 1, i + 3) || fits(i - 2, i + 1) || fits(i - 1, i + 2);
      seen.outlier[k][i] = s.size() > 6 && !any;
    }
  }
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
