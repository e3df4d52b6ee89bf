// SPDX-License-Identifier: MIT
//
// A puzzle in a few words, for a page of a book.
#pragma once

#include <string>

#include "bankshot/scene/puzzle.hpp"

namespace bankshot::app::book {

/// Returns a text like "Two cushions into top-right".
std::string question(const Puzzle& puzzle);
/// Returns a text like "pool-9ft, spin, side 0.5".
std::string scene(const Puzzle& puzzle);
/// Returns the title that the author wrote into `about`; empty if there is none.
std::string title(const Puzzle& puzzle);

}  // namespace bankshot::app::book
