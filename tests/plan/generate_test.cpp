// SPDX-License-Identifier: MIT
//
// Generated puzzles fulfil the wish: they have a shot, and the kind, the cushions and the difficulty asked for.
#include "bankshot/plan/generate.hpp"

#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "support/catch.hpp"

using namespace bankshot;

namespace {

Wish wish(const char* table, const char* physics, CushionRule cushions = {1, 3, {}}) {
  const Scene s = read_scene(table, physics);
  return {.table = s.table, .physics = s.physics, .ball = s.ball, .cushions = std::move(cushions)};
}

std::vector<Generated> made(const Wish& w, int count, std::uint64_t seed = 1) {
  std::vector<Generated> out;
  for (int i = 0; i < count; ++i) {
    Random random(seed, static_cast<std::uint64_t>(i));
    auto g = generate(w, random);
    REQUIRE(g);
    out.push_back(std::move(*g));
  }
  return out;
}

}  // namespace

TEST_CASE("generate: puzzles read back to what was solved, and are solved at the target's centre") {
  const auto [scene, physics] = GENERATE(table<const char*, const char*>({
      {"\"pool-9ft\"", "\"spin\""},
      {"\"carom-10ft\"", R"({"model":"spin","cushion":{"restitution":0.9}})"},
      {"\"snooker-12ft\"", "\"rolling\""},
      {"\"seed\"", "\"ideal\""},
      {R"({"vertices":[[0,0],[2,0],[2,1],[1,1],[1,2],[0,2]]})", "\"rolling\""},
      {R"({"length":0.002,"width":0.001})", "\"ideal\""},
  }));
  INFO(scene << " " << physics);
  Wish w = wish(scene, physics);
  if (w.table.diagonal() < 0.01) w.ball.body.radius = 0;
  for (const Generated& g : made(w, 6)) {
    const Puzzle& p = g.puzzle;
    CHECK(g.answer.status == Status::solved);
    CHECK(g.answer.shots[0].verification.miss <= 1e-9 * p.table.diagonal());
    CHECK(p.cushions.min == p.cushions.max);
    CHECK((p.cushions.min >= 1 && p.cushions.max <= 3));
    if (w.ball.body.radius == 0) continue;  // not the table's own ball
    const Puzzle back = read_puzzle(write_puzzle(p, scene, physics));
    CHECK(write_puzzle(back) == write_puzzle(p));
    CHECK(write_puzzle(p, scene, physics).size() < write_puzzle(p).size());
    CHECK(to_json(p, solve(back, {.suggest = false}), false) == to_json(p, g.answer, false));
  }
}

TEST_CASE("generate: kinds, sequences, difficulties and unique shots as wished") {
  Wish w = wish("\"pool-8ft\"", "\"spin\"");
  w.kind = Wish::Kind::pocket;
  for (const Difficulty d : {Difficulty::easy, Difficulty::medium, Difficulty::hard}) {
    w.difficulty = d;
    for (const Generated& g : made(w, 3)) {
      CHECK(std::holds_alternative<PocketTarget>(g.puzzle.target));
      Puzzle centred = g.puzzle;
      centred.aim = Aim::centre;
      CHECK(difficulty(solve(centred).shots[0]) == d);
    }
  }
  w.difficulty.reset();
  w.kind = Wish::Kind::stop;
  for (const Generated& g : made(w, 3)) CHECK(g.answer.shots[0].path.arrival.speed == 0);
  w.kind = Wish::Kind::pass;
  for (const Generated& g : made(w, 3)) CHECK(g.answer.shots[0].path.arrival.speed > 0.05);
  w.kind.reset();
  w.cushions = CushionRule::in_order({Contact::rail(2), Contact::rail(1), Contact::rail(0), Contact::rail(3)});
  for (const Generated& g : made(w, 3))
    CHECK(g.answer.shots[0].path.cushions ==
          std::vector<Contact>{Contact::rail(2), Contact::rail(1), Contact::rail(0), Contact::rail(3)});
  w.cushions = {2, 2, {}};
  w.unique = true;
  for (const Generated& g : made(w, 3)) CHECK(solve(g.puzzle, {.all = true}).shots.size() == 1);
}

TEST_CASE("generate: difficulty follows the smaller side of the margin and the chance") {
  Shot s;
  const auto of = [&](std::optional<double> down, std::optional<double> up, double success) {
    s.robustness.margin = Margin{{down, up}, {}};
    s.robustness.success = success;
    return difficulty(s);
  };
  CHECK(of({}, {}, 1) == Difficulty::easy);
  CHECK(of(radians(-0.25), radians(0.25), 0.9) == Difficulty::easy);
  CHECK(of(radians(-0.24), radians(2), 1) == Difficulty::medium);
  CHECK(of(radians(-2), radians(2), 0.89) == Difficulty::medium);
  CHECK(of(radians(-0.0625), radians(2), 0.4) == Difficulty::medium);
  CHECK(of(radians(-0.06), radians(2), 1) == Difficulty::hard);
  CHECK(of({}, {}, 0.39) == Difficulty::hard);
}

TEST_CASE("generate: an impossible wish ends, and says what became of it") {
  Wish w = wish("\"seed\"", "\"ideal\"");
  w.kind = Wish::Kind::stop;  // nothing stops without friction
  w.tries = 20;
  Random random(1);
  Tries tries;
  CHECK(!generate(w, random, &tries));
  CHECK(tries.solved == 0);
  CHECK(tries.draws == 1000);
  CHECK(tries.text().starts_with("1000 shots drawn, 0 with"));
  w = wish("\"seed\"", "\"rolling\"", {1, 1, {}});
  w.difficulty = Difficulty::easy;
  w.kind = Wish::Kind::stop;  // no stop within a centimetre succeeds nine times out of ten
  w.tries = 20;
  CHECK(!generate(w, random, &(tries = {})));
  CHECK(tries.other_difficulty + tries.no_shot == 20);
  w = wish(R"({"length":0.06,"width":0.06})", "\"rolling\"");
  CHECK(!generate(w, random, &(tries = {})));
  CHECK(tries.text() == "the table has no free place for the ball");
}
