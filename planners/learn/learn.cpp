// SPDX-License-Identifier: MIT
#include "planners/learn/learn.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <atomic>
#include <cmath>

#include "bankshot/numbers/random.hpp"
#include "planners/in_parallel.hpp"
#include "planners/learn/goodness.hpp"
#include "planners/learn/launch.hpp"
#include "planners/learn/least_squares.hpp"
#include "planners/learn/settings.hpp"

namespace bankshot::planning {
namespace {

using namespace settings::learn;

/// Calls `f(seen, work)` for all shots; returns how many calls returned true.
int count_shots(Shots& shots, int threads, const std::function<bool(Seen&, Spent&)>& f, Spent& work) {
  std::vector<Seen*> list;
  for (Seen& seen : shots) list.push_back(&seen);
  std::vector<Spent> works(list.size());
  std::atomic<int> count = 0;
  for_each_index(list.size(), threads, [&](std::size_t i) { count += f(*list[i], works[i]); });
  for (const Spent& w : works) work.simulations += w.simulations, work.restarts += w.restarts;
  return count;
}

/// Sets the sigma of each shot. If the laws cannot follow the shots, it is the typical error of all samples, the same
/// for all shots: a shot that is hard to follow says the most about the laws.
void weigh(Learnt& l) {
  std::vector<double> sizes;
  for (const Seen& seen : l.shots)
    for (const auto& track : misses(seen, l.common))
      for (const Vec2d& d : track) sizes.push_back(std::abs(d.x)), sizes.push_back(std::abs(d.y));
  l.off = of_median * median(sizes);
  constexpr double clearly = 1.5;
  for (Seen& seen : l.shots) seen.sigma = l.off > clearly * seen.noise ? l.off : seen.noise;
  l.astray = l.off > clearly * l.noise;
}

/// Finds the direction that the shots determine least. If a guess says more, the coefficient with the largest part in
/// it is held. Returns whether one was.
bool hold_one(Learnt& l) {
  Common& c = l.common;
  if (c.names.empty()) return false;
  Eigen::MatrixXd told = information(l.shots, c);
  const auto m = told.rows();
  const auto guess = [&](Eigen::Index k) { return c.fittable(c.names[static_cast<std::size_t>(k)]).guess; };
  for (Eigen::Index i = 0; i < m; ++i)
    for (Eigen::Index j = 0; j < m; ++j) told(i, j) *= guess(i) * guess(j);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(told);
  if (solver.eigenvalues()(0) >= 1) return false;
  const Eigen::VectorXd v = solver.eigenvectors().col(0).cwiseAbs();
  Eigen::Index worst = 0;
  v.maxCoeff(&worst);
  HeldCoefficient held{c.names[static_cast<std::size_t>(worst)], 0};
  held.value = c.fittable(held.name).start;
  constexpr double shares = 0.3;
  for (Eigen::Index k = 0; k < m; ++k)
    if (k != worst && v(k) > shares * v(worst)) held.like.push_back(c.names[static_cast<std::size_t>(k)]);
  c.names.erase(c.names.begin() + worst);
  c.values.erase(c.values.begin() + worst);
  l.held.push_back(held);
  return true;
}

/// Leaves out shots that fit far worse than the others, since they would lead the coefficients astray.
void leave_out_lost(Learnt& l) {
  std::vector<double> spreads;
  for (const Seen& seen : l.shots) spreads.push_back(spread(seen, l.common));
  const double most = lost * std::max(good, median(spreads));
  auto own = spreads.begin();
  std::size_t out = 0;
  for (Seen& seen : l.shots) out += seen.left_out = *own++ > most || (seen.robust == 0 && is_off(seen, l.common));
  if (2 * out <= l.shots.size()) return;
  for (Seen& seen : l.shots) seen.left_out = false;  // if most shots seem wrong, the coefficients are wrong
}

void solve(Learnt& l, Spent& work) {
  leave_out_lost(l);
  solve_all(l.shots, l.common, work);
}

/// Fits launches and coefficients in turn, until no badly fitting launch is replaced by a better one.
void settle(Learnt& l, int threads, Spent& work) {
  constexpr int rounds = 3;
  for (int round = 0, changed = 1; round < rounds && changed > 0; ++round) {
    solve(l, work);
    const auto again = [&](Seen& seen, Spent& its) {
      const bool better = look_again(seen, l.common, its) || look_for_usual(seen, l.common, its);
      tell(seen, l.common, its);
      return better;
    };
    changed = count_shots(l.shots, threads, again, work);
    weigh(l);
  }
}

/// Returns the sum of squares in sigmas. If the laws can follow the shots, all lost shots count alike, since their
/// distance says nothing. Otherwise shots that are hard to follow say the most.
double cost_of(const Learnt& l) {
  double sum = 0;
  for (const Seen& seen : l.shots) {
    const double off = excess(seen, l.common), e = l.astray ? off : std::min(off, lost);
    sum += e * e * seen.samples_used();
  }
  return sum;
}

/// Ways to move the coefficients before a new start. Each by itself leads far away where coefficients are hard to tell
/// apart. Together, as they are correlated, they lead to where paths change little.
enum class Shaken { each, together };

/// The state of a fit, to which it may return.
class Kept {
 public:
  explicit Kept(const Learnt& l) : common_(l.common) {
    for (const Seen& seen : l.shots) launches_.emplace_back(seen.launch, seen.told);
  }
  void restore(Learnt& l) const {
    l.common = common_;
    auto was = launches_.begin();
    for (Seen& seen : l.shots) std::tie(seen.launch, seen.told) = *was++;
  }

 private:
  Common common_;
  std::vector<std::pair<LaunchUnknowns, std::vector<Told>>> launches_;
};

/// Moves the coefficients at random; returns false if they have no covariance.
bool move_coefficients(Learnt& l, Shaken how, Random& random) {
  constexpr double way = 6;  // standard errors
  const Eigen::MatrixXd errors = covariance(l.shots, l.common);
  if (errors.size() == 0) return false;
  Eigen::VectorXd by(errors.rows());
  for (double& b : by) b = random.uniform(-way, way);
  if (how == Shaken::each)
    by = by.cwiseProduct(errors.diagonal().cwiseSqrt());
  else
    by = errors.llt().matrixL() * by;
  for (std::size_t k = 0; k < l.common.values.size(); ++k) {
    const Fittable& of = l.common.fittable(l.common.names[k]);
    double& value = l.common.values[k];
    value = std::clamp(value + by(static_cast<Eigen::Index>(k)), of.low, of.high);
  }
  return true;
}

/// Starts the fit again from near by and keeps what is better, because paths have kinks at which a fit may stop. It
/// ends after `most_in_vain` tries without gain.
void shake(Learnt& l, Shaken how, int most_in_vain, int threads, Spent& work) {
  const int tries = 4 * most_in_vain;
  Random random(1);
  for (int i = 0, in_vain = 0; i < tries && in_vain < most_in_vain; ++i) {
    const Kept before(l);
    const double cost = cost_of(l);
    if (!move_coefficients(l, how, random)) return;
    const auto again = [&](Seen& seen, Spent& its) {
      if (how == Shaken::together && seen.left_out) return fit_side(seen, l.common, its) < forever;
      return look_again(seen, l.common, its);
    };
    constexpr int rounds = 2;
    for (int round = 0; round < rounds; ++round) {
      count_shots(l.shots, threads, again, work);
      solve(l, work);
    }
    constexpr double gain = 1;
    const double after = cost_of(l);
    in_vain = after < cost - gain ? 0 : in_vain + 1;
    if (after >= cost) before.restore(l);
  }
  leave_out_lost(l);
}

/// Moves the coefficients widely first, for those that may be far off, then by many small steps, which cost little.
/// Without the small ones some fits stop at a kink, three standard errors off or more.
void shake(Learnt& l, int threads, Spent& work) {
  constexpr int wide_in_vain = 2, small_in_vain = 6;
  shake(l, Shaken::each, wide_in_vain, threads, work);
  if (!l.astray) shake(l, Shaken::together, small_in_vain, threads, work);
}

/// Fits from bounce to bounce: the coefficients are learnt from launches that are certain before long paths are used.
void follow(Learnt& l, int threads, Spent& work) {
  const auto begin = [&](Seen& seen, Spent& its) { return fit_first_part(seen, l.common, its) < forever; };
  const auto farther = [&](Seen& seen, Spent& its) {
    look_again(seen, l.common, its);
    if (!fit_farther(seen, l.common, its)) return false;
    look_again(seen, l.common, its);
    return true;
  };
  count_shots(l.shots, threads, begin, work);
  do solve(l, work);
  while (count_shots(l.shots, threads, farther, work) > 0);
}

/// Returns whether a coefficient gives the dependence on speed, which is fitted once the others are nearly known.
bool is_fine(const std::string& name) { return name.ends_with(".per_speed") || name.ends_with(".per_speed2"); }

/// Fits while outliers are not yet known. Coefficients start at the values of the physics, and in a further `attempt`
/// as far off as tables differ.
Learnt first_fit(const Recordings& recordings, const Asked& asked, int attempt, Spent& work) {
  const bool balls = std::ranges::any_of(recordings, [](const Recording* r) { return !r->scene.others.empty(); });
  Learnt l{.common = {asked.base, coefficients_of(asked.base, recordings.front()->scene.ball.body, balls)},
           .noise = noise_of(recordings)};
  Random random(static_cast<std::uint64_t>(attempt));
  const auto add = [&](bool fine) {
    for (const std::string& name : asked.names) {
      if (is_fine(name) != fine) continue;
      l.common.add(name);
      const Fittable& of = l.common.fittable(name);
      if (attempt > 0)
        l.common.values.back() = std::clamp(of.start + random.uniform(-1, 1) * of.guess, of.low, of.high);
    }
  };
  add(false);
  for (const Recording* r : recordings) {
    Seen& seen = l.shots.emplace_back(*r, l.noise);
    seen.robust = robust;
    seen.spread[masse] = first_masse;
    mark_apart(seen);
  }
  follow(l, asked.threads, work);
  weigh(l);
  settle(l, asked.threads, work);
  if (std::ranges::any_of(asked.names, is_fine)) {
    add(true);
    settle(l, asked.threads, work);
  }
  while (hold_one(l)) solve_all(l.shots, l.common, work);
  weigh(l);
  return l;
}

void finish(Learnt& l, int threads, Spent& work) {
  if (l.astray) {
    shake(l, threads, work);
    weigh(l);
  }
  for (Seen& seen : l.shots) {
    seen.spread[masse] = spread_of_masse;
    seen.robust = l.astray ? robust : 0;
    mark_outliers(seen, l.common);
  }
  settle(l, threads, work);
  if (!l.astray) shake(l, threads, work);
  while (hold_one(l)) settle(l, threads, work);  // at these values the shots may determine less
}

}  // namespace

Learnt learn(const Recordings& recordings, const Asked& asked, Spent& work,
             const std::function<void(double)>& progress) {
  Learnt best = first_fit(recordings, asked, 0, work);
  progress(0.5);
  // If the laws cannot follow the shots, they may still be the right ones, with coefficients that were led astray.
  constexpr int attempts = 4;
  constexpr double clearly = 0.7;
  for (int i = 1; i < attempts && best.astray; ++i)
    if (Learnt other = first_fit(recordings, asked, i, work); other.off < clearly * best.off) best = std::move(other);
  progress(0.7);
  finish(best, asked.threads, work);
  progress(0.9);
  return best;
}

}  // namespace bankshot::planning
