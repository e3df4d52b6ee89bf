// SPDX-License-Identifier: MIT
//
// A puzzle in a few words, for a page of a book.
#pragma once

#include <string>

#include "bankshot/scene/puzzle.hpp"

namespace bankshot::app::book {

/// "Two cushions into top-right"
std::string question(const Puzzle& puzzle);
/// "pool-9ft, spin, side 0.5"
std::string scene(const Puzzle& puzzle);
/// The title that its author wrote into `about`; empty without.
std::string title(const Puzzle& puzzle);

}  // namespace bankshot::app::book
