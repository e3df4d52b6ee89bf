// SPDX-License-Identifier: MIT
//
// Shots with their proof, or the reason why there is none.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "bankshot/plan/shot.hpp"
#include "bankshot/scene/puzzle.hpp"

namespace bankshot {

enum class Status { solved, no_shot, budget, invalid };

const char* name(Status status);

struct Answer {
  std::string id{};     ///< JSON text of the puzzle's identifier; empty without
  std::string about{};  ///< the same of the puzzle's `about`
  Status status = Status::no_shot;
  std::vector<Shot> shots{};  ///< best first
  struct Nearest {
    Shot shot;
    std::string why;
  };
  std::optional<Nearest> nearest{};  ///< the closest miss of a `no_shot`
  std::vector<std::string> modelled{};
  long simulations = 0;  ///< search and certification
  double time_us = 0;    ///< of the search, without margin and success
  struct Cost {
    double certify_us = 0;     ///< of time_us, what the replays of candidates took
    double robustness_us = 0;  ///< margin and success, beside time_us
  } cost{};                    ///< where SolveOptions::measure asked for it
  std::string message{};
  struct Error {
    std::string path, reason;
  };
  std::optional<Error> error{};  ///< of `invalid`
};

/// The answer to input that could not be read or breaks a rule.
Answer invalid_answer(std::string id, const InvalidInput& error, std::string about = "");

/// One line of JSON. `timing` writes time_us, `path` the points of each shot's path.
std::string to_json(const Puzzle& puzzle, const Answer& answer, bool timing = true, bool path = false);
/// The same for an `invalid` answer, which has no puzzle.
std::string to_json(const Answer& invalid);

/// An answer read back, shots with the launch, spin, cushions and claims of their JSON. Throws InvalidInput with
/// the JSON path. Of an answer to a puzzle that cannot be read (null) only id, status and error are
/// read. `unread`, if given, receives the keys of answer and shots that are no part of the format.
Answer read_answer(std::string_view text, const Puzzle* puzzle, std::set<std::string>* unread = nullptr);

/// The path of each shot up to its target, as `to_csv` of a trajectory writes it; with `numbered` the last column says
/// which shot it is, from 1.
std::string to_csv(const Puzzle& puzzle, const Answer& answer, bool numbered);

/// A short text for a person: where to aim, how hard, what happens.
std::string to_text(const Puzzle& puzzle, const Answer& answer);

}  // namespace bankshot
