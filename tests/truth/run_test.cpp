// SPDX-License-Identifier: MIT
//
// Runs in 50 digits and in double: their limits, their remainders, their derivatives, and how a start is turned and
// pushed without rounding.
#include "truth/run.hpp"
#include "truth/follow.hpp"

#include <cmath>
#include <vector>

#include "bankshot/motion/launched.hpp"
#include "bankshot/numbers/random.hpp"
#include "bankshot/scene/json.hpp"
#include "bankshot/scene/table.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::truth;

namespace {

constexpr double length = 2, width = 1;

/// A table without pockets and a ball that rolls on it.
struct Rolls {
  Table table = rectangle_table(length, width);
  Body body{};
  Physics physics = rolling_physics();
  Boundary boundary{table, body};

  Run run(const Vec2d& at, const Vec2d& velocity) const {
    return {boundary, physics, launched(at, body.radius, velocity, LaunchSpin{})};
  }
};

/// A number of two doubles, to see that only the nearest double is taken.
struct Twice {
  double high, low;
  template <class D>
  D convert_to() const {
    return static_cast<D>(high + low);
  }
};

bool same(const TruthEvent& a, const TruthEvent& b) {
  return a.kind == b.kind && a.contact == b.contact && a.time == b.time && a.state.at == b.state.at &&
         a.state.velocity == b.state.velocity && a.ball == b.ball;
}

/// Returns the difference of two positions, with their remainders.
Vec2d apart(const TruthEvent& a, const TruthEvent& b) { return (a.state.at - b.state.at) + (a.at_rest - b.at_rest); }

}  // namespace

TEST_CASE("a ball that rolls to rest stops where v² / 2a says, to more digits than a double has") {
  const Rolls r;
  const double v = 0.4;
  const Path path = run_truth(r.run({0.3, 0.5}, {v, 0})), in_double = run_double(r.run({0.3, 0.5}, {v, 0}));
  REQUIRE(path.ended);
  REQUIRE((path.events.size() == 1 && in_double.events.size() == 1));
  const TruthEvent &e = path.events[0], &d = in_double.events[0];
  CHECK(e.kind == EventKind::rest);
  const Rolling motion = std::get<Rolling>(r.physics.motion);
  const long double a = static_cast<long double>(motion.friction) * motion.g, speed = v;
  const long double x = 0.3 + speed * speed / (2 * a), t = speed / a;
  CHECK(std::abs(static_cast<double>(static_cast<long double>(e.state.at.x) + e.at_rest.x - x)) < 1e-18);
  CHECK(std::abs(static_cast<double>(static_cast<long double>(e.time) + e.time_rest - t)) < 1e-17);
  CHECK((e.state.at.y == 0.5 && e.at_rest.y == 0));
  CHECK((e.at_rest.x != 0 && std::abs(e.at_rest.x) <= 0x1p-52));  // half a unit in the last place at most
  CHECK((d.at_rest == Vec2d{} && d.time_rest == 0));
  CHECK(std::abs(d.state.at.x - e.state.at.x) < 1e-14);
}

TEST_CASE("a run ends after its bounces, its events or its time, and says whether it came to its end") {
  const Rolls r;
  Run run = r.run({0.3, 0.5}, {3, 0.2});
  run.cushions = 3;
  const Path bounces = run_truth(run);
  CHECK(bounces.ended);
  REQUIRE(bounces.events.size() == 3);
  for (const TruthEvent& e : bounces.events) CHECK(e.kind == EventKind::cushion);
  CHECK(bounces.events[0].contact == Contact::rail(1));
  CHECK(bounces.events[1].contact == Contact::rail(3));

  run.cushions = 1000000, run.events = 2;
  const Path few = run_truth(run);
  CHECK(!few.ended);
  REQUIRE(few.events.size() == 2);
  CHECK(same(few.events[1], bounces.events[1]));

  run.events = 1000, run.until = (bounces.events[0].time + bounces.events[1].time) / 2;
  const Path timed = run_truth(run);
  CHECK(timed.ended);
  REQUIRE(timed.events.size() == 2);
  CHECK(timed.events[1].kind == EventKind::horizon);
  CHECK(std::abs(timed.events[1].time - run.until) < 1e-15);
}

TEST_CASE("the target's nearest pass is noted on each arc, signed across the line of travel") {
  const Rolls r;
  Run run = r.run({0.3, 0.5}, {1.5, 0});
  run.cushions = 1;
  run.target = Vec2d{1, 0.52};
  const Path path = run_truth(run);
  REQUIRE(path.events.size() == 1);
  const Passing& p = path.events[0].passing;
  CHECK(p.miss == Approx(0.02));
  CHECK(p.lateral == Approx(0.02));  // on the left
  CHECK(std::abs(p.at.x - 1) < 1e-15);
  const double a = deceleration(r.physics);
  CHECK(p.speed == Approx(std::sqrt(1.5 * 1.5 - 2 * a * 0.7)));
  CHECK(p.time == Approx((1.5 - p.speed) / a));
  CHECK((p.velocity.x == p.speed && p.velocity.y == 0));
}

TEST_CASE("a ball that is pressed along a rail leaves its end by a pocket alike in 50 digits") {
  const ShotRequest shot =
      read_shot(R"({"table": "pool-9ft", "physics": {"model": "spin", "cushion": {"model": "han2005",
    "restitution": 0.35327835243210687, "friction": 0, "height": 0.04390548486767159}},
    "ball": {"at": [0.9678869742552196, 0.37969366707984],
             "spin": {"top": 1.1994722715974957, "side": -0.49462577267366414, "masse": 0.9250464850537301}},
    "shot": {"speed": 5.1315424785268, "angle": 143.68055467562007}})");
  const Boundary boundary(shot.table, shot.ball.body);
  const Run run{boundary, shot.physics, start_state(shot)};
  const Path exact = run_truth(run), found = run_double(run);
  REQUIRE((exact.ended && found.events.size() == exact.events.size()));
  CHECK(exact.events.back().kind == EventKind::pocket);
  for (std::size_t i = 0; i < found.events.size(); ++i) {
    CHECK(found.events[i].contact == exact.events[i].contact);
    CHECK(norm(found.events[i].state.at - exact.events[i].state.at) < 1e-12);
    CHECK(found.events[i].time == Approx(exact.events[i].time).epsilon(1e-12));
  }
}

TEST_CASE("a start is turned and pushed without rounding") {
  const Rolls r;
  Run run = r.run({0.3, 0.5}, {1, 0.5});
  run.start.spin = {3, -4, 5};
  CHECK(start_of<double>(run).velocity == run.start.velocity);
  run.turned = 1e-3, run.pushed = 0.25;
  const State<double> s = start_of<double>(run);
  CHECK(s.at == run.start.at);
  CHECK(norm(s.velocity - Vec2d{1.25 * (1 - 0.5e-3), 1.25 * (0.5 + 1e-3)}) < 1e-15);
  CHECK(s.spin.z == 1.25 * 5);
  CHECK(std::abs(s.spin.x - 1.25 * (3 + 4e-3)) < 1e-15);
  CHECK(std::abs(s.spin.y - 1.25 * (-4 + 3e-3)) < 1e-15);

  // A turn far below the rounding of a double still moves the end of a run by its share.
  Run straight = r.run({0.3, 0.5}, {0.4, 0});
  const TruthEvent before = run_truth(straight).events.back();
  straight.turned = 1e-22;
  const TruthEvent turned = run_truth(straight).events.back();
  const double rolled = before.state.at.x - 0.3;
  CHECK(apart(turned, before).y == Approx(1e-22 * rolled).epsilon(1e-6));
  straight.turned = 0, straight.pushed = 1e-22;
  const TruthEvent pushed = run_truth(straight).events.back();
  CHECK(apart(pushed, before).x == Approx(2e-22 * rolled).epsilon(1e-6));  // the distance grows with v²
}

TEST_CASE("the derivatives of a ball that rolls to rest are those of its closed form") {
  const Rolls r;
  const double v = 0.4, a = deceleration(r.physics);
  const Jacobian j = truth_jacobian(r.run({0.3, 0.5}, {v, 0}));
  const double expected[2][7] = {{1, 0, v / a, 0, 0, 0, 0}, {0, 1, 0, v / (2 * a), 0, 0, 0}};
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 7; ++column) {
      INFO("row " << row << ", column " << column);
      CHECK(std::abs(j.d[row][column] - expected[row][column]) < 1e-12);
    }
}

TEST_CASE("25 and 100 digits agree with 50 as far as the remainders go") {
  const Table table = rectangle_table(length, width);
  const Boundary boundary(table, Body{});
  const Physics physics = spin_physics();
  constexpr std::uint64_t seed = 1;
  Random draw(seed);
  for (int i = 0; i < 5; ++i) {
    INFO("draw " << i << " of seed " << seed);
    const Vec2d velocity{draw.uniform(-2, 2), draw.uniform(-2, 2)};
    Run run{boundary, physics,
            launched({0.7, 0.4}, boundary.body.radius, velocity, LaunchSpin{.top = 0.3, .side = draw.uniform(-1, 1)}),
            3};
    const Path path = run_truth(run);
    for (const int digits : {25, 50, 100}) {
      const Path other = run_in_digits(run, digits);
      REQUIRE(other.events.size() == path.events.size());
      for (std::size_t k = 0; k < path.events.size(); ++k) {
        CHECK(other.events[k].kind == path.events[k].kind);
        CHECK(norm(apart(other.events[k], path.events[k])) < (digits == 25 ? 1e-17 : 1e-28));
      }
    }
    const Path in_double = run_double(run);
    CHECK(norm(in_double.events[0].state.at - path.events[0].state.at) < 1e-12);
  }
}

TEST_CASE("only integrated impacts are made finer") {
  Physics integrated = spin_physics();
  integrated.cushion = Mathavan2010{};
  CHECK(*impact_tolerance(refined(integrated).cushion) <= 1.001e-7 * *impact_tolerance(integrated.cushion));
  for (const Physics& physics : {ideal_physics(), rolling_physics(), spin_physics()}) {
    const Physics same = refined(physics);
    CHECK(same.cushion.index() == physics.cushion.index());
    CHECK(impact_tolerance(same.cushion) == nullptr);
    CHECK(restitution(same).at_rest == restitution(physics).at_rest);
  }
}

TEST_CASE("each event of a run is seen once, and the record is what was seen") {
  const Rolls r;
  Run run = r.run({0.3, 0.5}, {3, 0.2});
  run.cushions = 4;
  std::vector<TruthEvent> seen;
  const bool ended = follow<double>(run, start_of<double>(run), [&](const Event& e, const auto& sim) {
    seen.push_back(note<double>(e, sim.time(), sim.state(), Passing{}, 3));
  });
  CHECK(ended);
  const Path path = recorded<double>(run), in_double = run_double(run);
  REQUIRE(path.events.size() == seen.size());
  REQUIRE(in_double.events.size() == seen.size());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    CHECK(seen[i].ball == 3);
    seen[i].ball = 0;
    CHECK(same(seen[i], path.events[i]));
    CHECK(same(seen[i], in_double.events[i]));
    CHECK((seen[i].time_rest == 0 && seen[i].at_rest == Vec2d{}));
  }
  run.events = 2;
  int events = 0;
  CHECK(!follow<double>(run, start_of<double>(run), [&](const Event&, const auto&) { ++events; }));
  CHECK(events == 2);
}

TEST_CASE("the line of travel through jaws leads to their pocket") {
  CHECK(towards({EventKind::jaw, Contact::jaw(3, 2)}) == Contact::pocket(3));
  CHECK(towards({EventKind::pocket, Contact::pocket(1)}) == Contact::pocket(1));
  CHECK(towards({EventKind::ball, Contact::ball(2)}) == Contact::ball(2));
}

TEST_CASE("a state on an arc is seen from the target, on its left or its right") {
  Arc<double> arc;
  arc.at = {1, 2}, arc.velocity = {0, 4}, arc.duration = 10;
  const Passing left = passing<double>(arc, 5, 0.5, {0.5, 4}), right = passing<double>(arc, 5, 0.5, {1.25, 4.5});
  CHECK(left.time == 5.5);
  CHECK(left.at == Vec2d{1, 4});
  CHECK(left.velocity == Vec2d{0, 4});
  CHECK(left.speed == 4);
  CHECK((left.miss == 0.5 && left.lateral == 0.5));
  CHECK((right.lateral == -0.25 && right.miss == Approx(std::hypot(0.25, 0.5))));
  arc.velocity = {};
  CHECK(passing<double>(arc, 0, 0.5, {0, 2}).lateral == 0);  // a ball at rest has no line of travel
}

TEST_CASE("long numbers are rounded to the nearest double") {
  CHECK(rounded(0.1) == 0.1);
  CHECK(rounded(Twice{0.1, 1e-30}) == 0.1);
  CHECK(rounded(Twice{1, 0.5}) == 1.5);
}

TEST_CASE("a state converts to another scalar") {
  const State<long double> s = to<long double>(State<double>{{1, 2}, {3, 4}, {5, 6, 7}});
  CHECK((s.at.x == 1 && s.at.y == 2 && s.velocity.x == 3 && s.velocity.y == 4));
  CHECK((s.spin.x == 5 && s.spin.y == 6 && s.spin.z == 7));
}
