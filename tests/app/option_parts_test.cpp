// SPDX-License-Identifier: MIT
//
// The command line: the commands, their options and what the manual says of both, and the flags that ask for pictures.
#include "app/commands.hpp"
#include "app/manual/options.hpp"
#include "app/options.hpp"
#include "app/picture.hpp"
#include "app/solve/solve.hpp"
#include "app/still_working.hpp"

#include <algorithm>
#include <atomic>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "app/scratch_file.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::app;
using Catch::Contains;
using test::ScratchFile;

namespace {

constexpr const char* small_svg =
    R"(<svg xmlns="http://www.w3.org/2000/svg" width="30" height="20"><rect width="30" height="20"/></svg>)";

/// Returns what is wrong with a command line; empty if nothing is.
std::string wrong(CLI::App& app, const std::string& line) {
  try {
    app.parse(line);
  } catch (const CLI::ParseError& e) {
    return e.what();
  }
  return "";
}

/// Parses one line by a command line that `add` completes; returns what is wrong with it.
template <class Add>
std::string wrong_of(const Add& add, const std::string& line) {
  CLI::App app("test", "test");
  add(app);
  return wrong(app, line);
}

/// One variable of every kind that an option can have.
struct Wanted {
  bool flag = false;
  std::string text, with_default = "usual";
  long count = -1;
  double number = 0;
  std::vector<double> pair{0, 0};
  std::vector<int> sizes{0, 0, 0};

  std::vector<service::Option> options() {
    return {{"flag", &flag, "a flag"},
            {"text", &text, "a text"},
            {"word", &with_default, "a text with a default", {}, false, "text"},
            {"count", &count, "a whole number"},
            {"number", &number, "a number", Range{-1, 2}, true},
            {"pair", &pair, "two numbers", Range{0, 10}},
            {"sizes", &sizes, "three whole numbers", Range{1, 9}}};
  }
};

std::string wrong_of(Wanted& wanted, const std::string& line) {
  return wrong_of([&](CLI::App& app) { add_options(app, wanted.options()); }, line);
}

const manual::Option& named(const std::vector<manual::Option>& all, const std::string& name) {
  const auto has = [&](const manual::Option& o) { return o.place == name || std::ranges::count(o.names, name) > 0; };
  const auto found = std::ranges::find_if(all, has);
  REQUIRE(found != all.end());
  return *found;
}

}  // namespace

TEST_CASE("every command adds itself under its name, with examples that call it and its exit codes") {
  CLI::App app("test", "bankshot");
  std::map<std::string, app::Run> commands;
#define BANKSHOT_ADD(name) commands[#name] = name::add(app);
  BANKSHOT_COMMANDS(BANKSHOT_ADD)
#undef BANKSHOT_ADD
  CHECK(commands.size() >= 15);
  CHECK(manual::commands(app).size() == commands.size());
  for (const CLI::App* command : manual::commands(app)) {
    const std::string name = command->get_name();
    INFO(name);
    REQUIRE(commands.contains(name));
    CHECK(commands.at(name));
    CHECK(!command->get_description().empty());
    CHECK_THAT(command->get_footer(), Contains("bankshot " + name) && Contains("\nExit codes: 0"));
  }
}

TEST_CASE("the words of examples stand below each other, or on a line of their own after a long one") {
  CLI::App app("test", "test");
  const std::string longest(62, 'x'), longer(63, 'y');
  explain(app, "About it.", {{"short", "what one"}, {longest, "what two"}, {longer, "what three"}}, "0 done.");
  const std::string footer = app.get_footer();
  CHECK(footer.starts_with("About it.\n\nExamples:\n"));
  CHECK(footer.ends_with("\n\nExit codes: 0 done."));
  for (const char* what : {"what one", "what two", "what three"}) {
    INFO(what);
    const std::size_t at = footer.find(what);
    REQUIRE(at != std::string::npos);
    CHECK(at - footer.rfind('\n', at) == 1 + 2 + 62 + 2);
  }
  CHECK_THAT(footer, Contains("  " + longer + "\n"));
  CLI::App narrow("test", "test");
  explain(narrow, "", {{"a", "first"}, {"abc", "second"}}, "");
  CHECK_THAT(narrow.get_footer(), Contains("  a    first\n  abc  second\n"));
}

TEST_CASE("an option of a request sets its variable by the name after two dashes") {
  Wanted w;
  CHECK(wrong_of(w, "--flag --text abc --count 12 --number -0.5 --pair 1.5,2 --sizes 1,2,9").empty());
  CHECK(w.flag);
  CHECK(w.text == "abc");
  CHECK(w.with_default == "usual");
  CHECK(w.count == 12);
  CHECK(w.number == -0.5);
  CHECK(w.pair == std::vector<double>{1.5, 2});
  CHECK(w.sizes == std::vector<int>{1, 2, 9});
}

TEST_CASE("a value outside its range or of another kind is refused by the name of its option") {
  const auto [line, name] = GENERATE(table<std::string, std::string>({{"--number 2.1", "--number"},
                                                                      {"--number x", "--number"},
                                                                      {"--number 1 --count -3", "--count"},
                                                                      {"--number 1 --count 1.5", "--count"},
                                                                      {"--number 1 --pair 1", "--pair"},
                                                                      {"--number 1 --pair 1,11", "--pair"},
                                                                      {"--number 1 --pair 1,2,3", "--pair"},
                                                                      {"--number 1 --sizes 1,2.5,3", "--sizes"},
                                                                      {"--number 1 --sizes 0,1,1", "--sizes"},
                                                                      {"--count 3", "--number"},
                                                                      {"--number 1 --text a --word b", "--text"},
                                                                      {"--number 1 --other", "--other"}}));
  Wanted w;
  INFO(line);
  CHECK_THAT(wrong_of(w, line), Contains(name));
}

TEST_CASE("the manual knows the options of a command in their order, without hidden ones") {
  CLI::App app("test", "test");
  CLI::App* const command = app.add_subcommand("go", "Goes");
  app.add_subcommand("stay", "Stays");
  std::string file, hidden, theme = "light", place, other;
  int jobs = 3;
  bool quiet = false;
  command->add_option("command", other, "The command");
  command->add_option("FILE", place, "The input");
  command->add_option("-o,--output", file, "The output");
  command->add_option("--secret", hidden, "Hidden")->group("");
  command->add_option("--jobs", jobs, "Threads")->capture_default_str();
  command->add_option("--theme", theme, "Colours")->check(CLI::IsMember({"light", "dark"}));
  command->add_flag("-q,--quiet", quiet, "No words");
  const std::vector<manual::Option> all = manual::options(*command);
  REQUIRE(all.size() == 7);
  const manual::Option &output = named(all, "--output"), &flag = named(all, "-q");
  CHECK(&named(all, "--help") == &all.front());
  CHECK(&output < &named(all, "--jobs"));
  CHECK(output.names == std::vector<std::string>{"-o", "--output"});
  CHECK(output.place.empty());
  CHECK(output.value == "TEXT");
  CHECK(output.meaning == "The output");
  CHECK(output.choices.empty());
  CHECK(flag.names == std::vector<std::string>{"-q", "--quiet"});
  CHECK(flag.value.empty());
  CHECK(named(all, "--jobs").fallback == "3");
  CHECK(named(all, "--theme").choices == std::vector<std::string>{"light", "dark"});
  CHECK(named(all, "--theme").value == "TEXT");
  CHECK(named(all, "FILE").names.empty());
  // An argument that is a command takes the names of all commands.
  CHECK(named(all, "command").choices == std::vector<std::string>{"go", "stay"});
}

TEST_CASE("a picture is an SVG as it stands, or a PNG of twice its size") {
  const ScratchFile svg("small.svg"), png("small.png");
  write_picture(svg.path, small_svg);
  CHECK(svg.text() == small_svg);
  if (!picture_name(png.path).empty()) {  // built without librsvg
    CHECK_THROWS_WITH(write_picture(png.path, small_svg), Contains("librsvg"));
    return;
  }
  write_picture(png.path, small_svg);
  const std::string bytes = png.text();
  REQUIRE(bytes.size() > 24);
  CHECK(bytes.substr(1, 3) == "PNG");
  CHECK(bytes.substr(16, 8) == std::string("\0\0\0\x3c\0\0\0\x28", 8));  // 60 and 40 pixels
  CHECK_THROWS_AS(write_picture(png.path, "no picture"), WriteError);
  CHECK_THROWS_WITH(write_picture("/no such folder/a.png", small_svg), Contains("/no such folder/a.png"));
  CHECK_THROWS_AS(write_picture("/no such folder/a.svg", small_svg), WriteError);
}

TEST_CASE("a table is a file that ends in .csv, packed or not") {
  CHECK(is_table("a.csv"));
  CHECK(is_table("a.csv.gz"));
  CHECK(!is_table("a.svg"));
  CHECK(!is_table("csv"));
  CHECK(!is_table("a.csv.svg"));
}

TEST_CASE("no picture is written to standard output or to the name of an option") {
  CHECK(picture_name("a.svg").empty());
  CHECK(!picture_name("-").empty());
  CHECK(!picture_name("--json").empty());
}

TEST_CASE("an output is a table or a picture by its suffix, and each kind is made for its files alone") {
  std::vector<std::string> files;
  const auto add = [&](CLI::App& app) { add_output_option(app, files, "the map"); };
  CHECK_THAT(wrong_of(add, ""), Contains("--output"));
  CHECK_THAT(wrong_of(add, "-o a.txt"), Contains("must end in .svg, .png or .csv"));
  CHECK_THAT(wrong_of(add, "-o --json"), Contains("--output"));
  files.clear();
  CHECK(wrong_of(add, "-o a.csv --output b.svg -o c.csv.gz").empty());
  CHECK(files == std::vector<std::string>{"a.csv", "b.svg", "c.csv.gz"});

  const ScratchFile table("made.csv"), picture("made.svg");
  int tables = 0, pictures = 0;
  const auto write = [&](const std::vector<std::string>& names) {
    write_outputs(
        names, [&] { return ++tables, "x,y\n"; }, [&] { return ++pictures, small_svg; });
  };
  write({table.path});
  CHECK((tables == 1 && pictures == 0));
  write({picture.path, table.path});
  CHECK((tables == 2 && pictures == 1));
  CHECK(table.text() == "x,y\n");
  CHECK(picture.text() == small_svg);
}

TEST_CASE("pictures are drawn only if a flag asks for them, in its theme and movement") {
  const auto asked = [](PictureFlags& flags, const std::string& line) {
    return wrong_of([&](CLI::App& app) { add_picture_flags(app, flags); }, line);
  };
  PictureFlags none;
  CHECK(asked(none, "").empty());
  int drawn = 0;
  const auto draw = [&](const PictureStyle& style) {
    ++drawn;
    return std::string(style.theme == Theme::dark ? "dark" : "light") + (style.moving ? " moving" : " still");
  };
  none.write(draw);
  CHECK(drawn == 0);

  const ScratchFile svg("drawn.svg");
  PictureFlags flags;
  CHECK(asked(flags, "--svg " + svg.path + " --theme dark --animate").empty());
  flags.write(draw);
  CHECK(drawn == 1);
  CHECK(svg.text() == "dark moving");

  PictureFlags refused;
  CHECK_THAT(asked(refused, "--svg a.png"), Contains("that is --png"));
  CHECK_THAT(asked(refused, "--png a.svg"), Contains("must end in .png"));
  CHECK_THAT(asked(refused, "--svg --animate"), Contains("--svg"));
  CHECK_THAT(asked(refused, "--theme blue"), Contains("--theme"));
}

TEST_CASE("the theme is one of two names, whose list the manual can show") {
  CLI::App app("test", "test");
  Theme theme = Theme::light;
  add_theme_flag(app, theme);
  const manual::Option option = named(manual::options(app), "--theme");
  CHECK(option.choices == std::vector<std::string>{"light", "dark"});
  CHECK(option.fallback == "light");
  CHECK(wrong(app, "--theme dark").empty());
  CHECK(theme == Theme::dark);
}

TEST_CASE("who waits long is told so once, and who does not wait is not") {
  struct Told : std::stringbuf {
    std::atomic<bool> flushed = false;
    int sync() override {
      flushed = true;
      flushed.notify_all();
      return 0;
    }
  } told;
  std::ostream said(&told);
  {
    const StillWorking waits(said, std::chrono::milliseconds(1));
    told.flushed.wait(false);
  }
  CHECK(told.str() == "bankshot: still working; Ctrl-C ends it\n");
  std::ostringstream nothing;
  { const StillWorking waits(nothing); }
  CHECK(nothing.str().empty());
}

TEST_CASE("`solve` and `play` take the same options of an answer") {
  CLI::App command;
  bankshot::app::solve::Arguments a;
  bankshot::app::solve::add_arguments(command, a);
  command.parse("--depth 2 --plies 2 --json --budget 7");
  CHECK(a.json);
  CHECK(a.flags.solve_options().depth == 2);
  CHECK(a.flags.budget == 7);
  CHECK(a.flags.solve_options().plies == 2);
  CHECK(a.flags.words().find("--depth 2 --plies 2") != std::string::npos);
}
