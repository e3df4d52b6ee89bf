// SPDX-License-Identifier: MIT
//
// Places of a ball's centre as the simulator sees them, and directions that an angle in double precision cannot hold.
#include "bankshot/geometry/boundary.hpp"

#include <cmath>
#include <limits>

#include "bankshot/scene/ball.hpp"
#include "support/catch.hpp"

using namespace bankshot;

namespace {

/// A square of side 2 without its upper right quarter: vertex 3 at (1, 1) is reflex.
Table l_shape() { return polygon_table({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}); }

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("clearance is the distance to the nearest cushion less the radius") {
  const Boundary b(rectangle_table(2, 1), {0.1});
  CHECK(b.clearance({1, 0.5}) == Approx(0.4));
  CHECK(b.clearance({0.3, 0.5}) == Approx(0.2));
  CHECK(b.clearance({0.1, 0.5}) == Approx(0).margin(1e-15));
  CHECK(b.clearance({0.05, 0.5}) == Approx(-0.05));  // inside the table, but in the cushion
  CHECK(b.clearance({-1, 0.5}) == Approx(-1.1));
  CHECK(b.clearance({-3, 1 + 4}) == Approx(-5.1));  // beyond a corner
}

TEST_CASE("clearance near a reflex vertex is measured round it") {
  const Boundary b(l_shape(), {0.1});
  CHECK(b.clearance({0.7, 0.6}) == Approx(0.4));  // 3-4-5 triangle to the tip
  CHECK(b.clearance({1.5, 1.5}) < 0);             // in the part cut away
  CHECK(b.clearance({0.5, 1.5}) == Approx(0.4));
}

TEST_CASE("walls are the cushions moved inwards, their ends where the ball touches two") {
  const Boundary b(rectangle_table(2, 1), {0.1});
  REQUIRE(b.walls.size() == 4);
  CHECK(b.walls[0].normal == Vec2d{0, 1});
  CHECK(b.walls[0].offset == Approx(0.1));
  CHECK(norm(b.walls[0].from - Vec2d{0.1, 0.1}) < 1e-15);
  CHECK(norm(b.walls[0].to - Vec2d{1.9, 0.1}) < 1e-15);
  CHECK(b.walls[1].normal == Vec2d{-1, 0});
  CHECK(b.diagonal == Approx(std::sqrt(5)));
}

TEST_CASE("only a ball with a radius meets a tip, and only at reflex vertices") {
  const Boundary ball(l_shape(), {0.1}), point(l_shape(), {0});
  REQUIRE(ball.tips.size() == 1);
  CHECK(ball.tips[0].centre == Vec2d{1, 1});
  CHECK(ball.tips[0].radius == 0.1);
  CHECK(ball.tips[0].contact == Contact::vertex(3));
  CHECK(contact_name(l_shape(), ball.tips[0].contact) == "v3");
  CHECK(contact_name(l_shape(), Contact::rail(2)) == "c2");
  CHECK(point.tips.empty());
  CHECK(Boundary(rectangle_table(2, 1), {0.1}).tips.empty());
  CHECK(!ball.unfolds());
  CHECK(point.unfolds());
}

TEST_CASE("obstacles are where the table's cushions are, a reflex vertex is a bend between two of them") {
  const Obstacles there = obstacles(l_shape());
  REQUIRE(there.segments.size() == 6);
  CHECK(there.segments[3].from == Vec2d{1, 1});
  CHECK(there.segments[3].contact == Contact::rail(3));
  REQUIRE(there.bends.size() == 1);
  const Bend& b = there.bends[0];
  CHECK(b.centre == Vec2d{1, 1});
  CHECK(b.radius == 0);
  CHECK(norm(b.middle - Vec2d{-1, -1} / std::sqrt(2)) < 1e-15);
  CHECK(b.half == Approx(radians(45)));
  CHECK(b.before == Contact::rail(2));
  CHECK(b.after == Contact::rail(3));
  // The corner may be sharp or flat: its extent is half the turn on either side.
  for (const double turn : {1e-9, 0.3, 2.0, 3.1}) {
    const Vec2d on = direction(radians(90) - turn);
    const auto bends = obstacles(polygon_table({{0, 0}, {0, 1}, Vec2d{0, 1} + on, {-5, 1}})).bends;
    REQUIRE(!bends.empty());
    CHECK(bends[0].half == Approx(turn / 2));
    CHECK(norm(bends[0].middle - perpendicular(direction(radians(90) - turn / 2))) < 1e-14);
  }
}

TEST_CASE("the extent of a tip holds all places where a ball can touch it, and ends behind the cushions") {
  const Circle tip = Boundary(l_shape(), {0.1}).tips.at(0);
  const auto covers = [&](double degrees) { return tip.covers(tip.centre + direction(radians(degrees)) * tip.radius); };
  for (const double at : {180.0, 225.0, 270.0, 180.0 - 60, 270.0 + 60}) CHECK(covers(at));
  for (const double at : {0.0, 45.0, 90.0}) CHECK(!covers(at));
  const Circle tiny = Boundary(l_shape(), {1e-12}).tips.at(0);
  CHECK(tiny.covers(tiny.centre + Vec2d{1e-12, 1e-12}));  // rounding may carry so small a ball round the tip
}

TEST_CASE("a collinear vertex is no tip, and its table is not strictly convex") {
  const Boundary b(polygon_table({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}}), {0.1});
  CHECK(b.tips.empty());
  CHECK(!b.strictly_convex);
  CHECK(norm(b.walls[0].to - Vec2d{1, 0.1}) < 1e-15);
  CHECK(norm(b.walls[1].from - Vec2d{1, 0.1}) < 1e-15);
  CHECK(b.clearance({1, 0.3}) == Approx(0.2));
}

TEST_CASE("convex polygons are strictly convex and others are not, whatever the radius") {
  for (const double radius : {0.0, 0.05}) {
    CHECK(Boundary(rectangle_table(2, 1), {radius}).strictly_convex);
    CHECK(Boundary(polygon_table({{0, 0}, {2, 0}, {0.3, 1.5}}), {radius}).strictly_convex);
    CHECK(!Boundary(l_shape(), {radius}).strictly_convex);
  }
}

TEST_CASE("the distance to the centres is 0 inside and goes to the nearest place outside") {
  const Boundary b(rectangle_table(2, 1), {0.1});
  CHECK(b.distance_to_centres({1, 0.5}) == 0);
  CHECK(b.distance_to_centres({1, 0}) == Approx(0.1));
  CHECK(b.distance_to_centres({0, 0}) == Approx(0.1 * std::sqrt(2)));  // why a corner pocket needs its width
  CHECK(b.distance_to_centres({2.3, 1.2}) == Approx(0.5));
  const Boundary l(l_shape(), {0.1});
  CHECK(l.distance_to_centres({1, 1}) == Approx(0.1));  // the centre goes round the tip
  CHECK(l.distance_to_centres({1.5, 1}) == Approx(0.1));
}

TEST_CASE("pockets of radius 0 become points of the tolerance") {
  Table t = rectangle_table(3, 4);
  t.pockets = {{"a", {0, 0}, 0}, {"b", {3, 4}, 0.25}};
  const Boundary b(t, {0});
  REQUIRE(b.pockets.size() == 2);
  CHECK(b.pockets[0].radius == Approx(5e-9));
  CHECK(b.pockets[1].radius == 0.25);
  CHECK(b.pockets[1].contact == Contact::pocket(1));
}

TEST_CASE("directions at multiples of 90 degrees are exact") {
  CHECK(direction(radians(0)) == Vec2d{1, 0});
  CHECK(direction(radians(90)) == Vec2d{0, 1});
  CHECK(direction(radians(180)) == Vec2d{-1, 0});
  CHECK(direction(radians(270)) == Vec2d{0, -1});
  CHECK(direction(radians(-90)) == Vec2d{0, -1});
  CHECK(direction(radians(360)) == Vec2d{1, 0});
}

TEST_CASE("directions near a multiple of 90 degrees keep what the angle says") {
  CHECK(direction(1e-300).y == 1e-300);
  CHECK(direction(radians(180) + 1e-14).y != 0);
  for (int i = 0; i < 360; ++i) CHECK(norm(direction(radians(i))) == Approx(1).epsilon(1e-15));
}

TEST_CASE("wrap_angle brings every angle between 0 and 2 pi, without the latter") {
  const double turn = radians(360);
  CHECK(wrap_angle(0) == 0);
  CHECK(wrap_angle(turn) == 0);
  CHECK(wrap_angle(-turn) == 0);
  CHECK(wrap_angle(1) == 1);
  CHECK(wrap_angle(std::nextafter(turn, 0)) == std::nextafter(turn, 0));
  CHECK(wrap_angle(-1) == Approx(turn - 1));
  CHECK(wrap_angle(-1e-300) == 0);  // 2 pi less a tiny amount would round to 2 pi
  for (const double a : {-1e9, -7.0, 6.3, 1e300, std::nextafter(-turn, -infinity)}) {
    CHECK(wrap_angle(a) >= 0);
    CHECK(wrap_angle(a) < turn);
  }
}
