// SPDX-License-Identifier: MIT
#include "planners/merit/outcome_map.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "bankshot/numbers/tolerances.hpp"
#include "planners/merit/lines_of_errors.hpp"
#include "planners/merit/room.hpp"
#include "planners/merit/settings.hpp"
#include "planners/proof/bounds.hpp"
#include "planners/proof/replay.hpp"

namespace bankshot::planning {

using namespace settings::outcome_map;

OutcomeMap::OutcomeMap(const Question& q, Ledger& ledger, const Shot& shot)
    : q_(q),
      ledger_(ledger),
      shot_(shot),
      goal_(Goal::counted(q, shot)),
      angle_(std::max(q.puzzle.noise.angle, tolerance::same_aim)) {
  double low = -angle_, high = angle_;
  if (const double by_aim = norm(shot.by_angle); by_aim > 0) {
    const Gap<double> room = room_beside(q, shot, shot.by_angle / by_aim);
    // Where the aim moves nothing to speak of, no more aims than the player's errors reach.
    const double widest = std::min(far * angle_, radians(180));
    low = std::clamp(room.low / by_aim, -widest, widest), high = std::clamp(room.high / by_aim, -widest, widest);
  }
  first_ = {low, high};
  rows_.push_back(row_at(shot.launch.speed, first_, aims));
}

double OutcomeMap::deviation(double speed) const {
  return std::max(q_.puzzle.noise.speed_at(speed), least_deviation * speed);
}

/// m/s, of a launch that is made.
std::optional<double> OutcomeMap::arrival_at(double aim, double speed) {
  if (!(speed > 0) || ledger_.spent()) return {};
  const Replay r = replay(q_, ledger_, {speed, wrap_angle(shot_.launch.angle + aim)}, goal_);
  return r.made ? std::optional(r.arrival.speed) : std::nullopt;
}

OutcomeMap::Row OutcomeMap::row_at(double speed, const Band& expected, int tried) {
  Row row{speed};
  const double width = std::max(expected.width(), tolerance::same_aim);
  const double beside = std::clamp(width / 2, least_beside * angle_, most_beside * angle_);
  const double first = expected.low - beside, step = (width + 2 * beside) / (tried - 1);
  struct Try {
    double aim;
    bool made;
  };
  std::vector<Try> tries;
  const auto look = [&](double aim) {
    const auto arrival = arrival_at(aim, speed);
    if (arrival) row.arrival = *arrival;
    return Try{aim, arrival.has_value()};
  };
  for (int k = 0; k < tried; ++k) tries.push_back(look(first + k * step));
  // A shot is made as it is launched, wherever the middle of its target may be.
  if (rows_.empty() && std::ranges::none_of(tries, &Try::made))
    tries.insert(std::ranges::upper_bound(tries, 0.0, {}, &Try::aim), look(0));
  if (std::ranges::none_of(tries, &Try::made)) return row;
  const double farthest = far * angle_;
  while (tries.front().made && expected.middle() - tries.front().aim < farthest)
    tries.insert(tries.begin(), look(tries.front().aim - beside));
  while (tries.back().made && tries.back().aim - expected.middle() < farthest)
    tries.push_back(look(tries.back().aim + beside));
  if (tries.front().made) row.bands.push_back({tries.front().aim, 0});
  for (std::size_t i = 0; i + 1 < tries.size(); ++i) {
    if (tries[i].made == tries[i + 1].made) continue;
    double in = tries[i].aim, out = tries[i + 1].aim;
    while (out - in > (tried == coarse_aims ? roughest : finest) * std::min(angle_, width) && !ledger_.spent()) {
      const double middle = (in + out) / 2;
      if (!(in < middle && middle < out)) break;
      (arrival_at(middle, speed).has_value() == tries[i].made ? in : out) = middle;
    }
    if (tries[i].made)
      row.bands.back().high = (in + out) / 2;
    else
      row.bands.push_back({(in + out) / 2, 0});
  }
  if (tries.back().made) row.bands.back().high = tries.back().aim;
  return row;
}

/// Where the rows around a speed have their widest bands.
OutcomeMap::Band OutcomeMap::expected_at(double speed) const {
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
  if (before != rows_.rend()) {
    const auto next = std::find_if(before + 1, rows_.rend(), is_before);
    return next == rows_.rend() ? before->widest() : beyond(*before, *next);
  }
  const auto next = std::find_if(after + 1, rows_.end(), [](const Row& r) { return r.made(); });
  return next == rows_.end() ? after->widest() : beyond(*after, *next);
}

/// False where there are rows enough.
bool OutcomeMap::add(double speed, int tried) {
  if (rows_.size() >= most_rows || ledger_.spent() || !(speed > 0)) return false;
  Row row = row_at(speed, expected_at(speed), tried);
  rows_.insert(std::ranges::upper_bound(rows_, speed, {}, &Row::speed), std::move(row));
  return true;
}

/// Rows from the shot outwards, as far as some aim is made, in few steps.
void OutcomeMap::look_along() {
  for (const double ratio : {1 / coarse, coarse}) {
    int missed = 0;
    for (double speed = shot_.launch.speed * ratio; q_.speed.contains(speed) && missed < most_missed; speed *= ratio) {
      if (!add(speed, coarse_aims)) return;
      const Row& row = ratio < 1 ? rows_.front() : rows_.back();
      missed = row.made() ? 0 : missed + 1;
    }
  }
}

/// A row where they are farther apart than the player's errors see, near the best one; false where there is none.
bool OutcomeMap::refine(double speed) {
  const double by = deviation(speed);
  for (const double way : {-1.0, 1.0}) {
    double at = speed;
    for (int k = 0; k < around; ++k) {
      const double next = at + way * apart * by;
      if (!(next > 0)) break;
      const auto known = [&](const Row& r) {
        return way * (r.speed - at) > 0 && way * (r.speed - next) <= 1e-9 * speed;
      };
      const auto row = std::ranges::find_if(rows_, known);
      if (row == rows_.end()) return add(next, aims);
      at = row->speed;
    }
  }
  return false;
}

double OutcomeMap::success_at(double aim, const Row& row) const {
  double sum = 0;
  for (const Band& band : row.bands)
    sum += normal_below((band.high - aim) / angle_) - normal_below((band.low - aim) / angle_);
  return sum;
}

/// Between rows it changes evenly with the speed, which the normal errors of speed weigh; beyond them nothing is made.
double OutcomeMap::success(double aim, double speed) const {
  if (rows_.size() == 1) return success_at(aim, rows_.front());
  const auto density = [](double z) { return std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi); };
  const double by = deviation(speed);
  double sum = 0;
  for (std::size_t i = 0; i + 1 < rows_.size(); ++i) {
    const Row &a = rows_[i], &b = rows_[i + 1];
    const double low = (a.speed - speed) / by, high = (b.speed - speed) / by;
    if (high < -far || low > far || !(a.made() || b.made())) continue;
    const double at_low = success_at(aim, a), slope = (success_at(aim, b) - at_low) / (high - low);
    sum += (at_low - slope * low) * (normal_below(high) - normal_below(low)) + slope * (density(low) - density(high));
  }
  return sum;
}

/// Golden sections between the middles of the rows around, inside the bounds of the aim.
double OutcomeMap::safest_aim(const Row& row) const {
  double low = row.widest().middle(), high = low;
  for (const Row& other : rows_)
    if (other.made() && std::abs(other.speed - row.speed) < 2 * deviation(row.speed))
      low = std::min(low, other.widest().middle()), high = std::max(high, other.widest().middle());
  for (const Band& band : row.bands) low = std::min(low, band.middle()), high = std::max(high, band.middle());
  constexpr double golden = 0.6180339887498949;
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double fa = success(a, row.speed), fb = success(b, row.speed);
  while (high - low > settled * angle_) {
    if (std::abs(fa - fb) < alike) {  // all of it is as good: its middle
      break;
    } else if (fa < fb) {
      low = a, a = b, fa = fb;
      fb = success(b = low + golden * (high - low), row.speed);
    } else {
      high = b, b = a, fb = fa;
      fa = success(a = high - golden * (high - low), row.speed);
    }
  }
  double aim = wrap_angle(shot_.launch.angle + (low + high) / 2);
  if (!q_.angle || inside_aims(aim, q_.angle)) return (low + high) / 2;
  // The nearer end of the bounds.
  const double to_low = angle_difference(aim, q_.angle->low), to_high = angle_difference(aim, q_.angle->high);
  return (low + high) / 2 + (std::abs(to_low) < std::abs(to_high) ? to_low : to_high);
}

/// It may be launched so fast, and arrives as asked.
bool OutcomeMap::allowed(const Row& row) const {
  const auto& arrive = q_.puzzle.arrive;
  double speed = row.speed;
  if (is_ideal(q_.puzzle.physics) || q_.pinned) return row.made() && row.speed == shot_.launch.speed;
  return row.made() && bring_inside(speed, q_.speed) && (!arrive || arrive->contains(row.arrival));
}

std::vector<OutcomeMap::Best> OutcomeMap::best_so_far() const {
  std::vector<Best> best;
  for (const Row& row : rows_) {
    if (!allowed(row)) continue;
    const double aim = safest_aim(row);
    best.push_back({{row.speed, wrap_angle(shot_.launch.angle + aim)},
                    success(aim, row.speed) - cost_of({row.speed, aim}, shot_.spin)});
  }
  // Of launches that are alike the slowest, whatever their last digits.
  std::ranges::stable_sort(best, std::greater(), [](const Best& b) { return std::round(b.value / alike); });
  return best;
}

double OutcomeMap::own_value() const { return success(0, shot_.launch.speed) - cost_of(shot_.launch, shot_.spin); }

std::vector<OutcomeMap::Best> OutcomeMap::best(double worth) {
  const bool one_speed = is_ideal(q_.puzzle.physics);
  if (!one_speed && !q_.pinned) look_along();
  const double contacts = cost_of(shot_) - cost_of(shot_.launch, shot_.spin);
  std::vector<Best> best = best_so_far();
  if (!best.empty() && best.front().value - contacts < worth - hope) return {};
  // A narrow peak may stand where the shot is.
  while (!one_speed && refine(shot_.launch.speed)) continue;
  best = best_so_far();
  while (!best.empty() && !one_speed && refine(best.front().launch.speed)) best = best_so_far();
  return best;
}

}  // namespace bankshot::planning
