// SPDX-License-Identifier: MIT
//
// Compares traces with simulations, over random launches of all models, balls and jaws: a path that is told its branch
// must be where the simulation of the same launch is, after each meeting; and what a discovered path says after each
// prefix of its branch must be what a trace of that prefix says.
//   traced --count 1000000 --seed 1 [--family masse]
// Prints one line per family; each failure is printed as JSON. Exit 1 if there is a failure, or nothing was compared.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include "bankshot/scene/json.hpp"
#include "support/random_balls.hpp"
#include "support/random_question.hpp"
#include "support/random_shot.hpp"
#include "support/traced.hpp"

namespace {

using namespace bankshot;
using namespace bankshot::test;

constexpr std::size_t most_meetings = 8;

struct Sample {
  std::string name;
  /// Judges a random launch; returns what differs, followed by its JSON.
  std::function<std::string(Random&, TraceTally&)> judge;
};

std::string told(const std::string& differs, const std::string& json) {
  return differs.empty() ? "" : differs + "\n" + json;
}

std::string discovered(Random& random, TraceTally& tally) {
  const Json question = random_question(random, {.most_balls = 1});
  const auto puzzle = valid_puzzle(question);
  const planning::SearchRequest request(*puzzle);
  if (request.problem->objects) return "";  // an object ball goes on, and no path is discovered
  const Launch launch{random.log_uniform(0.2, 8), random.uniform(0, 6.28)};
  return told(differs_from_discovery(request, launch, tally), question.dump());
}

std::vector<Sample> samples() {
  std::vector<Sample> all;
  for (const ShotFamily f : shot_families)
    all.push_back({name(f), [f](Random& random, TraceTally& tally) {
                     const ShotRequest shot = random_shot(random, f);
                     return told(differs_from_trace(shot, false, most_meetings, tally), write_shot(shot));
                   }});
  for (const BallFamily f : ball_families)
    for (const bool sends : {false, true})
      all.push_back({"balls " + name(f) + (sends ? ", the ball that is hit" : ", the cue ball"),
                     [f, sends](Random& random, TraceTally& tally) {
                       const ShotRequest shot = random_balls(random, f);
                       return told(differs_from_trace(shot, sends, most_meetings, tally), write_shot(shot));
                     }});
  all.push_back({"discovered", discovered});
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Compares traces with simulations."};
  long count = 1000;
  std::uint64_t seed = 1;
  std::string only;
  app.add_option("--count", count, "launches of each family");
  app.add_option("--seed", seed, "the draws");
  app.add_option("--family", only, "one family alone");
  CLI11_PARSE(app, argc, argv);
  long failed = 0, meetings = 0;
  std::cout << "family,seed,launches,meetings,failed,worst\n";
  for (const Sample& family : samples()) {
    if (!only.empty() && family.name != only) continue;
    Random random(seed);
    TraceTally tally;
    long own = 0;
    for (long i = 0; i < count; ++i) {
      const std::string differs = family.judge(random, tally);
      if (differs.empty()) continue;
      if (++own <= 3) std::cerr << family.name << ": " << differs << '\n';
    }
    std::cout << fmt::format("\"{}\",{},{},{},{},{:.2g}\n", family.name, seed, tally.launches, tally.meetings, own,
                             tally.worst);
    failed += own;
    meetings += tally.meetings;
  }
  return failed > 0 || meetings == 0;
}
