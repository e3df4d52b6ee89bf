// SPDX-License-Identifier: MIT
//
// Shots that are one, and the success of a player who errs in more than aim and speed: both by geometry.
#include "planners/evaluate/connected.hpp"

#include <cmath>
#include <vector>

#include "planners/evaluate/success.hpp"
#include "support/catch.hpp"
#include "support/proved.hpp"
#include "support/straight.hpp"

using namespace bankshot;
using namespace bankshot::planning;

namespace {

Puzzle wide() {
  Puzzle p = test::straight();
  p.target = PointTarget{{1.5, 0.5}, 0.1};
  return p;
}

std::vector<Shot> shots_of(const SearchRequest& request, const std::vector<Launch>& launches) {
  std::vector<Shot> out;
  for (const Launch& launch : launches) out.push_back(test::shot_of(request, launch));
  return out;
}

/// Returns the launch speeds of those of these shots that are kept.
std::vector<double> kept(const SearchRequest& request, std::vector<Shot> shots) {
  EvaluationBudget budget(1000);
  keep_connected_once(request, budget, shots);
  std::vector<double> speeds;
  for (const Shot& shot : shots) speeds.push_back(shot.launch.speed);
  return speeds;
}

}  // namespace

TEST_CASE("of shots between which all launches are made the first is kept") {
  Puzzle p = wide();
  const SearchRequest request(p);
  const std::vector<Launch> launches{{1, 0.05}, {2, radians(360) - 0.05}, {1.5, 0}};
  CHECK(kept(request, shots_of(request, launches)) == std::vector{1.0});
  // Another spin is another shot.
  std::vector<Shot> spun = shots_of(request, launches);
  spun[1].spin.side = 0.5;
  CHECK(kept(request, spun) == std::vector{1.0, 2.0});
}

TEST_CASE("shots on two sides of a ball, or by two routes, are not one") {
  Puzzle p = wide();
  p.target = PointTarget{{1.5, 0.5}, 0.2};
  const std::vector<Launch> sides{{1, 0.15}, {1.1, radians(360) - 0.15}, {1.2, 0.16}};
  const SearchRequest open(p);
  CHECK(kept(open, shots_of(open, sides)) == std::vector{1.0});
  p.others = {{{1, 0.5}, p.ball.body, "1"}};
  const SearchRequest blocked(p);
  CHECK(kept(blocked, shots_of(blocked, sides)) == std::vector{1.0, 1.1});
  Puzzle rails = wide();
  rails.physics.cushion = Mirror{.restitution = 1};
  rails.cushions = CushionRule::exactly(1);
  const SearchRequest mirrors(rails);
  // By the top and by the bottom rail the point has one image each, half a metre less a radius away.
  const double aim = std::atan2(2 * (0.5 - rails.ball.body.radius), 1);
  CHECK(kept(mirrors, shots_of(mirrors, {{2, aim}, {2.1, radians(360) - aim}, {2.2, aim + 0.01}})) ==
        std::vector{2.0, 2.1});
}

TEST_CASE("errors of places and of aim add up as their squares") {
  const double at = GENERATE(0.01, 0.05), angle = GENERATE(0.0, 0.04);
  CAPTURE(at, angle);
  Puzzle p = wide();
  p.noise = {.angle = angle, .speed = 0, .at = at};
  const SearchRequest request(p);
  EvaluationBudget budget(100000);
  const Shot shot = shots_of(request, {{1.5, 0}})[0];
  const double found = success_under_all_errors(request, budget, shot);
  CHECK(found == Approx(std::erf(0.1 / std::hypot(at, angle) / std::sqrt(2))).margin(0.012));
  CHECK(success_under_all_errors(request, budget, shot) == found);
}

TEST_CASE("a player who does not know the friction makes a slow shot as often as the ball gets there") {
  Puzzle p = wide();
  p.noise = {.angle = 0, .speed = 0};
  constexpr double error = 5e-4;
  p.physics.errors = CoefficientErrors{{"friction"}, {error * error}};
  const SearchRequest request(p);
  EvaluationBudget budget(100000);
  // The ball must roll the 0.9 m to the edge of the target's disc.
  const double most = GENERATE(0.0097, 0.0101, 0.0106);
  Puzzle sure = p;
  sure.physics.errors.reset();
  std::get<Rolling>(sure.physics.motion).friction = 0.005;  // the shot itself may fall short
  const SearchRequest there(sure);
  const Shot shot = shots_of(there, {{std::sqrt(2 * 9.81 * most * 0.9), 0}})[0];
  CAPTURE(most);
  CHECK(success_under_all_errors(request, budget, shot) ==
        Approx(std::erfc(-(most - 0.01) / error / std::sqrt(2)) / 2).margin(0.02));
}
