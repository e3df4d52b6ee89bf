// SPDX-License-Identifier: MIT
//
// Tests the properties that hold for every puzzle on a few puzzles; tests/stress/properties.cpp draws any number.
#include "support/properties.hpp"

#include "bankshot/scene/scene.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::test;

namespace {

/// Checks a property on random cases; a case may violate it by `allowed`.
void holds(char property, int cases, std::uint64_t seed, double allowed = 0) {
  int judged = 0;
  for (int i = 0; i < cases; ++i) {
    Random random(seed, static_cast<std::uint64_t>(i));
    std::optional<Case> c;
    while (!c) c = random_case(property, random, {.most_balls = 2, .quick = true});
    const Outcome o = check(*c);
    judged += o.judged;
    INFO("case " << i << " of seed " << seed << ", change " << c->change.dump() << ": " << o.what);
    for (const Json& question : o.questions) UNSCOPED_INFO(question.dump());
    CHECK((!o.failed || o.off <= allowed));
  }
  CHECK(judged >= cases / 3);  // the others have no shot
}

Json layout(int balls, std::uint64_t seed) {
  Random r(seed, static_cast<std::uint64_t>(balls));
  const Scene scene = preset_scene("pool-9ft");
  std::vector<Ball> all;
  Json question{{"table", "pool-9ft"}};
  for (int k = 0; k <= balls; ++k) {
    const Vec2d at = free_place(r, scene.table, all, scene.ball.body).value();
    all.push_back({at, scene.ball.body, std::to_string(k)});
    if (k > 0) question["others"].push_back({{"id", std::to_string(k)}, {"at", {at.x, at.y}}});
  }
  question["ball"]["at"] = {all[0].at.x, all[0].at.y};
  return question;
}

Answer play(Json question, const Json& cushions_of_object) {
  question["target"] = {{"ball", "any"}, {"then", {{"pocket", "any"}, {"cushions", cushions_of_object}}}};
  return solve(*valid_puzzle(question), {.suggest = false});
}

}  // namespace

// Success is sampled where the cue ball may fall, so two answers may differ by this much.
constexpr double sampled = 0.015;

TEST_CASE("the safest aim is worth at least what the centre is") { holds('b', 24, 1, sampled); }

TEST_CASE("a mirrored question has the mirrored answer") { holds('d', 24, 2, sampled); }

TEST_CASE("the order of other balls changes nothing") { holds('e', 24, 3); }

TEST_CASE("success is the share of noisy plays that count") { holds('h', 24, 4); }

TEST_CASE("what should I play? is answered on every layout, and not worse than by a direct pot") {
  constexpr double lost = 0.02;
  for (const int balls : {2, 3, 5, 7, 9, 15}) {
    const Json scene = layout(balls, 5);
    INFO(balls << " balls: " << scene.dump());
    const Answer answer = play(scene, {{"max", 2}});
    CHECK(answer.status == Status::solved);
    Json direct = scene;
    direct["cushions"] = 0;
    CHECK(value_of(answer) >= value_of(play(direct, 0)) - lost);
  }
}
