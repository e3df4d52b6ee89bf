// SPDX-License-Identifier: MIT
//
// The roots that a partition finds, route by route. A node of the partition predicts where the root of its route lies.
// A prediction within reach seeds Newton's method on the locked path, unless that leads to a known root. Each root
// becomes a shot or a candidate. Two roots of a route lie on the two sides of a fold; a node leads to the one on its
// own side. If only shots better than a known one are wanted, a search ends as soon as the derivatives tell that its
// root is none of them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "bankshot/geometry/aim_point.hpp"
#include "planners/search_result.hpp"
#include "planners/stop.hpp"
#include "planners/trace/residual.hpp"

namespace bankshot::planning {

class Roots {
 public:
  Roots(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, const Spacing& spacing)
      : request_(request),
        budget_(budget),
        found_(found),
        cell_{spacing.aim, spacing.speed},
        every_root_(spacing.every_root) {
    for (const Shot& s : found.shots)
      if (!s.verification.off_centre)
        roots_.push_back({route_by(s.path.cushions), request.problem->nearest_aim_point(s.path.arrival.at), s.launch});
  }

  /// Looks for a root from a node. `aim`: the cushions that it meets, and an aim point. `linear`: how it misses that.
  void visit(const Branch& aim, const Launch& node, const Linear& linear);

  /// Looks for roots of routes that were visited and have none, from the node of each that came nearest.
  void seek_rest();

  /// Returns the number of roots of this route and aim point that are known in a range of aims [rad].
  std::ptrdiff_t known_between(const Branch& aim, const Range& aims) const;

  /// Returns whether nothing more is looked for.
  bool done() const { return stop::over(request_, budget_, found_) || stop::route_settled(request_, found_); }

 private:
  /// A root of one route and aim point.
  struct Root {
    Route route;
    AimPoint aim_point;
    Launch launch;
    std::optional<double> determinant{};  ///< determinant of the derivatives, once computed
  };
  template <class Place>
  static bool belongs(const Place& x, const Branch& aim) {
    return x.aim_point == aim.aim_point && std::ranges::equal(x.route, aim.route);
  }
  /// A route to an aim point that was visited, and the node that came nearest.
  struct Seen {
    Route route;
    AimPoint aim_point;
    Launch nearest;
    double miss;  ///< size of the residual
  };
  bool rest_wanted() const { return request_.all() || found_.shots.empty(); }
  void see(const Branch& aim, const Launch& node, double miss);
  void remember(const Branch& aim, const Launch& root, std::optional<double> determinant = {}) {
    roots_.push_back({{aim.route.begin(), aim.route.end()}, aim.aim_point, root, determinant});
  }
  bool known(const Branch& aim, const Launch& l, double cells) const;
  bool on_side_of_known(const Branch& aim, const Linear& node);
  bool hopeless(const Branch& aim, const Launch& at, double cells, const Linear& linear) const;
  void add(const Branch& aim, const Launch& root);

  const SearchRequest& request_;
  EvaluationBudget& budget_;
  SearchResult& found_;
  Neighbourhood cell_;  ///< distance of neighbouring nodes
  bool every_root_;
  std::vector<Root> roots_{};
  std::vector<Seen> seen_{};
};

}  // namespace bankshot::planning
