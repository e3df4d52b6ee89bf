// SPDX-License-Identifier: MIT
//
// Planner `auto`: the cheapest sure step first. Images are exact where paths unfold. The planner `sweep` adds what they
// cannot see (reflex vertices, dead cushions). Levenberg–Marquardt and then a global search are for what is left. They
// do not run where the images were complete. With spin images are only seeds: the other proposers follow.
#include <algorithm>
#include <functional>
#include <span>
#include <type_traits>
#include <vector>

#include "bankshot/geometry/aim_point.hpp"
#include "planners/evaluate/connected.hpp"
#include "planners/evaluate/rank.hpp"
#include "planners/methods/methods.hpp"
#include "planners/methods/nlopt.hpp"
#include "planners/play/leave.hpp"
#include "planners/solve/branch_search.hpp"
#include "planners/solve/settings.hpp"
#include "planners/stop.hpp"

namespace bankshot::planning::methods {
namespace {

using namespace settings::automatic;

/// Returns whether images are enough. A route by straight cushions unfolds to one line, so its image is its only shot.
bool settled(const SearchRequest& request, const EvaluationBudget& budget, const SearchResult& found) {
  if (found.complete || budget.cut() || stop::satisfied(request, found)) return true;
  const auto straight = [&](const Meeting& m) { return request.problem->boundary.line(m.with) != nullptr; };
  return request.route && !found.shots.empty() && std::ranges::all_of(*request.route, straight);
}

/// Returns the best shot so far, as far as can be told before its success is known.
const Shot& best_of(const SearchRequest& request, const SearchResult& found) {
  const auto promise = [&](const Shot& s) {
    return request.puzzle().prefer == Prefer::robust ? s.robustness.success_estimate : merit(request.puzzle(), s);
  };
  return *std::ranges::max_element(found.shots, {}, promise);
}

/// Returns whether an improvement pass is wanted. Images find most of the best shots; wide cells look for a better one.
bool improvement_wanted(const SearchRequest& request, const EvaluationBudget& budget, const SearchResult& found) {
  if (request.first() || request.all() || request.route || found.shots.empty() || budget.cut()) return false;
  const auto sure = [](const Shot& s) { return s.robustness.success_estimate > settings::sure; };
  return request.puzzle().prefer != Prefer::robust || std::ranges::none_of(found.shots, sure);
}

void improvement_pass(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found) {
  if (!improvement_wanted(request, budget, found)) return;
  found.improvement_sought = true;
  propose::partition(request.better_than(best_of(request, found)), budget, found, improvement);
}

/// Searches for shots that arrive at one speed, or that have one launch speed.
void look(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found) {
  const auto nothing_yet = [&] { return stop::nothing_yet(budget, found); };
  propose::stretched_images(request, budget, found);
  if (budget.cut()) return;
  improvement_pass(request, budget, found);
  if (request.all() || nothing_yet()) propose::partition(request, budget, found, propose::usual_spacing(request));
  if (stop::more_wanted(request, budget, found)) propose::along(request, budget, found);
  propose::partial_targets(request, budget, found);
}

void with_spin(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found) {
  look(request, budget, found);
  if (stop::nothing_yet(budget, found)) propose::jaw_shots(request, budget, found);
  if (budget.cut()) return;
  if (stop::nothing_yet(budget, found)) propose::partition(request, budget, found, fine);
  propose::partial_targets(request, budget, found);
  if (stop::nothing_yet(budget, found)) search_box(request, budget, found, word::global);
}

/// Returns the samples at which seeds are laid. One arrival speed does for a carom, whose launches have all speeds.
std::vector<SearchRequest> seed_samples_of(const SearchRequest& request) {
  std::vector<SearchRequest> out = request.samples();
  if (request.problem->carom())
    std::erase_if(out, [&](const SearchRequest& sample) { return sample.asked != request.asked; });
  return out;
}

/// The proposer that leads to roots of most routes.
using Seeds = std::function<std::remove_pointer_t<propose::Proposer>>;
Seeds seeds_of(const SearchRequest& request) {
  if (!request.problem->objects) return propose::stretched_images;
  if (request.problem->carom()) return propose::caroms;
  return [known = propose::KnownLegs{}](const SearchRequest& one, EvaluationBudget& budget,
                                        SearchResult& found) mutable { propose::chains(one, budget, found, known); };
}

/// Goes from simple to complex: `look` at shots by ever more cushions of the cue ball and of the last object ball
/// together. Each stage may spend half of the budget that is left, so that hard ones leave something to those after
/// them. If the best shot is wanted, the search ends when no shot by so many cushions can be better.
template <class Look>
void each_stage(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, const Look& look) {
  if (request.problem->carom()) return look(request);  // all cushions are followed at once
  const bool sent = request.problem->then() != nullptr;
  const CushionRule &cue = request.cue_cushions, object = sent ? request.object_cushions : CushionRule::exactly(0);
  const bool best = request.puzzle().prefer == Prefer::robust && !request.all() && !request.first();
  for (int n = cue.min + object.min; n <= cue.max + object.max; ++n) {
    constexpr double per_contact = 0.005;
    const double at_most = 1 - per_contact * n - cost_of({request.speed.low, 0}, {});
    const double value = best ? value_in_hand(request, budget, found) : 0;
    if (best && at_most < value + settings::worth_a_search) return;
    for (int c = std::max(cue.min, n - object.max); c <= std::min(cue.max, n - object.min); ++c) {
      SearchRequest stage = request.stage(c, n - c);
      if (best && sent) stage.likelier = value + per_contact * n;
      {
        const EvaluationBudget::Part part(budget, n < cue.max + object.max ? 2 : 1);
        look(stage);
        if (budget.spent() && found.not_searched < 0) found.not_searched = n;
      }
      if (stop::over(request, budget, found)) return;
    }
  }
}

/// Adds a start; returns how many have its route and aim point, with this one.
std::ptrdiff_t times_started(std::vector<Candidate>& starts, const Candidate& candidate) {
  starts.push_back(candidate);
  return std::ranges::count_if(starts, [&](const Candidate& known) {
    return known.aim_point == candidate.aim_point && known.route == candidate.route;
  });
}

/// Climbs the branches of a stage where more than one quantity is free, from all roots of the samples, the highest
/// first.
void climb_branches(const SearchRequest& request, const SearchRequest& stage, EvaluationBudget& budget,
                    SearchResult& found, std::vector<Candidate>& climbed) {
  struct Foot {
    Candidate start;
    branch::BranchSearch::Tried at;
  };
  std::vector<Foot> feet;
  {
    const EvaluationBudget::Part half(budget, 2);  // the other one is for the climbs
    for (const SearchRequest& sample : seed_samples_of(stage)) {
      const Seeds seeds = seeds_of(stage);
      SearchResult starts;
      seeds(sample, budget, starts);
      for (Candidate& start : starts.candidates) {
        branch::BranchSearch search(request, budget, found, start);
        auto at = search.foot();
        if (!at) continue;
        if (request.first() && at->made()) return search.climb_from(*at);
        feet.push_back({std::move(start), std::move(*at)});
      }
    }
  }
  std::ranges::stable_sort(feet, [](const Foot& a, const Foot& b) { return a.at.above(b.at); });
  for (const Foot& foot : feet)
    if (!stop::over(request, budget, found) && times_started(climbed, foot.start) <= settings::branch::most_starts)
      branch::BranchSearch(request, budget, found, foot.start).climb_from(foot.at);
}

/// Searches branches from roots of a few arrival speeds and spins, along each route to each aim point.
void along_branches(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found) {
  std::vector<Candidate> followed;
  const bool surfaces = branch::BranchSearch::freedom(request) > 1;
  // Roots of a carom by one route lie on several curves.
  const int most = surfaces || request.problem->carom() ? settings::branch::most_starts : 1;
  const auto follow = [&](std::span<const Candidate> candidates) {
    for (const Candidate& candidate : candidates) {
      if (stop::over(request, budget, found) || times_started(followed, candidate) > most) continue;
      branch::BranchSearch branch(request, budget, found, candidate);
      if (!surfaces)
        branch.search();
      else if (const auto foot = branch.foot())
        branch.climb_from(*foot);
    }
  };
  each_stage(request, budget, found, [&](const SearchRequest& stage) {
    if (surfaces) return climb_branches(request, stage, budget, found, followed);
    Seeds seeds = seeds_of(stage);
    SearchResult starts;
    for (const SearchRequest& sample : seed_samples_of(stage)) {
      if (request.problem->carom()) starts = {}, seeds = seeds_of(stage);
      const std::size_t known = starts.candidates.size();  // their routes have no second curve
      seeds(sample, budget, starts);
      follow(std::span(starts.candidates).subspan(known));
    }
  });
  if (request.problem->carom()) {
    std::ranges::stable_sort(found.shots, std::greater(),
                             [&](const Shot& shot) { return merit(request.puzzle(), shot); });
    keep_connected_once(request, budget, found.shots);
  }
  if (request.problem->objects) return;
  const std::vector<SearchRequest> samples = request.samples();
  for (const SearchRequest& sample : samples) {
    const bool better = improvement_wanted(request, budget, found) && &sample == &samples.front();
    if (!request.all() && !better) break;
    found.improvement_sought = better;
    SearchResult roots;
    propose::partition(sample, budget, roots, request.all() ? propose::usual_spacing(request) : improvement);
    follow(roots.candidates);
  }
}

/// Searches for shots where arrival speeds or spins are free. If images lead to none, the steps run at each of a few
/// speeds and spins. They also run at the bounds of the launch speed, where balls arrive as they may.
void with_freedom(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found) {
  along_branches(request, budget, found);
  const auto nothing_yet = [&] { return stop::nothing_yet(budget, found); };
  if (!nothing_yet()) return;
  const auto look_at = [&](const SearchRequest& one) {
    if (nothing_yet()) look(one, budget, found);
  };
  const std::vector<SearchRequest> samples = request.samples();
  for (const SearchRequest& sample : samples) {
    look_at(request.spinning(sample.spin).asking(sample.asked));
    if (!request.arrival || request.arrival->fixed() || sample.asked != request.asked) continue;
    for (const double speed : {request.speed.high, request.speed.low})
      if (speed > 0) look_at(request.spinning(sample.spin).launched_at(speed));
  }
  for (const SearchRequest& sample : samples)
    if (nothing_yet()) propose::jaw_shots(request.spinning(sample.spin), budget, found);
}

/// Uses shots held in reserve where none was found.
void keep_spare(SearchResult& found, std::vector<Shot> spare) {
  if (found.shots.empty()) found.shots = std::move(spare);
}

/// Searches for shots in which the cue ball sets another ball going, or goes on off it. If nothing is found, it looks
/// first beside what is blocked. Then it follows every route from ball to ball.
void with_balls(const SearchRequest& asked, EvaluationBudget& budget, SearchResult& found) {
  SearchRequest request = asked;
  // A pot counts however the ball falls. One by a cushion leads to those that brush a rail or a jaw, and is moved to a
  // launch that uses none.
  const Then* const then = asked.problem->then();
  if (asked.problem->safest() && !asked.first() && then && then->counts_any_fall() && then->links.empty())
    request.object_cushions.max = 1;
  const bool free = !is_ideal(request.puzzle().physics) && branch::BranchSearch::freedom(request) > 0;
  if (free)
    along_branches(request, budget, found);
  else
    each_stage(request, budget, found,
               [&, seeds = seeds_of(request)](const SearchRequest& stage) { seeds(stage, budget, found); });
  propose::partial_targets(request, budget, found);
  // Shots that cannot be moved to use no cushion only tell which relaxation would allow them.
  std::vector<Shot> spare;
  if (request.object_cushions.max > asked.object_cushions.max && !(value_in_hand(request, budget, found) > 0))
    spare = std::exchange(found.shots, {});
  if (!stop::nothing_yet(budget, found)) return keep_spare(found, std::move(spare));
  each_stage(asked, budget, found, [&](const SearchRequest& stage) {
    if (!free) return propose::contact_windows(stage, budget, found);
    for (const SearchRequest& sample : stage.samples())
      if (stop::nothing_yet(budget, found))
        propose::contact_windows(stage.spinning(sample.spin).asking(sample.asked), budget, found);
  });
  keep_spare(found, std::move(spare));
}

}  // namespace

void automatic(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found) {
  if (request.puzzle().leave) return play::leave(request, budget, found, seeds_of(request));
  if (request.problem->objects) return with_balls(request, budget, found);
  if (!is_straight(request.puzzle().physics))
    return branch::BranchSearch::freedom(request) > 0 ? with_freedom(request, budget, found)
                                                      : with_spin(request, budget, found);
  image(request, budget, found);
  if (!settled(request, budget, found)) sweep(request, budget, found);
  if (stop::nothing_yet(budget, found)) propose::jaw_shots(request, budget, found);
  if (stop::nothing_yet(budget, found) && !found.complete) ceres(request, budget, found);
  if (stop::nothing_yet(budget, found) && !found.complete) search_box(request, budget, found, word::global);
}

}  // namespace bankshot::planning::methods
