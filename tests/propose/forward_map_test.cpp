// SPDX-License-Identifier: MIT
//
// The forward map finds the roots that mirror images give, and tries no speed that cannot arrive.
#include "planners/propose/forward_map.hpp"

#include <algorithm>
#include <cmath>

#include "planners/propose/proposers.hpp"
#include "support/catch.hpp"
#include "support/straight.hpp"

using namespace bankshot;
using namespace bankshot::planning;
using namespace bankshot::planning::propose;

namespace {

/// Returns a roll on a table whose cushions are mirrors, to pass a point at 0.5 m/s after so many of them.
Puzzle mirrors(int cushions) {
  Puzzle p{
      .table = rectangle_table(3, 2), .physics = {Rolling{}, Mirror{.restitution = 1}}, .ball = {.at = {0.7, 0.6}}};
  p.target = PointTarget{{2.1, 1.3}, 0.01};
  p.arrive = Range{0.5, 0.5};
  p.cushions = CushionRule::exactly(cushions);
  return p;
}

/// Returns the images of the point by so many mirrors, from the ball.
std::vector<Vec2d> images(const Puzzle& p, int cushions) {
  const double R = p.ball.body.radius;
  const Vec2d to = std::get<PointTarget>(p.target).at;
  const auto mirrored = [&](double x, double size, int k) {
    return R + (k % 2 == 0 ? k * size + (x - R) : (k + 1) * size - (x - R));
  };
  std::vector<Vec2d> out;
  for (int i = -cushions; i <= cushions; ++i)
    for (int j = -cushions; j <= cushions; ++j)
      if (std::abs(i) + std::abs(j) == cushions)
        out.push_back(Vec2d{mirrored(to.x, 3 - 2 * R, i), mirrored(to.y, 2 - 2 * R, j)} - p.ball.at);
  return out;
}

SearchResult mapped(const Puzzle& p, Wanted wanted) {
  const SearchRequest request(p, wanted);
  EvaluationBudget budget(100000);
  SearchResult found;
  propose::partition(request, budget, found, settings::forward_map::usual);
  return found;
}

}  // namespace

TEST_CASE("the forward map finds every image of a rectangle, with its aim and its speed") {
  const int cushions = GENERATE(0, 1, 2);
  CAPTURE(cushions);
  const Puzzle p = mirrors(cushions);
  const SearchResult found = mapped(p, Wanted::all);
  const std::vector<Vec2d> expected = images(p, cushions);
  CHECK(found.shots.size() == expected.size());
  for (const Vec2d& way : expected) {
    const double speed = std::sqrt(0.25 + 2 * deceleration(p.physics) * norm(way));
    CHECK(std::ranges::any_of(found.shots, [&](const Shot& s) {
      return std::abs(angle_difference(s.launch.angle, std::atan2(way.y, way.x))) < 1e-8 &&
             std::abs(s.launch.speed - speed) < 1e-8;
    }));
  }
}

TEST_CASE("the forward map keeps to the aims that are allowed, and stops at the first shot if that is wanted") {
  Puzzle p = mirrors(1);
  CHECK(mapped(p, Wanted::first).shots.size() == 1);
  p.angle = Range{radians(90), radians(180)};
  const SearchResult found = mapped(p, Wanted::all);
  const auto inside = std::ranges::count_if(images(p, 1), [](const Vec2d& way) { return way.x < 0 && way.y > 0; });
  CHECK(found.shots.size() == static_cast<std::size_t>(inside));
  for (const Shot& s : found.shots) CHECK(p.angle->contains(s.launch.angle));
}

TEST_CASE("the speeds to try begin where a ball just arrives as asked, and are a cell apart at most") {
  Puzzle p = test::straight();  // 1 m ahead, to be passed at 0.5 m/s
  const auto speeds = speeds_to_try(SearchRequest(p), 0.12);
  CHECK(speeds.front() == Approx(std::sqrt(0.25 + 2 * 0.01 * 9.81)));
  CHECK(speeds.back() == Approx(p.speed.high));
  for (std::size_t i = 1; i < speeds.size(); ++i) {
    CHECK(speeds[i] > speeds[i - 1]);
    CHECK(std::log(speeds[i] / speeds[i - 1]) < 0.12 * (1 + 1e-12));
  }
  p.speed = {1, 4};
  CHECK(speeds_to_try(SearchRequest(p), 0.12).front() == Approx(1));
  p.speed = {0.1, 0.4};  // too slow to arrive: the fastest alone is tried
  CHECK(speeds_to_try(SearchRequest(p), 0.12) == std::vector{0.4});
  CHECK(speeds_to_try(SearchRequest(p).launched_at(0.3), 0.12) == std::vector{0.3});
}
