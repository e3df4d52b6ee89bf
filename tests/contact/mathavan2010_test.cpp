// SPDX-License-Identifier: MIT
#include "bankshot/contact/mathavan2010.hpp"
#include "bankshot/numbers/dual.hpp"

#include <nlohmann/json.hpp>
#include <sstream>

#include "bankshot/contact/mirror.hpp"
#include "bankshot/motion/launched.hpp"
#include "support/catch.hpp"
#include "support/impacts.hpp"
#include "support/program.hpp"

using nlohmann::json;
using namespace bankshot;
using test::away_from_cushion;

namespace {

constexpr int families = static_cast<int>(std::size(test::impact_families));

/// Returns ½ v² + ⅕ (Rω)², for mass 1.
double energy(const State<double>& s, double R) {
  const Vec3<double>& w = s.spin;
  return dot(s.velocity, s.velocity) / 2 + R * R * (w.x * w.x + w.y * w.y + w.z * w.z) / 5;
}

/// Returns the largest difference of v and Rω [m/s].
double distance(const State<double>& a, const State<double>& b, double R) {
  const auto off = [](double x, double y) { return std::abs(x - y); };
  return std::max({off(a.velocity.x, b.velocity.x), off(a.velocity.y, b.velocity.y), R * off(a.spin.x, b.spin.x),
                   R * off(a.spin.y, b.spin.y), R * off(a.spin.z, b.spin.z)});
}

State<double> after(const Mathavan2010& cushion, const Body& body, State<double> s,
                    const Vec2d& away = away_from_cushion) {
  cushion.bounce(body, s, away);
  return s;
}

/// Calls check(arrival) for `count` random impacts of every family.
template <class F>
void for_random(std::uint64_t seed, int count, F&& check) {
  test::Random random(seed);
  for (int i = 0; i < count * families; ++i) {
    const test::Arrival a = test::random_arrival(random, i % families);
    INFO("seed " << seed << ", impact " << i << ", " << a.name << ": v " << a.velocity.x << ' ' << a.velocity.y
                 << ", top " << a.spin.top << ", side " << a.spin.side << ", e " << a.cushion.restitution.at_rest);
    check(a);
  }
}

}  // namespace

TEST_CASE("mathavan2010: impacts integrated with small steps in extended precision") {
  std::istringstream lines(test::read_repository_file("tests/problems/mathavan2010_impacts.jsonl"));
  int count = 0;
  double worst = 0, worst_of_allowed = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    const json j = json::parse(line);
    const bool paper = j["set"] == "paper";
    const Mathavan2010 cushion = paper ? test::paper_cushion() : test::pool_cushion();
    const Body body = paper ? test::paper_ball : test::pool_ball;
    const Vec2d v = direction(radians(j["incidence"])) * j["speed"].get<double>();
    const State<double> s = after(cushion, body, launched({0, 0}, body.radius, v, {j["top"], j["side"], 0}));
    const json &ev = j["after"]["v"], &ew = j["after"]["w"];
    const double off = distance(s, {{0, 0}, {ev[0], ev[1]}, {ew[0], ew[1], ew[2]}}, body.radius);
    const double allowed = std::max(2e-5, 20 * j["err"].get<double>());
    INFO(line);
    CHECK(off <= allowed);
    // The reference states its own error; a small one makes this check sharper.
    CHECK(off <= 20 * j["err"].get<double>() + 1e-12);
    worst = std::max(worst, off);
    worst_of_allowed = std::max(worst_of_allowed, off / allowed);
  }
  CHECK(count == 30);
  WARN("30 impacts: worst difference " << worst << " m/s, " << worst_of_allowed << " of what is allowed");
}

TEST_CASE("mathavan2010: rebound speed and angle of the paper's snooker ball") {
  struct Row {
    double incidence, ratio[2], out[2];  // no spin, rolling
  };
  const Row rows[] = {{10, {.9167, .9433}, {10.54, 10.34}},
                      {30, {.7876, .8614}, {36.17, 34.00}},
                      {50, {.7614, .8516}, {61.77, 58.56}},
                      {70, {.8114, .8883}, {78.21, 76.59}},
                      {90, {.8373, .9107}, {90, 90}}};
  for (const double speed : {0.5, 1.0, 2.0})
    for (const Row& row : rows)
      for (const int top : {0, 1}) {
        const Mathavan2010 cushion = test::paper_cushion();
        const Body body = test::paper_ball;
        const State<double> s =
            after(cushion, body,
                  launched({0, 0}, body.radius, direction(radians(row.incidence)) * speed, {double(top), 0, 0}));
        INFO(row.incidence << " degrees, top " << top << ", " << speed << " m/s");
        CHECK(std::abs(norm(s.velocity) / speed - row.ratio[top]) < 6e-5);
        CHECK(std::abs(degrees(std::atan2(-s.velocity.y, s.velocity.x)) - row.out[top]) < 6e-3);
      }
}

TEST_CASE("mathavan2010: energy, scale, mirror image and direction of the cushion") {
  constexpr std::uint64_t seed = 21;
  test::Random turn(seed + 1);
  int steps = 0, count = 0;
  for_random(seed, 500, [&](const test::Arrival& a) {
    const double R = a.body.radius, e = a.cushion.restitution.at_rest;
    const State<double> s = a.state<double>();
    State<double> out = s;
    const ImpactCourse course = a.cushion.course(a.body, out, away_from_cushion);
    const double size = std::sqrt(2.5 * energy(s, R)), before = energy(s, R);
    REQUIRE(!course.jams);
    steps += course.steps;
    ++count;
    CHECK(energy(out, R) <= before * (1 + 1e-14));
    CHECK(out.velocity.y <= 0);
    if (e == 0) CHECK(out.velocity.y == 0);

    State<double> fast{s.at, s.velocity * 8.0, {8 * s.spin.x, 8 * s.spin.y, 8 * s.spin.z}};
    fast = after(a.cushion, a.body, fast);
    CHECK(distance({out.at, fast.velocity / 8.0, {fast.spin.x / 8, fast.spin.y / 8, fast.spin.z / 8}}, out, R) <=
          1e-15 * size);

    const auto mirrored = [](const State<double>& x) {
      return State<double>{x.at, {-x.velocity.x, x.velocity.y}, {x.spin.x, -x.spin.y, -x.spin.z}};
    };
    CHECK(distance(mirrored(after(a.cushion, a.body, mirrored(s))), out, R) <= 1e-14 * size);

    const double angle = turn.uniform(0, 6), c = std::cos(angle), d = std::sin(angle);
    const auto rotated = [](const State<double>& x, double cosine, double sine) {
      const auto rotate = [&](double p, double q) { return Vec2d{cosine * p - sine * q, sine * p + cosine * q}; };
      const Vec2d v = rotate(x.velocity.x, x.velocity.y), w = rotate(x.spin.x, x.spin.y);
      return State<double>{x.at, v, {w.x, w.y, x.spin.z}};
    };
    const Vec2d away{d, -c};
    CHECK(distance(rotated(after(a.cushion, a.body, rotated(s, c, d), away), c, -d), out, R) <= 1e-12 * size);
  });
  WARN(count << " impacts, " << double(steps) / count << " steps each");
}

TEST_CASE("mathavan2010: without friction it is a mirror, and little friction changes little") {
  for_random(31, 20, [](test::Arrival a) {
    State<double> mirror = a.state<double>();
    Mirror{a.cushion.restitution}.bounce(a.body, mirror, away_from_cushion);
    const double R = a.body.radius, approach = a.velocity.y;
    a.cushion.friction = a.cushion.sliding_friction = 0;
    const double size = std::sqrt(2.5 * energy(a.state<double>(), R));
    CHECK(distance(after(a.cushion, a.body, a.state<double>()), mirror, R) <= 4e-15 * size);
    a.cushion.friction = a.cushion.sliding_friction = 1e-8;
    const double off = distance(after(a.cushion, a.body, a.state<double>()), mirror, R);
    CHECK(off <= 20e-8 * approach + 1e-15 * size);
    CHECK(off >= 1e-9 * approach - 1e-15 * size);
  });
}

TEST_CASE("mathavan2010: the normal speed vanishes with the restitution") {
  for_random(41, 20, [](test::Arrival a) {
    a.cushion.restitution = 0;
    const State<double> dead = after(a.cushion, a.body, a.state<double>());
    a.cushion.restitution = 1e-7;
    const State<double> nearly = after(a.cushion, a.body, a.state<double>());
    CHECK(dead.velocity.y == 0);
    CHECK(nearly.velocity.y < 0);
    CHECK(distance(dead, nearly, a.body.radius) <= 1e-6 * a.velocity.y);
  });
}

TEST_CASE("mathavan2010: what does not approach is left alone, and what jams stops") {
  State<double> s{{1, 2}, {3, -4}, {5, 6, 7}};
  CHECK(distance(after({}, {}, s), s, 1) == 0);
  s.velocity.y = 0;
  CHECK(distance(after({}, {}, s), s, 1) == 0);
  for (const double friction : {0.8, 2.0, 1e3, 1e9}) {
    int jams = 0;
    for_random(51, 30, [&](test::Arrival a) {
      a.cushion.friction = a.cushion.sliding_friction = friction;
      State<double> out = a.state<double>();
      const double before = energy(out, a.body.radius);
      jams += a.cushion.course(a.body, out, away_from_cushion).jams;
      CHECK(out.velocity.y <= 0);
      CHECK(energy(out, a.body.radius) <= before * (1 + 1e-9));
    });
    WARN("friction " << friction << ": " << jams << " of " << 30 * families << " jam");
    CHECK(jams > 0);
  }
}

namespace {

using Five = Dual<5>;

/// Computes the impact of a ball whose vx, vy, top, side and masse are the variables x.
template <class T>
State<T> impact(const Mathavan2010& cushion, const Body& body, const T (&x)[5], ImpactCourse& course) {
  const Vec2<T> v{x[0], x[1]}, rolled = perpendicular(v) / T(body.radius), along = v / T(body.radius);
  State<T> s{{T(0), T(0)}, v, {rolled.x * x[2] + along.x * x[4], rolled.y * x[2] + along.y * x[4], norm(along) * x[3]}};
  course = cushion.course(body, s, away_from_cushion);
  return s;
}

template <class T>
std::array<T, 5> list(const State<T>& s, double R) {
  return {s.velocity.x, s.velocity.y, T(R) * s.spin.x, T(R) * s.spin.y, T(R) * s.spin.z};
}

struct Slope {
  std::array<double, 5> value{}, error{};
  bool smooth = true;  ///< the switches are the same at all points
};

/// Ridders' method: extrapolated central differences with shrinking steps.
Slope ridders(const Mathavan2010& cushion, const Body& body, const double (&x)[5], int variable,
              const std::string& switches) {
  constexpr int levels = 7;
  constexpr double shrink = 1.6;
  Slope out;
  out.error.fill(1e300);
  double table[levels][levels][5];
  double h = 2e-3;
  for (int i = 0; i < levels; ++i, h /= shrink) {
    std::array<double, 5> side[2];
    for (int k = 0; k < 2; ++k) {
      double y[5];
      std::copy(std::begin(x), std::end(x), y);
      y[variable] += k == 0 ? -h : h;
      ImpactCourse course;
      side[k] = list(impact<double>(cushion, body, y, course), body.radius);
      out.smooth = out.smooth && test::sequence(course) == switches;
    }
    for (std::size_t c = 0; c < 5; ++c) {
      table[i][0][c] = (side[1][c] - side[0][c]) / (2 * h);
      double factor = shrink * shrink;
      for (int j = 1; j <= i; ++j, factor *= shrink * shrink) {
        table[i][j][c] = (table[i][j - 1][c] * factor - table[i - 1][j - 1][c]) / (factor - 1);
        const double off =
            std::max(std::abs(table[i][j][c] - table[i][j - 1][c]), std::abs(table[i][j][c] - table[i - 1][j - 1][c]));
        if (off < out.error[c]) out.error[c] = off, out.value[c] = table[i][j][c];
      }
    }
  }
  return out;
}

}  // namespace

TEST_CASE("mathavan2010: no impact runs out of steps, however rough the rubber and the cloth") {
  constexpr std::uint64_t seed = 1338;
  test::Random r(seed);
  for (int i = 0; i < 20000; ++i) {
    const Body body = test::pool_ball;
    const Mathavan2010 cushion{.height = body.radius * r.uniform(1.1, 1.7),
                               .restitution = r.uniform(0.3, 1),
                               .friction = r.uniform(0.02, 0.62),
                               .sliding_friction = r.uniform(0.02, 0.52)};
    const bool rolls = r.chance(0.4);
    const LaunchSpin spin{rolls ? 1 : r.uniform(-2, 2), r.uniform(-2, 2), rolls ? 0 : r.uniform(-2, 2)};
    const Vec2d heading = direction(r.uniform(0, radians(180)));
    State<double> s = launched(Vec2d{}, body.radius, heading * r.log_uniform(0.1, 10), spin);
    const ImpactCourse course = cushion.course(body, s, test::away_from_cushion);
    INFO("seed " << seed << ", impact " << i);
    CHECK(course.steps <= detail::mathavan::most_steps);
  }
}

TEST_CASE("mathavan2010: dual numbers agree with differences where the switches stay the same") {
  constexpr std::uint64_t seed = 61;
  int compared = 0, skipped = 0, vague = 0;
  double worst = 0;
  for_random(seed, 60, [&](const test::Arrival& a) {
    const double speed = norm(a.velocity);
    const double x[5] = {a.velocity.x / speed, a.velocity.y / speed, a.spin.top, a.spin.side, a.spin.masse};
    Five dual[5];
    for (int k = 0; k < 5; ++k) dual[k] = Five(x[k], k);
    ImpactCourse course;
    const auto derivative = list(impact<Five>(a.cushion, a.body, dual, course), a.body.radius);
    for (const Five& d : derivative)
      REQUIRE((std::isfinite(d.a) && std::ranges::all_of(d.v, [](double slope_k) { return std::isfinite(slope_k); })));
    if (x[1] < 0.05) return;  // differences would reach the cushion's line
    // Without slip on the cloth, only changes of the two velocities keep the slip 0.
    const bool rolls = x[2] == 1 && x[4] == 0;
    for (int k = 0; k < (rolls ? 2 : 5); ++k) {
      const Slope slope = ridders(a.cushion, a.body, x, k, test::sequence(course));
      if (!slope.smooth) {
        ++skipped;
        continue;
      }
      for (std::size_t c = 0; c < 5; ++c) {
        if (slope.error[c] > 1e-6) {
          ++vague;
          continue;
        }
        const double off = std::abs(derivative[c].v[k] - slope.value[c]);
        INFO("variable " << k << ", component " << c << ": " << derivative[c].v[k] << " and " << slope.value[c] << " ± "
                         << slope.error[c] << ", " << test::sequence(course));
        CHECK(off <= 1e-6 + 100 * slope.error[c]);
        worst = std::max(worst, off);
        ++compared;
      }
    }
  });
  WARN(compared << " derivatives, worst difference " << worst << "; " << skipped << " variables beside a switch, "
                << vague << " differences too vague");
  CHECK(compared > 4000);
}
