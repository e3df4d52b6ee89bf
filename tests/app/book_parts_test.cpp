// SPDX-License-Identifier: MIT
//
// The pages of a book of puzzles: the words of a puzzle, the parts of the book, and the links between questions and
// answers.
#include "app/book/pages.hpp"
#include "app/book/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "bankshot/numbers/random.hpp"
#include "bankshot/scene/json.hpp"
#include "bankshot/scene/scene.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::app;
using namespace bankshot::app::book;
using Catch::Contains;

namespace {

/// Returns a puzzle on a preset table, completed by `more`.
Puzzle puzzle(const std::string& more, const std::string& physics = R"("rolling")") {
  return read_puzzle(R"({"table": "pool-9ft", "physics": )" + physics + R"(, "ball": {"at": [0.635, 0.4]}, )" + more +
                     "}");
}

Entry entry(bool solved, bool unique, Difficulty difficulty = Difficulty::easy) {
  Entry e;
  e.solved = solved, e.unique = unique, e.difficulty = difficulty;
  e.question = "question", e.scene = "scene", e.answer = "answer";
  e.asked = e.told = R"(<svg xmlns="http://www.w3.org/2000/svg" width="20" height="10" viewBox="0 0 20 10"></svg>)";
  return e;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

/// Returns a random book, whose neighbours are often alike.
std::vector<Entry> random_book(Random& draw) {
  std::vector<Entry> out;
  const int runs = draw.integer(1, 8);
  for (int run = 0; run < runs; ++run) {
    const Entry e = entry(draw.chance(0.8), draw.chance(0.3), static_cast<Difficulty>(draw.integer(0, 2)));
    out.insert(out.end(), static_cast<std::size_t>(draw.integer(1, 12)), e);
  }
  return out;
}

}  // namespace

TEST_CASE("a question names its cushions and its target") {
  const std::string pocket = R"("target": {"pocket": "top-right"})", rest = R"("target": {"point": [1.5, 1.0]})";
  CHECK(question(puzzle(pocket + R"(, "cushions": 0)")) == "Straight into top-right");
  CHECK(question(puzzle(pocket + R"(, "cushions": [])")) == "Straight into top-right");
  CHECK(question(puzzle(pocket + R"(, "cushions": 1)")) == "One cushion into top-right");
  CHECK(question(puzzle(pocket + R"(, "cushions": 5)")) == "Five cushions into top-right");
  CHECK(question(puzzle(pocket + R"(, "cushions": 6)")) == "6 cushions into top-right");
  CHECK(question(puzzle(pocket + R"(, "cushions": {"min": 1, "max": 3})")) == "1 to 3 cushions into top-right");
  CHECK(question(puzzle(pocket + R"(, "cushions": ["top", "left"])")) == "By top, left into top-right");
  CHECK(question(puzzle(rest + R"(, "cushions": 2)")) == "Two cushions, to rest in the ring");
}

TEST_CASE("a question tells the speed that it fixes") {
  const std::string pocket = R"("target": {"pocket": "top-right"}, "cushions": 0)";
  CHECK(question(puzzle(pocket + R"(, "speed": 2.5)")) == "Straight into top-right, struck at 2.5 m/s");
  CHECK(question(puzzle(pocket + R"(, "arrive": {"speed": 1})")) == "Straight into top-right at 1 m/s");
  CHECK(question(puzzle(pocket + R"(, "arrive": {"speed": [1, 2]})")) == "Straight into top-right");
  CHECK(question(puzzle(R"("target": {"point": [1.5, 1.0]}, "cushions": 0, "arrive": {"speed": 0.5})")) ==
        "Straight through the ring at 0.5 m/s");
}

TEST_CASE("a scene is its table, its physics and its spin") {
  const std::string target = R"("target": {"pocket": "top-right"})";
  CHECK(scene(puzzle(target)) == "pool-9ft, rolling");
  CHECK(scene(puzzle(target, R"("ideal")")) == "pool-9ft, no friction");
  CHECK_THAT(scene(puzzle(target, R"("spin")")), Catch::StartsWith("pool-9ft, spin"));
  Puzzle p = puzzle(target);
  p.spin = {.top = -0.5, .side = 0.25, .masse = 0};
  CHECK(scene(p) == "pool-9ft, rolling, top -0.5, side 0.25");
  p.spin = {.top = 0, .side = 0, .masse = 0.1};
  CHECK(scene(p) == "pool-9ft, rolling, massé 0.1");
  p.spin = {};
  p.table = rectangle_table(2, 1.25);
  CHECK(scene(p) == "2 × 1.25 m, rolling");
  p.table = polygon_table({{0, 0}, {2, 0}, {1, 2}});
  CHECK(scene(p) == "3 sides, rolling");
  for (const TablePreset& preset : table_presets()) {
    p.table = make_table(preset, false);
    CHECK(scene(p) == std::string(preset.name) + ", rolling");
  }
}

TEST_CASE("a title is the text that the author calls so") {
  Puzzle p;
  CHECK(title(p).empty());
  for (const auto& [about, expected] : {std::pair{R"({"title": "The \"snake\" é"})", "The \"snake\" é"},
                                        {R"({"title": 7})", ""},
                                        {R"({"author": "x"})", ""},
                                        {R"("title")", ""},
                                        {R"(["title"])", ""}}) {
    INFO(about);
    p.about = about;
    CHECK(title(p) == expected);
  }
}

TEST_CASE("the parts of a book are the book, in its order, and small ones join the part before") {
  constexpr std::uint64_t seed = 1;
  Random draw(seed);
  CHECK(parts({}, 5).empty());
  for (int i = 0; i < 300; ++i) {
    INFO("draw " << i << " of seed " << seed);
    const std::vector<Entry> all = random_book(draw);
    const auto least = static_cast<std::size_t>(draw.integer(1, 8));
    const std::vector<book::Part> found = parts(all, least);
    REQUIRE(!found.empty());
    CHECK(found.front().begin == 0);
    CHECK(found.back().end == all.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      const book::Part& part = found[k];
      if (k > 0) CHECK(part.begin == found[k - 1].end);
      if (k > 0) CHECK(part.end - part.begin >= least);
      CHECK(part.end > part.begin);
      const std::span<const Entry> in(all.data() + part.begin, part.end - part.begin);
      const bool unique = std::ranges::all_of(in, [](const Entry& e) { return e.unique; });
      CHECK((part.title == fmt::format("{} with one answer", in.size())) == unique);
      // The counts of a part are in its title or below it.
      const auto solved = std::ranges::count_if(in, [](const Entry& e) { return e.solved; });
      if (solved < static_cast<long>(in.size()))
        CHECK_THAT(part.title + part.subtitle,
                   Contains(fmt::format("{} without an answer", static_cast<long>(in.size()) - solved)));
    }
  }
}

TEST_CASE("a part says what is true of all its puzzles") {
  std::vector<Entry> all(6, entry(true, false, Difficulty::easy));
  all.insert(all.end(), 5, entry(true, false, Difficulty::hard));
  all.insert(all.end(), 7, entry(true, true, Difficulty::medium));
  const std::vector<book::Part> found = parts(all, 5);
  REQUIRE(found.size() == 3);
  CHECK(found[0].title == "6 easy");
  CHECK_THAT(found[0].subtitle, Contains("at least 90 % of tries") && Contains("0.25°"));
  CHECK(found[1].title == "5 hard");
  CHECK_THAT(found[1].subtitle, Contains("less than 40 % of tries") && Contains("0.0625°"));
  CHECK(found[2].title == "7 with one answer");
  CHECK(found[2].subtitle == "no other was found: 7 medium");
  const std::vector<book::Part> together = parts(all, 8);
  REQUIRE(together.size() == 1);
  CHECK(together[0].title == "18 puzzles");
  CHECK(together[0].subtitle == "6 easy, 7 medium, 5 hard");
  const std::vector<Entry> one{entry(false, false)};
  CHECK(parts(one, 5)[0].title == "1 puzzle");
  CHECK(parts(one, 5)[0].subtitle == "1 without an answer");
}

TEST_CASE("each question of a page is linked to its answer, and its answer back") {
  std::vector<Entry> all(7, entry(true, false));
  all[2].title = "The <long> way & back";
  all[3].solved = false;
  const std::string page = html(all);
  for (std::size_t i = 1; i <= all.size(); ++i) {
    INFO(i);
    CHECK(count(page, fmt::format("id=\"q{}\"", i)) == 1);
    CHECK(count(page, fmt::format("id=\"a{}\"", i)) == 1);
    CHECK(count(page, fmt::format("href=\"#a{}\"", i)) == 1);
    CHECK(count(page, fmt::format("href=\"#q{}\"", i)) == 1);
  }
  CHECK(count(page, "<svg") == 14);
  CHECK(count(page, "3 · The &lt;long&gt; way &amp; back") == 2);
  CHECK_THAT(page, !Contains("<long>") && Contains("<title>7 Puzzles</title>") &&
                       Contains("6 answers found by bankshot and verified by a simulation"));
  CHECK(page.rfind("id=\"q7\"") < page.find(">Answers<"));
  CHECK(page.find("id=\"a1\"") > page.find(">Answers<"));
  const std::vector<Entry> one{entry(true, false)};
  CHECK_THAT(html(one), Contains("<title>1 Puzzle</title>") && Contains("every answer found"));
}

TEST_CASE("a picture of a book holds each question before all answers") {
  std::vector<Entry> all(6, entry(true, false));
  for (std::size_t i = 0; i < all.size(); ++i) all[i].title = fmt::format("name{} & more", i);
  const std::string picture = svg(all);
  CHECK(picture.starts_with("<svg"));
  CHECK_THAT(picture, Contains("6 Puzzles") && Contains("6 easy") && Contains("Answers") && !Contains("& more"));
  for (std::size_t i = 0; i < all.size(); ++i)
    CHECK(count(picture, fmt::format("{} · name{} &amp; more", i + 1, i)) == 2);
  CHECK(picture.find("name5") < picture.find("Answers"));
}
