// SPDX-License-Identifier: MIT
//
// The claims of an answer: all of a true answer hold, and each one that is changed is found out.
#include "truth/claims.hpp"

#include <algorithm>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using Catch::Contains;
using truth::Check;
using truth::Claim;

namespace {

constexpr Claim last_claim = Claim::leave;

/// A puzzle with an answer.
struct Answered {
  Puzzle puzzle;
  Answer answer;
};

Answered answered(const std::string& more) {
  Puzzle p = read_puzzle(R"({"id": 7, "about": {"title": "x"}, "table": {"preset": "pool-9ft", "jaws": false},
    "physics": "rolling", "ball": {"at": [0.635, 0.4]}, )" +
                         more + "}");
  Answer a = bankshot::solve(p);
  REQUIRE(a.status == Status::solved);
  return {std::move(p), std::move(a)};
}

const Answered& to_pocket() {
  static const Answered made = answered(R"("target": {"pocket": "top-right"}, "cushions": ["top"],
    "speed": [0.5, 9], "arrive": {"speed": [0, 8]}, "angle": [0, 180])");
  return made;
}

const Answered& to_ball() {
  static const Answered made = answered(R"("others": [{"id": "1", "at": [1.6, 0.7]}, {"id": "2", "at": [0.3, 1.1]}],
    "target": {"ball": "1", "cut": 20}, "cushions": 0)");
  return made;
}

/// Returns the claims that do not hold; each of them says why.
std::set<Claim> wrong(const Answered& a) {
  std::set<Claim> out;
  for (const Check& c : truth::check(&a.puzzle, a.puzzle.id, a.answer))
    if (!c.holds()) {
      out.insert(c.claim);
      CHECK(!c.what.empty());
    }
  return out;
}

}  // namespace

TEST_CASE("every claim has a name of its own, and those of a size have a unit") {
  std::set<std::string_view> names;
  for (int i = 0; i < truth::claims; ++i) names.insert(truth::name(static_cast<Claim>(i)));
  CHECK(static_cast<int>(last_claim) + 1 == truth::claims);
  CHECK(names.size() == truth::claims);
  CHECK(!names.contains(""));
  CHECK(truth::name(Claim::id) == "id");
  CHECK(truth::name(last_claim) == "leave");
  CHECK(truth::name(Claim::asked) == "speed asked");
  CHECK(truth::unit(Claim::place) == "m");
  CHECK(truth::unit(Claim::time) == "s");
  CHECK(truth::unit(Claim::arrival) == "m/s");
  CHECK(truth::unit(Claim::angle) == "rad");
  CHECK(truth::unit(Claim::margin) == "ends");
  CHECK(truth::unit(Claim::success).empty());
}

TEST_CASE("a check holds up to what is allowed") {
  CHECK(Check{Claim::miss, 1e-9, 1e-9}.holds());
  CHECK(!Check{Claim::miss, 2e-9, 1e-9}.holds());
  CHECK(Check{Claim::target}.holds());
}

TEST_CASE("the claims of a true answer hold, those of each shot in order") {
  Answered a = to_pocket();
  a.answer.shots.front().provenance.moved = false;  // what was moved need not arrive at the asked speed
  const std::vector<Check> checks = truth::check(&a.puzzle, a.puzzle.id, a.answer);
  std::set<Claim> seen;
  for (const Check& c : checks) {
    INFO(truth::name(c.claim) << ": " << c.what);
    CHECK(c.holds());
    CHECK(c.shot == 0);
    seen.insert(c.claim);
  }
  CHECK(wrong(to_ball()).empty());
  // A pocket has every claim but those on contacts with balls and on the leave.
  for (int i = 0; i < truth::claims; ++i) {
    INFO(truth::name(static_cast<Claim>(i)));
    CHECK((seen.contains(static_cast<Claim>(i)) || static_cast<Claim>(i) == Claim::hits ||
           static_cast<Claim>(i) == Claim::centre || static_cast<Claim>(i) == Claim::leave));
  }

  Answered all = a;
  all.answer.shots.push_back(all.answer.shots.front());
  all.answer.shots.back().path.arrival.time += 1;
  std::size_t before = 0;
  for (const Check& c : truth::check(&all.puzzle, all.puzzle.id, all.answer)) {
    CHECK(c.shot >= before);
    before = c.shot;
    CHECK(c.holds() == !(c.shot == 1 && c.claim == Claim::time));
  }
  CHECK(before == 1);
}

TEST_CASE("a leave that the simulator does not confirm is found out") {
  Answered a{
      read_puzzle(R"({"table": "pool-9ft", "ball": {"at": [0.635, 0.4]}, "others": [{"id": "1", "at": [1.6, 0.9]}],
    "target": {"ball": "1", "pocket": "any"}, "cushions": 0, "leave": {"point": [2.2, 0.9], "within": 0.3}})"),
      {}};
  a.answer = solve(a.puzzle);
  REQUIRE(a.answer.status == Status::solved);
  CHECK(wrong(a).empty());
  a.answer.shots.front().leave->at.x += 0.001;
  CHECK(wrong(a) == std::set<Claim>{Claim::leave});
  a.answer.shots.front().leave->at.x -= 0.001;
  a.answer.shots.front().leave->miss += 0.001;
  CHECK(wrong(a) == std::set<Claim>{Claim::leave});
}

TEST_CASE("whatever a shot says falsely is found out by its claim, and by that alone") {
  struct Case {
    const char* what;
    Claim claim;
    std::function<void(Answer&, Shot&)> change;
    bool ball = false;  ///< a puzzle with a ball as its target
    bool alone = true;  ///< no other claim fails with it
  };
  const Case cases[] = {
      {"another id", Claim::id, [](Answer& a, Shot&) { a.id += '8'; }},
      {"another about", Claim::form, [](Answer& a, Shot&) { a.about += ' '; }},
      {"no message", Claim::form, [](Answer& a, Shot&) { a.message.clear(); }},
      {"jaws", Claim::form, [](Answer&, Shot& s) { s.path.touches_jaws = true; }, false, false},
      {"invalid", Claim::status, [](Answer& a, Shot&) { a.status = Status::invalid; }, false, false},
      {"a faster launch", Claim::speed, [](Answer&, Shot& s) { s.launch.speed = 9.1; }, false, false},
      {"an aim outside", Claim::angle, [](Answer&, Shot& s) { s.launch.angle = radians(200.0); }, false, false},
      {"a spin", Claim::spin, [](Answer&, Shot& s) { s.spin.side = 0.1; }, false, false},
      {"no cushion", Claim::rule, [](Answer&, Shot& s) { s.path.cushions.clear(); }, false, false},
      {"another cushion", Claim::cushions, [](Answer&, Shot& s) { s.path.cushions[0] = Contact::rail(0); }, false,
       false},
      {"an aim beside the pocket", Claim::target, [](Answer&, Shot& s) { s.launch.angle += 0.15; }, false, false},
      {"a miss", Claim::miss, [](Answer&, Shot& s) { s.verification.miss += 1e-6; }},
      {"an offset", Claim::offset, [](Answer&, Shot& s) { s.verification.offset += 1e-6; }},
      {"another place", Claim::place, [](Answer&, Shot& s) { s.path.arrival.at.x += 1e-6; }},
      {"another time", Claim::time, [](Answer&, Shot& s) { s.path.arrival.time += 1e-5; }},
      {"another speed", Claim::arrival, [](Answer&, Shot& s) { s.path.arrival.speed += 1e-4; }},
      {"another condition", Claim::condition, [](Answer&, Shot& s) { s.verification.condition *= 1.001; }},
      {"a wider margin", Claim::margin, [](Answer&, Shot& s) { *s.robustness.margin->angle[1] *= 1.1; }},
      {"a narrower margin", Claim::margin, [](Answer&, Shot& s) { *s.robustness.margin->angle[0] *= 0.9; }},
      {"a success above 1", Claim::success, [](Answer&, Shot& s) { s.robustness.success = 1.1; }, false, false},
      {"another value", Claim::value, [](Answer&, Shot& s) { *s.robustness.value += 1e-6; }},
      {"another cut", Claim::hits, [](Answer&, Shot& s) { s.path.hits[0].cut += 1e-4; }, true},
      {"another ball", Claim::hits, [](Answer&, Shot& s) { s.path.hits[0].ball = 2; }, true, false},
      {"no hit", Claim::hits, [](Answer&, Shot& s) { s.path.hits.clear(); }, true, false},
      {"a slower hit", Claim::hits, [](Answer&, Shot& s) { s.path.hits[0].speed *= 0.999; }, true},
      {"a ball that goes on", Claim::hits,
       [](Answer&, Shot& s) {
         s.path.then.push_back({1, {}});
       },
       true},
  };
  std::set<Claim> found;
  for (const Case& c : cases) {
    INFO(c.what);
    Answered changed = c.ball ? to_ball() : to_pocket();
    c.change(changed.answer, changed.answer.shots.front());
    const std::set<Claim> off = wrong(changed);
    CHECK(off.contains(c.claim));
    if (c.alone) CHECK(off == std::set{c.claim});
    found.insert(c.claim);
  }

  // The launch is true, but not what the puzzle asks for.
  Answered asked = to_pocket();
  asked.answer.shots.front().provenance.moved = false;
  const double arrives = asked.answer.shots.front().path.arrival.speed;
  asked.puzzle.arrive = Range{arrives + 0.1, arrives + 0.2};
  CHECK(wrong(asked).contains(Claim::asked));
  found.insert(Claim::asked);

  // A launch off the centre that does not say so.
  Answered beside = to_ball();
  Shot& shot = beside.answer.shots.front();
  REQUIRE(!shot.verification.off_centre);
  shot.launch.angle += 0.2 * shot.robustness.margin->angle[1].value();
  CHECK(wrong(beside).contains(Claim::centre));
  found.insert(Claim::centre);
  CHECK(static_cast<int>(found.size()) == truth::claims - 1);  // the leave has a test of its own
}

TEST_CASE("a shot that guarantees no digits is held to its bounds alone") {
  Answered a = to_pocket();
  Shot& shot = a.answer.shots.front();
  shot.verification.digits = 0;
  shot.path.arrival.time += 1;
  CHECK(wrong(a).empty());
  shot.launch.speed = 20;
  CHECK(wrong(a).contains(Claim::speed));
  a = to_pocket();
  a.answer.shots.front().verification.digits = 4;
  a.answer.shots.front().verification.miss += 1e-5;  // allowed: 1e-4 of the diagonal
  CHECK(wrong(a).empty());
}

TEST_CASE("an answer has the form of its status") {
  const Puzzle p = to_pocket().puzzle;
  const auto off = [&](const Answer& a, const Puzzle* puzzle) {
    std::set<Claim> out;
    for (const Check& c : truth::check(puzzle, puzzle ? puzzle->id : "", a))
      if (!c.holds()) out.insert(c.claim);
    return out;
  };
  Answer none;
  none.id = p.id, none.about = p.about, none.status = Status::no_shot, none.message = "There is no shot.";
  CHECK(off(none, &p).empty());
  none.shots.emplace_back(to_pocket().answer.shots.front());
  CHECK(off(none, &p) == std::set{Claim::form});
  none.shots.clear();
  none.status = Status::solved;
  CHECK(off(none, &p) == std::set{Claim::form});
  none.status = Status::budget;
  none.nearest = Answer::Nearest{{}, "why"};
  CHECK(off(none, &p) == std::set{Claim::form});

  // An answer to text that cannot be read is `invalid`, with a reason.
  Answer invalid = invalid_answer("", InvalidInput("/ball", "is missing"));
  CHECK(off(invalid, nullptr).empty());
  CHECK(off(invalid, &p).contains(Claim::status));
  invalid.error.reset();
  CHECK(off(invalid, nullptr) == std::set{Claim::form});
  Answer budget;
  budget.status = Status::budget, budget.message = "The budget is spent.";
  CHECK(off(budget, nullptr) == std::set{Claim::status});
}
