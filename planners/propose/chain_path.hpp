// SPDX-License-Identifier: MIT
//
// How a ball of a chain goes on from the contact that sent it, and how it passes what it is to meet next: really, as if
// no other ball stood there, or along a route that is given. For bands.cpp.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "bankshot/geometry/aim_point.hpp"
#include "planners/evaluation_budget.hpp"
#include "planners/search_request.hpp"

namespace bankshot::planning::propose {

/// What a ball is to meet, and how far it is sent by.
struct Place {
  Vec2d at;
  double reach;                         ///< m
  const AimPoint* aim_point = nullptr;  ///< of the last ball
};

/// Of one leg, how a place is passed.
struct Pass {
  double left;  ///< m, of the line of travel
  bool ahead;
};

/// A launch after which the last ball met its aim point.
struct Fall {
  Route route;
  Launch launch;
  double arrived;  ///< m/s
  double right;    ///< m, of the aim point's centre
  const AimPoint* aim_point;
};

/// What becomes of a ball.
struct Followed {
  std::map<Route, Pass> passes{};  ///< by its routes as they grow from leg to leg
  Route route{};                   ///< until it has met more than it may, falls or rests
  Contact end{};
  double nearest = forever;  ///< m, to the place
  std::vector<Fall> falls{};
};

/// Balls are counted along the chain, the struck one is 0. After the n-th contact the n-th is on its way, in a carom
/// the struck one.
class ChainPath {
 public:
  /// All must outlive it.
  ChainPath(const SearchRequest& request, EvaluationBudget& budget, const Objects::Chain& chain);

  int last() const { return static_cast<int>(chain_.balls.size()); }
  const CushionRule& rule(int n) const;
  int number(int n) const { return is_struck(n) ? 0 : object(n).ball; }
  Contact contact_with(int n) const { return Contact::ball(object(n).ball); }
  /// The ball that it must touch.
  Place next_of(int n) const;

  /// The ball that a launch sends on by the route `before`, as if it were alone from then. Two simulations.
  Followed follow(int n, const Route& before, const Place& place, const Launch& launch);
  /// How it passes the place along a whole route; none where that leads nowhere.
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
  void object_ball_path(const Motion& motion, const Cushion& cushion, int n, const State<double>& sent,
                        const Route& before, const Place& place, const Launch& launch, Followed& out) const;

  const SearchRequest& request_;
  EvaluationBudget& budget_;
  const Objects::Chain& chain_;
  std::vector<Boundary> alone_{};  ///< the table as each ball sees it by itself
};

/// One route after the other.
Route joined(Route a, const Route& b);

}  // namespace bankshot::planning::propose
