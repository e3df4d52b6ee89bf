// SPDX-License-Identifier: MIT
//
// Cost of one answer without margin and success, over random puzzles that have a shot. Simulations (traces, locked
// paths and replays) are counted beside the time.
#include <benchmark/benchmark.h>

#include <vector>

#include "bankshot/plan/planner.hpp"
#include "support/random_puzzle.hpp"

namespace {

using namespace bankshot;

constexpr std::size_t puzzles = 512;

/// Draws puzzles with `bounces` cushions on rectangles without pockets; the route is given or only the count.
std::vector<Puzzle> draw(int bounces, test::Model model, bool sequence) {
  test::Random random(1);
  std::vector<Puzzle> out;
  while (out.size() < puzzles) {
    Puzzle p = test::random_puzzle(random, test::Family::uniform, model).puzzle;
    if (p.cushions.max != bounces || p.cushions.sequence.has_value() != sequence || !p.table.pockets.empty()) continue;
    out.push_back(std::move(p));
  }
  return out;
}

void solve_set(benchmark::State& state, test::Model model, bool sequence, const SolveOptions& options) {
  const std::vector<Puzzle> set = draw(static_cast<int>(state.range(0)), model, sequence);
  long simulations = 0;
  std::size_t n = 0;
  for (auto _ : state) {
    const Answer a = solve(set[n++ % puzzles], options);
    simulations += a.simulations;
    benchmark::DoNotOptimize(a.shots.data());
  }
  state.counters["simulations"] =
      benchmark::Counter(static_cast<double>(simulations), benchmark::Counter::kAvgIterations);
}

void rolling_sequence(benchmark::State& s) { solve_set(s, test::Model::rolling, true, {.robustness = false}); }
void rolling_count(benchmark::State& s) { solve_set(s, test::Model::rolling, false, {.robustness = false}); }
void rolling_count_robust(benchmark::State& s) { solve_set(s, test::Model::rolling, false, {}); }
void spin_sequence(benchmark::State& s) { solve_set(s, test::Model::spin, true, {.robustness = false}); }
void ideal_sequence(benchmark::State& s) { solve_set(s, test::Model::ideal, true, {.robustness = false}); }
void ideal_count(benchmark::State& s) { solve_set(s, test::Model::ideal, false, {.robustness = false}); }
void rolling_ceres(benchmark::State& s) {
  solve_set(s, test::Model::rolling, true, {.planner = "ceres", .robustness = false});
}
void rolling_sweep(benchmark::State& s) {
  solve_set(s, test::Model::rolling, false, {.planner = "sweep", .robustness = false});
}
#if BANKSHOT_NLOPT
void rolling_bobyqa(benchmark::State& s) {
  solve_set(s, test::Model::rolling, true, {.planner = "nlopt-bobyqa", .robustness = false});
}
void rolling_direct(benchmark::State& s) {
  solve_set(s, test::Model::rolling, false, {.planner = "nlopt-direct", .robustness = false});
}
#endif

BENCHMARK(rolling_sequence)->Arg(1)->Arg(3)->Arg(5);
BENCHMARK(rolling_count)->Arg(1)->Arg(3)->Arg(5);
BENCHMARK(spin_sequence)->Arg(1)->Arg(3);
BENCHMARK(ideal_sequence)->Arg(1)->Arg(3)->Arg(5);
BENCHMARK(ideal_count)->Arg(1)->Arg(3)->Arg(5);
BENCHMARK(rolling_count_robust)->Arg(3);
BENCHMARK(rolling_ceres)->Arg(3);
BENCHMARK(rolling_sweep)->Arg(3);
#if BANKSHOT_NLOPT
BENCHMARK(rolling_bobyqa)->Arg(3);
BENCHMARK(rolling_direct)->Arg(3);
#endif

}  // namespace
