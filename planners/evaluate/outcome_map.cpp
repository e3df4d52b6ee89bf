// SPDX-License-Identifier: MIT
#include "planners/evaluate/outcome_map.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <span>

#include "bankshot/numbers/tolerances.hpp"
#include "planners/evaluate/noise_scanlines.hpp"
#include "planners/evaluate/room.hpp"
#include "planners/evaluate/settings.hpp"
#include "planners/verify/bounds.hpp"
#include "planners/verify/goal.hpp"
#include "planners/verify/replay.hpp"

namespace bankshot::planning {

using namespace settings::outcome_map;

namespace {

/// Rungs of the lattice of speeds in a coarse step, so many that it can be halved that often.
constexpr int rungs = 1 << most_halvings;
/// Step of the origin of aims [rad]: a half turn divided by a power of two.
constexpr double origin_step = std::numbers::pi / 64;

/// Returns the largest step that divides a half turn by a power of two and is at most `most` [rad].
double lattice_step(double most) {
  return std::ldexp(std::numbers::pi, -static_cast<int>(std::ceil(std::log2(std::numbers::pi / most))));
}

/// Returns the launch speed of a rung [m/s]: `rungs` of them make one coarse step.
double speed_of(int rung) { return std::pow(coarse, static_cast<double>(rung) / rungs); }

double rungs_of(double speed) { return std::log(speed) / std::log(coarse) * rungs; }

/// Returns the last of every `stride` rungs that is no faster.
int rung_below(double speed, int stride) { return static_cast<int>(std::floor(rungs_of(speed) / stride)) * stride; }

/// Returns where f is largest, by golden sections; where its values are alike, the middle.
template <class F>
double largest(double low, double high, double enough, const F& f) {
  constexpr double golden = 0.6180339887498949;
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double fa = f(a), fb = f(b);
  while (high - low > enough && std::abs(fa - fb) >= settings::alike) {
    if (fa < fb) {
      low = a, a = b, fa = fb;
      fb = f(b = low + golden * (high - low));
    } else {
      high = b, b = a, fb = fa;
      fa = f(a = high - golden * (high - low));
    }
  }
  return (low + high) / 2;
}

class OutcomeMap {
 public:
  /// `request` has the spin of the shot, which must outlive this.
  OutcomeMap(const SearchRequest& request, EvaluationBudget& budget, const Shot& shot)
      : request_(request),
        budget_(budget),
        shot_(shot),
        goal_(Goal::counted(request, shot)),
        angle_(std::max(request.puzzle().noise.angle, tolerance::same_aim)),
        origin_(std::round(shot.launch.angle / origin_step) * origin_step),
        own_(angle_difference(origin_, shot.launch.angle)),
        one_speed_(is_ideal(request.puzzle().physics) || request.pinned || request.puzzle().prefer != Prefer::robust) {
    double low = -angle_, high = angle_;
    if (const double by_aim = norm(shot.verification.by_angle); by_aim > 0) {
      const Gap<double> room = room_beside(request, shot, shot.verification.by_angle / by_aim);
      // If the aim hardly moves the arrival, no more aims are tried than the player's errors reach.
      const double widest = std::min(far * angle_, radians(180));
      low = std::clamp(room.low / by_aim, -widest, widest), high = std::clamp(room.high / by_aim, -widest, widest);
    }
    first_ = {own_ + low, own_ + high};
    rows_.push_back(row_at(shot.launch.speed, first_));
  }

  std::vector<LikelyLaunch> best(double worth) {
    if (is_ideal(request_.puzzle().physics)) return best_so_far();
    if (!one_speed_) look_along();
    std::vector<LikelyLaunch> best = best_so_far();
    if (!best.empty() && best.front().value < worth - hope) return {};
    // A narrow peak may stand where the shot is.
    refine(shot_.launch.speed);
    if (one_speed_) return best_so_far();
    // The row of the shot's own speed is dropped, so that the lattice is the same for every shot nearby. It stays if
    // the puzzle gives an arrival speed, which is known on rows alone.
    const auto is_own = [&](const Row& row) { return row.speed == shot_.launch.speed; };
    const auto leads_on = [&](const Row& row) { return row.made() && !is_own(row); };
    if (!request_.puzzle().arrive && std::ranges::any_of(rows_, leads_on)) {
      std::erase_if(rows_, is_own);
      for (Row& row : rows_) row.best.reset();
    }
    best = best_so_far();
    while (!best.empty() && (refine(best.front().launch.speed) || refine_changes(best.front().launch)))
      best = best_so_far();
    if (best.empty()) return best;
    const double best_speed = best.front().launch.speed;
    const auto beyond = std::ranges::upper_bound(rows_, best_speed, {}, &Row::speed);
    const auto from = std::ranges::lower_bound(rows_, best_speed, {}, &Row::speed);
    const double slower = from == rows_.begin() ? best_speed : std::prev(from)->speed;
    const double faster = beyond == rows_.end() ? best_speed : beyond->speed;
    const double low = std::max(slower, request_.speed.low), high = std::min(faster, request_.speed.high);
    const double speed = largest(low, high, finest * deviation(low), [&](double v) { return best_at(v).value; });
    if (const LikelyLaunch peak = best_at(speed); peak.value > best.front().value) best.insert(best.begin(), peak);
    return best;
  }

 private:
  /// An interval of aims that are made [rad beside `origin_`].
  struct Band {
    double low, high;
    double width() const { return high - low; }
    double middle() const { return (low + high) / 2; }
  };
  /// A launch that is made.
  struct Seen {
    double aim;     ///< rad beside `origin_`
    int contacts;   ///< cushions and jaws that its balls meet
    bool as_asked;  ///< it arrives at a speed that the puzzle gives, and the object ball keeps to its cushions
  };
  /// The launches of one speed.
  struct Row {
    double speed;                        ///< m/s
    std::vector<Band> bands{};           ///< intervals that are made, in order
    std::vector<Seen> seen{};            ///< in order
    std::optional<LikelyLaunch> best{};  ///< its best launch, until a row is added that changes it
    bool made() const { return !bands.empty(); }
    const Band& widest() const { return *std::ranges::max_element(bands, {}, &Band::width); }
  };

  /// A row, and how much the success of an aim at its speed counts at another speed.
  struct Weight {
    const Row* row;
    double share;
  };

  /// A place on the lattice of launch speeds.
  using Rung = int;

  Launch launch(double aim, double speed) const { return {speed, wrap_angle(origin_ + aim)}; }

  double deviation(double speed) const {
    return std::max(request_.puzzle().noise.speed_at(speed), least_deviation * speed);
  }

  /// Returns whether a launch is made. The row of its speed keeps what it meets.
  bool is_made(double aim, Row& row) {
    if (!(row.speed > 0) || budget_.spent()) return false;
    const Replay r = replay(request_, budget_, launch(aim, row.speed), goal_);
    if (!r.made) return false;
    const auto at = std::ranges::lower_bound(row.seen, aim, {}, &Seen::aim);
    const auto& arrive = request_.puzzle().arrive;
    const bool as_asked =
        (!arrive || arrive->contains(r.path.arrival.speed)) && request_.problem->keeps_cushions(r.path.then);
    row.seen.insert(at, {aim, r.path.contacts(), as_asked});
    return true;
  }

  Row row_at(double speed, const Band& expected) {
    Row row{speed};
    const double width = std::max(expected.width(), tolerance::same_aim);
    const double beside = std::clamp(width / 2, least_beside * angle_, most_beside * angle_);
    const double step = lattice_step((width + 2 * beside) / aims);
    const double exact = lattice_step(finest * std::min(angle_, width));
    struct Try {
      double aim;
      bool made;
    };
    std::vector<Try> tries;
    const auto look = [&](double aim) { return Try{aim, is_made(aim, row)}; };
    const long first = std::lround(std::floor((expected.low - beside) / step));
    const long last = std::lround(std::ceil((expected.high + beside) / step));
    for (long k = first; k <= last; ++k) tries.push_back(look(static_cast<double>(k) * step));
    // A shot is made as it is launched, wherever the middle of its target may be.
    if (rows_.empty() && std::ranges::none_of(tries, &Try::made))
      tries.insert(std::ranges::upper_bound(tries, own_, {}, &Try::aim), look(own_));
    if (std::ranges::none_of(tries, &Try::made)) return row;
    const double farthest = far * angle_, farther = std::exp2(std::ceil(std::log2(beside / step))) * step;
    while (tries.front().made && expected.middle() - tries.front().aim < farthest)
      tries.insert(tries.begin(), look(tries.front().aim - farther));
    while (tries.back().made && tries.back().aim - expected.middle() < farthest)
      tries.push_back(look(tries.back().aim + farther));
    if (tries.front().made) row.bands.push_back({tries.front().aim, 0});
    for (std::size_t i = 0; i + 1 < tries.size(); ++i) {
      if (tries[i].made == tries[i + 1].made) continue;
      double in = tries[i].aim, out = tries[i + 1].aim;
      while (out - in > 1.5 * exact && !budget_.spent()) {
        const double middle = (in + out) / 2;
        if (!(in < middle && middle < out)) break;
        (is_made(middle, row) == tries[i].made ? in : out) = middle;
      }
      if (tries[i].made)
        row.bands.back().high = (in + out) / 2;
      else
        row.bands.push_back({(in + out) / 2, 0});
    }
    if (tries.back().made) row.bands.back().high = tries.back().aim;
    return row;
  }

  /// Returns the made aims to expect at a speed: the widest intervals of the speeds around it, interpolated.
  Band expected_at(double speed) const {
    if (std::ranges::none_of(rows_, &Row::made)) return first_;  // the cue ball may fall at the speed of the shot alone
    const auto after = std::ranges::find_if(rows_, [&](const Row& r) { return r.made() && r.speed > speed; });
    const auto is_before = [&](const Row& r) { return r.made() && r.speed < speed; };
    const auto before = std::find_if(rows_.rbegin(), rows_.rend(), is_before);
    const auto beyond = [&](const Row& near, const Row& other) {
      const double share = (speed - near.speed) / (other.speed - near.speed);
      const Band &a = near.widest(), &b = other.widest();
      const Band out{std::lerp(a.low, b.low, share), std::lerp(a.high, b.high, share)};
      return out.low < out.high ? out : a;
    };
    if (before != rows_.rend() && after != rows_.end()) return beyond(*before, *after);
    // Speeds that are nearer to each other than to this one do not tell how the interval moves.
    const auto extended = [&](const Row& near, auto from, auto end) {
      const auto tells = [&](const Row& r) {
        return r.made() && std::abs(r.speed - near.speed) >= std::abs(speed - near.speed) / 2;
      };
      const auto next = std::find_if(from, end, tells);
      return next == end ? near.widest() : beyond(near, *next);
    };
    if (before != rows_.rend()) return extended(*before, before + 1, rows_.rend());
    return extended(*after, after + 1, rows_.end());
  }

  /// Adds the row of a speed. Returns false if it is there, or there are rows enough.
  bool add(Rung rung) {
    const double speed = speed_of(rung);
    const auto at = std::ranges::lower_bound(rows_, speed, {}, &Row::speed);
    if ((at != rows_.end() && at->speed == speed) || rows_.size() >= most_rows || budget_.spent()) return false;
    Row row = row_at(speed, expected_at(speed));
    const auto added = rows_.insert(at, std::move(row));
    const double from = added == rows_.begin() ? -infinite : std::prev(added)->speed;
    const double to = std::next(added) == rows_.end() ? infinite : std::next(added)->speed;
    for (Row& other : rows_)
      if (const double reach = far * deviation(other.speed); other.speed + reach > from && other.speed - reach < to)
        other.best.reset();
    return true;
  }

  /// Looks at speeds in coarse steps from the shot outwards, as far as some aim is made. It goes at most one step
  /// beyond the allowed speeds, since a player's errors reach there.
  void look_along() {
    const Rung below = rung_below(shot_.launch.speed, rungs);
    for (const int way : {-1, 1}) {
      int missed = 0;
      for (Rung at = way < 0 ? below : below + rungs; missed < most_missed; at += way * rungs) {
        const double speed = speed_of(at);
        if (!add(at) || !request_.speed.contains(speed)) break;
        const Row& row = *std::ranges::lower_bound(rows_, speed, {}, &Row::speed);
        missed = row.made() ? 0 : missed + 1;
      }
    }
  }

  /// Adds speeds around one, as near to each other as the player's errors of speed need; returns false if none is new.
  bool refine(double speed) {
    const double step =
        std::log(coarse) * speed / (apart * deviation(speed));  // coarse steps are so many times too wide
    const Rung stride = rungs >> std::clamp(static_cast<int>(std::ceil(std::log2(step))), 0, most_halvings);
    const Rung below = rung_below(speed, stride);
    bool any = false;
    for (int k = 0; k < around; ++k)
      for (const Rung at : {below - k * stride, below + (k + 1) * stride}) any = add(at) || any;
    return any;
  }

  double success_at(double aim, const Row& row) const {
    double sum = 0;
    for (const Band& band : row.bands)
      sum += normal_below((band.high - aim) / angle_) - normal_below((band.low - aim) / angle_);
    return sum;
  }

  /// Returns what makes the success of a launch at a speed out of that of its aim on each row. Between two rows it
  /// changes evenly, and the normal errors of speed weigh it; beyond the last rows nothing is made.
  std::vector<Weight> weights_at(double speed) const {
    if (rows_.size() == 1) return {{&rows_.front(), 1}};
    const auto density = [](double z) { return std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi); };
    const double by = deviation(speed);
    std::vector<Weight> out;
    const auto add = [&](const Row& row, double share) {
      if (!row.made()) return;
      if (out.empty() || out.back().row != &row) out.push_back({&row, 0});
      out.back().share += share;
    };
    for (std::size_t i = 0; i + 1 < rows_.size(); ++i) {
      const Row &a = rows_[i], &b = rows_[i + 1];
      const double low = (a.speed - speed) / by, high = (b.speed - speed) / by;
      if (high < -far || low > far || !(a.made() || b.made())) continue;
      const double both = normal_below(high) - normal_below(low);
      const double share = (density(low) - density(high) - low * both) / (high - low);
      add(a, both - share);
      add(b, share);
    }
    return out;
  }

  double success(double aim, std::span<const Weight> weights) const {
    double sum = 0;
    for (const Weight& w : weights) sum += w.share * success_at(aim, *w.row);
    return sum;
  }

  /// Adds a speed between two around a launch whose success differs by much, as where the ball begins to arrive.
  /// Returns false if there are none.
  bool refine_changes(const Launch& best) {
    const double aim = angle_difference(origin_, best.angle), by = deviation(best.speed);
    for (std::size_t i = 0; i + 1 < rows_.size(); ++i) {
      const Row &a = rows_[i], &b = rows_[i + 1];
      if (b.speed < best.speed - far * by || a.speed > best.speed + far * by) continue;
      const double change = std::abs(success_at(aim, a) - success_at(aim, b));
      const int low = static_cast<int>(std::lround(rungs_of(a.speed))),
                high = static_cast<int>(std::lround(rungs_of(b.speed)));
      if (change * (b.speed - a.speed) / by > uneven && add((low + high) / 2)) return true;
    }
    return false;
  }

  /// Returns a launch with its value. `row`: the speed whose launches meet and arrive as this one does. If that is not
  /// as asked, the value is below any.
  LikelyLaunch at(double aim, double speed, const Row& row, std::span<const Weight> weights) const {
    const Seen& like = *std::ranges::min_element(row.seen, {}, [&](const Seen& s) { return std::abs(s.aim - aim); });
    if (!like.as_asked) return {launch(aim, speed), -infinite};
    const double cost = cost_of({speed, aim}, shot_.spin) + cost_of_contacts(like.contacts);
    return {launch(aim, speed), success(aim, weights) - cost};
  }

  /// Returns the best aim inside its bounds, between the middles of the intervals at the speeds around.
  double safest_aim(double speed, std::span<const Weight> weights) const {
    const double near = 2 * deviation(speed);
    double low = infinite, high = -low;
    for (const Row& row : rows_)
      if (rows_.size() == 1 || std::abs(row.speed - speed) < near)
        for (const Band& band : row.bands) low = std::min(low, band.middle()), high = std::max(high, band.middle());
    if (low > high) low = high = own_;
    const double best = largest(low, high, finest * angle_, [&](double aim) { return success(aim, weights); });
    double aim = wrap_angle(origin_ + best);
    if (!request_.angle || inside_aims(aim, request_.angle)) return best;
    // The nearer end of the bounds.
    const double to_low = angle_difference(aim, request_.angle->low),
                 to_high = angle_difference(aim, request_.angle->high);
    return best + (std::abs(to_low) < std::abs(to_high) ? to_low : to_high);
  }

  /// Returns the best launch of a speed: the likeliest, or the one nearest to it among those that meet the least. If
  /// the likeliest is not as asked, it is the best of those that were tried and are.
  LikelyLaunch best_at(double speed) const {
    const auto distance = [&](const Row& r) { return r.made() ? std::abs(r.speed - speed) : infinite; };
    const Row& row = *std::ranges::min_element(rows_, {}, distance);
    const std::vector<Weight> weights = weights_at(speed);
    const double aim = safest_aim(speed, weights);
    LikelyLaunch best = at(aim, speed, row, weights);
    const auto try_it = [&](const Seen& s) {
      double angle = wrap_angle(origin_ + s.aim);
      if (!inside_aims(angle, request_.angle)) return;
      if (const LikelyLaunch other = at(s.aim, speed, row, weights); other.value > best.value) best = other;
    };
    if (best.value == -infinite) std::ranges::for_each(row.seen, try_it);
    const auto effort = [&](const Seen& s) { return std::pair(s.contacts, std::abs(s.aim - aim)); };
    try_it(*std::ranges::min_element(row.seen, {}, effort));
    return best;
  }

  std::vector<LikelyLaunch> best_so_far() {
    std::vector<LikelyLaunch> best;
    for (Row& row : rows_) {
      double speed = row.speed;
      if (std::ranges::none_of(row.seen, &Seen::as_asked)) continue;
      if (!row.made() || !bring_inside(speed, request_.speed)) continue;
      if (one_speed_ && row.speed != shot_.launch.speed) continue;
      if (!row.best) row.best = best_at(speed);
      if (row.best->value > -infinite) best.push_back(*row.best);
    }
    // Among launches that are alike the slowest comes first, whatever their last digits.
    std::ranges::stable_sort(best, std::greater(),
                             [](const LikelyLaunch& b) { return std::round(b.value / settings::alike); });
    return best;
  }

  const SearchRequest& request_;
  EvaluationBudget& budget_;
  const Shot& shot_;
  Goal goal_;
  double angle_;             ///< deviation of the aim [rad]
  double origin_;            ///< aim of the lattice that is nearest to the shot's [rad]
  double own_;               ///< the shot's aim, seen from there [rad]
  bool one_speed_;           ///< only the speed of the shot is allowed, or preferred
  Band first_{};             ///< the interval that the shot's derivatives expect
  std::vector<Row> rows_{};  ///< slowest first
};

}  // namespace

std::vector<LikelyLaunch> likely_launches(const SearchRequest& request, EvaluationBudget& budget, const Shot& shot,
                                          double worth) {
  return OutcomeMap(request, budget, shot).best(worth);
}

}  // namespace bankshot::planning
