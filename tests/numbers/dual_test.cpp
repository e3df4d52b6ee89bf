// SPDX-License-Identifier: MIT
//
// Compares our dual numbers with those of Ceres: every operation gives the same bits.
#include "bankshot/numbers/dual.hpp"

#include <ceres/jet.h>

#include <bit>
#include <cstdint>

#include "bankshot/numbers/random.hpp"
#include "support/catch.hpp"

using namespace bankshot;

namespace {

using Ours = Dual<3>;
using Theirs = ceres::Jet<double, 3>;

Theirs same(const Ours& x) {
  Theirs out(x.a);
  for (int k = 0; k < 3; ++k) out.v[k] = x.v[static_cast<std::size_t>(k)];
  return out;
}

bool equal(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

bool equal(const Ours& a, const Theirs& b) {
  return equal(a.a, b.a) && equal(a.v[0], b.v[0]) && equal(a.v[1], b.v[1]) && equal(a.v[2], b.v[2]);
}

Ours draw(Random& r) {
  Ours x(r.uniform(0.1, 3) * (r.chance(0.5) ? 1 : -1));
  for (double& d : x.v) d = r.uniform(-2, 2);
  return x;
}

}  // namespace

TEST_CASE("a dual number rounds as Ceres' does, in every operation") {
  Random r(1);
  for (int i = 0; i < 1000; ++i) {
    const Ours x = draw(r), y = draw(r);
    const Theirs p = same(x), q = same(y);
    const double s = r.uniform(-2, 2);
    REQUIRE(equal(-x, -p));
    REQUIRE(equal(x + y, p + q));
    REQUIRE(equal(x - y, p - q));
    REQUIRE(equal(x * y, p * q));
    REQUIRE(equal(x / y, p / q));
    REQUIRE(equal(x + s, p + s));
    REQUIRE(equal(s + x, s + p));
    REQUIRE(equal(x - s, p - s));
    REQUIRE(equal(s - x, s - p));
    REQUIRE(equal(x * s, p * s));
    REQUIRE(equal(s * x, s * p));
    REQUIRE(equal(x / s, p / s));
    REQUIRE(equal(s / x, s / p));
    REQUIRE(equal(abs(x), abs(p)));
    REQUIRE(equal(sqrt(abs(x)), sqrt(abs(p))));
    REQUIRE(equal(log(abs(x)), log(abs(p))));
    REQUIRE(equal(exp(x), exp(p)));
    REQUIRE(equal(sin(x), sin(p)));
    REQUIRE(equal(cos(x), cos(p)));
    REQUIRE((x < y) == (p < q));
    REQUIRE((x >= s) == (p >= s));
    REQUIRE((s > x) == (s > p));
    REQUIRE((x == x && !(x == s)));
  }
}
