// SPDX-License-Identifier: MIT
//
// Where what one aims at is blocked, some part of the target may be reached beside it: around each lead the clearance
// is climbed (widest.hpp), and where that leaves hope, rows of aims are bisected.
#include <algorithm>
#include <cmath>

#include "planners/certify.hpp"
#include "planners/images/window.hpp"
#include "planners/locked/speed.hpp"
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

}  // namespace

bool alike(const Launch& a, const Launch& b) {
  return std::abs(angle_difference(a.angle, b.angle)) < settings::parts::alike &&
         std::abs(std::log(a.speed / b.speed)) < settings::parts::alike;
}

void Parts::climb(const Question& q, Ledger& ledger, Findings& found) {
  if (q.starts()) return;  // its leads are what is asked for
  for (Lead& lead : found.leads) {
    if (!found.shots.empty() || ledger.spent()) break;
    if (q.objects && was_tried(lead)) continue;  // many pairs of routes lead to one root
    Widest(q, ledger, found, lead).find();
    tried_.push_back(std::move(lead));
  }
  found.leads.clear();
}

bool Parts::was_tried(const Lead& lead) const {
  return std::ranges::any_of(tried_, [&](const Lead& known) {
    return alike(known.launch, lead.launch) && known.spin == lead.spin && known.mark == lead.mark &&
           known.route == lead.route;
  });
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
