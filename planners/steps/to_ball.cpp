// SPDX-License-Identifier: MIT
#include "planners/steps/to_ball.hpp"

#include <algorithm>
#include <cmath>

#include "planners/locked/newton.hpp"
#include "planners/steps/part.hpp"
#include "planners/steps/settings.hpp"
#include "planners/steps/steps.hpp"

namespace bankshot::planning::steps {
namespace {

using namespace settings::chains;

/// Straight there all aims that touch it; else as far beside its middle as first order says that it goes. `reach`: m,
/// between their centres when they touch.
std::optional<Range> aims_across(const SearchRequest& request, EvaluationBudget& budget, const SearchRequest& own,
                                 double reach, const Candidate& candidate) {
  const Vec2d& place = own.problem->aim_points.front().at;
  if (candidate.route.empty() && request.spin.masse == 0) {
    const Vec2d way = place - request.puzzle().ball.at;
    const double half = std::asin(std::min(1.0, reach / norm(way))), to = std::atan2(way.y, way.x);
    return Range{to - half, to + half};
  }
  const Branch aim{own, candidate.route, own.problem->aim_points.front()};
  const auto root = newton(aim, budget, {*own.pinned, candidate.launch.angle}, settings::wide);
  const auto l = root ? linearise(aim, budget, root.launch) : std::nullopt;
  if (!l || l->by_aim(0) == 0) return {};
  const double first = sweep_beyond * reach / std::abs(l->by_aim(0) * request.problem->boundary.diagonal);
  const auto side = [&](double way) {
    double turn = std::min(widest_aims, first);
    while (turn < widest_aims && !budget.spent()) {
      const auto there = linearise(aim, budget, {root.launch.speed, root.launch.angle + way * turn});
      if (!there || std::abs(there->r[0]) * request.problem->boundary.diagonal > reach) break;
      turn = std::min(widest_aims, turn * sweep_beyond);
    }
    return way * turn;
  };
  return Range{root.launch.angle + side(-1), root.launch.angle + side(1)};
}

/// What sets it going, to where it stands; `by`: the ball that touches it.
struct ToBall {
  Part part;
  const Body& by;
  Step step;
};

void add_approaches(const SearchRequest& request, EvaluationBudget& budget, const Objects::Object& object,
                    const ToBall& to, double speed, std::vector<Approach>& out) {
  ToPlace to_ball(request, to.part, speed);
  const SearchRequest& own = to_ball.at(object.at_rest.at);
  const double reach = touching_distance(to.by, object.at_rest.body);
  SearchResult starts;
  to.step(own, budget, starts);
  for (const Candidate& candidate : starts.candidates) {
    if (budget.spent()) return;
    const Route route = to.part.whole(candidate.route);
    if (std::ranges::find(out, route, &Approach::route) != out.end()) continue;
    if (const auto across = aims_across(request, budget, own, reach, candidate)) out.push_back({route, *across});
  }
}

}  // namespace

double middle_speed(const SearchRequest& request) {
  return request.one_unknown()
             ? request.fixed_speed()
             : std::sqrt(std::max(request.speed.low, request.speed.high * slowest_swept) * request.speed.high);
}

double slowest_tried(const SearchRequest& request) {
  return std::max(request.speed.low, request.speed.high * settings::slowest_of_fastest);
}

std::vector<Approach> approaches(const SearchRequest& request, EvaluationBudget& budget, const Objects::Object& object,
                                 const CushionRule& cushions, Step step) {
  std::vector<Approach> out;
  add_approaches(request, budget, object, {by_itself(request, cushions), request.puzzle().ball.body, step},
                 middle_speed(request), out);
  return out;
}

std::vector<Approach> approaches_to_last(const SearchRequest& request, EvaluationBudget& budget,
                                         const Objects::Chain& chain) {
  const Objects::Object& last = *chain.balls.back();
  const std::size_t n = chain.balls.size();
  const ToBall to{before_last(request, chain), n > 1 ? chain.balls[n - 2]->at_rest.body : request.puzzle().ball.body,
                  n > 1 ? chains : starts_by_map};
  std::vector<Approach> out;
  for (const double faster : approach_speeds)
    add_approaches(request, budget, last, to, faster * middle_speed(request), out);
  return out;
}

void each_launch(const SearchRequest& request, const Range& across, const Grid& grid,
                 const std::function<bool(const Launch&, int)>& look) {
  const double half = (across.high - across.low) / 2, middle = across.low + half;
  const double slowest = slowest_tried(request);
  const int rows = request.one_unknown() ? 1 : grid.speeds;
  const int aims = request.one_unknown() ? grid.aims * finer_alone : grid.aims;
  for (int i = -aims; i <= aims; ++i)
    for (int k = 0; k < rows; ++k) {
      const double speed = rows > 1
                               ? slowest * std::pow(request.speed.high / slowest, static_cast<double>(k) / (rows - 1))
                               : request.fixed_speed();
      if (look({speed, middle + half * std::sin(widest_cut * i / aims)}, k)) return;
    }
}

void starts_by_map(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found) {
  images(request, budget, found);
  if (!is_straight(request.puzzle().physics)) map(request, budget, found, usual_spacing(request));
}

}  // namespace bankshot::planning::steps
