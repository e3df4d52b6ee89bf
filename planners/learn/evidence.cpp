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

/// A launch that fits what was seen.
struct Fitted {
  LaunchUnknowns launch;
  std::vector<Told> told;
  double off;       ///< root mean square distance, sigmas
  double unlikely;  ///< see `unlikelihood`
  Eigen::Matrix<double, launch_size, launch_size> information;
};

/// Launches that fit, the likeliest first. A side that dies before the next cushion leaves room for any that does, one
/// that just lives hardly for another: by distance alone this one, which is nearer by what the noise can make it, would
/// always be taken.
class Fits {
 public:
  Fits(Seen& seen, const Common& common) : seen_(seen), common_(common) {}

  /// The launch that the shot has.
  void add(double off) {
    if (!(off < forever)) return;
    const Fitted fitted{seen_.launch, seen_.told, off, unlikelihood(seen_, common_),
                        launch_information(seen_, common_)};
    if (!std::isfinite(fitted.unlikely)) return;
    all_.insert(std::ranges::upper_bound(all_, fitted.unlikely, {}, &Fitted::unlikely), fitted);
  }
  /// Leaves the shot with the likeliest. Returns how far it is off.
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

/// From what was meant bounce by bounce, with more and with less side too: where it dies before a cushion it leaves no
/// trace, so that a fit that is led there stays.
void fit_from_meant(Seen& seen, const Common& common, Fits& fits, Work& work) {
  for (const double aside : {0.0, much_aside, -much_aside}) {
    if (aside != 0 && !carries_spin(common.base)) break;
    seen.launch = seen.expected;
    seen.launch[side] += aside;
    fits.add(fit_on(seen, common, forever, work));
  }
}

/// From the launch that was found, and with more and with less side: by now all of the track says which way to go. And
/// with none, which stays where it dies: what was meant would draw it up to where it just lives.
void fit_around(Seen& seen, const Common& common, Fits& fits, Work& work) {
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

/// The launch fitted to what was seen, and others that fit too; what was meant says little of them.
Fits measure(Seen& seen, const Common& common, const LaunchUnknowns& aim, Work& work) {
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

/// The directions in which something is told, and what.
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

/// Where the player's own errors are by one fit, what is expected of them included, all else unknown; in usual errors.
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

/// Those that differ by more than each may be off; the likeliest first.
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

/// What the samples alone say. Where several launches fit, each counts by its likelihood, and together they say what
/// one with their mean and covariance would: less than any of them alone.
void tell_errors(const Seen& seen, const Common& common, std::span<const Fitted> fits, Evidence& out) {
  const std::vector<Mode> modes = modes_of(seen, fits);
  // Where the laws follow the shot less well than samples err, it tells less.
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
  Fits fits = measure(seen, common, aim, work);
  out.error.left_out = !(std::max(fits.take(), excess(seen, common)) < lost);
  out.error.rms = distances(seen, common).rms;
  if (!out.error.left_out) tell_errors(seen, common, fits.all(), out);
  return out;
}

}  // namespace bankshot::planning
