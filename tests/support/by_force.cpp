// SPDX-License-Identifier: MIT
#include "support/by_force.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "bankshot/numbers/random.hpp"

namespace bankshot::test {
namespace {

constexpr int few_draws = 100, more_draws = 400;
constexpr double farthest_tip = 2.5;  // spin at which the tip is R from the centre

/// All free quantities of a root: spin and arrival speed.
using Choice = std::array<double, 4>;  // top, side, masse, m/s
LaunchSpin spin_of(const Choice& c) { return {c[0], c[1], c[2]}; }

class Search {
 public:
  Search(const Puzzle& puzzle, const Fineness& fineness)
      : p_(puzzle), fine_(fineness), a_(puzzle), random_(fineness.seed) {
    const auto arrival = arrival_range(p_).value_or(Range{0, 0});
    const SpinRange s = p_.spin_range.value_or(
        SpinRange{{p_.spin.top, p_.spin.top}, {p_.spin.side, p_.spin.side}, {p_.spin.masse, p_.spin.masse}});
    ranges_ = {s.top, s.side, s.masse, arrival};
  }

  std::optional<Root> from(const Launch& launch, const LaunchSpin& spin) {
    const Flight f = fly(a_, launch, spin, ranges_[3].high);
    const auto end = f.passes.begin() + f.count;
    const auto nearest = std::min_element(
        f.passes.begin(), end, [](const Pass& a, const Pass& b) { return std::abs(a.beside) < std::abs(b.beside); });
    constexpr double exact = 1e-9;
    if (nearest == end || std::abs(nearest->beside) > exact * a_.boundary.diagonal) return {};
    return climb({launch, spin, {}, nearest->route, a_.stops ? 0 : nearest->fast, nearest->time});
  }

  ByForce run() {
    std::vector<Root> tops = p_.spin_range ? over_spins() : on_grid(p_.spin, fine_.grid, fine_.arrivals, more_draws);
    keep_best(tops);
    for (const Root& top : tops) {
      const Root climbed = climb(top);
      if (!out_.best || climbed.merit > out_.best->merit) out_.best = climbed;
    }
    return std::move(out_);
  }

 private:
  static constexpr std::size_t climbers = 6;

  double merit(const Root& root, int draws) {
    if (p_.prefer == Prefer::soft) return -root.launch.speed;
    if (p_.prefer == Prefer::quick) return -root.time;
    out_.simulations += draws;
    return drawn_chance(a_, root.launch, root.spin, draws, fine_.seed);
  }

  std::vector<Root> on_grid(const LaunchSpin& spin, const Grid& grid, int arrivals, int draws) {
    const Range& r = ranges_[3];
    std::vector<double> speeds;
    const int steps = r.fixed() ? 0 : arrivals - 1;
    for (int i = 0; i <= steps; ++i) speeds.push_back(steps ? r.low + (r.high - r.low) * i / steps : r.low);
    std::vector<Root> roots = roots_on_grid(a_, spin, speeds, grid, out_.simulations);
    out_.roots += roots.size();
    for (Root& root : roots) root.merit = merit(root, draws);
    return roots;
  }

  /// Tries the ends and the middle of each range first, then random spins.
  std::vector<Root> over_spins() {
    const Grid coarse{25 * fine_.grid.aim, 2 * fine_.grid.speed};
    constexpr int few_arrivals = 5;
    std::vector<Root> all;
    for (int i = 0; i < fine_.spins; ++i) {
      const auto pick = [&](const Range& r, int third) {
        const double drawn = random_.uniform(r.low, r.high);
        return i < 9 ? r.low + (r.high - r.low) * third / 2 : drawn;
      };
      const LaunchSpin spin{pick(ranges_[0], i % 3), pick(ranges_[1], i / 3), pick(ranges_[2], (i + i / 3) % 3)};
      if (std::hypot(spin.top, spin.side) > farthest_tip) continue;
      const std::vector<Root> roots = on_grid(spin, coarse, few_arrivals, few_draws);
      all.insert(all.end(), roots.begin(), roots.end());
    }
    return all;
  }

  static void keep_best(std::vector<Root>& roots) {
    const std::size_t n = std::min(climbers, roots.size());
    std::partial_sort(roots.begin(), roots.begin() + static_cast<std::ptrdiff_t>(n), roots.end(),
                      [](const Root& a, const Root& b) { return a.merit > b.merit; });
    roots.resize(n);
  }

  /// Searches along each free axis and in random directions, by steps that halve.
  Root climb(Root best) {
    constexpr double first = 0.1, last = 1e-4;
    best.merit = merit(best, more_draws);
    Choice at{best.spin.top, best.spin.side, best.spin.masse, best.arrival};
    std::vector<std::size_t> axes;
    for (std::size_t i = 0; i < at.size(); ++i)
      if (!ranges_[i].fixed()) axes.push_back(i);
    for (double step = first; step > last && !axes.empty();) {
      bool better = false;
      for (std::size_t k = 0; k < 4 * axes.size() && !better; ++k) {
        Choice next = at;
        for (std::size_t m = 0; m < axes.size(); ++m) {
          const Range& r = ranges_[axes[m]];
          const double way = k < 2 * axes.size() ? (k / 2 == m ? (k % 2 ? -1.0 : 1.0) : 0.0) : random_.uniform(-1, 1);
          next[axes[m]] = std::clamp(at[axes[m]] + way * step * (r.high - r.low), r.low, r.high);
        }
        better = try_at(next, at, best);
      }
      if (!better) step /= 2;
    }
    return best;
  }

  bool try_at(const Choice& next, Choice& at, Root& best) {
    if (next == at || std::hypot(next[0], next[1]) > farthest_tip) return false;
    auto root = root_near(a_, best, spin_of(next), next[3], out_.simulations);
    if (!root) return false;
    root->merit = merit(*root, more_draws);
    if (!(root->merit > best.merit)) return false;
    at = next;
    best = *root;
    return true;
  }

  const Puzzle& p_;
  Fineness fine_;
  Aimed a_;
  Random random_;
  std::array<Range, 4> ranges_{};
  ByForce out_{};
};

}  // namespace

ByForce best_by_force(const Puzzle& puzzle, const Fineness& fineness) { return Search(puzzle, fineness).run(); }

std::optional<Root> climb_from(const Puzzle& puzzle, const Fineness& fineness, const Launch& launch,
                               const LaunchSpin& spin) {
  return Search(puzzle, fineness).from(launch, spin);
}

double drawn_chance(const Aimed& a, const Launch& launch, const LaunchSpin& spin, int draws, std::uint64_t seed) {
  Random random(seed);
  int made = 0;
  for (int i = 0; i < draws; ++i) {
    // Two normal numbers, after Box and Muller.
    const double size = std::sqrt(-2 * std::log(1 - random.uniform(0, 1))), turn = radians(random.uniform(0, 360));
    const Noise& noise = a.puzzle.noise;
    made += makes(a,
                  {launch.speed + noise.speed_at(launch.speed) * size * std::cos(turn),
                   wrap_angle(launch.angle + noise.angle * size * std::sin(turn))},
                  spin);
  }
  return static_cast<double>(made) / draws;
}

}  // namespace bankshot::test
