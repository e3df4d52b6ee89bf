// SPDX-License-Identifier: MIT
#include "bankshot/learn/fit.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <thread>

#include "bankshot/numbers/random.hpp"
#include "planners/learn/joint.hpp"
#include "planners/learn/settings.hpp"

namespace bankshot {
namespace planning {
namespace {

using namespace settings::learn;
using Recordings = std::vector<const Recording*>;

double median(std::vector<double> v) {
  if (v.empty()) return 0;
  const auto middle = v.begin() + static_cast<long>(v.size() / 2);
  std::ranges::nth_element(v, middle);
  return *middle;
}

/// Of normal errors, from the median of their sizes.
constexpr double of_median = 1.4826;

void each_shot(Shots& shots, int threads, const std::function<void(Seen&, Work&)>& f, Work& work) {
  std::vector<Seen*> list;
  for (Seen& seen : shots) list.push_back(&seen);
  std::vector<Work> works(list.size());
  std::atomic<std::size_t> next = 0;
  const auto run = [&] {
    for (std::size_t i; (i = next++) < list.size();) f(*list[i], works[i]);
  };
  {
    std::vector<std::jthread> pool;
    for (int k = 1; k < threads; ++k) pool.emplace_back(run);
    run();
  }
  for (const Work& w : works) work.simulations += w.simulations, work.restarts += w.restarts;
}

/// m: how much one coordinate of a sample errs, from what neighbours do not share: third differences of four samples at
/// even times, whose variance is 20 sigma squared.
double noise_of(const Recordings& recordings) {
  std::vector<double> thirds;
  for (const Recording* r : recordings)
    for (const Track& track : r->tracks)
      for (std::size_t i = 3; i < track.samples.size(); ++i) {
        const Sample* s = &track.samples[i - 3];
        const double step = s[1].time - s[0].time;
        if (std::abs(s[2].time - s[1].time - step) > 0.1 * step || std::abs(s[3].time - s[2].time - step) > 0.1 * step)
          continue;
        const Vec2d d = (s[3].at - s[0].at) - (s[2].at - s[1].at) * 3.0;
        thirds.push_back(std::abs(d.x)), thirds.push_back(std::abs(d.y));
      }
  constexpr double least = 1e-5, usual = 1e-3;
  return thirds.empty() ? usual : std::max(least, of_median * median(thirds) / std::sqrt(20.0));
}

/// What a fit knows in the end.
struct Learnt {
  Common common;
  Shots shots{};
  std::vector<Fittable> bounds{};
  std::vector<HeldCoefficient> held{};
  double sigma = 0;  ///< m
};

std::vector<std::vector<Vec2d>> misses(const Seen& seen, const Common& common) {
  return planning::misses(seen, common.names, common.values.data(), common.base);
}

/// A sample that lies apart from its neighbours, and farther than these from each other: what a camera sees wrong for a
/// moment, not what a law gets wrong.
void mark_outliers(Seen& seen, const Common& common, double sigma) {
  constexpr std::size_t around = 3;
  const auto off = misses(seen, common);
  for (std::size_t k = 0; k < off.size(); ++k)
    for (std::size_t i = 0; i < off[k].size(); ++i) {
      std::vector<double> xs, ys, sizes;
      const std::size_t from = i < around ? 0 : i - around, to = std::min(off[k].size(), i + around + 1);
      for (std::size_t j = from; j < to; ++j)
        if (j != i) xs.push_back(off[k][j].x), ys.push_back(off[k][j].y);
      const Vec2d middle{median(xs), median(ys)};
      for (std::size_t j = from; j < to; ++j)
        if (j != i) sizes.push_back(norm(off[k][j] - middle));
      seen.outlier[k][i] = norm(off[k][i] - middle) > outlier * std::max(sigma, median(sizes));
    }
}

/// The same before anything is fitted: a sample that neither those before it, nor those after it, nor both lead to.
void mark_apart(Seen& seen, double sigma) {
  constexpr double bends = 20;  // m/s², more than any cloth does
  for (std::size_t k = 0; k < seen.outlier.size(); ++k) {
    const std::vector<Sample>& s = seen.recording.tracks[k].samples;
    const auto leads = [&](std::size_t a, std::size_t b, std::size_t to) {
      const double share = (s[to].time - s[a].time) / (s[b].time - s[a].time), far = s[to].time - s[b].time;
      const Vec2d at = s[a].at + (s[b].at - s[a].at) * share;
      const double errs = sigma * std::sqrt(1 + share * share + (1 - share) * (1 - share));
      return norm(s[to].at - at) < outlier * errs + bends * far * far;
    };
    for (std::size_t i = 0; i < s.size(); ++i) {
      const auto fits = [&](std::size_t a, std::size_t b) { return a < s.size() && b < s.size() && leads(a, b, i); };
      const bool any = fits(i - 1, i + 1) || fits(i - 2, i - 1) || fits(i + 1, i + 2) || fits(i - 3, i - 1) ||
                       fits(i + 1, i + 3) || fits(i - 2, i + 1) || fits(i - 1, i + 2);
      seen.outlier[k][i] = s.size() > 6 && !any;
    }
  }
}

/// Where the laws cannot follow the shots, samples err by what half of them are off; all alike, for a shot that is hard
/// to follow tells the most of the laws. Returns whether that is so.
bool weigh(Learnt& l) {
  std::vector<double> sizes;
  for (const Seen& seen : l.shots)
    for (const auto& track : misses(seen, l.common))
      for (const Vec2d& d : track) sizes.push_back(std::abs(d.x)), sizes.push_back(std::abs(d.y));
  const double off = of_median * median(sizes);
  constexpr double clearly = 1.5;
  for (Seen& seen : l.shots) {
    const double noise = seen.recording.sigma.value_or(l.sigma);
    seen.sigma = off > clearly * noise ? off : noise;
  }
  return off > clearly * l.sigma;
}

/// The direction that the shots tell least of, while that is less than a guess would: its largest part is held.
bool hold_one(Learnt& l) {
  Common& c = l.common;
  if (c.names.empty()) return false;
  Eigen::MatrixXd told = information(l.shots, c);
  const auto m = told.rows();
  const auto guess = [&](Eigen::Index k) {
    return std::ranges::find(l.bounds, c.names[static_cast<std::size_t>(k)], &Fittable::name)->guess;
  };
  for (Eigen::Index i = 0; i < m; ++i)
    for (Eigen::Index j = 0; j < m; ++j) told(i, j) *= guess(i) * guess(j);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(told);
  if (solver.eigenvalues()(0) >= 1) return false;
  const Eigen::VectorXd v = solver.eigenvectors().col(0).cwiseAbs();
  Eigen::Index worst = 0;
  v.maxCoeff(&worst);
  HeldCoefficient held{c.names[static_cast<std::size_t>(worst)], 0};
  held.value = std::ranges::find(l.bounds, held.name, &Fittable::name)->start;
  constexpr double shares = 0.3;
  for (Eigen::Index k = 0; k < m; ++k)
    if (k != worst && v(k) > shares * v(worst)) held.like.push_back(c.names[static_cast<std::size_t>(k)]);
  c.names.erase(c.names.begin() + worst);
  c.values.erase(c.values.begin() + worst);
  l.held.push_back(held);
  return true;
}

/// Those that are far worse than the others would lead the coefficients astray.
void leave_out_lost(Shots& shots, const Common& common) {
  std::vector<double> spreads;
  for (const Seen& seen : shots) spreads.push_back(spread(seen, common));
  const double most = lost * std::max(good, median(spreads));
  auto own = spreads.begin();
  std::size_t out = 0;
  for (Seen& seen : shots) out += seen.left_out = *own++ > most || (seen.robust == 0 && is_off(seen, common));
  if (2 * out <= shots.size()) return;
  for (Seen& seen : shots) seen.left_out = false;  // no half of the shots is wrong: the coefficients are
}

/// Launches and coefficients together, until no launch that does not fit well is replaced by a better one.
void settle(Learnt& l, int threads, Work& work) {
  constexpr int rounds = 3;
  for (int round = 0; round < rounds; ++round) {
    leave_out_lost(l.shots, l.common);
    solve_joint(l.shots, l.common, l.bounds, work);
    std::atomic<int> changed = 0;
    each_shot(
        l.shots, threads,
        [&](Seen& seen, Work& its) {
          if (look_again(seen, l.common, its)) ++changed;
          tell(seen, l.common, its);
        },
        work);
    weigh(l);
    if (changed == 0) break;
  }
}

/// How a coefficient depends on speed is asked when the rest is nearly known.
bool is_fine(const std::string& name) { return name.ends_with(".per_speed") || name.ends_with(".per_speed2"); }

/// Sum of squares in sigmas over the shots that teach.
double cost_of(const Learnt& l) {
  double sum = 0;
  for (const Seen& seen : l.shots) {
    const double e = excess(seen, l.common);
    sum += e * e * seen.samples_used();
  }
  return sum;
}

/// Paths have kinks, at which all may stop on the way: set off again from near by, and keep what is better.
void shake(Learnt& l, int threads, Work& work) {
  constexpr int tries = 8, most_in_vain = 2;
  constexpr double way = 6;  // standard errors
  Random random(1);
  for (int i = 0, in_vain = 0; i < tries && in_vain < most_in_vain; ++i) {
    const Eigen::MatrixXd errors = covariance(l.shots, l.common);
    if (errors.size() == 0) return;
    const Common before = l.common;
    std::vector<std::pair<LaunchUnknowns, std::vector<Told>>> launches;
    for (const Seen& seen : l.shots) launches.emplace_back(seen.launch, seen.told);
    const double cost = cost_of(l);
    for (std::size_t k = 0; k < l.common.values.size(); ++k) {
      const auto j = static_cast<Eigen::Index>(k);
      const auto bound = std::ranges::find(l.bounds, l.common.names[k], &Fittable::name);
      l.common.values[k] =
          std::clamp(l.common.values[k] + random.uniform(-way, way) * std::sqrt(errors(j, j)), bound->low, bound->high);
    }
    each_shot(
        l.shots, threads, [&](Seen& seen, Work& its) { look_again(seen, l.common, its); }, work);
    leave_out_lost(l.shots, l.common);
    solve_joint(l.shots, l.common, l.bounds, work);
    each_shot(
        l.shots, threads, [&](Seen& seen, Work& its) { look_again(seen, l.common, its); }, work);
    leave_out_lost(l.shots, l.common);
    solve_joint(l.shots, l.common, l.bounds, work);
    constexpr double gain = 1;
    const double after = cost_of(l);
    in_vain = after < cost - gain ? 0 : in_vain + 1;
    if (after < cost) continue;
    l.common = before;
    auto was = launches.begin();
    for (Seen& seen : l.shots) std::tie(seen.launch, seen.told) = *was++;
  }
  leave_out_lost(l.shots, l.common);
}

void set_robust(Shots& shots, double k) {
  for (Seen& seen : shots) seen.robust = k;
}

Learnt learn(const Recordings& recordings, const Physics& base, const std::vector<std::string>& names,
             double given_sigma, int threads, Work& work, const std::function<void(double)>& progress) {
  const bool balls = std::ranges::any_of(recordings, [](const Recording* r) { return !r->scene.others.empty(); });
  Learnt l{.common = {base, {}, {}}};
  l.bounds = coefficients_of(base, recordings.front()->scene.ball.body, balls);
  const auto add = [&](bool fine) {
    for (const std::string& name : names)
      if (is_fine(name) == fine) {
        l.common.names.push_back(name);
        l.common.values.push_back(std::ranges::find(l.bounds, name, &Fittable::name)->start);
      }
  };
  add(false);
  l.sigma = given_sigma > 0 ? given_sigma : noise_of(recordings);
  for (const Recording* r : recordings) {
    Seen& seen = l.shots.emplace_back(*r);
    seen.sigma = seen.sigma_at = r->sigma.value_or(l.sigma);
    mark_apart(seen, seen.sigma);
    seen.masse_spread = first_masse;
  }
  set_robust(l.shots, robust);
  // From bounce to bounce: the coefficients are learnt where launches are sure before they are asked where a long path
  // leads.
  each_shot(
      l.shots, threads, [&](Seen& seen, Work& its) { fit_first_part(seen, l.common, its); }, work);
  for (std::atomic<bool> more = true; more;) {
    leave_out_lost(l.shots, l.common);
    solve_joint(l.shots, l.common, l.bounds, work);
    more = false;
    each_shot(
        l.shots, threads,
        [&](Seen& seen, Work& its) {
          look_again(seen, l.common, its);
          if (!fit_farther(seen, l.common, its)) return;
          look_again(seen, l.common, its);
          more = true;
        },
        work);
  }
  progress(0.5);
  weigh(l);
  settle(l, threads, work);
  if (std::ranges::any_of(names, is_fine)) {
    add(true);
    settle(l, threads, work);
  }
  progress(0.7);
  while (hold_one(l)) solve_joint(l.shots, l.common, l.bounds, work);
  bool astray = weigh(l);
  if (astray) {
    shake(l, threads, work);
    astray = weigh(l);
  }
  for (Seen& seen : l.shots) seen.masse_spread = spread_of_masse;
  for (Seen& seen : l.shots) mark_outliers(seen, l.common, seen.recording.sigma.value_or(l.sigma));
  set_robust(l.shots, astray ? robust : 0);
  settle(l, threads, work);
  if (!astray) shake(l, threads, work);
  progress(0.9);
  return l;
}

/// Of those that count.
void measure(const Seen& seen, const Common& common, FittedShot& out) {
  double sum = 0;
  const auto off = misses(seen, common);
  for (std::size_t k = 0; k < off.size(); ++k)
    for (std::size_t i = 0; i < off[k].size(); ++i) {
      out.distances.push_back(norm(off[k][i]));
      const double since = seen.recording.tracks[k].samples[i].time - seen.launch[start_time];
      if (since > seen.told[k].until) {
        ++out.unexplained;
      } else if (seen.outlier[k][i]) {
        ++out.outliers;
      } else {
        ++out.samples;
        sum += dot(off[k][i], off[k][i]);
      }
    }
  if (out.samples > 0) out.rms = std::sqrt(sum / out.samples);
}

FittedShot fitted_shot(const Seen& seen, const Common& common) {
  const ShotRequest shot = with_launch(seen.recording.scene, seen.launch);
  FittedShot out{
      .id = shot.id, .start = seen.launch[start_time], .at = shot.ball.at, .launch = shot.launch, .spin = shot.spin};
  measure(seen, common, out);
  ShotRequest played = shot;
  played.physics = common.physics();
  played.until.time = std::max(0.0, seen.last - out.start);
  try {
    out.cushions = simulate(played).cushions;
  } catch (const InvalidInput&) {
  }
  return out;
}

Prediction predict(const Recording& recording, const Common& common, double sigma, Work& work) {
  Recording unseen = recording;  // what it met later is not known beforehand
  unseen.cushions.reset();
  Seen seen(unseen);
  seen.sigma = seen.sigma_at = recording.sigma.value_or(sigma);
  seen.robust = robust;
  seen.masse_spread = first_masse;
  mark_apart(seen, seen.sigma);
  Prediction out{recording.scene.id, 0, 0};
  if (!(fit_first_part(seen, common, work) < forever)) return out;
  const double from = seen.window;
  seen.window = forever;
  tell(seen, common, work);
  mark_outliers(seen, common, seen.sigma);
  const auto off = misses(seen, common);
  double sum = 0;
  for (std::size_t k = 0; k < off.size(); ++k)
    for (std::size_t i = 0; i < off[k].size(); ++i)
      if (unseen.tracks[k].samples[i].time > from && !seen.outlier[k][i])
        sum += dot(off[k][i], off[k][i]), ++out.samples;
  if (out.samples > 0) out.rms = std::sqrt(sum / out.samples);
  return out;
}

/// Restitution that depends on speed as asked; a slope of exactly 0 would be none.
Restitution bounce_of(Restitution e, FitWish::Bounce bounce) {
  constexpr double slope = 1e-4;
  if (bounce == FitWish::Bounce::as_given) return e;
  if (bounce == FitWish::Bounce::constant) return {e(1.0)};
  if (e.per_speed == 0) e.per_speed = -slope;
  if (bounce == FitWish::Bounce::linear) return {e.at_rest, e.per_speed};
  if (e.per_speed2 == 0) e.per_speed2 = -slope;
  return e;
}

Physics with_model(Physics p, const std::string& model, FitWish::Bounce bounce) {
  const Restitution e = bounce_of(restitution(p), bounce);
  if (!carries_spin(p)) return p;
  double height = spin_physics().cushion.index() == 1 ? std::get<Han2005>(spin_physics().cushion).height : 0;
  double friction = Han2005{}.friction;
  std::visit(
      [&](const auto& c) {
        if constexpr (requires { c.height; }) height = c.height, friction = c.friction;
      },
      p.cushion);
  if (model == "mirror") p.cushion = Mirror{e};
  if (model == "han2005") p.cushion = Han2005{height, e, friction};
  if (model == "stronge") p.cushion = Stronge{height, e, friction};
  if (model == "mathavan2010")
    p.cushion = Mathavan2010{.height = height,
                             .restitution = e,
                             .friction = friction,
                             .sliding_friction = std::get<SlideRoll>(p.motion).sliding_friction};
  if (model.empty())
    std::visit(
        [&](auto& c) {
          if constexpr (requires { c.restitution; }) c.restitution = e;
        },
        p.cushion);
  return p;
}

std::string name_of(const Physics& p) {
  constexpr const char* names[] = {"mirror", "han2005", "mathavan2010", "stronge", "custom"};
  const Restitution& e = restitution(p);
  return std::string(names[p.cushion.index()]) + (e.constant()        ? ""
                                                  : e.per_speed2 != 0 ? ", restitution by speed squared"
                                                                      : ", restitution by speed");
}

std::vector<std::string> names_asked(const Physics& physics, const Body& body, bool balls, const FitWish& wish) {
  std::vector<std::string> out;
  for (const Fittable& f : coefficients_of(physics, body, balls)) {
    const bool table = !f.name.starts_with("tilt") && !f.name.starts_with("camera");
    const auto asked = [&](const std::string& name) {
      return f.name == name || f.name.starts_with(name + ".") || (name == "tilt" && f.name.starts_with("tilt."));
    };
    if (wish.free.empty() ? table : std::ranges::any_of(wish.free, asked)) out.push_back(f.name);
  }
  for (const std::string& name : wish.free)
    if (name != "launch" &&
        std::ranges::none_of(out, [&](const std::string& o) { return o == name || o.starts_with(name + "."); }))
      throw InvalidInput("", "\"" + name + "\" is nothing that this physics lets a fit move");
  return out;
}

/// Each left out once, in groups: how the fit of the others predicts them.
std::vector<Prediction> held_out(const Recordings& all, const Physics& base, const std::vector<std::string>& names,
                                 double sigma, int group, int threads, Work& work) {
  std::vector<Prediction> out;
  const auto size = static_cast<std::size_t>(group);
  for (std::size_t from = 0; from < all.size(); from += size) {
    Recordings others, left;
    for (std::size_t i = 0; i < all.size(); ++i) (i >= from && i < from + size ? left : others).push_back(all[i]);
    if (others.empty()) break;
    const Learnt l = learn(others, base, names, sigma, threads, work, [](double) {});
    for (const Recording* r : left) out.push_back(predict(*r, l.common, l.sigma, work));
  }
  return out;
}

double median_rms(const std::vector<Prediction>& predictions) {
  std::vector<double> v;
  for (const Prediction& p : predictions)
    if (p.samples > 0) v.push_back(p.rms);
  return median(v);
}

}  // namespace
}  // namespace planning

std::vector<std::string> fit_names(const Physics& physics) {
  std::vector<std::string> out;
  for (const auto& f : planning::coefficients_of(physics, Body{}, true)) out.push_back(f.name);
  return out;
}

Fit fit(std::span<const Recording> recordings, const FitWish& wish) {
  using namespace planning;
  if (recordings.empty()) throw InvalidInput("", "there is no recording to fit");
  Recordings all;
  for (const Recording& r : recordings) all.push_back(&r);
  const Physics& given = recordings.front().scene.physics;
  const Body& body = recordings.front().scene.ball.body;
  for (const Recording& r : recordings)
    if (r.scene.physics.motion.index() != given.motion.index())
      throw InvalidInput("/physics", "is of another model than the first recording's: one fit has one");
  const bool balls = std::ranges::any_of(recordings, [](const Recording& r) { return !r.scene.others.empty(); });
  const int threads = std::max(1, wish.threads);
  const auto progress = [&](double share) {
    if (wish.progress) wish.progress(share);
  };
  Fit out;
  Work work;
  Physics base = with_model(given, wish.model == "any" ? "" : wish.model, wish.bounce);
  if (wish.model == "any") {
    double best = forever;
    const int group = wish.holdout > 0 ? wish.holdout : std::max(1, static_cast<int>(all.size()) / 4);
    const char* const models[] = {"han2005", "mathavan2010", "stronge"};
    for (std::size_t i = 0; i < std::size(models) * 2; ++i) {
      const Physics p = with_model(given, models[i / 2], i % 2 ? FitWish::Bounce::linear : FitWish::Bounce::constant);
      const auto names = names_asked(p, body, balls, wish);
      const Learnt l = learn(all, p, names, 0, threads, work, [](double) {});
      std::vector<double> rms;
      for (const Seen& seen : l.shots) rms.push_back(fitted_shot(seen, l.common).rms);
      const double predicted = median_rms(held_out(all, p, names, 0, group, threads, work));
      out.models.push_back({name_of(p), median(rms), predicted});
      if (predicted < best) best = predicted, base = p;
      progress(0.8 * static_cast<double>(i + 1) / 6);
    }
  }
  const std::vector<std::string> names = names_asked(base, body, balls, wish);
  Learnt l = learn(all, base, names, 0, threads, work, progress);
  const Eigen::MatrixXd unit = covariance(l.shots, l.common);

  // Errors are in the units of what is left over.
  double sum = 0;
  long rows = -static_cast<long>(l.common.names.size());
  std::vector<double> noise;
  for (const Seen& seen : l.shots) {
    const FittedShot shot = fitted_shot(seen, l.common);
    sum += 2 * shot.samples * (shot.rms * shot.rms / 2) / (seen.sigma * seen.sigma);
    rows += 2 * shot.samples - launch_size;
    out.shots.push_back(shot);
    noise.push_back(seen.sigma);
  }
  const double excess = rows > 0 ? sum / static_cast<double>(rows) : 1;
  out.sigma = l.sigma * std::sqrt(excess);
  out.physics = l.common.physics();
  const auto m = static_cast<Eigen::Index>(l.common.names.size());
  std::vector<Eigen::Index> of_physics;  // tilt and camera are none of it
  for (Eigen::Index i = 0; i < m; ++i) {
    const auto k = static_cast<std::size_t>(i);
    FittedCoefficient& p = out.parameters.emplace_back(FittedCoefficient{l.common.names[k], l.common.values[k], 0});
    if (unit.size() == 0) continue;
    p.error = std::sqrt(unit(i, i) * excess);
    for (Eigen::Index j = 0; j < m; ++j) {
      out.covariance.push_back(unit(i, j) * excess);
      constexpr double close = 0.9;
      if (j != i && std::abs(unit(i, j)) > close * std::sqrt(unit(i, i) * unit(j, j)))
        p.correlated_with.push_back(l.common.names[static_cast<std::size_t>(j)]);
    }
    if (!p.name.starts_with("camera") && !p.name.starts_with("tilt")) of_physics.push_back(i);
    if (p.name == "camera.scale") out.camera_scale = p.value;
    if (p.name == "camera.x") out.camera_offset.x = p.value;
    if (p.name == "camera.y") out.camera_offset.y = p.value;
  }
  if (unit.size() > 0) {
    CoefficientErrors& errors = out.physics.errors.emplace();
    for (const Eigen::Index i : of_physics) {
      errors.names.push_back(l.common.names[static_cast<std::size_t>(i)]);
      for (const Eigen::Index j : of_physics) errors.covariance.push_back((unit(i, j) + unit(j, i)) / 2 * excess);
    }
  }
  out.held = l.held;
  if (wish.holdout > 0)
    out.predictions = held_out(all, base, names, 0, wish.holdout, threads, work);
  else if (wish.predict)
    for (const Recording* r : all) out.predictions.push_back(predict(*r, l.common, l.sigma, work));
  out.simulations = work.simulations;
  out.restarts = work.restarts;
  progress(1);
  return out;
}

}  // namespace bankshot
