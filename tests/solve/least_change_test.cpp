// SPDX-License-Identifier: MIT
//
// Steps of least change, on equations with known solutions and on the branch of a pot.
#include "planners/solve/least_change.hpp"

#include <Eigen/QR>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "support/catch.hpp"
#include "support/one_pot.hpp"

using namespace bankshot;
using namespace bankshot::planning;
using namespace bankshot::planning::branch;

namespace {

Value random_value(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  Value out{normal(random), {}};
  for (int i = 0; i < coordinates; ++i) out.by[i] = normal(random);
  return out;
}

double left_of(const Value& e, const Vector& step) { return e.a + e.by.dot(step); }

const Box everywhere{Vector::Constant(-infinite), Vector::Constant(infinite)};

}  // namespace

TEST_CASE("the least step solves its equations, and no shorter one does") {
  constexpr std::uint64_t seed = 61;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int draw = 0; draw < 200; ++draw) {
    CAPTURE(draw);
    std::vector<Value> equations;
    for (int k = 0; k <= draw % 3; ++k) equations.push_back(random_value(random));
    const Vector step = least_step(equations, {}, everywhere, Vector::Zero());
    for (const Value& e : equations) CHECK(std::abs(left_of(e, step)) < 1e-9 * (1 + step.norm()));
    // The step is a combination of the gradients, in scales: nothing of it lies in the null space.
    Eigen::MatrixXd gradients(coordinates, equations.size());
    for (std::size_t k = 0; k < equations.size(); ++k)
      gradients.col(static_cast<Eigen::Index>(k)) = equations[k].by.cwiseProduct(scales());
    const Eigen::VectorXd scaled = step.cwiseQuotient(scales());
    const Eigen::VectorXd fitted = gradients * gradients.colPivHouseholderQr().solve(scaled);
    CHECK((scaled - fitted).norm() < 1e-9 * (1 + scaled.norm()));
  }
}

TEST_CASE("what is kept is solved, and what is wanted comes as near as that leaves it") {
  constexpr std::uint64_t seed = 62;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int draw = 0; draw < 100; ++draw) {
    CAPTURE(draw);
    const std::array kept{random_value(random), random_value(random)},
        wanted{random_value(random), random_value(random)};
    const Vector step = least_step(kept, wanted, everywhere, Vector::Zero());
    for (const Value& e : kept) CHECK(std::abs(left_of(e, step)) < 1e-8 * (1 + step.norm()));
    for (const Value& e : wanted) CHECK(std::abs(left_of(e, step)) < 1e-8 * (1 + step.norm()));
    // Only aim and speed are free: the two equations that are kept take both.
    Box narrow{Vector::Zero(), Vector::Zero()};
    for (const int i : {aim, log_speed}) narrow.low[i] = -infinite, narrow.high[i] = infinite;
    const Vector few = least_step(kept, wanted, narrow, Vector::Zero());
    for (const Value& e : kept) CHECK(std::abs(left_of(e, few)) < 1e-8 * (1 + few.norm()));
    CHECK(few.tail(3).isZero(0));
  }
}

TEST_CASE("a coordinate stays inside its bounds, and the others solve the equations without it") {
  Value e{-1, Vector::Ones()};
  Box box = everywhere;
  box.high[top] = 0.01;
  const Vector step = least_step(std::array{e}, {}, box, Vector::Zero());
  CHECK(step[top] == 0.01);
  CHECK(left_of(e, step) == Approx(0).margin(1e-14));
  box.low = box.high = Vector::Zero();
  CHECK(least_step(std::array{e}, {}, box, Vector::Zero()).isZero(0));
}

TEST_CASE("steps lead to the launch where a pot is made, or end where there is none") {
  test::OnePot s;
  const auto off = [&](const Vector& at) -> std::optional<Equations> {
    const auto point = look(s.branch, s.budget, at, Vary::spin_too);
    return point ? std::optional(passes(*point)) : std::nullopt;
  };
  const auto there = least_change(s.x, box_of(s.request), settings::settled, off);
  REQUIRE(there);
  CHECK(std::abs(off(*there)->each[0].a) < 1e-12);
  Box fixed{s.x, s.x};
  CHECK_FALSE(least_change(s.x, fixed, settings::settled, off));
  Vector away = s.x;
  away[aim] += 2;
  CHECK_FALSE(least_change(away, everywhere, settings::settled, off));
}

TEST_CASE("a long step is cut in its direction") {
  const Vector step = 100 * scales();
  const Vector shorter = cut(step);
  CHECK(size_of(step) == Approx(100));
  CHECK(size_of(shorter) < 3);
  CHECK((shorter / shorter.norm() - step / step.norm()).norm() < 1e-12);
  CHECK(cut(scales()) == scales());
}
