// SPDX-License-Identifier: MIT
#include "bankshot/plan/launch_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "planners/evaluate/settings.hpp"
#include "planners/verify/replay.hpp"

namespace bankshot {
namespace {

/// Most cells that are simulated, including those around the window: some seconds.
constexpr int most_cells = 2000000;
InvalidInput too_fine() { return {"/noise", "reaches over more cells than are simulated: ask for fewer, wider cells"}; }

/// Returns the probabilities that a normal error ends in each of the cells from -n to n.
std::vector<double> weights(double deviation, double cell) {
  const double reach = std::ceil(planning::settings::success::widest * deviation / cell);
  if (reach > most_cells) throw too_fine();
  const auto n = static_cast<int>(reach);
  std::vector<double> out;
  for (int k = -n; k <= n; ++k) {
    const auto below = [&](double at) {
      return deviation > 0 ? std::erfc(-at * cell / deviation / std::sqrt(2.0)) / 2 : at < 0 ? 0.0 : 1.0;
    };
    out.push_back(below(k + 0.5) - below(k - 0.5));
  }
  return out;
}

/// A table of numbers, row by row.
struct Rows {
  Rows(int of_columns, int of_rows)
      : columns(of_columns), rows(of_rows), cells(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}
  int columns, rows;
  std::vector<double> cells;
  double& at(int column, int row) {
    return cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column)];
  }
};

/// Sums each row with the weights, so that it loses as many cells on either side as they reach. The result is
/// transposed, so that two calls do both directions.
Rows blurred(Rows& from, const std::vector<double>& weights) {
  const auto reach = static_cast<int>(weights.size()) - 1;
  Rows to(from.rows, from.columns - reach);
  for (int row = 0; row < from.rows; ++row)
    for (int column = 0; column < to.rows; ++column) {
      double sum = 0;
      for (int k = 0; k <= reach; ++k) sum += weights[static_cast<std::size_t>(k)] * from.at(column + k, row);
      to.at(row, column) = sum;
    }
  return to;
}

}  // namespace

Launch LaunchGrid::at(std::size_t i) const {
  const auto n = static_cast<std::size_t>(angles);
  const double a = (static_cast<double>(i % n) + 0.5) / angles, s = (static_cast<double>(i / n) + 0.5) / speeds;
  return {std::lerp(speed.low, speed.high, s), wrap_angle(std::lerp(angle.low, angle.high, a))};
}

LaunchMap launch_map(const Puzzle& puzzle, const LaunchGrid& grid, const std::atomic<bool>* cancelled) {
  validate(puzzle);
  const double aim = (grid.angle.high - grid.angle.low) / grid.angles,
               faster = (grid.speed.high - grid.speed.low) / grid.speeds;
  const std::vector<double> by_aim = weights(puzzle.noise.angle, aim),
                            by_speed = weights(puzzle.noise.speed_at((grid.speed.low + grid.speed.high) / 2), faster);
  const int beside = static_cast<int>(by_aim.size()) / 2, above = static_cast<int>(by_speed.size()) / 2;
  // The grid extends around the window as far as the noise reaches.
  const LaunchGrid around{{grid.angle.low - beside * aim, grid.angle.high + beside * aim},
                          {grid.speed.low - above * faster, grid.speed.high + above * faster},
                          grid.angles + 2 * beside,
                          grid.speeds + 2 * above};
  if (static_cast<double>(around.angles) * around.speeds > most_cells) throw too_fine();
  std::vector<Puzzle> orders{puzzle};
  if (is_in_any_order(puzzle.target)) {
    orders.push_back(puzzle);
    const auto& carom = std::get<CaromTarget>(puzzle.target);
    orders[0].target = in_order(puzzle.target, carom.first);
    orders[1].target = in_order(puzzle.target, carom.second.balls.front());
  }
  std::vector<planning::SearchRequest> requests(orders.begin(), orders.end());
  planning::EvaluationBudget budget(std::numeric_limits<long>::max(), cancelled);
  Rows made(around.angles, around.speeds);
  for (std::size_t i = 0; i < around.size() && !budget.spent(); ++i) {
    const Launch launch = around.at(i);
    const auto makes = [&](const planning::SearchRequest& request) {
      return planning::replay(request, budget, launch, planning::Goal::of(request)).made;
    };
    if (launch.speed > 0 && std::ranges::any_of(requests, makes)) made.cells[i] = 1;
  }
  LaunchMap map{grid, {}, {}};
  for (int row = 0; row < grid.speeds; ++row)
    for (int column = 0; column < grid.angles; ++column) map.made.push_back(made.at(column + beside, row + above) != 0);
  Rows half = blurred(made, by_aim);
  map.success = blurred(half, by_speed).cells;
  return map;
}

}  // namespace bankshot
