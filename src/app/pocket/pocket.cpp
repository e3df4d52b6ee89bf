// SPDX-License-Identifier: MIT
//
// bankshot pocket: the acceptance window of a pocket.
#include <fmt/format.h>

#include <algorithm>

#include "app/commands.hpp"
#include "app/files.hpp"
#include "app/picture.hpp"
#include "bankshot/draw/acceptance.hpp"
#include "bankshot/simulate/acceptance.hpp"
#include "io/json/reader.hpp"
#include "service/scene_words.hpp"

namespace bankshot::app::pocket {
namespace {

struct Arguments {
  std::string table, pocket;
  std::vector<double> speeds{1, 3};
  std::vector<std::string> out;
  Theme theme = Theme::light;
};

int find_pocket(const Table& table, const std::string& name) {
  if (table.pockets.empty()) throw FileError("this table has no pockets");
  std::vector<std::string_view> names;
  for (const Pocket& p : table.pockets) names.push_back(p.name);
  const auto it = std::ranges::find(names, name);
  if (it == names.end()) throw FileError(fmt::format("{} is no pocket{}", quote(name), known_words(name, names)));
  return static_cast<int>(it - names.begin());
}

/// Returns, for each direction and speed, the width of the strip of parallel lines on which a ball drops.
std::string summary(const std::vector<Acceptance>& windows) {
  constexpr int each = 10;  // degrees
  std::string out = "mm of parallel lines that drop: clean, and with those off a jaw or a rail\n  angle";
  for (const Acceptance& w : windows) out += fmt::format("{:>18}", fmt::format("{:g} m/s", w.speed));
  out += '\n';
  const int most = windows.front().steepest / each * each;
  for (int degree = -most; degree <= most; degree += each) {
    out += fmt::format("{:>6}°", degree);
    for (const Acceptance& w : windows)
      out +=
          fmt::format("{:>10.1f}{:>8.1f}", 1e3 * w.width(degree, Entry::clean), 1e3 * w.width(degree, Entry::rattles));
    out += '\n';
  }
  return out;
}

int run(const Arguments& a) {
  const Scene scene = service::read_scene_words(a.table, "spin");
  const int pocket = find_pocket(scene.table, a.pocket);
  for (const std::string& path : a.out) write_file(path, "");
  std::vector<Acceptance> windows;
  for (const double speed : a.speeds) windows.push_back(acceptance(scene, pocket, speed));
  write_outputs(
      a.out, [&] { return to_csv(windows); }, [&] { return draw(scene, pocket, windows, a.theme); });
  print(summary(windows));
  return done;
}

}  // namespace

Run add(CLI::App& app) {
  auto a = std::make_shared<Arguments>();
  constexpr double slowest = 0.01, fastest = 30;  // m/s
  CLI::App* command = app.add_subcommand("pocket", "Show which lines of a ball a pocket takes");
  command->add_option("table", a->table, "A table by its name or as JSON")->required();
  command->add_option("pocket", a->pocket, "One of its pockets, such as top-left")->required();
  command->add_option("--speed", a->speeds, "Speeds of the ball, three mouths before the pocket [m/s]")
      ->check(CLI::Range(slowest, fastest))
      ->capture_default_str();
  add_output_option(*command, a->out, "a picture");
  add_theme_flag(*command, a->theme);
  explain(
      *command,
      "Balls roll at the pocket along straight lines: in directions a degree apart, from straight out of the table,\n"
      "anticlockwise; and with offsets half a millimetre apart, from the middle of what captures, to the left of the\n"
      "line of travel. Each is simulated: clean, off a jaw or a rail and in, off a jaw and out, or past.",
      {{"bankshot pocket pool-9ft bottom-left -o corner.svg", "a corner at 1 and 3 m/s"},
       {"bankshot pocket pool-9ft top-middle --speed 0.5 1 2 -o middle.csv", "as a table"},
       {R"(bankshot pocket '{"preset": "pool-9ft", "jaws": false}' top-left -o circle.svg)", "a plain circle"}},
      "0 done; 2 bad input or usage.");
  return [a] { return run(*a); };
}

}  // namespace bankshot::app::pocket
