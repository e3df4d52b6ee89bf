// SPDX-License-Identifier: MIT
//
// Cost of one call in C++ and in C, for comparison with calls from other languages.
//   one_call solve puzzle.json 2000      microseconds of CPU: the call alone, and from text to text in C++ and in C
//   one_call simulate shot.json 2000
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <iostream>
#include <sstream>
#include <vector>

#include "bankshot/bankshot.h"
#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "bankshot/simulate/trajectory.hpp"

using namespace bankshot;

namespace {

/// Returns the median of nine rounds.
template <class F>
double microseconds(long count, const F& call) {
  std::vector<double> rounds;
  for (int round = 0; round < 9; ++round) {
    const std::clock_t begin = std::clock();
    for (long i = 0; i < count; ++i) call();
    rounds.push_back(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC * 1e6 / static_cast<double>(count));
  }
  std::ranges::nth_element(rounds, rounds.begin() + 4);
  return rounds[4];
}

volatile std::size_t used = 0;  // keeps the compiler from removing a call

using InC = bankshot_status (*)(const char* document, size_t length, const char* flags, bankshot_text* out);

void report_c(long count, const std::string& text, InC call) {
  fmt::print("{:.3f}\n", microseconds(count, [&] {
               bankshot_text out;
               if (call(text.data(), text.size(), nullptr, &out) == BANKSHOT_DONE) used = out.length;
               bankshot_free(out.data);
             }));
}

void report(long count, const std::string& text, bool solves) {
  if (solves) {
    const Puzzle puzzle = read_puzzle(text);
    fmt::print("{:.3f}\n", microseconds(count, [&] { used = solve(puzzle).shots.size(); }));
    fmt::print("{:.3f}\n", microseconds(count, [&] {
                 const Puzzle p = read_puzzle(text);
                 used = to_json(p, solve(p)).size();
               }));
    report_c(count, text, bankshot_solve);
  } else {
    const ShotRequest shot = read_shot(text);
    fmt::print("{:.3f}\n", microseconds(count, [&] { used = simulate(shot).events.size(); }));
    fmt::print("{:.3f}\n", microseconds(count, [&] {
                 const ShotRequest s = read_shot(text);
                 used = to_json(s, simulate(s)).size();
               }));
    report_c(count, text, bankshot_simulate);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return std::cerr << "one_call solve|simulate FILE COUNT\n", 2;
  std::ifstream file(argv[2]);
  std::stringstream text;
  text << file.rdbuf();
  report(std::stol(argv[3]), text.str(), std::string_view(argv[1]) == "solve");
}
