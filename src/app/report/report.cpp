// SPDX-License-Identifier: MIT
//
// `report`: measures, section by section, and writes a page, its figures and its numbers into a folder.
#include <fmt/format.h>

#include <filesystem>
#include <iostream>

#include "app/commands.hpp"
#include "app/files.hpp"
#include "app/option_checks.hpp"
#include "app/report/sections.hpp"

namespace bankshot::app::report {
namespace {

struct Arguments {
  std::string folder;
  bool quick = false;
  int shots = 0;
};

constexpr int full_shots = 40, quick_shots = 10;

using Measure = Section (*)(const Settings&, Progress&);
constexpr Measure parts[] = {simulators, models, planners, conditioning, hard_cases, scaling, tilt};

void make_folder(const std::filesystem::path& folder) {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) throw FileError(fmt::format("{}: cannot be made a folder: {}", folder.string(), problem.message()));
}

/// The figure of each section, drawn by gnuplot if there is one; its script in any case.
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

/// Says at once, not after minutes, that there will be no figures.
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

std::vector<Section> measure_all(const std::filesystem::path& folder, const Settings& settings) {
  std::vector<Section> out;
  Progress progress(static_cast<int>(std::size(parts)));
  for (const Measure measure : parts) {
    out.push_back(measure(settings, progress));
    for (const Csv& c : out.back().data) write_file((folder / (c.name + ".csv")).string(), c.text);
  }
  return out;
}

int run(const Arguments& a) {
  const std::filesystem::path folder(a.folder);
  make_folder(folder / "figures");
  const bool gnuplot = has_gnuplot();
  const Settings settings{a.quick, a.shots > 0 ? a.shots : a.quick ? quick_shots : full_shots};
  const Page page{fmt::format("{}; {} run, {} shots a point", machine(), a.quick ? "quick" : "full", settings.shots),
                  measure_all(folder, settings)};
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
  command->add_flag("--quick", a->quick, "Fewer shots and coarser ranges: under a minute");
  command->add_option("--shots", a->shots, "Shots a point of a curve")->group("");  // for tests
  explain(*command, "The page opens offline. Every figure has its CSV beside it; docs/csv.md has their columns.",
          {{"bankshot report -o report --quick", "in under a minute"}},
          "0 done; 2 bad usage, or a file cannot be written.");
  return [a] { return run(*a); };
}

}  // namespace bankshot::app::report
