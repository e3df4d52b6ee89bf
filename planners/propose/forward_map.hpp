// SPDX-License-Identifier: MIT
//
// A forward map of aim × ln speed: where a path's shape depends on its speed, this shows which routes there are.
// Method: each node simulates the real path with dual numbers (discover.hpp); the free leg after any number of bounces
// that is allowed has a residual and its derivatives, which lead to roots (roots.hpp). Of each aim only the speeds are
// tried that may arrive as asked. Between two neighbours that meet different cushions the aim is divided near where
// that changes, so that narrow routes get nodes of their own. A route that is given is mapped on its locked path.
// Worked number: cells of 2° and 0.12 of ln speed are 180 aims by 39 speeds from 0.1 to 10 m/s; a ball that must rest
// at a point three cushions on does so from three or four speeds an aim, so some 700 nodes are followed, and about
// 2,000 more where cushions change: 3,000 simulations.
// Cost: some thousands of simulations with dual numbers, a third of a microsecond a bounce each.
// Guarantee: none; a root is missed where the map bends within a cell more than the reach allows, or where a route is
// narrower than the spacing and lies between equal neighbours.
#pragma once

#include <optional>
#include <vector>

#include "planners/solve/roots.hpp"
#include "planners/trace/discover.hpp"

namespace bankshot::planning::propose {

/// Launch speeds that a map tries, so far apart in ln speed: none too slow for the nearest aim point, nor to arrive as
/// asked.
std::vector<double> speeds_to_try(const SearchRequest& request, double cell);

class ForwardMap {
 public:
  ForwardMap(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, const Spacing& spacing)
      : request_(request), budget_(budget), found_(found), cell_(spacing), roots_(request, budget, found, spacing) {}

  /// All aims that the puzzle allows, at all speeds that matter.
  void run();

 private:
  /// How fast a node's launch is, against those that arrive as asked.
  enum class Place { below, within, beyond };
  struct Node {
    double angle, speed;
    Route route;
    std::vector<BouncePlace> places;
    Place place;
  };
  using Column = std::vector<std::optional<Node>>;  ///< one aim at all speeds, where it is worth while

  static bool within(const std::optional<Node>& n) { return n && n->place == Place::within; }
  Column column(double angle, const std::vector<double>& rows, const Column& neighbour);
  Node node(double angle, double speed);
  Place place() const;
  double cells_of_speed(const Passage& p) const;
  void keep_lead(double angle, double speed, const Passage& p);
  void between(const Node& a, const Node& b);
  bool hopeless(const Node& a, const Node& b) const;
  double change(const Node& a, const Node& b) const;

  const SearchRequest& request_;
  EvaluationBudget& budget_;
  SearchResult& found_;
  Spacing cell_;
  Roots roots_;
  Discovery forward_{};  ///< of the node followed last
  std::vector<Candidate> candidates_{};
};

}  // namespace bankshot::planning::propose
