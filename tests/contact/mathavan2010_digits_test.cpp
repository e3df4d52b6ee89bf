// SPDX-License-Identifier: MIT
//
// Compares mathavan2010 in double with mathavan2010 in 50 digits at a far smaller tolerance.
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "bankshot/numbers/dual.hpp"
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

namespace {

/// An impact towards +x, by coefficients: the height and the spin are in radii.
struct Stiff {
  double friction, height, cloth, restitution;
  Vec2d velocity;
  std::array<double, 3> spin;
};

/// In these one slip hardly grows or shrinks while its direction settles at once, or the ball leaves faster than the
/// restitution alone would let it. Steps that follow the direction come to no end.
constexpr Stiff stiff[] = {
    {0.036943154764224634,
     1.6210341577666338,
     0.36071063053523111,
     0.85753524648277057,
     {3.4108746021673171, 6.0062677066565549},
     {-6.0062677066565549, 3.4108746021673171, 1.19346756764463}},
    {0.61529699085894085,
     1.2632329348245515,
     0.032891055982001226,
     0.90922102346815015,
     {0.11546337773285206, 0.084643033905549961},
     {0.021339302983631007, -0.13509822810272062, -0.11956687971340001}},
    {0.28985264762804064,
     1.3789740118204565,
     0.302721066292234,
     0.42733980385094261,
     {0.79276802560264914, 0.26346636446817973},
     {-0.26346636446817973, 0.79276802560264914, -0.35995134092520709}},
    {0.36746593522395843,
     1.3797925597577381,
     0.40732386046748215,
     0.4471951764871549,
     {1.8782403637537763, -1.4407837762127602},
     {1.4407837762127602, 1.8782403637537763, 1.7533959853455428}},
    {0.40577764765804453,
     1.3676002565082759,
     0.45944682022091315,
     0.74279738533282724,
     {0.69814580021320982, 0.14915983001297062},
     {-0.14915983001297062, 0.69814580021320982, 0.2925312508383619}},
    {0.60906843755478157,
     1.5883108591482211,
     0.41663403008390809,
     0.64545733271698258,
     {0.061766966321013764, 0.59874480390778662},
     {-0.59874480390778662, 0.061766966321013757, 0.51657683259845044}},
    {0.47052083124074123,
     1.5617266417495319,
     0.46688538689242781,
     0.31523487140543532,
     {0.095263710942015967, 0.043591727755068817},
     {-0.043591727755068817, 0.095263710942015967, -0.040992661496370743}},
    {0.24040689537742954,
     1.557929502873076,
     0.42773186381073286,
     0.65545654342356063,
     {3.6823944441555656, -2.7944672540480759},
     {2.7944672540480759, 3.6823944441555652, -6.407003201707588}},
    {0.46779146206184347,
     1.4620462260161278,
     0.48124939881710688,
     0.42525201488424125,
     {0.32261226048873703, -0.12711859009540163},
     {0.10731157972632646, -0.035296086627028038, -0.22416725768112503}},
};

/// Returns v and Rω after the impact, for a ball with a radius of 1 m.
template <class T>
std::array<T, 5> bounced(const Stiff& a, double tolerance, ImpactCourse& course) {
  Mathavan2010 cushion{
      .height = a.height, .restitution = a.restitution, .friction = a.friction, .sliding_friction = a.cloth};
  cushion.tolerance = tolerance;
  State<T> s;
  s.velocity = to<T>(a.velocity);
  s.spin = {T(a.spin[0]), T(a.spin[1]), T(a.spin[2])};
  course = cushion.course({.radius = 1}, s, Vec2d{-1, 0});
  return {s.velocity.x, s.velocity.y, s.spin.x, s.spin.y, s.spin.z};
}

}  // namespace

TEST_CASE("mathavan2010 in 50 digits: slips whose direction settles far sooner than they grow", "[heavy]") {
  for (const Stiff& a : stiff) {
    ImpactCourse course, dual, fine;
    const auto truth = bounced<Digits>(a, 1e-20, fine);
    const auto found = bounced<double>(a, 1e-13, course);
    CAPTURE(a.friction, course.steps, dual.steps, fine.steps);
    CHECK(distance(truth, digits(found)) <= 1e-12);
    CHECK(!course.jams);
    CHECK(course.steps <= 200);
    const auto derived = bounced<Dual<2>>(a, 1e-13, dual);
    CHECK(std::abs(derived[0].a - found[0]) + std::abs(derived[1].a - found[1]) <= 1e-12);
    CHECK(dual.steps <= 200);
  }
}
