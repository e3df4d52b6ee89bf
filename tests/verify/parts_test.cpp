// SPDX-License-Identifier: MIT
//
// The parts of verification: bounds, goals, sequences of cushions, lines of travel, and the cost of a path in speed.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "bankshot/geometry/aim_point.hpp"
#include "planners/verify/bounds.hpp"
#include "planners/verify/goal.hpp"
#include "planners/verify/line_of_travel.hpp"
#include "planners/verify/replay.hpp"
#include "planners/verify/sequence_check.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::planning;

namespace {

const Contact bottom = Contact::rail(0), right = Contact::rail(1), top = Contact::rail(2);

/// Returns a puzzle whose target is a pocket in the middle of the table.
Puzzle to_well() {
  Puzzle p{.table = rectangle_table(4, 2), .physics = rolling_physics(), .ball = {.at = {0.5, 1}}};
  p.table.pockets = {{"well", {2, 1}, 0.1}};
  p.target = PocketTarget{0};
  return p;
}

/// Returns a puzzle in which ball 1 is to touch ball 2, which is to fall into the well.
Puzzle combination() {
  Puzzle p = to_well();
  p.others = {{{1, 1}, p.ball.body, "1"}, {{1.5, 1}, p.ball.body, "2"}};
  Then then;
  then.target = PocketTarget{0};
  then.links = {{CushionRule::exactly(1), 2}};
  p.target = ObjectBallTarget{.balls = {1}, .then = then};
  return p;
}

/// A cushion that is met, in one instant with the last one or not.
struct Met {
  Contact cushion;
  bool same = false;
};

/// Returns 1 for each cushion that is accepted and 0 for the first that is not, then ? if a second bounce is waited
/// for. It is not inlined, since g++ 12 would then warn of bounds that hold.
[[gnu::noinline]] std::string accepted(const std::vector<Contact>* wanted, const std::vector<Met>& met) {
  SequenceCheck check(wanted);
  std::string out;
  for (const Met& m : met) {
    const bool fits = check.accepts(static_cast<int>(out.size()), {EventKind::cushion, m.cushion, m.same});
    out += fits ? '1' : '0';
    if (!fits) return out;
  }
  return check.open() ? out + '?' : out;
}

}  // namespace

TEST_CASE("a number that rounding carried out of its bounds comes back, another does not") {
  const Range bounds{1, 4};
  const auto brought = [&](double v) { return bring_inside(v, bounds) ? v : -1; };
  CHECK(brought(2.5) == 2.5);
  CHECK(brought(1 - 1e-13) == 1);
  CHECK(brought(4 + 1e-13) == 4);
  CHECK(brought(1 - 1e-9) == -1);
  CHECK(brought(4 + 1e-9) == -1);
}

TEST_CASE("bounds of the aim hold in any turn") {
  const auto allowed = [](double angle_deg, const std::optional<Range>& bounds) {
    double angle = radians(angle_deg);
    return inside_aims(angle, bounds) ? degrees(angle) : -1;
  };
  const Range through_zero{radians(350), radians(380)};
  CHECK(allowed(123, {}) == Approx(123));
  CHECK(allowed(355, through_zero) == Approx(355));
  CHECK(allowed(10, through_zero) == Approx(10));
  CHECK(allowed(345, through_zero) == -1);
  CHECK(allowed(25, through_zero) == -1);
  CHECK(allowed(-5, Range{radians(-10), radians(10)}) == Approx(355));
}

TEST_CASE("cushions are compared in order, two of one instant in either order") {
  const std::vector<Contact> wanted{bottom, right, top};
  CHECK(accepted(nullptr, {{top}, {top}}) == "11");
  CHECK(accepted(&wanted, {{bottom}, {right}, {right}}) == "110");
  CHECK(accepted(&wanted, {{right}}) == "1?");  // the first two may still have met in one instant
  CHECK(accepted(&wanted, {{right}, {bottom, true}, {top}}) == "111");
  CHECK(accepted(&wanted, {{right}, {bottom}}) == "10");
  CHECK(accepted(&wanted, {{top}}) == "0");
  CHECK(accepted(&wanted, {{bottom}, {right}, {top}}) == "111");
}

TEST_CASE("a goal asks for the cushions of the puzzle, of a stage or of a shot") {
  Puzzle p = to_well();
  p.cushions = {1, 4, {}};
  const SearchRequest request(p);
  const Goal whole = Goal::of(request);
  CHECK((whole.min == 1 && whole.max == 4 && !whole.sequence && whole.demand == Demand::exact));
  const Goal stage = Goal::exactly(request, 2, Demand::off_centre);
  CHECK((stage.min == 2 && stage.max == 2 && stage.demand == Demand::off_centre));
  Shot shot;
  shot.path.cushions = {bottom, top};
  const Goal again = Goal::along(shot);
  CHECK((again.min == 2 && again.max == 2 && again.sequence == &shot.path.cushions && again.demand == Demand::made));
  CHECK(!again.then);
  const Goal counted = Goal::counted(request, shot);
  CHECK((counted.min == 1 && counted.max == 4 && counted.counts == &shot));
  CHECK(Goal::counted_along(shot).max == 2);
}

TEST_CASE("a goal knows the cushions of each object ball, and counts every fall where none are asked") {
  const Puzzle p = combination();
  const SearchRequest request(p);
  const Goal asked = Goal::of(request);
  CHECK((asked.of_sent(request, 0).min == 1 && asked.of_sent(request, 0).max == 1));
  CHECK((asked.of_sent(request, 1).min == 0 && asked.of_sent(request, 1).max == 0));
  Shot shot;
  shot.path.hits = {{1, 0, 1, {}, 0}};
  shot.path.then = {{1, {top}}, {2, {}}};
  const Goal along = Goal::along(shot);
  CHECK((along.of_sent(request, 0).min == 1 && *along.of_sent(request, 0).sequence == std::vector{top}));
  CHECK(along.allows(1));
  CHECK(!along.allows(2));
  const Goal counted = Goal::counted(request, shot);
  CHECK(counted.of_sent(request, 1).max == max_cushions);  // the last ball may fall by any rails
  CHECK(counted.of_sent(request, 0).max == 1);
  CHECK(counted.allows(1));
  CHECK(!counted.allows(2));
}

TEST_CASE("a line into a pocket is measured from its centre, positive on the left") {
  const Puzzle p = to_well();
  const SearchRequest request(p);
  const AimPoint& well = request.problem->aim_points.front();
  for (const double offset : {0.0, 0.03, -0.05}) {
    Replay replay;
    const Vec2d u{0.6, 0.8};
    measure(request, well, {well.at + perpendicular(u) * offset - u * 0.3, u * 2.5}, replay);
    CHECK(replay.offset == Approx(offset).margin(1e-15));
    CHECK(replay.miss == Approx(std::abs(offset)).margin(1e-15));
  }
}

TEST_CASE("a hit has the cut of its line") {
  const Line line{{0, 0}, {2, 0}};
  const auto cut_at = [&](double y) { return hit_by(line, 2, 1, {0.5, y}, 0.06, 3).cut; };
  CHECK(cut_at(0) == 0);
  CHECK(cut_at(0.03) == Approx(radians(30)));  // half a ball to the left: the object ball leaves to the left
  CHECK(cut_at(-0.03) == Approx(radians(-30)));
  CHECK(cut_at(0.06) == Approx(radians(90)));
  const Hit hit = hit_by(line, 2, 1, {0.5, 0}, 0.06, 3);
  CHECK((hit.ball == 1 && hit.speed == 2 && hit.after == 3 && hit.at == line.at));
  CHECK(hit_by({{0, 0}, {0, 0}}, 0, 1, {0.5, 0.1}, 0.06, 0).cut == 0);  // it stands: no line
}

TEST_CASE("a contact counts within its cuts, ends included") {
  AimPoint ball;
  ball.at = {1, 0};
  ball.reach = 0.06;
  ball.taken_by = Contact::ball(1);
  ball.cuts = Cuts{-0.02, 0, 0.02};
  for (const auto& [offset, made] :
       {std::pair(0.0, true), std::pair(0.02, true), std::pair(0.021, false), std::pair(-0.021, false)}) {
    Replay replay;
    touched(ball, {{0, offset}, {3, 0}}, replay);
    CHECK(replay.made == made);
    CHECK(replay.miss == Approx(std::abs(offset)).margin(1e-16));
    CHECK((replay.failure.reason == FailureReason::other_cut) == !made);
  }
}

TEST_CASE("a path costs the speed that friction and cushions take from it") {
  constexpr double a = 0.1, e = 0.8;
  SpeedAccount account(a);
  const Arc<double> first{{0, 0}, {1, 0}, {}, forever}, second{{2, 0}, {-e, 0}, {}, forever};
  account.add(first, 2);
  account.add(second, 1 / e);
  // v² = e² (v0² − 2 a · 2) − 2 a · 1
  CHECK(account.gain == Approx(e * e));
  CHECK(account.loss == Approx(e * e * 2 * a * 2 + 2 * a));
  const double least = std::sqrt(account.loss / account.gain);
  CHECK(account.beyond(least * (1 - 1e-12)));
  CHECK(!account.beyond(least * (1 + 1e-12)));
}

TEST_CASE("a trace finds that cost on the table, and a replay at this speed arrives as the account says") {
  Puzzle p{.table = rectangle_table(4, 2), .physics = rolling_physics(), .ball = {.at = {1, 1}}};
  p.target = PointTarget{{1, 1.2}, 0.01};
  p.arrive = Range{0.5, 0.5};
  p.cushions = CushionRule::exactly(1);
  const SearchRequest request(p);
  EvaluationBudget budget(10);
  // From y = 1 to the bottom cushion and back up to y = 1.2.
  const double R = p.ball.body.radius, down = 1 - R, up = 1.2 - R, e = restitution(p.physics).at_rest,
               a = deceleration(p.physics);
  const Trace t = trace(request, budget, radians(270), Goal::of(request));
  REQUIRE(t.replay.made);
  CHECK(t.replay.bounces() == 1);
  CHECK(t.account.gain == Approx(e * e));
  CHECK(t.account.loss == Approx(2 * a * (e * e * down + up)));
  const double speed = std::sqrt((0.25 + t.account.loss) / t.account.gain);
  const Replay r = replay(request, budget, {speed, radians(270)}, Goal::of(request));
  REQUIRE(r.made);
  CHECK(r.path.cushions == std::vector{bottom});
  CHECK(r.path.arrival.speed == Approx(0.5).epsilon(1e-12));
  CHECK(budget.simulations() == 2);
}
