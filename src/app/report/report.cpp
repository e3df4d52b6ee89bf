// SPDX-License-Identifier: MIT
//
// `report`: measures, section by section, and writes a page, its figures and its numbers into a folder.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iostream>
#include <utility>

#include "app/commands.hpp"
#include "app/files.hpp"
#include "app/option_checks.hpp"
#include "app/read_each.hpp"
#include "app/report/sections.hpp"
#include "bankshot/scene/recording.hpp"

namespace bankshot::app::report {
namespace {

struct Arguments {
  std::string folder, recordings;
  std::vector<std::string> sections;
  bool quick = false;
  int shots = 0;
};

constexpr int full_shots = 40, quick_shots = 10;

struct Part {
  const char* name;
  std::function<Section(const Settings&, Progress&)> measure;
};

std::vector<Recording> read_recordings(const std::string& file) {
  long bad = 0;
  auto out = read_each(
      file, [](const std::string& line) { return read_recording(line); }, bad);
  tell_left_out(bad, out.size());
  for (const Recording& r : out)
    if (!carries_spin(r.scene.physics))
      throw FileError(file + ": laws of cushions are told apart in physics with spin");
  if (out.empty()) throw FileError(file + ": no recording in it");
  return out;
}

/// The sections in the page's order, except that of recordings, which comes last.
constexpr std::pair<const char*, Section (*)(const Settings&, Progress&)> always[] = {
    {"simulators", simulators}, {"models", models},   {"planners", planners}, {"conditioning", conditioning},
    {"hard-cases", hard_cases}, {"scaling", scaling}, {"tilt", tilt}};
constexpr const char* of_recordings = "recorded";

std::vector<std::string> part_names() {
  std::vector<std::string> out;
  for (const auto& part : always) out.push_back(part.first);
#if BANKSHOT_LEARN
  out.push_back(of_recordings);
#endif
  return out;
}

/// Returns the sections asked for, or all if none was.
std::vector<Part> parts_of(const Arguments& a, const std::vector<Recording>& recordings) {
  std::vector<Part> out;
  const auto asked = [&](const char* name) { return std::ranges::find(a.sections, name) != a.sections.end(); };
  const auto add = [&](const Part& part) {
    if (a.sections.empty() || asked(part.name)) out.push_back(part);
  };
  for (const auto& [name, measure] : always) add({name, measure});
#if BANKSHOT_LEARN
  if (!recordings.empty())
    add({of_recordings, [&](const Settings& s, Progress& progress) { return recorded(recordings, s, progress); }});
#endif
  if (recordings.empty() && asked(of_recordings)) throw FileError("the section recorded needs --recordings");
  return out;
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) throw FileError(fmt::format("{}: cannot be made a folder: {}", folder.string(), problem.message()));
}

/// Writes the gnuplot script of each section, and returns the figures if gnuplot can draw them.
std::vector<std::string> draw(const std::filesystem::path& folder, const std::vector<Section>& sections, bool gnuplot) {
  std::vector<std::string> out;
  for (const Section& s : sections) {
    const std::string base = (folder / "figures" / s.name).string();
    write_file(base + ".gp", gnuplot_script(s.figure, base + ".svg"));
    if (gnuplot) run_gnuplot(base + ".gp");
    out.push_back(gnuplot ? read_file(base + ".svg") : "");
  }
  return out;
}

/// Looks for gnuplot; reports at once, and not after minutes, that there will be no figures.
bool has_gnuplot() {
  try {
    find_gnuplot();
    return true;
  } catch (const DrawingError& e) {
    std::cerr << "bankshot: " << one_line(e.what())
              << ": there will be report.md and CSV files, but no figures and no index.html\n";
    return false;
  }
}

std::vector<Section> measure_all(const std::filesystem::path& folder, const std::vector<Part>& parts,
                                 const Settings& settings) {
  std::vector<Section> out;
  Progress progress(static_cast<int>(parts.size()));
  for (const Part& part : parts) {
    out.push_back(part.measure(settings, progress));
    for (const Csv& c : out.back().data) write_file((folder / (c.name + ".csv")).string(), c.text);
  }
  return out;
}

int run(const Arguments& a) {
  const auto recordings = a.recordings.empty() ? std::vector<Recording>() : read_recordings(a.recordings);
  const std::vector<Part> parts = parts_of(a, recordings);
  const std::filesystem::path folder(a.folder);
  make_folder(folder / "figures");
  const bool gnuplot = has_gnuplot();
  const Settings settings{a.quick, a.shots > 0 ? a.shots : a.quick ? quick_shots : full_shots};
  const Page page{fmt::format("{}; {} run, {} shots per point", machine(), a.quick ? "quick" : "full", settings.shots),
                  measure_all(folder, parts, settings)};
  const std::vector<std::string> figures = draw(folder, page.sections, gnuplot);
  write_file((folder / "report.md").string(), to_markdown(page, figures));
  if (gnuplot) write_file((folder / "index.html").string(), to_html(page, figures));
  for (const Section& s : page.sections) print(fmt::format("{}: {}\n", s.title, s.conclusion));
  return gnuplot ? done : bad_input;
}

}  // namespace

Run add(CLI::App& app) {
  auto a = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("report", "Measure speed against error: simulators and planners");
  command->add_option("-o,--output", a->folder, "The folder to write index.html, report.md, figures and CSV files into")
      ->required()
      ->check(file_name);
  command->add_flag("--quick", a->quick, "Use fewer shots and coarser ranges: under a minute");
#if BANKSHOT_LEARN
  command->add_option("--recordings", a->recordings,
                      "Recordings, one per line; an extra section says which cushion law explains them");
#endif
  command->add_option("--sections", a->sections, "Measure these sections alone")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(part_names()));
  command->add_option("--shots", a->shots, "Shots per point of a curve")->group("");  // for tests
  explain(
      *command, "The page opens offline. Every figure has its CSV beside it; docs/csv.md describes their columns.",
      {
        {"bankshot report -o report --quick", "in under a minute"},
#if BANKSHOT_LEARN
        {
          "bankshot report -o report --quick --recordings recordings.jsonl --sections recorded",
              "models against real shots"
        }
#endif
      },
      "0 done; 2 bad usage, or a file cannot be written.");
  return [a] { return run(*a); };
}

}  // namespace bankshot::app::report
