// SPDX-License-Identifier: MIT
#include "planners/propose/leg.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "planners/propose/part.hpp"
#include "planners/propose/proposers.hpp"
#include "planners/propose/settings.hpp"
#include "planners/propose/unfold.hpp"
#include "planners/trace/residual.hpp"
#include "planners/verify/in_sight.hpp"

namespace bankshot::planning::propose {
namespace {

using namespace settings::chains;

Leg leg_of(const Part& own, Candidate alone) {
  Leg leg{std::move(alone), {}, {}};
  leg.route = own.whole(leg.alone.route), leg.aim_point = leg.alone.aim_point;
  leg.aim_point.ball = own.whole(leg.aim_point.ball);
  return leg;
}

/// Returns the directions that a straight hit may give the ball.
Range aims_of_a_hit(const SearchRequest& request, const Objects::Object& object) {
  const Vec2d way = object.at_rest.at - request.puzzle().ball.at;
  const double middle = std::atan2(way.y, way.x), half = radians(90.0);
  return {middle - half, middle + half};
}

/// Returns whether the only cushion of a route does not count: the ball touches it as it is hit, or it is beside the
/// pocket, where a ball meets a jaw instead.
bool meets_uncounted(const Problem& alone, const Candidate& candidate) {
  const Contact met = candidate.route.front().with;
  if (alone.touches(met)) return true;
  if (!candidate.aim_point.drops() || alone.boundary.jaws.empty()) return false;
  const JawWalls& jaws = alone.boundary.jaws[static_cast<std::size_t>(candidate.aim_point.taken_by.index)];
  return std::ranges::any_of(jaws.tips, [&](const Circle& tip) { return tip.before == met || tip.after == met; });
}

}  // namespace

bool hit_straight(const SearchRequest& request, const Objects::Chain& chain) {
  return chain.balls.size() == 1 && request.cushions().max == 0 && request.spin.masse == 0;
}

bool is_hidden(const SearchRequest& request, const Objects::Chain& chain) {
  if (request.cushions().max > 0 || request.spin.masse != 0 || !is_level(request.puzzle().physics)) return false;
  std::vector<Circle> others = request.problem->boundary.balls;
  const auto first = std::ranges::find(others, Contact::ball(chain.balls.front()->ball), &Circle::contact);
  const Circle ball = *first;
  others.erase(first);
  return !in_sight(request.puzzle().ball.at, ball, others);
}

std::vector<Leg> legs(const SearchRequest& request, EvaluationBudget& budget, const Objects::Chain& chain,
                      std::vector<Candidate> known) {
  const Part own = last_alone(request, chain);
  SearchRequest all(own.puzzle, Wanted::starts);
  if (hit_straight(request, chain)) all.angle = aims_of_a_hit(request, *chain.balls.front());
  // The search adds a cushion that was not asked for (methods/auto.cpp).
  const bool uncounted = request.problem->then()->counts_any_fall() && request.object_cushions.min > 0;
  std::vector<Leg> out;
  const auto look = [&](const SearchRequest& one) {
    SearchResult found{.candidates = known};
    stretched_images(one, budget, found);
    for (Candidate& candidate : std::span(found.candidates).subspan(known.size())) {
      if (budget.spent()) return;
      if (uncounted && !meets_uncounted(*one.problem, candidate)) continue;
      const auto linear = request.likelier > 0
                              ? linearise({one, candidate.route, candidate.aim_point}, budget, candidate.launch, true)
                              : std::nullopt;
      out.push_back(leg_of(own, std::move(candidate)));
      if (linear) out.back().spread = std::abs(linear->by_aim(0)) * one.problem->boundary.diagonal;
    }
  };
  if (!request.one_unknown())
    look(all.asking(request.asked));
  else
    for (const double share : shares_of_speed) look(all.launched_at(share * request.fixed_speed()));
  return out;
}

Route together(const Objects::Chain& chain, Route before, const Leg& leg) {
  const std::size_t n = chain.balls.size();
  before.push_back({n > 1 ? chain.balls[n - 2]->ball : 0, Contact::ball(chain.balls[n - 1]->ball)});
  before.insert(before.end(), leg.route.begin(), leg.route.end());
  return before;
}

}  // namespace bankshot::planning::propose
