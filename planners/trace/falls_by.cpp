// SPDX-License-Identifier: MIT
#include "planners/trace/falls_by.hpp"

#include <algorithm>
#include <utility>

#include "bankshot/simulate/simulator.hpp"
#include "bankshot/simulate/with_physics.hpp"
#include "planners/start.hpp"
#include "planners/trace/real_legs.hpp"

namespace bankshot::planning {
namespace {

/// Returns how many cushions the last ball may still meet.
std::size_t cushions_left(const Branch& aim) {
  const Then* const then = aim.request.problem->then();
  const int most = then ? aim.request.object_cushions.max : aim.request.cushions().max;
  return static_cast<std::size_t>(most - std::ranges::count(aim.route, aim.aim_point.ball, &Meeting::ball));
}

}  // namespace

std::optional<std::vector<Contact>> falls_by(const Branch& aim, EvaluationBudget& budget, const Launch& launch) {
  if (budget.spent()) return {};
  budget.charge(aim.route.size());
  const SearchRequest& request = aim.request;
  const std::size_t left = cushions_left(aim);
  return with_physics(
      request.puzzle().physics, [&](const auto& motion, const auto& cushion) -> std::optional<std::vector<Contact>> {
        const auto path =
            follow_locked(request.problem->balls(), motion, cushion, aim.route, start_of(request, launch));
        budget.work() += path.work;
        if (path.end != LockedEnd::complete) return {};
        Simulator sim(request.problem->boundary_of(path.ball), motion, cushion, path.state);
        std::vector<Contact> by;
        bool falls = false;
        each_leg(
            sim, budget.work(), [&] { return by.size() <= left; },
            [&](const Event& e) {
              falls = e.kind == EventKind::pocket && e.contact == aim.aim_point.taken_by;
              if (e.kind == EventKind::cushion) by.push_back(e.contact);
              return !falls && e.kind != EventKind::ball && !e.final();
            });
        return falls ? std::optional(std::move(by)) : std::nullopt;
      });
}

}  // namespace bankshot::planning
