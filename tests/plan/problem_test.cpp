// SPDX-License-Identifier: MIT
//
// The state of a search: problem, request, result, the launch as motion, and when a search stops.
#include <cmath>

#include "bankshot/numbers/dual.hpp"
#include "planners/nearest.hpp"
#include "planners/problem.hpp"
#include "planners/search_request.hpp"
#include "planners/search_result.hpp"
#include "planners/start.hpp"
#include "planners/stop.hpp"
#include "planners/verify/certify.hpp"
#include "support/catch.hpp"
#include "support/straight.hpp"

using namespace bankshot;
using bankshot::test::straight;
using namespace bankshot::planning;

namespace {

/// Returns a puzzle in which ball 1 sends ball 2 into a pocket.
Puzzle combination() {
  Puzzle p = straight();
  p.table.pockets = {{"well", {1.8, 0.8}, 0.06}};
  p.others = {{{1, 0.5}, p.ball.body, "1"}, {{1.4, 0.7}, p.ball.body, "2"}};
  Then then;
  then.target = PocketTarget{0};
  then.links = {{CushionRule::exactly(0), 2}};
  then.cushions = CushionRule::exactly(1);
  p.target = ObjectBallTarget{.balls = {1}, .then = then};
  p.arrive = {};
  return p;
}

Launch exact_launch(const Puzzle& p) { return {std::sqrt(0.25 + 2 * deceleration(p.physics)), 0}; }

}  // namespace

TEST_CASE("a problem knows what its ball touches at the start, and which aims drive it there") {
  Puzzle p = straight();
  CHECK(Problem(p).touched.empty());
  CHECK(!Problem(p).into_touched_cushion(radians(270)));
  p.ball.at = {0.5, p.ball.body.radius};
  const Problem on_rail(p);
  CHECK(on_rail.touches(Contact::rail(0)));
  CHECK(on_rail.into_touched_cushion(radians(269)));
  CHECK(!on_rail.into_touched_cushion(0));  // along the cushion
  CHECK(!on_rail.into_touched_cushion(radians(10)));
  CHECK(!on_rail.in_vertex());
  p.ball.body.radius = 0;
  p.ball.at = {0, 0};
  CHECK(Problem(p).in_vertex());
}

TEST_CASE("a miss counts as exact up to a part of the diagonal") {
  const Puzzle p = straight();
  const Problem problem(p);
  const double most = tolerance::exact_miss * std::sqrt(5);
  CHECK(problem.centred(most * (1 - 1e-12)));
  CHECK(!problem.centred(most * 1.01));
  CHECK(problem.on_a_line(0, {0.5, p.ball.body.radius + most / 2}));
  CHECK(!problem.on_a_line(0, {0.5, 0.5}));
}

TEST_CASE("each object ball sees the table without itself, the moving ones without each other") {
  const Puzzle p = combination();
  const Problem problem(p);
  REQUIRE(problem.objects);
  CHECK(problem.boundary.balls.size() == 2);
  CHECK(problem.alone().balls.empty());
  CHECK(problem.boundary_of(1).balls.size() == 1);
  CHECK(problem.boundary_of(1).balls[0].contact == Contact::ball(2));
  const Objects::Chain* const chain = problem.objects->chain_by(1);
  REQUIRE(chain);
  CHECK(chain->balls.size() == 2);
  for (const Boundary& moving : chain->moving) CHECK(moving.balls.empty());
  CHECK(!problem.objects->chain_by(2));
  CHECK(problem.drops());
  CHECK(!problem.carom());
  CHECK(problem.nearest_aim_point({1.7, 0.7}, 2).taken_by == Contact::pocket(0));
  CHECK(problem.aim_point_taken_by(Contact::pocket(0), {1.8, 0.8}, 2));
  CHECK(!problem.aim_point_taken_by(Contact::pocket(0), {1.8, 0.8}, 0));
}

TEST_CASE("a ball that stands on the point is told") {
  Puzzle p = straight();
  CHECK(!Problem(p).covering());
  p.others = {{{1.5 + p.ball.body.radius, 0.5}, p.ball.body, "1"}};
  CHECK(Problem(p).covering() == Contact::ball(1));
}

TEST_CASE("the route of a shot goes from ball to ball") {
  Shot shot;
  shot.path.cushions = {Contact::rail(0), Contact::rail(1)};
  CHECK(route_of(shot) == route_by(shot.path.cushions));
  shot.path.then = {{1, {Contact::rail(2)}}, {2, {}}};
  const Route sent{{0, Contact::rail(0)},
                   {0, Contact::rail(1)},
                   {0, Contact::ball(1)},
                   {1, Contact::rail(2)},
                   {1, Contact::ball(2)}};
  CHECK(route_of(shot) == sent);
  Shot carom;
  carom.path.cushions = {Contact::rail(0), Contact::rail(1)};
  carom.path.hits = {{1, 0, 1, {}, 1}, {2, 0, 1, {}, 2}};
  const Route off_ball{{0, Contact::rail(0)}, {0, Contact::ball(1)}, {0, Contact::rail(1)}};
  CHECK(route_of(carom) == off_ball);
  Shot jaws;
  jaws.path.touches_jaws = true;
  jaws.path.met = {Contact::rail(0), Contact::jaw(1, 0)};
  CHECK(route_with_jaws_of(jaws) == route_by(jaws.path.met));
}

TEST_CASE("the difference of two angles is the short way round") {
  CHECK(angle_difference(radians(350), radians(10)) == Approx(radians(20)));
  CHECK(angle_difference(radians(10), radians(350)) == Approx(radians(-20)));
  CHECK(angle_difference(1, 1) == Approx(0).margin(1e-15));
}

TEST_CASE("a request begins with what the puzzle asks") {
  Puzzle p = straight();
  p.arrive = Range{0.2, 0.6};
  const SearchRequest request(p);
  CHECK(request.asked == 0.6);  // fast, unless soft shots are preferred
  CHECK(!request.stop);
  CHECK(!request.one_unknown());
  CHECK(request.launched_at(2).one_unknown());
  CHECK(request.launched_at(2).fixed_speed() == 2);
  CHECK(request.asking(0.3).asked == 0.3);
  p.prefer = Prefer::soft;
  CHECK(SearchRequest(p).asked == 0.2);
  p.arrive = Range{0, 0};
  CHECK(SearchRequest(p).stop);
  p.spin_range = SpinRange{{-1, -0.5}, {-1, 1}, {0.25, 1}};
  CHECK(SearchRequest(p).spin == LaunchSpin{-0.5, 0, 0.25});  // the least of each
  p.cushions = CushionRule::in_order({Contact::rail(2)});
  CHECK(SearchRequest(p).route == route_by(*p.cushions.sequence));
  CHECK(SearchRequest(p).stage(2, 0).cushions().min == 1);  // a sequence stays
}

TEST_CASE("a stage asks for so many cushions of the cue ball and of the last object ball") {
  const Puzzle p = combination();
  const SearchRequest stage = SearchRequest(p).stage(2, 3);
  CHECK((stage.cushions().min == 2 && stage.cushions().max == 2));
  CHECK((stage.cushions_of(0).min == 0 && stage.cushions_of(0).max == 0));  // a link keeps its own
  CHECK((stage.cushions_of(1).min == 3 && stage.cushions_of(1).max == 3));
}

TEST_CASE("better shots than one in hand are slower, sooner or likelier, as is preferred") {
  Puzzle p = straight();
  Shot shot;
  shot.launch.speed = 2;
  shot.path.arrival.time = 1.5;
  shot.robustness.success_estimate = 0.7;
  p.prefer = Prefer::soft;
  CHECK(SearchRequest(p).better_than(shot).speed.high == 2);
  p.prefer = Prefer::quick;
  CHECK(SearchRequest(p).better_than(shot).latest == 1.5);
  p.prefer = Prefer::robust;
  CHECK(SearchRequest(p).better_than(shot).likelier == 0.7);
  CHECK(SearchRequest(p).better_than(shot).speed.high == p.speed.high);
}

TEST_CASE("roots to start from may lie outside the bounds") {
  Puzzle p = straight();
  p.angle = Range{0, 1};
  const SearchRequest starts = SearchRequest(p, Wanted::all).starts_at(0.4, {.top = 1});
  CHECK(starts.starts());
  CHECK(!starts.angle);
  CHECK(starts.asked == 0.4);
  CHECK(starts.speed.high >= p.speed.high);
}

TEST_CASE("failures are counted by reason and obstacle, with the speed nearest to the bound") {
  SearchResult found;
  found.remember({{1, 0.1}, 0.3, {FailureReason::too_fast, {}, 7}});
  found.remember({{1, 0.2}, 0.1, {FailureReason::too_fast, {}, 5}});
  found.remember({{1, 0.3}, 0.2, {FailureReason::too_slow, {}, 0.1}});
  found.remember({{1, 0.4}, 0.4, {FailureReason::too_slow, {}, 0.3}});
  found.remember({{1, 0.5}, 0.5, {FailureReason::hit_ball, Contact::ball(1)}});
  found.remember({{1, 0.6}, 0.6, {FailureReason::hit_ball, Contact::ball(2)}});
  REQUIRE(found.failures.size() == 4);
  CHECK((found.failures[0].times == 2 && found.failures[0].failure.speed == 5));
  CHECK((found.failures[1].times == 2 && found.failures[1].failure.speed == 0.3));
  CHECK(found.nearest.launch.angle == 0.2);
  found.add_note("one");
  found.add_note("two");
  CHECK(found.note == "one; two");
}

TEST_CASE("a launch begins at the ball, and its derivatives are those of a turn and of more speed") {
  const Puzzle p = straight();
  const SearchRequest request = SearchRequest(p).spinning({.top = 0.5, .side = 0.2});
  const Launch launch{2, 0.7};
  const State<double> s = start_of(request, launch);
  CHECK(s.at == p.ball.at);
  CHECK(norm(s.velocity - direction(0.7) * 2.0) < 1e-15);
  CHECK(norm(start_of(request, 0.7, 2.0).velocity - s.velocity) < 1e-15);
  const auto dual = dual_start<Dual<2>, 2>(request, launch, request.spin);
  const double h = 1e-6;
  const State<double> turned = start_of(request, 0.7 + h, 2.0), faster = start_of(request, 0.7, 2.0 * (1 + h));
  CHECK(dual.velocity.x.v[0] == Approx((turned.velocity.x - s.velocity.x) / h).epsilon(1e-5));
  CHECK(dual.spin.x.v[0] == Approx((turned.spin.x - s.spin.x) / h).epsilon(1e-5));
  CHECK(dual.spin.z.v[0] == Approx(0).margin(1e-12));
  CHECK(dual.velocity.y.v[1] == Approx((faster.velocity.y - s.velocity.y) / h).epsilon(1e-5));
  CHECK(dual.spin.z.v[1] == Approx(s.spin.z).epsilon(1e-12));  // by ln speed
}

TEST_CASE("a search stops as its request says") {
  const Puzzle p = straight();
  const SearchRequest best(p), first(p, Wanted::first), all(p, Wanted::all);
  SearchResult none, one, many;
  one.shots.resize(1);
  many.shots.resize(settings::enough_to_compare);
  EvaluationBudget rich(100), poor(0);
  CHECK(stop::satisfied(first, one));
  CHECK(!stop::satisfied(first, none));
  CHECK(!stop::satisfied(best, many));
  CHECK(stop::over(best, poor, none));
  CHECK(!stop::over(best, rich, many));
  CHECK(stop::enough_seeds(first, rich, one));
  CHECK(!stop::enough_seeds(best, rich, one));
  CHECK(!many.plenty);
  CHECK(stop::enough_seeds(best, rich, many));
  CHECK(many.plenty);
  CHECK(!stop::enough_seeds(all, rich, many));
  CHECK(stop::enough_images(best, many, true));
  CHECK(!stop::enough_images(best, many, false));  // longer images may be better
  CHECK(!stop::enough_images(all, many, true));
  CHECK(stop::nothing_yet(rich, none));
  CHECK(!stop::nothing_yet(poor, none));  // spent above
  CHECK(stop::more_wanted(all, rich, many));
  CHECK(!stop::more_wanted(best, rich, one));
  Puzzle routed = straight();
  routed.cushions = CushionRule::in_order({});
  CHECK(stop::route_settled(SearchRequest(routed), one));
  CHECK(!stop::route_settled(SearchRequest(routed, Wanted::all), one));
}

TEST_CASE("a verified shot is kept once, with its derivatives") {
  const Puzzle p = straight();
  const SearchRequest request(p);
  EvaluationBudget budget(1000);
  SearchResult found;
  REQUIRE(certify(request, budget, found, exact_launch(p), 0, "test"));
  certify(request, budget, found, exact_launch(p), 0, "again");
  REQUIRE(found.shots.size() == 1);
  const Shot& shot = found.shots[0];
  CHECK(shot.provenance.planner == "test");
  CHECK(norm(shot.verification.by_angle) == Approx(1).epsilon(1e-9));  // one metre per radian
  CHECK(!promised_digits(request, shot));                              // nine or more
  CHECK(!certify(request, budget, found, {exact_launch(p).speed, 0.1}, 0, "beside"));
  REQUIRE(found.failures.size() == 1);
  CHECK(found.failures[0].times == 1);
}

TEST_CASE("two shots are one if launch and arrival agree") {
  const Puzzle p = straight();
  const SearchRequest request(p);
  Shot a;
  a.launch = {2, 1};
  a.path.arrival.time = 1;
  Shot b = a;
  CHECK(same_shot(request, a, b));
  b.launch.angle += 1e-6;
  CHECK(!same_shot(request, a, b));
  b = a;
  b.path.arrival.time = 1.1;  // it arrives again, after another bounce
  CHECK(!same_shot(request, a, b));
}

TEST_CASE("digits are promised by the rounding that the shot amplifies") {
  const Puzzle p = straight();
  const SearchRequest request(p);
  Shot shot;
  const auto digits = [&](double condition) {
    shot.verification.condition = condition;
    return promised_digits(request, shot);
  };
  CHECK(!digits(1));
  REQUIRE(digits(1e9));
  const double off = tolerance::simulation_error * 0x1p-53 * 1e9 / std::sqrt(5);
  CHECK(*digits(1e9) == static_cast<int>(-std::log10(off)));
  CHECK(*digits(1e12) == *digits(1e9) - 3);
  CHECK(*digits(1e30) == 1);
}

TEST_CASE("the nearest launch that is allowed is at the end of the aims, and rests abreast of the point") {
  Puzzle p = straight();
  p.arrive = Range{0, 0};
  p.angle = Range{radians(10), radians(20)};
  const SearchRequest request(p);
  EvaluationBudget budget(0);  // none is charged
  const auto launch = nearest_launch(request, budget, {}, true);
  REQUIRE(launch);
  CHECK(budget.work().arcs > 1000);
  CHECK(launch->angle == Approx(radians(10)).margin(1e-3));
  CHECK(launch->speed == Approx(std::sqrt(2 * deceleration(p.physics) * std::cos(radians(10)))).epsilon(1e-2));
  CHECK(!nearest_launch(request, budget, {}, false));  // nothing was remembered
  SearchResult found;
  found.nearest.launch = {0.4, radians(15)};
  CHECK(nearest_launch(request, budget, found, false)->angle == Approx(radians(15)));
}
