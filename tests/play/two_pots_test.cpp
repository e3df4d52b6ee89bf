// SPDX-License-Identifier: MIT
#include "planners/play/two_pots.hpp"

#include <limits>

#include "bankshot/scene/json.hpp"
#include "planners/verify/aftermath.hpp"
#include "support/catch.hpp"
#include "support/played.hpp"

using namespace bankshot;
using namespace bankshot::planning;
using namespace bankshot::planning::play;

namespace {

using Places = std::vector<std::optional<Vec2d>>;

/// Ball 1 is to fall now, then 2, then 3.
Puzzle three_balls() {
  return read_puzzle(R"({"table": "pool-9ft", "ball": {"at": [1.0, 0.6], "spin": {"top": [-1, 1]}},
    "others": [{"id": "1", "at": [1.3, 0.9]}, {"id": "2", "at": [2.2, 1.0]}, {"id": "3", "at": [2.25, 0.25]}],
    "target": {"ball": "1", "pocket": "any"}, "leave": {"for": ["2", "3"]}})");
}

}  // namespace

TEST_CASE("two pots: the chance of the next, times that of the one after it") {
  const Puzzle p = three_balls();
  const SearchRequest request(p);
  EvaluationBudget budget(std::numeric_limits<long>::max());
  const NextPot next(p);
  const PottingOrder order{{2}, {3}};
  const auto two = [&](const Ending& ending) { return two_pots(request, budget, next, order, ending); };
  const Ending both{.places = {Vec2d{1.9, 0.8}, std::nullopt, Vec2d{2.2, 1.0}, Vec2d{2.25, 0.25}}};
  const double first = next.best(order, both.places).chance, value = two(both);
  CHECK(value > 0.5);
  CHECK(value <= first);
  CHECK(budget.simulations() > 0);
  // The ball after the next one is behind another that stays.
  Ending hidden = both;
  hidden.places[1] = Vec2d{2.4, 0.12};
  CHECK(two(hidden) < value);
  // Without a ball after the next one, and without any ball.
  const Ending last{.places = {Vec2d{1.9, 0.8}, std::nullopt, Vec2d{2.2, 1.0}, std::nullopt}};
  CHECK(two(last) == Approx(first));
  const Ending none{.places = {Vec2d{1.9, 0.8}, Vec2d{1.3, 0.9}, std::nullopt, std::nullopt}};
  CHECK(two(none) == 1);
}

TEST_CASE("play_on: a shot from where balls rest is the one that the simulator plays there") {
  Puzzle p = three_balls();
  const SearchRequest request(p);
  EvaluationBudget budget(std::numeric_limits<long>::max());
  const Launch launch{2, 0.5};
  const LaunchSpin spin{.top = 0.5};
  const Places places =
      play_on(request, budget, Places{Vec2d{1.9, 0.8}, std::nullopt, Vec2d{2.2, 1.0}, Vec2d{1.1, 0.3}}, launch, spin);
  p.ball.at = {1.9, 0.8};
  p.others = {p.others[1], p.others[2]};
  p.others[1].at = {1.1, 0.3};
  const Places judged = test::played(p, launch, spin);
  REQUIRE(places.size() == 4);
  CHECK_FALSE(places[1]);
  for (const auto& [here, there] : {std::pair(0, 0), {2, 1}, {3, 2}}) {
    REQUIRE(places[here].has_value() == judged[there].has_value());
    if (places[here]) CHECK(norm(*places[here] - *judged[there]) < 1e-9);
  }
}
