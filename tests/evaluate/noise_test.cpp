// SPDX-License-Identifier: MIT
//
// Normal draws and noise scanlines, compared with the normal distribution itself.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "bankshot/numbers/random.hpp"
#include "planners/evaluate/draws.hpp"
#include "planners/evaluate/noise_scanlines.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::planning;

namespace {

/// Sums a function of a normal error, weighed by its density.
template <class F>
double mean_of(const F& f) {
  constexpr double step = 1e-3;
  double sum = 0;
  for (double z = -8 + step / 2; z < 8; z += step)
    sum += f(z) * std::exp(-z * z / 2) * step / std::sqrt(2 * std::numbers::pi);
  return sum;
}

/// Returns whether the edges of a scanline call an error made.
bool made(const NoiseScanline& line, double across) {
  return line.open != (std::ranges::count_if(line.edges, [&](double edge) { return edge < across; }) % 2 == 1);
}

}  // namespace

TEST_CASE("draws are independent standard normal numbers, the same each time") {
  const std::size_t count = GENERATE(std::size_t{1}, std::size_t{2}, std::size_t{5}, std::size_t{8});
  CAPTURE(count);
  constexpr int many = 4096;
  Draws draws(count), again(count);
  std::vector<std::vector<double>> seen;
  for (int i = 0; i < many; ++i) {
    seen.push_back(draws.next());
    REQUIRE(seen.back() == again.next());
  }
  const auto mean = [&](const auto& f) {
    double sum = 0;
    for (const auto& draw : seen) sum += f(draw);
    return sum / many;
  };
  REQUIRE(seen[0].size() >= count);
  for (std::size_t k = 0; k < count; ++k) {
    CHECK(mean([&](const auto& z) { return z[k]; }) == Approx(0).margin(0.01));
    CHECK(mean([&](const auto& z) { return z[k] * z[k]; }) == Approx(1).margin(0.02));
    for (std::size_t j = 0; j < k; ++j)
      CHECK(mean([&](const auto& z) { return z[j] * z[k]; }) == Approx(0).margin(0.03));
    for (const double z : {-2.0, -1.0, -0.3, 0.0, 0.6, 1.5})
      CHECK(mean([&](const auto& draw) { return draw[k] < z ? 1.0 : 0.0; }) == Approx(normal_below(z)).margin(0.01));
  }
}

TEST_CASE("the probability below a number of deviations is the normal one, in its tails too") {
  CHECK(normal_below(0) == 0.5);
  CHECK(normal_below(1) == Approx(0.8413447460685429).epsilon(1e-14));
  CHECK(normal_below(-2) == Approx(0.02275013194817921).epsilon(1e-13));
  CHECK(normal_below(-8) == Approx(6.220960574271785e-16).epsilon(1e-12));
  CHECK(normal_below(0.7) + normal_below(-0.7) == Approx(1).epsilon(1e-15));
}

TEST_CASE("a scanline reads its edges off between tries that differ, where they are expected if that lies there") {
  NoiseScanline line{0, {{-2, false}, {-1, true}, {1, true}, {2, false}}};
  line.read_off({-1.25, 0.3});
  CHECK(line.edges == std::vector{-1.25, 1.5});
  CHECK(!line.open);
  CHECK(line.changes() == 2);
  CHECK(line.success == Approx((std::erf(1.5 / std::sqrt(2)) + std::erf(1.25 / std::sqrt(2))) / 2));
  CHECK((made(line, -1.2) && made(line, 1.4) && !made(line, 1.6) && !made(line, -1.3)));
  line.tries = {{-1, true}, {1, false}};
  line.read_off({});
  CHECK((line.open && made(line, -3) && !made(line, 0.1)));
  CHECK(line.success == Approx(0.5));
}

TEST_CASE("the success of a scanline is the probability of what it calls made") {
  constexpr std::uint64_t seed = 3;
  Random random(seed);
  for (int i = 0; i < 20; ++i) {
    INFO("scanline " << i << " of seed " << seed);
    NoiseScanline line{0};
    const int tries = random.integer(1, 12);
    for (int k = 0; k < tries; ++k) line.tries.push_back({random.uniform(-3, 3), random.chance(0.5)});
    std::ranges::sort(line.tries, {}, &NoiseScanline::Try::across);
    line.read_off({random.uniform(-3, 3)});
    CHECK(static_cast<int>(line.edges.size()) == line.changes());
    for (const NoiseScanline::Try& t : line.tries) CHECK(made(line, t.across) == t.made);
    CHECK(line.success == Approx(mean_of([&](double z) { return made(line, z) ? 1.0 : 0.0; })).margin(3e-3));
  }
}

TEST_CASE("scanlines together have the success of the whole plane") {
  const auto over = [](const auto& success) {
    std::vector<NoiseScanline> lines;
    for (int k = -4; k <= 4; ++k) lines.push_back({0.65 * k, {}, {}, false, success(0.65 * k)});
    return success_of(lines);
  };
  CHECK(over([](double) { return 1.0; }) == 1);
  CHECK(over([](double) { return 0.37; }) == Approx(0.37).epsilon(1e-6));
  // A line across the plane, at an angle to the scanlines.
  const double slope = GENERATE(0.0, 0.3, -0.8), from = GENERATE(-0.5, 0.0, 1.2);
  CAPTURE(slope, from);
  CHECK(over([&](double along) { return normal_below(from - slope * along); }) ==
        Approx(normal_below(from / std::hypot(1, slope))).margin(2e-3));
  // Between a scanline that is made and one that is not, success falls and does not overshoot.
  const double stepped = over([](double along) { return along < 0.1 ? 1.0 : 0.0; });
  CHECK(stepped > normal_below(0));
  CHECK(stepped < normal_below(0.65));
}
