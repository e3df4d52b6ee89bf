// SPDX-License-Identifier: MIT
//
// Where what one aims at is blocked, some part of the target may be reached beside it: around each lead the clearance
// is climbed (widest.hpp), and where that leaves hope, rows of aims are bisected.
#include <algorithm>
#include <cmath>

#include "planners/certify.hpp"
#include "planners/family/family.hpp"
#include "planners/images/window.hpp"
#include "planners/locked/speed.hpp"
#include "planners/merit/rank.hpp"
#include "planners/settings.hpp"
#include "planners/steps/steps.hpp"
#include "planners/steps/widest.hpp"

namespace bankshot::planning::steps {
namespace {

using namespace settings::parts;

/// A window around a lead, along its route, at the speed that each aim needs.
bool bisect_lead(const Question& q, Ledger& ledger, Findings& found, const Lead& lead) {
  const LockedAim locked{q, lead.route, lead.mark};
  const std::vector<Contact> contacts = contacts_of(lead.route);
  const Goal goal = Goal::along(contacts);
  const auto launch = [&](double aim) -> std::optional<Launch> {
    const auto speed = speed_near(locked, ledger, aim, lead.launch.speed);
    if (!speed) return {};
    return Launch{*speed, wrap_angle(aim)};
  };
  const AimRow row{[&](double aim) {
                     const auto l = launch(aim);
                     return l ? replay(q, ledger, *l, goal) : Replay{};
                   },
                   [&](double aim, int bounces) {
                     const auto l = launch(aim);
                     return l && certify(q, ledger, found, *l, bounces, word::parts, Demand::off_centre);
                   }};
  const Range aims{lead.launch.angle - lead.half, lead.launch.angle + lead.half};
  return find_window(row, ledger, aims, lead.launch.angle, aims_across);
}

/// A bisection may still find a part: the target is less than its own size away, at a speed that is allowed, or nearly.
bool hopeful(const Question& q, const Lead& lead) {
  const Range& v = q.speed;
  return lead.half > 0 && lead.room > -lead.mark.reach && lead.launch.speed > v.low / nearly_allowed &&
         lead.launch.speed < v.high * nearly_allowed;
}

/// Arrival speeds of a range, evenly in their roots: slow ones differ most.
class Arrivals {
 public:
  explicit Arrivals(const Range& r)
      : range_(r), low_(std::sqrt(r.low)), step_((std::sqrt(r.high) - low_) / (arrivals - 1)) {}
  double at(int i) const { return beside(range_.low, i); }
  /// So many steps beside another.
  double beside(double speed, double steps) const {
    const double root = std::max(low_, std::sqrt(speed) + steps * step_);
    return std::clamp(root * root, range_.low, range_.high);
  }

 private:
  Range range_;
  double low_, step_;
};

/// Along the same cushions into the same pocket the better shot stays.
void keep_better(const Question& q, Findings& found, std::vector<Shot>& shots) {
  const auto better = [&](const Shot& a, const Shot& b) {
    if (q.beside_will_do()) return a.chance > b.chance;
    return b.off_centre && (!a.off_centre || first_merit(q.puzzle, a) > first_merit(q.puzzle, b));
  };
  for (Shot& shot : shots) {
    const Pocket* const into = pocket_reached(q.puzzle, shot);
    const auto rival = std::ranges::find_if(
        found.shots, [&](const Shot& s) { return s.cushions == shot.cushions && pocket_reached(q.puzzle, s) == into; });
    if (rival == found.shots.end())
      found.shots.push_back(std::move(shot));
    else if (better(shot, *rival))
      *rival = std::move(shot);
  }
}

/// From the best shots to arrival speeds between those that were tried.
void refine_arrival(const Question& q, Ledger& ledger, Findings& found) {
  const Arrivals speeds(*q.arrival);
  std::ranges::sort(found.shots, std::greater{}, &Shot::chance);
  for (std::size_t i = 0; i < std::min(refined, found.shots.size()); ++i)
    for (const double steps : {-0.5, 0.5, -0.25, 0.25, -0.125, 0.125}) {
      if (ledger.spent()) return;
      const Shot shot = found.shots[i];
      const Question one = q.asking(speeds.beside(shot.arrival.speed, steps));
      Lead lead = family::lead_of(q, shot);
      Findings beside;
      Widest(one, ledger, beside, lead).find();
      keep_better(q, found, beside.shots);
    }
}

}  // namespace

void parts_by_arrival(const Question& q, Ledger& ledger, Findings& found) {
  const Arrivals speeds(*q.arrival);
  for (int i = 0; i < arrivals && !ledger.spent(); ++i) {
    const Question one = q.asking(speeds.at(i));
    Findings roots;
    images(one, ledger, roots);
    keep_better(q, found, roots.shots);
    for (Lead& lead : roots.leads) {
      Findings beside;
      if (!ledger.spent()) Widest(one, ledger, beside, lead).find();
      keep_better(q, found, beside.shots);
    }
  }
  if (q.beside_will_do()) refine_arrival(q, ledger, found);
}

void Parts::climb(const Question& q, Ledger& ledger, Findings& found) {
  for (Lead& lead : found.leads) {
    if (!found.shots.empty() || ledger.spent()) break;
    Widest(q, ledger, found, lead).find();
    tried_.push_back(std::move(lead));
  }
  found.leads.clear();
}

void Parts::bisect(const Question& q, Ledger& ledger, Findings& found, double share) {
  const long until = ledger.share_of_rest(share);
  std::sort(tried_.begin(), tried_.end(), [](const auto& a, const auto& b) { return a.room < b.room; });
  for (; !tried_.empty() && found.shots.empty() && !ledger.spent() && ledger.simulations() < until; tried_.pop_back()) {
    Lead& lead = tried_.back();
    if (hopeful(q, lead) && !Widest(q, ledger, found, lead).across_jumps()) bisect_lead(q, ledger, found, lead);
  }
}

}  // namespace bankshot::planning::steps
