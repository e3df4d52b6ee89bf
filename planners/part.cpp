// SPDX-License-Identifier: MIT
#include "planners/part.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bankshot::planning {
namespace {

/// rad; where the bisection between two aims that fail differently gives up.
constexpr double narrowest = 1e-10;

class PartOfTarget {
 public:
  PartOfTarget(Search& s, const Range& aims, const Goal& goal, std::string_view planner)
      : s_(s), aims_(aims), goal_(goal), planner_(planner) {}

  bool find(double centre, int samples) {
    std::vector<Tried> row;
    for (int i = 0; i < samples && !s_.spent(); ++i)
      row.push_back(attempt(aims_.low + (aims_.high - aims_.low) * i / (samples - 1)));
    if (s_.spent()) return false;
    std::vector<std::size_t> order(row.size() - 1);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return std::abs(row[a].aim - centre) < std::abs(row[b].aim - centre); });
    for (const std::size_t i : order) {
      if (s_.spent()) return false;
      const auto made = between(row[i], row[i + 1]);
      if (made && certify_window(*made)) return true;
    }
    return false;
  }

 private:
  struct Tried {
    double aim;
    Replay replay;
    bool like(const Tried& o) const {
      return replay.failure.foul == o.replay.failure.foul && replay.failure.index == o.replay.failure.index && replay.bounces == o.replay.bounces;
    }
  };

  Tried attempt(double aim) { return {aim, trace(s_, wrap_angle(aim), goal_).replay}; }

  std::optional<Tried> between(const Tried& a, const Tried& b) {
    if (a.replay.made) return a;
    if (b.replay.made) return b;
    if (a.like(b) || b.aim - a.aim < narrowest || s_.spent()) return {};
    const Tried middle = attempt(a.aim + (b.aim - a.aim) / 2);
    if (const auto made = between(a, middle)) return made;
    return between(middle, b);
  }

  /// The end of the made window that begins at `made`, towards `limit`.
  double edge(double made, double limit) {
    double step = (limit - made) / 64;
    while (std::abs(made - limit) > narrowest && std::abs(step) > narrowest && !s_.spent()) {
      const bool fits = std::abs(step) < std::abs(limit - made) && attempt(made + step).replay.made;
      if (fits) made += step;
      step *= fits ? 1.5 : 0.5;
    }
    return made;
  }

  bool certify_window(const Tried& made) {
    const int bounces = made.replay.bounces;
    const double middle = (edge(made.aim, aims_.low) + edge(made.aim, aims_.high)) / 2;
    return certify_aim(s_, wrap_angle(middle), bounces, planner_, true) ||
           certify_aim(s_, wrap_angle(made.aim), bounces, planner_, true);
  }

  Search& s_;
  Range aims_;
  const Goal& goal_;
  std::string_view planner_;
};

}  // namespace

bool reach_part(Search& s, const Range& aims, double centre, int samples, const Goal& goal, std::string_view planner) {
  return PartOfTarget(s, aims, goal, planner).find(centre, samples);
}

}  // namespace bankshot::planning
