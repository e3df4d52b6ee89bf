// SPDX-License-Identifier: MIT
//
// Follows a ball of a chain from the contact that sets it going, and tells how it passes the place that it is to reach.
// It is followed as if no other ball stood there, or along a given route. For contact_windows.cpp.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "bankshot/geometry/aim_point.hpp"
#include "planners/evaluation_budget.hpp"
#include "planners/search_request.hpp"

namespace bankshot::planning::propose {

/// The place that a ball is to reach next, and the distance within which it counts as reached.
struct Place {
  Vec2d at;
  double reach;                         ///< m
  const AimPoint* aim_point = nullptr;  ///< the last ball's; null for the others
};

/// The offset at which one leg passes a place.
struct Pass {
  double left;  ///< m; how far the place, or its exact line, lies to the left of the line of travel
  bool ahead;
};

/// A launch after which the last ball met its aim point.
struct Fall {
  Route route;
  Launch launch;
  double arrived;  ///< m/s
  double right;    ///< m; how far the aim point's centre lies to the right of the line of travel
  const AimPoint* aim_point;
};

/// The path of one ball after its contact.
struct Followed {
  std::map<Route, Pass> passes{};  ///< one for each leg, by the route up to there
  std::vector<Fall> falls{};
};

/// Follows the balls of a chain. They are counted along the chain; the cue ball is 0. After the n-th contact the n-th
/// ball moves on; in a carom that is the cue ball.
class ChainPath {
 public:
  /// The arguments must outlive this.
  ChainPath(const SearchRequest& request, EvaluationBudget& budget, const Objects::Chain& chain);

  int last() const { return static_cast<int>(chain_.balls.size()); }
  const CushionRule& rule(int n) const;
  int number(int n) const { return is_struck(n) ? 0 : object(n).ball; }
  Contact contact_with(int n) const { return Contact::ball(object(n).ball); }
  /// Returns the place of the ball that the n-th ball must touch.
  Place next_of(int n) const;

  /// Follows the ball that a launch sets going by the route `before`, as if it were alone from then. Cost: two
  /// simulations.
  Followed follow(int n, const Route& before, const Place& place, const Launch& launch);
  /// Returns how the ball passes the place along a whole route; none where the route leads nowhere.
  std::optional<Pass> locked_pass(const Route& route, int n, const Place& place, const Launch& launch);
  std::optional<double> left_of(const Route& route, int n, const Place& place, const Launch& launch);

 private:
  const Objects::Object& object(int n) const { return *chain_.balls[static_cast<std::size_t>(n) - 1]; }
  bool is_struck(int n) const { return n == 0 || request_.problem->carom(); }
  const Body& body(int n) const { return is_struck(n) ? request_.puzzle().ball.body : object(n).at_rest.body; }
  const Boundary& alone(int n) const {
    return is_struck(n) ? request_.problem->alone() : alone_[static_cast<std::size_t>(n) - 1];
  }
  int least(int n) const { return request_.problem->carom() && n == 0 ? 0 : rule(n).min; }
  bool is_on(int n, const std::vector<Contact>& met) const;
  template <class Motion, class Cushion>
  void follow_on(const Motion& motion, const Cushion& cushion, int n, const State<double>& sent, const Route& before,
                 const Place& place, const Launch& launch, Followed& out) const;

  const SearchRequest& request_;
  EvaluationBudget& budget_;
  const Objects::Chain& chain_;
  std::vector<Boundary> alone_{};  ///< the table as each ball sees it by itself
};

/// Returns one route followed by the other.
Route joined(Route a, const Route& b);

}  // namespace bankshot::planning::propose
