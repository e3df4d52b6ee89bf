// SPDX-License-Identifier: MIT
//
// Shots that set other balls going, up to the target and until every ball rests.
#include <cmath>

#include "bankshot/numbers/random.hpp"
#include "bankshot/scene/scene.hpp"
#include "planners/verify/aftermath.hpp"
#include "planners/verify/set_going.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::planning;

namespace {

/// Returns a puzzle in which ball 1 is to come to rest on a point, straight behind it.
Puzzle straight(double distance) {
  Puzzle p{.table = rectangle_table(6, 2), .physics = rolling_physics(), .ball = {.at = {0.5, 1}}};
  p.others = {{{2, 1}, p.ball.body, "1"}};
  Then then;
  then.target = PointTarget{{2 + distance, 1}, 0.01};
  p.target = ObjectBallTarget{.balls = {1}, .then = then};
  p.arrive = Range{0, 0};
  return p;
}

/// Follows the shot from a contact in which the cue ball moves along `heading` at this speed.
Replay sent(const Puzzle& p, double speed, const Vec2d& heading = {1, 0}) {
  const SearchRequest request(p);
  const Goal goal = Goal::of(request, Demand::made);
  const Objects::Chain* const chain = request.problem->objects->chain_by(1);
  REQUIRE(chain);
  Replay out;
  const Vec2d at = p.others[0].at - Vec2d{2 * p.ball.body.radius, 0};
  SetGoing going(request, std::get<Rolling>(p.physics.motion), std::get<Mirror>(p.physics.cushion), *chain, goal,
                 SequenceCheck(nullptr), out);
  going.run({at, heading * speed, {}}, 1.5);
  return out;
}

}  // namespace

TEST_CASE("an object ball that is hit full goes straight to its point") {
  constexpr double distance = 1.25;
  const Puzzle p = straight(distance);
  const double a = deceleration(p.physics), e = p.physics.ball_ball.restitution;
  const double leaves = std::sqrt(2 * a * distance), speed = 2 * leaves / (1 + e);
  const Replay r = sent(p, speed);
  REQUIRE(r.made);
  CHECK(r.miss < 1e-9);
  CHECK(r.path.arrival.time == Approx(1.5 + leaves / a).epsilon(1e-9));
  CHECK(norm(r.path.arrival.at - Vec2d{2 + distance, 1}) < 1e-9);
  REQUIRE(r.path.hits.size() == 1);
  CHECK(r.path.hits[0].ball == 1);
  CHECK(r.path.hits[0].cut == Approx(0).margin(1e-12));
  CHECK(r.path.hits[0].speed == Approx(speed));
  REQUIRE(r.path.then.size() == 1);
  CHECK(r.path.then[0].cushions.empty());
}

TEST_CASE("a ball that stops short, or meets a cushion that is not asked, fails for that reason") {
  const Puzzle p = straight(1.25);
  const double leaves = std::sqrt(2 * deceleration(p.physics) * 1.25);
  const Replay slow = sent(p, leaves);  // restitution takes too much
  CHECK(!slow.made);
  CHECK(slow.failure.reason == FailureReason::missed);
  CHECK(slow.miss > 0.01);
  const Replay fast = sent(p, 4);
  CHECK(!fast.made);
  CHECK(fast.failure.reason == FailureReason::extra_cushion);
  CHECK(fast.failure.contact == Contact::rail(1));
}

TEST_CASE("the aftermath is the end of the whole shot as the simulator plays it") {
  const Scene scene = preset_scene("pool-9ft", "rolling");
  Puzzle p{.table = scene.table, .physics = scene.physics, .ball = {.at = {0.9, 0.6}, .body = scene.ball.body}};
  p.others = {{{1.6, 0.7}, scene.ball.body, "8"}};
  p.target = BallTarget{.balls = {1}};
  const SearchRequest request(p);
  Random r(91);
  int scratches = 0;
  for (int i = 0; i < 100; ++i) {
    const Launch launch{r.uniform(0.5, 5), r.uniform(0, radians(360))};
    EvaluationBudget budget(10);
    Shot shot{.launch = launch, .path = {.hits = {{}}}};
    add_aftermath(request, budget, shot);
    CHECK(budget.simulations() >= 1);
    const Trajectory whole =
        simulate({.table = p.table, .physics = p.physics, .ball = p.ball, .others = p.others, .launch = launch});
    INFO("number " << i << " of seed 91");
    REQUIRE(shot.path.scratch_pocket.has_value() == (whole.end == EventKind::pocket));
    REQUIRE(shot.path.scratch == shot.path.scratch_pocket.has_value());
    if (shot.path.scratch_pocket) {
      ++scratches;
      const auto fell = std::ranges::find_if(
          whole.events, [](const Record& e) { return e.kind == EventKind::pocket && e.ball == 0; });
      REQUIRE(*shot.path.scratch_pocket == fell->contact.index);
    } else {
      REQUIRE(shot.path.cue_rests);
      REQUIRE(*shot.path.cue_rests == end_of(whole, 0).state.at);
    }
  }
  CHECK(scratches > 3);
  CHECK(scratches < 97);
}

TEST_CASE("a shot gets its aftermath if it hits a ball") {
  Puzzle p = straight(1.25);
  Shot shot;
  shot.launch = {1, 0};
  EvaluationBudget budget(10);
  add_aftermath(SearchRequest(p), budget, shot);
  CHECK(!shot.path.cue_rests);  // no ball was hit
  shot.path.hits = {{1, 0, 1, {}, 0}};
  add_aftermath(SearchRequest(p), budget, shot);
  CHECK(shot.path.cue_rests);
  CHECK(!shot.path.scratch);
  p.target = PointTarget{{3, 1}, 0.01};
  Shot other{.launch = {1, 0}, .path = {.hits = shot.path.hits}};
  add_aftermath(SearchRequest(p), budget, other);
  CHECK(!other.path.cue_rests);
  CHECK(!other.path.scratch_pocket);
}
