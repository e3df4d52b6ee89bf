// SPDX-License-Identifier: MIT
//
// Images of aim points: affine maps, exact lines, unfolded tables against the closed form of a rectangle, and launches
// made from aims.
#include <algorithm>
#include <cmath>
#include <vector>

#include "bankshot/geometry/aim_point.hpp"
#include "bankshot/numbers/random.hpp"
#include "bankshot/scene/scene.hpp"
#include "planners/propose/affine.hpp"
#include "planners/propose/aim.hpp"
#include "planners/propose/exact_line.hpp"
#include "planners/propose/refine.hpp"
#include "planners/propose/unfold.hpp"
#include "planners/propose/window.hpp"
#include "support/catch.hpp"
#include "support/straight.hpp"

using namespace bankshot;
using bankshot::test::straight;
using namespace bankshot::planning;

namespace {

/// Returns a puzzle on a rectangle of centres of 3 m by 2 m, which begins at the origin.
Puzzle ideal(int least, int most) {
  Puzzle p{
      .table = rectangle_table(3, 2), .physics = ideal_physics(), .ball = {.at = {0.7, 0.3}, .body = {.radius = 0}}};
  p.target = PointTarget{{2.1, 1.6}, 0.01};
  p.cushions = {least, most, {}};
  return p;
}

std::vector<Image> all_of(Unfolding& images) {
  std::vector<Image> out;
  while (const auto image = images.next()) out.push_back(*image);
  return out;
}

/// Returns the distances to all images of the target with so many bounces, from the closed form, in order.
std::vector<double> distances(const Puzzle& p, int least, int most) {
  const Vec2d to = std::get<PointTarget>(p.target).at;
  const auto mirrored = [](double x, double size, int k) { return k % 2 == 0 ? k * size + x : (k + 1) * size - x; };
  std::vector<double> out;
  for (int i = -most; i <= most; ++i)
    for (int j = -most; j <= most; ++j)
      if (const int n = std::abs(i) + std::abs(j); n >= least && n <= most)
        out.push_back(norm(Vec2d{mirrored(to.x, 3, i), mirrored(to.y, 2, j)} - p.ball.at));
  std::ranges::sort(out);
  return out;
}

}  // namespace

TEST_CASE("a direction goes back through an affine map, and a reflection stretches nothing") {
  const Affine mirror{-1, 0, 0, 1, {6, 0}};
  CHECK(mirror.apply({1, 2}) == Vec2d{5, 2});
  CHECK(mirror.back({1, 2}) == Vec2d{-1, 2});
  CHECK(mirror.stretch() == 1);
  Random r(92);
  for (int i = 0; i < 200; ++i) {
    const Affine a{r.uniform(-2, 2), r.uniform(-2, 2), r.uniform(-2, 2), r.uniform(-2, 2), {1, 1}};
    const Vec2d d{r.uniform(-1, 1), r.uniform(-1, 1)}, back = a.back(d), again = a.apply(back) - a.shift;
    REQUIRE(std::abs(cross(again, d)) < 1e-14);
    REQUIRE(dot(again, d) >= 0);
    const double x = r.uniform(0, 7);  // no direction is stretched to more than twice the norm
    REQUIRE(norm(a.apply({std::cos(x), std::sin(x)}) - a.shift) <= 2 * a.stretch());
  }
}

TEST_CASE("a ray from the ball follows the exact line of a pocket, in the table and in a mirror") {
  Scene scene = preset_scene("pool-9ft");
  scene.ball.at = {0.9, 0.7};
  const Boundary boundary(scene.table, scene.ball.body);
  Random r(93);
  for (const AimPoint& pocket : aim_points_of(PocketTarget{}, boundary)) {
    for (int i = 0; i < 50; ++i) {
      const Vec2d from{r.uniform(0.3, 2.2), r.uniform(0.3, 0.9)};
      const Vec2d on = on_exact_line(pocket, {}, from), u = (on - from) / norm(on - from);
      const double offset = cross(u, on - pocket.at);
      REQUIRE(std::abs(offset - pocket.exact_offset(u, offset)) < 1e-6 * pocket.reach);
      // Mirrored at x = 0, the ball sees the line from the other side.
      const Affine mirror{-1, 0, 0, 1, {}};
      const Vec2d there = on_exact_line(pocket, mirror, {-from.x, from.y});
      REQUIRE(norm(there - on) < 1e-12);
    }
  }
  AimPoint point;
  point.at = {1, 0.5};
  CHECK(on_exact_line(point, {}, {0.2, 0.2}) == point.at);
}

TEST_CASE("the images of a rectangle are those of the closed form, nearest first, by lattice and by tree") {
  for (const bool tree : {false, true})
    for (const auto& [least, most] : {std::pair(0, 0), std::pair(1, 1), std::pair(2, 3)}) {
      const Puzzle p = ideal(least, most);
      const SearchRequest request(p);
      Unfolding images(request, {.keep_routes = tree});
      const auto found = all_of(images);
      const auto known = distances(p, least, most);
      INFO("tree " << tree << ", " << least << " to " << most);
      REQUIRE(images.whole());
      CHECK(images.shortest_first());
      REQUIRE(found.size() == known.size());
      for (std::size_t i = 0; i < found.size(); ++i) {
        CHECK(found[i].distance == Approx(known[i]).epsilon(1e-13));
        if (tree) CHECK(images.route(found[i]).size() == static_cast<std::size_t>(found[i].bounces));
      }
    }
}

TEST_CASE("a ball that is aimed at an image passes its target after these bounces") {
  const Puzzle p = ideal(1, 4);
  const SearchRequest request(p);
  Unfolding images(request, {.keep_routes = true});
  for (const Image& image : all_of(images)) {
    EvaluationBudget budget(10);
    const Trace t = trace(request, budget, image.angle, Goal::exactly(request, image.bounces));
    REQUIRE(t.replay.made);
    CHECK(t.replay.miss < 1e-12);
    CHECK(t.replay.path.arrival.time == Approx(image.distance).epsilon(1e-12));  // at unit speed
    CHECK(route_by(t.replay.path.cushions) == images.route(image));
  }
}

TEST_CASE("a given route has one image") {
  Puzzle p = ideal(0, 3);
  p.cushions = CushionRule::in_order({Contact::rail(2), Contact::rail(1)});
  const SearchRequest request(p);
  Unfolding images(request, {});
  const auto found = all_of(images);
  REQUIRE(found.size() == 1);
  CHECK(images.route(found[0]) == route_by(*p.cushions.sequence));
  CHECK(norm(found[0].ray - Vec2d{3 + 3 - 2.1 - 0.7, 2 + 2 - 1.6 - 0.3}) < 1e-13);
}

TEST_CASE("the speed of a launch follows from the cost of its path, within the bounds") {
  Puzzle p = straight();
  const auto asked = [&](const Trace& t, SearchResult& found, Demand demand = Demand::exact) {
    return launch_speed(SearchRequest(p), found, 0, t, demand);
  };
  Trace t{{}, SpeedAccount(0)};
  t.account.gain = 0.64;
  t.account.loss = 0.3;
  SearchResult found;
  const double needed = std::sqrt((0.25 + 0.3) / 0.64);
  CHECK(*asked(t, found) == Approx(needed));
  p.arrive = Range{0.5, 1};
  CHECK(*asked(t, found) == Approx(std::sqrt((1 + 0.3) / 0.64)));  // more speed is more robust
  p.prefer = Prefer::soft;
  CHECK(*asked(t, found) == Approx(needed));
  CHECK(found.failures.empty());
  p.speed = {0.1, 0.5};
  CHECK(!asked(t, found));
  REQUIRE(found.failures.size() == 1);
  CHECK(found.failures[0].failure.reason == FailureReason::too_fast);
  CHECK(found.failures[0].failure.speed == Approx(needed));
  p.physics = ideal_physics();
  p.speed = {2, 3};
  p.arrive = {};
  CHECK(*asked(t, found) == ideal_speed(p));
}

TEST_CASE("a straight aim becomes a shot, an aim beside it does not") {
  const Puzzle p = straight();
  const SearchRequest request(p);
  EvaluationBudget budget(100);
  SearchResult found;
  CHECK(certify_aim(request, budget, found, 0, 0, "test"));
  REQUIRE(found.shots.size() == 1);
  CHECK(found.shots[0].launch.speed == Approx(std::sqrt(0.25 + 2 * deceleration(p.physics))));
  CHECK(found.shots[0].provenance.planner == "test");
  CHECK(!certify_aim(request, budget, found, radians(5), 0, "test"));
  CHECK(found.shots.size() == 1);
  CHECK(found.nearest.miss == Approx(std::sin(radians(5))).epsilon(1e-7));
}

TEST_CASE("a window of made aims is found between neighbours that fail differently, and its middle is taken") {
  constexpr double from = 0.333, to = 0.337;
  double certified = -1;
  const auto row = [&](FailureReason below, FailureReason above) {
    return AimRow{[=](double aim) {
                    Replay r;
                    r.made = aim >= from && aim <= to;
                    if (!r.made) r.failure.reason = aim < from ? below : above;
                    return r;
                  },
                  [&](double aim, int) {
                    certified = aim;
                    return true;
                  }};
  };
  EvaluationBudget budget(1000);
  CHECK(find_window(row(FailureReason::missed, FailureReason::hit_ball), budget, {0, 1}, 0.5, 11));
  CHECK(certified == Approx((from + to) / 2).margin(1e-3));
  CHECK((certified >= from && certified <= to));
  CHECK(!find_window(row(FailureReason::missed, FailureReason::missed), budget, {0, 1}, 0.5, 11));
  EvaluationBudget none(0);
  CHECK(!find_window(row(FailureReason::missed, FailureReason::hit_ball), none, {0, 1}, 0.5, 11));
}

TEST_CASE("part of a target is reached where its centre is hidden") {
  Puzzle p = straight();
  p.physics = ideal_physics();
  p.arrive = {};
  p.target = PointTarget{{1.5, 0.5}, 0.06};
  // A ball just beside the line: lines to the centre touch it, lines above do not.
  p.others = {{{1, 0.5 - 2 * p.ball.body.radius + 0.01}, p.ball.body, "1"}};
  const SearchRequest request(p);
  EvaluationBudget budget(1000);
  SearchResult found;
  CHECK(!certify_aim(request, budget, found, 0, 0, "test"));
  CHECK(reach_part(request, budget, found, {-0.06, 0.06}, 0, 9, Goal::exactly(request, 0, Demand::made), "test"));
  REQUIRE(found.shots.size() == 1);
  CHECK(found.shots[0].verification.off_centre);
  CHECK(found.shots[0].launch.angle > 0.01 / 0.5);
  CHECK(found.shots[0].launch.angle < 0.06);
}

TEST_CASE("seeds become roots by the finder that is given, and only roots are kept") {
  const Puzzle p = straight();
  const SearchRequest request(p);
  EvaluationBudget budget(1000);
  SearchResult found;
  const double exact = std::sqrt(0.25 + 2 * deceleration(p.physics));
  int asked = 0;
  refine_images(request, budget, found, "test", [&](const Branch&, const Launch& seed) {
    ++asked;
    CHECK(seed.angle == Approx(0).margin(1e-12));
    CHECK(seed.speed == Approx(exact).epsilon(1e-6));
    return std::optional<Launch>({exact, 0});
  });
  CHECK(asked == 1);
  REQUIRE(found.shots.size() == 1);
  CHECK(found.shots[0].launch.speed == exact);
  SearchResult none;
  const Branch aim{request, {}, request.problem->aim_points.front()};
  CHECK(!refine_aim(aim, budget, none, 0, 1, "test", [](const Branch&, const Launch&) { return std::nullopt; }));
  CHECK(none.shots.empty());
}
