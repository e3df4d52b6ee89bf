// SPDX-License-Identifier: MIT
//
// The measurements of `report`, by their parts: the forces that steppers integrate, the suite of puzzles, one root with
// and without derivatives, the troubles of steppers, and circles in place of jaws.
#include "app/report/circles.hpp"
#include "app/report/derivatives.hpp"
#include "app/report/forces.hpp"
#include "app/report/one_root.hpp"
#include "app/report/sections.hpp"
#include "app/report/suite.hpp"
#include "app/report/troubles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "bankshot/numbers/tolerances.hpp"
#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::app::report;
using Catch::Contains;

namespace {

constexpr double g = 9.81, R = 0.028575, mu_slide = 0.2;

Forces sliding(const Vec2d& along) { return {Phase::slide, along, mu_slide * g, 0, 0, 5 * mu_slide * g / (2 * R)}; }
Forces rolling(const Vec2d& along, double a, double b) { return {Phase::roll, along, mu_slide * g, a, b, 0}; }

/// Returns the rows of a CSV without its header, as texts; a name in quotes has no comma.
std::vector<std::vector<std::string>> rows_of(const std::string& csv) {
  std::vector<std::vector<std::string>> out;
  std::istringstream in(csv);
  std::string line;
  std::getline(in, line);
  const auto columns = static_cast<std::size_t>(std::ranges::count(line, ','));
  while (std::getline(in, line)) {
    std::vector<std::string> row(1);
    bool quoted = false;
    for (const char c : line) {
      if (c == '"')
        quoted = !quoted;
      else if (c == ',' && !quoted)
        row.emplace_back();
      else
        row.back() += c;
    }
    if (row.size() != columns + 1) FAIL(line);
    out.push_back(row);
  }
  return out;
}

/// A clock that has moved one second on, each time it is read.
double next_second() {
  static double now = 0;
  return now += 1;
}

}  // namespace

TEST_CASE("a slide is a parabola, and its slip falls by seven halves of the friction") {
  const Vec2d along{0.6, 0.8};
  const Forces f = sliding(along);
  const Coordinates start{0.1, 0.2, 3, -1, 5, 7};
  CHECK((velocity_of(start) == Vec2d{3, -1}));
  for (const double h : {0.01, 0.3}) {
    const Coordinates end = advanced(Scheme::Method::rk4, f, start, h);
    const Vec2d v = velocity_of(start) - along * (mu_slide * g * h);
    const Vec2d at = Vec2d{0.1, 0.2} + velocity_of(start) * h - along * (mu_slide * g * h * h / 2);
    CHECK(norm(Vec2d{end[0], end[1]} - at) < 1e-15);
    CHECK(norm(velocity_of(end) - v) < 1e-15);
    const auto slip = [](const Coordinates& y) { return Vec2d{y[2] - R * y[5], y[3] + R * y[4]}; };
    CHECK(norm(slip(end) - (slip(start) - along * (3.5 * mu_slide * g * h))) < 1e-14);
  }
  Coordinates rate{};
  f(start, rate, 17);  // the forces do not depend on time
  CHECK(rate == f(start));
}

TEST_CASE("a roll slows down by a constant and by its speed, and each method has its order") {
  const double a = 0.3, b = 0.7, v0 = 2;
  const Vec2d along{1, 0};
  const auto error = [&](Scheme::Method method, double h) {
    const Coordinates end = advanced(method, rolling(along, a, b), {0, 0, v0, 0, 0, 0}, h);
    const double v = (v0 + a / b) * std::exp(-b * h) - a / b;
    CHECK((end[1] == 0 && end[3] == 0 && end[4] == 0 && end[5] == 0));
    return std::abs(end[2] - v);
  };
  // The error of one step falls with one power more than the order.
  const auto power = [&](Scheme::Method method) { return std::log2(error(method, 0.1) / error(method, 0.05)); };
  CHECK(std::abs(power(Scheme::Method::euler) - 2) < 0.1);
  CHECK(std::abs(power(Scheme::Method::semi_implicit) - 2) < 0.1);
  CHECK(std::abs(power(Scheme::Method::rk4) - 5) < 0.1);
  const Coordinates start{1, 2, v0, 0, 0, 0};
  const Coordinates euler = advanced(Scheme::Method::euler, rolling(along, a, b), start, 0.1),
                    semi = advanced(Scheme::Method::semi_implicit, rolling(along, a, b), start, 0.1);
  CHECK(euler[0] == 1 + 0.1 * v0);
  CHECK(semi[0] == 1 + 0.1 * euler[2]);
  CHECK(moved(start, {1, 2, 3, 4, 5, 6}, 2) == Coordinates{3, 6, v0 + 6, 8, 10, 12});
}

TEST_CASE("the suite has the cushions of each level, and its puzzles are always the same") {
  CHECK(std::string(name(Level::easy)) == "easy");
  CHECK(std::string(name(Level::medium)) == "medium");
  CHECK(std::string(name(Level::hard)) == "hard");
  for (const Physics& physics : {ideal_physics(), rolling_physics(), spin_physics()})
    for (const Level level : levels) {
      const std::vector<Puzzle> all = suite(physics, level, 8), fewer = suite(physics, level, 3);
      REQUIRE(all.size() == 8);
      std::map<int, int> counts;
      for (std::size_t i = 0; i < all.size(); ++i) {
        INFO(name(level) << " number " << i << ": " << write_puzzle(all[i]));
        const CushionRule& rule = all[i].cushions;
        CHECK(rule.min == rule.max);
        ++counts[rule.min];
        CHECK(rule.sequence.has_value() == (i % 2 == 0));
        if (rule.sequence) CHECK(static_cast<int>(rule.sequence->size()) == rule.min);
        CHECK(all[i].arrive.has_value() != is_ideal(physics));
        CHECK_NOTHROW(validate(all[i]));
        if (i < fewer.size()) CHECK(write_puzzle(all[i]) == write_puzzle(fewer[i]));
      }
      const std::map<int, int> expected = level == Level::easy     ? std::map<int, int>{{1, 4}, {2, 4}}
                                          : level == Level::medium ? std::map<int, int>{{3, 8}}
                                                                   : std::map<int, int>{{4, 4}, {5, 4}};
      CHECK(counts == expected);
    }
}

TEST_CASE("every easy puzzle of the suite has an answer") {
  for (const Puzzle& p : suite(rolling_physics(), Level::easy, 6)) {
    INFO(write_puzzle(p));
    const Answer a = bankshot::solve(p, {.robustness = false, .suggest = false});
    REQUIRE(a.status == Status::solved);
    CHECK(a.shots.front().verification.miss <= tolerance::exact_miss * p.table.diagonal());
  }
}

TEST_CASE("one root is approached from one seed, and each method pays for its derivatives") {
  int exact = 0, roots = 0;
  for (const Level level : {Level::easy, Level::medium})
    for (const Puzzle& p : suite(spin_physics(), level, 12)) {
      if (!p.cushions.sequence) continue;
      INFO(write_puzzle(p));
      const std::vector<Iterate> dual = approach(p, Derivatives::dual, next_second),
                                 forward = approach(p, Derivatives::forward, next_second),
                                 central = approach(p, Derivatives::central, next_second),
                                 none = approach(p, Derivatives::none, next_second);
      if (dual.empty()) continue;
      ++roots;
      REQUIRE((!forward.empty() && !central.empty()));
      CHECK(std::abs(dual.front().miss - forward.front().miss) < 1e-12);  // from one seed
      CHECK(std::abs(dual.front().miss - central.front().miss) < 1e-12);
      const std::pair<const std::vector<Iterate>*, long> runs[] = {
          {&dual, 1}, {&forward, 3}, {&central, 5}, {&none, 1}};
      for (const auto& [run, cost] : runs)
        for (std::size_t i = 0; i < run->size(); ++i) {
          const Iterate& it = (*run)[i];
          CHECK(it.simulations == cost * static_cast<long>(i + 1));
          CHECK(it.seconds == static_cast<double>(i + 1));  // the clock is read once a step
          if (i > 0) CHECK(it.miss <= (*run)[i - 1].miss);
        }
      const auto steps = [](const std::vector<Iterate>& run) {
        return std::ranges::find_if(run, [](const Iterate& it) { return it.miss < tolerance::exact_miss; }) -
               run.begin();
      };
      exact += dual.back().miss < tolerance::exact_miss;
      if (forward.back().miss < tolerance::exact_miss) CHECK(steps(dual) <= steps(forward) + 1);
    }
  CHECK(roots >= 8);
  CHECK(exact >= roots / 2);
}

TEST_CASE("the comparison of derivatives adds a row of panels, its numbers and what each method needs") {
  Section section{.name = "3-planners"};
  section.figure.panels.emplace_back();
  Progress progress(1);
  const std::string text = add_derivatives({true, 1}, section, progress);
  REQUIRE(section.figure.panels.size() == 4);
  REQUIRE(section.data.size() == 1);
  CHECK(section.data[0].name == "3-planners-derivatives");
  const Panel &time = section.figure.panels[1], &simulations = section.figure.panels[2],
              &legend = section.figure.panels[3];
  REQUIRE(time.curves.size() == legend.legend.size());
  REQUIRE(simulations.curves.size() == legend.legend.size());
  CHECK(legend.legend.size() <= derivatives_steps);
  CHECK(legend.curves.empty());
  CHECK_THAT(time.title, Contains(std::string(usual_cushion.key)));
  std::size_t points = 0;
  for (std::size_t i = 0; i < legend.legend.size(); ++i) {
    const std::string& method = legend.legend[i];
    INFO(method);
    CHECK_THAT(text, Contains("“" + method + "”"));
    CHECK(time.curves[i].name == method);
    REQUIRE(simulations.curves[i].name == method);
    const std::vector<Point>& curve = simulations.curves[i].points;
    REQUIRE(curve.size() == time.curves[i].points.size());
    points += curve.size();
    for (std::size_t k = 1; k < curve.size(); ++k) {
      CHECK(curve[k].x >= curve[k - 1].x);
      CHECK(curve[k].y <= curve[k - 1].y);
    }
    for (const Point& p : curve) CHECK((p.low <= p.y && p.y <= p.high));
  }
  CHECK(rows_of(section.data[0].text).size() == points);
  // Dual numbers need one simulation a step and reach an exact root.
  CHECK(simulations.curves[0].points.back().y < tolerance::exact_miss);
  CHECK(simulations.curves[0].points.front().x == 1);
}

TEST_CASE("the troubles of steppers are counted by step, and smaller steps have fewer") {
  Section section{.name = "1-simulators", .caption = "Before."};
  Progress progress(1);
  add_troubles({true, 1}, section, progress);
  REQUIRE(section.figure.panels.size() == troubles_steps);
  REQUIRE(section.data.size() == 1);
  CHECK(section.data[0].name == "1-simulators-troubles");
  CHECK_THAT(section.caption, Catch::StartsWith("Before. The last row") && Contains("With steps of 100 ms") &&
                                  Contains("With steps of 1 ms"));
  std::size_t points = 0;
  for (std::size_t i = 0; i < section.figure.panels.size(); ++i) {
    const Panel& panel = section.figure.panels[i];
    INFO(panel.title);
    CHECK(panel.x.logarithmic);
    REQUIRE(panel.curves.size() >= 3);
    for (const Curve& curve : panel.curves) {
      INFO(curve.name);
      points += curve.points.size();
      const auto [finest, coarsest] = std::ranges::minmax_element(curve.points, {}, &Point::x);
      CHECK(finest->x < coarsest->x);
      CHECK(finest->y <= coarsest->y + 1e-8);  // some keep the energy to rounding
      for (const Point& p : curve.points) CHECK((p.low >= 0 && p.low <= p.y && p.y <= p.high));
      if (i > 0)
        for (const Point& p : curve.points) CHECK((p.y <= 100 && p.low == p.high));
    }
  }
  const auto rows = rows_of(section.data[0].text);
  CHECK(rows.size() == points);
  for (const auto& row : rows) CHECK(row[3] == "10");  // ten shots for each one asked for
}

TEST_CASE("shots that are chosen on circles are played between jaws, and the words repeat their numbers") {
  constexpr int puzzles = 6;
  Progress progress(1);
  const CirclesForJaws found = circles_for_jaws(puzzles, progress);
  const auto rows = rows_of(found.csv);
  REQUIRE(!rows.empty());
  CHECK(rows.size() <= puzzles);
  REQUIRE(found.panel.curves.size() == 2);
  REQUIRE(found.panel.curves[0].points.size() == rows.size());
  double told = 0, played = 0, best = 0;
  int off = 0, with_best = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Point& p = found.panel.curves[0].points[i];
    INFO("puzzle " << rows[i][0]);
    CHECK(std::abs(p.x - std::stod(rows[i][1])) <= 0.5001e-4);
    CHECK(std::abs(p.y - std::stod(rows[i][2])) <= 0.5001e-4);
    CHECK((p.x >= 0 && p.x <= 1 && p.y >= 0 && p.y <= 1));
    CHECK(std::abs(std::round(p.y * 400) - p.y * 400) < 1e-9);  // of 400 tries
    told += p.x, played += p.y;
    off += std::abs(p.x - p.y) > 0.1;
    if (!rows[i][3].empty()) best += std::stod(rows[i][3]), ++with_best;
  }
  const auto n = static_cast<double>(rows.size());
  CHECK_THAT(found.told, Contains(fmt::format("{} shots were chosen", rows.size())));
  CHECK_THAT(found.told, Contains(fmt::format("a mean success of {:.0f} %; between jaws it is {:.0f} %", 100 * told / n,
                                              100 * played / n)));
  CHECK_THAT(found.told, Contains(fmt::format("For {:.0f} % of these shots", 100.0 * off / n)));
  if (with_best > 0) CHECK_THAT(found.told, Contains(fmt::format("mean success of {:.0f} %", 100 * best / with_best)));
}

TEST_CASE("few puzzles on circles are as good as many") {
  Progress progress(1);
  CHECK(rows_of(circles_for_jaws(1, progress).csv).size() <= 1);
}

TEST_CASE("the physics of the report is named by its cushions") {
  CHECK(spin_with(usual_cushion) == "spin, " + std::string(usual_cushion.key));
  CHECK(spin_with(fullest_cushion) == "spin, " + std::string(fullest_cushion.key));
  CHECK(usual_cushion.key != fullest_cushion.key);
  CHECK(usual_cushion.key == model_of(spin_physics().cushion).key);
}

TEST_CASE("a section says what was asked, and its table, figure and data are whole", "[heavy]") {
  Progress progress(3);
  const Settings few{true, 2};
  for (const Section& s : {conditioning(few, progress), scaling(few, progress), tilt(few, progress)}) {
    INFO(s.name);
    CHECK((!s.title.empty() && s.question.ends_with('?') && !s.about.empty() && !s.caption.empty()));
    CHECK(s.conclusion.ends_with('.'));
    CHECK(!s.figure.panels.empty());
    CHECK(!s.table.rows.empty());
    for (const auto& row : s.table.rows) CHECK(row.size() == s.table.header.size());
    REQUIRE(!s.data.empty());
    CHECK(s.data.front().name == s.name);
    for (const Csv& csv : s.data) CHECK(rows_of(csv.text).size() > 3);
  }
}
