// SPDX-License-Identifier: MIT
//
// The last ball of a route on the real table, compared with the plain simulator; and the obstacles of a leg.
#include "planners/trace/falls_by.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "bankshot/simulate/trajectory.hpp"
#include "planners/trace/in_the_way.hpp"
#include "support/catch.hpp"
#include "support/random_layout.hpp"

using namespace bankshot;
using namespace bankshot::planning;

namespace {

using Falls = std::optional<std::vector<Contact>>;

/// Returns the cushions by which a ball falls into a pocket, by the plain simulator; none where it does not, or by more
/// cushions than `most`.
Falls by_play(const Trajectory& path, Contact pocket, std::size_t most) {
  std::vector<Contact> by;
  for (const Record& e : path.events) {
    if (e.kind == EventKind::cushion) by.push_back(e.contact);
    if (e.kind == EventKind::pocket && e.contact == pocket && by.size() <= most) return by;
  }
  return {};
}

Trajectory played(const Puzzle& p, const Launch& launch) {
  return simulate({{}, p.table, p.physics, p.ball, p.others, launch, {}, {}});
}

/// Returns a random layout that asks for a pot of ball 1 into any pocket by at most two cushions.
Puzzle random_pot(Random& random) {
  Puzzle p = test::random_layout(random, 1);
  p.spin_range.reset();
  p.target = ObjectBallTarget{{1}, {.target = PocketTarget{}, .cushions = CushionRule{0, 2, {}}}};
  return p;
}

/// Returns whether the cue ball meets ball 1 first of all, and the two never meet again.
bool meets_once(const Trajectory& t) {
  const auto met = [](const Record& e) { return e.kind == EventKind::ball; };
  const auto bounces = [](const Record& e) { return is_bounce(e.kind); };
  return std::ranges::count_if(t.events, met) == 1 &&
         std::ranges::find_if(t.events, met) < std::ranges::find_if(t.events, bounces);
}

}  // namespace

TEST_CASE("a cue ball falls by the cushions by which the simulator lets it fall") {
  constexpr std::uint64_t seed = 11;
  Random random(seed);
  Puzzle p = test::random_layout(random, 0);
  p.spin_range.reset();
  p.target = PocketTarget{};
  p.cushions = {0, 2, {}};
  const SearchRequest request(p);
  EvaluationBudget budget(100000);
  std::size_t banks = 0, falls = 0;
  for (int i = 0; i < 400; ++i) {
    const Launch launch{random.uniform(1, 5), random.uniform(0, radians(360))};
    INFO("launch " << i << " of seed " << seed << ": " << launch.speed << " m/s at " << launch.angle << " rad");
    const Trajectory t = played(p, launch);
    for (const AimPoint& aim_point : request.problem->aim_points) {
      const Falls found = falls_by({request, {}, aim_point}, budget, launch);
      CHECK(found == by_play(t, aim_point.taken_by, 2));
      falls += found ? 1 : 0;
      banks += found && !found->empty() ? 1 : 0;
    }
  }
  CHECK(falls > 20);
  CHECK(banks > 5);
}

TEST_CASE("an object ball falls by the cushions by which the simulator lets it fall, unless it meets a ball again") {
  constexpr std::uint64_t seed = 12;
  Random random(seed);
  std::size_t falls = 0, compared = 0;
  for (int i = 0; i < 300; ++i) {
    const Puzzle p = random_pot(random);
    const SearchRequest request(p);
    EvaluationBudget budget(1000);
    const Vec2d to = p.others[0].at - p.ball.at;
    const double widest = 2 * p.ball.body.radius / norm(to);
    const Launch launch{random.uniform(1, 4), wrap_angle(std::atan2(to.y, to.x) + random.uniform(-widest, widest))};
    INFO("puzzle " << i << " of seed " << seed);
    const Trajectory t = played(p, launch), object = path_of(t, 1);
    if (!meets_once(t)) continue;
    ++compared;
    const Route hit{{0, Contact::ball(1)}};
    for (const AimPoint& aim_point : request.problem->aim_points) {
      const Falls found = falls_by({request, hit, aim_point}, budget, launch);
      CHECK(found == by_play(object, aim_point.taken_by, 2));
      falls += found ? 1 : 0;
    }
  }
  CHECK(compared > 150);
  CHECK(falls > 20);
}

TEST_CASE("nothing falls where the route leads nowhere, or the budget is spent") {
  Random random(1);
  const Puzzle p = random_pot(random);
  const SearchRequest request(p);
  EvaluationBudget budget(1);  // the first call spends it
  const Vec2d away = p.ball.at - p.others[0].at;
  const Route hit{{0, Contact::ball(1)}};
  CHECK(!falls_by({request, hit, request.problem->aim_points[0]}, budget, {2, std::atan2(away.y, away.x)}));
  CHECK(budget.spent());
  CHECK(!falls_by({request, hit, request.problem->aim_points[0]}, budget, {2, std::atan2(-away.y, -away.x)}));
}

TEST_CASE("a leg is in the way of all round obstacles but those at its ends and balls that have gone") {
  // A table with one vertex that points inwards, two pockets and three balls.
  Puzzle p{.table = polygon_table({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}), .ball = {.at = {0.2, 0.2}}};
  p.table.pockets = {{"low", {1.6, 0.5}, 0.06}, {"high", {0.5, 1.6}, 0.06}};
  for (const Vec2d at : {Vec2d{0.5, 0.5}, Vec2d{0.8, 0.5}, Vec2d{0.5, 0.9}})
    p.others.push_back({at, p.ball.body, std::to_string(p.others.size() + 1)});
  const Boundary boundary(p.table, p.ball.body, p.others);
  const Contact vertex = Contact::vertex(3), low = Contact::pocket(0), high = Contact::pocket(1);
  const auto seen = [&](const Route& before, Contact next, Contact taken_by) {
    std::set<Contact> out;
    each_in_the_way(boundary, before, next, taken_by, [&](const Circle& c) { out.insert(c.contact); });
    return out;
  };
  const auto ball = [](int k) { return Contact::ball(k); };
  using Set = std::set<Contact>;
  CHECK(seen({}, {}, {}) == Set{vertex, low, high, ball(1), ball(2), ball(3)});
  CHECK(seen({}, {}, high) == Set{vertex, low, ball(1), ball(2), ball(3)});
  CHECK(seen({}, vertex, high) == Set{low, high, ball(1), ball(2), ball(3)});
  CHECK(seen({{0, vertex}}, {}, high) == Set{low, ball(1), ball(2), ball(3)});
  CHECK(seen({{0, vertex}, {0, Contact::rail(0)}}, {}, high) == Set{vertex, low, ball(1), ball(2), ball(3)});
  CHECK(seen({{0, ball(1)}, {1, Contact::rail(0)}}, ball(3), low) == Set{vertex, low, high, ball(2)});
}
