// SPDX-License-Identifier: MIT
//
// The parts of a chain as puzzles of their own.
#include "planners/propose/part.hpp"

#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::planning;
using namespace bankshot::planning::propose;

namespace {

/// Returns a puzzle in which ball 3 sends ball 2 onto ball 4, which drops; balls 1 and 5 stand by.
Puzzle three_balls() {
  Puzzle p{.table = rectangle_table(4, 2), .physics = rolling_physics(), .ball = {.at = {0.5, 1}}};
  p.table.pockets = {{"well", {3.4, 1.2}, 0.08}};
  for (const Vec2d at : {Vec2d{0.3, 0.3}, Vec2d{1.5, 1.0}, Vec2d{1.0, 1.0}, Vec2d{2.2, 1.1}, Vec2d{3.5, 0.3}})
    p.others.push_back({at, p.ball.body, std::to_string(p.others.size() + 1)});
  Then then{PocketTarget{0}, CushionRule::exactly(0), {{CushionRule::exactly(0), 2}, {CushionRule::exactly(0), 4}}};
  p.target = ObjectBallTarget{{3}, then};
  p.arrive = Range{0.4, 0.4};
  p.cushions = CushionRule::exactly(0);
  return p;
}

/// Checks that each ball of a part is the one whose number in the whole puzzle it has.
void check_numbers(const Part& part, const Puzzle& whole) {
  REQUIRE(part.numbers.size() == part.puzzle.others.size() + 1);
  for (std::size_t k = 1; k < part.numbers.size(); ++k)
    CHECK(part.puzzle.others[k - 1].id == whole.others[static_cast<std::size_t>(part.numbers[k]) - 1].id);
}

}  // namespace

TEST_CASE("a part keeps the balls that it is about, with their numbers in the whole puzzle") {
  const Puzzle p = three_balls();
  const SearchRequest whole(p);
  const Objects::Chain& chain = whole.problem->objects->chains.front();
  const Part own = by_itself(whole, CushionRule::exactly(2));
  CHECK(own.puzzle.others.empty());
  CHECK(own.whole(0) == 0);
  CHECK((own.puzzle.cushions.min == 2 && own.puzzle.ball.at == p.ball.at));

  const Part before = before_last(whole, chain);
  check_numbers(before, p);
  CHECK(before.numbers == std::vector<int>{0, 1, 2, 3, 5});
  const auto& sent = std::get<ObjectBallTarget>(before.puzzle.target);
  CHECK(before.whole(sent.balls.at(0)) == 3);
  REQUIRE(sent.then.links.size() == 1);
  CHECK(before.whole(sent.then.links[0].ball) == 2);
  CHECK(std::holds_alternative<PointTarget>(sent.then.target));

  const Part last = last_alone(whole, chain);
  check_numbers(last, p);
  CHECK(last.whole(0) == 4);
  CHECK(last.numbers == std::vector<int>{4, 1, 5});
  CHECK(last.puzzle.ball.at == p.others[3].at);
  CHECK(std::holds_alternative<PocketTarget>(last.puzzle.target));
  CHECK(last.puzzle.arrive->low == 0.4);
  CHECK_NOTHROW(validate(last.puzzle));
  const Route route{{0, Contact::rail(1)}, {0, Contact::ball(1)}, {0, Contact::ball(2)}};
  CHECK(last.whole(route) == Route{{4, Contact::rail(1)}, {4, Contact::ball(1)}, {4, Contact::ball(5)}});
}

TEST_CASE("a part that goes to a place is moved from place to place, and a copy stays where it was") {
  const Puzzle p = three_balls();
  SearchRequest whole(p);
  whole.spin = {.top = 0.5};
  ToPlace to(whole, before_last(whole, whole.problem->objects->chains.front()), {});
  const SearchRequest first = to.at({2, 1.5}, 0.25);
  CHECK_NOTHROW(validate(to.part().puzzle));
  const SearchRequest& second = to.at({3, 0.5}, 0.75);
  CHECK(first.problem->aim_points.front().at == Vec2d{2, 1.5});
  CHECK(second.problem->aim_points.front().at == Vec2d{3, 0.5});
  CHECK((first.asked == 0.25 && second.asked == 0.75));
  CHECK((first.starts() && first.spin == whole.spin && !first.pinned));
  CHECK(ToPlace(whole, by_itself(whole, {}), 1.5).at({1, 1}, 0.25).fixed_speed() == 1.5);
}
