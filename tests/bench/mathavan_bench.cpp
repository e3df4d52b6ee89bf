// SPDX-License-Identifier: MIT
//
// Cost of one cushion impact: mathavan2010 at three tolerances (given as minus the exponent of ten), and the closed
// form of han2005. The balls are drawn at random: rolling, sliding, and with any spin.
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "bankshot/contact/han2005.hpp"
#include "bankshot/contact/mathavan2010.hpp"
#include "bankshot/motion/launched.hpp"
#include "bankshot/scene/ball.hpp"
#include "support/random_puzzle.hpp"

namespace {

using namespace bankshot;

enum Family { rolls, slides, spins };
constexpr int balls = 1024;
constexpr double radius = 0.028575;

std::vector<State<double>> draw(Family family) {
  test::Random random(1);
  std::vector<State<double>> out;
  while (out.size() < balls) {
    const Vec2d velocity = direction(random.uniform(0, radians(180))) * random.log_uniform(0.2, 10);
    LaunchSpin spin{.top = family == rolls ? 1.0 : 0.0};
    if (family == spins) spin = {random.uniform(-1, 1.2), random.uniform(-1, 1), 0};
    out.push_back(launched({0, 0}, radius, velocity, spin));
  }
  return out;
}

template <class Cushion>
void bounce(benchmark::State& state, const Cushion& cushion, Family family) {
  const auto starts = draw(family);
  std::size_t n = 0;
  for (auto _ : state) {
    State<double> s = starts[n++ % balls];
    cushion.bounce(Body{radius}, s, Vec2d{0, -1});
    benchmark::DoNotOptimize(s);
  }
}

void mathavan(benchmark::State& state, Family family) {
  const Mathavan2010 cushion{.tolerance = std::pow(10.0, -static_cast<double>(state.range(0)))};
  bounce(state, cushion, family);
  double steps = 0;
  for (State<double> s : draw(family)) steps += cushion.course(Body{radius}, s, Vec2d{0, -1}).steps;
  state.counters["steps"] = steps / balls;
}

void mathavan_rolling(benchmark::State& state) { mathavan(state, rolls); }
void mathavan_sliding(benchmark::State& state) { mathavan(state, slides); }
void mathavan_spinning(benchmark::State& state) { mathavan(state, spins); }
void han_spinning(benchmark::State& state) { bounce(state, Han2005{}, spins); }

BENCHMARK(mathavan_rolling)->Arg(6)->Arg(9)->Arg(13);
BENCHMARK(mathavan_sliding)->Arg(6)->Arg(9)->Arg(13);
BENCHMARK(mathavan_spinning)->Arg(6)->Arg(9)->Arg(13);
BENCHMARK(han_spinning);

}  // namespace
