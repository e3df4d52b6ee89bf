// SPDX-License-Identifier: MIT
//
// The writing of `report`: numbers in words, spreads, figures as gnuplot draws them, the page in HTML and Markdown, and
// its progress.
#include "app/report/figure.hpp"
#include "app/report/measure.hpp"
#include "app/report/page.hpp"
#include "app/report/progress.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "app/scratch_file.hpp"
#include "bankshot/numbers/random.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::app::report;
using Catch::Contains;
using test::ScratchFile;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

Point at(double x, double y) { return {x, y, y, y}; }

Figure small_figure() {
  Figure f;
  f.columns = 2;
  f.panels = {{"one", {"x"}, {"y"}, {{"ours", {at(0, 1), at(1, 2)}}, {"another", {{0, 1, 0.5, 1.5}, at(1, 3)}}}},
              {"two", {"x", true}, {"y", true}, {{"ours", {at(1, 1), at(10, 100)}, Curve::Style::dashes}}}};
  return f;
}

Page small_page() {
  Section s{.name = "1-first", .title = "First <section>", .question = "Is a & b?", .about = "About it."};
  s.caption = "What is \"seen\".";
  s.table = {{"group", "what", "n|m"}, {{"a", "x<y", "1"}, {"a", "z", "2"}, {"b", "x|y", "3"}}, 2};
  s.conclusion = "It is.";
  s.data = {{"1-first", "x\n1\n"}, {"1-first-more", "y\n2\n"}};
  Section other = s;
  other.name = "2-second", other.title = "Second";
  return {"machine & commit", {s, other}};
}

std::string path_of_programs() {
  const char* const path = std::getenv("PATH");
  return path ? path : "";
}

/// A folder before the others of PATH that holds a gnuplot of our own; with no text there is no other program at all.
class OwnGnuplot {
 public:
  explicit OwnGnuplot(const std::string& script) : folder_("gnuplot"), before_(path_of_programs()) {
    std::filesystem::create_directories(folder_.path);
    const std::string file = folder_.path + "/gnuplot";
    if (!script.empty()) {
      std::ofstream(file) << script;
      chmod(file.c_str(), 0755);
    }
    setenv("PATH", script.empty() ? folder_.path.c_str() : (folder_.path + ":" + before_).c_str(), 1);
  }
  OwnGnuplot(const OwnGnuplot&) = delete;
  OwnGnuplot& operator=(const OwnGnuplot&) = delete;
  ~OwnGnuplot() {
    setenv("PATH", before_.c_str(), 1);
    std::filesystem::remove_all(folder_.path);
  }

 private:
  const ScratchFile folder_;
  const std::string before_;
};

/// Takes the bytes of standard error while it lives, also those that C writes.
class Overheard {
 public:
  Overheard() : file_("standard-error"), before_(dup(STDERR_FILENO)) {
    file_.write("");
    if (!std::freopen(file_.path.c_str(), "a", stderr)) FAIL("standard error cannot be moved");
  }
  Overheard(const Overheard&) = delete;
  Overheard& operator=(const Overheard&) = delete;
  ~Overheard() {
    std::fflush(stderr);
    dup2(before_, STDERR_FILENO);
    close(before_);
  }
  std::string text() const {
    std::fflush(stderr);
    return file_.text();
  }

 private:
  const ScratchFile file_;
  const int before_;
};

}  // namespace

TEST_CASE("a spread is the median and the ends of the middle eight tenths") {
  const Spread none = spread({});
  CHECK((none.low == 0 && none.median == 0 && none.high == 0));
  const Spread one = spread({7});
  CHECK((one.low == 7 && one.median == 7 && one.high == 7));
  const Spread eleven = spread({10, 0, 9, 1, 8, 2, 7, 3, 6, 4, 5});
  CHECK((eleven.low == 1 && eleven.median == 5 && eleven.high == 9));
  CHECK(spread({1, 2}).median == 1.5);
  // Runs that never arrive are infinitely wrong.
  const Spread lost = spread({1, infinite, infinite, infinite});
  CHECK((lost.median == infinite && lost.high == infinite));

  constexpr std::uint64_t seed = 1;
  Random draw(seed);
  for (int i = 0; i < 200; ++i) {
    INFO("draw " << i << " of seed " << seed);
    std::vector<double> numbers(static_cast<std::size_t>(draw.integer(1, 40)));
    for (double& x : numbers) x = draw.uniform(-5, 5);
    const Spread s = spread(numbers);
    const auto below = [&](double x) {
      return static_cast<double>(std::ranges::count_if(numbers, [&](double y) { return y < x - 1e-12; }));
    };
    const double last = static_cast<double>(numbers.size() - 1);
    CHECK(std::abs(below(s.low) - 0.1 * last) <= 1);
    CHECK(std::abs(below(s.median) - 0.5 * last) <= 1);
    CHECK(std::abs(below(s.high) - 0.9 * last) <= 1);
  }
}

TEST_CASE("a number has three digits, and a power of ten where it is very large or small") {
  CHECK(short_number(0) == "0");
  CHECK(short_number(1) == "1");
  CHECK(short_number(-0.12345) == "-0.123");
  CHECK(short_number(12.345) == "12.3");
  CHECK(short_number(1e-3) == "0.001");
  CHECK(short_number(9.99e-4) == "1.0e-03");
  CHECK(short_number(1.26e5) == "1.3e+05");
  CHECK(short_number(infinite) == "∞");
  CHECK(short_number(-infinite) == "–");
  CHECK(short_number(std::nan("")) == "–");
}

TEST_CASE("a count has two digits and commas") {
  CHECK(short_count(3) == "3");
  CHECK(short_count(1.25) == "1.2");
  CHECK(short_count(99) == "99");
  CHECK(short_count(100) == "100");
  CHECK(short_count(12345) == "12,000");
  CHECK(short_count(999.7) == "1,000");
  CHECK(short_count(1234567) == "1,200,000");
  CHECK(short_count(99.7) == "100");
}

TEST_CASE("a power has two decimals, and 0 has no sign") {
  CHECK(short_power(1.999) == "2.00");
  CHECK(short_power(-0.5) == "-0.50");
  CHECK(short_power(-0.001) == "0.00");
}

TEST_CASE("a time and a length have the unit in which they are at least one") {
  CHECK(short_time(2) == "2 s");
  CHECK(short_time(3.4e-7) == "340 ns");
  CHECK(short_time(1e-6) == "1 µs");
  CHECK(short_time(0.0123) == "12.3 ms");
  CHECK(short_time(1e-12) == "1.0e-03 ns");
  CHECK(short_time(0) == "0");
  CHECK(short_time(infinite) == "∞");
  CHECK(short_time(0.9999) == "1 s");
  CHECK(short_length(0.5) == "500 mm");
  CHECK(short_length(2e-9) == "2 nm");
  CHECK(short_length(3.2e-17) == "3.2e-17 m");
  CHECK(short_length(0) == "0");
  CHECK(short_length(0.9996e-6) == "1 µm");

  // Whatever the number, its words say it to within half of the last of three digits, and without a power of ten.
  constexpr std::uint64_t seed = 2;
  Random draw(seed);
  for (int i = 0; i < 2000; ++i) {
    const double x = draw.log_uniform(1e-9, 999);
    INFO("draw " << i << " of seed " << seed << ": " << x);
    const std::string words = short_time(x);
    const std::string unit = words.substr(words.find(' ') + 1);
    const double size = unit == "s" ? 1 : unit == "ms" ? 1e-3 : unit == "µs" ? 1e-6 : 1e-9;
    if (std::abs(std::stod(words) * size - x) > 0.00501 * x || words.find('e') != std::string::npos) FAIL(words);
  }
}

TEST_CASE("the time of a call is processor time, the least of its repeats") {
  int calls = 0;
  double sum = 0;
  const double one = seconds_of([&] {
    ++calls;
    for (int i = 1; i < 1000; ++i) sum += 1.0 / i;
  });
  CHECK(one > 0);
  CHECK(calls > 3);
  CHECK(sum > 0);
  // A long call is made once: it burns 6 ms of this thread.
  calls = 0;
  const double burnt = seconds_of([&] {
    ++calls;
    for (const double begin = app::cpu_seconds(); app::cpu_seconds() - begin < 6e-3;) continue;
  });
  CHECK(calls == 1);
  CHECK(burnt >= 6e-3);
}

TEST_CASE("a report says on which machine and from which commit it was made") {
  CHECK_THAT(machine(), Contains(" core") && Contains("; commit "));
}

TEST_CASE("panels that share an axis have one range that covers all that can be shown") {
  std::vector<Panel> panels{{"a", {"x"}, {"y", true}, {{"c", {at(0, 1), at(1, 10)}}}},
                            {"b", {"x"}, {"y", true}, {{"c", {at(4, 0), at(3, 1e6), at(2, infinite)}}}}};
  share_x(panels);
  share_y(panels);
  for (const Panel& p : panels) {
    REQUIRE((p.x.range && p.y.range));
    CHECK((p.x.range->low < 0 && p.x.range->low > -1));
    CHECK((p.x.range->high > 3 && p.x.range->high < 4));  // at 4 and 2 nothing can be shown
    CHECK((p.y.range->low < 1 && p.y.range->low > 0.1));
    CHECK((p.y.range->high > 1e6 && p.y.range->high < 1e7));
  }
  // A short logarithmic axis ends at whole decades, and an empty one has a range, too.
  std::vector<Panel> few{{"a", {"x"}, {"y", true}, {{"c", {at(2, 3), at(2, 40)}}}}},
      empty{{"a", {"x"}, {"y", true}, {}}};
  share_x(few);
  share_y(few);
  CHECK((few[0].x.range->low == 1.5 && few[0].x.range->high == 2.5));
  CHECK((few[0].y.range->low == 1 && few[0].y.range->high == 100));
  share_x(empty);
  share_y(empty);
  CHECK((empty[0].x.range->low < empty[0].x.range->high && empty[0].y.range->low > 0));
}

TEST_CASE("the script of a figure holds the points that its axes can show, and one legend") {
  Figure f = small_figure();
  f.panels[1].curves[0].points.push_back(at(-1, 5));
  f.panels[1].curves[0].points.push_back(at(5, infinite));
  const std::string script = gnuplot_script(f, "/tmp/a 'b'.svg");
  CHECK_THAT(script, Contains("set output '/tmp/a ''b''.svg'"));
  CHECK_THAT(script, Contains("0 1 0.5 1.5\n") && Contains("10 100 100 100\n"));
  CHECK_THAT(script, !Contains("-1 5 5 5") && !Contains("inf"));
  CHECK(count(script, "title \"ours\"") == 1);
  CHECK(count(script, "title \"another\"") == 1);
  CHECK(count(script, "filledcurves") == 1);  // one curve has a band
  CHECK(count(script, "\nset logscale x") == 1);
  CHECK(script.find("title \"ours\"") < script.find("title \"another\""));
  f.names = {"another"};
  const std::string other = gnuplot_script(f, "a.svg");
  CHECK(other.find("title \"another\"") < other.find("title \"ours\""));
  CHECK(count(script, "set title \"one\"") == 1);
}

TEST_CASE("a panel that is a legend has its names for itself, and axes of names show them") {
  Figure f = small_figure();
  Panel legend;
  legend.legend = {"ours"};
  f.panels.push_back(legend);
  f.panels[0].y.names = {"first_name", "second"};
  const std::string script = gnuplot_script(f, "a.svg");
  CHECK(count(script, "title \"ours\"") == 1);
  CHECK(script.find("title \"ours\"") < script.find("title \"another\""));  // that of the panel comes before the strip
  CHECK_THAT(script, Contains("set ytics (\"first\\\\_name\" 0, \"second\" -1)"));
}

TEST_CASE("gnuplot draws the script, also where texts hold its own signs") {
  try {
    find_gnuplot();
  } catch (const DrawingError&) {
    WARN("there is no gnuplot");
    return;
  }
  const ScratchFile script("figure.gnuplot"), svg("figure 'quoted' `x`.svg");
  Figure f = small_figure();
  f.panels[0].title = R"(a_b^c {d} "e" @ & ~)";
  f.panels[0].curves.push_back({"none", {}});
  script.write(gnuplot_script(f, svg.path));
  run_gnuplot(script.path);
  CHECK_THAT(svg.text(), Contains("<svg") && Contains("</svg>") && Contains("width=\"960\""));
  std::string text = svg.text();
  for (const char* part : {">a_b^c", ">ours<", ">another<", ">two<"}) {
    INFO(part);
    CHECK(text.find(part) != std::string::npos);
  }
}

TEST_CASE("a gnuplot that is missing or fails is told in one line") {
  {
    const OwnGnuplot missing("");
    CHECK_THROWS_WITH(find_gnuplot(), Contains("gnuplot is not installed") && Contains("gnuplot-nox"));
    CHECK_THROWS_AS(run_gnuplot("a.gnuplot"), DrawingError);
  }
  {
    const OwnGnuplot fails("#!/bin/sh\nexit 3\n");
    CHECK_THROWS_WITH(find_gnuplot(), Contains("does not run"));
    CHECK_THROWS_WITH(run_gnuplot("a.gnuplot"), Contains("cannot draw a.gnuplot"));
  }
  const ScratchFile seen("arguments");
  const OwnGnuplot works("#!/bin/sh\necho \"$@\" > '" + seen.path + "'\n");
  CHECK_NOTHROW(find_gnuplot());
  CHECK(seen.text() == "--version\n");
  CHECK_NOTHROW(run_gnuplot("a b.gnuplot"));
  CHECK(seen.text() == "a b.gnuplot\n");
}

TEST_CASE("the page shows each section with its question, figure, table, data and conclusion") {
  const Page page = small_page();
  const std::string figure = "<?xml version=\"1.0\"?>\n<svg id=\"gnuplot_canvas\"><g id=\"gpPt0\"/></svg>\n";
  const std::string html = to_html(page, {figure, figure});
  CHECK_THAT(html, Contains("First &lt;section&gt;") && Contains("Is a &amp; b?") && Contains("machine &amp; commit"));
  CHECK(count(html, "<section id=") == 2);
  CHECK(count(html, "href=\"#1-first\"") == 1);
  CHECK(count(html, "<figcaption>What is &quot;seen&quot;.</figcaption>") == 2);
  CHECK(count(html, "href=\"1-first-more.csv\"") == 2);
  CHECK_THAT(html, !Contains("<?xml") && !Contains("gnuplot_canvas"));
  // No identifier occurs twice, although both figures had the same.
  for (const char* id :
       {"id=\"1-first-canvas\"", "id=\"2-second-canvas\"", "id=\"1-firstgpPt0\"", "id=\"2-secondgpPt0\""}) {
    INFO(id);
    CHECK(count(html, id) == 1);
  }
  // The first column tells its text only where it changes.
  CHECK(count(html, "<td class=\"text\">a</td>") == 2);
  CHECK(count(html, "<tr class=\"group\">") == 4);
  CHECK(count(html, "<td>3</td>") == 2);
  CHECK(count(to_html(page, {"", figure}), "<figure>") == 1);
}

TEST_CASE("the page in Markdown links to its figures and keeps its tables whole") {
  const Page page = small_page();
  const std::string text = to_markdown(page, {"<svg/>", ""});
  CHECK(count(text, "\n## ") == 2);
  CHECK_THAT(text, Contains("## 2. Second\n"));
  CHECK(count(text, "![") == 1);
  CHECK_THAT(text, Contains("![First <section>](figures/1-first.svg)"));
  CHECK_THAT(text,
             Contains("| group | what | n\\|m |\n|---|---|---:|\n| a | x<y | 1 |\n| a | z | 2 |\n| b | x\\|y | 3 |\n"));
  CHECK(count(text, "[1-first-more.csv](1-first-more.csv)") == 2);
  CHECK(count(text, "**Conclusion.** It is.") == 2);
}

TEST_CASE("progress is shown to nobody who is no terminal") {
  const Overheard overheard;
  {
    Progress progress(2);
    progress.begin("one", 3);
    for (int i = 0; i < 3; ++i) progress.step();
    progress.begin("two", 0);
    progress.step();
  }
  CHECK(overheard.text().empty());
}
