// SPDX-License-Identifier: MIT
//
// The legs of a chain's last ball, compared with mirror images, and straight hits, compared with rays.
#include "planners/propose/leg.hpp"

#include <algorithm>
#include <cmath>

#include "bankshot/numbers/random.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::planning;
using namespace bankshot::planning::propose;

namespace {

/// Returns a puzzle in which ball 2 is to drop, by so many cushions; ball 1 stands by.
Puzzle pot_of_second(int cushions) {
  Puzzle p{.table = rectangle_table(4, 2), .physics = {Rolling{}, Mirror{.restitution = 1}}, .ball = {.at = {0.5, 1}}};
  p.table.pockets = {{"well", {3.4, 1.2}, 0.08}};
  p.others = {{{0.3, 0.3}, p.ball.body, "1"}, {{1.5, 1.0}, p.ball.body, "2"}};
  p.target = ObjectBallTarget{{2}, {.target = PocketTarget{0}, .cushions = CushionRule::exactly(cushions)}};
  p.arrive = Range{0.4, 0.4};
  p.cushions = CushionRule::exactly(0);
  return p;
}

}  // namespace

TEST_CASE("the legs of a last ball are the mirror images of its pocket, with its own number") {
  const int cushions = GENERATE(0, 1);
  const Puzzle p = pot_of_second(cushions);
  const SearchRequest request(p);
  const Objects::Chain& chain = request.problem->objects->chains.front();
  EvaluationBudget budget(10000);
  const std::vector<propose::Leg> found = legs(request, budget, chain);
  const Vec2d from = p.others[1].at, well = p.table.pockets[0].at;
  const double R = p.ball.body.radius;
  std::vector<Vec2d> images{well};
  if (cushions == 1)
    images = {{well.x, 2 * R - well.y},
              {2 * (4 - R) - well.x, well.y},
              {well.x, 2 * (2 - R) - well.y},
              {2 * R - well.x, well.y}};
  REQUIRE(found.size() == (cushions == 0 ? 1 : hit_straight(request, chain) ? 3 : 4));
  for (const propose::Leg& leg : found) {
    const Route by(leg.route.begin(), leg.route.end());
    REQUIRE(by.size() == static_cast<std::size_t>(cushions));
    const Vec2d way = images[by.empty() ? 0 : static_cast<std::size_t>(by[0].with.index)] - from;
    CHECK(angle_difference(leg.launch().angle, std::atan2(way.y, way.x)) == Approx(0).margin(1e-9));
    CHECK(leg.launch().speed == Approx(std::sqrt(0.16 + 2 * deceleration(p.physics) * (norm(way) - 0.08))));
    CHECK(leg.aim_point.ball == 2);
    for (const Meeting& m : by) CHECK(m.ball == 2);
    Route whole{{0, Contact::ball(2)}};
    whole.insert(whole.end(), by.begin(), by.end());
    CHECK(together(chain, {}, leg) == whole);
  }
}

TEST_CASE("legs that are known are left out") {
  Puzzle p = pot_of_second(1);
  p.physics = spin_physics();
  const SearchRequest request(p);
  const Objects::Chain& chain = request.problem->objects->chains.front();
  EvaluationBudget budget(100000);
  const std::vector<propose::Leg> all = legs(request, budget, chain);
  REQUIRE(all.size() > 1);
  for (const propose::Leg& known : all)
    for (const propose::Leg& left : legs(request, budget, chain, {known.alone})) CHECK(left.route != known.route);
}

TEST_CASE("a hit is straight for one object ball without cushions and massé") {
  Puzzle p = pot_of_second(0);
  const auto straight = [&] {
    const SearchRequest request(p);
    return hit_straight(request, request.problem->objects->chains.front());
  };
  CHECK(straight());
  p.cushions = {0, 1, {}};
  CHECK(!straight());
  p = pot_of_second(0);
  std::get<ObjectBallTarget>(p.target) = {{2}, {PocketTarget{0}, {}, {{CushionRule::exactly(0), 1}}}};
  CHECK(!straight());  // ball 2 sends ball 1 on
  p = pot_of_second(0);
  p.physics = spin_physics();
  p.spin.masse = 0.2;
  CHECK(!straight());
}

TEST_CASE("a ball is hidden where no straight line touches it before another") {
  constexpr std::uint64_t seed = 5;
  Random random(seed);
  int hidden = 0, seen = 0;
  for (int i = 0; i < 300; ++i) {
    INFO("puzzle " << i << " of seed " << seed);
    Puzzle p = pot_of_second(0);
    const double apart = 2 * p.ball.body.radius;
    const Vec2d ball = p.others[1].at;
    for (int k = 0; k < 3; ++k)
      p.others.push_back({{random.uniform(0.7, 1.4), ball.y + random.uniform(-0.1, 0.1)}, p.ball.body, "more"});
    // The least number of metres to a touch of a circle along a direction; infinite where it is passed.
    const auto until = [&](const Vec2d& u, const Vec2d& at) {
      const double along = dot(u, at - p.ball.at), beside = cross(u, at - p.ball.at);
      return along > 0 && std::abs(beside) < apart ? along - std::sqrt(apart * apart - beside * beside) : infinite;
    };
    const double half = std::asin(apart / norm(ball - p.ball.at)), middle = std::atan2(ball.y - 1, ball.x - 0.5);
    int free = 0;
    constexpr int rays = 2000;
    for (int k = 1; k < rays; ++k) {
      const Vec2d u = direction(middle + half * (2.0 * k / rays - 1));
      free += std::ranges::all_of(
          p.others, [&](const Ball& other) { return other.at == ball || until(u, other.at) > until(u, ball); });
    }
    const SearchRequest request(p);
    const bool found = is_hidden(request, request.problem->objects->chains.front());
    if (free > 0) CHECK(!found);
    if (free == 0) CHECK(found);
    (free > 0 ? seen : hidden) += 1;
  }
  CHECK(hidden > 20);
  CHECK(seen > 20);
}
