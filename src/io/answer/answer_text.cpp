// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "bankshot/plan/answer.hpp"
#include "io/answer/words.hpp"

namespace bankshot {

std::string to_text(const Puzzle& p, const Answer& a) {
  std::string out = fmt::format("{}: {}\n", name(a.status), a.message);
  for (std::size_t i = 0; i < a.shots.size(); ++i) {
    if (a.shots.size() > 1) out += fmt::format("\nshot {} of {}\n", i + 1, a.shots.size());
    for (const Row& row : rows_of(p, a.shots[i], i == 0 && a.plan ? &*a.plan : nullptr))
      out += row.what == scratch_row ? fmt::format("  {}: {}\n", row.what, row.text)
                                     : fmt::format("  {:<10}{}\n", row.what, row.text);
  }
  if (a.nearest) out += fmt::format("  nearest   {}\n", nearest_words(*a.nearest, p.table));
  return out;
}

}  // namespace bankshot
