// SPDX-License-Identifier: MIT
#include "planners/propose/window.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

#include "planners/propose/aim.hpp"
#include "planners/settings.hpp"
#include "planners/solve/line_search.hpp"

namespace bankshot::planning {
namespace {

class Windows {
 public:
  Windows(const AimRow& how, EvaluationBudget& budget, const Range& aims) : how_(how), budget_(budget), aims_(aims) {}

  bool find(double centre, int samples) {
    std::vector<Tried> row;
    for (int i = 0; i < samples && !budget_.spent(); ++i)
      row.push_back(attempt(aims_.low + (aims_.high - aims_.low) * i / (samples - 1)));
    if (budget_.spent()) return false;
    std::vector<std::size_t> order(row.size() - 1);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](auto a, auto b) { return std::abs(row[a].aim - centre) < std::abs(row[b].aim - centre); });
    for (const std::size_t i : order) {
      if (budget_.spent()) return false;
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
      return replay.failure.like(o.replay.failure) && replay.bounces() == o.replay.bounces();
    }
  };

  Tried attempt(double aim) { return {aim, how_.follow(aim)}; }

  std::optional<Tried> between(const Tried& a, const Tried& b) {
    if (a.replay.made) return a;
    if (b.replay.made) return b;
    if (a.like(b) || b.aim - a.aim < settings::narrowest || budget_.spent()) return {};
    const Tried middle = attempt(a.aim + (b.aim - a.aim) / 2);
    if (auto made = between(a, middle)) return made;
    return between(middle, b);
  }

  /// Finds an end of what is made, between `made` and `limit`.
  double edge(double made, double limit) {
    const auto wide = [&](double a, double b) { return std::abs(a - b) > settings::narrowest && !budget_.spent(); };
    bisect(made, limit, wide, [&](double aim) { return attempt(aim).replay.made; });
    return made;
  }

  bool certify_window(const Tried& made) {
    const int bounces = made.replay.bounces();
    const double middle = (edge(made.aim, aims_.low) + edge(made.aim, aims_.high)) / 2;
    return how_.certify(middle, bounces) || how_.certify(made.aim, bounces);
  }

  const AimRow& how_;
  EvaluationBudget& budget_;
  Range aims_;
};

}  // namespace

bool find_window(const AimRow& row, EvaluationBudget& budget, const Range& aims, double centre, int samples) {
  return Windows(row, budget, aims).find(centre, samples);
}

bool reach_part(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, const Range& aims,
                double centre, int samples, const Goal& goal, std::string_view step) {
  const AimRow row{[&](double aim) { return trace(request, budget, wrap_angle(aim), goal).replay; },
                   [&](double aim, int bounces) {
                     return certify_aim(request, budget, found, wrap_angle(aim), bounces, step, Demand::off_centre);
                   }};
  return find_window(row, budget, aims, centre, samples);
}

}  // namespace bankshot::planning
