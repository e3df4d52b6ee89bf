// SPDX-License-Identifier: MIT
//
// The parts of a fit, each on shots whose truth is known: paths along given contacts, the noise of a camera, wrong
// samples, residuals and their derivatives, launches, what observations tell, predictions, and a player's errors.
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include "bankshot/scene/coefficients.hpp"
#include "planners/learn/goodness.hpp"
#include "planners/learn/launch.hpp"
#include "planners/learn/learn.hpp"
#include "planners/learn/least_squares.hpp"
#include "planners/learn/outliers.hpp"
#include "planners/learn/player.hpp"
#include "planners/learn/predict.hpp"
#include "planners/learn/seen.hpp"
#include "planners/learn/way.hpp"
#include "support/catch.hpp"
#include "support/filmed.hpp"

using namespace bankshot;
using namespace bankshot::planning;
using bankshot::test::Filmed;
using bankshot::test::filmed;

namespace {

constexpr std::uint64_t seed = 94;

/// Returns the shots of one table.
Filmed shots_of(int count, const Camera& camera) {
  Random random(seed);
  const Physics truth = test::random_table(random, Body{});
  return filmed(truth, {.shots = count, .seconds = 3, .camera = camera}, random);
}

Common true_table(const Filmed& f) {
  const auto known = coefficients_of(f.truth, f.shots.front().ball.body, false);
  return {.base = f.truth, .known = known};
}

/// Returns a nearly normal number of mean 0 and variance 1: the sum of twelve even ones.
double normal(Random& random) {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += random.uniform(0, 1);
  return sum;
}

/// Sets the launch with which the shot was filmed.
void set_true_launch(Seen& seen, const Common& common, const ShotRequest& shot) {
  seen.launch = unknowns_of(shot, 0);
  Spent work;
  REQUIRE(tell(seen, common, work));
}

}  // namespace

TEST_CASE("the median is the middle value, the upper one of two") {
  CHECK(median({}) == 0);
  CHECK(median({7}) == 7);
  CHECK(median({3, 1, 2}) == 2);
  CHECK(median({4, 1, 3, 2}) == 3);
}

TEST_CASE("a path along the contacts of a simulated shot is that shot") {
  const Filmed f = shots_of(6, {});
  int places = 0, contacts = 0;
  for (const ShotRequest& shot : f.shots) {
    const Trajectory t = simulate(shot);
    const Told told = told_of(t, 0, forever);
    CHECK(told.until == forever);
    CHECK(told.before.empty());
    CHECK(told.route.size() == t.sequence().size());
    contacts += static_cast<int>(told.route.size());
    const Stand stand(shot);
    const auto way = way_of(stand, shot.physics.ball_ball, std::get<SlideRoll>(shot.physics.motion),
                            std::get<Han2005>(shot.physics.cushion), told, start_state(shot), forever);
    sample(shot, t, 20, [&](double time, int, const State<double>& s) {
      CHECK(norm(way.at(time) - s.at) < 1e-9);
      ++places;
    });
    CHECK(way.at(-1) == shot.ball.at);  // it stands before the launch
  }
  CHECK(places > 200);
  CHECK(contacts > 5);
}

TEST_CASE("a ball that the cue ball hits is followed from where it stood, up to its next contact with a ball") {
  ShotRequest shot{.table = rectangle_table(3, 2), .ball = {.at = {0.5, 1}}, .launch = {1.5, 0}};
  shot.others = {{{1.2, 1}, shot.ball.body, "1"}, {{2.2, 1}, shot.ball.body, "2"}};
  const Trajectory t = simulate(shot);
  const Told first = told_of(t, 1, forever), second = told_of(t, 2, forever);
  CHECK(first.before == Route{{0, Contact::ball(1)}});
  const auto meets = std::ranges::find_if(
      t.events, [](const Record& e) { return e.kind == EventKind::ball && e.ball == 1 && e.contact.index == 2; });
  REQUIRE(meets != t.events.end());
  CHECK(first.until == meets->time);
  CHECK(second.until <= meets->time);  // it was not the cue ball that sent it
  const Stand stand(shot);
  CHECK(stand.others().size() == 2);
  const auto way = way_of(stand, shot.physics.ball_ball, std::get<Rolling>(shot.physics.motion),
                          std::get<Mirror>(shot.physics.cushion), first, start_state(shot), forever);
  sample(shot, t, 20, [&](double time, int ball, const State<double>& s) {
    if (ball == 1 && time < first.until) CHECK(norm(way.at(time) - s.at) < 1e-9);
  });
}

TEST_CASE("the noise of a camera is found from neighbours, whatever is displaced") {
  for (const double noise : {5e-4, 2e-3})
    for (const double outliers : {0.0, 0.05}) {
      const Filmed f = shots_of(8, {.noise = noise, .outliers = outliers});
      Recordings all;
      for (const Recording& r : f.recordings) all.push_back(&r);
      INFO(noise << ", " << outliers);
      CHECK(noise_of(all) == Approx(noise).epsilon(0.15));
    }
  Recording still;
  still.tracks.resize(1);
  CHECK(noise_of({&still}) == 1e-3);  // no samples: the usual noise
}

TEST_CASE("a sample that lies apart is marked, before and after the fit, and its neighbours are not") {
  Filmed f = shots_of(1, {.noise = 1e-3});
  Recording& r = f.recordings.front();
  std::vector<Sample>& samples = r.tracks.front().samples;
  REQUIRE(samples.size() > 60);
  const std::size_t wrong[] = {20, 41};
  for (const std::size_t i : wrong) samples[i].at += {0.12, -0.07};
  const Common common = true_table(f);
  Seen seen(r, 1e-3);
  mark_apart(seen);
  for (const std::size_t i : wrong) CHECK(seen.outlier[0][i]);
  CHECK(std::ranges::count(seen.outlier[0], 1) <= 4);
  set_true_launch(seen, common, f.shots.front());
  mark_outliers(seen, common);
  for (const std::size_t i : wrong) CHECK(seen.outlier[0][i]);
  CHECK(std::ranges::count(seen.outlier[0], 1) <= 4);
  const Distances off = distances(seen, common);
  CHECK(off.outliers == std::ranges::count(seen.outlier[0], 1));
  CHECK(off.each[wrong[0]] == Approx(std::hypot(0.12, 0.07)).margin(5e-3));
  CHECK(off.rms == Approx(1e-3 * std::sqrt(2.0)).epsilon(0.2));
}

TEST_CASE("the true launch fits as well as the noise allows, and another does not") {
  const Filmed f = shots_of(4, {.noise = 2e-3});
  const Common common = true_table(f);
  for (std::size_t i = 0; i < f.shots.size(); ++i) {
    Seen seen(f.recordings[i], 2e-3);
    set_true_launch(seen, common, f.shots[i]);
    CHECK(excess(seen, common) == Approx(1).margin(0.15));
    CHECK(spread(seen, common) == Approx(1).margin(0.35));
    CHECK(!is_off(seen, common));
    seen.launch[angle] += 0.05;
    CHECK(is_off(seen, common));
    seen.robust = 2.5;
    CHECK(is_off(seen, common));
  }
}

TEST_CASE("samples count inside the window alone") {
  const Filmed f = shots_of(1, {});
  Seen seen(f.recordings.front(), 1e-3);
  const auto& samples = f.recordings.front().tracks.front().samples;
  CHECK(seen.samples_used() == static_cast<int>(samples.size()));
  CHECK(seen.last == samples.back().time);
  seen.window = samples[10].time;
  CHECK(seen.followed(0) == 11);
  seen.outlier[0][3] = 1;
  CHECK(seen.samples_used() == 10);
}

TEST_CASE("residuals vanish at the truth, and their derivatives agree with differences") {
  const Filmed f = shots_of(2, {});
  Common common = true_table(f);
  for (const char* name : {"sliding_friction", "cushion.restitution"}) common.add(name);
  for (std::size_t k = 0; k < common.names.size(); ++k) common.values[k] = test::coefficient(f.truth, common.names[k]);
  Seen seen(f.recordings.front(), 1e-3);
  set_true_launch(seen, common, f.shots.front());
  const SeenCost cost(seen, common.names, common.base);
  const auto rows = static_cast<std::size_t>(cost.num_residuals()),
             samples = 2 * static_cast<std::size_t>(seen.samples_used());
  REQUIRE(rows >= samples);
  const auto residuals = [&](const LaunchUnknowns& launch, const std::vector<double>& values) {
    std::vector<double> out(rows);
    const double* blocks[] = {launch.data(), values.data()};
    REQUIRE(cost.Evaluate(blocks, out.data(), nullptr));
    return out;
  };
  const auto at_truth = residuals(seen.launch, common.values);
  for (std::size_t i = 0; i < samples; ++i) CHECK(std::abs(at_truth[i]) < 1e-5);  // in units of 1 mm
  std::vector<double> by_launch(rows * launch_size), by_values(rows * common.values.size()), ignored(rows);
  const double* blocks[] = {seen.launch.data(), common.values.data()};
  double* jacobians[] = {by_launch.data(), by_values.data()};
  REQUIRE(cost.Evaluate(blocks, ignored.data(), jacobians));
  const auto agrees = [&](const std::vector<double>& more, const std::vector<double>& less, double h,
                          const std::vector<double>& exact, std::size_t column, std::size_t columns) {
    double scale = 0;
    for (std::size_t i = 0; i < rows; ++i) scale = std::max(scale, std::abs(exact[i * columns + column]));
    long off = 0;
    for (std::size_t i = 0; i < rows; ++i)
      off += std::abs((more[i] - less[i]) / (2 * h) - exact[i * columns + column]) > 1e-3 * scale;
    return off <= static_cast<long>(rows / 20);  // a sample at a bounce has a kink
  };
  constexpr double h = 1e-6;
  for (std::size_t k = 0; k < launch_size; ++k) {
    LaunchUnknowns more = seen.launch, less = seen.launch;
    more[k] += h, less[k] -= h;
    INFO("unknown " << k << " of the launch");
    CHECK(agrees(residuals(more, common.values), residuals(less, common.values), h, by_launch, k, launch_size));
  }
  for (std::size_t k = 0; k < common.values.size(); ++k) {
    std::vector<double> more = common.values, less = common.values;
    more[k] += h, less[k] -= h;
    INFO(common.names[k]);
    CHECK(agrees(residuals(seen.launch, more), residuals(seen.launch, less), h, by_values, k, common.values.size()));
  }
}

TEST_CASE("a launch beside the true one is led to it") {
  const Filmed f = shots_of(3, {});
  const Common common = true_table(f);
  for (std::size_t i = 0; i < f.shots.size(); ++i) {
    Seen seen(f.recordings[i], 1e-3);
    set_true_launch(seen, common, f.shots[i]);
    const LaunchUnknowns truth = seen.launch;
    seen.launch[speed] *= 1.02;
    seen.launch[angle] += 5e-3;
    Spent work;
    const double off = solve_launch(seen, common, work);
    INFO("shot " << i);
    CHECK(work.simulations > 0);
    CHECK(off < 0.5);
    CHECK(seen.launch[speed] == Approx(truth[speed]).epsilon(4e-3));  // the prior of the spin pulls a little
    CHECK(seen.launch[angle] == Approx(truth[angle]).margin(1e-3));
  }
}

TEST_CASE("the covariance of coefficients is the inverse of what the shots tell of them") {
  const Filmed f = shots_of(6, {.noise = 1e-3});
  Common common = true_table(f);
  for (const char* name : {"sliding_friction", "rolling_friction", "cushion.restitution"}) common.add(name);
  for (std::size_t k = 0; k < common.names.size(); ++k) common.values[k] = test::coefficient(f.truth, common.names[k]);
  Shots shots;
  for (std::size_t i = 0; i < f.shots.size(); ++i)
    set_true_launch(shots.emplace_back(f.recordings[i], 1e-3), common, f.shots[i]);
  const Eigen::MatrixXd told = information(shots, common), spread_of = covariance(shots, common);
  REQUIRE(told.rows() == 3);
  CHECK((told - told.transpose()).norm() < 1e-9 * told.norm());
  CHECK((told * spread_of - Eigen::MatrixXd::Identity(3, 3)).norm() < 1e-4);
  // A shot that is left out tells nothing.
  shots.front().left_out = true;
  const Eigen::MatrixXd less = information(shots, common);
  for (Eigen::Index k = 0; k < 3; ++k) CHECK(less(k, k) <= told(k, k));
  // The launch's own information is that of its derivatives: positive along every unknown.
  const auto launch = launch_information(shots.back(), common);
  for (Eigen::Index k = 0; k < launch_size; ++k) CHECK(launch(k, k) > 0);
  const double at_truth = unlikelihood(shots.back(), common);
  shots.back().launch[angle] += 0.02;
  CHECK(unlikelihood(shots.back(), common) > at_truth);
}

TEST_CASE("a table is learnt, and predicts a shot that it was not taught", "[heavy]") {
  const Filmed f = shots_of(7, {.noise = 1e-3});
  Recordings taught;
  for (const Recording& r : f.recordings) taught.push_back(&r);
  const Recording* const unseen = taught.back();
  taught.pop_back();
  Asked asked{.base = f.recordings.front().scene.physics, .names = {"rolling_friction", "cushion.restitution"}};
  asked.base = f.truth;
  *coefficient(asked.base, "rolling_friction").at(0) *= 1.3;
  *coefficient(asked.base, "cushion.restitution").at(0) *= 0.95;
  Spent work;
  double done = 0;
  const Learnt learnt = learn(taught, asked, work, [&](double share) {
    CHECK(share >= done);
    done = share;
  });
  CHECK(done <= 1);
  CHECK(learnt.noise == Approx(1e-3).epsilon(0.2));
  CHECK(!learnt.astray);
  REQUIRE(learnt.common.names.size() == 2);
  for (std::size_t k = 0; k < 2; ++k) {
    INFO(learnt.common.names[k]);
    CHECK(learnt.common.values[k] == Approx(test::coefficient(f.truth, learnt.common.names[k])).epsilon(0.02));
  }
  const Prediction rest = predict(*unseen, learnt.common, learnt.noise, work);
  CHECK(rest.samples > 20);
  CHECK(rest.rms < 0.05);
}

TEST_CASE("a player's errors are those of launches that are known exactly") {
  constexpr double sigma[] = {0.5, 2}, bias[] = {0.3, -1};  // of angle and speed, in usual errors
  constexpr int attempts = 400;
  Random random(seed);
  std::vector<Evidence> evidence(attempts);
  Eigen::Vector2d sum = Eigen::Vector2d::Zero(), square = Eigen::Vector2d::Zero();
  const double by_speed = 2 * 0.02 / usual_error()(1);  // a bias of 2 % at 2 m/s, in usual errors of the speed
  for (Evidence& e : evidence) {
    e.error.measured = true;
    e.meant_speed = 2;
    constexpr double exactly = 1e8;
    for (int k = 0; k < 2; ++k) {
      const double off = normal(random) * sigma[k] + bias[k] * (k == 1 ? by_speed : 1);
      e.information(k, k) = exactly;
      e.gradient(k) = exactly * off;
      sum(k) += off, square(k) += off * off;
    }
  }
  const auto errors = errors_of(evidence);
  REQUIRE(errors.size() == 2);
  for (int k = 0; k < 2; ++k) {
    const PlayerError& e = errors[static_cast<std::size_t>(k)];
    INFO(e.name);
    const double mean = sum(k) / attempts, deviation = std::sqrt(square(k) / attempts - mean * mean);
    CHECK(e.sigma == Approx(deviation * usual_error()(k)).epsilon(0.01));
    CHECK(e.bias_is_told);
    CHECK(e.bias == Approx(k == 0 ? mean * usual_error()(0) : mean / by_speed * 0.02).epsilon(0.01));
    CHECK(e.sigma_interval.contains(sigma[k] * usual_error()(k)));
    CHECK(e.sigma_interval.contains(e.sigma));
  }
}

TEST_CASE("an attempt far from all others is left out of a player's errors") {
  Random random(seed);
  std::vector<Evidence> evidence(60);
  for (Evidence& e : evidence) {
    e.error.measured = true;
    e.meant_speed = 2;
    for (int k = 0; k < 2; ++k) e.information(k, k) = 1e6, e.gradient(k) = 1e6 * normal(random);
  }
  evidence[7].gradient(0) = 1e6 * 40;
  const auto errors = errors_of(evidence);
  CHECK(evidence[7].error.left_out);
  CHECK(std::ranges::count_if(evidence, [](const Evidence& e) { return e.error.left_out; }) == 1);
  CHECK(errors[0].sigma == Approx(usual_error()(0)).epsilon(0.3));
}
