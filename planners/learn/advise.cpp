// SPDX-License-Identifier: MIT
#include "bankshot/learn/advise.hpp"

#include <algorithm>
#include <limits>

#include "bankshot/plan/planner.hpp"
#include "planners/evaluate/success.hpp"
#include "planners/in_parallel.hpp"
#include "planners/learn/outliers.hpp"
#include "planners/learn/player.hpp"

namespace bankshot {
namespace planning {
namespace {

Noise noise_by(const std::vector<PlayerError>& errors) {
  Noise out;
  for (const PlayerError& e : errors) {
    if (e.name == "angle") out.angle = e.sigma;
    if (e.name == "speed") out.speed = e.sigma;
    if (e.name == "side") out.side = e.sigma;
    if (e.name == "top") out.top = e.sigma;
  }
  return out;
}

/// Returns the success, with these errors, of a shot that was chosen for other errors.
double success_of(Shot shot, const Puzzle& puzzle) {
  EvaluationBudget budget(std::numeric_limits<long>::max());
  find_success(SearchRequest(puzzle), budget, shot);
  return shot.robustness.success.value_or(0);
}

Choice choose(const Puzzle& puzzle, const Noise& noise) {
  Puzzle own = puzzle, usual = puzzle;
  own.noise = noise;
  own.prefer = usual.prefer = Prefer::robust;
  Choice out{.id = puzzle.id};
  const Answer a = solve(own), b = solve(usual);
  if (a.shots.empty() || b.shots.empty()) return out;
  out.solved = true;
  out.shot = a.shots.front(), out.usual = b.shots.front();
  out.success = out.shot.robustness.success.value_or(0);
  out.success_of_usual = success_of(out.usual, own);
  if (out.success_of_usual > out.success) out.shot = out.usual, out.success = out.success_of_usual;
  return out;
}

void choose_all(std::span<const Puzzle> puzzles, int threads, Advice& out) {
  out.shots.resize(puzzles.size());
  for_each_index(puzzles.size(), threads, [&](std::size_t i) { out.shots[i] = choose(puzzles[i], out.noise); });
  std::vector<Choice*> solved;
  for (Choice& c : out.shots)
    if (c.solved) solved.push_back(&c);
  if (solved.empty()) return;
  for (const Choice* c : solved)
    out.gain_by_shot += (c->success - c->success_of_usual) / static_cast<double>(solved.size());
  const auto by_own = std::ranges::max_element(solved, {}, [](const Choice* c) { return c->success; });
  const auto by_usual =
      std::ranges::max_element(solved, {}, [](const Choice* c) { return c->usual.robustness.success.value_or(0); });
  out.gain_by_puzzle = (*by_own)->success - (*by_usual)->success_of_usual;
  std::ranges::stable_sort(out.shots, std::ranges::greater{}, &Choice::success);
}

}  // namespace
}  // namespace planning

Advice advise(std::span<const Attempt> attempts, const AdviseWish& wish) {
  using namespace planning;
  if (attempts.empty()) throw InvalidInput("", "there is no attempt to learn from");
  Recordings seen;
  for (const Attempt& a : attempts) seen.push_back(&a.seen);
  const double noise = noise_of(seen);
  const int threads = std::max(1, wish.threads);
  std::vector<Evidence> evidence(attempts.size());
  std::vector<Spent> works(attempts.size());
  for_each_index(attempts.size(), threads,
                 [&](std::size_t i) { evidence[i] = evidence_of(attempts[i], noise, works[i]); });
  Advice out;
  out.errors = errors_of(evidence);
  out.noise = noise_by(out.errors);
  for (const Evidence& e : evidence) out.attempts.push_back(e.error);
  choose_all(wish.shots, threads, out);
  return out;
}

}  // namespace bankshot
