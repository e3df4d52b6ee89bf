// SPDX-License-Identifier: MIT
#include "planners/play/next_pot.hpp"

#include "bankshot/scene/json.hpp"
#include "planners/play/worth.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::planning::play;

namespace {

using Places = std::vector<std::optional<Vec2d>>;

Puzzle three_balls(const std::string& leave = R"({"for": "1"})") {
  return read_puzzle(R"({"table": "pool-9ft", "ball": {"at": [1.0, 0.6]}, "others": [{"id": "1", "at": [2.2, 1.0]},
    {"id": "2", "at": [0.3, 0.2]}], "target": {"ball": "2"}, "leave": )" +
                     leave + "}");
}

}  // namespace

TEST_CASE("a near and straight pot is likelier than a far or a thin one") {
  const Puzzle p = three_balls();
  const NextPot next(p);
  const auto chance = [&](const Vec2d& cue) {
    return next.best({{1}}, Places{cue, Vec2d{2.2, 1.0}, Vec2d{0.3, 0.2}}).chance;
  };
  const double near = chance({2.0, 0.8}), far = chance({0.4, 0.3}), thin = chance({2.25, 0.5});
  CHECK(near > 0.95);
  CHECK(far < near);
  CHECK(thin < near);
  CHECK(next.best({{1}}, Places{Vec2d{2.0, 0.8}, Vec2d{2.2, 1.0}, Vec2d{0.3, 0.2}}).pocket ==
        static_cast<int>(std::ranges::find(p.table.pockets, "top-right", &Pocket::name) - p.table.pockets.begin()));
}

TEST_CASE("a ball in the way spoils a pot, and fallen balls have none") {
  const Puzzle p = three_balls();
  const NextPot next(p);
  const Vec2d cue{1.8, 0.64}, object{2.2, 1.0};
  const double open = next.best({{1}}, Places{cue, object, Vec2d{0.3, 0.2}}).chance;
  const double blocked = next.best({{1}}, Places{cue, object, cue + (object - cue) * 0.5}).chance;
  CHECK(open > 0.9);
  CHECK(blocked < open);
  CHECK(next.best({{1}}, Places{cue, std::nullopt, Vec2d{0.3, 0.2}}).pocket == -1);
  CHECK(next.best({{1}}, Places{std::nullopt, object, Vec2d{0.3, 0.2}}).chance == 0);
}

TEST_CASE("a ball is hidden only where others cover all of it") {
  const Puzzle p = three_balls();
  const double R = p.ball.body.radius;
  const Vec2d cue{0.5, 0.6}, object{1.5, 0.6};
  CHECK(can_be_hit(p, 1, Places{cue, object, Vec2d{2.0, 0.6}}));            // behind it
  CHECK(can_be_hit(p, 1, Places{cue, object, Vec2d{1.0, 0.6 + 2.5 * R}}));  // covers half
  CHECK_FALSE(can_be_hit(p, 1, Places{cue, object, Vec2d{0.8, 0.6}}));
  CHECK_FALSE(can_be_hit(p, 1, Places{cue, std::nullopt, Vec2d{0.8, 0.6}}));
}

TEST_CASE("a leave is worth 1 where it is as asked, and 0 elsewhere") {
  const Places there{Vec2d{1.0, 0.5}, Vec2d{2.2, 1.0}, Vec2d{0.3, 0.2}};
  const Puzzle place = three_balls(R"({"point": [1.05, 0.5], "within": 0.06})"),
               off = three_balls(R"({"point": [1.05, 0.5], "within": 0.04})"),
               inside = three_balls(R"({"polygon": [[0.9, 0.4], [1.2, 0.4], [1.0, 0.7]]})"),
               outside = three_balls(R"({"polygon": [[1.5, 0.4], [1.8, 0.4], [1.5, 0.7]]})"),
               hidden = three_balls(R"({"safe": ["1"]})");
  CHECK(LeaveWorth(place)({.places = there}) == 1);
  CHECK(miss_of(*place.leave, *there[0]) == Approx(0.05));
  CHECK(LeaveWorth(off)({.places = there}) == 0);
  CHECK(LeaveWorth(inside)({.places = there}) == 1);
  CHECK(miss_of(*inside.leave, *there[0]) == 0);
  CHECK(LeaveWorth(outside)({.places = there}) == 0);
  CHECK(miss_of(*outside.leave, *there[0]) == Approx(0.5));
  const Puzzle against = three_balls(R"({"against": ["1"]})");
  const double best = NextPot(against).best({{1}}, there).chance;
  CHECK(best > 0);
  CHECK(LeaveWorth(against)({.places = there, .rail_after_contact = true}) == Approx(1 - best));
  CHECK(LeaveWorth(against)({.places = there}) == 0);
  CHECK(LeaveWorth(hidden)({.places = there}) == 0);
  CHECK(LeaveWorth(hidden)({.places = Places{Vec2d{1.0, 0.5}, std::nullopt, Vec2d{0.3, 0.2}}}) == 0);
  CHECK(LeaveWorth(hidden)({.places = Places{Vec2d{1.0, 0.5}, Vec2d{2.2, 1.0}, Vec2d{1.1, 0.54}}}) == 1);
  CHECK(LeaveWorth(place)({.places = Places{std::nullopt, Vec2d{2.2, 1.0}, Vec2d{0.3, 0.2}}}) == 0);
}
