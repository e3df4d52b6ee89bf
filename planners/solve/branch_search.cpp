// SPDX-License-Identifier: MIT
#include "planners/solve/branch_search.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "planners/evaluate/first_order.hpp"
#include "planners/evaluate/rank.hpp"
#include "planners/evaluate/success.hpp"
#include "planners/solve/settings.hpp"
#include "planners/trace/arrival.hpp"
#include "planners/verify/aftermath.hpp"
#include "planners/verify/certify.hpp"

namespace bankshot::planning::branch {

using namespace settings::branch;

namespace {

/// Turn of the compass after each round [rad]. Its multiples never repeat.
constexpr double golden_turn = std::numbers::pi * (3 - 2.23606797749979);

/// Returns the value to first order. Where that is not positive it returns less, which still grows with success.
double likely_value(const Shot& shot) {
  const double estimate = shot.robustness.success_estimate, value = estimate - cost_of(shot);
  return value > 0 ? value : std::log(std::max(estimate, settings::rounding));
}

}  // namespace

int BranchSearch::freedom(const SearchRequest& request) {
  const auto free = static_cast<int>(free_of(box_of(request)).size());
  const bool speed_asked = request.arrival && !request.pinned && (request.stop || request.arrival->fixed());
  return free - 1 - (speed_asked ? 1 : 0);
}

BranchSearch::BranchSearch(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found,
                           const Candidate& start)
    : request_(request.spinning(start.spin)),
      budget_(budget),
      found_(found),
      start_(start),
      aim_{request_, start.route, start.aim_point},
      box_(box_of(request)),
      wide_(box_),
      vary_(request.puzzle().spin_range ? Vary::spin_too : Vary::launch) {
  wide_.low[aim] = -infinite, wide_.high[aim] = infinite;
  if (box_.free(log_speed)) wide_.low[log_speed] = -infinite, wide_.high[log_speed] = infinite;
}

Equations BranchSearch::equations(const Point& p, bool& at_bound) const {
  Equations out = passes(p);
  if (request_.stop || request_.pinned || !request_.arrival) return out;
  const auto counted = [&](double speed) { return even_square(request_.puzzle().physics, speed * speed); };
  const double square = p.speed2.a, low = counted(request_.arrival->low), high = counted(request_.arrival->high);
  at_bound = at_bound || !(square > low && square < high);
  if (at_bound) out.add(speed_off(p, square < (low + high) / 2 ? low : high));
  return out;
}

std::optional<Point> BranchSearch::corrected(const Vector& x, Box box, int held, double tolerance) {
  if (held >= 0) box.low[held] = box.high[held] = x[held];
  bool at_bound = false;
  std::optional<Point> last;
  const auto there = least_change(x, box, tolerance, [&](const Vector& at) -> std::optional<Equations> {
    last = look(aim_, budget_, at, vary_);
    return last ? std::optional(equations(*last, at_bound)) : std::nullopt;
  });
  if (!there) return {};
  last->x = *there;
  return last;
}

Eigen::MatrixXd BranchSearch::tangents(const Point& p) const {
  bool at_bound = false;
  const Equations found = equations(p, at_bound);
  const bool any_speed = request_.arrival && !request_.arrival->fixed();
  const std::span<const Value> rows =
      any_speed ? found.all().first(static_cast<std::size_t>(p.equations)) : found.all();
  const std::vector<int> free = free_of(wide_);
  const auto n = static_cast<Eigen::Index>(free.size()), m = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd a(n, m);
  for (Eigen::Index k = 0; k < m; ++k)
    a.col(k) = rows[static_cast<std::size_t>(k)].by.cwiseProduct(scales())(std::span(free));
  if (n <= m) return Eigen::MatrixXd(coordinates, 0);
  const Eigen::MatrixXd all = Eigen::HouseholderQR<Eigen::MatrixXd>(a).householderQ();
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(coordinates, n - m);
  for (Eigen::Index i = 0; i < n; ++i) out.row(free[static_cast<std::size_t>(i)]) = all.row(i).tail(n - m);
  // Each tangent leads to more speed and top spin, which a mirror keeps. So a mirrored branch has mirrored tangents.
  for (auto tangent : out.colwise())
    if (tangent[log_speed] + tangent[top] < 0) tangent = -tangent;
  return out;
}

void BranchSearch::search() {
  const int free = freedom(request_);
  const auto from = corrected(near_start(), wide_);
  if (!from || (free == 1 && is_hopeless(*from))) return;
  Curve curve = free == 1 ? curve_through(*from) : Curve{{*from}};
  add_crossings(curve);
  keep_parts(curve);
  if (!drops() || is_listed(start_.aim_point, aim_.route, found_.shots)) return;
  if (!request_.all() || !look_beside(curve)) look_for_jaw_shots(curve);
}

std::optional<BranchSearch::Tried> BranchSearch::foot() {
  const auto from = corrected(near_start(), box_);
  return from ? std::optional(clear(attempt(*from))) : std::nullopt;
}

void BranchSearch::climb_from(const Tried& from) {
  const Tried best = climb(from);
  if (best.made())
    keep(best);
  else if (drops())
    look_for_jaw_shots({attempt_where_clear(best.at)});
}

Vector BranchSearch::near_start() const {
  return vector_of({start_.launch.speed, near_window(start_.launch.angle, request_.angle)}, start_.spin);
}

bool BranchSearch::is_listed(const AimPoint& aim_point, std::span<const Meeting> route,
                             std::span<const Shot> among) const {
  return std::ranges::any_of(among, [&](const Shot& shot) {
    return request_.problem->aim_point_of(shot) == aim_point && std::ranges::equal(route_of(shot), route);
  });
}

double BranchSearch::merit(const Point& p) const {
  switch (request_.puzzle().prefer) {
    case Prefer::soft:
      return -p.x[log_speed];
    case Prefer::quick:
      return -p.time.a;
    case Prefer::robust:
      break;
  }
  return 0;  // known once the launch is verified
}

bool BranchSearch::is_hopeless(const Point& p) {
  return clearance(aim_, budget_, launch_of(p.x)).value_or(0) < -hopeless * request_.problem->boundary.diagonal;
}

bool BranchSearch::inside(const Point& p) const {
  for (int i = 0; i < coordinates; ++i)
    if (p.x[i] < box_.low[i] - settings::settled || p.x[i] > box_.high[i] + settings::settled) return false;
  return true;
}

BranchSearch::Tried BranchSearch::attempt(const Point& p) {
  Tried t{p, merit(p), {}};
  if (!inside(p)) return t;
  request_.spin = spin_of(p.x);
  t.proof = prove(request_, budget_, launch_of(p.x), Goal::exactly(request_, bounces_of(aim_.route)));
  if (t.made() && request_.puzzle().prefer == Prefer::robust) {
    budget_.charge(aim_.route.size());
    add_first_order(request_, t.proof->shot, budget_.work());
    t.merit = likely_value(t.proof->shot);
  }
  return t;
}

/// Gives a launch that is no shot its clearance as merit: the largest is nearest to a shot.
BranchSearch::Tried BranchSearch::clear(Tried t) {
  if (!t.made()) t.merit = clearance(aim_, budget_, launch_of(t.at.x)).value_or(-infinite);
  return t;
}

BranchSearch::Tried BranchSearch::climb(Tried at) {
  double step = 1, turned = 0;
  const auto first = [&] { return request_.first() && at.made(); };
  for (int evaluations = 0; !first() && evaluations < settings::most_steps && step > finest && !budget_.spent();) {
    bool moved = false;
    for (const Vector& way : ways(at, turned)) {
      ++evaluations;
      const auto p = corrected(at.at.x + step * scales().cwiseProduct(way), box_);
      if (!p) continue;
      Tried t = clear(attempt(*p));
      if (!t.above(at)) continue;
      at = std::move(t);
      moved = true;
      break;
    }
    step = moved ? std::min(2 * step, longest_step) : step / 3;
    turned += golden_turn;
  }
  return at;
}

/// Returns the directions to try from a point. First comes the slope of what is preferred, where that is known. Then
/// comes a basis of the tangent space, both ways, turned each time so that no ridge hides between them.
std::vector<Vector> BranchSearch::ways(const Tried& from, double turned) const {
  Eigen::MatrixXd basis = tangents(from.at);
  std::vector<Vector> out;
  Vector slope = Vector::Zero();
  if (from.made() && request_.puzzle().prefer == Prefer::soft) slope[log_speed] = -1;
  if (from.made() && request_.puzzle().prefer == Prefer::quick) slope = -from.at.time.by;
  slope = basis * (basis.transpose() * scales().cwiseProduct(slope));
  if (slope.norm() > 0) out.push_back(slope.normalized());
  for (Eigen::Index i = 0; i + 1 < basis.cols(); ++i) {
    const Eigen::VectorXd a = basis.col(i), b = basis.col(i + 1);
    basis.col(i) = a * std::cos(turned) + b * std::sin(turned);
    basis.col(i + 1) = b * std::cos(turned) - a * std::sin(turned);
  }
  for (Eigen::Index i = 0; i < basis.cols(); ++i) {
    out.push_back(basis.col(i));
    out.push_back(-basis.col(i));
  }
  return out;
}

Shot BranchSearch::tuned(const Shot& shot) {
  Shot best = shot;
  if (!best.robustness.success) find_success(request_, budget_, best);
  auto at = corrected(vector_of({best.launch.speed, near_window(best.launch.angle, request_.angle)}, best.spin), box_);
  double step = 1, turned = 0;
  for (int tried = 0; at && tried < most_tuned && step > finest && *best.robustness.success < settings::sure;) {
    std::optional<Shot> better;
    Point there;
    for (const Vector& way : ways({*at}, turned)) {
      const auto next = corrected(at->x + step * scales().cwiseProduct(way), box_);
      Tried t = next ? attempt(*next) : Tried{};
      if (!t.made()) continue;
      find_success(request_, budget_, t.proof->shot);
      ++tried;
      if (!(*t.proof->shot.robustness.value >
            (better ? *better : best).robustness.value.value() + (better ? 0 : settings::worth_a_search)))
        continue;
      better = std::move(t.proof->shot);
      there = *next;
    }
    if (better) {
      at = there;
      better->provenance = best.provenance;
      best = std::move(*better);
      add_aftermath(request_, budget_, best);
    } else {
      step /= 2;
    }
    turned += golden_turn;
  }
  return best;
}

void BranchSearch::keep(const Tried& t) {
  request_.spin = spin_of(t.at.x);
  planning::keep(request_, budget_, found_, t.proof->shot, Goal::exactly(request_, bounces_of(aim_.route)),
                 word::continuation);
}

void tune(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found) {
  const Puzzle& p = request.puzzle();
  // A shot that is moved to its safest launch gets its speed and aim there.
  const bool chosen_later = request.problem->safest() && request.all();
  if (p.prefer != Prefer::robust || chosen_later || is_straight(p.physics) || BranchSearch::freedom(request) == 0)
    return;
  // First order knows little of the other routes by which a carom may reach its second ball, so several are tuned.
  const std::size_t some = request.problem->carom() ? std::min(found.shots.size(), most_tuned_caroms) : 1;
  const std::span<Shot> shots = std::span(found.shots).first(request.all() ? found.shots.size() : some);
  for (Shot& shot : shots) {
    const Candidate candidate{shot.launch, route_of(shot), request.problem->aim_point_of(shot), shot.spin};
    if (!shot.verification.off_centre) shot = BranchSearch(request, budget, found, candidate).tuned(shot);
  }
  if (!request.all()) return order_by_value(shots);
  // Two shots that were tuned into one lay on one curve.
  std::vector<Shot> distinct;
  for (Shot& shot : found.shots) {
    const auto same = [&](const Shot& known) { return known.spin == shot.spin && same_shot(request, known, shot); };
    if (std::ranges::none_of(distinct, same)) distinct.push_back(std::move(shot));
  }
  found.shots = std::move(distinct);
}

}  // namespace bankshot::planning::branch
