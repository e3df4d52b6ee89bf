// SPDX-License-Identifier: MIT
//
// A ball that touches a cushion may run exactly along it. It then meets other cushions than at any aim beside, so no
// partition of aims shows it. The aim is known, and only the speed is searched for.
// Method: launches at even steps of ln speed, both ways along each cushion touched. A golden-section search starts at
// each launch that comes nearer to what is asked than its neighbours; a replay then verifies. Cost: some 600
// simulations a cushion. Guarantee: none.
#include <algorithm>
#include <cmath>
#include <vector>

#include "planners/propose/proposers.hpp"
#include "planners/settings.hpp"
#include "planners/solve/line_search.hpp"
#include "planners/stop.hpp"
#include "planners/verify/certify.hpp"

namespace bankshot::planning::propose {
namespace {

using namespace settings::along;

/// Searches the speeds of one aim.
class OneAim {
 public:
  OneAim(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, double angle)
      : request_(request), budget_(budget), found_(found), angle_(angle) {}

  void search() {
    if (request_.one_unknown()) return certify_at(request_.fixed_speed());
    const Range& v = request_.speed;
    const double low = std::max(v.low, settings::slowest_of_fastest * v.high);
    std::vector<Tried> row;
    for (int i = 0; i <= speeds && !budget_.spent(); ++i)
      row.push_back(attempt(low * std::pow(v.high / low, static_cast<double>(i) / speeds)));
    for (std::size_t i = 0; i < row.size() && !budget_.spent(); ++i) {
      const Tried &before = row[i > 0 ? i - 1 : i], &after = row[std::min(i + 1, row.size() - 1)];
      if (row[i].value > hopeless && row[i].value >= before.value && row[i].value >= after.value)
        certify_at(best_between(before, row[i], after));
    }
  }

 private:
  /// A speed and its value: minus the distance of its launch from what is asked. The miss counts as a share of the
  /// diagonal, and the error of the arrival speed as a share of the speed asked.
  struct Tried {
    double x, value;
  };
  static constexpr double hopeless = -1;

  Tried attempt(double speed) {
    const Replay r = replay(request_, budget_, {speed, angle_}, Goal::of(request_));
    if (!r.made && r.failure.reason != FailureReason::missed) return {speed, hopeless};
    const double miss = r.miss / request_.problem->boundary.diagonal;
    const bool any_speed = !request_.arrival || request_.stop;
    return {
        speed,
        -(any_speed ? miss : miss + std::abs(r.path.arrival.speed - request_.asked) / std::max(1.0, request_.asked))};
  }

  double best_between(const Tried& low, const Tried& best, const Tried& high) {
    const auto narrow = [&](const Tried&, const Tried&, const Tried&) { return budget_.spent(); };
    return climb(
               low, best, high, settings::rounding * high.x, [&](double speed, const Tried&) { return attempt(speed); },
               narrow)
        .x;
  }

  void certify_at(double speed) {
    for (int n = request_.cushions().min; n <= request_.cushions().max && !budget_.spent(); ++n)
      certify(request_, budget_, found_, {speed, angle_}, n, word::partition);
  }

  const SearchRequest& request_;
  EvaluationBudget& budget_;
  SearchResult& found_;
  double angle_;
};

}  // namespace

void along(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found) {
  for (const double angle : request.problem->along_touched_cushions())
    if (!stop::over(request, budget, found)) OneAim(request, budget, found, angle).search();
}

}  // namespace bankshot::planning::propose
