// SPDX-License-Identifier: MIT
//
// The forward map divides aim × ln speed into cells. Where a path's shape depends on its speed, it shows which routes
// there are.
// Method: each node simulates the real path with dual numbers (discover.hpp). The free leg after each allowed number of
// bounces has a residual and its derivatives, which lead to roots (roots.hpp). At each aim only the speeds are tried
// that may arrive as asked. Between two neighbours that meet different cushions the aim is divided near the change, so
// that narrow routes get nodes of their own. A route that is given is followed on its locked path.
// Worked number: cells of 2° and 0.12 of ln speed are 180 aims by 39 speeds from 0.1 to 10 m/s. A ball that must rest
// at a point three cushions on does so from three or four speeds an aim. So some 700 nodes are followed, and about
// 2,000 more where cushions change: 3,000 simulations.
// Cost: some thousands of simulations with dual numbers.
// Guarantee: none. A root is missed where paths bend within a cell more than the reach allows. It is also missed where
// a route is narrower than the spacing and lies between equal neighbours. Of 51,709 shots at one speed that brute force
// found, on rectangles and polygons, beside rails and frozen, none is missed (tests/plan/brute_force_test.cpp).
#pragma once

#include <optional>
#include <vector>

#include "planners/solve/roots.hpp"
#include "planners/trace/discover.hpp"

namespace bankshot::planning::propose {

/// Returns the launch speeds to try, `cell` apart in ln speed. None is too slow to reach the nearest aim point, or to
/// arrive as asked.
std::vector<double> speeds_to_try(const SearchRequest& request, double cell);

class ForwardMap {
 public:
  ForwardMap(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, const Spacing& spacing)
      : request_(request), budget_(budget), found_(found), cell_(spacing), roots_(request, budget, found, spacing) {}

  /// Searches all aims that the puzzle allows, at all speeds that matter.
  void run();

 private:
  /// The place of a node's launch speed relative to those that arrive as asked.
  enum class Place { below, within, beyond };
  struct Node {
    double angle, speed;
    Route route;
    std::vector<Passage> passages;
    std::vector<BouncePlace> places;
    Place place;
  };
  using Column = std::vector<std::optional<Node>>;  ///< one aim at all speeds; none where it was not followed

  static bool within(const std::optional<Node>& n) { return n && n->place == Place::within; }
  Column column(double angle, const std::vector<double>& rows, const Column& neighbour);
  Node node(double angle, double speed);
  Place place() const;
  double cells_of_speed(const Passage& p) const;
  void keep_lead(double angle, double speed, const Passage& p);
  void between(const Node& a, const Node& b);
  static bool alike(const Node& a, const Node& b);
  bool lacks_root(const Node& a, const Node& b) const;
  bool hopeless(const Node& a, const Node& b) const;
  double change(const Node& a, const Node& b) const;

  const SearchRequest& request_;
  EvaluationBudget& budget_;
  SearchResult& found_;
  Spacing cell_;
  Roots roots_;
  Discovery forward_{};  ///< the node followed last
  std::vector<Candidate> candidates_{};
};

}  // namespace bankshot::planning::propose
