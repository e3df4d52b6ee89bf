// SPDX-License-Identifier: MIT
//
// Searches of one branch: where a roll has a closed form, and by properties of sliding shots.
#include "planners/solve/branch_search.hpp"

#include <cmath>

#include "planners/evaluate/success.hpp"
#include "support/bank.hpp"
#include "support/catch.hpp"
#include "support/flight.hpp"
#include "support/straight.hpp"

using namespace bankshot;
using namespace bankshot::planning;
using branch::BranchSearch;

namespace {

constexpr double slowing = 2 * 0.01 * 9.81;  // m/s²; twice the deceleration of a roll

/// Returns the worked number of solve/point.hpp: a roll of 1 m into a pocket, where it may fall at 0.2 to 3 m/s.
Puzzle into_well(Prefer prefer) {
  Puzzle p = test::straight();
  p.ball.at = {0.4, 0.5};
  p.table.pockets = {{"well", {1.5, 0.5}, 0.1}};
  p.target = PocketTarget{0};
  p.arrive = Range{0.2, 3};
  p.prefer = prefer;
  return p;
}

SearchResult searched(const Puzzle& p, const Launch& launch) {
  const SearchRequest request(p);
  EvaluationBudget budget(10000);
  SearchResult found;
  const Candidate start{launch, request.route.value_or(Route{}), request.problem->aim_points[0], request.spin};
  BranchSearch(request, budget, found, start).search();
  return found;
}

}  // namespace

TEST_CASE("the box of a request has its bounds, and as many free sides as the puzzle leaves") {
  Puzzle p = test::bank();
  p.angle = Range{1, 2};
  p.speed = {0.5, 4};
  p.spin_range = SpinRange{{-1, 1}, {0.25, 0.25}, {0, 0.5}};
  const SearchRequest request(p);
  const branch::Box box = branch::box_of(request);
  CHECK((box.low[branch::aim] == 1 && box.high[branch::aim] == 2));
  CHECK(std::exp(box.low[branch::log_speed]) == Approx(0.5));
  CHECK(std::exp(box.high[branch::log_speed]) == Approx(4));
  CHECK((box.low[branch::top] == -1 && box.high[branch::masse] == 0.5));
  CHECK((box.free(branch::top) && !box.free(branch::side) && box.free(branch::masse)));
  CHECK(!branch::box_of(request.launched_at(2)).free(branch::log_speed));
  p.spin_range.reset();
  CHECK(!branch::box_of(SearchRequest(p)).free(branch::top));
}

TEST_CASE("the freedom of a branch is what its equations leave of aim, speed and spin") {
  Puzzle p = test::bank();
  const auto freedom = [&] { return BranchSearch::freedom(SearchRequest(p)); };
  CHECK(freedom() == 0);
  CHECK(BranchSearch::freedom(SearchRequest(p).launched_at(2)) == 0);
  p.arrive = Range{0.2, 0.6};
  CHECK(freedom() == 1);
  p.spin_range = SpinRange{{-1, 1}, {0, 0.5}, {0, 0}};
  CHECK(freedom() == 3);
  p.arrive = Range{0, 0};
  CHECK(freedom() == 2);
}

TEST_CASE("the best of a curve is at the end of the arrival speeds that is preferred") {
  for (const auto& [prefer, arrival] : {std::pair(Prefer::soft, 0.2), std::pair(Prefer::quick, 3.0)}) {
    const SearchResult found = searched(into_well(prefer), {1, 0.01});
    REQUIRE(found.shots.size() == 1);
    CHECK(found.shots[0].launch.speed == Approx(std::sqrt(arrival * arrival + slowing)).epsilon(1e-3));
    CHECK(angle_difference(0, found.shots[0].launch.angle) == Approx(0).margin(1e-9));
  }
}

TEST_CASE("a bound on the launch cuts a curve, and no shot is kept beyond it") {
  Puzzle p = into_well(Prefer::soft);
  p.speed = {0.8, 2};
  CHECK(searched(p, {1, 0}).shots.at(0).launch.speed == Approx(0.8).epsilon(1e-3));
  p.prefer = Prefer::quick;
  CHECK(searched(p, {1, 0}).shots.at(0).launch.speed == Approx(2).epsilon(1e-3));
  p.angle = Range{0.1, 0.2};
  CHECK(searched(p, {1, 0}).shots.empty());
}

TEST_CASE("a sliding ball's softest bank is softer than all that plays find on the way to its point") {
  Puzzle p = test::bank();
  p.arrive = Range{0.3, 2};
  p.prefer = Prefer::soft;
  const SearchResult found = searched(p, test::near_bank(1.9));
  REQUIRE(found.shots.size() == 1);
  const Launch& launch = found.shots[0].launch;
  const test::Aimed aimed(p);
  const test::Pass pass = test::fly(aimed, launch, p.spin, 10).passes[0];
  CHECK(std::abs(pass.beside) < 1e-9);
  CHECK(pass.fast == Approx(0.3).epsilon(2e-3));
  // Slower launches that pass the point do so too slowly.
  int passing = 0;
  for (int i = -20; i <= 20; ++i) {
    const test::Flight flight = test::fly(aimed, {0.98 * launch.speed, launch.angle + 1e-3 * i}, p.spin, 10);
    REQUIRE(flight.count == 1);
    if (std::abs(flight.passes[0].beside) > 0.02) continue;
    CHECK(flight.passes[0].fast < 0.3);
    ++passing;
  }
  CHECK(passing > 5);
}

TEST_CASE("a climb over free spin ends in natural roll, where the softest launch loses least") {
  Puzzle p = test::straight();
  p.physics = spin_physics();
  p.prefer = Prefer::soft;
  p.spin_range = SpinRange{{-0.5, 1}, {0, 0}, {0, 0}};
  const SearchRequest request(p);
  EvaluationBudget budget(10000);
  SearchResult found;
  const Candidate start{{1.2, 0.01}, {}, request.problem->aim_points[0], {.top = 0}};
  BranchSearch search(request, budget, found, start);
  const auto foot = search.foot();
  REQUIRE(foot);
  CHECK(foot->made());
  CHECK(std::abs(foot->at.off[0].a) < 1e-9);
  search.climb_from(*foot);
  REQUIRE(found.shots.size() == 1);
  const double least = std::sqrt(0.25 + 2 * deceleration(p.physics));
  CHECK(found.shots[0].launch.speed >= least * (1 - 1e-9));
  CHECK(found.shots[0].launch.speed < 1.02 * least);
}

TEST_CASE("tuning never takes success from a shot") {
  Puzzle p = test::bank();
  p.arrive = Range{0.2, 2.5};
  const SearchRequest request(p);
  EvaluationBudget budget(100000);
  SearchResult found = searched(p, test::near_bank(1.9));
  REQUIRE(!found.shots.empty());
  find_success(request, budget, found.shots[0]);
  const double before = *found.shots[0].robustness.value;
  branch::tune(request, budget, found);
  CHECK(*found.shots[0].robustness.value >= before);
  CHECK(test::makes(test::Aimed(p), found.shots[0].launch, p.spin));
}
