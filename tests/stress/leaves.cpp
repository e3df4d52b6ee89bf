// SPDX-License-Identifier: MIT
//
// Asks for places that the cue ball can reach after a pot, and counts how many are reached.
//   leaves [--count 1000] [--seed 1] [--others 0] [--plays 2000] [--csv FILE]
// Each place is made forwards: a random layout, a random launch on the exact line of a random pocket, and the place
// where the plain simulator leaves the cue ball. The planner is asked for any pocket, with `centre` and with `safest`.
// `centre`: places that the replay of the plain simulator leaves exactly, to 1e-8 m. Both: the mean success of the
// leave within 0.1 m, and how far it is from the share of random plays that the plain simulator makes and leaves so.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <random>

#include "bankshot/plan/planner.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "support/exact_pot.hpp"

namespace {

using namespace bankshot;
using namespace bankshot::test;
using planning::SearchRequest;

constexpr double exact = 1e-8;

/// Returns a place that a launch on the exact line leads to; none if this one does not.
std::optional<Vec2d> reachable_place(const Puzzle& p, Random& r) {
  const SearchRequest request(p);
  const auto& mouths = request.problem->aim_points;
  const AimPoint& mouth = mouths[static_cast<std::size_t>(r.uniform(0, static_cast<double>(mouths.size()) - 1e-9))];
  const double speed = p.speed.low * std::pow(p.speed.high / p.speed.low, r.uniform(0, 1));
  const double top = r.uniform(-1, 1), side = r.uniform(-0.75, 0.75);
  const auto struck = exact_pot(request, mouth, speed, {top, side, 0});
  return struck ? rest_after_pot(request, *struck) : std::nullopt;
}

struct Sums {
  int asked = 0, solved = 0, on_place = 0, wrong = 0;
  double success = 0, square = 0;
  std::vector<double> times{};

  void add(const Puzzle& p, const Vec2d& place, int plays, std::mt19937_64& random) {
    ++asked;
    const Answer a = solve(p);
    times.push_back(a.time_us / 1000);
    if (a.shots.empty()) return;
    ++solved;
    const Shot& shot = a.shots.front();
    const auto rests = played(p, shot.launch, shot.spin);
    wrong += !rests[0] || norm(*rests[0] - shot.leave->at) > exact;
    on_place += rests[0] && !rests[1] && norm(*rests[0] - place) <= exact;
    success += shot.leave->success;
    if (plays == 0) return;
    std::normal_distribution<double> normal;
    int left = 0;
    const Pocket* const pocket = pocket_reached(p, shot);
    for (int i = 0; i < plays; ++i) {
      const Launch struck{shot.launch.speed + p.noise.speed_at(shot.launch.speed) * normal(random),
                          shot.launch.angle + p.noise.angle * normal(random)};
      const Trajectory t = simulate({{}, p.table, p.physics, p.ball, p.others, struck, shot.spin, {}});
      const auto falls = [&](const Record& e) {
        return e.kind == EventKind::pocket && e.ball == 1 &&
               &p.table.pockets[static_cast<std::size_t>(e.contact.index)] == pocket;
      };
      const auto scratch = [](const Record& e) { return e.kind == EventKind::pocket && e.ball == 0; };
      left += std::ranges::any_of(t.events, falls) && std::ranges::none_of(t.events, scratch) &&
              norm(end_of(t, 0).state.at - place) <= std::get<LeavePlace>(*p.leave).within;
    }
    const double off = shot.leave->success - static_cast<double>(left) / plays;
    square += off * off;
  }
  double time(double quantile) {
    std::ranges::sort(times);
    return times[std::min(times.size() - 1, static_cast<std::size_t>(quantile * static_cast<double>(times.size())))];
  }
};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Asks for places that the cue ball can reach after a pot.");
  int count = 1000, others = 0, plays = 2000;
  std::uint64_t seed = 1;
  std::string csv;
  app.add_option("--count", count, "Places");
  app.add_option("--seed", seed, "Seed of the layouts");
  app.add_option("--others", others, "Balls besides the one that is potted");
  app.add_option("--plays", plays, "Random plays of each answer");
  app.add_option("--csv", csv, "A file for the table");
  CLI11_PARSE(app, argc, argv);
  Random random(seed);
  std::mt19937_64 plays_random(seed);
  Sums centre, safest;
  while (centre.asked < count) {
    Puzzle p = random_pot(random, others);
    const auto place = reachable_place(p, random);
    if (!place) continue;
    p.leave = LeavePlace{*place};
    p.aim = Aim::centre;
    centre.add(p, *place, plays, plays_random);
    p.aim = Aim::safest;
    safest.add(p, *place, plays, plays_random);
  }
  std::ofstream file(csv);
  file << "others,aim,places,solved,on_place,wrong,success,rms_of_success,median_ms,99_percent_ms\n";
  bool right = true;
  for (auto& [name, s] : {std::pair<std::string, Sums&>{"centre", centre}, {"safest", safest}}) {
    const double rms = std::sqrt(s.square / std::max(1, s.solved)), mean = s.success / s.asked;
    std::cout << fmt::format(
        "seed {}, {} others, {}: {} places, {} solved, {} exactly on the place, {} wrong; success {:.3f}, rms of it "
        "{:.4f}; {:.1f} ms in the median, 99 % in {:.1f} ms\n",
        seed, others, name, s.asked, s.solved, s.on_place, s.wrong, mean, rms, s.time(0.5), s.time(0.99));
    file << fmt::format("{},{},{},{},{},{},{:.4f},{:.4f},{:.2f},{:.2f}\n", others, name, s.asked, s.solved, s.on_place,
                        s.wrong, mean, rms, s.time(0.5), s.time(0.99));
    right = right && s.wrong == 0;
  }
  return right ? 0 : 1;
}
