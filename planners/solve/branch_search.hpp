// SPDX-License-Identifier: MIT
//
// A search of one branch: all launches along one route that meet one aim point, where arrival speed or spin is free.
//   corrected      the point of the branch nearest to a launch (solve/least_change.hpp)
//   curve_through  continuation where one quantity is free: steps along the curve, both ways, until the arrival speed
//                  or the spin ends. The replay judges the steps afterwards: only parts of a curve may be shots
//   climb          where more is free, a compass search over the tangent space to a best shot by `prefer`
//   beside         launches beside a curve, where an object ball is to drop and no point of the curve is made: those
//                  that fall by the jaws. Where every shot is wanted, first those that fall straight, also between
//                  points
// A best shot lies inside, at a bound, or where a cushion's end or a pocket cuts the branch; there the edge is
// bisected.
// Cost: three simulations a point; some 15 points a curve, 60 a surface. Guarantee: every shot that is kept is
// verified. Nothing certifies that no better one exists; tests/stress measures it. Source: the compass search is that
// of Kolda, Lewis & Torczon, SIAM Review 45, 2003, algorithm 3.2, on the tangent space.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "bankshot/geometry/aim_point.hpp"
#include "planners/search_result.hpp"
#include "planners/solve/least_change.hpp"
#include "planners/solve/point.hpp"
#include "planners/solve/settings.hpp"
#include "planners/trace/clearance.hpp"
#include "planners/verify/certify.hpp"

namespace bankshot::planning::branch {

class BranchSearch {
 public:
  BranchSearch(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, const Candidate& start);

  /// A point, its verification and its merit.
  struct Tried {
    Point at;
    double merit = 0;
    std::optional<Proof> proof{};
    std::optional<Room> room{};  ///< clearances of its locked path, if they were computed
    bool between = false;        ///< added between two points of the first continuation
    bool looked = false;         ///< launches to either side were tried
    double spare = -forever;  ///< m; the largest clearance found beside it; where all are negative, the one that first
                              ///< order expects
    bool made() const { return proof && proof->holds(); }
    /// Returns whether this one is better. Any shot is better than a launch that is none.
    bool above(const Tried& o) const { return made() != o.made() ? made() : merit > o.merit; }
  };
  /// Searches a branch where at most one quantity is free. Keeps the best shot of each connected part. If only the
  /// first shot is wanted, it keeps just that.
  void search();

  /// Searches a branch where more is free. `foot` returns the point of the branch nearest to the start. `climb_from`
  /// goes up from there to a shot and keeps it.
  std::optional<Tried> foot();
  void climb_from(const Tried& from);

  /// Moves a shot along its branch to where its success is largest, found by simulation. It comes last, for the few
  /// shots that are printed.
  Shot tuned(const Shot& shot);

  /// Returns the number of free quantities.
  static int freedom(const SearchRequest& request);

 private:
  using Curve = std::vector<Tried>;
  /// Returns what must be 0. `at_bound` is set once the arrival speed is at an end of its range, where it then stays.
  Equations equations(const Point& p, bool& at_bound) const;
  /// Returns the point of the branch nearest to x. `held`: a coordinate that stays as it is. `tolerance`: size of the
  /// last step, in scales; the error left is about its square.
  std::optional<Point> corrected(const Vector& x, Box box, int held = -1, double tolerance = settings::settled);
  /// Returns an orthonormal basis, in scales, of the changes that stay on the branch.
  Eigen::MatrixXd tangents(const Point& p) const;
  double merit(const Point& p) const;
  bool inside(const Point& p) const;
  bool at_end(const Point& p) const;
  /// Returns whether a point is so far from a shot that no other of its curve is one.
  bool is_hopeless(const Point& p);
  /// Returns whether a point is outside the bounds on the launch speed, and goes farther out this way.
  bool leaves_for_good(const Point& at, const Vector& way) const;
  Tried attempt(const Point& p);
  Tried attempt_where_clear(const Point& p);

  Curve curve_through(const Point& from);
  void extend(const Point& from, double way, Curve& out);
  void add_crossings(Curve& curve);
  void look_between(Curve& curve);
  void divide(Curve& curve, const std::function<bool(const Tried&)>& is_hopeful);
  void keep_parts(Curve& curve);
  bool is_listed(const AimPoint& aim_point, std::span<const Meeting> route, std::span<const Shot> among) const;
  bool keep_beside(const Launch& launch);
  /// Returns whether an object ball is to drop. Jaws may let it in where its exact line is blocked.
  bool drops() const { return request_.problem->objects && start_.aim_point.drops(); }
  static Launch beside(const Launch& line, double turn);
  /// Neighbouring aims beside a point of a curve, from one step to another.
  struct Strip {
    Launch line;
    LaunchSpin spin;
    double step;
    int first = 0, last = 0;
    Launch middle() const { return beside(line, step * (first + last) / 2); }
  };

  bool look_beside(Curve& curve);
  bool look_beside(Tried& t);
  bool look_to_one_side(Tried& t, double way);
  void look_for_jaw_shots(const Curve& curve);
  void add_strips(const Point& p, std::map<std::vector<Contact>, std::vector<Strip>>& ways);
  Tried edge(const Tried& inside, const Tried& outside);
  Tried peak(const Tried& low, const Tried& best, const Tried& high);
  Vector near_start() const;
  Tried clear(Tried t);
  Tried climb(Tried from);

  std::vector<Vector> ways(const Tried& from, double turned) const;

  void keep(const Tried& t);

  SearchRequest request_;  ///< a copy, with the spin of the launch in hand
  EvaluationBudget& budget_;
  SearchResult& found_;
  const Candidate& start_;
  Branch aim_;
  Box box_, wide_;
  Vary vary_;
};

/// Moves the shots that are printed, all or the first, along their branches to where success is largest.
void tune(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found);

}  // namespace bankshot::planning::branch
