// SPDX-License-Identifier: MIT
//
// Polynomials with known roots, and truncated power series against closed forms.
#include "bankshot/detail/roots/polynomial.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bankshot/detail/mathavan2010/polynomial.hpp"
#include "bankshot/numbers/dual.hpp"
#include "bankshot/numbers/random.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::detail;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// (t − 1)(t − 2)(t − 3)
const Polynomial<double, 3> cubic{-6.0, 11.0, -6.0, 1.0};

/// Returns the series of eˣ, times `by` to the power of its order.
mathavan::Series<double> exponential(double by = 1) {
  mathavan::Series<double> a{};
  double term = 1;
  for (std::size_t n = 0; n < a.size(); ++n, term *= by / static_cast<double>(n)) a[n] = term;
  return a;
}

}  // namespace

TEST_CASE("a polynomial and its derivative have the values of their coefficients") {
  CHECK(cubic(0.0) == -6);
  CHECK(cubic(4.0) == 6);
  CHECK(cubic.derivative().c == std::array<double, 3>{11, -12, 3});
  CHECK(cubic.derivative()(2.0) == -1);
}

TEST_CASE("all simple roots of an interval are found in order, and no others") {
  const auto all = roots_between(cubic, 0.5, 3.5);
  REQUIRE(all.count == 3);
  for (int k = 0; k < 3; ++k) CHECK(all.begin()[k] == Approx(k + 1).epsilon(1e-14));
  const auto middle = roots_between(cubic, 1.5, 2.5);
  REQUIRE(middle.count == 1);
  CHECK(*middle.begin() == Approx(2).epsilon(1e-15));
  CHECK(roots_between(cubic, 3.5, 9.0).count == 0);
  CHECK(roots_between(Polynomial<double, 2>{1.0, -2.0, 1.0}, 0.0, 3.0).count == 0);  // (t − 1)² does not change sign
}

TEST_CASE("leading coefficients may vanish") {
  const auto line = roots_between(Polynomial<double, 4>{-1.0, 2.0, 0.0, 0.0, 0.0}, 0.0, 5.0);
  REQUIRE(line.count == 1);
  CHECK(*line.begin() == 0.5);
}

TEST_CASE("four roots that are drawn at random are found again") {
  constexpr std::uint64_t seed = 81;
  Random r(seed);
  for (int i = 0; i < 2000; ++i) {
    std::array<double, 4> roots;
    double last = 0;
    for (double& root : roots) root = last += r.uniform(0.1, 1);
    Polynomial<double, 4> f{1.0, 0.0, 0.0, 0.0, 0.0};
    for (const double root : roots)  // multiplies by (t − root)
      for (std::size_t k = 5; k-- > 0;) f.c[k] = (k > 0 ? f.c[k - 1] : 0) - root * f.c[k];
    const auto found = roots_between(f, 0.0, last + 0.1);
    INFO("number " << i << " of seed " << seed);
    REQUIRE(found.count == 4);
    for (std::size_t k = 0; k < 4; ++k) REQUIRE(std::abs(found.values[k] - roots[k]) < 1e-11);
    REQUIRE(first_descent_of(f, last + 1) == Approx(roots[0]).epsilon(1e-11));  // f begins above 0
    REQUIRE(first_descent_of(f, roots[0] - 0.05) == infinity);
  }
}

TEST_CASE("a descent goes from above 0 to below, or begins at 0 and falls") {
  CHECK(first_descent_of(cubic, 9.0) == Approx(2).epsilon(1e-15));
  CHECK(first_descent_of(Polynomial<double, 2>{0.0, -1.0, 9.0}, 5.0) == 0);
  CHECK(first_descent_of(Polynomial<double, 2>{0.0, 1.0, -1.0}, 5.0) == Approx(1).epsilon(1e-15));
  CHECK(first_descent_of(Polynomial<double, 2>{0.0, 1.0, 1.0}, 5.0) == infinity);
}

TEST_CASE("the product of two series is the series of the product") {
  const auto up = exponential(), down = exponential(-1), twice = exponential(2);
  CHECK(mathavan::product(up, down, 0) == 1);
  for (int n = 1; n < mathavan::max_order<double>; ++n) {
    CHECK(std::abs(mathavan::product(up, down, n)) < 1e-15);
    CHECK(mathavan::product(up, up, n) == Approx(twice[static_cast<std::size_t>(n)]).epsilon(1e-14));
    const double whole = mathavan::product(up, up, n), last = up[static_cast<std::size_t>(n)];
    CHECK(mathavan::product(up, up, n, 1) == Approx(whole - last).margin(1e-15));
    CHECK(mathavan::product(up, up, n, 1, 1) == Approx(whole - 2 * last).margin(1e-15));
  }
}

TEST_CASE("a series has the value, the slope and the root of its function") {
  constexpr int order = 24;
  const auto f = exponential();
  for (const double x : {-1.0, 0.0, 0.3, 1.0}) {
    CHECK(mathavan::evaluate(f, order, x) == Approx(std::exp(x)).epsilon(1e-15));
    CHECK(mathavan::slope(f, order, x) == Approx(std::exp(x)).epsilon(1e-15));
  }
  CHECK(mathavan::root(f, order, 2.0, 1.0, 1e-15) == Approx(std::log(2.0)).epsilon(1e-15));
  // The derivative of the root follows from the slope: d(ln goal) = d goal / goal.
  mathavan::Series<Dual<1>> dual;
  for (std::size_t n = 0; n < dual.size(); ++n) dual[n] = Dual<1>(f[n]);
  const Dual<1> root = mathavan::root(dual, order, Dual<1>(2, 0), 1.0, 1e-15);
  CHECK(root.a == Approx(std::log(2.0)).epsilon(1e-15));
  CHECK(root.v[0] == Approx(0.5).epsilon(1e-14));
}

TEST_CASE("a switch is found to the last bit, on its far side") {
  const auto outside = [](double x) { return x * x > 2; };
  const double at = mathavan::first_outside(3, outside);
  CHECK(outside(at));
  CHECK(at == Approx(std::sqrt(2.0)).epsilon(2e-15));
}

TEST_CASE("decisions see the number, error estimates a thousandth of its derivatives") {
  Dual<2> x(-0.5, 0);
  x.v[1] = -4000;
  CHECK(mathavan::as_double(x) == -0.5);
  CHECK(mathavan::magnitude(x) == 4);
  CHECK(mathavan::magnitude(-0.5) == 0.5);
}
