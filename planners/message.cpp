// SPDX-License-Identifier: MIT
#include "planners/message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bankshot/geometry/aim_point.hpp"
#include "bankshot/geometry/boundary.hpp"
#include "bankshot/numbers/tolerances.hpp"
#include "planners/evaluate/first_order.hpp"
#include "planners/nearest.hpp"
#include "planners/settings.hpp"
#include "planners/solve/newton.hpp"
#include "planners/verify/prove.hpp"

namespace bankshot::planning {
namespace {

/// Returns the aims that the puzzle allows, in words.
std::string aims(const SearchRequest& request) {
  const Range aim = request.angle.value_or(Range{0, radians(360)});
  const double to = degrees(aim.high);
  return fmt::format("{:.4g}° to {:.4g}°", degrees(aim.low), to > 360 ? to - 360 : to);
}

/// Says what went wrong, as the end of a sentence that begins with "it".
std::string explain(const SearchRequest& request, const Failure& f) {
  const auto cushion = [&] { return contact_name(request.puzzle(), f.contact); };
  const Range& v = request.speed;
  switch (f.reason) {
    case FailureReason::none:
    case FailureReason::inexact:
    case FailureReason::missed:
      return "passes by the target";
    case FailureReason::fell_short:
      return "stops before the target";
    case FailureReason::wrong_cushion:
      return fmt::format("meets cushion {} out of order", cushion());
    case FailureReason::extra_cushion:
      return fmt::format("meets cushion {} before the target", cushion());
    case FailureReason::in_place:
      return fmt::format("is launched into {}, which it already touches", cushion());
    case FailureReason::pocketed:
      return fmt::format("falls into pocket {} first", cushion());
    case FailureReason::hit_ball:
      return fmt::format("runs into {} first", cushion());
    case FailureReason::other_cut:
      return fmt::format("meets {} at another cut", cushion());
    case FailureReason::too_fast:
      return fmt::format("needs {:.4g} m/s or more, and the bound is {:.4g} m/s", f.speed, v.high);
    case FailureReason::too_slow:
      if (request.stop && deceleration(request.puzzle().physics) == 0)
        return "never stops, because the rolling friction is 0";
      return fmt::format("needs {:.4g} m/s or less, and the bound is {:.4g} m/s", f.speed, v.low);
    case FailureReason::too_long:
      return fmt::format("needs a longer path than a launch at {:.4g} m/s can roll", v.high);
    case FailureReason::scratched:
      return "pockets the cue ball";
    case FailureReason::other_bounces:
    case FailureReason::no_budget:  // launches refused for this are not counted
    case FailureReason::outside_aim:
      break;
  }
  return fmt::format("needs an aim outside the bounds of {}", aims(request));
}

/// Says what a launch does instead of what is asked, or at which bound it is held.
std::string why(const SearchRequest& request, const Proof& proof) {
  const Launch& l = proof.shot.launch;
  const auto at_end = [](double v, const Range& r) {
    const double slack = tolerance::bound * std::max(1.0, r.high);
    return std::abs(v - r.low) <= slack || std::abs(v - r.high) <= slack;
  };
  const Range& v = request.puzzle().speed;
  if (request.puzzle().angle && !request.puzzle().angle->fixed() && at_end(l.angle, *request.puzzle().angle))
    return explain(request, {FailureReason::outside_aim});
  if (!v.fixed() && at_end(l.speed, v)) return fmt::format("is held at the bound of {:.4g} m/s", l.speed);
  const double speed = proof.shot.path.arrival.speed;
  if (proof.failure.reason == FailureReason::inexact && request.arrival && !request.arrival->contains(speed))
    return fmt::format("arrives at {:.4g} m/s", speed);
  return explain(request, proof.failure);
}

/// An answer names no more reasons: a person reads no more.
constexpr std::size_t most_reasons_named = 3;

/// Returns the failure reasons of candidates, the most frequent first.
std::string reasons(const SearchRequest& request, const SearchResult& found) {
  std::vector<SearchResult::Counted> by_count = found.failures;
  std::stable_sort(by_count.begin(), by_count.end(), [](const auto& a, const auto& b) { return a.times > b.times; });
  std::string out;
  for (std::size_t i = 0; i < std::min(most_reasons_named, by_count.size()); ++i)
    out += fmt::format("{}it {} ({} of the launches tried)", i ? "; " : "", explain(request, by_count[i].failure),
                       by_count[i].times);
  if (by_count.size() > most_reasons_named)
    out += fmt::format("; and {} other reason{}", by_count.size() - most_reasons_named,
                       by_count.size() > most_reasons_named + 1 ? "s" : "");
  if (!out.empty()) return out;
  return found.proved ? "no path has the cushions asked for" : "no launch was found that reaches the target as asked";
}

std::string asked_cushions(const CushionRule& c) {
  if (c.sequence) return "the cushions asked for, in that order";
  if (c.min == c.max) return fmt::format("exactly {} cushion{}", c.min, c.min == 1 ? "" : "s");
  return fmt::format("{} to {} cushions", c.min, c.max);
}

/// Returns a warning if double precision is not enough for an exact answer: the replay's miss is then rounding, too.
std::string uncertain(const SearchRequest& request, const Shot& shot) {
  if (!shot.verification.digits) return "";
  if (*shot.verification.digits == 0) return "; how often it bounces at its target is up to rounding";
  return fmt::format("; rounding leaves {} digits: the true arrival may be {:.1g} m away", *shot.verification.digits,
                     request.problem->boundary.diagonal * std::pow(10, -*shot.verification.digits));
}

/// Says why a shot is not on the exact line or point: what its route meets there.
std::string why_beside(const SearchRequest& request, EvaluationBudget& budget, const Shot& shot) {
  const Route route = route_of(shot);
  // The words of an answer do not count against the budget.
  EvaluationBudget aside(settings::most_spent_on_words, budget);
  const SearchRequest own = request.pinned || request.one_unknown() ? request : request.asking(shot.path.arrival.speed);
  const auto root = newton({own, route, request.problem->aim_point_of(shot)}, aside, shot.launch, settings::wide);
  const auto& cuts = request.problem->aim_point_of(shot).cuts;
  const bool any_cut = cuts && cuts->high - cuts->low >= 2 * request.problem->aim_point_of(shot).reach;
  const std::string where = fmt::format("; it is made off the {}: ", request.problem->drops() ? "exact line"
                                                                     : cuts && !any_cut       ? "cut that is asked"
                                                                     : cuts                   ? "middle of the ball"
                                                                                              : "middle of the target");
  if (!root) return where + "no launch by its cushions leads there";
  const Proof proof = prove(own, aside, *root, Goal::along(shot, Demand::exact));
  return where + "there it " + explain(request, proof.failure);
}

std::string solved(const SearchRequest& request, EvaluationBudget& budget, const SearchResult& found, const Answer& a,
                   std::size_t distinct) {
  std::string text = request.first() ? "the first shot found; there may be better ones"
                     : distinct == 1 ? "one shot found"
                     : request.all() ? fmt::format("{} distinct shots found", distinct)
                                     : fmt::format("the best of {} shots found; --all prints each", distinct);
  if (is_hopeless(request.puzzle(), a.shots.front()))
    text = "possible, not playable: this player makes it less than once in 100 tries; " + text;
  if (found.plenty && !request.first()) text += "; the search stopped there, so others were not compared";
  if (a.shots.front().path.touches_jaws)
    text += request.problem->safest() ? "; it touches the jaws of a pocket"
                                      : "; it touches the jaws of a pocket, because no shot was found that avoids them";
  if (a.shots.front().verification.off_centre && !a.shots.front().provenance.moved && !request.problem->safest())
    text += as_struck(request, a.shots.front(),
                      [&](const SearchRequest& own) { return why_beside(own, budget, a.shots.front()); });
  const Shot& best = a.shots.front();
  if (best.path.scratch_pocket)
    text +=
        "; the cue ball falls into " + contact_name(request.puzzle().table, Contact::pocket(*best.path.scratch_pocket));
  for (const std::string& warning : warnings(request.puzzle(), best)) text += "; " + warning;
  text += uncertain(request, a.shots.front());
  if (budget.ever_cut())
    text +=
        fmt::format("; the {} ended the search, so there may be better ones", budget.cancelled() ? "caller" : "budget");
  if (found.not_searched >= 0)
    text += fmt::format("; not all shots by {} cushions or more were searched", found.not_searched);
  if (found.improvement_sought && !budget.ever_cut())
    text += fmt::format("; not all routes narrower than {:.0f}° of aim were searched, so there may be a better one",
                        degrees(settings::automatic::improvement.narrowest));
  if (request.all() && !found.complete && !budget.ever_cut())
    text += "; there may be more: shots in a narrow range of aims can be missed";
  return text;
}

std::string no_shot(const SearchRequest& request, const SearchResult& found) {
  if (const Contact ball = request.problem->covering())
    return fmt::format("certified: {} covers the target", contact_name(request.puzzle(), ball));
  if (found.proved)
    return fmt::format("certified: every path with {} was tried, and {}", asked_cushions(request.cushions()),
                       reasons(request, found));
  const Range& v = request.speed;
  const std::string speeds = v.fixed() ? fmt::format("the launch speed {:.4g} m/s", v.low)
                                       : fmt::format("launch speeds {:.4g} to {:.4g} m/s", v.low, v.high);
  const std::string how = !request.problem->objects  ? ""
                          : request.problem->carom() ? ", a grid of aims across the first ball"
                                                     : ", one launch per route";
  return fmt::format("searched {} and aims {} with {}{}: {}", speeds, aims(request), asked_cushions(request.cushions()),
                     how, reasons(request, found));
}

/// Returns remarks on an odd puzzle that may explain why no shot was found.
std::string caveats(const SearchRequest& request) {
  std::string text;
  const AimPoint& aim_point = request.problem->nearest_aim_point(request.puzzle().ball.at);
  if (!aim_point.captures() && norm(aim_point.at - request.puzzle().ball.at) <= aim_point.reach &&
      request.cushions().min == 0)
    text += "; the ball starts at its target";
  return text;
}

}  // namespace

std::string message(const SearchRequest& request, EvaluationBudget& budget, const SearchResult& found, const Answer& a,
                    std::size_t distinct) {
  std::string text;
  if (a.status == Status::solved)
    text = solved(request, budget, found, a, distinct);
  else if (a.status == Status::budget)
    text = budget.cancelled()
               ? "the search was cancelled before it found a shot"
               : fmt::format("no shot found within the budget of {} simulations", budget_of(request.puzzle()));
  else
    text = no_shot(request, found);
  if (a.status != Status::solved) text += caveats(request);
  if (!found.note.empty()) text += "; " + found.note;
  return text;
}

void add_nearest(const SearchRequest& request, EvaluationBudget& budget, const SearchResult& found, bool scan,
                 Answer& a) {
  const auto launch = a.status == Status::no_shot ? nearest_launch(request, budget, found, scan) : std::nullopt;
  if (!launch) return;
  EvaluationBudget aside(2, budget);  // the nearest miss does not count against the budget
  Proof proof = prove(request, aside, *launch, Goal::of(request));
  add_first_order(request, proof.shot, aside.work());
  proof.shot.provenance.planner = "none";
  a.nearest = Answer::Nearest{std::move(proof.shot), why(request, proof)};
}

}  // namespace bankshot::planning
