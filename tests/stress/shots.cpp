// SPDX-License-Identifier: MIT
//
// Simulates random shots of one ball and checks each. The centre must never be outside the table, energy must never be
// gained, the shot must end, and every number must be finite. The first shots of each family are compared with 50
// digits. At a tie, and where κ is above 1e6, nothing is compared, so both are counted and bounded.
//   shots --count 1000000 --seed 1 [--family masse] [--truth 10000]
// Prints one line per family; each failure is printed as JSON that `bankshot simulate` replays. Exit 1 if there is a
// failure, or if a family was compared too rarely.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>

#include "bankshot/simulate/simulator.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "bankshot/simulate/with_physics.hpp"
#include "support/random_shot.hpp"
#include "support/truth.hpp"

namespace {

using namespace bankshot;

constexpr long endless = 20000;            // events; 200 cushions and their phases are far fewer
constexpr double energy_rounding = 1e-13;  // relative, per step
constexpr double hard = 1e6;               // κ above which a shot is counted, not judged

struct Tally {
  long shots = 0, events = 0, failed = 0;
  double outside = 0;  // worst, in units of Boundary::touch
  double gain = 0;     // worst, relative, per step
  long truth = 0, ties = 0, wrong = 0, conditioned = 0, beyond = 0;
  double ratio = 0, kappa = 0, miss = 0;

  /// Returns why the comparison says too little; empty if it suffices. Only the family `corners` has many ties, and
  /// only `grazing` has many shots with κ above 1e6.
  std::string too_little(test::ShotFamily f) const {
    const long most_ties = 2 + (f == test::ShotFamily::corners ? truth / 25 : truth / 300), most_steep = 2 + truth / 12;
    if (ties > most_ties) return fmt::format("{} of {} ended at a tie, and {} may", ties, truth, most_ties);
    if (conditioned > most_steep)
      return fmt::format("{} of {} had kappa above {:.0e}, and {} may", conditioned, truth, hard, most_steep);
    return "";
  }
};

/// Returns how far a place is outside the table, in units of Boundary::touch. The lines of the walls bound a convex
/// table.
double outside(const Boundary& b, const Vec2d& at) {
  double worst = 0;
  if (!b.strictly_convex) return std::max(0.0, -b.clearance(at) / b.touch);
  for (const Wall& w : b.walls) worst = std::max(worst, (w.offset - dot(w.normal, at)) / b.touch);
  return worst;
}

/// Returns the same along an arc: where it turns back from a wall, and at three places between.
double outside_along(const Boundary& b, const Arc<double>& arc, double travelled) {
  double worst = 0;
  for (const Wall& w : b.walls) {
    const double t = -dot(w.normal, arc.velocity) / dot(w.normal, arc.acceleration);
    if (t > 0 && t < travelled) worst = std::max(worst, outside(b, arc.position(t)));
  }
  for (const double part : {0.25, 0.5, 0.75}) worst = std::max(worst, outside(b, arc.position(part * travelled)));
  return worst;
}

bool finite(const State<double>& s) {
  return std::isfinite(s.at.x + s.at.y + s.velocity.x + s.velocity.y + s.spin.x + s.spin.y + s.spin.z);
}

/// Returns what is wrong with the shot; empty if nothing.
std::string check(const ShotRequest& shot, const Boundary& boundary, Tally& t) {
  return with_physics(shot.physics, [&](const auto& motion, const auto& cushion) -> std::string {
    Simulator sim(boundary, motion, cushion, start_state(shot));
    double lowest = 0;  // J, so that no energy is negative on a tilted table
    for (const Vec2d& v : shot.table.vertices)
      lowest = std::max(lowest, -shot.ball.body.mass * gravity(shot.physics) * dot(shot.physics.tilt, v));
    const auto energy_now = [&] {
      State<double> s = sim.state();
      s.spin = motion.spin(shot.ball.body, s);
      return energy(shot.physics, shot.ball.body, s) + lowest;
    };
    double before = energy_now();
    const double most = is_level(shot.physics) ? 0 : before;  // rounded relative to the initial energy
    int cushions = 0;
    for (long i = 0; i < endless; ++i) {
      const Event e = sim.step();
      ++t.events;
      if (!finite(sim.state()) || !std::isfinite(sim.time())) return "a number is not finite";
      const double out = std::max(outside(boundary, sim.state().at),
                                  sim.arc().chord ? 0 : outside_along(boundary, sim.arc(), sim.travelled()));
      t.outside = std::max(t.outside, out);
      if (out > 1) return fmt::format("outside by {:.3g} touch", out);
      const double now = energy_now();
      if (before > 0) t.gain = std::max(t.gain, now / before - 1);
      if (now > before + energy_rounding * std::max(before, most))
        return fmt::format("gains energy: {:.17g} J of {:.17g} J", now, before);
      before = now;
      if (e.kind == EventKind::cushion) ++cushions;
      if (e.final() || cushions >= *shot.until.cushions) return "";
    }
    return "endless";
  });
}

/// Compares up to a dozen cushions of the shot with 50 digits.
std::string check_truth(const ShotRequest& shot, const Boundary& boundary, int cushions, Tally& t) {
  const test::Compared c = test::compare_with_truth({boundary, shot.physics, start_state(shot), cushions});
  ++t.truth;
  const bool judged = c.kappa <= hard;
  if (c.order == test::Compared::Order::tie) ++t.ties;
  if (!judged) ++t.conditioned;
  if (c.order == test::Compared::Order::wrong) {
    if (!judged) return "";
    ++t.wrong;
    return fmt::format("events differ from those of 50 digits within {} cushions (condition {:.3g})", cushions,
                       c.kappa);
  }
  if (c.order == test::Compared::Order::tie) return "";
  if (!judged) {
    if (!(c.ratio() <= tolerance::simulation_error)) ++t.beyond;
    return "";
  }
  t.ratio = std::max(t.ratio, c.ratio());
  t.kappa = std::max(t.kappa, c.kappa);
  t.miss = std::max(t.miss, c.error / boundary.extent);
  if (c.ratio() <= tolerance::simulation_error) return "";
  return fmt::format("error {:.3g} m after {} cushions is {:.3g} units of 2^-53 size kappa, kappa {:.3g}", c.error,
                     cushions, c.ratio(), c.kappa);
}

constexpr const char* header =
    "family,seed,shots,events,failed,outside_in_touch,energy_gain,truth,worst_error_over_unit,bound,worst_error_over_"
    "extent,ties,wrong_order,"
    "condition,ill_conditioned,ill_conditioned_beyond\n";

std::string row(test::ShotFamily f, std::uint64_t seed, const Tally& t, bool csv) {
  constexpr const char* as_csv = "{},{},{},{},{},{:.2g},{:.1g},{},{:.3g},{},{:.2g},{},{},{:.1g},{},{}\n";
  constexpr const char* as_text =
      "{:8} seed {}: {} shots, {} events, {} failed; outside by {:.2g} touch, energy gain {:.1g}; {} against 50 "
      "digits: worst error {:.2g} of the "
      "bound's unit (C = {}), {:.2g} of the extent, {} at ties, {} in wrong order; condition up to {:.1g}, {} above "
      "1e6 ({} beyond the bound)\n";
  return fmt::format(fmt::runtime(csv ? as_csv : as_text), test::name(f), seed, t.shots, t.events, t.failed, t.outside,
                     t.gain, t.truth, t.ratio, tolerance::simulation_error, t.miss, t.ties, t.wrong, t.kappa,
                     t.conditioned, t.beyond);
}

/// Simulates all shots of a family; each failure is printed as JSON that `bankshot simulate` replays.
Tally run(test::ShotFamily f, std::uint64_t seed, long count, long truth, std::ostream& failures) {
  constexpr long most_printed = 20;
  test::Random random(seed);
  Tally t;
  for (long i = 0; i < count; ++i) {
    const ShotRequest shot = test::random_shot(random, f);
    const Boundary boundary(shot.table, shot.ball.body);
    const int cushions = random.integer(1, 12);
    std::string problem = check(shot, boundary, t);
    if (problem.empty() && i < truth) problem = check_truth(shot, boundary, cushions, t);
    ++t.shots;
    if (problem.empty() || ++t.failed > most_printed) continue;
    failures << fmt::format("FAILED {} number {} of seed {}: {}\n{}\n", test::name(f), i, seed, problem,
                            test::write_shot(shot));
  }
  return t;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Random shots: inside, without gain, never endless, and true to 50 digits?");
  long count = 12000, truth = 120;
  std::uint64_t seed = 1;
  std::string family = "all";
  bool csv = false;
  std::vector<std::string> names{"all"};
  for (const test::ShotFamily f : test::shot_families) names.push_back(test::name(f));
  app.add_option("--count", count)->capture_default_str();
  app.add_option("--seed", seed)->capture_default_str();
  app.add_option("--family", family)->check(CLI::IsMember(names))->capture_default_str();
  app.add_option("--truth", truth, "how many of them are held against 50 digits")->capture_default_str();
  app.add_flag("--csv", csv);
  CLI11_PARSE(app, argc, argv);

  const long parts = family == "all" ? static_cast<long>(std::size(test::shot_families)) : 1;
  const auto share = [&](long n) { return (n + parts - 1) / parts; };
  Tally all;
  if (csv) std::cout << header;
  for (const test::ShotFamily f : test::shot_families) {
    if (family != "all" && family != test::name(f)) continue;
    const Tally t = run(f, seed, share(count), share(truth), csv ? std::cerr : std::cout);
    std::cout << row(f, seed, t, csv);
    if (const std::string problem = t.too_little(f); !problem.empty()) {
      std::cerr << fmt::format("FAILED {}: {}\n", test::name(f), problem);
      ++all.failed;
    }
    all.ratio = std::max(all.ratio, t.ratio);
    all.shots += t.shots;
    all.failed += t.failed;
    all.truth += t.truth;
    all.events += t.events;
    all.ties += t.ties;
  }
  if (!csv)
    std::cout << fmt::format("{} shots, {} events, {} failed; {} against 50 digits, {} at ties, worst {:.3g} units\n",
                             all.shots, all.events, all.failed, all.truth, all.ties, all.ratio);
  return all.failed == 0 ? 0 : 1;
}
