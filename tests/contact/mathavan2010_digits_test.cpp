// SPDX-License-Identifier: MIT
//
// Compares mathavan2010 in double with mathavan2010 in 50 digits at a far smaller tolerance.
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/catch.hpp"
#include "support/impacts.hpp"
#include "support/program.hpp"

using namespace bankshot;
using Digits = boost::multiprecision::number<boost::multiprecision::cpp_dec_float<50>, boost::multiprecision::et_off>;

namespace {

/// Returns v and Rω after the impact.
template <class T>
std::array<T, 5> bounced(const test::Arrival& a, double tolerance, ImpactCourse* course = nullptr) {
  Mathavan2010 cushion = a.cushion;
  cushion.tolerance = tolerance;
  State<T> s = a.state<T>();
  const ImpactCourse c = cushion.course(a.body, s, test::away_from_cushion);
  if (course) *course = c;
  const T R(a.body.radius);
  return {s.velocity.x, s.velocity.y, R * s.spin.x, R * s.spin.y, R * s.spin.z};
}

double distance(const std::array<Digits, 5>& truth, const std::array<Digits, 5>& x) {
  double off = 0;
  for (std::size_t i = 0; i < 5; ++i) off = std::max(off, std::abs(static_cast<double>(Digits(x[i] - truth[i]))));
  return off;
}

std::array<Digits, 5> digits(const std::array<double, 5>& x) {
  return {Digits(x[0]), Digits(x[1]), Digits(x[2]), Digits(x[3]), Digits(x[4])};
}

/// |v| + R|ω|
double size(const test::Arrival& a) {
  return norm(a.velocity) * (1 + std::abs(a.spin.top) + std::abs(a.spin.side) + std::abs(a.spin.masse));
}

}  // namespace

TEST_CASE("mathavan2010 in 50 digits: the published impacts, to 1e-20 and by double to 1e-12", "[heavy]") {
  std::istringstream lines(test::read_repository_file("tests/problems/mathavan2010_impacts.jsonl"));
  double by_tolerance = 0, by_double = 0;
  for (std::string line; std::getline(lines, line);) {
    const auto j = nlohmann::json::parse(line);
    const bool paper = j["set"] == "paper";
    test::Arrival a{paper ? test::paper_ball : test::pool_ball,
                    paper ? test::paper_cushion() : test::pool_cushion(),
                    {},
                    {j["top"], j["side"], 0},
                    ""};
    a.velocity = direction(radians(j["incidence"])) * j["speed"].get<double>();
    const auto truth = bounced<Digits>(a, 1e-25);
    INFO(line);
    by_tolerance = std::max(by_tolerance, distance(truth, bounced<Digits>(a, 1e-22)) / size(a));
    by_double = std::max(by_double, distance(truth, digits(bounced<double>(a, 1e-13))) / size(a));
    REQUIRE(by_tolerance <= 1e-20);
    REQUIRE(by_double <= 1e-12);
  }
  WARN("tolerance 1e-22 against 1e-25: " << by_tolerance << "; double: " << by_double << " of |v| + R|ω|");
}

TEST_CASE("mathavan2010 in 50 digits: random impacts at three tolerances", "[heavy]") {
  constexpr std::uint64_t seed = 71;
  constexpr int families = static_cast<int>(std::size(test::impact_families)), count = 300;
  constexpr double tolerances[] = {1e-6, 1e-9, 1e-13}, allowed[] = {1e-5, 1e-8, 1e-12};
  test::Random random(seed);
  std::map<std::string, int> seen;
  double worst[3]{};
  for (int i = 0; i < count * families; ++i) {
    const test::Arrival a = test::random_arrival(random, i % families);
    const auto truth = bounced<Digits>(a, 1e-20);
    for (int k = 0; k < 3; ++k) {
      ImpactCourse course;
      const double off = distance(truth, digits(bounced<double>(a, tolerances[k], &course))) / size(a);
      INFO("seed " << seed << ", impact " << i << ", " << a.name << ": v " << a.velocity.x << ' ' << a.velocity.y
                   << ", top " << a.spin.top << ", side " << a.spin.side << ", e " << a.cushion.restitution.at_rest
                   << ", height " << a.cushion.height << ", " << test::sequence(course));
      CHECK(off <= allowed[k]);
      worst[k] = std::max(worst[k], off);
      if (k == 2) ++seen[test::sequence(course)];
    }
  }
  std::string table;
  for (const auto& [switches, n] : seen) table += "\n  " + std::to_string(n) + "  " + switches;
  WARN(count * families << " impacts, worst error of double at tolerance 1e-6, 1e-9, 1e-13: " << worst[0] << ", "
                        << worst[1] << ", " << worst[2]
                        << "; switches (I cushion, C cloth slide; i, c stick; 0 no load):" << table);
  CHECK(seen.size() >= 8);
}
