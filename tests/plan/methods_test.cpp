// SPDX-License-Identifier: MIT
//
// The planners that a user can name: their list, and the same roots by each of them. It compiles without NLopt too.
#include "planners/methods/methods.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "planners/methods/nlopt.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::planning;

namespace {

/// Returns a roll on a table whose cushions are mirrors, to pass a point at 0.5 m/s after one of them.
Puzzle mirrors() {
  Puzzle p{
      .table = rectangle_table(3, 2), .physics = {Rolling{}, Mirror{.restitution = 1}}, .ball = {.at = {0.7, 0.6}}};
  p.target = PointTarget{{2.1, 1.3}, 0.01};
  p.arrive = Range{0.5, 0.5};
  p.cushions = CushionRule::exactly(1);
  p.speed = {0.3, 2};
  return p;
}

/// Returns whether a launch is aimed at one of the four images of the point, at the speed that rolling there takes.
bool is_root(const Puzzle& p, const Launch& launch) {
  const double R = p.ball.body.radius;
  const Vec2d to{2.1, 1.3};
  return std::ranges::any_of(std::array{Vec2d{to.x, 2 * R - to.y}, Vec2d{2 * (3 - R) - to.x, to.y},
                                        Vec2d{to.x, 2 * (2 - R) - to.y}, Vec2d{2 * R - to.x, to.y}},
                             [&](const Vec2d& image) {
                               const Vec2d way = image - p.ball.at;
                               const double speed = std::sqrt(0.25 + 2 * deceleration(p.physics) * norm(way));
                               return std::abs(angle_difference(launch.angle, std::atan2(way.y, way.x))) < 1e-8 &&
                                      std::abs(launch.speed - speed) < 1e-8;
                             });
}

}  // namespace

TEST_CASE("each planner has a name of its own by which it is found, and an unknown name is told the known ones") {
  std::set<std::string> names;
  for (const methods::Method& m : methods::all()) {
    names.emplace(m.info.name);
    CHECK(&methods::find(std::string(m.info.name)) == &m);
    CHECK(!m.info.summary.empty());
  }
  CHECK(names.size() == methods::all().size());
  REQUIRE(planners().size() == methods::all().size());
  for (const PlannerInfo& info : planners()) CHECK(names.contains(std::string(info.name)));
  try {
    methods::find("guess");
    FAIL("an unknown planner was found");
  } catch (const InvalidInput& e) {
    for (const std::string& name : names) CHECK_THAT(e.what(), Catch::Contains(name));
  }
}

TEST_CASE("each planner finds a shot of a bank, and only roots that mirror images give") {
  const Puzzle p = mirrors();
  const SearchRequest request(p);
  for (const methods::Method& m : methods::all()) {
    CAPTURE(m.info.name);
    EvaluationBudget budget(100000);
    SearchResult found;
    m.plan(request, budget, found);
    CHECK(!found.shots.empty());
    for (const Shot& shot : found.shots) CHECK(is_root(p, shot.launch));
  }
}

TEST_CASE("the planners of NLopt are in the list, and without NLopt the global search finds nothing") {
  const auto nlopt = methods::nlopt_methods();
  for (const methods::Method& m : nlopt) {
    CHECK(m.info.name.starts_with("nlopt-"));
    CHECK(methods::find(std::string(m.info.name)).plan == m.plan);
  }
  const auto named = [](const methods::Method& m) { return m.info.name.starts_with("nlopt-"); };
  CHECK(std::ranges::count_if(methods::all(), named) == static_cast<std::ptrdiff_t>(nlopt.size()));
  const Puzzle p = mirrors();
  const SearchRequest request(p);
  EvaluationBudget budget(100000), none(0);
  SearchResult found, nothing;
  methods::search_box(request, none, nothing, "box");
  CHECK(nothing.shots.empty());
  methods::search_box(request, budget, found, "box");
  CHECK(found.shots.empty() == nlopt.empty());
  for (const Shot& shot : found.shots) {
    CHECK(is_root(p, shot.launch));
    CHECK(shot.provenance.planner == "box");
  }
}
