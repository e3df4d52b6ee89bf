// SPDX-License-Identifier: MIT
#include "bankshot/plan/launch_map.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "planners/evaluate/noise_scanlines.hpp"
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
  // At a deviation of 0 both ends of the only cell are infinitely far, so its probability is 1.
  const auto below = [&](double at) { return planning::normal_below(at * cell / deviation); };
  std::vector<double> out;
  for (int k = -n; k <= n; ++k) out.push_back(below(k + 0.5) - below(k - 0.5));
  return out;
}

/// Sums each column with the weights, so that it loses as many cells on either side as they reach. The result is
/// transposed, so that two calls do both directions.
Eigen::MatrixXd blurred(const Eigen::MatrixXd& from, const std::vector<double>& weights) {
  const auto reach = static_cast<Eigen::Index>(weights.size()) - 1;
  Eigen::MatrixXd to = Eigen::MatrixXd::Zero(from.rows() - reach, from.cols());
  for (Eigen::Index k = 0; k <= reach; ++k) to += weights[static_cast<std::size_t>(k)] * from.middleRows(k, to.rows());
  return to.transpose();
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
  // The columns of a matrix lie one after the other, so a cell has its index in the grid.
  Eigen::MatrixXd made = Eigen::MatrixXd::Zero(around.angles, around.speeds);
  for (std::size_t i = 0; i < around.size() && !budget.spent(); ++i) {
    const Launch launch = around.at(i);
    const auto makes = [&](const planning::SearchRequest& request) {
      return planning::replay(request, budget, launch, planning::Goal::of(request)).made;
    };
    if (launch.speed > 0 && std::ranges::any_of(requests, makes)) made(static_cast<Eigen::Index>(i)) = 1;
  }
  LaunchMap map{grid, {}, {}};
  for (int s = 0; s < grid.speeds; ++s)
    for (int a = 0; a < grid.angles; ++a) map.made.push_back(made(a + beside, s + above) != 0);
  const Eigen::MatrixXd success = blurred(blurred(made, by_aim), by_speed);
  map.success.assign(success.data(), success.data() + success.size());
  return map;
}

}  // namespace bankshot
