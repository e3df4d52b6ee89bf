// SPDX-License-Identifier: MIT
#include "planners/evaluate/rank.hpp"
#include "bankshot/geometry/aim_point.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "planners/evaluate/first_order.hpp"
#include "planners/evaluate/margin.hpp"
#include "planners/evaluate/safest.hpp"
#include "planners/evaluate/settings.hpp"
#include "planners/evaluate/success.hpp"
#include "planners/trace/discover.hpp"

namespace bankshot::planning {
namespace {

/// Returns whether a shot comes last. If values do not rank, nobody strikes a ball straight into the cushion it touches
/// while there is another shot.
bool last_choice(const SearchRequest& request, const Shot& shot) {
  return (request.puzzle().prefer != Prefer::robust || !request.valued) && !shot.path.cushions.empty() &&
         !request.route && request.problem->into_touched_cushion(shot.launch.angle);
}

/// Orders the shots that are about as likely as the best by how well they leave the cue ball. Then it orders the rest
/// likewise, and so on.
void order_by_leave(const Puzzle& p, std::span<Shot> shots) {
  for (auto rest = shots; !rest.empty();) {
    const double enough = rest.front().robustness.value.value_or(0) - settings::rank::as_likely;
    const auto unlike = std::ranges::find_if(rest, [&](const Shot& s) {
      return s.robustness.value.value_or(0) < enough || s.path.scratch != rest.front().path.scratch;
    });
    std::ranges::stable_sort(rest.begin(), unlike, {}, [&](const Shot& s) {
      return s.path.cue_rests ? norm(*s.path.cue_rests - *p.rest_near) : infinite;
    });
    rest = rest.subspan(static_cast<std::size_t>(unlike - rest.begin()));
  }
}

void order(const SearchRequest& request, std::span<Shot> shots) {
  std::stable_sort(shots.begin(), shots.end(), [&](const Shot& a, const Shot& b) {
    if (a.path.scratch != b.path.scratch) return b.path.scratch;
    const bool keeps = request.problem->keeps_cushions(a);
    if (keeps != request.problem->keeps_cushions(b)) return keeps;
    const bool first = last_choice(request, b), second = last_choice(request, a);
    if (first != second) return first;
    const double x = merit(request.puzzle(), a), y = merit(request.puzzle(), b);
    if (x != y) return x > y;
    if (a.robustness.first_order != b.robustness.first_order)
      return a.robustness.first_order > b.robustness.first_order;
    return a.launch.angle < b.launch.angle;
  });
}

/// Drops shots beside the exact line or point if some shot is on it. Drops jaw shots if some shot does without jaws. If
/// all shots with object balls are wanted, or shots leave the exact line by themselves, this holds for each route by
/// itself.
void keep_centred(const SearchRequest& request, std::vector<Shot>& shots) {
  const auto erase_where_others = [&](const auto& is_worse) {
    std::set<std::pair<Route, Contact>> better;
    const auto key = [&](const Shot& shot) {
      return request.problem->safest() || (request.problem->objects && request.all())
                 ? std::pair(route_of(shot), request.problem->aim_point_of(shot).taken_by)
                 : std::pair<Route, Contact>();
    };
    for (const Shot& shot : shots)
      if (!is_worse(shot)) better.insert(key(shot));
    std::erase_if(shots, [&](const Shot& shot) { return is_worse(shot) && better.contains(key(shot)); });
  };
  erase_where_others([](const Shot& shot) { return shot.verification.off_centre; });
  erase_where_others([](const Shot& shot) { return shot.path.touches_jaws; });
}

/// Returns the distance between two launches, in deviations of the player.
double deviations_apart(const SearchRequest& request, const Launch& a, const Launch& b) {
  const auto count = [](double apart, double noise) { return apart == 0 ? 0 : std::abs(apart) / noise; };
  return std::hypot(
      count(angle_difference(a.angle, b.angle), request.puzzle().noise.angle),
      is_ideal(request.puzzle().physics) ? 0 : count(a.speed - b.speed, request.puzzle().noise.speed_at(a.speed)));
}

/// Returns the success estimate of passing the point on the way, after fewer cushions, which counts too. Cost: one
/// simulation.
double estimate_on_the_way(const SearchRequest& request, EvaluationBudget& budget, const Shot& shot) {
  const std::size_t bounces = shot.path.cushions.size();
  if (request.problem->captures() || request.problem->objects || request.stop || request.route ||
      static_cast<int>(bounces) <= request.cushions().min)
    return 0;
  Discovery path;
  discover(request, budget, shot.launch, false, path);
  double estimate = 0;
  for (const Passage& p : path.passages)
    if (p.meetings < bounces)
      estimate += estimate_of_passing(request, request.problem->aim_points[p.aim_point], shot.launch, p.linear);
  return estimate;
}

/// Returns a bound on the success of a shot, from its success estimate and those of the shots beside it. `request` has
/// the spin of the shot. Cost: one simulation.
double shot_at_most(const SearchRequest& request, EvaluationBudget& budget, std::span<const Shot> shots,
                    const Shot& shot) {
  // A cue ball that misses by the cushions of this shot may touch the second ball after more of them.
  if (request.problem->carom() && !request.route &&
      static_cast<int>(shot.path.cushions.size()) < request.cushions().max)
    return 1;
  double estimate = shot.robustness.success_estimate + estimate_on_the_way(request, budget, shot);
  for (const Shot& other : shots)
    if (&other != &shot && deviations_apart(request, shot.launch, other.launch) < settings::outcome_map::far)
      estimate += other.robustness.success_estimate;
  const AimPoint& aim_point = request.problem->aim_point_of(shot);
  // A ball that a jaw turns away may fall all the same. So may one that a cushion beside the pocket turns away, where
  // another bounce is allowed.
  const int bounces = static_cast<int>(shot.path.cushions.size());
  if (aim_point.captures() &&
      (!request.problem->boundary.jaws.empty() || (!request.route && bounces < request.cushions().max)))
    estimate = std::max(estimate, std::erf(shot.robustness.first_order / std::sqrt(2.0)));
  return success_at_most(request, aim_point, estimate);
}

}  // namespace

double success_at_most(const SearchRequest& request, const AimPoint& aim_point, double estimate) {
  using namespace settings::rank;
  // A ball passes a point twice if its disc reaches over a cushion's line.
  if (!aim_point.captures() && request.problem->boundary_of(aim_point.ball).clearance(aim_point.at) < aim_point.reach)
    return 1;
  return std::min(1.0, times * estimate + more);
}

double merit(const Puzzle& p, const Shot& shot) {
  switch (p.prefer) {
    case Prefer::soft:
      return -shot.launch.speed;
    case Prefer::quick:
      return -shot.path.arrival.time;
    case Prefer::robust:
      break;
  }
  return shot.robustness.value.value_or(shot.robustness.first_order);
}

void rank(const SearchRequest& request, std::vector<Shot>& shots) {
  keep_centred(request, shots);
  // Beside a launch that scratches there may be one that does not.
  const bool moves = request.valued && request.puzzle().prefer == Prefer::robust && request.problem->safest();
  const auto last = [&](const Shot& shot) { return (shot.path.scratch && !moves) || last_choice(request, shot); };
  if (!request.all() && !std::ranges::all_of(shots, last)) std::erase_if(shots, last);
  order(request, shots);
}

void order_by_value(std::span<Shot> shots) { std::ranges::stable_sort(shots, std::greater(), worth_of); }

namespace {

/// Returns the number of the shot with the largest value, if that exceeds `value`. Computes the values of shots that
/// may have it. A shot that scratches counts where there is no other.
std::optional<std::size_t> best_above(const SearchRequest& request, EvaluationBudget& budget, std::span<Shot> shots,
                                      double value) {
  struct Candidate {
    double at_most;  ///< largest value that first order leaves possible
    std::size_t shot;
  };
  const bool others = value > -infinite || !std::ranges::all_of(shots, [](const Shot& s) { return s.path.scratch; });
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < shots.size(); ++i) {
    const Shot& shot = shots[i];
    if ((shot.path.scratch && others) || !request.problem->keeps_cushions(shot)) continue;
    const double success =
        as_struck(request, shot, [&](const SearchRequest& own) { return shot_at_most(own, budget, shots, shot); });
    candidates.push_back({success - cost_of(shot), i});
  }
  // The shots are in the order of their margins, which decides between equals.
  std::ranges::stable_sort(candidates, std::greater(), &Candidate::at_most);
  std::optional<std::size_t> best;
  const double tie = request.puzzle().rest_near ? settings::rank::as_likely : 0;
  for (const Candidate& c : candidates) {
    if (c.at_most <= value - tie) break;
    Shot& shot = shots[c.shot];  // the value of some is known since their stage
    if (!shot.robustness.value)
      as_struck(request, shot, [&](const SearchRequest& own) { find_success(own, budget, shot); });
    if (*shot.robustness.value > value) value = *shot.robustness.value, best = c.shot;
  }
  return best;
}

}  // namespace

void best_first(const SearchRequest& request, EvaluationBudget& budget, std::vector<Shot>& shots) {
  const auto best = best_above(request, budget, shots, -infinite);
  std::swap(shots.front(), shots[best.value_or(0)]);
  // The shots behind it are tuned as well, or leave the cue ball better.
  if (request.problem->carom() || request.puzzle().rest_near) order_by_value(shots);
}

namespace {

/// Returns the value of a shot to first order, moved to where that is largest.
double likely_value(const SearchRequest& request, const Shot& shot, Work& work) {
  if (shot.path.scratch && !request.problem->safest()) return 0;
  const double estimate = request.problem->safest()
                              ? std::max(shot.robustness.success_estimate, estimate_in_middle(request, shot, work))
                              : shot.robustness.success_estimate;
  return estimate - cost_of(shot);
}

/// Returns a bound on the value of a shot once it is moved. `shots`: those that were found. `request` has the spin of
/// the shot.
double movable_to(const SearchRequest& request, EvaluationBudget& budget, std::span<const Shot> shots, const Shot& shot,
                  double likely) {
  const double contacts = cost_of(shot) - cost_of(shot.launch, shot.spin);
  const double most = success_at_most(request, request.problem->aim_point_of(shot), likely + cost_of(shot));
  return std::min(1.0, std::max(most, shot_at_most(request, budget, shots, shot))) - contacts;
}

auto moved_from(SearchResult& found, const Shot& shot) {
  return std::ranges::find_if(found.moved, [&](const SearchResult::Moved& m) {
    return m.from.angle == shot.launch.angle && m.from.speed == shot.launch.speed && m.spin == shot.spin;
  });
}

/// Returns the worth of a shot that was moved, and less than any if it was not.
double moved_worth(SearchResult& found, const Shot& shot) {
  const auto known = moved_from(found, shot);
  return known == found.moved.end() || !known->shot ? -infinite : worth_of(*known->shot);
}

/// Moves shots that may be worth more than all others, at most `most` of them, the most promising first. Returns the
/// worth of the best that was moved.
double move_some(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, std::size_t most) {
  struct Candidate {
    double likely, at_most;
    const Shot* shot;
  };
  std::vector<Candidate> candidates;
  double value = -1;
  for (const Shot& shot : found.shots) {
    value = std::max(value, moved_worth(found, shot));
    if (moved_from(found, shot) != found.moved.end()) continue;
    candidates.push_back(as_struck(request, shot, [&](const SearchRequest& own) {
      const double likely = likely_value(own, shot, budget.work());
      return Candidate{likely, movable_to(own, budget, found.shots, shot, likely), &shot};
    }));
  }
  std::ranges::stable_sort(candidates, std::greater(), &Candidate::likely);
  for (const Candidate& c : candidates) {
    if (c.at_most <= value) continue;
    if (most-- == 0) break;
    Shot shot = *c.shot;
    const bool hope =
        as_struck(request, shot, [&](const SearchRequest& own) { return make_safest(own, budget, shot, value); });
    found.moved.push_back({c.shot->launch, c.shot->spin, {}});
    if (!hope || !request.problem->keeps_cushions(shot)) continue;
    value = std::max(value, worth_of(shot));
    found.moved.back().shot = std::move(shot);
  }
  return value;
}

}  // namespace

double value_in_hand(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found) {
  if (request.puzzle().prefer != Prefer::robust || found.shots.empty()) return 0;
  EvaluationBudget aside(std::numeric_limits<long>::max(), budget);  // what shots are worth is no part of the search
  if (request.valued && request.problem->safest() && !request.all())
    return std::max(0.0, move_some(request, aside, found, 1));
  Shot* best = &found.shots.front();
  double most = -infinite;
  for (Shot& shot : found.shots) {
    const double likely =
        as_struck(request, shot, [&](const SearchRequest& own) { return likely_value(own, shot, aside.work()); });
    if (likely > most) most = likely, best = &shot;
  }
  if (!request.valued) return std::max(0.0, most);
  if (!best->robustness.value)
    as_struck(request, *best, [&](const SearchRequest& own) { find_success(own, aside, *best); });
  double value = 0;
  for (const Shot& shot : found.shots) value = std::max(value, worth_of(shot));
  return value;
}

void move_best(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found) {
  const auto move = [&](Shot& shot) {
    as_struck(request, shot, [&](const SearchRequest& own) { return make_safest(own, budget, shot); });
  };
  if (request.all()) return std::ranges::for_each(found.shots, move), void();
  if (request.puzzle().prefer != Prefer::robust) return move(found.shots.front());
  move_some(request, budget, found, found.shots.size());
  Shot* best = &*std::ranges::max_element(found.shots, {}, [&](const Shot& s) { return moved_worth(found, s); });
  // The map is an estimate, so an exact launch may be worth more.
  if (const auto exact = best_above(request, budget, found.shots, moved_worth(found, *best)))
    best = &found.shots[*exact];
  else if (moved_worth(found, *best) > -infinite)
    *best = *moved_from(found, *best)->shot;
  std::swap(*best, found.shots.front());
}

void add_robustness(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found) {
  std::vector<Shot>& shots = found.shots;
  if (request.puzzle().rest_near && !request.all()) order_by_leave(request.puzzle(), shots);
  for (Shot& shot : std::span(shots).first(request.all() ? shots.size() : 1)) {
    as_struck(request, shot, [&](const SearchRequest& own) {
      if (!shot.robustness.success) find_success(own, budget, shot);
      find_margin(own, budget, shot);
    });
  }
  if (request.all()) order(request, shots);
  if (request.all() && request.puzzle().rest_near) order_by_leave(request.puzzle(), shots);
}

bool comes_before(const Puzzle& p, const Shot& a, const Shot& b) {
  if (a.path.scratch != b.path.scratch) return b.path.scratch;
  return merit(p, a) > merit(p, b);
}

}  // namespace bankshot::planning
