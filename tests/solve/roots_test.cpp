// SPDX-License-Identifier: MIT
//
// Roots of locked paths: what a solver or the cells of a partition lead to, judged by the plain simulator.
#include "planners/solve/roots.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "bankshot/simulate/trajectory.hpp"
#include "planners/solve/levenberg_marquardt.hpp"
#include "support/bank.hpp"
#include "support/catch.hpp"
#include "support/flight.hpp"
#include "support/straight.hpp"

using namespace bankshot;
using namespace bankshot::planning;

namespace {

double exact_speed() { return std::sqrt(0.25 + 2 * 0.01 * 9.81); }

/// A search by cells of 0.05 rad and 0.1 of ln speed for the roots of one puzzle with a straight route.
struct Search {
  explicit Search(const Puzzle& p, Wanted wanted = Wanted::all) : Search(p, wanted, {}) {}
  Search(const Puzzle& p, Wanted wanted, std::vector<Shot> known) : request(p, wanted) {
    found.shots = std::move(known);
    roots.emplace(request, budget, found, Spacing{0.05, 0.1});
  }
  SearchRequest request;
  EvaluationBudget budget{1000};
  SearchResult found{};
  std::optional<Roots> roots{};

  /// Visits a node, and returns the number of simulations spent on it.
  long visit(const Launch& node) {
    const long before = budget.simulations();
    const Branch aim{request, {}, request.problem->aim_points[0]};
    roots->visit(aim, node, linearise(aim, budget, node).value());
    return budget.simulations() - before;
  }
};

}  // namespace

TEST_CASE("a solved launch passes its point exactly, at the speed asked or at its own") {
  const Puzzle p = test::bank();
  const SearchRequest free(p), fixed = free.launched_at(2.2);
  EvaluationBudget budget(1000);
  for (const SearchRequest* request : {&free, &fixed}) {
    const Branch aim{*request, *request->route, request->problem->aim_points[0]};
    const auto root = solve_locked(aim, budget, test::near_bank(2.2));
    REQUIRE(root);
    const test::Pass pass = test::fly(test::Aimed(p), *root, p.spin, 10).passes[0];
    CHECK(std::abs(pass.beside) < 1e-11);
    CHECK((request == &free ? pass.fast : root->speed) == Approx(request == &free ? 0.5 : 2.2).epsilon(1e-9));
  }
  CHECK(budget.simulations() < 100);
}

TEST_CASE("no launch is solved along a route that leads nowhere, or without budget") {
  const Puzzle p = test::bank();
  const SearchRequest request(p);
  EvaluationBudget budget(1000), none(0);
  const Branch aim{request, *request.route, request.problem->aim_points[0]};
  CHECK(!solve_locked(aim, none, test::near_bank(1.9)));
  CHECK(!solve_locked(aim, budget, {1.9, radians(270)}));
}

TEST_CASE("a node within reach leads to the root once, and a known root costs less") {
  const Puzzle p = test::straight();
  Search search(p);
  const long first = search.visit({exact_speed() * 1.05, 0.04});
  REQUIRE(search.found.shots.size() == 1);
  CHECK(search.found.shots[0].launch.speed == Approx(exact_speed()).epsilon(1e-9));
  CHECK(search.found.shots[0].launch.angle == Approx(0).margin(1e-9));
  CHECK(search.visit({exact_speed() * 0.97, -0.03}) < first);
  CHECK(search.found.shots.size() == 1);
  Search again(p, Wanted::all, search.found.shots);
  CHECK(again.visit({exact_speed() * 1.05, 0.04}) < first);
  CHECK(again.found.shots.size() == 1);
}

TEST_CASE("a route without a root is searched from its nearest node at last") {
  const Puzzle p = test::straight();
  Search search(p, Wanted::first);
  for (const double aim : {0.2, 0.15, 0.25}) search.visit({exact_speed(), aim});  // farther than a cell and a half
  CHECK(search.found.shots.empty());
  CHECK(!search.roots->done());
  search.roots->seek_rest();
  REQUIRE(search.found.shots.size() == 1);
  CHECK(search.found.shots[0].launch.speed == Approx(exact_speed()).epsilon(1e-9));
}

TEST_CASE("a root that is no shot becomes a candidate") {
  Puzzle p = test::straight();
  p.others = {{{1, 0.5}, p.ball.body, "1"}};
  Search search(p);
  search.visit({exact_speed(), 0.02});
  CHECK(search.found.shots.empty());
  REQUIRE(search.found.candidates.size() == 1);
  CHECK(search.found.candidates[0].launch.angle == Approx(0).margin(1e-9));
  CHECK(search.found.candidates[0].launch.speed == Approx(exact_speed()).epsilon(1e-9));
}
