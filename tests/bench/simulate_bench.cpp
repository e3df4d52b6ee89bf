// SPDX-License-Identifier: MIT
//
// Cost of one forward simulation, shots drawn at random and stopped at the n-th bounce.
//   bash tests/bench/run.sh, which writes tests/bench/results/simulate.csv
#include <benchmark/benchmark.h>

#include <vector>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/simulate/simulator.hpp"
#include "support/random_puzzle.hpp"

namespace {

using namespace bankshot;

constexpr int shots = 1024;

template <class Motion>
void simulate(benchmark::State& state, const Motion& motion, bool pockets) {
  Table table = rectangle_table(2.54, 1.27);
  if (pockets) table.pockets = six_pockets(table, {0.116, 0.129});
  const Boundary boundary(table, {0.028575});
  test::Random random(1);
  std::vector<State<double>> starts;
  while (starts.size() < shots) {
    const State<double> s{{random.uniform(0.1, 2.4), random.uniform(0.1, 1.1)},
                          direction(random.uniform(0, 6.28)) * 4.0};
    starts.push_back(s);
  }
  long events = 0, n = 0;
  for (auto _ : state) {
    Simulator sim(boundary, motion, Mirror{0.85}, starts[static_cast<std::size_t>(n++ % shots)]);
    int bounces = 0;
    while (bounces < state.range(0)) {
      ++events;
      if (sim.step().final()) break;
      ++bounces;
    }
    benchmark::DoNotOptimize(sim.state());
  }
  state.counters["events"] = benchmark::Counter(static_cast<double>(events), benchmark::Counter::kAvgIterations);
}

void simulate_ideal(benchmark::State& state) { simulate(state, Ideal{}, false); }
void simulate_rolling(benchmark::State& state) { simulate(state, Rolling{}, false); }
void simulate_rolling_pockets(benchmark::State& state) { simulate(state, Rolling{}, true); }

BENCHMARK(simulate_ideal)->Arg(1)->Arg(3)->Arg(5)->Arg(100);
BENCHMARK(simulate_rolling)->Arg(1)->Arg(3)->Arg(5);
BENCHMARK(simulate_rolling_pockets)->Arg(1)->Arg(3)->Arg(5);

}  // namespace
