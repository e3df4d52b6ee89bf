// SPDX-License-Identifier: MIT
//
// Counts of a batch's answers so far, and how they are shown: a progress line on a terminal and a summary at the end.
#pragma once

#include <chrono>
#include <string>

#include "bankshot/plan/answer.hpp"

namespace bankshot::app::batch {

struct Tally {
  long solved = 0, no_shot = 0, budget = 0, invalid = 0;
  long first_invalid = 0;  ///< line of the first invalid answer, from 1; 0 if there is none
  long beside = 0;         ///< solved, but no shot reaches the target's centre
  double worst_miss = 0;   ///< m, of the shots that reach the centre
  long simulations = 0;

  long lines() const { return solved + no_shot + budget + invalid; }
  void add(const Puzzle& puzzle, const Answer& answer);
  void add_invalid(long line);
  void add(const Tally& later);
};

/// CPU time of a batch by stage, in seconds over all threads.
struct Cost {
  double read = 0;   ///< bytes to lines
  double parse = 0;  ///< lines to puzzles
  double search = 0;
  double certify = 0;     ///< replays of proposed launches
  double robustness = 0;  ///< margin and success
  double format = 0;      ///< answers to lines, and their gzip compression
  double write = 0;       ///< to the file
  void add(const Cost& more);
};

/// The progress line: puzzles done, share of the input, rate, time left, share solved.
class Progress {
 public:
  /// `kept`: number of answers of an earlier run. `shown`: draw the line, which is for a terminal and not for --quiet.
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

/// Returns "1,000 puzzles in 0.1 s, 9,000 a second: 998 solved, ...".
std::string closing_line(const Tally& tally, long kept, const Progress& progress);
std::string grouped(long n);  ///< 1,234,567
/// Returns a CSV table of the costs and the peak memory.
std::string cost_csv(const Cost& cost, const Tally& tally, long kept, const Progress& progress);

}  // namespace bankshot::app::batch
