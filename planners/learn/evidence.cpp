// SPDX-License-Identifier: MIT
#include "planners/learn/evidence.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "bankshot/plan/planner.hpp"
#include "planners/learn/goodness.hpp"
#include "planners/learn/launch.hpp"
#include "planners/learn/least_squares.hpp"
#include "planners/learn/outliers.hpp"
#include "planners/learn/settings.hpp"
#include "planners/merit/draws.hpp"
#include "planners/proof/replay.hpp"

namespace bankshot::planning {
namespace {

using namespace settings::learn;

constexpr std::array<LaunchIndex, error_size> own{angle, speed, side, top};
constexpr std::array<LaunchIndex, error_size> others{start_time, x, y, masse};

/// The puzzle's likeliest shot where none is given; none where it has none.
std::optional<LaunchUnknowns> meant(const Attempt& attempt) {
  if (attempt.seen.launch_given) return unknowns_of(attempt.seen.scene, 0);
  const Answer answer = solve(*attempt.puzzle);
  if (answer.shots.empty()) return {};
  ShotRequest shot = attempt.seen.scene;
  shot.launch = answer.shots.front().launch;
  shot.spin = answer.shots.front().spin;
  return unknowns_of(shot, 0);
}

/// The best launch near the one that was meant. A side that dies before a cushion leaves no trace, so that a fit that
/// is led there stays: from more and from less of it too.
double fit_near(Seen& seen, const Common& common, Work& work) {
  const LaunchUnknowns first = seen.expected;
  LaunchUnknowns launch = first;
  double best = forever;
  constexpr double clearly = 0.99;
  for (const double aside : {0.0, much_aside, -much_aside}) {
    if (aside != 0 && !carries_spin(common.base)) break;
    seen.launch = first;
    seen.launch[side] += aside;
    if (const double off = fit_on(seen, common, forever, work); off < clearly * best) best = off, launch = seen.launch;
  }
  seen.launch = launch;
  tell(seen, common, work);
  return best;
}

/// The launch fitted to what was seen; what was meant says little of it. Returns how far it is off, in sigmas.
double measure(Seen& seen, const Common& common, const LaunchUnknowns& aim, Work& work) {
  for (const LaunchIndex k : {angle, speed, top, side, masse}) seen.expected[k] = aim[k];
  for (Eigen::Index i = 0; i < error_size; ++i)
    seen.spread[own[static_cast<std::size_t>(i)]] = errors_of_a_player * usual_error()(i);
  seen.spread[masse] = off_masse;
  seen.robust = robust;
  mark_apart(seen);
  const auto fit = [&] {
    const double near = fit_near(seen, common, work);
    if (!is_off(seen, common)) return near;
    const LaunchUnknowns launch = seen.launch;
    if (const double anew = fit_anew(seen, common, forever, work); anew < near) return anew;
    seen.launch = launch;
    tell(seen, common, work);
    return near;
  };
  if (const double off = fit(); !(off < lost)) return off;
  mark_outliers(seen, common);
  seen.robust = 0;
  return std::max(fit(), excess(seen, common));
}

/// Without what rounding left of directions that are not told.
Eigen::Matrix4d positive(const Eigen::Matrix4d& m) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(m);
  const Eigen::Vector4d kept = solver.eigenvalues().cwiseMax(0);
  return solver.eigenvectors() * kept.asDiagonal() * solver.eigenvectors().transpose();
}

/// What the samples alone say, all but the player's own errors unknown.
void tell_errors(const Seen& seen, const Common& common, Evidence& out) {
  const Eigen::Matrix<double, launch_size, launch_size> all = launch_information(seen, common);
  Eigen::Matrix4d told, across, rest;
  LaunchError unit = usual_error(), off, expected;
  for (Eigen::Index i = 0; i < error_size; ++i) {
    const auto a = own[static_cast<std::size_t>(i)];
    off(i) = seen.launch[a] - seen.expected[a];
    if (a == angle) off(i) = std::remainder(off(i), 2 * std::numbers::pi);
    off(i) /= unit(i);
    expected(i) = seen.spread[a] == forever ? 0 : unit(i) * unit(i) / (seen.spread[a] * seen.spread[a]);
    for (Eigen::Index j = 0; j < error_size; ++j) {
      const auto b = own[static_cast<std::size_t>(j)];
      const auto c = others[static_cast<std::size_t>(i)], d = others[static_cast<std::size_t>(j)];
      told(i, j) = all(a, b) * unit(i) * unit(j);
      across(i, j) = all(c, b) * unit(j);
      rest(i, j) = all(c, d);
    }
  }
  const Eigen::Matrix4d with_expected = told - across.transpose() * rest.ldlt().solve(across);
  // Where the laws follow the shot less well than samples err, it tells less.
  const double off_by = std::max(1.0, excess(seen, common));
  out.information = positive(with_expected - Eigen::Matrix4d(expected.asDiagonal()));
  out.gradient = with_expected * off;
  out.information /= off_by * off_by;
  out.gradient /= off_by * off_by;
  if (!carries_spin(common.base)) {
    out.information.bottomRows<2>().setZero();
    out.information.rightCols<2>().setZero();
    out.gradient.tail<2>().setZero();
    off.tail<2>().setZero();
  }
  off = off.cwiseProduct(unit);
  out.error.angle = off(0), out.error.speed = off(1), out.error.side = off(2), out.error.top = off(3);
}

/// Launches around what was meant, three widths of them, and which are made.
std::vector<Draw> draw(const Puzzle& puzzle, const LaunchUnknowns& aim, Work& work) {
  constexpr double widths[] = {1, 2, 4};  // usual errors
  constexpr int each = 400;
  const LaunchError unit = usual_error();
  Question q(puzzle);
  q.spin = {aim[top], aim[side], aim[masse]};
  Ledger ledger(std::numeric_limits<long>::max());
  std::vector<Draw> out;
  Draws draws(2);
  for (const double width : widths)
    for (int i = 0; i < each; ++i) {
      const std::vector<double>& z = draws.next();
      Draw d{width * z[0], width * z[1], 0, false};
      for (const double w : widths)
        d.density += std::exp(-(d.angle * d.angle + d.speed * d.speed) / (2 * w * w)) / (w * w);
      const Launch launch{aim[speed] + unit(1) * d.speed, wrap_angle(aim[angle] + unit(0) * d.angle)};
      d.made = launch.speed > 0 && replay(q, ledger, launch, Goal::of(q)).made;
      out.push_back(d);
    }
  work.simulations += ledger.simulations();
  return out;
}

}  // namespace

LaunchError usual_error() {
  const Noise usual;
  constexpr double spin = 0.05;
  return {usual.angle, usual.speed, spin, spin};
}

Evidence evidence_of(const Attempt& attempt, double noise, Work& work) {
  Evidence out{.error = {.id = attempt.seen.scene.id}};
  const auto found = meant(attempt);
  if (!found) return out.error.left_out = true, out;
  const LaunchUnknowns& aim = *found;
  out.meant_speed = aim[speed];
  if (attempt.seen.tracks.empty()) {
    out.made = *attempt.made;
    out.draws = draw(*attempt.puzzle, aim, work);
    return out;
  }
  Recording recording = attempt.seen;
  recording.scene = with_launch(recording.scene, aim);
  recording.launch_given = true;
  Seen seen(recording, noise);
  const Common common{.base = recording.scene.physics};
  out.error.measured = true;
  out.error.left_out = !(measure(seen, common, aim, work) < lost);
  out.error.rms = distances(seen, common).rms;
  if (!out.error.left_out) tell_errors(seen, common, out);
  return out;
}

}  // namespace bankshot::planning
