// SPDX-License-Identifier: MIT
#include "bankshot/detail/roots/roots.hpp"

#include "support/catch.hpp"

using namespace bankshot;

TEST_CASE("the gap falls through zero at the first descent") {
  CHECK(detail::first_descent(1.0, -2.0, 0.0) == 0.5);
  CHECK(detail::first_descent(1.0, -1.0, 0.5) == 2.0);        // touches: a double root
  CHECK(detail::first_descent(1.0, 1.0, -4.0) == 1.0);        // away and back
  CHECK(detail::first_descent(1.0, 1.0, 1.0) == forever);     // away for good
  CHECK(detail::first_descent(1.0, -1.0, 1.0) == forever);    // turns before it
  CHECK(detail::first_descent(-1.0, -1.0, -1.0) == forever);  // already below and falling
  CHECK(detail::first_descent(-1.0, 3.0, -4.0) == 1.0);       // comes up, then down
}

TEST_CASE("a gap of zero gives exactly zero, or the second root when leaving") {
  CHECK(detail::first_descent(0.0, -1.0, 3.0) == 0.0);
  CHECK(detail::first_descent(0.0, 1.0, -2.0) == 1.0);
  CHECK(detail::first_descent(0.0, 1.0, 2.0) == forever);
}

TEST_CASE("a tiny gap keeps its digits") {
  const double t = detail::first_descent(1e-17, -1.0, -1e-3);
  CHECK(t == Approx(1e-17).epsilon(1e-14));
}

TEST_CASE("a circle is entered once, from outside") {
  const Arc<double> along{{0, 0}, {2, 0}, {0, 0}, forever};
  CHECK(detail::first_entry(along, {3, 0}, 1, forever) == 1.0);
  CHECK(detail::first_entry(along, {-3, 0}, 1, forever) == forever);   // behind
  CHECK(detail::first_entry(along, {3, 1.5}, 1, forever) == forever);  // passes by
  CHECK(detail::first_entry(along, {0.5, 0}, 1, forever) == forever);  // starts inside
  CHECK(detail::first_entry(along, {1, 0}, 1, forever) == 0.0);        // starts on the rim
}

TEST_CASE("on a slowing arc the circle is entered later, or not at all") {
  const Arc<double> slowing{{0, 0}, {2, 0}, {-1, 0}, 2};
  CHECK(detail::first_entry(slowing, {2.5, 0}, 1, forever) == Approx(1.0).epsilon(1e-15));  // 2t - t²/2 = 1.5
  CHECK(detail::first_entry(slowing, {9, 0}, 1, forever) == forever);
}

TEST_CASE("an arc that hardly leaves a circle and bends back meets it in time") {
  // Just after it left, the arc is 0.4 nm outside the circle; it is back after 2 · 6e-7/1.5 s.
  const Arc<double> back{.at = {0, 0.115 + 4e-10},
                         .velocity = {7e-3, 6e-7},
                         .acceleration = {0, -1.5},
                         .duration = 0.1,
                         .end = PhaseEnd::roll,
                         .bends = true};
  CHECK(detail::first_entry(back, {0, 0}, 0.115, 0.1, true) < 1e-6);
}

TEST_CASE("the closest approach is clamped to the arc") {
  const Arc<double> along{{0, 0}, {2, 0}, {0, 0}, forever};
  CHECK(detail::closest_time(along, 5.0, {3, 4}) == 1.5);
  CHECK(detail::closest_time(along, 1.0, {3, 4}) == 1.0);
  CHECK(detail::closest_time(along, 1.0, {-3, 4}) == 0.0);
}
