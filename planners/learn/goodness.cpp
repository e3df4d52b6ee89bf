// SPDX-License-Identifier: MIT
#include "planners/learn/goodness.hpp"

#include <algorithm>
#include <cmath>

#include "planners/learn/settings.hpp"

namespace bankshot::planning {

double median(std::vector<double> v) {
  if (v.empty()) return 0;
  const auto middle = v.begin() + static_cast<long>(v.size() / 2);
  std::ranges::nth_element(v, middle);
  return *middle;
}

double spread(const Seen& seen, const Common& common) {
  constexpr double share = 0.7, of_normal = 1.036;
  constexpr std::size_t parts = 4, least = 6;
  double largest = 0;
  const auto off = misses(seen, common);
  for (std::size_t k = 0; k < off.size(); ++k) {
    const std::size_t n = seen.followed(k), each = std::max(least, n / parts + 1);
    for (std::size_t from = 0; from + least <= n; from += each) {
      std::vector<double> sizes;
      for (std::size_t i = from; i < std::min(n, from + each); ++i)
        sizes.push_back(std::abs(off[k][i].x)), sizes.push_back(std::abs(off[k][i].y));
      const auto at = sizes.begin() + static_cast<long>(share * static_cast<double>(sizes.size() - 1));
      std::ranges::nth_element(sizes, at);
      largest = std::max(largest, *at / of_normal / seen.sigma);
    }
  }
  return largest;
}

Distances distances(const Seen& seen, const Common& common) {
  Distances out;
  double sum = 0;
  const auto off = misses(seen, common);
  for (std::size_t k = 0; k < off.size(); ++k)
    for (std::size_t i = 0; i < off[k].size(); ++i) {
      out.each.push_back(norm(off[k][i]));
      out.counted.push_back(i < seen.followed(k) && !seen.outlier[k][i]);
      if (i >= seen.followed(k)) {
        ++out.unexplained;
      } else if (seen.outlier[k][i]) {
        ++out.outliers;
      } else {
        ++out.samples;
        sum += dot(off[k][i], off[k][i]);
      }
    }
  if (out.samples > 0) out.rms = std::sqrt(sum / out.samples);
  return out;
}

double excess(const Seen& seen, const Common& common) {
  const Distances off = distances(seen, common);
  const int free = 2 * off.samples - launch_size;
  return free > 0 ? off.rms * std::sqrt(static_cast<double>(off.samples) / free) / seen.sigma : 0;
}

bool is_off(const Seen& seen, const Common& common) {
  using namespace settings::learn;
  return seen.robust > 0 ? spread(seen, common) > good : excess(seen, common) > chance;
}

}  // namespace bankshot::planning
