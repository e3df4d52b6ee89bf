// SPDX-License-Identifier: MIT
//
// Compares the sensitivity to each coefficient with shots simulated again with that coefficient changed. A longer run
// by hand: test_plan "[long]"
#include <cmath>

#include "bankshot/plan/planner.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "support/catch.hpp"
#include "support/random_puzzle.hpp"
#include "support/seed.hpp"

using namespace bankshot;

namespace {

/// Adds to the coefficient of this name.
void change(Physics& p, const std::string& name, double by) {
  if (name == "tilt.x") p.tilt.x += by;
  if (name == "tilt.y") p.tilt.y += by;
  if (name == "friction") std::get<Rolling>(p.motion).friction += by;
  if (name == "ball_ball.restitution") p.ball_ball.restitution += by;
  if (name == "ball_ball.friction") p.ball_ball.friction.fast += by;
  if (auto* m = std::get_if<SlideRoll>(&p.motion)) {
    if (name == "sliding_friction") {
      m->sliding_friction += by;
      if (auto* c = std::get_if<Mathavan2010>(&p.cushion)) c->sliding_friction += by;
    }
    if (name == "rolling_friction") m->rolling_friction.at_rest += by;
    if (name == "spinning_friction") m->spinning_friction += by;
  }
  std::visit(
      [&](auto& c) {
        if (name == "restitution" || name == "cushion.restitution") c.restitution.at_rest += by;
        if constexpr (requires { c.height; }) {
          if (name == "cushion.friction") c.friction += by;
          if (name == "cushion.height") c.height += by;
        }
        if constexpr (requires { c.frequency_ratio; })
          if (name == "cushion.frequency_ratio") c.frequency_ratio += by;
      },
      p.cushion);
}

struct End {
  Vec2d at, velocity;
  std::vector<Contact> cushions;
};

/// Returns the state of the arriving ball at the time of arrival, or at rest.
End end_of_shot(const Puzzle& p, const Shot& shot, bool rests) {
  ShotRequest r = as_request(p, shot);
  if (rests) r.until = {};
  const Trajectory t = simulate(r);
  const Trajectory path = path_of(t, shot.arriving());
  const Record& e = path.events.back();
  const Record& before = path.events.size() > 1 ? path.events[path.events.size() - 2] : e;
  return {e.state.at, norm(e.state.velocity) > 0 ? e.state.velocity : before.state.velocity, t.sequence()};
}

/// Returns the shift per unit of the coefficient by central differences [m]; none when the change alters the cushions.
std::optional<double> by_differences(const Puzzle& p, const Shot& shot, const std::string& name, double step) {
  const bool rests = shot.path.arrival.speed == 0;
  Puzzle low = p, high = p;
  change(low.physics, name, -step);
  change(high.physics, name, step);
  const End a = end_of_shot(low, shot, rests), b = end_of_shot(high, shot, rests), m = end_of_shot(p, shot, rests);
  if (a.cushions != b.cushions || a.cushions != m.cushions) return {};
  const Vec2d moved = (b.at - a.at) / (2 * step);
  if (rests) return norm(moved);
  return std::abs(cross(m.velocity / norm(m.velocity), moved));
}

struct Seen {
  int shots = 0, compared = 0;
  double worst = 0;
};

void compare(const Puzzle& p, Seen& seen) {
  const Answer a = solve(p, {.robustness = false, .sensitivity = true, .suggest = false});
  if (a.shots.empty() || a.shots[0].verification.condition > 1e4 || a.shots[0].path.touches_jaws) return;
  const Shot& shot = a.shots[0];
  REQUIRE(!shot.robustness.sensitivity.empty());
  ++seen.shots;
  for (const Sensitivity& s : shot.robustness.sensitivity) {
    const double step = s.coefficient.starts_with("tilt") ? 1e-7 : s.coefficient == "cushion.height" ? 1e-8 : 1e-6;
    const auto found = by_differences(p, shot, s.coefficient, step);
    const auto finer = by_differences(p, shot, s.coefficient, step / 2);
    if (!found || !finer) continue;
    const double noise = std::abs(*found - *finer);  // error of the differences themselves
    ++seen.compared;
    const double error = std::abs(*found - s.by), scale = 1e-4 + std::abs(s.by);
    INFO(s.coefficient << ": " << s.by << ", by differences " << *found << " and " << *finer);
    CHECK(error <= 2e-3 * scale + 4 * noise + 1e-8 / step * 1e-3);
    seen.worst = std::max(seen.worst, (error - 4 * noise) / scale);
  }
}

void compare_all(int each, std::uint64_t seed) {
  Seen seen;
  for (const test::Model model :
       {test::Model::rolling, test::Model::spin, test::Model::stronge, test::Model::mathavan, test::Model::tilted}) {
    test::Random random(seed);
    const int count = model == test::Model::mathavan ? each / 5 + 1 : each;
    for (int i = 0; i < count; ++i) {
      INFO("puzzle " << i << " of seed " << seed << ", model " << static_cast<int>(model));
      compare(test::random_puzzle(random, test::Family::uniform, model, i % 4).puzzle, seen);
    }
  }
  WARN("sensitivity: " << seen.compared << " coefficients of " << seen.shots << " shots, worst difference "
                       << seen.worst);
  CHECK(seen.shots > 3 * each);
  CHECK(seen.compared > 20 * each);
}

}  // namespace

TEST_CASE("sensitivity is what shots simulated again with another coefficient show", "[heavy]") { compare_all(12, 5); }
TEST_CASE("sensitivity of a thousand shots", "[.][long]") { compare_all(250, test::seed_or_fresh(6)); }

TEST_CASE("sensitivity names the coefficients of the laws that a shot depends on") {
  Puzzle p{.table = rectangle_table(2, 1),
           .physics = spin_physics(),
           .ball = {.at = {0.5, 0.5}},
           .target = PointTarget{{1.5, 0.7}},
           .cushions = CushionRule::exactly(1)};
  const auto names = [&] {
    std::vector<std::string> out;
    const Answer answer = solve(p, {.sensitivity = true});
    for (const Sensitivity& s : answer.shots.at(0).robustness.sensitivity) out.push_back(s.coefficient);
    return out;
  };
  CHECK(names() == std::vector<std::string>{"sliding_friction", "rolling_friction", "spinning_friction",
                                            "cushion.restitution", "cushion.friction", "cushion.height", "tilt.x",
                                            "tilt.y"});
  p.physics.cushion = Stronge{.restitution = {0.9, -0.02}};
  CHECK(names() == std::vector<std::string>{"sliding_friction", "rolling_friction", "spinning_friction",
                                            "cushion.restitution.at_rest", "cushion.restitution.per_speed",
                                            "cushion.friction", "cushion.height", "cushion.frequency_ratio", "tilt.x",
                                            "tilt.y"});
  p.physics = rolling_physics();
  CHECK(names() == std::vector<std::string>{"friction", "restitution", "tilt.x", "tilt.y"});
  p.physics = ideal_physics();
  CHECK(names().empty());
  p.physics = rolling_physics();
  CHECK(solve(p).shots.at(0).robustness.sensitivity.empty());
}
