// SPDX-License-Identifier: MIT
//
// Cost of a shot with spin up to its n-th cushion, plain and with the derivatives by two parameters, in the simulator
// and along a locked path. Quote the ratio of minima, because the machine's noise only adds time.
#include <benchmark/benchmark.h>
#include <array>
#include <vector>

#include "bankshot/motion/launched.hpp"
#include "bankshot/numbers/dual.hpp"
#include "bankshot/simulate/locked.hpp"
#include "bankshot/simulate/simulator.hpp"
#include "support/random_puzzle.hpp"

namespace {

using namespace bankshot;
using Dual = bankshot::Dual<2>;

struct Case {
  Vec2d at;
  double speed, angle;
  LaunchSpin spin;
  Route route;
};

const Boundary& boundary() {
  static const Boundary made(rectangle_table(2.54, 1.27), {0.028575});
  return made;
}

/// Returns a start with its derivatives by aim [rad] and by ln speed.
template <class T>
State<T> start_of(const Case& c) {
  const Vec2d v = direction(c.angle) * c.speed;
  Vec2<T> velocity = to<T>(v);
  if constexpr (!std::is_same_v<T, double>) {
    velocity.x.v[0] = -v.y;
    velocity.x.v[1] = v.x;
    velocity.y.v[0] = v.x;
    velocity.y.v[1] = v.y;
  }
  return launched(c.at, 0.028575, velocity, c.spin);
}

template <class T>
int run(const Case& c, int cushions, long& events, State<T>* end = nullptr) {
  Simulator sim(boundary(), SlideRoll{}, Han2005{}, start_of<T>(c));
  int bounces = 0;
  while (bounces < cushions) {
    const Event e = sim.step();
    ++events;
    if (e.final()) break;
    if (e.kind == EventKind::cushion) ++bounces;
  }
  benchmark::DoNotOptimize(sim.state());
  if (end) *end = sim.state();
  return bounces;
}

/// Returns shots that reach three cushions, so that plain and locked runs do the same work.
const std::vector<Case>& cases() {
  static const std::vector<Case> made = [] {
    std::vector<Case> out;
    test::Random r(1);
    while (out.size() < 1024) {
      Case c{{r.uniform(0.1, 2.4), r.uniform(0.1, 1.1)},
             4,
             r.uniform(0, 6.28),
             {r.uniform(-1, 1), r.uniform(-1, 1), 0},
             {}};
      Simulator sim(boundary(), SlideRoll{}, Han2005{}, start_of<double>(c));
      for (Event e = sim.step(); !e.final() && c.route.size() < 3; e = sim.step())
        if (e.kind == EventKind::cushion) c.route.push_back({0, e.contact});
      if (c.route.size() == 3) out.push_back(c);
    }
    return out;
  }();
  return made;
}

template <class T>
void simulate(benchmark::State& state) {
  long events = 0;
  std::size_t n = 0;
  for (auto _ : state) run<T>(cases()[n++ % cases().size()], static_cast<int>(state.range(0)), events);
  state.counters["events"] = benchmark::Counter(static_cast<double>(events), benchmark::Counter::kAvgIterations);
}

template <class T>
void locked(benchmark::State& state) {
  std::size_t n = 0;
  for (auto _ : state) {
    const Case& c = cases()[n++ % cases().size()];
    benchmark::DoNotOptimize(follow_locked(boundary(), SlideRoll{}, Han2005{}, c.route, start_of<T>(c)));
  }
}

/// Follows the first leg until it is abreast of the start of the next case, or within 6 cm of it.
template <class T>
void arrive(benchmark::State& state) {
  std::size_t n = 0;
  for (auto _ : state) {
    const Case &c = cases()[n % cases().size()], &other = cases()[(n + 1) % cases().size()];
    ++n;
    benchmark::DoNotOptimize(arrive_locked(SlideRoll{}, boundary().body, start_of<T>(c), other.at, 0.06, false));
  }
}

void simulate_spin(benchmark::State& state) { simulate<double>(state); }
void simulate_spin_derivatives(benchmark::State& state) { simulate<Dual>(state); }
void locked_spin(benchmark::State& state) { locked<double>(state); }
void locked_spin_derivatives(benchmark::State& state) { locked<Dual>(state); }
void locked_arrival(benchmark::State& state) { arrive<double>(state); }
void locked_arrival_derivatives(benchmark::State& state) { arrive<Dual>(state); }

BENCHMARK(simulate_spin)->Arg(1)->Arg(3);
BENCHMARK(simulate_spin_derivatives)->Arg(1)->Arg(3);
BENCHMARK(locked_spin);
BENCHMARK(locked_spin_derivatives);
BENCHMARK(locked_arrival);
BENCHMARK(locked_arrival_derivatives);

}  // namespace
