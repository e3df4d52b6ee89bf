// SPDX-License-Identifier: MIT
//
// The pages of a book: questions in front, answers at the back. Its headings say what is in it.
#pragma once

#include <span>
#include <string>

#include "bankshot/plan/generate.hpp"

namespace bankshot::app::book {

struct Entry {
  bool solved = false, unique = false;
  Difficulty difficulty{};  ///< of one that is solved
  std::string title, question, scene, answer;
  std::string asked, told;  ///< pictures
};

/// Entries that belong together, and what is true of all of them.
struct Part {
  std::string title, subtitle;
  std::size_t begin, end;
};

/// In the order of the book: of one difficulty, or with one answer each. What is shorter than `least` joins the part
/// before it.
std::vector<Part> parts(std::span<const Entry> book, std::size_t least);

std::string svg(std::span<const Entry> book);
std::string html(std::span<const Entry> book);

}  // namespace bankshot::app::book
