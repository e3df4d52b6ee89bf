// SPDX-License-Identifier: MIT
//
// The answer to a puzzle: verified shots, or the reason why there is none.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "bankshot/plan/shot.hpp"
#include "bankshot/scene/puzzle.hpp"
#include "bankshot/simulate/work.hpp"

namespace bankshot {

enum class Status { solved, no_shot, budget, invalid };

const char* name(Status status);

/// The shots that are planned after the best shot of a game.
struct Plan {
  /// A shot that is planned, from where the shot before it leaves the balls.
  struct Step {
    Puzzle puzzle;
    Shot shot;
  };
  std::vector<Step> next{};
  /// Probability of potting the first ball, the first two, and so on, in one visit. It is an estimate: along the
  /// planned shots, as if each stray place of the cue ball were worth what those of its shot are in the mean.
  std::vector<double> clears{};
  bool whole = false;  ///< the last of them clears the table
  std::string why{};   ///< why this shot and not the likeliest pot
};

struct Answer {
  std::string id{};     ///< JSON text of the puzzle's identifier; empty without
  std::string about{};  ///< JSON text of the puzzle's `about`; empty without
  Status status = Status::no_shot;
  std::vector<Shot> shots{};  ///< best first
  struct Nearest {
    Shot shot;
    std::string why;
  };
  std::optional<Nearest> nearest{};  ///< the nearest miss of a `no_shot`
  std::optional<Plan> plan{};        ///< of a game
  std::vector<std::string> modelled{};
  long simulations = 0;  ///< simulations spent on search and verification
  double time_us = 0;    ///< time of the search, without margin and success
  struct Cost {
    double certify_us = 0;     ///< part of time_us that the replays of candidates took
    double robustness_us = 0;  ///< time for margin and success, not part of time_us
    Work work{};               ///< of all simulated paths, also of those that `simulations` leaves out
  } cost{};                    ///< the times are filled if SolveOptions::measure is set
  std::string message{};
  struct Error {
    std::string path, reason;
  };
  std::optional<Error> error{};  ///< set if the status is `invalid`

  /// Adds the simulations, times and work of another answer that led to this one.
  void add_cost(const Answer& other) {
    simulations += other.simulations;
    time_us += other.time_us;
    cost.certify_us += other.cost.certify_us;
    cost.robustness_us += other.cost.robustness_us;
    cost.work += other.cost.work;
  }
};

/// Returns the answer to input that could not be read or breaks a rule.
Answer invalid_answer(std::string id, const InvalidInput& error, std::string about = "");

/// Returns the answer as one line of JSON. `timing` adds time_us, `path` adds the points of each shot's path.
std::string to_json(const Puzzle& puzzle, const Answer& answer, bool timing = true, bool path = false);
/// Returns the JSON of an `invalid` answer, which has no puzzle.
std::string to_json(const Answer& invalid);

/// Reads an answer back: its shots have the launch, spin, cushions and claims of the JSON. Throws InvalidInput with
/// the JSON path. If `puzzle` is null (it could not be read), only id, status and error are read.
/// `unread`, if given, receives the keys of answer and shots that are not part of the format.
Answer read_answer(std::string_view text, const Puzzle* puzzle, std::set<std::string>* unread = nullptr);

/// Returns the path of each shot up to its target, in the CSV format of a trajectory. With `numbered`, a last column
/// holds the number of the shot, from 1.
std::string to_csv(const Puzzle& puzzle, const Answer& answer, bool numbered);

/// Returns a short text for a player: where to aim, how hard, and what happens.
std::string to_text(const Puzzle& puzzle, const Answer& answer);

}  // namespace bankshot
