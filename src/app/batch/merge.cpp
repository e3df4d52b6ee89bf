// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <vector>

#include "app/batch/output.hpp"
#include "app/batch/part_record.hpp"
#include "app/batch/tally.hpp"
#include "app/commands.hpp"
#include "app/files.hpp"
#include "app/gzip.hpp"

namespace bankshot::app::merge {
namespace {

using batch::PartRecord;

struct Arguments {
  std::vector<std::string> parts;
  std::string output;
  bool quiet = false;
};

struct Found {
  std::string path;
  PartRecord record;
};

/// Writes numbers as Slurm does: 0-3,7,9-11.
std::string as_array(const std::vector<long>& numbers) {
  std::string out;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    out += fmt::format("{}{}", out.empty() ? "" : ",", numbers[i]);
    if (last > i) out += fmt::format("-{}", numbers[last]);
    i = last + 1;
  }
  return out;
}

/// Returns the parts in order, each once. `damaged` gets the numbers of those that must be made again.
std::vector<Found> found_parts(const Arguments& a, std::vector<long>& damaged) {
  std::vector<Found> found;
  for (const std::string& path : a.parts) {
    auto record = batch::read_part(path);
    if (!record)
      throw FileError(
          fmt::format("{}: is no part: {} is missing, which stands beside a part that is whole; copy it too, or make "
                      "the part again",
                      path, PartRecord::path_for(path)));
    found.push_back({path, *record});
  }
  const PartRecord& first = found.front().record;
  for (const auto& [path, record] : found) {
    if (record.part.n != first.part.n)
      throw FileError(fmt::format("{} is one of {} parts, and {} one of {}", path, record.part.n, found.front().path,
                                  first.part.n));
    if (record.flags != first.flags)
      throw FileError(fmt::format("{} was made with other flags than {}: {}; {}", path, found.front().path,
                                  record.flags, first.flags));
    if (batch::is_whole(path, record)) continue;
    std::cerr << fmt::format("bankshot: {}: is not what part {} wrote\n", path, record.part.k);
    damaged.push_back(record.part.k);
  }
  std::ranges::stable_sort(found, {}, [](const Found& f) { return f.record.part.k; });
  for (std::size_t i = 1; i < found.size(); ++i)
    if (found[i].record.part.k == found[i - 1].record.part.k)
      throw FileError(
          fmt::format("{} and {} are both part {}", found[i - 1].path, found[i].path, found[i].record.part.k));
  return found;
}

/// Throws FileError if parts are missing or damaged, and says which to make again.
void check_whole(const std::vector<Found>& found, std::vector<long> again) {
  const long n = found.front().record.part.n;
  for (long k = 0; k < n; ++k)
    if (!std::ranges::binary_search(found, k, {}, [](const Found& f) { return f.record.part.k; })) again.push_back(k);
  std::ranges::sort(again);
  if (!again.empty())
    throw FileError(fmt::format("{} of {} parts are missing or damaged; make them again with --array={}", again.size(),
                                n, as_array(again)));
  for (std::size_t i = 1; i < found.size(); ++i)
    if (found[i - 1].record.to != found[i].record.from)
      throw FileError(fmt::format("{} does not go on where {} ends: they are of different inputs", found[i].path,
                                  found[i - 1].path));
}

/// Writes the same gzip members as a single batch would.
void write_packed(const std::vector<Found>& found, batch::Output& out) {
  std::string text;
  std::size_t lines = 0;
  const auto flush = [&] {
    if (lines > 0) out.write(gzipped(text));
    text.clear();
    lines = 0;
  };
  for (const Found& part : found) {
    batch::LineReader in(part.path, true);
    for (batch::Lines more; in.next(more);)
      for (std::size_t i = 0; i < more.lines.size(); ++i) {
        text.append(more.line(i)).push_back('\n');
        if (++lines == batch::LineReader::lines_a_chunk) flush();
      }
  }
  flush();
  if (out.written() == 0) out.write(gzipped(""));
}

int run(const Arguments& a) {
  std::vector<long> damaged;
  const std::vector<Found> found = found_parts(a, damaged);
  check_whole(found, damaged);
  for (const Found& part : found) {
    std::error_code unknown;
    if (std::filesystem::equivalent(part.path, a.output, unknown))
      throw FileError(fmt::format("{}: is a part too, and would be overwritten", a.output));
  }
  const std::string partial = a.output + (is_packed(a.output) ? ".partial.gz" : ".partial");
  batch::Output out(partial);
  out.cut(0);
  if (out.gzip()) {
    write_packed(found, out);
  } else {
    for (const Found& part : found) {
      ByteReader in(part.path);
      for (std::string_view piece; !(piece = in.next()).empty();) out.write(piece);
    }
  }
  out.finish();
  batch::put_in_place(partial, a.output);
  if (!a.quiet) {
    long lines = 0, invalid = 0;
    for (const Found& part : found) lines += part.record.output.lines, invalid += part.record.invalid;
    std::cerr << fmt::format("{} answer{} of {} parts{}\n", batch::grouped(lines), lines == 1 ? "" : "s", found.size(),
                             invalid > 0 ? fmt::format(", {} invalid", batch::grouped(invalid)) : "");
  }
  return done;
}

}  // namespace

Run add(CLI::App& app) {
  auto a = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("merge", "Put the parts of a batch together");
  explain(*command,
          "Parts are what `bankshot batch --part K/N` wrote, in any order. Each is checked against the file .part\n"
          "beside it: it must be whole and of the same input and flags, and no part may be missing. A message names\n"
          "missing or damaged parts as a Slurm array. The result has the bytes of a batch in one go. It appears whole\n"
          "or not at all.",
          {{"bankshot merge shots-*.jsonl -o shots.jsonl", "all parts, in their order"}},
          "0 done; 2 a part is missing, damaged or of another batch.");
  command->add_option("parts", a->parts, "The outputs of the parts; *.gz is unpacked")->required();
  command->add_option("-o,--output", a->output, "Write the answers here; *.gz is packed")->required();
  command->add_flag("--quiet", a->quiet, "Write nothing but errors to standard error");
  return [a] { return run(*a); };
}

}  // namespace bankshot::app::merge
