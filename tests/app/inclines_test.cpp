// SPDX-License-Identifier: MIT
//
// The methods that `report` compares for a ball on a slope: all agree with the closed form, each with its order of
// convergence.
#include "app/report/inclines.hpp"

#include <cmath>

#include "bankshot/numbers/random.hpp"
#include "bankshot/scene/ball.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::app::report;

namespace {

constexpr std::uint64_t seed = 41;
constexpr int cases = 200;

struct Roll {
  detail::Incline<double> law;
  Vec2d w;
};
Roll draw(Random& r, double share) {
  const double friction = r.log_uniform(0.03, 0.3);
  return {{friction, 0, friction * share, direction(r.uniform(0, 6.28))},
          direction(r.uniform(0, 6.28)) * r.uniform(0.5, 2)};
}

/// Returns the mean order of convergence at half the time to the stop, from halving the step.
template <class Way>
double order(int steps, const Way& way) {
  Random r(seed);
  double sum = 0;
  for (int i = 0; i < cases; ++i) {
    const Roll roll = draw(r, 0.5);
    const double until = exactly(roll.law, roll.w).time / 2;
    const Vec2d truth = exactly(roll.law, roll.w, until).moved;
    const auto error = [&](int n) { return norm(way(roll, until, n).moved - truth); };
    sum += std::log2(error(steps) / error(2 * steps)) / cases;
  }
  return sum;
}

}  // namespace

TEST_CASE("series and Dormand–Prince on a slope converge with the order of their method") {
  const auto by_series = [](int terms) {
    return [terms](const Roll& r, double until, int n) { return series(r.law, r.w, until, terms, n); };
  };
  CHECK(std::abs(order(64, by_series(3)) - 3) < 0.2);
  CHECK(std::abs(order(16, by_series(6)) - 6) < 0.3);
  const double found =
      order(8, [](const Roll& r, double until, int n) { return dormand_prince(r.law, r.w, until, n); });
  CHECK(found > 4.8);
  CHECK(found < 5.8);
}

TEST_CASE("Dormand–Prince stops where the closed form does") {
  Random r(seed);
  for (int i = 0; i < cases; ++i) {
    const Roll roll = draw(r, r.uniform(0.01, 0.8));
    const Slipped truth = exactly(roll.law, roll.w), found = dormand_prince_to_stop(roll.law, roll.w, 1e-10);
    INFO("draw " << i << " of seed " << seed);
    CHECK(norm(found.moved - truth.moved) < 1e-7 * norm(truth.moved));
    CHECK(std::abs(found.time - truth.time) < 1e-4 * truth.time);
  }
}

TEST_CASE("what a slope adds in first order is off by its square") {
  Random r(seed);
  for (int i = 0; i < cases; ++i) {
    Roll roll = draw(r, 1e-2);
    const auto error = [&] { return norm(perturbed(roll.law, roll.w).moved - exactly(roll.law, roll.w).moved); };
    const double steep = error();
    roll.law.pull /= 10;
    INFO("draw " << i << " of seed " << seed);
    CHECK(steep / error() == Approx(100).epsilon(0.2));
  }
}
