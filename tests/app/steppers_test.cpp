// SPDX-License-Identifier: MIT
//
// The stepping simulators that `report` compares with, on motion that none of them integrates exactly: spin, and
// rolling friction that grows with the speed. With events located, their errors fall with the first, first, fourth and
// fifth power of the step. All then converge to the result of the event-driven simulator. Without events located, they
// converge with the first power.
#include "app/report/steppers.hpp"

#include <cmath>
#include <cstdio>
#include <vector>

#include "app/report/compared.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::app::report;

namespace {

Physics dragging() {
  Physics p = spin_physics();
  std::get<SlideRoll>(p.motion).rolling_friction = {0.02, 0.1};
  return p;
}

double error(const Timed& shot, const Scheme& scheme) {
  const Boundary& table = comparison_table();
  return norm(step_through(table, dragging(), shot.start, shot.until, scheme).state.at -
              by_events(table, dragging(), shot).at);
}

/// Draws shots that roll for a while. A slide alone is a parabola, which the higher orders integrate exactly.
std::vector<Timed> rolling_shots() {
  constexpr std::size_t enough = 40;
  Random draw(11);
  std::vector<Timed> out;
  while (out.size() < enough) {
    const Timed shot = timed_shot(draw, dragging(), 1);
    if (shot.until > 0.6 && error(shot, {Scheme::Method::rk4, true, 0.1}) > 1e-9) out.push_back(shot);
  }
  return out;
}

/// Returns the slope of the mean log error over the log step; the step starts at `largest` and shrinks by 1.3.
double order(Scheme scheme, double largest, int steps) {
  const std::vector<Timed> shots = rolling_shots();
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  const bool adaptive = scheme.method == Scheme::Method::dormand_prince;
  for (int k = 0; k < steps; ++k) {
    const double step = largest * std::pow(1.3, -k), x = std::log(step);
    // With a tolerance that never shortens a step, Dormand-Prince takes steps of the longest size.
    (adaptive ? scheme.longest : scheme.step) = step;
    if (adaptive) scheme.step = 1e3;
    double y = 0;
    for (const Timed& shot : shots) y += std::log(error(shot, scheme)) / static_cast<double>(shots.size());
    sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  return (steps * sxy - sx * sy) / (steps * sxx - sx * sx);
}

}  // namespace

TEST_CASE("with events located the steppers converge with the order of their method") {
  using Method = Scheme::Method;
  const auto [method, largest, expected] = GENERATE(table<Method, double, double>({{Method::euler, 0.01, 1},
                                                                                   {Method::semi_implicit, 0.01, 1},
                                                                                   {Method::rk4, 0.15, 4},
                                                                                   {Method::dormand_prince, 0.2, 5}}));
  const double found = order({method, true}, largest, 10);
  std::printf("order of method %d with events located: %.2f\n", static_cast<int>(method), found);
  CHECK(std::abs(found - expected) <= 0.2);
}

TEST_CASE("without they all converge with order one") {
  using Method = Scheme::Method;
  const Method method = GENERATE(Method::euler, Method::semi_implicit, Method::rk4);
  const double found = order({method, false}, 0.01, 10);
  std::printf("order of method %d without: %.2f\n", static_cast<int>(method), found);
  CHECK(std::abs(found - 1) <= 0.2);
}
