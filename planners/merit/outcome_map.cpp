// SPDX-License-Identifier: MIT
#include "planners/merit/outcome_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>

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
    low = room.low / by_aim, high = room.high / by_aim;
  }
  rows_.push_back(row_at(shot.launch.speed, low, high));
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

/// The interval is expected from `low` to `high`.
OutcomeMap::Row OutcomeMap::row_at(double speed, double low, double high) {
  Row row{speed};
  const double width = std::max(high - low, tolerance::same_aim);
  for (const double share : {0.5, 0.25, 0.75, 0.0, 1.0, -0.5, 1.5}) {
    const double aim = low + share * width;
    if (const auto arrival = arrival_at(aim, speed)) {
      row.made = true, row.arrival = *arrival, row.low = row.high = aim;
      break;
    }
  }
  // A shot is made as it is launched, wherever the middle of its target may be.
  if (!row.made && rows_.empty()) row.made = true, row.arrival = shot_.arrival.speed;
  if (!row.made) return row;
  const double inside = row.low;
  row.low = edge(row, std::min(low, inside - tolerance::same_aim), -1);
  row.high = edge({.speed = speed, .low = inside, .high = inside}, std::max(high, inside + tolerance::same_aim), 1);
  return row;
}

/// The end of what is made to one side of a row that is one aim so far, found from where it is expected.
double OutcomeMap::edge(const Row& row, double expected, double side) {
  const double start = row.low, farthest = start + side * far * angle_;
  double in = start, out = side * (expected - farthest) < 0 ? expected : farthest;
  const auto beyond = [&](double aim) { return !(side * (aim - farthest) < 0); };
  const double step = nearly * std::abs(expected - start);
  if (made(out, row.speed)) {
    for (double by = step; in = out, !beyond(in); by *= 2) {
      out = in + side * by;
      if (!made(out, row.speed)) break;
    }
    if (beyond(in)) return farthest;
  } else if (const double before = out - side * step; side * (before - start) > 0) {
    (made(before, row.speed) ? in : out) = before;
  }
  while (std::abs(out - in) > finest * std::min(angle_, std::max(std::abs(in - start), tolerance::same_aim))) {
    const double middle = (in + out) / 2;
    if (middle == in || middle == out || ledger_.spent()) break;
    (made(middle, row.speed) ? in : out) = middle;
  }
  return (in + out) / 2;
}

/// Where the rows around a speed have the ends of the interval.
OutcomeMap::Row OutcomeMap::expected_at(double speed) const {
  const auto after = std::ranges::find_if(rows_, [&](const Row& r) { return r.made && r.speed > speed; });
  const auto is_before = [&](const Row& r) { return r.made && r.speed < speed; };
  const auto before = std::find_if(rows_.rbegin(), rows_.rend(), is_before);
  const auto beyond = [&](const Row& near, const auto& far) {
    const double share = (speed - near.speed) / (far.speed - near.speed);
    const Row out{speed, true, std::lerp(near.low, far.low, share), std::lerp(near.high, far.high, share)};
    return out.low < out.high ? out : near;
  };
  if (before != rows_.rend() && after != rows_.end()) return beyond(*before, *after);
  if (before != rows_.rend()) {
    const auto next = std::find_if(before + 1, rows_.rend(), is_before);
    return next == rows_.rend() ? *before : beyond(*before, *next);
  }
  const auto next = std::find_if(after + 1, rows_.end(), [](const Row& r) { return r.made; });
  return next == rows_.end() ? *after : beyond(*after, *next);
}

/// False where there are rows enough.
bool OutcomeMap::add(double speed) {
  if (rows_.size() >= most_rows || ledger_.spent() || !(speed > 0)) return false;
  const Row expected = expected_at(speed);
  const Row row = row_at(speed, expected.low, expected.high);
  rows_.insert(std::ranges::upper_bound(rows_, speed, {}, &Row::speed), row);
  return true;
}

/// Rows from the shot outwards, as far as some aim is made, in few steps.
void OutcomeMap::look_along() {
  for (const double ratio : {1 / coarse, coarse}) {
    int missed = 0;
    for (double speed = shot_.launch.speed * ratio; q_.speed.contains(speed) && missed < most_missed; speed *= ratio) {
      if (!add(speed)) return;
      const Row& row = ratio < 1 ? rows_.front() : rows_.back();
      missed = row.made ? 0 : missed + 1;
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
      if (row == rows_.end()) return add(next);
      at = row->speed;
    }
  }
  return false;
}

double OutcomeMap::success_at(double aim, double speed) const {
  const auto after = std::ranges::lower_bound(rows_, speed, {}, &Row::speed);
  if (after == rows_.end() || (after == rows_.begin() && after->speed != speed)) return 0;
  const Row &b = *after, &a = after == rows_.begin() ? b : *(after - 1);
  const double share = &a == &b ? 0 : (speed - a.speed) / (b.speed - a.speed);
  const auto inside = [&](double low, double high) {
    return normal_below((high - aim) / angle_) - normal_below((low - aim) / angle_);
  };
  if (a.made && b.made) return inside(std::lerp(a.low, b.low, share), std::lerp(a.high, b.high, share));
  const Row& near = share < 0.5 ? a : b;
  return near.made ? inside(near.low, near.high) : 0;
}

double OutcomeMap::success(double aim, double speed) const {
  if (is_ideal(q_.puzzle.physics)) return success_at(aim, speed);
  constexpr std::array node{0.0, 1.3556261799742659, 2.8569700138728056};
  constexpr std::array weight{0.5333333333333333, 0.2220759220056126, 0.0112574113277207};
  const double by = deviation(speed);
  double sum = weight[0] * success_at(aim, speed);
  for (std::size_t k = 1; k < node.size(); ++k)
    sum += weight[k] * (success_at(aim, speed - by * node[k]) + success_at(aim, speed + by * node[k]));
  return sum;
}

/// Golden sections between the middles of the rows around, inside the bounds of the aim.
double OutcomeMap::safest_aim(const Row& row) const {
  double low = row.middle(), high = low;
  for (const Row& other : rows_)
    if (other.made && std::abs(other.speed - row.speed) < 2 * deviation(row.speed))
      low = std::min(low, other.middle()), high = std::max(high, other.middle());
  constexpr double golden = 0.6180339887498949;
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double fa = success(a, row.speed), fb = success(b, row.speed);
  while (high - low > nearly * angle_) {
    if (fa < fb) {
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
  if (is_ideal(q_.puzzle.physics) || q_.pinned) return row.made && row.speed == shot_.launch.speed;
  return row.made && bring_inside(speed, q_.speed) && (!arrive || arrive->contains(row.arrival));
}

std::optional<OutcomeMap::Best> OutcomeMap::best() {
  const bool one_speed = is_ideal(q_.puzzle.physics) || q_.pinned;
  if (!one_speed) look_along();
  for (;;) {
    std::optional<Best> best;
    for (const Row& row : rows_) {
      if (!allowed(row)) continue;
      const double aim = safest_aim(row);
      const double value = success(aim, row.speed) - cost_of({row.speed, aim}, shot_.spin);
      if (!best || value > best->value) best = {{row.speed, wrap_angle(shot_.launch.angle + aim)}, value};
    }
    if (!best || one_speed || !refine(best->launch.speed)) return best;
  }
}

}  // namespace bankshot::planning
