// SPDX-License-Identifier: MIT
//
// A trace, a discovered path and a simulation of one launch agree (stress/traced.cpp goes on with more), and count
// their work alike.
#include "planners/trace/trace.hpp"

#include <vector>

#include "bankshot/scene/scene.hpp"
#include "bankshot/simulate/simulator.hpp"
#include "bankshot/simulate/with_physics.hpp"
#include "planners/start.hpp"
#include "planners/trace/discover.hpp"
#include "planners/trace/real_legs.hpp"
#include "support/catch.hpp"
#include "support/random_balls.hpp"
#include "support/random_question.hpp"
#include "support/random_shot.hpp"
#include "support/traced.hpp"

namespace {

using namespace bankshot;
using namespace bankshot::planning;

Puzzle bank() {
  const Scene scene = preset_scene("carom-10ft");
  Puzzle p{.table = scene.table, .physics = scene.physics, .ball = scene.ball};
  p.ball.at = {0.5, 0.5};
  p.target = PointTarget{{1.5, 0.7}};
  p.cushions = CushionRule{0, 2, {}};
  return p;
}

/// Notes what a trace tells of its legs.
struct Notes {
  std::vector<std::size_t> arcs{}, meetings{};
  void arc(std::size_t leg, const Arc<double>&, double) { arcs.push_back(leg); }
  void met(std::size_t leg, const State<double>&) { meetings.push_back(leg); }
};

}  // namespace

TEST_CASE("a trace is where the simulation is, after each meeting of all balls and jaws") {
  const std::uint64_t seed = GENERATE(1, 2);
  CAPTURE(seed);
  test::TraceTally tally;
  Random random(seed);
  for (const test::ShotFamily family : test::shot_families)  // frozen balls may be held from the start, and add none
    for (int i = 0; i < 20; ++i)
      CHECK_THAT(test::differs_from_trace(test::random_shot(random, family), false, 8, tally), Catch::Equals(""));
  for (const test::BallFamily family : test::ball_families)
    for (int i = 0; i < 20; ++i)
      CHECK_THAT(test::differs_from_trace(test::random_balls(random, family), i % 2 == 0, 8, tally), Catch::Equals(""));
  CHECK(tally.meetings > 800);
}

TEST_CASE("what is discovered after each prefix of a branch, its trace says too") {
  const std::uint64_t seed = GENERATE(1, 2);
  CAPTURE(seed);
  test::TraceTally tally;
  Random random(seed);
  for (int i = 0; i < 100; ++i) {
    const auto question = test::random_question(random, {.most_balls = 1});
    const auto puzzle = test::valid_puzzle(question);
    const SearchRequest request(*puzzle);
    if (request.problem->objects) continue;  // an object ball goes on, and no path is discovered
    CAPTURE(question.dump());
    CHECK_THAT(test::differs_from_discovery(request, {random.log_uniform(0.2, 8), random.uniform(0, 6.28)}, tally),
               Catch::Equals(""));
  }
  CHECK(tally.meetings > 60);
}

TEST_CASE("an observer sees each leg in order, and the work is counted as the simulator counts it") {
  const Puzzle p = bank();
  const SearchRequest request(p);
  const Launch launch{3, radians(50)};
  EvaluationBudget budget(10);
  Discovery path;
  discover(request, budget, launch, false, path);
  REQUIRE(path.route.size() == 2);
  const Work discovered = budget.work();
  with_physics(p.physics, [&](const auto& motion, const auto& cushion) {
    Notes notes;
    Work work;
    const Destination to{p.ball.body, {1.5, 0.7}, 0, false};
    const auto arrival = trace(request.problem->balls(), motion, cushion, std::span<const Meeting>(path.route),
                               start_of(request, launch), to, work, notes);
    REQUIRE(arrival);
    CHECK(std::ranges::is_sorted(notes.arcs));
    CHECK(notes.arcs.back() == 2);
    CHECK(notes.meetings == std::vector<std::size_t>{0, 1});
    CHECK(work.impacts == 2);
    Simulator sim(request.problem->boundary, motion, cushion, start_of(request, launch));
    Work simulated;
    int legs = 0;
    each_leg(
        sim, simulated, [&] { return legs < 2; }, [&](const Event&) { return ++legs < 2; });
    CHECK(simulated.impacts == 2);
    CHECK(simulated.arcs <= work.arcs);
  });
  CHECK(discovered.impacts == 2);
}

TEST_CASE("a leg that leads nowhere ends a trace, or is passed over") {
  const Puzzle p = bank();
  const SearchRequest request(p);
  const Route away = route_by(std::vector{Contact::rail(0), Contact::rail(0)});
  with_physics(p.physics, [&](const auto& motion, const auto& cushion) {
    Work work;
    const Destination to{p.ball.body, {1.5, 0.7}, 0, false};
    const auto start = start_of(request, Launch{3, radians(50)});
    const std::span<const Meeting> meetings(away);
    CHECK(!trace(request.problem->balls(), motion, cushion, meetings, start, to, work));
    Notes notes;
    const auto passed =
        trace(request.problem->balls(), motion, cushion, meetings, start, to, work, notes, LostLeg::is_passed_over);
    REQUIRE(passed);
    CHECK(!passed->complete);
    CHECK(notes.meetings.size() == 2);
  });
}
