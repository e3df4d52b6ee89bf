// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "app/book/pages.hpp"

namespace bankshot::app::book {
namespace {

/// Returns a text like "9 easy, 1 hard".
std::string counts(std::span<const Entry> part) {
  std::string out;
  const auto add = [&](long n, const std::string& what) {
    if (n > 0) out += fmt::format("{}{} {}", out.empty() ? "" : ", ", n, what);
  };
  for (const Difficulty d : {Difficulty::easy, Difficulty::medium, Difficulty::hard})
    add(std::count_if(part.begin(), part.end(), [&](const Entry& e) { return e.solved && e.difficulty == d; }),
        name(d));
  add(std::count_if(part.begin(), part.end(), [](const Entry& e) { return !e.solved; }), "without an answer");
  return out;
}

/// Returns what a difficulty means for the default player (plan/generate.hpp).
std::string meaning(Difficulty d) {
  if (d == Difficulty::easy)
    return fmt::format("made in at least {:.0f} % of tries, and {:.2g}° of aim to both sides still make it",
                       100 * easy_success, degrees(easy_margin));
  if (d == Difficulty::hard)
    return fmt::format("made in less than {:.0f} % of tries, or less than {:.3g}° of aim to one side",
                       100 * hard_success, degrees(hard_margin));
  return "between easy and hard";
}

template <class Same>
std::size_t run_length(std::span<const Entry> rest, Same same) {
  return static_cast<std::size_t>(std::find_if_not(rest.begin(), rest.end(), same) - rest.begin());
}

/// Counts the first entries that belong together: those of one difficulty or those with one answer each, whichever are
/// more.
std::size_t alike(std::span<const Entry> rest) {
  const Entry& first = rest.front();
  return std::max(run_length(rest, [](const Entry& e) { return e.unique; }), run_length(rest, [&](const Entry& e) {
                    return e.solved == first.solved && e.difficulty == first.difficulty;
                  }));
}

/// Returns a part whose heading says what is true of all its entries.
Part heading(std::span<const Entry> book, std::size_t begin, std::size_t end) {
  const std::span<const Entry> part = book.subspan(begin, end - begin);
  const std::size_t n = part.size();
  if (run_length(part, [](const Entry& e) { return e.unique; }) == n)
    return {fmt::format("{} with one answer", n), "no other was found: " + counts(part), begin, end};
  if (part.front().solved && alike(part) == n) return {counts(part), meaning(part.front().difficulty), begin, end};
  return {fmt::format("{} puzzle{}", n, n == 1 ? "" : "s"), counts(part), begin, end};
}

}  // namespace

std::vector<Part> parts(std::span<const Entry> book, std::size_t least) {
  std::vector<std::size_t> ends;
  for (std::size_t begin = 0; begin < book.size();) {
    const std::size_t n = alike(book.subspan(begin));
    begin += n;
    if (n < least && !ends.empty())
      ends.back() = begin;
    else
      ends.push_back(begin);
  }
  std::vector<Part> out;
  std::size_t begin = 0;
  for (const std::size_t end : ends) out.push_back(heading(book, begin, end)), begin = end;
  return out;
}

}  // namespace bankshot::app::book
