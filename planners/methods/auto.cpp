// SPDX-License-Identifier: MIT
//
// Planner `auto`: the cheapest sure step first. Images are exact where paths unfold; a sweep of the
// aim adds what they cannot see (reflex vertices, dead cushions); Levenberg–Marquardt and then a
// global search are for what is left, and are not run when the images proved that nothing is.
// With spin images are only seeds: the steps of planners/steps follow, in the order of their numbers.
#include <algorithm>
#include <functional>
#include <iterator>
#include <span>
#include <type_traits>
#include <vector>

#include "planners/family/family.hpp"
#include "planners/family/settings.hpp"
#include "planners/merit/connected.hpp"
#include "planners/merit/rank.hpp"
#include "planners/methods/methods.hpp"
#include "planners/methods/nlopt.hpp"
#include "planners/stop.hpp"

namespace bankshot::planning::methods {
namespace {

using namespace settings::automatic;

/// A route by straight cushions unfolds to one line, so its image is its only shot.
bool settled(const Question& q, const EvaluationBudget& budget, const SearchResult& found) {
  if (found.complete || budget.cut() || stop::satisfied(q, found)) return true;
  const auto straight = [&](const Meeting& m) { return q.boundary.line(m.with) != nullptr; };
  return q.route && !found.shots.empty() && std::ranges::all_of(*q.route, straight);
}

/// The best shot so far, as far as can be told before its success is known.
const Shot& best_of(const Question& q, const SearchResult& found) {
  const auto merit = [&](const Shot& s) {
    return q.puzzle.prefer == Prefer::robust ? s.success_estimate : first_merit(q.puzzle, s);
  };
  return *std::ranges::max_element(found.shots, {}, merit);
}

/// Where one shot is wanted, the best: images see nine in ten; a map of wide cells looks for a better one.
bool improvement_wanted(const Question& q, const EvaluationBudget& budget, const SearchResult& found) {
  if (q.first() || q.all() || q.route || found.shots.empty() || budget.cut()) return false;
  const auto sure = [](const Shot& s) { return s.success_estimate > sure_enough; };
  return q.puzzle.prefer != Prefer::robust || std::ranges::none_of(found.shots, sure);
}

void improvement_pass(const Question& q, EvaluationBudget& budget, SearchResult& found) {
  if (!improvement_wanted(q, budget, found)) return;
  found.improvement_sought = true;
  steps::map(q.better_than(best_of(q, found)), budget, found, improvement);
}

/// One arrival speed aimed for, or one launch speed.
void look(const Question& q, EvaluationBudget& budget, SearchResult& found, steps::Parts& parts) {
  const auto nothing_yet = [&] { return stop::nothing_yet(budget, found); };
  steps::images(q, budget, found);
  if (budget.cut()) return;
  // What blocks a pocket's exact line is often there, or a ball; else parts of points come last.
  const bool obstacles = q.has_obstacles();
  if (q.route && nothing_yet()) {
    steps::fan(q, budget, found);
    if (obstacles) parts.climb(q, budget, found);
  }
  improvement_pass(q, budget, found);
  if (q.all() || nothing_yet()) steps::map(q, budget, found, steps::usual_spacing(q));
  if (stop::more_wanted(q, budget, found)) steps::along(q, budget, found);
  if (obstacles) {
    parts.climb(q, budget, found);
    parts.bisect(q, budget, found, first_share_of_parts);
  }
}

/// What costs ten times as much, where nothing was found.
void look_closely(const Question& q, EvaluationBudget& budget, SearchResult& found, steps::Parts& parts) {
  const auto nothing_yet = [&] { return stop::nothing_yet(budget, found); };
  if (nothing_yet()) steps::map(q, budget, found, fine);
  if (q.route && nothing_yet()) steps::map(q, budget, found, as_it_occurs);
  parts.climb(q, budget, found);
}

void with_spin(const Question& q, EvaluationBudget& budget, SearchResult& found) {
  steps::Parts parts;
  look(q, budget, found, parts);
  if (stop::nothing_yet(budget, found)) steps::jaw_shots(q, budget, found);
  if (budget.cut()) return;
  look_closely(q, budget, found, parts);
  if (q.has_obstacles() && stop::nothing_yet(budget, found)) {
    steps::map(q, budget, found, finest);
    parts.climb(q, budget, found);
  }
  parts.bisect(q, budget, found, 1);
  if (stop::nothing_yet(budget, found)) search_box(q, budget, found, steps::word::global);
}

/// The arrival speeds and spins at which families are looked for: the ends that are preferred first.
std::vector<Question> samples_of(const Question& q) {
  std::vector<double> arrivals{q.asked};
  if (q.arrival && !q.arrival->fixed()) {
    arrivals.push_back((q.arrival->low + q.arrival->high) / 2);
    arrivals.push_back(q.arrival->low + q.arrival->high - q.asked);
  }
  // Corners first: a ball without side spin has no derivative by it, since its spin is gone at once.
  std::vector<LaunchSpin> spins;
  const auto add = [&](const LaunchSpin& spin) {
    if (std::ranges::find(spins, spin) == spins.end()) spins.push_back(spin);
  };
  if (const auto& r = q.puzzle.spin_range)
    for (const double top : {r->top.high, r->top.low})
      for (const double side : {r->side.low, r->side.high})
        for (const double masse : {r->masse.low, r->masse.high}) add({top, side, masse});
  add(q.spin);
  std::vector<Question> out;
  for (const double asked : arrivals)
    for (const LaunchSpin& spin : spins) out.push_back(q.starts_at(asked, spin));
  return out;
}

/// What leads to roots of most routes, and what is left where that finds nothing.
struct Seeds {
  std::function<std::remove_pointer_t<steps::Step>> first;
  void (*closely)(const Question&, EvaluationBudget&, SearchResult&, steps::Parts&);
  std::string_view word;
};
Seeds seeds_of(const Question& q) {
  if (!q.objects) return {steps::images, nullptr, steps::word::images};
  if (q.carom()) return {steps::caroms, steps::caroms_closely, steps::word::caroms};
  const auto chains = [known = steps::KnownLegs{}](const Question& one, EvaluationBudget& budget,
                                                   SearchResult& found) mutable {
    steps::chains_again(one, budget, found, known);
  };
  return {chains, steps::chains_closely, steps::word::chains};
}

/// From simple to complex: `look` at shots by ever more cushions of the cue ball and of the last object ball together.
/// Where the best shot is wanted a stage ends the search when no shot by so many cushions can be better.
template <class Look>
void each_stage(const Question& q, EvaluationBudget& budget, SearchResult& found, const Look& look) {
  if (q.carom()) return look(q);  // all cushions are followed at once
  const bool sent = q.then() != nullptr;
  const CushionRule &cue = q.cue_cushions, object = sent ? q.object_cushions : CushionRule::exactly(0);
  const bool best = q.puzzle.prefer == Prefer::robust && !q.all() && !q.first();
  for (int n = cue.min + object.min; n <= cue.max + object.max; ++n) {
    constexpr double per_contact = 0.005;
    const double at_most = 1 - per_contact * n - cost_of({q.speed.low, 0}, {});
    const double value = best ? value_in_hand(q, found) : 0;
    if (best && at_most < value + worth_a_stage) return;
    for (int c = std::max(cue.min, n - object.max); c <= std::min(cue.max, n - object.min); ++c) {
      Question stage = q.stage(c, n - c);
      if (best && sent) stage.likelier = value + per_contact * n;
      look(stage);
      if (budget.spent()) found.not_searched = n;
      if (stop::over(q, budget, found)) return;
    }
  }
}

/// What is free is followed from roots of a few arrival speeds and spins, along each route to each aim point.
void along_families(const Question& q, EvaluationBudget& budget, SearchResult& found) {
  struct Followed {
    Route route;
    AimPoint aim_point;
    int times;
  };
  std::vector<Followed> followed;
  // Roots of a carom by one route are of several families.
  const bool several = family::Family::freedom(q) > 1 || q.carom();
  const int most = several ? settings::family::most_starts : 1;
  const auto enough = [&](const Candidate& candidate) {
    const auto same = [&](const Followed& f) {
      return f.aim_point == candidate.aim_point && f.route == candidate.route;
    };
    auto it = std::ranges::find_if(followed, same);
    if (it == followed.end()) it = followed.insert(it, {candidate.route, candidate.aim_point, 0});
    return ++it->times > most;
  };
  const auto follow = [&](std::span<const Candidate> candidates, std::string_view step) {
    for (const Candidate& candidate : candidates)
      if (!stop::over(q, budget, found) && !enough(candidate))
        family::Family(q, budget, found, candidate, step).search();
  };
  each_stage(q, budget, found, [&](const Question& stage) {
    Seeds seeds = seeds_of(stage);
    const std::vector<Question> samples = samples_of(stage);
    SearchResult starts;
    for (const Question& sample : samples) {
      if (q.carom() && sample.asked != samples.front().asked) continue;  // its launches have all speeds
      if (several) starts = {}, seeds = seeds_of(stage);
      const std::size_t known = starts.candidates.size();  // whose routes have no second family
      seeds.first(sample, budget, starts);
      follow(std::span(starts.candidates).subspan(known), seeds.word);
    }
  });
  if (q.carom()) {
    std::ranges::stable_sort(found.shots, std::greater(),
                             [&](const Shot& shot) { return first_merit(q.puzzle, shot); });
    keep_connected_once(q, budget, found.shots);
  }
  if (q.objects) return;
  const std::vector<Question> samples = samples_of(q);
  for (const Question& sample : samples) {
    const bool better = improvement_wanted(q, budget, found) && &sample == &samples.front();
    if (!q.all() && !better) break;
    found.improvement_sought = better;
    SearchResult roots;
    steps::map(sample, budget, roots, q.all() ? steps::usual_spacing(q) : improvement);
    follow(roots.candidates, steps::word::map);
  }
}

/// From shots of one arrival speed and spin to the best ones of their families.
void improve(const Question& q, EvaluationBudget& budget, SearchResult& found) {
  const std::vector<Shot> shots = found.shots;
  for (const Shot& shot : shots) {
    const Candidate candidate = family::candidate_of(q, shot);
    if (!budget.spent()) family::Family(q, budget, found, candidate, shot.planner).search();
  }
}

/// Arrival speeds or spins are free. Where images lead to no shot: the steps at each of a few speeds and spins, and of
/// launches at the bounds of their own speed, which arrive as they may; fine maps at the first of them alone.
void with_freedom(const Question& q, EvaluationBudget& budget, SearchResult& found) {
  along_families(q, budget, found);
  const auto nothing_yet = [&] { return stop::nothing_yet(budget, found); };
  if (!nothing_yet()) return;
  const auto look_at = [&](const Question& one) {
    steps::Parts parts;
    if (nothing_yet()) look(one, budget, found, parts);
  };
  const std::vector<Question> samples = samples_of(q);
  for (const Question& sample : samples) {
    look_at(q.spinning(sample.spin).asking(sample.asked));
    if (!q.arrival || q.arrival->fixed() || sample.asked != q.asked) continue;
    for (const double speed : {q.speed.high, q.speed.low})
      if (speed > 0) look_at(q.spinning(sample.spin).launched_at(speed));
  }
  for (const Question& sample : samples)
    if (nothing_yet()) steps::jaw_shots(q.spinning(sample.spin), budget, found);
  steps::Parts parts;
  if (nothing_yet()) look_closely(q.spinning(samples.front().spin), budget, found, parts);
  parts.bisect(q.spinning(samples.front().spin), budget, found, 1);
  if (!q.first()) improve(q, budget, found);
}

/// Some shot has as many cushions as this stage.
bool has_shot(const Question& stage, const SearchResult& found) {
  const auto inside = [](std::size_t n, const CushionRule& rule) {
    return static_cast<int>(n) >= rule.min && static_cast<int>(n) <= rule.max;
  };
  return std::ranges::any_of(found.shots, [&](const Shot& shot) {
    return inside(shot.cushions.size(), stage.cue_cushions) &&
           (shot.then.empty() || inside(shot.then.back().cushions.size(), stage.object_cushions));
  });
}

/// The cue ball sends another on, or goes on off it. A stage without any shot is looked at closely, unless what is
/// found so hardly ever beats the shot in hand.
void with_balls(const Question& q, EvaluationBudget& budget, SearchResult& found) {
  const bool free = !is_ideal(q.puzzle.physics) && family::Family::freedom(q) > 0;
  const Seeds seeds = seeds_of(q);
  free ? along_families(q, budget, found)
       : each_stage(q, budget, found, [&](const Question& stage) { seeds.first(stage, budget, found); });
  if (!q.all() && value_in_hand(q, found) > best_found_closely) return;
  const auto each_sample = [&](const auto& look_at) {
    each_stage(q, budget, found, [&](const Question& stage) {
      const auto nothing_yet = [&] { return !has_shot(stage, found) && !budget.cut(); };
      if (!free && (q.all() || nothing_yet())) return look_at(stage);
      for (const Question& sample : samples_of(stage))
        if (free && nothing_yet()) look_at(stage.spinning(sample.spin).asking(sample.asked));
    });
  };
  each_sample([&](const Question& one) {
    steps::Parts parts;
    std::vector<Shot> others;  // steps end at the first shot that they find
    std::swap(others, found.shots);
    parts.climb(one, budget, found);
    if (stop::more_wanted(one, budget, found)) seeds.closely(one, budget, found, parts);
    parts.bisect(one, budget, found, free ? first_share_of_parts : 1);
    std::ranges::move(others, std::back_inserter(found.shots));
  });
  if (stop::nothing_yet(budget, found))
    each_sample([&](const Question& one) { steps::speeds_between(one, budget, found); });
  if (free && !q.first()) improve(q, budget, found);
}

}  // namespace

void automatic(const Question& q, EvaluationBudget& budget, SearchResult& found) {
  if (q.objects) return with_balls(q, budget, found);
  if (!is_straight(q.puzzle.physics))
    return family::Family::freedom(q) > 0 ? with_freedom(q, budget, found) : with_spin(q, budget, found);
  image(q, budget, found);
  if (!settled(q, budget, found)) sweep(q, budget, found);
  if (stop::nothing_yet(budget, found)) steps::jaw_shots(q, budget, found);
  if (stop::nothing_yet(budget, found) && !found.complete) ceres(q, budget, found);
  if (stop::nothing_yet(budget, found) && !found.complete) search_box(q, budget, found, steps::word::global);
}

}  // namespace bankshot::planning::methods
