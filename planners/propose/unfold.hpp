// SPDX-License-Identifier: MIT
//
// Unfolding: the table is reflected at each cushion instead of the ball, so that the path becomes a straight line from
// the ball to an image of the target.
//
// A cushion with restitution e maps velocities linearly: it multiplies the normal part by −e. Its inverse, applied to
// the plane beyond the cushion's line, is an affine map that fixes the line: x -> x − (1 + 1/e)(n·x − d) n. Composed
// along a route, these maps send every leg of a `rolling` or `ideal` path onto one straight line, on any polygon. With
// e = 1 it is the mirror, with e < 1 the stretched image (on rectangles the closed form that is linear in the tangent
// of the aim).
//
// Method: best-first over routes, nearest window first. A route is kept only while a ray from the ball can pass all its
// windows (unfolded cushions), so only routes that can occur are visited. On rectangles with e = 1 the images form a
// lattice and need no tree.
// Cost: about one cross product per window.
// Guarantee: on a table without reflex vertices no route that occurs is skipped. If an edge hides another, candidates
// may be false (the replay decides).
// Source: the image method; beam tracing (Heckbert & Hanrahan 1984).
#pragma once

#include <functional>
#include <optional>
#include <queue>
#include <vector>

#include "bankshot/geometry/aim_point.hpp"
#include "planners/propose/affine.hpp"
#include "planners/search_request.hpp"

namespace bankshot::planning {

/// An aim to try.
struct Image {
  double angle = 0;  ///< rad, of `ray`
  int bounces = 0;
  double distance = 0;        ///< m, from the ball to the image: the path's length if e = 1
  double low = 0;             ///< rad beside `angle`: the aims at which a ray that passes the cushions
  double high = 0;            ///< may reach any part of the target; low = high = 0 if none may
  std::size_t aim_point = 0;  ///< index of the problem's aim point
  int node = -1;              ///< index of the node with its route; -1 in a lattice
  Vec2d ray{};                ///< from the ball to the image of the aim point, or of a point on its exact line
};

class Unfolding {
 public:
  struct Options {
    bool parts = false;  ///< also propose images of which a ray may reach some part but not the centre
    /// Restitution of the unfolding; exact only if it is the cushions'. A rail with a restitution of its own uses the
    /// same share of that.
    double restitution = 1;
    /// Keep the route of each candidate, which a lattice does not; `low` and `high` are then left out if the ray to the
    /// centre passes.
    bool keep_routes = false;
  };
  Unfolding(const SearchRequest& request, const Options& options);

  /// Returns the cushions of a candidate, in order; not kept in a lattice.
  Route route(const Image& c) const;

  /// Returns the next candidate, nearest first; none when all were returned.
  std::optional<Image> next();

  /// Returns false if routes were left unvisited because there were too many.
  bool whole() const { return whole_; }
  /// Returns the number of routes left out because no launch within the speed bound rolls so far.
  long too_long() const { return too_long_; }
  /// Returns whether distances are path lengths; then the first shot found is the shortest.
  bool shortest_first() const { return mirrors_; }

 private:
  struct Node {
    Affine image;
    Vec2d from{}, to{};  ///< the beam's first and last ray, anticlockwise, unless it is open
    double distance = 0;
    double length = 0, length_before = 0;  ///< m; least length of any path to the last cushion, and to the one before
    int bounces = 0;
    int last = -1, before = -1;
    int self = -1, parent = -1;  ///< indices in the list of nodes
    bool flipped = false;
    bool open = true;     ///< no cushion bounds the beam yet
    bool closed = false;  ///< no ray passes all cushions
  };
  /// A node to visit, by its index in the list of nodes.
  struct Turn {
    double distance;
    std::size_t node;
  };
  struct Farther {
    template <class A>
    bool operator()(const A& a, const A& b) const {
      return a.distance > b.distance;
    }
  };

  void add(const Node& node);
  void visit(Node node);
  void propose(const Node& node);
  /// Returns the candidate of an aim point; none if no ray gets near it.
  std::optional<Image> candidate(const Node& node, std::size_t aim_point) const;
  bool is_beside(const Node& node, const AimPoint& aim_point) const;
  bool is_point(const AimPoint& aim_point) const;
  bool leads_over_table(const Vec2d& from, const Vec2d& way) const;
  void find_window(const Node& node, const AimPoint& aim_point, Image& c) const;
  std::optional<Node> child(const Node& node, int wall);
  /// Returns the node after one more cushion, with its beam and lengths still those of `node`.
  Node beyond(const Node& node, int wall) const;
  /// Returns the least distance between centres that touch two cushions; 0 for neighbours and for none (-1).
  double apart(int i, int j);
  void follow_route();
  void lattice();
  Affine through(const Affine& image, int wall) const;
  double restitution_of(int wall) const;

  const SearchRequest& request_;
  Options options_;
  bool mirrors_ = true;  ///< all cushions stretch by 1
  bool whole_ = true;
  double longest_;  ///< m, how far the fastest launch rolls
  long visited_ = 0, too_long_ = 0;
  std::vector<double> apart_;  ///< cache of apart(), -1 where it is unknown
  std::vector<Node> nodes_;
  std::priority_queue<Turn, std::vector<Turn>, Farther> turns_;
  std::priority_queue<Image, std::vector<Image>, Farther> candidates_;
};

}  // namespace bankshot::planning
