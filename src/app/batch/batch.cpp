// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <thread>

#include "app/batch/part_record.hpp"
#include "app/batch/pipeline.hpp"
#include "app/batch/rows.hpp"
#include "app/commands.hpp"
#include "app/files.hpp"
#include "app/gzip.hpp"
#include "app/interrupt.hpp"
#include "app/option_checks.hpp"
#include "app/options.hpp"

namespace bankshot::app::batch {
namespace {

constexpr int by_signal = 128;  ///< an exit code of 128 + n means that signal n ended the program

struct Arguments {
  std::string file, output = "-", cost, csv;
  service::SolveFlags flags;
  int threads = 0;
  std::optional<Part> part{};  ///< the only part of the input to solve, if set
  bool resume = false, quiet = false, strict = false, json = true;
};

/// Returns the name under which a part is written until it is complete.
std::string partial_of(const std::string& output) {
  return is_packed(output) ? std::string(unpacked_name(output)) + ".partial.gz" : output + ".partial";
}

std::string without_time(std::string line) {
  const std::size_t begin = line.find("\"time_us\":"), end = line.find(',', begin);
  return begin == std::string::npos || end == std::string::npos ? line : line.erase(begin, end - begin);
}

bool is_invalid(std::string_view answer) {
  constexpr std::string_view key =
      "\"status\":\"";  // only an id precedes this key, and no JSON string contains it unescaped
  const std::size_t at = answer.find(key);
  return at != std::string_view::npos && answer.substr(at + key.size()).starts_with("invalid\"");
}

/// Returns whether an output without a journal is already the complete answer: it has as many lines as the input, and
/// its first and last chunks hold what this input and these flags give. Counts its invalid answers.
bool finished(LineReader& in, const Arguments& a, long& invalid) {
  LineReader out(a.output, true);
  Lines asked, told;
  const auto same = [&](bool from_the_end) {
    const std::size_t n = asked.lines.size(), m = told.lines.size(), both = std::min(n, m);
    for (std::size_t i = 0; i < both; ++i) {
      const std::size_t question = from_the_end ? n - 1 - i : i;
      const std::string_view answer = told.line(from_the_end ? m - 1 - i : i);
      if (without_time(answer_line(asked, question, a.flags)) != without_time(std::string(answer))) return false;
    }
    return true;
  };
  const auto next = [](LineReader& reader, Lines& lines) {
    Lines more;
    if (!reader.next(more)) return false;
    lines = std::move(more);
    return true;
  };
  const auto count = [&] {
    for (std::size_t i = 0; i < told.lines.size(); ++i) invalid += is_invalid(told.line(i));
  };
  if (!in.next(asked) || !out.next(told) || !same(false)) return false;
  count();
  while (next(in, asked)) {
  }
  while (next(out, told)) count();
  return asked.after.lines == told.after.lines && same(true);
}

/// Resumes an earlier run: checks its journal, cuts the output to the last good mark, and returns that mark.
Journal::Mark go_on(Journal& journal, LineReader& in, Output& out, const std::string& path) {
  journal.check_same();
  const auto mark = journal.last(path);
  if (!mark) {
    journal.begin();
    out.cut(0);
    return {};
  }
  if (!in.skip(mark->read) && !interrupted())
    throw FileError(fmt::format("{}: this batch was begun with another input: its first {} lines differ",
                                Journal::path_for(path), mark->read.lines));
  out.cut(mark->written, mark->crc);
  journal.go_on(*mark);
  return *mark;
}

/// Begins a new output; refuses to discard the answers of a run that was cut off.
Journal::Mark begin(Journal& journal, Output& out) {
  if (const auto mark = journal.last(out.name()); mark && out.size() > 0)
    throw FileError(
        fmt::format("{} holds the first {} answers of a batch that was interrupted: --resume continues it; remove it "
                    "to start again",
                    out.name(), grouped(mark->read.lines)));
  journal.begin();
  out.cut(0);
  return {};
}

/// Returns whether the part is already complete, for this input and these flags.
bool is_done(const Arguments& a) {
  if (!std::filesystem::exists(a.output)) return false;
  const auto record = read_part(a.output);
  if (!record || record->part != *a.part || record->flags != a.flags.words() || !is_whole(a.output, *record))
    return false;
  LineReader in(a.file, true, *a.part);
  Lines more;
  return in.begun() == record->from && in.skip(record->to) && !in.next(more) && !interrupted();
}

/// Completes a part: writes its record beside the output and moves the output to its final name.
void close_part(const Arguments& a, const LineReader& in, const Journal::Mark& at) {
  const std::string partial = partial_of(a.output);
  if (!std::filesystem::exists(partial) && is_done(a)) return;  // another run completed it in the meantime
  if (Kept kept(partial); !kept.holds(at.written, at.crc) || !kept.at_end())
    throw WriteError(fmt::format(
        "{}: is not what was written to it; perhaps another bankshot writes to it too, or a disk fails; the same "
        "command with --resume continues after what is right",
        partial));
  // The part ends after its last line; a part without lines ends where it begins.
  const ReadMark& to = at.read.bytes > in.begun().bytes ? at.read : in.begun();
  write_part(a.output, {*a.part, a.flags.words(), in.begun(), to, measured(partial), at.tally.invalid});
  put_in_place(partial, a.output);
}

void write_cost(const Arguments& a, const Cost& cost, const Journal::Mark& at, long kept, const Progress& progress) {
  if (!a.cost.empty()) write_file(a.cost, cost_csv(cost, at.tally, kept, progress));
}

int run_batch(const Arguments& a, LineReader& in, Output& out, Journal* journal, const Journal::Mark& from) {
  const long before = in.begun().lines, kept = from.read.lines - before;
  Progress progress(kept, in.share(), !a.quiet && isatty(STDERR_FILENO) == 1);
  Cost cost;
  Batch batch{in, out, journal, a.flags, a.threads, progress, from, a.cost.empty() ? nullptr : &cost};
  const std::string how_to_go_on = journal ? "; the same command with --resume continues" : "";
  try {
    run_pipeline(batch);
    if (!interrupted()) {
      if (out.gzip() && out.written() == 0) out.write(gzipped(""));  // an empty file is not a gzip file
      out.finish();
    }
  } catch (const FileError& e) {
    progress.clear();
    if (journal) out.cut_quietly(batch.at.written);
    throw WriteError(
        fmt::format("{}; answers written: {}{}", e.what(), grouped(batch.at.read.lines - before), how_to_go_on));
  }
  progress.clear();
  if (interrupted()) {
    if (!a.quiet)
      std::cerr << fmt::format("bankshot: interrupted after {} puzzles{}\n", grouped(batch.at.read.lines - before),
                               how_to_go_on);
    return by_signal + interrupted();
  }
  if (a.part) close_part(a, in, batch.at);
  if (journal) journal->remove();
  if (!a.quiet) std::cerr << closing_line(batch.at.tally, kept, progress);
  write_cost(a, cost, batch.at, kept, progress);
  return a.strict && batch.at.tally.invalid > 0 ? some_fail : done;
}

int run_part(const Arguments& a) {
  if (a.output == "-") throw FileError("--part needs a file of its own: -o SHOTS.jsonl");
  LineReader in(a.file, is_packed(a.output), *a.part);
  const std::string partial = partial_of(a.output);
  // The journal takes the lock first: otherwise another run of this part could finish between the check and the next
  // step.
  Journal journal(partial, fmt::format("{} --part {}/{}", a.flags.words(), a.part->k, a.part->n), in.identity());
  if (a.resume && is_done(a)) {
    journal.remove();
    if (!a.quiet) std::cerr << a.output << ": is whole already\n";
    return done;
  }
  Output out(partial);
  if (!out.regular()) throw FileError(fmt::format("{}: is no file", partial));
  Journal::Mark from = a.resume ? go_on(journal, in, out, partial) : begin(journal, out);
  if (from.read.lines == 0) from.read = in.begun();
  return run_batch(a, in, out, &journal, from);
}

int answer(const Arguments& a) {
  const Interrupts watch;
  if (a.part) return run_part(a);
  LineReader in(a.file, a.output.ends_with(".gz"));
  Output out(a.output);
  if (a.resume && !out.regular()) throw FileError(fmt::format("{}: is no file that can be resumed", a.output));
  if (in.same_file(out.descriptor()))
    throw FileError(fmt::format("{}: is the input too, and would be overwritten", a.output));
  if (!out.regular()) return run_batch(a, in, out, nullptr, {});
  const std::string progress_file = Journal::path_for(a.output);
  if (a.resume && out.size() > 0 && !std::filesystem::exists(progress_file)) {
    long invalid = 0;
    const bool whole = finished(in, a, invalid);
    if (interrupted()) return by_signal + interrupted();
    if (!whole)
      throw FileError(fmt::format(
          "{}: cannot be resumed: {} is missing, and it is not the whole answer to this input with these flags",
          a.output, progress_file));
    if (!a.quiet) std::cerr << a.output << ": is whole already\n";
    return a.strict && invalid > 0 ? some_fail : done;
  }
  Journal journal(a.output, a.flags.words(), in.identity());
  const Journal::Mark from = a.resume ? go_on(journal, in, out, a.output) : begin(journal, out);
  return run_batch(a, in, out, &journal, from);
}

int run(Arguments a) {
  if (const std::string list = service::list_asked(a.flags); !list.empty()) return print(list), done;
  service::check(a.flags);
  a.threads = threads_for(a.threads);
  if (a.resume && a.output == "-") throw FileError("--resume needs the file to continue: -o SHOTS.jsonl");
  if (!a.csv.empty() && a.output == "-") throw FileError("--csv needs the answers in a file too: -o SHOTS.jsonl");
  if (!a.csv.empty()) write_file(a.csv, rows_header());  // reports a name that cannot be written before the work begins
  const int code = answer(a);
  if (!a.csv.empty() && code < by_signal) write_rows(a.output, a.csv);
  return code;
}

}  // namespace

Run add(CLI::App& app) {
  auto a = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("batch", "Solve many puzzles, one per line");
  explain(
      *command,
      "Each line is answered by one line, in order. A line that is no puzzle is answered \"invalid\". While a batch\n"
      "runs, SHOTS.jsonl.progress stands beside its output. After a kill, a full disk or Ctrl-C, the same command\n"
      "with --resume checks the input and the flags against that file and continues; at most a few hundred puzzles\n"
      "are solved again. A packed output (.gz) consists of gzip members of 64 lines.",
      {{"bankshot batch puzzles.jsonl -o shots.jsonl", "the best shot of each"},
       {"bankshot batch puzzles.jsonl -o shots.jsonl --resume", "continues where that was interrupted"},
       {"bankshot batch puzzles.jsonl -o shots.jsonl --csv shots.csv", "also as a table"},
       {"bankshot batch puzzles.jsonl --part 3/64 -o shots-3.jsonl",
        "the fourth of 64 parts; bankshot merge joins them"},
       {"bankshot batch puzzles.jsonl -o all.jsonl.gz --all --strict",
        "every shot, packed; exit code 1 if a line is invalid"}},
      "0 done; 1 a line was invalid (--strict); 2 bad input or usage; 128 + n ended by signal n.");
  command->add_option("puzzles", a->file, "A puzzle in JSON on each line; - reads standard input, *.gz is unpacked")
      ->required();
  command->add_option("-o,--output", a->output, "Write the answers here, one per line; *.gz is packed")
      ->capture_default_str();
  command->add_option("-j,--threads", a->threads, "Threads; 0: one per core")
      ->capture_default_str()
      ->check(CLI::Range(0, 1024));
  command
      ->add_option_function<std::string>(
          "--part", [a](const std::string& part) { a->part = part_of(part); },
          "Answer only part K of N, counted from 0; without K/N, the part that Slurm or MPI gives this process")
      ->expected(0, 1)
      ->type_name("K/N");
  command->add_flag("--resume", a->resume, "Continue where an earlier run of this command was interrupted");
  command->add_flag("--quiet", a->quiet, "Write nothing but errors to standard error");
  command->add_flag("--strict", a->strict, "End with exit code 1 if a line was invalid");
  add_options(*command, service::options_of(a->flags));
  command->add_flag("--json", a->json, "Answers are JSON with or without it");
  command->add_option("--csv", a->csv, "Write a table here too: one row per answer, with its best shot")
      ->check(file_name);
  command->add_option("--cost", a->cost, "Write the time that each stage took to this file (CSV)")->check(file_name);
  const auto no_picture = [](const std::string&) {
    throw CLI::ValidationError("--svg", "a batch draws no pictures; bankshot solve --svg draws one");
  };
  command->add_option_function<std::string>("--svg", no_picture)->group("");
  return [a] { return run(*a); };
}

}  // namespace bankshot::app::batch
