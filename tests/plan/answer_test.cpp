// SPDX-License-Identifier: MIT
//
// Tests what an answer says beyond the launch: why there is no shot, how robust a shot is, which of several is best.
#include <algorithm>
#include <utility>

#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "bankshot/scene/scene.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "planners/message.hpp"
#include "support/catch.hpp"
#include "support/claims.hpp"
#include "support/random_puzzle.hpp"

using namespace bankshot;

namespace {

Puzzle plain(Physics physics) {
  return {.table = rectangle_table(2, 1),
          .physics = std::move(physics),
          .ball = {.at = {0.4, 0.3}},
          .target = PointTarget{{1.5, 0.7}},
          .cushions = CushionRule::exactly(1)};
}

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Returns true when the launch makes a stop at the point: it rests within reach after the same cushions.
bool made(const Puzzle& p, const Shot& shot, double speed, double angle) {
  const auto& target = std::get<PointTarget>(p.target);
  const Trajectory t = simulate(
      ShotRequest{.table = p.table, .physics = p.physics, .ball = p.ball, .launch = {speed, wrap_angle(angle)}});
  return t.sequence() == shot.path.cushions && norm(t.events.back().state.at - target.at) <= target.within;
}

}  // namespace

TEST_CASE("a no-shot on a convex table without obstacles is certified, and says what failed") {
  Puzzle p = plain(ideal_physics());
  p.cushions = CushionRule::in_order({Contact::rail(0), Contact::rail(2), Contact::rail(0), Contact::rail(0)});
  const Answer a = solve(p);
  CHECK(a.status == Status::no_shot);
  CHECK(says(a.message, "certified"));
  REQUIRE(a.nearest);
  CHECK_FALSE(a.nearest->why.empty());
}

TEST_CASE("a bound that binds is named with the number that would open it") {
  Puzzle p = plain(rolling_physics());
  p.speed = {0.01, 0.2};
  const Answer a = solve(p);
  CHECK(a.status == Status::no_shot);
  CHECK(says(a.message, "needs"));
  CHECK(says(a.message, "0.2 m/s"));
  REQUIRE(a.nearest);
  CHECK(a.nearest->shot.verification.miss > 0);
  p.speed = {0.1, 10};
  p.angle = Range{0, 0.01};
  CHECK(says(solve(p).message, "aim"));
}

TEST_CASE("a pocket in the way is named") {
  Puzzle p{.table = rectangle_table(2, 1),
           .physics = ideal_physics(),
           .ball = {.at = {0.4, 0.5}},
           .target = PointTarget{{1.6, 0.5}},
           .cushions = CushionRule::exactly(0)};
  p.table.pockets = {{"hole", {1, 0.5}, 0.1}};
  const Answer a = solve(p);
  CHECK(a.status == Status::no_shot);
  CHECK(says(a.message, "falls into pocket hole"));
}

TEST_CASE("where the line through a pocket's centre has no room the shot is on the exact line beside it") {
  Puzzle p{.table = make_table(*find_table_preset("pool-9ft")),
           .physics = rolling_physics(),
           .ball = {.at = {0.635, 0.4}},
           .target = PocketTarget{5},
           .cushions = CushionRule::exactly(0),
           .arrive = Range{0.5, 0.5},
           .aim = Aim::centre};
  const Answer a = solve(p);
  REQUIRE(a.status == Status::solved);
  CHECK_FALSE(a.shots[0].verification.off_centre);
  CHECK(a.shots[0].verification.miss < 1e-9);
  CHECK(std::abs(a.shots[0].verification.offset) > 1e-3);
  CHECK_FALSE(says(a.message, "made off"));
  // With aims bounded towards the rail, only a part of the opening is left.
  p.angle = Range{a.shots[0].launch.angle + radians(0.05), radians(90)};
  const Answer beside = solve(p);
  REQUIRE(beside.status == Status::solved);
  CHECK(beside.shots[0].verification.off_centre);
  CHECK(says(beside.message, "off the exact line: there it needs an aim outside the bounds"));
}

TEST_CASE("into a pocket any arrival speed will do, and the shot of the largest value is the answer") {
  struct Bank {
    Vec2d ball;
    int pocket, cushions;
  };
  double gained = 0;
  for (const Bank& bank :
       {Bank{{0.635, 0.4}, 1, 2}, Bank{{1.9, 0.9}, 0, 1}, Bank{{2.2, 0.3}, 4, 1}, Bank{{0.5, 1.0}, 5, 0}}) {
    Scene scene = preset_scene("pool-9ft");
    Puzzle p{.table = scene.table, .physics = scene.physics, .ball = scene.ball};
    p.ball.at = bank.ball;
    p.target = PocketTarget{bank.pocket};
    p.cushions = CushionRule::exactly(bank.cushions);
    const Answer free = solve(p);
    REQUIRE(free.status == Status::solved);
    const Shot& best = free.shots[0];
    CHECK((best.path.arrival.speed >= 0.2 - 1e-9 && best.path.arrival.speed <= 3 + 1e-9));
    test::check_claims(p, free);
    for (const double speed : {0.2, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0}) {
      p.arrive = Range{speed, speed};
      const Answer a = solve(p);
      if (a.shots.empty()) continue;
      CAPTURE(bank.ball.x, bank.cushions, speed, *best.robustness.value, *a.shots[0].robustness.value);
      CHECK(*a.shots[0].robustness.value <= *best.robustness.value + 0.01);
      if (speed == 0.5) gained += *best.robustness.success - *a.shots[0].robustness.success;
    }
  }
  CHECK(gained > 0.1);  // otherwise nothing was chosen
}

TEST_CASE("a ball that passes the point on its way is as likely as it is") {
  // The shot with the largest margin arrives at a crawl; the shot with the largest success has passed the point
  // earlier.
  const Puzzle p = read_puzzle(R"({"table": {"length": 2.54, "width": 1.27, "pockets": "none"},
    "ball": {"at": [0.6800484348540151, 1.2328861295438833],
             "spin": {"top": 0.04016349286834631, "side": 0.5501743267156756}},
    "target": {"point": [0.3752395085952283, 1.1506604279625545]}, "arrive": {"speed": 0.014387817542625482}})");
  const double best = *solve(p, {.all = true}).shots.at(0).robustness.success;
  CHECK(best > 0.99);
  CHECK(*solve(p).shots.at(0).robustness.success > best - 0.005);
}

TEST_CASE("where jaws may turn a ball in, nothing is certified by straight lines") {
  // A shot by these cushions drops off the jaws; no line leads straight into the pocket.
  const Puzzle p = read_puzzle(R"({"table": "pool-8ft", "physics": "rolling",
    "ball": {"at": [0.5226075263862454, 0.09239981811862226]}, "target": {"pocket": "top-middle"},
    "cushions": ["bottom", "left", "bottom"], "arrive": {"speed": 2.0900407724829204}})");
  const Answer a = solve(p);
  CHECK_FALSE(says(a.message, "certified"));
  CHECK((a.status == Status::no_shot || a.shots.at(0).path.touches_jaws));
}

TEST_CASE("a margin ends before a narrow band that is not made") {
  // Between 2.967 and 2.995 m/s, 4 % of the way to the next end, the ball misses the pocket.
  const Puzzle p = read_puzzle(R"({"table": {"preset": "pool-8ft", "jaws": false}, "ball": {"at": [1.978, 0.073]},
    "target": {"pocket": "top-middle"}, "cushions": 3, "arrive": {"speed": 0.5}, "aim": "centre"})");
  const Answer a = solve(p);
  test::check_claims(p, a);
  CHECK(*a.shots.at(0).robustness.margin->speed[0] > -0.57);
}

TEST_CASE("a margin is where the shot stops being made") {
  test::Random random(21);
  int checked = 0;
  while (checked < 40) {
    Puzzle p = test::random_puzzle(random, test::Family::uniform, test::Model::rolling).puzzle;
    const auto range = arrival_range(p);
    if (!range || range->high > 0 || !p.table.pockets.empty()) continue;
    ++checked;
    const Answer a = solve(p);
    REQUIRE(a.status == Status::solved);
    const Shot& s = a.shots[0];
    REQUIRE(s.robustness.margin);
    for (const int side : {0, 1}) {
      INFO("side " << side << ", puzzle " << checked << " of seed 21");
      REQUIRE(s.robustness.margin->angle[static_cast<std::size_t>(side)]);
      REQUIRE(s.robustness.margin->speed[static_cast<std::size_t>(side)]);
      const double angle = *s.robustness.margin->angle[static_cast<std::size_t>(side)],
                   speed = *s.robustness.margin->speed[static_cast<std::size_t>(side)];
      CHECK(made(p, s, s.launch.speed, s.launch.angle + angle * (1 - 1e-5)));
      CHECK(!made(p, s, s.launch.speed, s.launch.angle + angle * (1 + 1e-5)));
      CHECK(made(p, s, s.launch.speed + speed * (1 - 1e-5), s.launch.angle));
      CHECK(!made(p, s, s.launch.speed + speed * (1 + 1e-5), s.launch.angle));
    }
  }
}

TEST_CASE("the condition is the derivative of the arrival") {
  test::Random random(22);
  int compared = 0;
  for (int i = 0; i < 100; ++i) {
    const Puzzle p = test::random_puzzle(random, test::Family::convex, test::Model::rolling).puzzle;
    const auto range = arrival_range(p);
    if (!range || range->high > 0) continue;
    const Answer a = solve(p, {.robustness = false});
    REQUIRE(a.status == Status::solved);
    const Shot& s = a.shots[0];
    const auto rest = [&](double speed, double angle) {
      return simulate(ShotRequest{
                          .table = p.table, .physics = p.physics, .ball = p.ball, .launch = {speed, wrap_angle(angle)}})
          .events.back()
          .state.at;
    };
    const double h = 1e-7;
    const double by_aim =
        norm(rest(s.launch.speed, s.launch.angle + h) - rest(s.launch.speed, s.launch.angle - h)) / (2 * h);
    const double by_speed =
        norm(rest(s.launch.speed * (1 + h), s.launch.angle) - rest(s.launch.speed * (1 - h), s.launch.angle)) / (2 * h);
    CHECK(s.verification.condition == Approx(std::max(by_aim, by_speed)).epsilon(1e-4));
    ++compared;
  }
  CHECK(compared > 20);
}

TEST_CASE("preferences choose: the softest is slowest, the quickest soonest") {
  Puzzle p = plain(rolling_physics());
  p.cushions = {.min = 0, .max = 3};
  p.arrive = Range{0.2, 1.5};
  const Answer all = solve(p, {.all = true, .robustness = false});
  CHECK(all.shots.size() > 8);
  p.prefer = Prefer::soft;
  const Shot soft = solve(p, {.robustness = false}).shots.at(0);
  p.prefer = Prefer::quick;
  const Shot quick = solve(p, {.robustness = false}).shots.at(0);
  for (const Shot& s : all.shots) {
    CHECK(soft.launch.speed <= s.launch.speed);
    CHECK(quick.path.arrival.time <= s.path.arrival.time);
  }
  CHECK(soft.path.arrival.speed == Approx(0.2));
  CHECK(quick.path.arrival.speed == Approx(1.5));
}

TEST_CASE("an aim into a cushion that the ball touches is offered like any other") {
  Puzzle p{.table = rectangle_table(2, 1),
           .physics = ideal_physics(),
           .ball = {.at = {0.4, 0.1}, .body = {.radius = 0.1}},
           .target = PointTarget{{1.5, 0.7}},
           .cushions = CushionRule::exactly(1)};
  const auto into = [](const Answer& a) {
    return std::ranges::count_if(a.shots, [](const Shot& s) { return s.launch.angle > radians(180); });
  };
  const Answer all = solve(p, {.all = true});
  CHECK(all.shots.size() > 2);
  CHECK(into(all) == 1);
  p.cushions = CushionRule::in_order({Contact::rail(0)});
  CHECK(into(solve(p)) == 1);
}

TEST_CASE("an answer warns when its condition leaves fewer digits than an exact shot needs") {
  const Puzzle p = plain(ideal_physics());
  const planning::SearchRequest request(p);
  planning::EvaluationBudget budget(budget_of(p));
  const planning::SearchResult found;
  Answer a{.status = Status::solved, .shots = {Shot{.verification = {.condition = 1e3}}}};
  CHECK(!says(planning::message(request, budget, found, a, 1), "digits"));
  a.shots[0].verification.digits = 8;
  CHECK(says(planning::message(request, budget, found, a, 1), "leaves 8 digits"));
  a.shots[0].verification.digits = 0;
  CHECK(says(planning::message(request, budget, found, a, 1), "up to rounding"));
}
