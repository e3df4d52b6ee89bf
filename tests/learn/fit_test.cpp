// SPDX-License-Identifier: MIT
//
// Fits of tables whose truth is known. The program stress/learn.cpp counts how often the truth lies within the errors.
#include "bankshot/learn/fit.hpp"

#include <algorithm>
#include <cmath>

#include "bankshot/scene/json.hpp"
#include "planners/learn/launch.hpp"
#include "planners/learn/models.hpp"
#include "planners/learn/unknowns.hpp"
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

TEST_CASE("a shot that the laws cannot follow makes the camera no worse", "[heavy]") {
  Random random(24);
  const Physics truth = random_table(random, carom_ball);
  Filmed f = filmed(truth, {.shots = 8, .seconds = 3}, random);
  Physics other = truth;
  std::get<Han2005>(other.cushion).restitution = 0.5;
  ShotRequest strange = f.shots.back();
  strange.physics = other;
  f.recordings.push_back(film(strange, simulate(strange), {.rate = 60, .noise = 2e-3}, random));
  f.recordings.back().scene.physics = f.recordings.front().scene.physics;
  const Fit fit = bankshot::fit(f.recordings);
  CHECK(fit.shots.back().rms > 0.01);
  CHECK(fit.sigma == Approx(2e-3).epsilon(0.1));
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

TEST_CASE("what the shots cannot tell is held, and named", "[heavy]") {
  Random random(14);
  const Physics truth = random_table(random, carom_ball);
  const Filmed f = filmed(truth, {.shots = 6, .camera = {.rate = 60, .noise = 1e-3}, .bounces = false}, random);
  const Fit fit = bankshot::fit(f.recordings);
  for (const char* name : told_by_bounces) {
    INFO(name);
    CHECK(is_held(fit, name));
    CHECK(message_of(fit).find(name) != std::string::npos);
  }
  CHECK(std::abs(of(fit, "rolling_friction").value - coefficient(truth, "rolling_friction")) <
        5 * of(fit, "rolling_friction").error);
}

TEST_CASE("what another law's shots tell less of than a guess would is held in the end", "[heavy]") {
  for (const std::uint64_t seed : {31u, 32u, 33u, 34u}) {
    INFO("seed " << seed);
    Random random(seed);
    const Filmed f = filmed(random_table(random, carom_ball), {.shots = 5, .seconds = 3}, random);
    const Fit fit = bankshot::fit(f.recordings, {.model = "stronge"});
    const auto known = planning::coefficients_of(fit.physics, carom_ball, false);
    for (const FittedCoefficient& p : fit.parameters) {
      INFO(p.name << " " << p.value << " +- " << p.error);
      const auto guessed = std::ranges::find(known, p.name, &planning::Fittable::name);
      REQUIRE(guessed != known.end());
      CHECK(p.error < guessed->guess);
    }
  }
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

TEST_CASE("of all laws the one that predicts best what was left out is taken", "[heavy]") {
  Random random(23);
  Physics truth = random_table(random, carom_ball);
  truth.cushion = Stronge{0.037, 0.8, 0.3};
  const Filmed f = filmed(truth, {.shots = 3, .seconds = 1.5, .camera = {.rate = 50, .noise = 2e-4}}, random);
  std::vector<double> shares;
  const Fit fit = bankshot::fit(
      f.recordings, {.free = {"cushion.friction"}, .model = "any", .holdout = 2, .progress = [&](double share) {
                       shares.push_back(share);
                     }});
  REQUIRE(fit.models.size() == 4);
  const auto best = std::ranges::min_element(fit.models, {}, &ModelScore::predicted);
  CHECK(best->model.starts_with("stronge"));
  CHECK(std::holds_alternative<Stronge>(fit.physics.cushion));
  REQUIRE(fit.predictions.size() == 3);
  CHECK(median_rms(fit.predictions) == best->predicted);
  CHECK(median_rms(fit.shots) == best->fitted);
  CHECK(fit.model == best->model);
  CHECK(fit.seconds > 0);
  CHECK(std::ranges::is_sorted(shares));
  CHECK(shares.back() == 1);
  CHECK(message_of(fit).find("Cushions after stronge") != std::string::npos);
}

TEST_CASE("a ball that stands beside a cushion was not struck into it, though laws that are wrong would like that",
          "[heavy]") {
  Random random(19);
  const Physics truth = random_table(random, carom_ball);
  ShotRequest s{.table = preset_scene("carom-10ft").table, .physics = truth, .ball = preset_scene("carom-10ft").ball};
  const Vec2d size = s.table.highest();
  s.ball.at = {0.5, size.y - carom_ball.radius - 0.01};
  s.launch = {3.2, wrap_angle(-1.98)};
  s.spin = {.top = 0.4, .side = -0.6};
  s.until.time = 5;
  Recording r = film(s, simulate(s), {.rate = 50, .noise = 5e-4}, random);
  r.scene.physics.cushion = Han2005{0.037, 0.8, 0.1};
  const Fit fit = bankshot::fit(std::vector{r}, {.free = {"launch"}, .predict = true});
  CHECK(fit.shots[0].launch.angle == Approx(s.launch.angle).margin(0.05));
  REQUIRE(fit.predictions.size() == 1);
  CHECK(fit.predictions[0].samples > 100);
}

TEST_CASE("what two balls do to each other is learnt from the tracks of both") {
  Random random(20);
  Physics truth = random_table(random, carom_ball);
  truth.ball_ball = {0.9, 0.08};
  Filmed f;
  constexpr int shots = 8;
  for (int i = 0; i < shots; ++i) {
    Scene scene = preset_scene("carom-10ft");
    ShotRequest s{.table = scene.table, .physics = truth, .ball = scene.ball};
    s.ball.at = {0.8, 0.5};
    s.others = {{{1.3, 0.5 + 0.006 * (i - 4)}, carom_ball, "red"}};
    s.launch = {random.uniform(1, 2), 0};
    s.until.time = 1.5;
    f.recordings.push_back(film(s, simulate(s), {.rate = 60, .noise = 1e-4}, random));
    REQUIRE(f.recordings.back().tracks.size() == 2);
  }
  const Fit fit = bankshot::fit(f.recordings, {.free = {"ball_ball", "sliding_friction", "rolling_friction"}});
  for (const char* name : {"ball_ball.restitution", "ball_ball.friction"}) {
    INFO(name << " " << of(fit, name).value << " +- " << of(fit, name).error);
    CHECK(std::abs(of(fit, name).value - coefficient(truth, name)) < 5 * of(fit, name).error);
    CHECK(of(fit, name).value == Approx(coefficient(truth, name)).margin(0.02));
  }
  for (const FittedShot& shot : fit.shots) CHECK(shot.unexplained == 0);
}

TEST_CASE("places of rest alone tell the rolling friction of launches that are known") {
  Random random(21);
  Physics truth = random_table(random, carom_ball);
  Filmed f = filmed(truth, {.shots = 8, .seconds = forever, .camera = {.noise = 2e-3}}, random);
  for (std::size_t i = 0; i < f.recordings.size(); ++i) {
    Recording& r = f.recordings[i];
    r.scene.physics = truth;
    std::get<SlideRoll>(r.scene.physics.motion).rolling_friction = 0.9 * coefficient(truth, "rolling_friction");
    r.scene.launch = f.shots[i].launch, r.scene.spin = f.shots[i].spin, r.launch_given = true;
    r.tracks.front().samples.clear();
  }
  const Fit fit = bankshot::fit(f.recordings, {.free = {"rolling_friction"}});
  const FittedCoefficient& found = of(fit, "rolling_friction");
  const double true_one = coefficient(truth, "rolling_friction");
  INFO(found.value << " +- " << found.error << ", truth " << true_one);
  CHECK(std::abs(found.value - true_one) < 5 * found.error);
  CHECK(found.value == Approx(true_one).epsilon(0.05));
}

TEST_CASE("a camera that sees the table too large and shifted is learnt") {
  Random random(22);
  const Physics truth = random_table(random, carom_ball);
  Filmed f = filmed(truth, {.shots = 5, .seconds = 3, .camera = {.rate = 60, .noise = 5e-4}}, random);
  constexpr double scale = 1.004;
  const Vec2d shift{0.003, -0.002};
  const auto seen = [&](const Vec2d& at) { return at * scale + shift; };
  for (Recording& r : f.recordings) {
    r.scene.physics = truth;
    for (Track& track : r.tracks)
      for (Sample& s : track.samples) s.at = seen(s.at);
    if (r.tracks.front().rest) r.tracks.front().rest = seen(*r.tracks.front().rest);
    r.scene.ball.at = seen(r.scene.ball.at);
  }
  const Fit fit = bankshot::fit(f.recordings, {.free = {"camera"}});
  CHECK(std::abs(fit.camera_scale - scale) < 5 * of(fit, "camera.scale").error);
  CHECK(fit.camera_scale == Approx(scale).margin(5e-4));
  CHECK(norm(fit.camera_offset - shift) < 1e-3);
}

/// Compares derivatives of distances with the laws of `fitted` with differences with the laws of `exact_laws`, within a
/// fraction of the largest.
void compare_derivatives(const Physics& fitted, const Physics& exact_laws, double share) {
  using namespace bankshot::planning;
  Random random(18);
  const Physics& truth = fitted;
  const std::vector<std::string> names{"sliding_friction", "rolling_friction",    "spinning_friction",
                                       "cushion.friction", "cushion.restitution", "cushion.height"};
  const Filmed f = filmed(truth, {.shots = 6, .camera = {.rate = 60}}, random);
  std::vector<double> values;
  for (const std::string& name : names) values.push_back(coefficient(truth, name));
  for (std::size_t k = 0; k < f.shots.size(); ++k) {
    INFO("shot " << k);
    Seen seen(f.recordings[k], 1e-3);
    constexpr double early = 1e-3;  // s; no sample lies at the launch, where paths have a kink
    seen.launch = unknowns_of(f.shots[k], -early);
    Spent work;
    REQUIRE(tell(seen, {.base = truth, .names = names, .values = values}, work));
    const SeenCost cost(seen, names, truth), exact_cost(seen, names, exact_laws);
    const auto rows = static_cast<std::size_t>(cost.num_residuals());
    const auto at = [&](const LaunchUnknowns& launch, const std::vector<double>& v, double** jacobians) {
      std::vector<double> out(rows);
      const double* blocks[] = {launch.data(), v.data()};
      (jacobians ? cost : exact_cost).Evaluate(blocks, out.data(), jacobians);
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
      CHECK(worst <= share * largest);
    }
  }
}

TEST_CASE("distances have exact derivatives") {
  Random random(18);
  const Physics truth = random_table(random, carom_ball);
  constexpr double share = 1e-3;
  compare_derivatives(truth, truth, share);
  // Impacts that are integrated less exactly, as in fits, have the derivatives of exact ones.
  const Physics fitted = planning::with_laws(truth, {.model = "mathavan2010"}, carom_ball);
  Physics exact = fitted;
  planning::restore_tolerance(exact);
  REQUIRE(std::get<Mathavan2010>(fitted.cushion).tolerance > std::get<Mathavan2010>(exact.cushion).tolerance);
  constexpr double roughly = 3e-3;
  compare_derivatives(fitted, exact, roughly);
}

}  // namespace
