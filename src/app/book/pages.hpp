// SPDX-License-Identifier: MIT
//
// The pages of a book: questions in front, answers at the back, and headings that say what each part holds.
#pragma once

#include <span>
#include <string>

#include "bankshot/plan/generate.hpp"

namespace bankshot::app::book {

struct Entry {
  bool solved = false, unique = false;
  Difficulty difficulty{};  ///< meaningful only if solved
  std::string title, question, scene, answer;
  std::string asked, told;  ///< pictures
};

/// A run of entries that belong together, and what is true of all of them.
struct Part {
  std::string title, subtitle;
  std::size_t begin, end;
};

/// Divides the book into parts, in its order: entries of one difficulty, or entries with one answer each. A part with
/// fewer than `least` entries joins the one before it.
std::vector<Part> parts(std::span<const Entry> book, std::size_t least);

std::string svg(std::span<const Entry> book);
std::string html(std::span<const Entry> book);

}  // namespace bankshot::app::book
