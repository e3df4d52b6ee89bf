// SPDX-License-Identifier: MIT
//
// Aims across the last ball, for each route by which the balls before it come to it.
// Methods: launches that a replay makes as they are, by whatever they meet (into a pocket first of all, since hardly
// any that falls is on its exact line; onto a point last); for each leg of the last ball a sweep evenly in the cut,
// each aim at the speed that arrives as asked, whose changes of side are bisected and whose launches beside the exact
// line are tried; then a grid in the cut and the speed, from whose nodes Newton's method goes where the derivatives
// predict a root nearby; last, around each launch of a sweep that has more room than its neighbours, the aims between
// them are climbed. Cost: some 600 simulations a route of launches, 250 a pair of routes in a sweep, 300 in a grid, 100
// a climb. Guarantee: none beyond the proof.
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <set>
#include <tuple>

#include "planners/certify.hpp"
#include "planners/line_search.hpp"
#include "planners/locked/clearance.hpp"
#include "planners/locked/newton.hpp"
#include "planners/locked/speed.hpp"
#include "planners/steps/made_as_asked.hpp"
#include "planners/steps/settings.hpp"
#include "planners/steps/steps.hpp"
#include "planners/steps/sweeps.hpp"
#include "planners/steps/to_ball.hpp"
#include "planners/stop.hpp"

namespace bankshot::planning::steps {
namespace {

using namespace settings::chains;

class Sweeps {
 public:
  Sweeps(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, Parts& parts)
      : request_(request), budget_(budget), found_(found), parts_(parts) {}

  void run(const Objects::Chain& chain, const std::vector<Leg>& legs) {
    const std::vector<Approach> to_ball = approaches_to_last(request_, budget_, chain);
    if (request_.problem->drops()) launches(to_ball);  // hardly any that falls is on the exact line
    each_pair(chain, legs, to_ball, [&](const Branch& aim, const Range& across) { sweep(aim, across); });
    each_pair(chain, legs, to_ball, [&](const Branch& aim, const Range& across) { grid(aim, across); });
    if (!request_.problem->drops()) launches(to_ball);
    climb_peaks();
  }

 private:
  /// Those that are made as they are, by whatever they meet.
  void launches(const std::vector<Approach>& to_ball) {
    for (const Approach& approach : to_ball)
      each_launch(request_, approach.across, {sweep_steps, grid_rows}, [&](const Launch& launch, int) {
        if (over()) return true;
        if (const auto made = made_as_asked(request_, budget_, launch))
          certify(request_, budget_, found_, made->launch, made->replay.bounces, word::chains, Demand::off_centre);
        return false;
      });
  }

  bool over() const { return sweeps_over(request_, budget_, found_); }

  /// `look(chain, aims across the ball)`, once each.
  template <class Look>
  void each_pair(const Objects::Chain& chain, const std::vector<Leg>& legs, const std::vector<Approach>& to_ball,
                 const Look& look) {
    std::set<std::tuple<Route, double, double>> done;
    for (const Leg& leg : legs) {
      if (!done.insert({leg.route, leg.aim_point.at.x, leg.aim_point.at.y}).second) continue;
      for (const Approach& approach : to_ball) {
        if (over()) return;
        const Route whole = together(chain, approach.route, leg);
        look({request_, whole, leg.aim_point}, approach.across);
        parts_.climb(request_, budget_, found_);
      }
    }
  }

  /// A launch at an aim, and on which side of the aim point it leads the ball.
  struct Side {
    Launch launch;
    double side = 0;
    double room = 0;  ///< m, its clearance
  };

  std::optional<Side> side_at(const Branch& aim, double angle, double guess) {
    if (budget_.spent()) return {};
    const auto speed = speed_near(aim, budget_, angle, guess);
    const auto l = speed ? linearise(aim, budget_, {*speed, angle}) : std::nullopt;
    if (!l) return {};
    return Side{{*speed, angle}, request_.stop ? l->r[0] * l->by_speed(1) - l->r[1] * l->by_speed(0) : l->r[0]};
  }

  /// Where Newton's method does not come to the speed that arrives as asked.
  std::optional<Side> side_from_bounds(const Branch& aim, double angle) {
    const auto speed = speed_at(aim, budget_, angle, request_.problem->boundary.diagonal);
    return speed ? side_at(aim, angle, *speed) : std::nullopt;
  }

  void sweep(const Branch& aim, const Range& across) {
    const double middle = (across.low + across.high) / 2, half = (across.high - across.low) / 2;
    std::optional<Side> last;
    std::vector<Side> row;
    double guess = middle_speed(request_);
    for (int i = -sweep_steps; i <= sweep_steps && !over(); ++i) {
      const double cut = widest_cut * i / sweep_steps;
      const double to = middle + half * std::sin(cut);
      auto now = side_at(aim, to, guess);
      if (!now) now = side_from_bounds(aim, to);
      if (now) guess = now->launch.speed;
      if (now && last && (now->side > 0) != (last->side > 0)) between(aim, *last, *now);
      last = now;
      if (now && !request_.starts()) row.push_back(*now);
    }
    make_beside(aim, row);
  }

  void between(const Branch& aim, const Side& a, const Side& b) {
    double low = a.launch.angle, high = b.launch.angle;
    Launch at = a.launch;
    int left = sweep_halvings;
    bisect(
        low, high, [&](double, double) { return left-- > 0; },
        [&](double angle) {
          const auto middle = side_at(aim, angle, at.speed);
          if (middle) at = middle->launch;
          return middle && (middle->side > 0) == (a.side > 0);
        });
    const auto root = newton(aim, budget_, at, settings::wide);
    if (root) certify_root(aim, budget_, found_, root.launch, word::chains);
  }

  /// Where the exact line needs a launch that no bound allows, or is blocked, others lead in beside it: those of the
  /// row with room, and what is between two of them around each that has more than its neighbours.
  void make_beside(const Branch& aim, std::vector<Side>& row) {
    for (Side& s : row) s.room = clearance(aim, budget_, s.launch).value_or(-request_.problem->boundary.diagonal);
    for (std::size_t i = 0; i < row.size(); ++i) {
      const Side& s = row[i];
      if (over()) return;
      if (request_.speed.contains(s.launch.speed) && s.room > 0)
        certify(request_, budget_, found_, {s.launch.speed, wrap_angle(s.launch.angle)}, bounces_of(aim.route),
                word::chains, Demand::off_centre);
      const Side& before = row[i > 0 ? i - 1 : i];
      const Side& after = row[std::min(i + 1, row.size() - 1)];
      if (s.room < before.room || s.room < after.room || s.room < -least_hope * aim.aim_point.reach) continue;
      const double half = std::max(s.launch.angle - before.launch.angle, after.launch.angle - s.launch.angle);
      peaks_.push_back(
          {s.launch, Route(aim.route.begin(), aim.route.end()), aim.aim_point, request_.spin, half, s.room});
    }
  }

  /// Last of all, since each takes a hundred simulations: the most hopeful first.
  void climb_peaks() {
    if (over()) return;
    std::ranges::sort(peaks_, std::ranges::greater{}, &Candidate::room);
    std::ranges::move(peaks_, std::back_inserter(found_.candidates));
    parts_.climb(request_, budget_, found_);
  }

  void grid(const Branch& aim, const Range& across) {
    const Neighbourhood near{
        grid_reach * (across.high - across.low) / 2 / grid_steps,
        grid_reach *
            (request_.one_unknown() ? 1 : std::log(request_.speed.high / slowest_tried(request_)) / (grid_rows - 1))};
    each_launch(request_, across, {grid_steps, grid_rows}, [&](const Launch& node, int) {
      if (over()) return true;
      const auto l = linearise(aim, budget_, node);
      const auto step = l ? newton_step(*l, request_.one_unknown()) : std::nullopt;
      if (!step || !(std::abs((*step)[0]) < near.step_aim && std::abs((*step)[1]) < near.step_speed)) return false;
      const auto root = newton(aim, budget_, {node.speed * std::exp((*step)[1]), node.angle + (*step)[0]}, near);
      if (root) certify_root(aim, budget_, found_, root.launch, word::chains);
      return false;
    });
  }

  const SearchRequest& request_;
  EvaluationBudget& budget_;
  SearchResult& found_;
  Parts& parts_;
  std::vector<Candidate> peaks_{};  ///< of clearance, between two aims of a sweep
};

}  // namespace

void sweeps(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, const Objects::Chain& chain,
            const std::vector<Leg>& known, Parts& parts) {
  std::vector<Leg> legs = known;
  std::ranges::move(legs_of_images(request, chain), std::back_inserter(legs));
  Sweeps(request, budget, found, parts).run(chain, legs);
}

bool sweeps_over(const SearchRequest& request, EvaluationBudget& budget, const SearchResult& found) {
  return stop::over(request, budget, found) || !(request.all() || request.starts() || found.shots.empty());
}

}  // namespace bankshot::planning::steps
