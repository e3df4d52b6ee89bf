// SPDX-License-Identifier: MIT
//
// The roots that a map finds, route by route. A node of the map predicts where the root of its route lies;
// a prediction within reach seeds Newton's method on the locked path, unless that leads to a root that is known.
// Each root becomes a shot, or a lead. What one seed cannot see is sought besides: the other root of a pair across a
// fold or a kink, and roots of routes that were seen but gave none. Where only better shots than one that is known are
// wanted, a search ends as soon as the derivatives tell that its root is none of them.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "bankshot/geometry/aim_point.hpp"
#include "planners/locked/newton.hpp"
#include "planners/search_result.hpp"
#include "planners/stop.hpp"

namespace bankshot::planning::steps {

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

  /// A node that meets these cushions, and how it misses the aim point.
  void visit(const Branch& aim, const Launch& node, const Linear& linear);

  /// Routes that were visited and have no root yet: from the nodes that came nearest.
  void seek_rest();

  /// Whether those are wanted.
  bool rest_wanted() const { return request_.all() || found_.shots.empty(); }

  /// Nothing more is looked for.
  bool done() const { return stop::over(request_, budget_, found_) || stop::route_settled(request_, found_); }

 private:
  /// Of one route and aim point.
  struct Root {
    Route route;
    AimPoint aim_point;
    Launch launch;
    std::optional<double> determinant{};  ///< of its derivatives, once it was asked for
  };
  static constexpr double none = std::numeric_limits<double>::infinity();
  struct Nearest {
    Launch launch{};
    double miss = none;  ///< of the residual
  };
  /// A route and aim point that were visited, and the nodes that came nearest.
  struct Seen {
    Route route;
    AimPoint aim_point;
    std::array<Nearest, 3> nearest{};
  };
  static bool belongs(const Root& x, const Branch& aim) {
    return x.aim_point == aim.aim_point && std::ranges::equal(x.route, aim.route);
  }
  static bool belongs(const Seen& x, const Branch& aim) {
    return x.aim_point == aim.aim_point && std::ranges::equal(x.route, aim.route);
  }

  void remember(const Branch& aim, const Launch& root, std::optional<double> determinant = {}) {
    roots_.push_back({{aim.route.begin(), aim.route.end()}, aim.aim_point, root, determinant});
  }
  Seen& seen(const Branch& aim);
  void keep_nearest(const Branch& aim, const Launch& node, double miss);
  bool known(const Branch& aim, const Launch& l, double cells) const;
  bool on_side_of_known(const Branch& aim, const Linear& node);
  bool hopeless(const Branch& aim, const Launch& at, double cells, const Linear& linear) const;
  void add(const Branch& aim, const Launch& root);
  void across_fold(const Branch& aim, const Launch& root);
  void from_beside(const Branch& aim, const Launch& root, const Linear& at_root, const Vec2d& turn, double cells);
  void beside_rail(const Branch& aim, const Launch& root);
  /// At an aim, the speed that arrives as asked, and on which side of the aim point the ball then passes or rests.
  struct Side {
    double angle, speed, side;
  };
  std::optional<Side> side_at(const Branch& aim, double angle, double guess);
  bool beside_last(const Branch& aim) const;
  NewtonResult after_last(const Branch& aim, const Launch& from);

  const SearchRequest& request_;
  EvaluationBudget& budget_;
  SearchResult& found_;
  Neighbourhood cell_;  ///< how far apart nodes are
  bool every_root_;
  std::vector<Root> roots_{};
  std::vector<Seen> seen_{};
  std::size_t last_seen_ = 0;
};

}  // namespace bankshot::planning::steps
