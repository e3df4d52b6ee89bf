// SPDX-License-Identifier: MIT
//
// Fits of tables whose truth is known. How often it lies within the errors is counted by stress/learn.cpp.
#include "bankshot/learn/fit.hpp"

#include <algorithm>
#include <cmath>

#include "bankshot/scene/json.hpp"
#include "planners/learn/launch.hpp"
#include "support/catch.hpp"
#include "support/filmed.hpp"

namespace {

using namespace bankshot;
using namespace bankshot::test;

const Body carom_ball = preset_scene("carom-10ft").ball.body;

const FittedCoefficient& of(const Fit& fit, const std::string& name) {
  const auto found = std::ranges::find(fit.parameters, name, &FittedCoefficient::name);
  INFO(name);
  REQUIRE(found != fit.parameters.end());
  return *found;
}

bool is_held(const Fit& fit, const std::string& name) {
  return std::ranges::find(fit.held, name, &HeldCoefficient::name) != fit.held.end();
}

TEST_CASE("a table seen without errors is found to its digits") {
  Random random(11);
  const Physics truth = random_table(random, carom_ball);
  const Filmed f = filmed(truth, {.shots = 8, .camera = {.rate = 60}}, random);
  const Fit fit = bankshot::fit(f.recordings);
  for (const FittedCoefficient& p : fit.parameters) {
    INFO(p.name);
    CHECK(p.value == Approx(coefficient(truth, p.name)).epsilon(1e-3));
  }
  for (std::size_t i = 0; i < f.shots.size(); ++i) {
    INFO(i);
    CHECK(fit.shots[i].rms < 1e-4);
    CHECK(fit.shots[i].launch.speed == Approx(f.shots[i].launch.speed).epsilon(1e-2));
  }
}

TEST_CASE("of noisy shots each coefficient is within its errors, and outliers are known", "[heavy]") {
  constexpr std::uint64_t seed = 12;
  Random random(seed);
  const Physics truth = random_table(random, carom_ball);
  const Filmed f = filmed(truth, {.shots = 12}, random);
  const Fit fit = bankshot::fit(f.recordings);
  INFO("seed " << seed);
  for (const FittedCoefficient& p : fit.parameters) {
    INFO(p.name << " " << p.value << " +- " << p.error);
    CHECK(p.error > 0);
    CHECK(std::abs(p.value - coefficient(truth, p.name)) < 5 * p.error);
  }
  CHECK(fit.sigma == Approx(2e-3).epsilon(0.1));
  long outliers = 0, samples = 0;
  for (const FittedShot& s : fit.shots) outliers += s.outliers, samples += s.samples;
  CHECK(static_cast<double>(outliers) / static_cast<double>(outliers + samples) == Approx(0.05).epsilon(0.4));
}

TEST_CASE("the physics of a fit takes the place of a puzzle's, and says how well it is known", "[heavy]") {
  Random random(13);
  const Filmed f = filmed(random_table(random, carom_ball), {.shots = 6}, random);
  const Fit fit = bankshot::fit(f.recordings, {.free = {"cushion.restitution", "rolling_friction"}});
  REQUIRE(fit.parameters.size() == 2);
  REQUIRE(fit.physics.errors);
  CHECK(fit.physics.errors->names == std::vector<std::string>{"rolling_friction", "cushion.restitution"});
  CHECK(fit.physics.errors->covariance[0] == Approx(std::pow(of(fit, "rolling_friction").error, 2)));
  const Scene read = read_scene("\"carom-10ft\"", physics_of(fit));
  CHECK(restitution(read.physics).at_rest == of(fit, "cushion.restitution").value);
  CHECK(read.physics.errors->covariance == fit.physics.errors->covariance);
}

TEST_CASE("what the shots cannot tell is held, and named") {
  // Balls that meet no cushion say nothing of cushions; without side nothing of what stops it.
  Random random(14);
  const Physics truth = random_table(random, carom_ball);
  Filmed f;
  for (int i = 0; i < 6; ++i) {
    Scene scene = preset_scene("carom-10ft");
    ShotRequest s{.table = scene.table, .physics = truth, .ball = scene.ball};
    s.ball.at = {0.3, 0.3 + 0.1 * i};
    s.launch = {random.uniform(0.8, 1.4), random.uniform(-0.1, 0.1)};
    s.launch.angle = wrap_angle(s.launch.angle);
    s.until.length = 2;
    f.recordings.push_back(film(s, simulate(s), {.rate = 60, .noise = 1e-3}, random));
  }
  const Fit fit = bankshot::fit(f.recordings);
  for (const char* name : {"cushion.restitution", "cushion.friction", "cushion.height", "spinning_friction"}) {
    INFO(name);
    CHECK(is_held(fit, name));
    CHECK(message_of(fit).find(name) != std::string::npos);
  }
  CHECK(std::abs(of(fit, "rolling_friction").value - coefficient(truth, "rolling_friction")) <
        5 * of(fit, "rolling_friction").error);
}

TEST_CASE("a tilt is learnt where it is asked for", "[heavy]") {
  Random random(15);
  Physics truth = random_table(random, carom_ball);
  truth.tilt = {0.002, -0.001};
  Filmed f = filmed(truth, {.shots = 3, .seconds = 3, .camera = {.rate = 30, .noise = 1e-3}}, random);
  for (Recording& r : f.recordings) r.scene.physics = truth, r.scene.physics.tilt = {};
  const Fit fit = bankshot::fit(f.recordings, {.free = {"tilt"}});
  for (const char* name : {"tilt.x", "tilt.y"}) {
    INFO(name << " " << of(fit, name).value << " +- " << of(fit, name).error);
    CHECK(std::abs(of(fit, name).value - coefficient(truth, name)) < 5 * of(fit, name).error);
  }
}

TEST_CASE("a rolling table is learnt too") {
  Random random(16);
  Physics truth = rolling_physics();
  std::get<Rolling>(truth.motion).friction = 0.014;
  truth.cushion = Mirror{0.78};
  const Filmed f = filmed(truth, {.shots = 6}, random);
  const Fit fit = bankshot::fit(f.recordings);
  for (const char* name : {"friction", "restitution"}) {
    INFO(name << " " << of(fit, name).value << " +- " << of(fit, name).error);
    CHECK(std::abs(of(fit, name).value - coefficient(truth, name)) < 5 * of(fit, name).error);
  }
}

TEST_CASE("a shot that is left out is predicted from its first part", "[heavy]") {
  Random random(17);
  const Filmed f = filmed(random_table(random, carom_ball), {.shots = 8}, random);
  const Fit fit = bankshot::fit(f.recordings, {.holdout = 4});
  REQUIRE(fit.predictions.size() == 8);
  std::vector<double> rms;
  for (const Prediction& p : fit.predictions) rms.push_back(p.rms);
  std::ranges::sort(rms);
  CHECK(rms[4] < 0.05);  // m; the launch is known from a quarter of the track
}

TEST_CASE("distances have exact derivatives") {
  using namespace bankshot::planning;
  Random random(18);
  Physics truth = random_table(random, carom_ball);
  const std::vector<std::string> names{"sliding_friction", "rolling_friction",    "spinning_friction",
                                       "cushion.friction", "cushion.restitution", "cushion.height"};
  const Filmed f = filmed(truth, {.shots = 6, .camera = {.rate = 60}}, random);
  std::vector<double> values;
  for (const std::string& name : names) values.push_back(coefficient(truth, name));
  for (std::size_t k = 0; k < f.shots.size(); ++k) {
    INFO("shot " << k);
    Seen seen(f.recordings[k], 1e-3);
    constexpr double early = 1e-3;  // s: no sample lies at the launch, where paths have a kink
    seen.launch = unknowns_of(f.shots[k], -early);
    Work work;
    REQUIRE(tell(seen, {.base = truth, .names = names, .values = values}, work));
    const SeenCost cost(seen, names, truth);
    const auto rows = static_cast<std::size_t>(cost.num_residuals());
    const auto at = [&](const LaunchUnknowns& launch, const std::vector<double>& v, double** jacobians) {
      std::vector<double> out(rows);
      const double* blocks[] = {launch.data(), v.data()};
      cost.Evaluate(blocks, out.data(), jacobians);
      return out;
    };
    std::vector<double> by_launch(rows * launch_size), by_names(rows * names.size());
    double* jacobians[] = {by_launch.data(), by_names.data()};
    at(seen.launch, values, jacobians);
    for (std::size_t q = 0; q < launch_size + names.size(); ++q) {
      INFO("unknown " << q);
      const bool own = q < launch_size;
      const double step = 1e-7 * (own ? 1 : values[q - launch_size]);
      LaunchUnknowns low = seen.launch, high = low;
      std::vector<double> less = values, more = values;
      (own ? low[q] : less[q - launch_size]) -= step;
      (own ? high[q] : more[q - launch_size]) += step;
      const auto a = at(low, less, nullptr), b = at(high, more, nullptr);
      double worst = 0, largest = 0;
      for (std::size_t j = 0; j < rows; ++j) {
        const double slope = (b[j] - a[j]) / (2 * step);
        const double exact = own ? by_launch[j * launch_size + q] : by_names[j * names.size() + q - launch_size];
        worst = std::max(worst, std::abs(slope - exact)), largest = std::max(largest, std::abs(slope));
      }
      CHECK(worst <= 1e-3 * largest);
    }
  }
}

}  // namespace
