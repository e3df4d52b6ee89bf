// SPDX-License-Identifier: MIT
#include "planners/steps/parts.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "planners/locked/residual.hpp"

namespace bankshot::planning {
namespace {

/// rad; where the bisection between two aims that fail differently gives up.
constexpr double narrowest = 1e-10;

/// `Follow`: aim -> Replay. `Certify`: (aim, bounces) -> whether it became a shot.
template <class Follow, class Certify>
class PartOfTarget {
 public:
  PartOfTarget(Search& s, const Range& aims, Follow follow, Certify certify)
      : s_(s), aims_(aims), follow_(follow), certify_(certify) {}

  bool find(double centre, int samples) {
    std::vector<Tried> row;
    for (int i = 0; i < samples && !s_.spent(); ++i)
      row.push_back(attempt(aims_.low + (aims_.high - aims_.low) * i / (samples - 1)));
    if (s_.spent()) return false;
    std::vector<std::size_t> order(row.size() - 1);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](auto a, auto b) { return std::abs(row[a].aim - centre) < std::abs(row[b].aim - centre); });
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
      return replay.failure.like(o.replay.failure) && replay.bounces == o.replay.bounces;
    }
  };

  Tried attempt(double aim) { return {aim, follow_(aim)}; }

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
    return certify_(middle, bounces) || certify_(made.aim, bounces);
  }

  Search& s_;
  Range aims_;
  Follow follow_;
  Certify certify_;
};

}  // namespace

bool reach_part(Search& s, const Range& aims, double centre, int samples, const Goal& goal, std::string_view planner) {
  const auto follow = [&](double aim) { return trace(s, wrap_angle(aim), goal).replay; };
  const auto certified = [&](double aim, int bounces) {
    return certify_aim(s, wrap_angle(aim), bounces, planner, true);
  };
  return PartOfTarget(s, aims, follow, certified).find(centre, samples);
}

bool bisect_lead(Search& s, const Search::Lead& lead, std::string_view planner) {
  const LockedAim locked{s, lead.contacts, lead.target};
  const Goal goal = Goal::along(lead.contacts);
  const auto launch = [&](double aim) -> std::optional<Launch> {
    const auto speed = speed_near(s, locked, aim, lead.launch.speed);
    if (!speed) return {};
    return Launch{*speed, wrap_angle(aim)};
  };
  const auto follow = [&](double aim) {
    const auto l = launch(aim);
    return l ? replay(s, *l, goal) : Replay{};
  };
  const auto certified = [&](double aim, int bounces) {
    const auto l = launch(aim);
    return l && certify(s, *l, bounces, planner, true);
  };
  constexpr int aims_across = 17;
  const Range aims{lead.launch.angle - lead.half, lead.launch.angle + lead.half};
  return PartOfTarget(s, aims, follow, certified).find(lead.launch.angle, aims_across);
}

}  // namespace bankshot::planning
