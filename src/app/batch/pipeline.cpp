// SPDX-License-Identifier: MIT
#include "app/batch/pipeline.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <exception>
#include <memory>

#include "app/clock.hpp"
#include "app/gzip.hpp"
#include "app/interrupt.hpp"
#include "bankshot/plan/batch.hpp"
#include "bankshot/scene/json.hpp"

namespace bankshot::app::batch {
namespace {

struct Chunk {
  Lines in;
  std::string out;
  Tally tally;
  Cost cost;
};
using ChunkPointer = std::shared_ptr<Chunk>;

/// Adds the CPU time since the previous call to a counter; does nothing when switched off.
class Laps {
 public:
  explicit Laps(bool on) : on_(on), last_(on ? cpu_seconds() : 0) {}
  void add_to(double& part) {
    if (!on_) return;
    const double now = cpu_seconds();
    part += now - std::exchange(last_, now);
  }

 private:
  bool on_;
  double last_;
};

/// The puzzles of a chunk, and the answers to its lines without a puzzle.
struct Parsed {
  std::vector<Puzzle> puzzles;
  std::vector<std::string> bad;  ///< one text per line; empty if the line is a puzzle
};

/// Returns the answer to a line without a valid puzzle. Text that is not JSON is located by its line in the file, other
/// errors by their JSON path.
std::string answer_to_bad(std::string_view line, long number, InvalidInput e) {
  if (line.find_first_not_of(" \t\r") == std::string_view::npos) e = InvalidInput("", "blank line", 1);
  if (e.line) e.line = number;
  return to_json(invalid_answer(read_id(line), e, read_about(line)));
}

Parsed parse(const Lines& lines, const service::SolveFlags& flags) {
  Parsed p;
  p.puzzles.reserve(lines.lines.size());
  p.bad.resize(lines.lines.size());
  for (std::size_t i = 0; i < lines.lines.size(); ++i) {
    const std::string_view line = lines.line(i);
    try {
      if (lines.lines[i].too_long)
        throw InvalidInput(
            "", fmt::format("longer than {} bytes, and no puzzle needs as many", LineReader::longest_line), 1);
      p.puzzles.push_back(flags.read(line));
    } catch (const InvalidInput& e) {
      p.bad[i] = answer_to_bad(line, lines.number(i), e);
    }
  }
  return p;
}

/// Divides the chunk's CPU time `seconds` in proportion to the wall-clock times that its answers report.
void add_solving(Cost& cost, const std::vector<Answer>& answers, double seconds) {
  double certify = 0, robustness = 0, all = 0;
  for (const Answer& a : answers) {
    certify += a.cost.certify_us;
    robustness += a.cost.robustness_us;
    all += a.time_us + a.cost.robustness_us;
  }
  const double scale = all > 0 ? seconds / all : 0;
  cost.certify += certify * scale;
  cost.robustness += robustness * scale;
  cost.search += seconds - (certify + robustness) * scale;
}

void work(Chunk& c, const service::SolveFlags& flags, bool gzip, bool measure) {
  Laps laps(measure);
  const Parsed parsed = parse(c.in, flags);
  laps.add_to(c.cost.parse);
  BatchOptions options{.solve = flags.solve_options(), .threads = 1};
  options.solve.measure = measure;
  const std::vector<Answer> answers = solve_batch(parsed.puzzles, options);
  double solving = 0;
  laps.add_to(solving);
  add_solving(c.cost, answers, solving);
  std::size_t next = 0;
  for (std::size_t i = 0; i < parsed.bad.size(); ++i) {
    const bool bad = !parsed.bad[i].empty();
    const Answer* a = bad ? nullptr : &answers[next];
    if (bad || a->status == Status::invalid) {
      c.out += bad ? parsed.bad[i] : to_json(*a);
      c.tally.add_invalid(c.in.number(i));
    } else {
      c.out += to_json(parsed.puzzles[next], *a, !flags.no_timing, flags.path);
      c.tally.add(parsed.puzzles[next], *a);
    }
    c.out += '\n';
    if (!bad) ++next;
  }
  if (gzip) c.out = gzipped(c.out);
  laps.add_to(c.cost.format);
}

/// Writes the answers first and their mark after them.
void write(Batch& b, Chunk& c) {
  Laps laps(b.cost != nullptr);
  b.out.write(c.out);
  Journal::Mark mark{c.in.after, b.out.written(), b.out.crc(), b.at.tally};
  mark.tally.add(c.tally);
  if (b.journal) b.journal->add(mark);
  b.at = mark;
  laps.add_to(c.cost.write);
  if (b.cost) b.cost->add(c.cost);
  b.progress.show(mark.tally, c.in.share);
}

}  // namespace

void run_pipeline(Batch& b) {
  std::atomic<bool> stop = false;
  std::exception_ptr read_error, error;
  const auto read = [&](tbb::flow_control& control) -> ChunkPointer {
    auto chunk = std::make_shared<Chunk>();
    Laps laps(b.cost != nullptr);
    try {
      if (!stop && !interrupted() && b.in.next(chunk->in)) {
        laps.add_to(chunk->cost.read);
        return chunk;
      }
    } catch (...) {
      read_error = std::current_exception();
    }
    control.stop();
    return nullptr;
  };
  const auto solve = [&](ChunkPointer chunk) {
    work(*chunk, b.flags, b.out.gzip(), b.cost != nullptr);
    return chunk;
  };
  const auto write_chunk = [&](const ChunkPointer& chunk) {
    if (stop) return;  // after a failure nothing more may be written
    try {
      write(b, *chunk);
    } catch (...) {
      error = std::current_exception();
      stop = true;
    }
  };
  const auto threads = static_cast<std::size_t>(b.threads);
  constexpr std::size_t chunks_a_thread = 4;  // so that one hard puzzle delays the writing but not the other threads
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena(b.threads).execute([&] {
    using Mode = tbb::filter_mode;
    tbb::parallel_pipeline(chunks_a_thread * threads,
                           tbb::make_filter<void, ChunkPointer>(Mode::serial_in_order, read) &
                               tbb::make_filter<ChunkPointer, ChunkPointer>(Mode::parallel, solve) &
                               tbb::make_filter<ChunkPointer, void>(Mode::serial_in_order, write_chunk));
  });
  if (error) std::rethrow_exception(error);
  if (read_error) std::rethrow_exception(read_error);
}

std::string answer_line(const Lines& lines, std::size_t i, const service::SolveFlags& flags) {
  const std::string_view line = lines.line(i);
  try {
    const Puzzle puzzle = flags.read(line);
    return to_json(puzzle, bankshot::solve(puzzle, flags.solve_options()), !flags.no_timing, flags.path);
  } catch (const InvalidInput& e) {
    return answer_to_bad(line, lines.number(i), e);
  }
}

}  // namespace bankshot::app::batch
