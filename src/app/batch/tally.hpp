// SPDX-License-Identifier: MIT
//
// What came of a batch so far, and how it is told: a line that moves on a terminal, one at the end.
#pragma once

#include <chrono>
#include <string>

#include "bankshot/plan/answer.hpp"

namespace bankshot::app::batch {

struct Tally {
  long solved = 0, no_shot = 0, budget = 0, invalid = 0;
  long first_invalid = 0;  ///< its line, from 1; 0 without
  long beside = 0;         ///< solved, but no shot reaches the target's centre
  double worst_miss = 0;   ///< m, of those that do
  long simulations = 0;

  long lines() const { return solved + no_shot + budget + invalid; }
  void add(const Puzzle& puzzle, const Answer& answer);
  void add_invalid(long line);
  void add(const Tally& later);
};

/// Where the time of a batch went: seconds of CPU, over all threads.
struct Cost {
  double read = 0;   ///< bytes to lines
  double parse = 0;  ///< lines to puzzles
  double search = 0;
  double certify = 0;     ///< replays of what the search proposed
  double robustness = 0;  ///< margin and success
  double format = 0;      ///< answers to lines; with gzip, compressing them
  double write = 0;       ///< to the file
  void add(const Cost& more);
};

/// The line that moves: done, share of the input, rate, what is left, share solved.
class Progress {
 public:
  /// `kept`: answers of an earlier run; `shown`: on a terminal, unless quiet.
  Progress(long kept, double share, bool shown);
  ~Progress() { clear(); }
  void show(const Tally& tally, double share);
  void clear();
  double seconds() const;
  double rate(const Tally& tally) const;

 private:
  using Clock = std::chrono::steady_clock;
  long kept_;
  double share_before_;
  bool shown_, drawn_ = false;
  Clock::time_point begin_ = Clock::now(), next_ = begin_;
};

/// "1,000 puzzles in 0.1 s, 9,000 a second: 998 solved, ..."
std::string closing_line(const Tally& tally, long kept, const Progress& progress);
std::string grouped(long n);  ///< 1,234,567
/// A table of the costs, and of the most memory held, as CSV.
std::string cost_csv(const Cost& cost, const Tally& tally, long kept, const Progress& progress);

}  // namespace bankshot::app::batch
