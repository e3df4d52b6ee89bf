// SPDX-License-Identifier: MIT
#include "planners/learn/evidence.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "bankshot/plan/planner.hpp"
#include "planners/evaluate/draws.hpp"
#include "planners/learn/goodness.hpp"
#include "planners/learn/launch.hpp"
#include "planners/learn/least_squares.hpp"
#include "planners/learn/outliers.hpp"
#include "planners/learn/settings.hpp"
#include "planners/verify/replay.hpp"

namespace bankshot::planning {
namespace {

using namespace settings::learn;

constexpr std::array<LaunchIndex, error_size> own{angle, speed, side, top};
constexpr std::array<LaunchIndex, error_size> others{start_time, x, y, masse};

/// Returns the intended launch: the one given, else that of the puzzle's best shot; none if it has no shot.
std::optional<LaunchUnknowns> meant(const Attempt& attempt) {
  if (attempt.seen.launch_given) return unknowns_of(attempt.seen.scene, 0);
  const Answer answer = solve(*attempt.puzzle);
  if (answer.shots.empty()) return {};
  ShotRequest shot = attempt.seen.scene;
  shot.launch = answer.shots.front().launch;
  shot.spin = answer.shots.front().spin;
  return unknowns_of(shot, 0);
}

/// A launch that fits the observations.
struct Fitted {
  LaunchUnknowns launch;
  std::vector<Told> told;
  double off;       ///< root mean square distance, sigmas
  double unlikely;  ///< see `unlikelihood`
  Eigen::Matrix<double, launch_size, launch_size> information;
};

/// Launches that fit, the likeliest first. If side spin dies before the next cushion, many values of side fit. If it
/// just survives, hardly another value does; that one can follow the noise and would always win by distance alone.
class Fits {
 public:
  Fits(Seen& seen, const Common& common) : seen_(seen), common_(common) {}

  /// Adds the shot's present launch, which is off by so many sigmas.
  void add(double off) {
    if (!(off < forever)) return;
    const Fitted fitted{seen_.launch, seen_.told, off, unlikelihood(seen_, common_),
                        launch_information(seen_, common_)};
    if (!std::isfinite(fitted.unlikely)) return;
    all_.insert(std::ranges::upper_bound(all_, fitted.unlikely, {}, &Fitted::unlikely), fitted);
  }
  /// Gives the shot the likeliest launch. Returns how far it is off.
  double take() {
    if (all_.empty()) return forever;
    seen_.launch = all_.front().launch;
    seen_.told = all_.front().told;
    seen_.window = forever;
    return all_.front().off;
  }
  std::span<const Fitted> all() const { return all_; }

 private:
  Seen& seen_;
  const Common& common_;
  std::vector<Fitted> all_;
};

/// Fits bounce by bounce from the intended launch, and with more and with less side. Side spin that dies before a
/// cushion leaves no trace, so a fit that is led there stays there.
void fit_from_meant(Seen& seen, const Common& common, Fits& fits, Spent& work) {
  for (const double aside : {0.0, much_aside, -much_aside}) {
    if (aside != 0 && !carries_spin(common.base)) break;
    seen.launch = seen.expected;
    seen.launch[side] += aside;
    fits.add(fit_on(seen, common, forever, work));
  }
}

/// Fits from the launch found, with more and with less side, since the whole track now decides. Fits also from no side
/// and a prior around none, because the intended side would draw it up to where it just survives.
void fit_around(Seen& seen, const Common& common, Fits& fits, Spent& work) {
  const LaunchUnknowns found = seen.launch;
  for (const double aside : {0.0, little_aside, -little_aside, much_aside, -much_aside}) {
    if (aside != 0 && !carries_spin(common.base)) return;
    seen.launch = found;
    seen.launch[side] += aside;
    fits.add(fit_window(seen, common, work));
  }
  const double meant = std::exchange(seen.expected[side], 0);
  seen.launch = found;
  seen.launch[side] = 0;
  const double off = fit_window(seen, common, work);
  seen.expected[side] = meant;
  fits.add(off);
}

/// Fits launches to the observations; the intended launch is only a weak prior.
Fits measure(Seen& seen, const Common& common, const LaunchUnknowns& aim, Spent& work) {
  for (const LaunchIndex k : {angle, speed, top, side, masse}) seen.expected[k] = aim[k];
  for (Eigen::Index i = 0; i < error_size; ++i)
    seen.spread[own[static_cast<std::size_t>(i)]] = errors_of_a_player * usual_error()(i);
  seen.spread[masse] = off_masse;
  seen.robust = robust;
  mark_apart(seen);
  const auto anew_if_off = [&](Fits& fits) {
    if (!(fits.take() < forever) || is_off(seen, common)) fits.add(fit_anew(seen, common, forever, work));
    return fits.take();
  };
  Fits first(seen, common);
  fit_from_meant(seen, common, first, work);
  if (!(anew_if_off(first) < lost)) return first;
  mark_outliers(seen, common);
  seen.robust = 0;
  Fits last(seen, common);
  fit_around(seen, common, last, work);
  anew_if_off(last);
  return last;
}

/// Information in the directions that the samples determine, and the projection onto these.
struct Kept {
  Eigen::Matrix4d information, directions;
};
Kept kept_of(const Eigen::Matrix4d& information, double expected) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(information);
  const Eigen::Vector4d kept = (solver.eigenvalues().array() > hardly_told * expected).cast<double>();
  const Eigen::Matrix4d& v = solver.eigenvectors();
  return {v * kept.cwiseProduct(solver.eigenvalues()).asDiagonal() * v.transpose(),
          v * kept.asDiagonal() * v.transpose()};
}

/// Estimate of the player's own errors by one fit, prior included, all other unknowns being free; in usual errors.
struct Mode {
  LaunchError off;
  Eigen::Matrix4d told;  ///< the inverse of their covariance
  double unlikely;
};

Mode mode_of(const Seen& seen, const Fitted& fitted) {
  const Eigen::Matrix<double, launch_size, launch_size>& all = fitted.information;
  Eigen::Matrix4d told, across, rest;
  LaunchError unit = usual_error(), off;
  for (Eigen::Index i = 0; i < error_size; ++i) {
    const auto a = own[static_cast<std::size_t>(i)];
    off(i) = fitted.launch[a] - seen.expected[a];
    if (a == angle) off(i) = std::remainder(off(i), 2 * std::numbers::pi);
    off(i) /= unit(i);
    for (Eigen::Index j = 0; j < error_size; ++j) {
      const auto b = own[static_cast<std::size_t>(j)];
      const auto c = others[static_cast<std::size_t>(i)], d = others[static_cast<std::size_t>(j)];
      told(i, j) = all(a, b) * unit(i) * unit(j);
      across(i, j) = all(c, b) * unit(j);
      rest(i, j) = all(c, d);
    }
  }
  return {off, told - across.transpose() * rest.ldlt().solve(across), fitted.unlikely};
}

/// Returns the estimates that differ by more than their uncertainty, the likeliest first.
std::vector<Mode> modes_of(const Seen& seen, std::span<const Fitted> fits) {
  std::vector<Mode> out;
  for (const Fitted& f : fits) {
    const Mode mode = mode_of(seen, f);
    if (std::ranges::none_of(out, [&](const Mode& other) {
          const LaunchError apart = mode.off - other.off;
          return apart.dot(other.told * apart) < 1;
        }))
      out.push_back(mode);
  }
  return out;
}

/// Writes what the samples alone say of the errors. If several launches fit, each counts by its likelihood. Together
/// they say what a normal distribution with their mean and covariance would, which is less than any of them alone says.
void tell_errors(const Seen& seen, const Common& common, std::span<const Fitted> fits, Evidence& out) {
  const std::vector<Mode> modes = modes_of(seen, fits);
  // If the residuals exceed the samples' errors, the shot says less.
  const double off_by = std::max(1.0, excess(seen, common));
  double weights = 0;
  LaunchError mean = LaunchError::Zero();
  Eigen::Matrix4d squares = Eigen::Matrix4d::Zero();
  for (const Mode& m : modes) {
    const double weight = std::exp(-(m.unlikely - modes.front().unlikely) / (2 * off_by * off_by));
    weights += weight;
    mean += weight * m.off;
    squares += weight * (m.told.inverse() + m.off * m.off.transpose());
  }
  mean /= weights;
  const Eigen::Matrix4d with_expected = (squares / weights - mean * mean.transpose()).inverse();
  LaunchError unit = usual_error(), off = modes.front().off, expected;
  for (Eigen::Index i = 0; i < error_size; ++i) {
    const double spread = seen.spread[own[static_cast<std::size_t>(i)]];
    expected(i) = spread == forever ? 0 : unit(i) * unit(i) / (spread * spread);
  }
  const Kept kept = kept_of(with_expected - Eigen::Matrix4d(expected.asDiagonal()), expected.maxCoeff());
  out.information = kept.information / (off_by * off_by);
  out.gradient = kept.directions * with_expected * mean / (off_by * off_by);
  if (!carries_spin(common.base)) {
    out.information.bottomRows<2>().setZero();
    out.information.rightCols<2>().setZero();
    out.gradient.tail<2>().setZero();
    off.tail<2>().setZero();
  }
  off = off.cwiseProduct(unit);
  out.error.angle = off(0), out.error.speed = off(1), out.error.side = off(2), out.error.top = off(3);
}

/// Draws launches around the intended one, with three widths, and replays each.
std::vector<Draw> draw(const Puzzle& puzzle, const LaunchUnknowns& aim, Spent& work) {
  constexpr double widths[] = {1, 2, 4};  // usual errors
  constexpr int each = 400;
  const LaunchError unit = usual_error();
  SearchRequest request(puzzle);
  request.spin = {aim[top], aim[side], aim[masse]};
  EvaluationBudget budget(std::numeric_limits<long>::max());
  std::vector<Draw> out;
  Draws draws(2);
  for (const double width : widths)
    for (int i = 0; i < each; ++i) {
      const std::vector<double>& z = draws.next();
      Draw d{width * z[0], width * z[1], 0, false};
      for (const double w : widths)
        d.density += std::exp(-(d.angle * d.angle + d.speed * d.speed) / (2 * w * w)) / (w * w);
      const Launch launch{aim[speed] + unit(1) * d.speed, wrap_angle(aim[angle] + unit(0) * d.angle)};
      d.made = launch.speed > 0 && replay(request, budget, launch, Goal::of(request)).made;
      out.push_back(d);
    }
  work.simulations += budget.simulations();
  return out;
}

}  // namespace

LaunchError usual_error() {
  const Noise usual;
  constexpr double spin = 0.05;
  return {usual.angle, usual.speed, spin, spin};
}

Evidence evidence_of(const Attempt& attempt, double noise, Spent& work) {
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
  Fits fits = measure(seen, common, aim, work);
  out.error.left_out = !(std::max(fits.take(), excess(seen, common)) < lost);
  out.error.rms = distances(seen, common).rms;
  if (!out.error.left_out) tell_errors(seen, common, fits.all(), out);
  return out;
}

}  // namespace bankshot::planning
