// SPDX-License-Identifier: MIT
//
// First-order results of a shot, compared with plays beside it and with closed forms of rolling balls.
#include "planners/evaluate/first_order.hpp"

#include <cmath>
#include <functional>

#include "bankshot/numbers/random.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "planners/evaluate/real_arrival.hpp"
#include "planners/solve/newton.hpp"
#include "support/bank.hpp"
#include "support/catch.hpp"
#include "support/flight.hpp"
#include "support/played.hpp"
#include "support/proved.hpp"
#include "support/straight.hpp"

using namespace bankshot;
using namespace bankshot::planning;

namespace {

constexpr double slowing = 2 * 0.01 * 9.81;  // m/s²; twice the deceleration of a roll

double below(double z) { return std::erfc(-z / std::sqrt(2.0)) / 2; }

/// Returns the exact launch of a bank near a launch.
Launch root_of(const SearchRequest& request, const Launch& near) {
  EvaluationBudget budget(1000);
  const auto root = newton({request, *request.route, request.problem->aim_points[0]}, budget, near, settings::wide);
  REQUIRE(root);
  return *root;
}

/// Compares the derivatives of a shot with central differences of an arrival [m].
void compare(const Shot& shot, const std::function<Vec2d(const Launch&)>& arrival) {
  constexpr double step = 1e-6;
  const auto by = [&](double aim, double speed) {
    const Launch less{shot.launch.speed - speed, shot.launch.angle - aim},
        more{shot.launch.speed + speed, shot.launch.angle + aim};
    return (arrival(more) - arrival(less)) / (2 * step);
  };
  const Verification& v = shot.verification;
  const Vec2d by_angle = by(step, 0), by_speed = by(0, step);
  CHECK(v.by_angle.x == Approx(by_angle.x).epsilon(1e-4).margin(1e-6));
  CHECK(v.by_angle.y == Approx(by_angle.y).epsilon(1e-4).margin(1e-6));
  CHECK(v.by_speed.x == Approx(by_speed.x).epsilon(1e-4).margin(1e-6));
  CHECK(v.by_speed.y == Approx(by_speed.y).epsilon(1e-4).margin(1e-6));
  CHECK(v.condition == Approx(std::max(norm(by_angle), norm(by_speed) * shot.launch.speed)).epsilon(1e-4));
}

/// Returns a puzzle in which a rolling ball sends ball 1 along a line past a point.
Puzzle sent() {
  Puzzle p{.table = rectangle_table(4, 2), .physics = rolling_physics(), .ball = {.at = {0.5, 1}}};
  p.others = {{{1.5, 1.02}, p.ball.body, "1"}};
  p.target = ObjectBallTarget{{1}, {.target = PointTarget{{2.4, 1.3}, 0.1}}};
  p.arrive = Range{0.3, 0.3};
  p.cushions = CushionRule::exactly(0);
  return p;
}

Launch onto_ghost(const Puzzle& p, double speed) {
  const Vec2d object = p.others[0].at, way = Vec2d{2.4, 1.3} - object,
              to = object - way * (2 * p.ball.body.radius / norm(way)) - p.ball.at;
  return {speed, std::atan2(to.y, to.x)};
}

}  // namespace

TEST_CASE("a rest moves with aim and speed as plays beside the shot show") {
  Puzzle p = test::bank();
  p.arrive = Range{0, 0};
  const SearchRequest request(p);
  Shot shot = test::shot_of(request, root_of(request, test::near_bank(0.95)));
  Work work;
  add_first_order(request, shot, work);
  compare(shot, [&](const Launch& l) { return *test::played(p, l, p.spin)[0]; });
}

TEST_CASE("the success of a straight pass is that of its angle, and of lines beside it likewise") {
  Puzzle p = test::straight();
  const double within = 0.03, error = GENERATE(0.01, 0.03, 0.1);
  CAPTURE(error);
  p.target = PointTarget{{1.5, 0.5}, within};
  p.noise = {.angle = error, .speed = 0};
  const SearchRequest request(p);
  const Launch exact{std::sqrt(0.25 + slowing), 0};
  Shot shot = test::shot_of(request, exact);
  Work work;
  add_first_order(request, shot, work);
  const double expected = std::erf(within / error / std::sqrt(2));
  CHECK(shot.robustness.success_estimate == Approx(expected).margin(5e-3));
  CHECK(shot.robustness.first_order == Approx(within / error));
  EvaluationBudget budget(10);
  const Branch aim{request, {}, request.problem->aim_points[0]};
  CHECK(success_on_aim_point(aim, exact, linearise(aim, budget, exact).value()) == Approx(expected));
  const auto limits = limits_of(aim, exact, p.noise, work);
  REQUIRE(limits);
  CHECK(limits->hold());
  CHECK(limits->until({1, 0}) == Approx(within / error));
  const Launch beside{exact.speed, 0.02};
  CHECK(estimate_of_passing(request, aim.aim_point, beside, linearise(aim, budget, beside).value()) ==
        Approx(below((within - 0.02) / error) - below((-within - 0.02) / error)).margin(1e-3));
  CHECK(!limits_of(aim, {exact.speed, 0.04}, p.noise, work)->hold());
}

TEST_CASE("the success of a rest is at least that of its disc, and at most that of its strip") {
  Puzzle p = test::straight();
  p.target = PointTarget{{1.5, 0.5}, 0.05};
  p.arrive = Range{0, 0};
  p.noise = {.angle = 0.04, .speed = 0.01};
  const SearchRequest request(p);
  const Launch exact{std::sqrt(slowing), 0};
  EvaluationBudget budget(1);
  const Branch aim{request, {}, request.problem->aim_points[0]};
  // The place of rest is the square of the launch speed, so its deviation is twice that of the speed, as a share.
  const double across = 0.04, along = 2 * 0.01 / exact.speed, reach = 0.05;
  const double found = success_on_aim_point(aim, exact, linearise(aim, budget, exact).value());
  CHECK(found == Approx(std::erf(reach / across / std::sqrt(2)) * std::erf(reach / along / std::sqrt(2))));
  Shot shot = test::shot_of(request, exact);
  Work work;
  add_first_order(request, shot, work);
  constexpr std::uint64_t seed = 4;
  Random random(seed);
  int made = 0;
  constexpr int draws = 20000;
  for (int i = 0; i < draws; ++i) {
    const double size = std::sqrt(-2 * std::log(1 - random.uniform(0, 1))), turn = random.uniform(0, radians(360));
    made += std::hypot(size * std::cos(turn) * across, size * std::sin(turn) * along) < reach;
  }
  INFO("seed " << seed);
  CHECK(shot.robustness.success_estimate == Approx(static_cast<double>(made) / draws).margin(0.012));
  CHECK(found >= shot.robustness.success_estimate - 2e-3);
}

TEST_CASE("a ball that is sent on arrives as plays beside the shot show, on its real path as well") {
  const Puzzle p = sent();
  const SearchRequest request(p);
  Shot shot = test::shot_of(request, onto_ghost(p, 1.5));
  // Once it is hit, the ball rolls straight on; its line passes nearest to the point there.
  const auto nearest = [&](const Launch& launch) {
    const Trajectory t = simulate({{}, p.table, p.physics, p.ball, p.others, launch, {}, {}});
    const auto hit = std::ranges::find(t.events, EventKind::ball, &Record::kind);
    const Vec2d u = hit->other.velocity / norm(hit->other.velocity), to = Vec2d{2.4, 1.3} - hit->other.at;
    return hit->other.at + u * dot(u, to);
  };
  Work work;
  const auto moved = real_arrival(request, shot, work);
  REQUIRE(moved);
  Shot real = shot;
  real.verification.by_angle = moved->by_angle;
  real.verification.by_speed = moved->by_log_speed / shot.launch.speed;
  real.verification.condition = std::max(norm(moved->by_angle), norm(moved->by_log_speed));
  compare(real, nearest);
  const Puzzle roll = test::straight();
  const SearchRequest alone(roll);
  CHECK(!real_arrival(alone, test::shot_of(alone, {std::sqrt(0.25 + slowing), 0}), work));
  shot.path.arrival.time = 20;  // by then it has met the right rail
  CHECK(!real_arrival(request, shot, work));
}

// Its derivatives are those of the miss, which has the other sign.
TEST_CASE("a pass moves with aim and speed as plays beside the shot show") {
  const Puzzle p = test::bank();
  const SearchRequest request(p);
  Shot shot = test::shot_of(request, root_of(request, test::near_bank(1.9)));
  Work work;
  add_first_order(request, shot, work);
  const Trajectory t = simulate(as_request(p, shot));
  const Vec2d v = t.events.back().state.velocity, left = perpendicular(v) / norm(v);
  // The line moves to its left by what its point comes to lie less to the left of it.
  compare(shot, [&](const Launch& l) { return left * -test::fly(test::Aimed(p), l, p.spin, 10).passes[0].beside; });
}

// The wrong sign of the derivatives turns the aim away from the middle.
TEST_CASE("the middle of its target gives a shot beside it the estimate of a shot in the middle") {
  Puzzle p = test::straight();
  p.target = PointTarget{{1.5, 0.5}, 0.06};
  p.noise = {.angle = 0.04, .speed = 0};
  const SearchRequest request(p);
  Shot shot = test::shot_of(request, {std::sqrt(0.25 + slowing), 0.03});
  Work work;
  add_first_order(request, shot, work);
  CHECK(shot.robustness.success_estimate == Approx(below(0.03 / 0.04) - below(-0.09 / 0.04)).margin(5e-3));
  CHECK(estimate_in_middle(request, shot, work) == Approx(std::erf(0.06 / 0.04 / std::sqrt(2))).margin(5e-3));
}

// It also turns a pot on its exact line away from the middle of the pocket's gap.
TEST_CASE("the middle of a pocket's gap is half way between the aims that just fall") {
  Puzzle p{.table = rectangle_table(2, 1), .physics = rolling_physics(), .ball = {.at = {1.2, 0.85}}};
  p.table.pockets = {{"corner", {2, 1}, 0.06}};
  p.target = PocketTarget{0};
  p.cushions = CushionRule::in_order({});
  p.arrive = Range{0.8, 0.8};
  p.noise = {.angle = 0.02, .speed = 0};
  const SearchRequest request(p);
  Shot shot = test::shot_of(request, root_of(request, {1.2, std::atan2(0.13, 0.8)}));
  const auto falls = [&](double aim) {
    const Trajectory t = simulate({{}, p.table, p.physics, p.ball, {}, {shot.launch.speed, aim}, {}, {}});
    return t.end == EventKind::pocket && t.cushions == 0;
  };
  const auto edge = [&](double way) {
    double aim = shot.launch.angle;
    while (falls(aim)) aim += way * 1e-5;
    return aim;
  };
  Work work;
  add_first_order(request, shot, work);
  CHECK(estimate_in_middle(request, shot, work) ==
        Approx(std::erf((edge(1) - edge(-1)) / 2 / p.noise.angle / std::sqrt(2))).margin(0.01));
}
