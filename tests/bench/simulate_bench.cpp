// SPDX-License-Identifier: MIT
//
// Cost of one simulation of random shots that stop at the n-th bounce.
//   bash tests/bench/run.sh, which writes tests/bench/results/simulate.csv
#include <benchmark/benchmark.h>

#include <vector>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/motion/launched.hpp"
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
    for (long left = state.range(0); left > 0; --left) {
      ++events;
      if (sim.step().final()) break;
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

// Cost of pockets to a shot that meets none: the shots are equal, with spin, up to their third cushion.

enum class Pockets { none, circles, jaws };

Table pool(Pockets pockets) {
  const TablePreset& preset = *find_table_preset("pool-9ft");
  Table table = make_table(preset, pockets == Pockets::jaws);
  if (pockets == Pockets::none) table.pockets.clear();
  return table;
}

/// Simulates up to the third cushion; returns the number of cushions, or -1 if a jaw or a pocket was met.
int three_cushions(const Boundary& boundary, const State<double>& start) {
  Simulator sim(boundary, SlideRoll{}, Han2005{}, start);
  int bounces = 0;
  while (bounces < 3) {
    const Event e = sim.step();
    if (e.kind == EventKind::jaw || e.kind == EventKind::pocket) return -1;
    if (e.final()) break;
    if (e.bounces()) ++bounces;
  }
  benchmark::DoNotOptimize(sim.state());
  return bounces;
}

void simulate_past(benchmark::State& state, Pockets pockets) {
  const Body body = find_table_preset("pool-9ft")->body;
  const Boundary circles(pool(Pockets::circles), body), jaws(pool(Pockets::jaws), body), there(pool(pockets), body);
  test::Random random(1);
  std::vector<State<double>> starts;
  while (starts.size() < shots) {
    const Vec2d at{random.uniform(0.1, 2.4), random.uniform(0.1, 1.1)};
    const Vec2d velocity = direction(random.uniform(0, 6.28)) * random.uniform(2, 5);
    const State<double> s = launched(at, body.radius, velocity, {random.uniform(-1, 1), random.uniform(-1, 1)});
    if (three_cushions(circles, s) == 3 && three_cushions(jaws, s) == 3) starts.push_back(s);
  }
  std::size_t n = 0;
  for (auto _ : state) benchmark::DoNotOptimize(three_cushions(there, starts[n++ % shots]));
}

void simulate_past_no_pockets(benchmark::State& state) { simulate_past(state, Pockets::none); }
void simulate_past_circles(benchmark::State& state) { simulate_past(state, Pockets::circles); }
void simulate_past_jaws(benchmark::State& state) { simulate_past(state, Pockets::jaws); }

BENCHMARK(simulate_past_no_pockets);
BENCHMARK(simulate_past_circles);
BENCHMARK(simulate_past_jaws);

}  // namespace
