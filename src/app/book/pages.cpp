// SPDX-License-Identifier: MIT
#include "app/book/pages.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bankshot/draw/page.hpp"
#include "io/draw/escape.hpp"

namespace bankshot::app::book {
namespace {

constexpr std::size_t columns = 5;

std::string number(std::size_t i, const Entry& e) {
  return e.title.empty() ? fmt::format("{}", i + 1) : fmt::format("{} · {}", i + 1, e.title);
}

std::string book_title(std::span<const Entry> book) {
  return fmt::format("{} Puzzle{}", book.size(), book.size() == 1 ? "" : "s");
}

std::string subtitle(std::span<const Entry> book) {
  const auto solved = std::count_if(book.begin(), book.end(), [](const Entry& e) { return e.solved; });
  const bool all = solved == static_cast<long>(book.size());
  return (all ? "every answer" : fmt::format("{} answer{}", solved, solved == 1 ? "" : "s")) +
         std::string(" found by bankshot and verified by a simulation");
}

constexpr std::string_view style =
    "body{font-family:Georgia,'DejaVu Serif',serif;color:#2b2118;background:#fbf7ee;max-width:75em;margin:2em auto;"
    "padding:0 1em}h1,h2,h2+p,h1+p{text-align:center}h2+p,h1+p,small{color:#8a7a66;font-style:italic}"
    "section{display:grid;grid-template-columns:repeat(auto-fill,minmax(21em,1fr));gap:1.5em}"
    "figure{margin:0;break-inside:avoid}figure "
    "svg{width:100%;height:auto;max-height:15em}a{color:inherit;text-decoration:none}"
    "@media print{h2.back{break-before:page}}";

/// Returns one picture with its words; its number links to the other end of the book.
std::string figure(std::size_t i, const Entry& e, bool told) {
  const char here = told ? 'a' : 'q', there = told ? 'q' : 'a';
  return fmt::format(
      "<figure id=\"{}{}\"><strong><a href=\"#{}{}\">{}</a></strong>\n{}<figcaption>{}<br><small>{}</small>"
      "</figcaption></figure>\n",
      here, i + 1, there, i + 1, escaped(number(i, e)), told ? e.told : e.asked, escaped(told ? e.answer : e.question),
      escaped(told ? e.question : e.scene));
}

}  // namespace

std::string svg(std::span<const Entry> book) {
  std::vector<Chapter> chapters;
  for (const Part& part : parts(book, columns)) {
    chapters.push_back({part.title, part.subtitle, {}});
    for (std::size_t i = part.begin; i < part.end; ++i)
      chapters.back().plates.push_back({book[i].asked, number(i, book[i]), {book[i].question, book[i].scene}});
  }
  chapters.push_back({"Answers", "", {}});
  for (std::size_t i = 0; i < book.size(); ++i)
    chapters.back().plates.push_back({book[i].told, number(i, book[i]), {book[i].answer, book[i].question}});
  return draw_page(chapters, {.columns = static_cast<int>(std::clamp<std::size_t>(book.size(), 1, columns)),
                              .plate = 480,
                              .ratio = 0.6,
                              .letter = 18,
                              .title = book_title(book),
                              .subtitle = subtitle(book)});
}

std::string html(std::span<const Entry> book) {
  std::string out = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}</title>\n<style>{1}</style></head>\n"
      "<body>\n<h1>{0}</h1>\n<p>{2}</p>\n",
      book_title(book), style, escaped(subtitle(book)));
  for (const Part& part : parts(book, columns)) {
    out += fmt::format("<h2>{}</h2>\n<p>{}</p>\n<section>\n", escaped(part.title), escaped(part.subtitle));
    for (std::size_t i = part.begin; i < part.end; ++i) out += figure(i, book[i], false);
    out += "</section>\n";
  }
  out += "<h2 class=\"back\">Answers</h2>\n<section>\n";
  for (std::size_t i = 0; i < book.size(); ++i) out += figure(i, book[i], true);
  return out + "</section>\n</body></html>\n";
}

}  // namespace bankshot::app::book
