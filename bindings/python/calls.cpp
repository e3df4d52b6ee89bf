// SPDX-License-Identifier: MIT
#include "bindings/python/calls.hpp"

#include <chrono>

#include "bankshot/plan/place_value.hpp"
#include "bankshot/scene/json.hpp"
#include "bindings/python/interrupt.hpp"
#include "planners/in_parallel.hpp"
#include "service/start_map.hpp"

namespace py = pybind11;

namespace bankshot::python {
namespace {

Solved solved_until(const std::string& text, const SolveFlags& flags, const std::atomic<bool>& stop) {
  Solved out{flags.read(text), {}, flags};
  SolveOptions options = flags.solve_options();
  options.cancelled = &stop;
  out.answer = solve(out.puzzle, options);
  return out;
}

/// Returns the answer as `batch` does. Never throws for an invalid text.
std::string answer_line(const std::string& text, const SolveFlags& flags, const std::atomic<bool>& stop) {
  try {
    return solved_until(text, flags, stop).json();
  } catch (const InvalidInput& e) {
    return to_json(invalid_answer(read_id(text), e, read_about(text)));
  } catch (const std::exception& e) {
    const InvalidInput trouble("", std::string("this puzzle could not be worked on: ") + e.what());
    return to_json(invalid_answer(read_id(text), trouble, read_about(text)));
  }
}

/// Reports the progress to Python from time to time.
class Told {
 public:
  explicit Told(py::object tell) : tell_(std::move(tell)) {}

  void operator()(std::size_t done) {
    constexpr auto often = std::chrono::milliseconds(100);
    const auto now = std::chrono::steady_clock::now();
    if (tell_.is_none() || now - last_ < often) return;
    last_ = now;
    const py::gil_scoped_acquire hold;
    tell_(done);
  }

 private:
  py::object tell_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Calls `make(i, stop)` for each i below `count` on several threads, and returns the results.
template <class Make>
auto each(std::size_t count, int threads, py::object tell, const Make& make) {
  using Result = decltype(make(std::size_t{}, std::atomic<bool>{}));
  Told told(std::move(tell));
  return interruptibly([&](const std::atomic<bool>& stop) {
    std::vector<Result> out(count);
    std::atomic<std::size_t> done{0};
    planning::in_parallel(
        count, 1, threads, stop,
        [&](std::size_t i, std::size_t) {
          out[i] = make(i, stop);
          ++done;
        },
        [&] { told(done); });
    return out;
  });
}

}  // namespace

void check(const SolveFlags& flags) {
  if (flags.options.all && flags.options.first) throw InvalidInput("", "all excludes first");
  try {
    service::check(flags);
  } catch (const service::BadOption& e) {
    throw InvalidInput("", e.what());
  }
}

Solved solved(const std::string& text, const SolveFlags& flags) {
  return interruptibly([&](const std::atomic<bool>& stop) { return solved_until(text, flags, stop); });
}

Texts solve_lines(const Texts& lines, const SolveFlags& flags, int threads, py::object tell) {
  return each(lines.size(), threads, std::move(tell),
              [&](std::size_t i, const std::atomic<bool>& stop) { return answer_line(lines[i], flags, stop); });
}

Texts generate_lines(const service::Wishes& wishes, long count, int threads) {
  const Wish wish = service::read_wish(wishes);
  const auto made = each(static_cast<std::size_t>(count), threads, py::none(), [&](std::size_t i, const auto&) {
    return service::make(wishes, wish, static_cast<long>(i) + 1);
  });
  Texts lines;
  for (const service::Made& m : made) {
    if (m.line.empty())
      throw NotFound("puzzle " + std::to_string(lines.size() + 1) + " was not found: " + m.tries.text());
    lines.push_back(m.line);
  }
  return lines;
}

std::string map(const std::string& text, int columns, int rows, const SolveFlags& flags, bool value) {
  if (columns < 1 || rows < 1) throw InvalidInput("", "a map has one column and one row at least");
  return interruptibly([&](const std::atomic<bool>& stop) {
    const Puzzle puzzle = flags.read(text);
    if (value) return to_csv(puzzle, value_map(puzzle, columns, rows));
    SolveOptions options = flags.solve_options();
    options.cancelled = &stop;
    return to_csv(puzzle, service::start_map(puzzle, columns, rows, options));
  });
}

#if BANKSHOT_LEARN
std::string fit(const Texts& lines, FitWish wish) {
  std::vector<Recording> recordings;
  for (const std::string& line : lines) recordings.push_back(read_recording(line));
  wish.progress = [](double) {
    const py::gil_scoped_acquire hold;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  };
  const py::gil_scoped_release release;
  return to_json(bankshot::fit(recordings, wish));
}
#endif

}  // namespace bankshot::python
