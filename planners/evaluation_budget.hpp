// SPDX-License-Identifier: MIT
//
// The evaluation budget of a search: simulations spent, and whether more may be. Every path that is followed counts, by
// its bounces.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>

#include "bankshot/simulate/work.hpp"

namespace bankshot::planning {

/// Bounces that cost as much as one simulation: a longer path counts as several.
inline constexpr std::size_t bounces_a_simulation = 32;

class EvaluationBudget {
 public:
  /// `cancelled`, if not null, ends the search as soon as it is true; it must outlive this.
  explicit EvaluationBudget(long budget, const std::atomic<bool>* cancelled = nullptr)
      : budget_(budget), limit_(budget), cancelled_(cancelled) {}
  /// Makes a budget for what does not count against another one. Both count the same work.
  EvaluationBudget(long budget, EvaluationBudget& beside) : EvaluationBudget(budget) { work_ = beside.work_; }
  EvaluationBudget(const EvaluationBudget&) = delete;
  EvaluationBudget& operator=(const EvaluationBudget&) = delete;

  /// Counts `times` paths with so many bounces each.
  void charge(std::size_t bounces, long times = 1) {
    simulations_ += times * (1 + static_cast<long>(bounces / bounces_a_simulation));
  }
  long simulations() const { return simulations_; }

  /// Returns whether nothing is left or the search was cancelled, and remembers that this ended the search.
  bool spent() {
    cut_ = cut_ || simulations_ >= limit_ || cancelled();
    ever_cut_ = ever_cut_ || cut_;
    return cut_;
  }
  /// Returns whether this part of the search was ended so, and not because it was done.
  bool cut() const { return cut_; }
  /// Returns whether any part of the search was ended so.
  bool ever_cut() const { return ever_cut_; }
  bool cancelled() const { return cancelled_ && cancelled_->load(std::memory_order_relaxed); }

  /// A part of the search, which gets one of `shares` even shares of what is left. What it does not spend is left to
  /// those after it.
  class Part {
   public:
    Part(EvaluationBudget& budget, std::size_t shares) : budget_(budget), limit_(budget.limit_) {
      budget_.limit_ = budget_.simulations_ + budget_.left() / static_cast<long>(shares);
    }
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;
    ~Part() {
      budget_.limit_ = limit_;
      budget_.cut_ = budget_.cut_ && (budget_.left() == 0 || budget_.cancelled());
    }

   private:
    EvaluationBudget& budget_;
    long limit_;
  };
  /// Returns whether the whole budget is spent, or the search was cancelled.
  bool exhausted() const { return simulations_ >= budget_ || cancelled(); }
  /// Returns the number of simulations that may still be spent.
  long left() const { return std::max(0L, limit_ - simulations_); }

  bool measures = false;  ///< time the verification; this costs two readings of the clock each
  double proof_us = 0;

  /// The work of all paths, also of those that are not counted as simulations.
  Work& work() { return *work_; }

 private:
  long simulations_ = 0;
  long budget_;
  long limit_;  ///< for the part that is searched now
  const std::atomic<bool>* cancelled_;
  bool cut_ = false;
  bool ever_cut_ = false;
  Work own_{};
  Work* work_ = &own_;
};

}  // namespace bankshot::planning
