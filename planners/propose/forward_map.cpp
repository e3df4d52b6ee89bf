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
#include "planners/propose/forward_map.hpp"
#include "bankshot/geometry/aim_point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "bankshot/numbers/tolerances.hpp"
#include "planners/propose/proposers.hpp"
#include "planners/settings.hpp"
#include "planners/solve/roots.hpp"
#include "planners/trace/discover.hpp"

namespace bankshot::planning::propose {
namespace {

using namespace settings::forward_map;

/// Returns the launch speed [m/s] below which no ball rolls as far as the nearest aim point, or arrives as fast as
/// asked.
double slowest_arrival(const SearchRequest& request) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const AimPoint& m : request.problem->aim_points)
    nearest = std::min(nearest, norm(m.at - request.puzzle().ball.at) - m.capture());
  const double asked = request.arrival ? request.arrival->low : 0;
  const double energy = asked * asked + 2 * deceleration(request.puzzle().physics) * std::max(0.0, nearest);
  return std::max(std::sqrt(energy), settings::slowest_of_fastest * request.speed.high);
}

class ForwardMap {
 public:
  ForwardMap(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, const Spacing& spacing)
      : request_(request), budget_(budget), found_(found), cell_(spacing), roots_(request, budget, found, spacing) {}

  /// Searches all aims that the puzzle allows, at all speeds that matter.
  void run() {
    const Range aims = request_.angle.value_or(whole_turn);
    const int columns = std::max(1, static_cast<int>(std::ceil((aims.high - aims.low) / cell_.aim)));
    const auto aim = [&](int i) { return aims.low + (aims.high - aims.low) * i / columns; };
    const std::vector<double> rows = speeds_to_try(request_, cell_.speed);
    Column before = column(aim(0), rows, {});
    for (int i = 1; i <= columns && !roots_.done(); ++i) {
      Column after = column(aim(i), rows, before);
      for (std::size_t k = 0; k < rows.size() && !roots_.done(); ++k) {
        if (within(before[k]) && !after[k]) after[k] = node(aim(i), rows[k]);
        if (within(after[k]) && !before[k]) before[k] = node(aim(i - 1), rows[k]);
        if (before[k] && after[k]) between(*before[k], *after[k]);
      }
      before = std::move(after);
    }
    roots_.seek_rest();
    if (found_.shots.empty() && !request_.starts())
      found_.candidates.insert(found_.candidates.end(), candidates_.begin(), candidates_.end());
  }

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

  /// Follows one aim at the speeds around those that arrive as asked; no others matter. They change little from one aim
  /// to the next, so it begins near where they began at the neighbour. It goes up until a speed is too fast, and down
  /// until one is too slow.
  Column column(double angle, const std::vector<double>& rows, const Column& neighbour) {
    Column out(rows.size());
    const auto first =
        static_cast<std::size_t>(std::find_if(neighbour.begin(), neighbour.end(), within) - neighbour.begin());
    const std::size_t start = first < neighbour.size() ? first : 0;
    const auto place = [&](std::size_t k) {
      out[k] = node(angle, rows[k]);
      return out[k]->place;
    };
    bool too_fast = false, too_slow = false;
    for (std::size_t k = start; k < rows.size() && !too_fast && !roots_.done(); ++k) {
      const Place p = place(k);
      too_fast = p == Place::beyond;
      too_slow = too_slow || (k == start && p == Place::below);
    }
    for (std::size_t k = start; k-- > 0 && !too_slow && !roots_.done();) too_slow = place(k) == Place::below;
    return out;
  }

  Node node(double angle, double speed) {
    discover(request_, budget_, {speed, wrap_angle(angle)}, !cell_.whole, forward_);
    for (const Passage& p : forward_.passages) {
      keep_lead(angle, speed, p);
      roots_.visit({request_, std::span<const Meeting>(forward_.route).first(p.meetings),
                    request_.problem->aim_points[p.aim_point]},
                   {speed, angle}, p.linear);
    }
    return {angle, speed, forward_.route, forward_.passages, forward_.places, place()};
  }

  /// Returns the place of the launch that was followed last.
  Place place() const {
    // A reflex vertex sends a slightly slower ball another way.
    if (cell_.whole || !request_.problem->boundary.unfolds()) return Place::within;
    if (forward_.passages.empty()) return forward_.rests ? Place::below : Place::within;
    bool below = true, beyond = true;
    for (const Passage& p : forward_.passages) {
      const double cells = cells_of_speed(p);
      below = below && cells > 1;
      beyond = beyond && cells < -1;
    }
    return below ? Place::below : beyond ? Place::beyond : Place::within;
  }

  /// Returns the cells of speed from here to where the ball arrives as asked.
  double cells_of_speed(const Passage& p) const {
    const Linear& l = p.linear;
    if (request_.one_unknown()) return 0;
    if (!request_.stop) return -l.r[1] / l.by_speed(1) / cell_.speed;
    const double diagonal = request_.problem->boundary.diagonal;
    // A ball that would rest outside the table is too fast.
    const double outside = -request_.problem->boundary.clearance(request_.problem->aim_points[p.aim_point].at -
                                                                 Vec2d{l.r[0], l.r[1]} * diagonal);
    return outside > 0 ? -outside / (diagonal * std::hypot(l.by_speed(0), l.by_speed(1))) / cell_.speed : 0;
  }

  /// Keeps a node as a candidate if a turn within its cell may reach some part of the target, perhaps not its centre.
  /// The speed is the one that arrives as asked.
  void keep_lead(double angle, double speed, const Passage& p) {
    if (!found_.shots.empty()) return;
    const Linear& l = p.linear;
    double lateral = l.r[0], by_aim = l.by_aim(0), step = 0;
    if (!request_.one_unknown()) {
      const std::size_t along = !request_.stop || std::abs(l.by_speed(1)) > std::abs(l.by_speed(0)) ? 1 : 0;
      step = -l.r[along] / l.by_speed(along);
      lateral = l.r[1 - along] + l.by_speed(1 - along) * step;
      by_aim = l.by_aim(1 - along) - l.by_speed(1 - along) * l.by_aim(along) / l.by_speed(along);
    }
    const AimPoint& aim_point = request_.problem->aim_points[p.aim_point];
    const double wide = aim_point.reach / request_.problem->boundary.diagonal + std::abs(by_aim) * cell_.aim;
    if (!(std::abs(lateral) < wide && std::abs(step) < settings::roots::seed_reach * cell_.speed)) return;
    const std::span<const Meeting> route(forward_.route.data(), p.meetings);
    for (const Candidate& known : candidates_)
      if (known.aim_point == aim_point && std::abs(angle_difference(known.launch.angle, angle)) < cell_.aim / 2 &&
          std::ranges::equal(known.route, route))
        return;
    candidates_.push_back({{speed * std::exp(step), wrap_angle(angle)},
                           {route.begin(), route.end()},
                           aim_point,
                           request_.spin,
                           cell_.aim});
  }

  void between(const Node& a, const Node& b) {
    const bool same = alike(a, b);
    if ((same && !lacks_root(a, b)) || hopeless(a, b) || budget_.spent()) return;
    if (b.angle - a.angle < (same ? tolerance::same_aim : cell_.narrowest)) return;
    const Node other = node(change(a, b), a.speed);
    between(a, other);
    between(other, b);
  }

  /// Returns whether two nodes meet the same cushions, and the same legs lead to the aim points.
  static bool alike(const Node& a, const Node& b) {
    const auto same = [](const Passage& p, const Passage& q) {
      return p.meetings == q.meetings && p.aim_point == q.aim_point;
    };
    return a.route == b.route && std::ranges::equal(a.passages, b.passages, same);
  }

  /// Returns whether some root between two nodes that are alike, at one speed, is not known. A leg that passes on both
  /// sides of its aim point has an odd number of roots there, another one an even number; two, if it turns back near
  /// it.
  bool lacks_root(const Node& a, const Node& b) const {
    if (!request_.one_unknown() || !cell_.every_root) return false;
    for (std::size_t i = 0; i < a.passages.size(); ++i) {
      const Linear &at_a = a.passages[i].linear, &at_b = b.passages[i].linear;
      const auto leads_inside = [&](const Linear& l, double way) {
        const double step = -l.r[0] / l.by_aim(0) * way;
        return step > 0 && step < b.angle - a.angle;
      };
      const bool both_sides = at_a.r[0] * at_b.r[0] < 0, turns_back = leads_inside(at_a, 1) && leads_inside(at_b, -1);
      const Branch aim{request_, std::span<const Meeting>(a.route).first(a.passages[i].meetings),
                       request_.problem->aim_points[a.passages[i].aim_point]};
      const auto known = roots_.known_between(aim, {a.angle, b.angle});
      const bool odd = known % 2 == 1;
      if (both_sides != odd || (turns_back && known == 0)) return true;
    }
    return false;
  }

  /// Returns whether no path between two nodes can be a shot: it is too fast as well, or ends too early to meet all the
  /// cushions.
  bool hopeless(const Node& a, const Node& b) const {
    if (a.place != b.place) return false;
    const auto most = static_cast<int>(std::max(a.route.size(), b.route.size()));
    return a.place == Place::beyond || (a.place == Place::below && most + 1 < request_.cushions().min);
  }

  /// Returns the aim at which to divide. It lies just beyond where one of two neighbours stops meeting the cushion that
  /// the other does not meet, as far as its derivatives tell; else half way.
  double change(const Node& a, const Node& b) const {
    const auto differ = std::mismatch(a.route.begin(), a.route.end(), b.route.begin(), b.route.end());
    const auto m = static_cast<std::size_t>(differ.first - a.route.begin());
    double best = a.angle + (b.angle - a.angle) / 2, nearest = (b.angle - a.angle) / 2;
    for (const auto& [node, way] : {std::pair{&a, 1.0}, std::pair{&b, -1.0}}) {
      const Wall* const line = m < node->route.size() && m < node->places.size()
                                   ? request_.problem->boundary.line(node->route[m].with)
                                   : nullptr;
      if (!line) continue;
      const BouncePlace& at = node->places[m];
      const double end = dot(line->along, at.by_aim * way > 0 ? line->to : line->from);
      const double to_end = (end - at.along) / at.by_aim * way;
      if (!(to_end > 0)) continue;  // it is no end of the cushion that makes them differ
      const double turn = std::max(least_turn * (b.angle - a.angle), past_the_end * to_end);
      if (turn < nearest) best = node->angle + way * turn, nearest = turn;
    }
    return best;
  }

  const SearchRequest& request_;
  EvaluationBudget& budget_;
  SearchResult& found_;
  Spacing cell_;
  Roots roots_;
  Discovery forward_{};  ///< the node followed last
  std::vector<Candidate> candidates_{};
};

}  // namespace

std::vector<double> speeds_to_try(const SearchRequest& request, double cell) {
  const Range& v = request.speed;
  if (request.pinned || v.fixed()) return {request.pinned.value_or(v.low)};
  const double low = std::max(v.low, slowest_arrival(request));
  if (!(low < v.high)) return {v.high};
  const int rows = 1 + static_cast<int>(std::ceil(std::log(v.high / low) / cell));
  std::vector<double> out;
  for (int i = 0; i < rows; ++i) out.push_back(low * std::pow(v.high / low, static_cast<double>(i) / (rows - 1)));
  return out;
}

void partition(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, const Spacing& spacing) {
  ForwardMap(request, budget, found, spacing).run();
}

/// Paths with more bounces bend more within a cell.
Spacing usual_spacing(const SearchRequest& request) {
  const double finer = static_cast<double>(plain_bounces) / std::max(plain_bounces, request.cushions().max);
  return request.all() ? Spacing{usual.aim * finer, usual.speed * finer} : usual;
}

}  // namespace bankshot::planning::propose
