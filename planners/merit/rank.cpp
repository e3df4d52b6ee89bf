// SPDX-License-Identifier: MIT
#include "planners/merit/rank.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "planners/merit/margin.hpp"
#include "planners/merit/success.hpp"
#include "planners/settings.hpp"

namespace bankshot::planning {
namespace {

/// Larger is better.
double merit(const Puzzle& p, const Shot& shot) {
  return p.prefer == Prefer::robust && shot.success ? *shot.success : first_merit(p, shot);
}

void order(const Puzzle& p, std::span<Shot> shots) {
  std::stable_sort(shots.begin(), shots.end(), [&](const Shot& a, const Shot& b) {
    const double x = merit(p, a), y = merit(p, b);
    if (x != y) return x > y;
    if (a.first_order != b.first_order) return a.first_order > b.first_order;
    return a.launch.angle < b.launch.angle;
  });
}

/// Where some line reaches the target's centre, shots beside it are no answer.
void keep_centred(std::vector<Shot>& shots) {
  const auto beside = [](const Shot& shot) { return shot.off_centre; };
  if (!std::all_of(shots.begin(), shots.end(), beside)) std::erase_if(shots, beside);
}

}  // namespace

double first_merit(const Puzzle& p, const Shot& shot) {
  switch (p.prefer) {
    case Prefer::soft:
      return -shot.launch.speed;
    case Prefer::quick:
      return -shot.arrival.time;
    case Prefer::robust:
      break;
  }
  return shot.first_order;
}

void rank(const Question& q, std::vector<Shot>& shots) {
  keep_centred(shots);
  order(q.puzzle, shots);
}

void add_robustness(const Question& q, Ledger& ledger, Findings& found) {
  std::vector<Shot>& shots = found.shots;
  const std::size_t n = std::min(shots.size(), settings::most_compared_by_success);
  const bool by_success = q.puzzle.prefer == Prefer::robust;
  if (shots.size() > n && by_success)
    found.add_note(fmt::format("only the {} with the largest first-order margin were compared by success", n));
  for (std::size_t i = 0; i < (by_success || q.all() ? n : 1); ++i) find_success(q, ledger, shots[i]);
  if (by_success) order(q.puzzle, std::span(shots).first(n));
  for (std::size_t i = 0; i < (q.all() ? shots.size() : 1); ++i) {
    if (!shots[i].success) find_success(q, ledger, shots[i]);
    find_margin(q, ledger, shots[i]);
  }
}

}  // namespace bankshot::planning
