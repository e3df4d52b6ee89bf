// SPDX-License-Identifier: MIT
//
// The balls of a chain, followed one by one, compared with simulations of all balls; and falls brought to a speed.
#include "planners/propose/chain_path.hpp"

#include <algorithm>
#include <cmath>

#include "bankshot/simulate/trajectory.hpp"
#include "planners/propose/falls.hpp"
#include "support/catch.hpp"
#include "support/flight.hpp"
#include "support/random_layout.hpp"

using namespace bankshot;
using namespace bankshot::planning;
using namespace bankshot::planning::propose;

namespace {

/// Returns a random layout in which ball 1 is to drop into any pocket, by at most two cushions of each ball.
Puzzle random_pot(Random& random) {
  Puzzle p = test::random_layout(random, 1);
  p.spin_range.reset();
  p.target = ObjectBallTarget{{1}, {.target = PocketTarget{}, .cushions = CushionRule{0, 2, {}}}};
  p.cushions = {0, 2, {}};
  return p;
}

/// Returns a puzzle in which a rolling ball pots another straight into a well, at 0.6 m/s.
Puzzle straight_pot() {
  Puzzle p{.table = rectangle_table(4, 2), .physics = rolling_physics(), .ball = {.at = {0.5, 1}}};
  p.table.pockets = {{"well", {2.6, 1.3}, 0.08}};
  p.others = {{{1.5, 1.1}, p.ball.body, "1"}};
  p.target = ObjectBallTarget{{1}, {.target = PocketTarget{0}}};
  p.arrive = Range{0.6, 0.6};
  p.cushions = CushionRule::exactly(0);
  return p;
}

/// Returns the launch that sends ball 1 towards the pocket's centre.
Launch onto_ghost(const Puzzle& p, double speed) {
  const Vec2d object = p.others[0].at, way = p.table.pockets[0].at - object,
              to = object - way * (2 * p.ball.body.radius / norm(way)) - p.ball.at;
  return {speed, std::atan2(to.y, to.x)};
}

/// The only chain of a puzzle, as the tests follow it.
struct Chain {
  explicit Chain(const Puzzle& p) : request(p, Wanted::all) {}
  SearchRequest request;
  EvaluationBudget budget{100000};
  ChainPath path{request, budget, request.problem->objects->chains.front()};

  Place pocket(std::size_t i = 0) const {
    const AimPoint& aim_point = request.problem->aim_points[i];
    return {aim_point.at, aim_point.reach, &aim_point};
  }
};

/// Returns whether the cue ball meets ball 1 first of all, and the two never meet again.
bool meets_once(const Trajectory& t) {
  const auto met = [](const Record& e) { return e.kind == EventKind::ball; };
  const auto bounces = [](const Record& e) { return is_bounce(e.kind); };
  return std::ranges::count_if(t.events, met) == 1 &&
         std::ranges::find_if(t.events, met) < std::ranges::find_if(t.events, bounces);
}

const Record* drop_of(const Trajectory& t, int ball) {
  const auto drop =
      std::ranges::find_if(t.events, [&](const Record& e) { return e.kind == EventKind::pocket && e.ball == ball; });
  return drop == t.events.end() ? nullptr : &*drop;
}

}  // namespace

TEST_CASE("a cue ball passes the ball that it is to touch as a flight without that ball passes its place") {
  constexpr std::uint64_t seed = 21;
  Random random(seed);
  int compared = 0;
  for (int i = 0; i < 100; ++i) {
    INFO("puzzle " << i << " of seed " << seed);
    const Puzzle p = random_pot(random);
    Chain chain(p);
    const Launch launch{random.uniform(1, 4), random.uniform(0, radians(360))};
    const Place next = chain.path.next_of(0);
    CHECK(next.at == p.others[0].at);
    CHECK(next.reach == Approx(2 * p.ball.body.radius));
    const Followed followed = chain.path.follow(0, {}, next, launch);
    Puzzle alone = p;
    alone.others.clear();
    alone.target = PointTarget{next.at};
    alone.arrive = Range{0, 10};
    std::vector<Contact> met;
    const test::Flight flight = test::fly(test::Aimed(alone), launch, {}, 10, &met);
    for (int k = 0; k < flight.count; ++k) {
      const test::Pass& plain = flight.passes[static_cast<std::size_t>(k)];
      const Route route = route_by(std::span(met).first(static_cast<std::size_t>(plain.bounces)));
      REQUIRE(followed.passes.contains(route));
      const Pass& pass = followed.passes.at(route);
      CHECK(pass.left == Approx(plain.beside).margin(1e-9));
      CHECK(pass.ahead);
      const auto locked = chain.path.left_of(route, 0, next, launch);
      REQUIRE(locked);
      CHECK(*locked == Approx(plain.beside).margin(1e-9));
      ++compared;
    }
  }
  CHECK(compared > 50);
}

TEST_CASE("a ball that is sent on falls as it does in a simulation of all balls") {
  constexpr std::uint64_t seed = 22;
  Random random(seed);
  int falls = 0;
  for (int i = 0; i < 300; ++i) {
    INFO("puzzle " << i << " of seed " << seed);
    const Puzzle p = random_pot(random);
    const Vec2d to = p.others[0].at - p.ball.at;
    const double widest = 2 * p.ball.body.radius / norm(to);
    const Launch launch{random.uniform(1, 4), wrap_angle(std::atan2(to.y, to.x) + random.uniform(-widest, widest))};
    const Trajectory t = simulate({{}, p.table, p.physics, p.ball, p.others, launch, {}, {}});
    const Record* const drop = drop_of(t, 1);
    if (!drop || !meets_once(t)) continue;
    Route route{{0, Contact::ball(1)}};
    bool by_jaws = false;
    for (const Record& e : path_of(t, 1).events) {
      if (e.kind == EventKind::cushion) route.push_back({1, e.contact});
      by_jaws = by_jaws || e.kind == EventKind::jaw;
    }
    if (by_jaws || route.size() > 3) continue;
    Chain chain(p);
    const auto& aim_points = chain.request.problem->aim_points;
    const auto pocket = std::ranges::find(aim_points, drop->contact, &AimPoint::taken_by) - aim_points.begin();
    const Place place = chain.pocket(static_cast<std::size_t>(pocket));
    const Followed followed = chain.path.follow(1, {{0, Contact::ball(1)}}, place, launch);
    REQUIRE(followed.falls.size() == 1);
    const Fall& fall = followed.falls[0];
    CHECK(fall.route == route);
    CHECK(fall.arrived == Approx(norm(drop->state.velocity)).epsilon(1e-9));
    const Vec2d off = place.at - drop->state.at;
    CHECK(fall.right == Approx(-cross(drop->state.velocity, off) / norm(drop->state.velocity)).margin(1e-9));
    ++falls;
  }
  CHECK(falls > 15);
}

TEST_CASE("a chain counts its balls from the cue ball, and keeps their rules") {
  Puzzle p = straight_pot();
  p.others.push_back({{2.2, 1.2}, p.ball.body, "2"});
  Then then{PocketTarget{0}, CushionRule::exactly(2), {{CushionRule::exactly(1), 1}}};
  p.target = ObjectBallTarget{{2}, then};
  const Chain chain(p);
  CHECK(chain.path.last() == 2);
  CHECK((chain.path.number(0) == 0 && chain.path.number(1) == 2 && chain.path.number(2) == 1));
  CHECK(chain.path.contact_with(1) == Contact::ball(2));
  CHECK((chain.path.rule(0).max == 0 && chain.path.rule(1).min == 1 && chain.path.rule(2).min == 2));
  CHECK(chain.path.next_of(1).at == p.others[0].at);
  const Route a{{0, Contact::ball(2)}}, b{{2, Contact::rail(0)}, {2, Contact::ball(1)}};
  CHECK(joined(a, b) == Route{{0, Contact::ball(2)}, {2, Contact::rail(0)}, {2, Contact::ball(1)}});
  CHECK(joined(a, {}) == a);
}

TEST_CASE("a fall is brought to the speed asked, unless its route is made already") {
  const Puzzle p = straight_pot();
  Chain chain(p);
  const Launch from = onto_ghost(p, 2);
  const Followed followed = chain.path.follow(1, {{0, Contact::ball(1)}}, chain.pocket(), from);
  REQUIRE(followed.falls.size() == 1);
  SearchResult found;
  Falls falls(chain.request, chain.budget, found, chain.path, "test");
  falls.remember(followed.falls[0]);
  falls.bring_to_speed({followed.falls[0].route});
  CHECK(found.shots.empty());
  falls.bring_to_speed({});
  CHECK(found.shots.empty());  // the first call forgot it
  falls.remember(followed.falls[0]);
  falls.bring_to_speed({});
  REQUIRE(found.shots.size() == 1);
  const Shot& shot = found.shots[0];
  CHECK(shot.provenance.planner == "test");
  CHECK(shot.launch.angle == Approx(from.angle).epsilon(1e-9));  // a roll keeps its line at any speed
  const Trajectory t = simulate({{}, p.table, p.physics, p.ball, p.others, shot.launch, {}, {}});
  const Record* const drop = drop_of(t, 1);
  REQUIRE(drop);
  CHECK(norm(drop->state.velocity) == Approx(0.6).epsilon(1e-8));
}
