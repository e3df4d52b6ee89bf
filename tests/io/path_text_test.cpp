// SPDX-License-Identifier: MIT
//
// Points of paths as JSON and rows of CSV.
#include <cmath>

#include "bankshot/scene/puzzle.hpp"
#include "io/answer/answer_path.hpp"
#include "io/json/document.hpp"
#include "io/simulate/csv.hpp"
#include "support/catch.hpp"

using namespace bankshot;

TEST_CASE("a field of CSV is quoted where it must be, and quotes in it are doubled") {
  CHECK(csv_field("8") == "8");
  CHECK(csv_field("the red one") == "the red one");
  CHECK(csv_field("a,b") == "\"a,b\"");
  CHECK(csv_field("say \"hi\"") == "\"say \"\"hi\"\"\"");
  CHECK(csv_field("a\nb") == "\"a\nb\"");
}

TEST_CASE("a row of CSV has as many fields as its header") {
  const State<double> s{{0.1, 2}, {-3, 4.5}, {1, 0, -1e-300}};
  const std::string row = csv_row(0.25, "cue", s);
  CHECK(row == "0.25,cue,0.1,2,-3,4.5,1,0,-1e-300");
  CHECK(std::ranges::count(row, ',') == std::ranges::count(csv_header, ','));
}

TEST_CASE("the points of a path begin at the ball, end at the target, and lie on the path") {
  Puzzle p;
  p.table = rectangle_table(3, 2);
  p.ball.at = {1, 1};
  p.target = PointTarget{{2, 1}};
  p.arrive = Range{0, 0};
  p.others = {{{2.5, 1.5}, p.ball.body, "8"}};
  const double a = deceleration(p.physics);
  Shot shot;
  shot.launch = {std::sqrt(2 * a), 0};  // rests after one metre
  shot.path.arrival = {std::sqrt(2 / a), 0, {2, 1}};
  JsonWriter w;
  w.open('{');
  write_points(w, p, shot);
  w.close('}');
  const Json j = parse_document(w.take());
  CHECK(!j.contains("paths"));  // the other ball stands
  const Json& path = j["path"];
  CHECK(path.front() == Json{0.0, 1.0, 1.0});
  CHECK(path.back()[0].get<double>() == Approx(std::sqrt(2 / a)).epsilon(1e-9));
  CHECK(path.back()[1].get<double>() == Approx(2).epsilon(1e-12));
  CHECK(path.size() >= static_cast<std::size_t>(usual_rate * std::sqrt(2 / a)));
  double last = -1;
  for (const Json& point : path) {
    const double t = point[0].get<double>();
    CHECK(t > last);
    CHECK(point[1].get<double>() == Approx(1 + shot.launch.speed * t - a * t * t / 2).epsilon(1e-12));
    CHECK(point[2] == 1.0);
    last = t;
  }
}
