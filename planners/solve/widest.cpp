// SPDX-License-Identifier: MIT
#include "planners/solve/widest.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "planners/settings.hpp"
#include "planners/solve/line_search.hpp"
#include "planners/solve/speed.hpp"
#include "planners/trace/clearance.hpp"
#include "planners/verify/certify.hpp"

namespace bankshot::planning {
namespace {

using namespace settings::widest;

class Widest {
 public:
  Widest(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, Candidate& candidate)
      : request_(request),
        budget_(budget),
        found_(found),
        candidate_(candidate),
        aim_{request, candidate.route, candidate.aim_point} {}

  void find() {
    if (!(candidate_.half > 0)) candidate_.half = half_window();
    if (!(candidate_.half > 0)) return;
    const Row row = along_lead();
    for (const std::size_t i : peaks_of(row)) {
      const Tried best = highest(row, i);
      candidate_.room = std::max(candidate_.room, best.value);
      if (shot(best)) return;
    }
  }

 private:
  static constexpr std::size_t aims_across = settings::aims_across, middle = aims_across / 2;
  static constexpr double blocked = -std::numeric_limits<double>::infinity();

  /// An aim at a speed, and its clearance.
  struct Tried {
    double x = 0;  ///< rad
    double speed = 0;
    double value = blocked;
  };
  using Row = std::array<Tried, aims_across>;

  static const Tried& before(const Row& row, std::size_t i) { return row[i > 0 ? i - 1 : i]; }
  static const Tried& after(const Row& row, std::size_t i) { return row[std::min(i + 1, aims_across - 1)]; }

  /// Returns how far the aim may turn from a root [rad] until the ball passes all of the target. The speed is adapted
  /// to arrive as asked.
  double half_window() const {
    const auto l = linearise(aim_, budget_, candidate_.launch);
    if (!l) return 0;
    double lateral = l->by_aim(0);  // of the diagonal, per radian
    if (!request_.one_unknown())
      lateral = l->determinant(false) / (request_.stop ? std::hypot(l->by_speed(0), l->by_speed(1)) : l->by_speed(1));
    const double half = candidate_.aim_point.reach / (std::abs(lateral) * request_.problem->boundary.diagonal);
    return half < widest_half ? half : widest_half;
  }

  double aim_at(std::size_t i) const {
    return candidate_.launch.angle + candidate_.half * (static_cast<double>(i) / middle - 1);
  }

  /// Tries the aims from the candidate outwards, so that each speed is near its neighbour's.
  Row along_lead() const {
    Row row;
    row[middle] = attempt(candidate_.launch.angle, candidate_.launch.speed);
    for (std::size_t i = middle + 1; i < aims_across; ++i) row[i] = attempt(aim_at(i), row[i - 1].speed);
    for (std::size_t i = middle; i-- > 0;) row[i] = attempt(aim_at(i), row[i + 1].speed);
    return row;
  }

  /// Returns the indices at which the clearance is larger than at the neighbours, largest first.
  static std::vector<std::size_t> peaks_of(const Row& row) {
    std::vector<std::size_t> peaks;
    for (std::size_t i = 0; i < aims_across; ++i)
      if (row[i].value > blocked && (i == 0 || row[i].value >= row[i - 1].value) &&
          (i + 1 == aims_across || row[i].value > row[i + 1].value))
        peaks.push_back(i);
    std::sort(peaks.begin(), peaks.end(), [&](auto a, auto b) { return row[a].value > row[b].value; });
    return peaks;
  }

  /// Closes in on a peak of clearances by golden sections, until little can be gained.
  Tried highest(const Row& row, std::size_t peak) const {
    const auto settled = [](const Tried& low, const Tried& best, const Tried& high) {
      return best.value - std::min(low.value, high.value) < little_gain * std::abs(best.value);
    };
    return climb(
        before(row, peak), row[peak], after(row, peak), settings::rounding,
        [&](double aim, const Tried& best) { return attempt(aim, best.speed); }, settled);
  }

  Tried attempt(double aim, double guess) const {
    const auto speed = budget_.spent() ? std::nullopt : speed_near(aim_, budget_, aim, guess);
    if (!speed) return {aim, guess};
    return {aim, *speed, clearance(aim_, budget_, {*speed, aim}).value_or(blocked)};
  }

  bool shot(const Tried& t) const {
    const double least = -10 * request_.problem->boundary.touch;  // a path through a corner has no clearance at all
    if (!(t.value > least) || budget_.spent()) return false;
    const Launch launch{t.speed, wrap_angle(t.x)};
    const int bounces = bounces_of(aim_.route);
    return certify(request_, budget_, found_, launch, bounces, word::partition, Demand::off_centre);
  }

  const SearchRequest& request_;
  EvaluationBudget& budget_;
  SearchResult& found_;
  Candidate& candidate_;
  Branch aim_;
};

}  // namespace

void climb_clearance(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found,
                     Candidate& candidate) {
  Widest(request, budget, found, candidate).find();
}

}  // namespace bankshot::planning
