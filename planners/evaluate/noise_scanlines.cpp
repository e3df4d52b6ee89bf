// SPDX-License-Identifier: MIT
#include "planners/evaluate/noise_scanlines.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace bankshot::planning {
namespace {

/// Returns the slopes of the monotone cubic at the scanlines.
std::vector<double> slopes(std::span<const NoiseScanline> lines) {
  const std::size_t n = lines.size();
  std::vector<double> steps(n - 1), slope(n);
  for (std::size_t i = 0; i + 1 < n; ++i)
    steps[i] = (lines[i + 1].success - lines[i].success) / (lines[i + 1].along - lines[i].along);
  slope.front() = steps.front();
  slope.back() = steps.back();
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double before = lines[i].along - lines[i - 1].along, after = lines[i + 1].along - lines[i].along;
    const double u = 2 * after + before, v = after + 2 * before;
    slope[i] = steps[i - 1] * steps[i] > 0 ? (u + v) / (u / steps[i - 1] + v / steps[i]) : 0;
  }
  return slope;
}

}  // namespace

double normal_below(double deviations) { return std::erfc(-deviations / std::sqrt(2.0)) / 2; }

int NoiseScanline::changes() const {
  int count = 0;
  for (std::size_t i = 1; i < tries.size(); ++i) count += tries[i - 1].made != tries[i].made;
  return count;
}

void NoiseScanline::read_off(const std::vector<double>& expected) {
  edges.clear();
  open = !tries.empty() && tries.front().made;
  success = !tries.empty() && tries.back().made ? 1 : 0;
  for (std::size_t i = 0; i + 1 < tries.size(); ++i) {
    const double low = tries[i].across, high = tries[i + 1].across;
    if (tries[i].made == tries[i + 1].made) continue;
    const auto inside = std::find_if(expected.begin(), expected.end(), [&](double e) { return low < e && e < high; });
    edges.push_back(inside != expected.end() ? *inside : (low + high) / 2);
    success += (tries[i].made ? 1 : -1) * normal_below(edges.back());
  }
}

double success_of(std::span<const NoiseScanline> lines) {
  constexpr double node[] = {-0.8611363115940526, -0.3399810435848563, 0.3399810435848563, 0.8611363115940526};
  constexpr double weight[] = {0.3478548451374538, 0.6521451548625461, 0.6521451548625461, 0.3478548451374538};
  constexpr double density_at_0 = 0.3989422804014327;
  if (std::ranges::all_of(lines, [](const NoiseScanline& l) { return l.success == 1; })) return 1;
  const std::vector<double> slope = slopes(lines);
  double total = lines.front().success * normal_below(lines.front().along) +
                 lines.back().success * normal_below(-lines.back().along);
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    const NoiseScanline &a = lines[i], &b = lines[i + 1];
    const double h = b.along - a.along;
    for (std::size_t k = 0; k < std::size(node); ++k) {
      const double x = (1 + node[k]) / 2, y = 1 - x, along = a.along + h * x;
      const double success = y * y * ((1 + 2 * x) * a.success + x * h * slope[i]) +
                             x * x * ((3 - 2 * x) * b.success - y * h * slope[i + 1]);
      total += weight[k] * h / 2 * success * density_at_0 * std::exp(-along * along / 2);
    }
  }
  return std::clamp(total, 0.0, 1.0);
}

}  // namespace bankshot::planning
