// SPDX-License-Identifier: MIT
//
// The judge decides what counts as made. Here it judges paths that are written by hand, event by event.
#include "truth/judge.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "bankshot/scene/json.hpp"
#include "support/catch.hpp"
#include "truth/arrival.hpp"

using namespace bankshot;
using namespace bankshot::truth;
using Catch::Contains;

namespace {

constexpr int bottom = 0, right = 1, top = 2;

/// Returns a puzzle on a table of 2 m × 1 m with six round pockets and two object balls; `more` gives its target.
Puzzle puzzle(const std::string& more) {
  return read_puzzle(R"({"table": {"length": 2, "width": 1, "pockets": "six"}, "physics": "rolling",
    "ball": {"at": [0.5, 0.5]}, "others": [{"id": "1", "at": [1.5, 0.5]}, {"id": "2", "at": [1.5, 0.8]}], )" +
                     more + "}");
}

TruthEvent event(EventKind kind, Contact contact, double time, int ball = 0) {
  TruthEvent e{};
  e.kind = kind, e.contact = contact, e.time = time, e.ball = ball;
  e.state.at = {1, 0.5}, e.state.velocity = {1, 0};
  return e;
}

TruthEvent bounce(int rail, double time, int ball = 0) {
  return event(EventKind::cushion, Contact::rail(rail), time, ball);
}

/// Adds to an event that its arc passes the target by `miss`.
TruthEvent passing_by(TruthEvent e, double miss, double time, double speed = 2) {
  e.passing.miss = miss, e.passing.time = time, e.passing.speed = speed, e.passing.at = {1.2, 0.6};
  return e;
}

TruthEvent hit(int ball, double time, double lateral, int by = 0) {
  TruthEvent e = event(EventKind::ball, Contact::ball(ball), time, by);
  e.passing.lateral = lateral, e.passing.miss = std::abs(lateral), e.passing.speed = 1.5;
  e.passing.velocity = {1, 0};
  return e;
}

Goal counted(int min, int max) { return {min, max, nullptr, nullptr, 0, 0, nullptr}; }

Arrived judged(const Puzzle& p, const std::vector<TruthEvent>& events, const Goal& goal) {
  const truth::Scene scene(p);
  return judge(scene, {events, true}, goal);
}

}  // namespace

TEST_CASE("a ball passes through a point if one of its arcs comes near enough after its cushions") {
  const Puzzle p = puzzle(R"("target": {"point": [1.2, 0.6], "within": 0.01}, "arrive": {"speed": [0.1, 5]})");
  REQUIRE(!truth::Scene(p).stops);
  const TruthEvent first = bounce(top, 1), near = passing_by(bounce(right, 2), 0.004, 1.5);
  const Arrived made = judged(p, {first, near}, counted(1, 1));
  CHECK(made.made());
  CHECK((made.time == 1.5 && made.speed == 2 && made.passed == 0.004 && made.at == Vec2d{1.2, 0.6}));
  CHECK(made.cushions == std::vector{Contact::rail(top)});

  CHECK_THAT(judged(p, {near}, counted(1, 1)).why, Contains("passes by the target"));  // its cushion is missing
  CHECK_THAT(judged(p, {first, bounce(right, 2)}, counted(1, 1)).why, Contains("meets right before the target"));
  CHECK(judged(p, {first, bounce(right, 2), passing_by(bounce(top, 3), 0, 2.5)}, counted(1, 2)).made());

  // `within` has a sharp end, which slack moves.
  const TruthEvent far = passing_by(bounce(right, 2), 0.0101, 1.5);
  CHECK(!judged(p, {first, far}, counted(1, 1)).made());
  Goal slack = counted(1, 1);
  slack.slack = 2e-4;
  CHECK(judged(p, {first, far}, slack).made());
}

TEST_CASE("of several passes the one nearest to the claimed time counts") {
  const Puzzle p = puzzle(R"("target": {"point": [1.2, 0.6]}, "arrive": {"speed": [0.1, 5]})");
  const std::vector<TruthEvent> passes{passing_by(event(EventKind::slide_to_roll, {}, 1), 0.001, 0.8),
                                       passing_by(event(EventKind::slide_to_roll, {}, 2), 0.002, 1.8),
                                       passing_by(bounce(bottom, 3), 0.003, 2.8)};
  for (const auto& [claimed, time] : {std::pair{0.0, 0.8}, {1.7, 1.8}, {9.0, 2.8}}) {
    INFO(claimed);
    Goal goal = counted(0, 3);
    goal.time = claimed;
    const Arrived made = judged(p, passes, goal);
    CHECK(made.made());
    CHECK(made.time == time);
  }
}

TEST_CASE("a ball that must rest does so within its ring, and nowhere else") {
  const Puzzle p = puzzle(R"("target": {"point": [1, 0.6], "within": 0.05}, "arrive": {"speed": 0})");
  REQUIRE(truth::Scene(p).stops);
  TruthEvent rest = event(EventKind::rest, {}, 4);
  rest.state.at = {1, 0.64}, rest.state.velocity = {};
  const Arrived made = judged(p, {bounce(top, 1), rest}, counted(1, 1));
  CHECK(made.made());
  CHECK((made.speed == 0 && made.time == 4 && made.passed == Approx(0.04)));
  CHECK_THAT(judged(p, {rest}, counted(1, 1)).why, Contains("stops before the target"));
  rest.state.at = {1, 0.66};
  CHECK_THAT(judged(p, {bounce(top, 1), rest}, counted(1, 1)).why, Contains("stops 0.06 m from the target"));
  // The remainder counts: it is the position's last digits.
  rest.state.at = {1, 0.65}, rest.at_rest = {0, -1e-3};
  CHECK(judged(p, {bounce(top, 1), rest}, counted(1, 1)).made());
  CHECK(!judged(p, {passing_by(bounce(top, 1), 0, 0.5), bounce(right, 2)}, counted(0, 1)).made());
}

TEST_CASE("named cushions are met in their order, but two of one instant in either") {
  const Puzzle p = puzzle(R"("target": {"point": [1.2, 0.6]}, "arrive": {"speed": [0.1, 5]})");
  const std::vector<Contact> asked{Contact::rail(top), Contact::rail(right)};
  const Goal goal{2, 2, &asked, nullptr, 0};
  const auto met = [&](int first, int second, double later) {
    return judged(p, {bounce(first, 1), bounce(second, 1 + later), passing_by(bounce(bottom, 3), 0, 2)}, goal);
  };
  CHECK(met(top, right, 1).made());
  CHECK(met(right, top, 1e-13).made());
  const Arrived wrong = met(right, top, 1e-3);
  CHECK((!wrong.in_order && !wrong.made()));
  CHECK(wrong.cushions == std::vector{Contact::rail(right), Contact::rail(top)});
  CHECK(!met(top, top, 1).in_order);
}

TEST_CASE("a pocket takes its own ball after its cushions") {
  const Puzzle p = puzzle(R"("target": {"pocket": "top-right"})"), any = puzzle(R"("target": {"pocket": "any"})");
  const int wanted = std::get<PocketTarget>(p.target).pocket.value();
  const auto fall = [](int pocket, double lateral) {
    TruthEvent e = event(EventKind::pocket, Contact::pocket(pocket), 3);
    e.state.velocity = {0.6, 0.8};
    e.passing.lateral = lateral, e.passing.velocity = {0.6, 0.8};
    return e;
  };
  const Arrived made = judged(p, {bounce(bottom, 1), fall(wanted, 0.01)}, counted(1, 1));
  CHECK(made.made());
  CHECK(made.taken_by == Contact::pocket(wanted));
  CHECK(made.offset == -0.01);  // positive on the left of the pocket's centre, seen along the path
  CHECK((made.speed == 1 && made.time == 3 && !made.touches_jaws));
  const double rim = truth::Scene(p).boundary.rim(Contact::pocket(wanted))->radius;
  CHECK(made.incidence == Approx(std::sqrt(1 - std::pow(0.01 / rim, 2))));

  const int another = wanted == 0 ? 1 : 0;
  CHECK_THAT(judged(p, {fall(another, 0)}, counted(0, 1)).why, Contains("falls into pocket bottom-left"));
  CHECK(judged(any, {fall(another, 0)}, counted(0, 1)).made());
  CHECK_THAT(judged(any, {fall(another, 0)}, counted(1, 1)).why, Contains("falls into"));
  CHECK_THAT(judged(any, {event(EventKind::rest, {}, 2)}, counted(0, 1)).why, Contains("stops before the target"));
  CHECK_THAT(judged(any, {}, counted(0, 1)).why, Contains("passes by the target"));
}

TEST_CASE("a jaw of the pocket decides the line, and touching any jaw is noted") {
  const Puzzle p = puzzle(R"("target": {"pocket": "any"})");
  TruthEvent jaw = event(EventKind::jaw, Contact::jaw(2, 1), 2), fall = event(EventKind::pocket, Contact::pocket(2), 3);
  jaw.passing.lateral = 0.02, fall.passing.lateral = -0.005;
  const Arrived made = judged(p, {jaw, fall}, counted(0, 0));
  CHECK(made.made());
  CHECK(made.touches_jaws);
  CHECK(made.offset == -0.02);  // of the line on which the ball came
}

TEST_CASE("the cue ball runs into nothing that the puzzle does not ask for") {
  const Puzzle p = puzzle(R"("target": {"pocket": "any"})");
  const TruthEvent fall = event(EventKind::pocket, Contact::pocket(2), 3);
  CHECK_THAT(judged(p, {hit(1, 1, 0), fall}, counted(0, 0)).why, Contains(R"(runs into ball "1")"));
  CHECK_THAT(judged(p, {hit(2, 1, 0, 1), fall}, counted(0, 0)).why, Contains(R"(touches ball "2")"));
}

TEST_CASE("a ball is touched at the asked cut, after the cushions, and no other before") {
  const Puzzle p = puzzle(R"("target": {"ball": "1", "cut": 30, "within": 2})");
  const double reach = truth::Scene(p).boundary.rim(Contact::ball(1))->radius;
  // A cut above 0 has the line of travel to the right of the ball's centre, which is then on its left.
  const auto at_cut = [&](double cut) { return hit(1, 2, reach * std::sin(radians(cut))); };
  const Arrived made = judged(p, {bounce(top, 1), at_cut(31)}, counted(1, 1));
  CHECK(made.made());
  CHECK(made.taken_by == Contact::ball(1));
  CHECK((made.speed == 1.5 && made.offset == Approx(-reach * std::sin(radians(31.0)))));
  REQUIRE(made.hits.size() == 1);
  CHECK(made.hits[0].ball == 1);
  CHECK(judged(p, {at_cut(28.01)}, counted(0, 0)).made());
  for (const double cut : {27.9, 32.1, -30.0}) {
    INFO(cut);
    CHECK_THAT(judged(p, {at_cut(cut)}, counted(0, 0)).why, Contains(R"(meets ball "1" at another cut)"));
  }
  CHECK_THAT(judged(p, {at_cut(30)}, counted(1, 1)).why, Contains("runs into"));
  CHECK_THAT(judged(p, {hit(2, 1, 0), at_cut(30)}, counted(0, 0)).why, Contains(R"(runs into ball "2")"));
}

TEST_CASE("a carom touches its first ball and then its second") {
  const Puzzle p = puzzle(R"("target": {"carom": ["1", "2"]})");
  const Arrived made = judged(p, {hit(1, 1, 0.01), bounce(top, 2), hit(2, 3, 0)}, counted(1, 1));
  CHECK(made.made());
  REQUIRE(made.hits.size() == 2);
  CHECK((made.hits[0].ball == 1 && made.hits[1].ball == 2));
  CHECK(made.ball == 0);
  CHECK_THAT(judged(p, {hit(2, 1, 0), hit(1, 2, 0)}, counted(0, 0)).why, Contains(R"(touches ball "2")"));
  CHECK_THAT(judged(p, {hit(1, 1, 0), hit(2, 3, 0)}, counted(1, 1)).why, Contains("runs into"));
}

TEST_CASE("an object ball is hit by the cue ball, and then falls by its own cushions") {
  const Puzzle p =
      puzzle(R"("target": {"ball": "1", "then": {"pocket": "any", "cushions": 1}}, "cushions": {"max": 1})");
  const TruthEvent fall = event(EventKind::pocket, Contact::pocket(2), 4, 1);
  const Arrived made = judged(p, {bounce(top, 1), hit(1, 2, 0.01), bounce(bottom, 3, 1), fall}, counted(0, 1));
  CHECK(made.made());
  CHECK(made.ball == 1);
  CHECK(made.cushions == std::vector{Contact::rail(top)});
  REQUIRE(made.then.size() == 1);
  CHECK(made.then[0].ball == 1);
  CHECK(made.then[0].cushions == std::vector{Contact::rail(bottom)});
  // The cue ball's bounces after the hit are its own.
  CHECK(judged(p, {hit(1, 2, 0), bounce(right, 2.5), bounce(bottom, 3, 1), fall}, counted(0, 1)).made());

  CHECK_THAT(judged(p, {hit(1, 2, 0), fall}, counted(0, 1)).why, Contains("sends it into pocket"));
  CHECK_THAT(judged(p, {hit(1, 2, 0), bounce(bottom, 3, 1), bounce(top, 3.5, 1)}, counted(0, 1)).why,
             Contains("sends it to top before the target"));
  CHECK_THAT(judged(p, {hit(1, 2, 0), event(EventKind::rest, {}, 3, 1)}, counted(0, 1)).why,
             Contains("sends it not as far as the target"));
  CHECK_THAT(judged(p, {hit(1, 2, 0), hit(2, 3, 0, 1)}, counted(0, 1)).why, Contains(R"(touches ball "2")"));
  CHECK_THAT(judged(p, {bounce(top, 1), bounce(right, 2), hit(1, 3, 0)}, counted(0, 1)).why,
             Contains("meets right before the ball"));
  CHECK_THAT(judged(p, {event(EventKind::rest, {}, 3)}, counted(0, 1)).why, Contains("touches no ball"));
  CHECK_THAT(judged(p, {hit(2, 1, 0)}, counted(0, 1)).why, Contains(R"(runs into ball "2")"));
}

TEST_CASE("success counts a pot by any cushions, but only with the shot's own ball and pocket") {
  const Puzzle p = puzzle(R"("target": {"ball": ["1", "2"], "then": {"pocket": "any"}}, "cushions": 0)");
  Shot shot;
  shot.path.hits = {{.ball = 1}};
  shot.path.then = {{.ball = 1}};
  shot.path.arrival.at = p.table.pockets[2].at;
  Goal goal = counted(0, 0);
  const auto falls = [&](int ball, int pocket) {
    return judged(
        p, {hit(ball, 1, 0), bounce(bottom, 2, ball), event(EventKind::pocket, Contact::pocket(pocket), 3, ball)},
        goal);
  };
  CHECK(!falls(1, 2).made());  // the puzzle allows no cushion
  goal.counts = &shot;
  CHECK(falls(1, 2).made());
  CHECK_THAT(falls(1, 0).why, Contains("sends it into pocket"));
  CHECK_THAT(falls(2, 2).why, Contains("runs into"));
}

TEST_CASE("a combination is hit ball by ball") {
  const Puzzle p =
      puzzle(R"("target": {"ball": "1", "then": {"ball": "2", "then": {"pocket": "any"}}}, "cushions": 0)");
  const TruthEvent fall = event(EventKind::pocket, Contact::pocket(2), 4, 2);
  const Arrived made = judged(p, {hit(1, 1, 0), hit(2, 2, 0, 1), fall}, counted(0, 0));
  CHECK(made.made());
  CHECK(made.ball == 2);
  REQUIRE(made.then.size() == 2);
  CHECK((made.then[0].ball == 1 && made.then[1].ball == 2));
  CHECK_THAT(judged(p, {hit(1, 1, 0), event(EventKind::pocket, Contact::pocket(2), 4, 1)}, counted(0, 0)).why,
             Contains("sends it into pocket"));
}
