// SPDX-License-Identifier: MIT
#include "planners/play/launches.hpp"

#include <cmath>

#include "planners/settings.hpp"
#include "support/catch.hpp"
#include "support/one_pot.hpp"
#include "support/played.hpp"

using namespace bankshot;
using namespace bankshot::planning;

namespace {

struct Launching : test::OnePot {
  play::LeaveWorth worth{puzzle};
  play::Launches launches{request, budget, worth};
  play::Root root{branch, *play::on_target(branch, budget, launches.box(), x, 0)};
};

}  // namespace

TEST_CASE("a launch near another makes its target, and leaves the cue ball where the simulator leaves it") {
  Launching s;
  play::Vector x = s.root.x;
  x[branch::log_speed] += 0.2;
  x[branch::top] = -0.4;
  for (const double shift : {0.0, 0.006, -0.006}) {
    const auto one = s.launches.play_near(s.root, x, shift);
    REQUIRE(one);
    CHECK((one->x[branch::log_speed] == x[branch::log_speed] && one->x[branch::top] == x[branch::top]));
    const auto places = test::played(s.puzzle, one->shot.launch, one->shot.spin);
    CHECK(!places[1]);
    CHECK(norm(*one->ending.cue_rests() - *places[0]) < 1e-10);
    CHECK(one->value() == one->promise);
  }
  x[branch::log_speed] = std::log(0.3);
  CHECK(!s.launches.play_near(s.root, x, 0));  // too slow
}

TEST_CASE("the widest range of made places across a pocket is what the simulator lets in") {
  Launching s;
  s.launches.look_across(s.root);
  REQUIRE(s.root.made);
  const double step = 2 * s.branch.aim_point.reach / settings::aims_across;
  const auto falls = [&](double shift) {
    const auto x = play::on_target(s.branch, s.budget, s.launches.box(), s.root.x, shift);
    REQUIRE(x);
    return !test::played(s.puzzle, branch::launch_of(*x), branch::spin_of(*x))[1].has_value();
  };
  CHECK(s.root.made->high - s.root.made->low > step);
  CHECK(falls((s.root.made->low + s.root.made->high) / 2));
  CHECK(!falls(s.root.made->low - step));
  CHECK(!falls(s.root.made->high + step));
}

TEST_CASE("a pot is likely in the middle of what is made, and less towards an end") {
  Launching s;
  s.launches.look_across(s.root);
  REQUIRE(s.root.made);
  const auto [low, high] = *s.root.made;
  const double middle = (low + high) / 2;
  const auto one = s.launches.play_near(s.root, s.root.x, middle);
  REQUIRE(one);
  double before = s.launches.likely(s.root, middle, one->shot);
  CHECK(before > 0.5);
  for (const double part : {0.5, 0.75, 1.0}) {
    const double likely = s.launches.likely(s.root, std::lerp(middle, high, part), one->shot);
    CHECK(likely <= before);
    before = likely;
  }
}

TEST_CASE("a climb ends where no step of its size is better") {
  Launching s;
  auto best = s.launches.play_near(s.root, s.root.x, 0);
  REQUIRE(best);
  const auto from_middle = [](const play::Launched& one) { return norm(*one.ending.cue_rests() - Vec2d{1.9, 0.4}); };
  const double before = from_middle(*best);
  int looked = 0;
  s.launches.climb(*best, 1, [&](play::Launched& one) { return ++looked, from_middle(one) < from_middle(*best); });
  CHECK(from_middle(*best) < before);
  const int last = looked;
  s.launches.climb(*best, 1, [&](play::Launched& one) { return ++looked, from_middle(one) < from_middle(*best); });
  CHECK(looked - last <= 8);  // one look each way along four coordinates
}
