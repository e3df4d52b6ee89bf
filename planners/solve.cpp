// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <limits>
#include <vector>

#include "bankshot/plan/planner.hpp"
#include "planners/evaluate/connected.hpp"
#include "planners/evaluate/rank.hpp"
#include "planners/evaluate/sensitivity.hpp"
#include "planners/message.hpp"
#include "planners/methods/methods.hpp"
#include "planners/play/game.hpp"
#include "planners/play/in_hand.hpp"
#include "planners/play/leave_success.hpp"
#include "planners/propose/proposers.hpp"
#include "planners/settings.hpp"
#include "planners/solve/branch_search.hpp"
#include "planners/verify/certify.hpp"
#include "planners/what_would_open.hpp"

namespace bankshot {
namespace {

using planning::EvaluationBudget;
using planning::SearchRequest;
using planning::SearchResult;
using planning::Wanted;

std::vector<std::string> modelled(const Puzzle& p, const std::vector<Shot>& shots) {
  std::vector<std::string> out{is_ideal(p.physics) ? "ideal" : "rolling"};
  if (carries_spin(p.physics)) out.insert(out.begin(), "sliding");
  const CushionModel& cushion = model_of(p.physics.cushion);
  out.push_back(std::string(cushion.key) + (cushion.in_files ? "" : " cushion"));
  if (std::any_of(shots.begin(), shots.end(), [](const Shot& s) { return s.path.cushion_stick; }))
    out.push_back("cushion-stick");
  if (!p.table.pockets.empty()) out.push_back("pockets");
  if (!p.others.empty()) out.push_back("balls");
  if (!is_level(p.physics)) out.push_back("tilt");
  return out;
}

/// Returns one spin, or those of the puzzle's ranges on a grid, least first.
std::vector<LaunchSpin> spins_to_try(const Puzzle& p) {
  if (!p.spin_range) return {p.spin};
  constexpr int steps = planning::settings::steps_of_spin;
  const auto values = [](const Range& r) {
    std::vector<double> out{std::clamp(0.0, r.low, r.high)};
    for (int i = 0; i <= steps && !r.fixed(); ++i) {
      const double v = r.low + (r.high - r.low) * i / steps;
      if (v != out.front()) out.push_back(v);
    }
    return out;
  };
  std::vector<LaunchSpin> spins;
  for (const double top : values(p.spin_range->top))
    for (const double side : values(p.spin_range->side))
      for (const double masse : values(p.spin_range->masse)) spins.push_back({top, side, masse});
  const auto size = [](const LaunchSpin& s) { return s.top * s.top + s.side * s.side + s.masse * s.masse; };
  std::stable_sort(spins.begin(), spins.end(), [&](const auto& a, const auto& b) { return size(a) < size(b); });
  return spins;
}

double microseconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count();
}

/// Chooses among shots and moves them, the best one alone or each of a list, to where their value is largest.
void choose(const SearchRequest& request, EvaluationBudget& aside, SearchResult& found) {
  if (request.puzzle().prefer == Prefer::robust && !request.all()) planning::best_first(request, aside, found.shots);
  planning::branch::tune(request, aside, found);
  if (request.problem->safest()) planning::move_best(request, aside, found);
  std::erase_if(found.shots, [&](const Shot& shot) { return !request.problem->keeps_cushions(shot); });
  if (found.shots.empty())
    found.add_note(R"(a pot that brushes a rail was found, which "cushions": {"max": 1} in "then" would allow)");
}

/// Returns the best of the shots of a list, chosen as if it alone were wanted.
std::optional<Shot> best_of(const SearchRequest& request, EvaluationBudget& aside, const SearchResult& found) {
  SearchRequest alone = request;
  alone.wanted = Wanted::best;
  SearchResult best{.shots = found.shots};
  choose(alone, aside, best);
  return best.shots.empty() ? std::nullopt : std::optional(std::move(best.shots.front()));
}

/// Makes the answer from the result of a search: success, margins and words.
Answer finish(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, const SolveOptions& options,
              double time_us) {
  Answer a{.id = request.puzzle().id, .about = request.puzzle().about};
  a.simulations = budget.simulations();
  a.time_us = time_us;
  a.cost.certify_us = budget.proof_us;
  EvaluationBudget aside(std::numeric_limits<long>::max(),
                         budget);  // rating the shots does not count against the budget
  const bool once = request.all() && !request.puzzle().leave && (request.problem->objects || request.problem->safest());
  const auto begin = std::chrono::steady_clock::now();
  if (request.puzzle().leave) {
    planning::play::rate_leaves(request, aside, options.robustness, found.shots);
  } else if ((options.robustness || request.problem->safest()) && !found.shots.empty()) {
    // The best of a list gets the care of the best alone.
    const std::optional<Shot> best = once ? best_of(request, aside, found) : std::nullopt;
    choose(request, aside, found);
    if (best) found.shots.push_back(*best);
    if (options.robustness && !found.shots.empty()) planning::add_robustness(request, aside, found);
  }
  if (options.measure) a.cost.robustness_us = microseconds_since(begin);
  a.status = !found.shots.empty() ? Status::solved : budget.ever_cut() ? Status::budget : Status::no_shot;
  planning::add_nearest(request, budget, found, options.suggest, a);
  if (once) planning::keep_connected_once(request, aside, found.shots);
  if (!options.robustness)
    for (Shot& shot : found.shots) shot.robustness.success.reset(), shot.robustness.value.reset();
  const std::size_t distinct = found.shots.size();
  if (!request.all() && distinct > 1) found.shots.resize(1);
  if (options.sensitivity)
    for (Shot& shot : found.shots)
      planning::as_struck(request, shot,
                          [&](const SearchRequest& own) { planning::add_sensitivity(own, shot, budget.work()); });
  a.shots = std::move(found.shots);
  a.modelled = modelled(request.puzzle(), a.shots);
  a.message = planning::message(request, budget, found, a, distinct);
  a.cost.work = budget.work();
  return a;
}

/// Returns the puzzle with one spin of its ranges.
Puzzle with_spin(Puzzle p, const LaunchSpin& spin) {
  p.spin = spin;
  p.spin_range.reset();
  return p;
}

Wanted wanted(const SolveOptions& options) {
  return options.all ? Wanted::all : options.first ? Wanted::first : Wanted::best;
}

/// Verifies the launch of a shot of a looser puzzle as asked; keeps the shot and returns true if it is one.
bool keep_as_asked(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, const Shot& shot) {
  return planning::as_struck(request, shot, [&](const SearchRequest& own) {
    const int bounces = bounces_of(planning::route_of(shot));
    const auto proves = [&](planning::Demand demand) {
      return planning::certify(own, budget, found, shot.launch, bounces, planning::word::relaxed, demand);
    };
    return proves(planning::Demand::exact) || proves(planning::Demand::off_centre);
  });
}

/// Returns words on what would open a puzzle without a shot, or none if a looser search finds a shot as asked, which is
/// kept.
std::string hint(const Puzzle& puzzle, const SearchRequest& request, EvaluationBudget& budget, SearchResult& found,
                 const SolveOptions& options) {
  const SolveOptions plain{.robustness = false, .suggest = false, .cancelled = options.cancelled};
  // These searches do not ask where the cue ball stops. A shot that one finds has no leave, and only ends the search.
  Puzzle target = puzzle;
  target.leave.reset();
  SearchResult without_leave;
  SearchResult& kept = puzzle.leave ? without_leave : found;
  long spent = 0;
  const auto looser = [&](const Puzzle& p) {
    Answer a = solve(p, plain);
    spent += a.simulations;
    budget.work() += a.cost.work;
    return a;
  };
  const auto is_asked = [&](const Shot& shot) {
    const bool same_spins = shot.spin == request.spin || puzzle.spin_range;
    return same_spins && keep_as_asked(request, budget, kept, shot);
  };
  std::string words = planning::what_would_open(target, looser, is_asked);
  if (!found.shots.empty()) {
    budget.charge(0, spent);
    found.add_note("a search with looser bounds came upon it");
  }
  return words;
}

/// Solves a carom in both orders, each with half of a budget that is given, and puts the answers together.
Answer solve_both_orders(const Puzzle& puzzle, const SolveOptions& options) {
  const auto& carom = std::get<CaromTarget>(puzzle.target);
  const auto solved = [&](int first, int other) {
    Puzzle one = puzzle;
    one.target = in_order(puzzle.target, first);
    if (puzzle.budget) one.budget = *puzzle.budget / 2;
    Answer a = solve(one, options);
    if (!a.shots.empty()) a.message += fmt::format("; it touches {} first", contact_name(puzzle, Contact::ball(first)));
    if (a.shots.empty())
      a.message = fmt::format("{} and then {}: {}", contact_name(puzzle, Contact::ball(first)),
                              contact_name(puzzle, Contact::ball(other)), a.message);
    return a;
  };
  const int second = carom.second.balls.front();
  Answer a = solved(carom.first, second);
  if (options.first && !a.shots.empty()) return a;
  Answer b = solved(second, carom.first);
  const auto nearer = [](const Answer& x, const Answer& y) {
    return x.nearest && (!y.nearest || x.nearest->shot.verification.miss < y.nearest->shot.verification.miss);
  };
  const bool swap = a.shots.empty()
                        ? !b.shots.empty() || nearer(b, a)
                        : !b.shots.empty() && planning::comes_before(puzzle, b.shots.front(), a.shots.front());
  if (swap) std::swap(a, b);
  if (a.shots.empty()) a.message += "; " + b.message;
  if (b.status == Status::budget && a.status == Status::no_shot) a.status = Status::budget;
  if (options.all) {
    std::ranges::move(b.shots, std::back_inserter(a.shots));
    std::ranges::stable_sort(a.shots,
                             [&](const Shot& x, const Shot& y) { return planning::comes_before(puzzle, x, y); });
    if (!b.shots.empty()) a.message += fmt::format("; in either order {} shots", a.shots.size());
  }
  for (const std::string& m : b.modelled)
    if (std::ranges::find(a.modelled, m) == a.modelled.end()) a.modelled.push_back(m);
  a.add_cost(b);
  return a;
}

}  // namespace

Answer solve(const Puzzle& puzzle, const SolveOptions& options) {
  validate(puzzle);
  if (options.all && options.first) throw InvalidInput("", "either all shots are asked for or the first one found");
  if (is_in_any_order(puzzle.target)) return solve_both_orders(puzzle, options);
  const planning::methods::Method& method = planning::methods::find(options.planner);
  if (!method.info.bends && !is_straight(puzzle.physics))
    throw InvalidInput(
        "", fmt::format("the planner \"{}\" does not do physics with spin or a tilted table, where paths bend",
                        method.info.name));
  if (puzzle.leave && options.planner != "auto")
    throw InvalidInput("", fmt::format("the planner \"{}\" does not plan where the cue ball stops", method.info.name));
  if (goes_on_after_contact(puzzle.target) && options.planner != "auto")
    throw InvalidInput("", fmt::format("the planner \"{}\" sets no other ball going", method.info.name));
  if (puzzle.in_hand) return planning::play::solve_in_hand(puzzle, options);
  if (puzzle.game) return planning::play::solve_game(puzzle, options);
  if (!options.robustness && !puzzle.aim && aim_of(puzzle) == Aim::safest) {
    Puzzle centred = puzzle;
    centred.aim = Aim::centre;
    return solve(centred, options);
  }
  const auto begin = std::chrono::steady_clock::now();
  const std::vector<LaunchSpin> spins = options.planner == "auto" ? std::vector{puzzle.spin} : spins_to_try(puzzle);
  EvaluationBudget budget(budget_of(puzzle), options.cancelled);
  budget.measures = options.measure;
  for (std::size_t i = 0;; ++i) {
    const std::optional<Puzzle> one = spins.size() > 1 ? std::optional(with_spin(puzzle, spins[i])) : std::nullopt;
    SearchRequest request(one ? *one : puzzle, wanted(options));
    request.valued = options.robustness;
    SearchResult found;
    const EvaluationBudget::Part part(budget, spins.size() - i);
    if (request.stop && !rests(request.puzzle().physics))
      found.add_note("no ball comes to rest on a table that leans by more than rolling friction holds");
    else if (!budget.spent() && !request.problem->covering())
      method.plan(request, budget, found);
    if (found.shots.empty() && !budget.exhausted() && i + 1 < spins.size()) continue;
    if (!puzzle.leave) planning::rank(request, found.shots);
    const double took = microseconds_since(begin);
    if (spins.size() > 1)
      found.add_note(fmt::format("{} of {} spins were tried, the least first", i + 1, spins.size()));
    Answer a = finish(request, budget, found, options, took);
    if (a.status != Status::no_shot || !options.suggest) return a;
    const std::string words = hint(puzzle, request, budget, found, options);
    if (!found.shots.empty()) {
      planning::rank(request, found.shots);
      return finish(request, budget, found, options, microseconds_since(begin));
    }
    if (!words.empty()) a.message += "; " + words;
    return a;
  }
}

std::span<const PlannerInfo> planners() {
  static const auto infos = [] {
    std::vector<PlannerInfo> out;
    for (const planning::methods::Method& m : planning::methods::all()) out.push_back(m.info);
    return out;
  }();
  return infos;
}

}  // namespace bankshot
