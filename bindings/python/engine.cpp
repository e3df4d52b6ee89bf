// SPDX-License-Identifier: MIT
//
// The module bankshot._engine: texts in, texts and arrays out. Its public interface is written in Python
// (bankshot/__init__.py).
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cmath>

#include "bankshot/draw/svg.hpp"
#include "bankshot/scene/json.hpp"
#include "bindings/many.hpp"
#include "bindings/python/calls.hpp"
#include "bindings/python/interrupt.hpp"
#include "bindings/verified.hpp"
#include "service/answers.hpp"

namespace py = pybind11;

namespace bankshot::python {
namespace {

template <class T>
using Array = py::array_t<T, py::array::c_style | py::array::forcecast>;

PictureStyle style_of(bool dark, bool words, bool moving) {
  return {.theme = dark ? Theme::dark : Theme::light, .words = words, .moving = moving};
}

/// One row of a path: one ball at one time.
struct Row {
  double t;
  std::int32_t ball;
  double x, y, vx, vy, wx, wy, wz;
};

/// A shot and its trajectory.
struct Played {
  ShotRequest request;
  Trajectory trajectory;

  std::string json() const { return to_json(request, trajectory); }
  std::string svg(bool dark, bool words, bool moving) const {
    return draw(request, trajectory, style_of(dark, words, moving));
  }

  py::array_t<Row> rows(double rate) const {
    constexpr double most = 1e7;  // about a gigabyte
    if (!(rate > 0)) throw InvalidInput("", "the rate must be more than 0");
    if (trajectory.events.back().time * rate * static_cast<double>(1 + request.others.size()) > most)
      throw InvalidInput("", "the path would have more than 10,000,000 points: ask a lower rate");
    std::vector<Row> rows;
    sample(request, trajectory, rate, [&](double t, int ball, const State<double>& s) {
      rows.push_back({t, ball, s.at.x, s.at.y, s.velocity.x, s.velocity.y, s.spin.x, s.spin.y, s.spin.z});
    });
    return py::array_t<Row>(static_cast<py::ssize_t>(rows.size()), rows.data());
  }

  Texts balls() const {
    Texts names;
    for (int i = 0; i <= static_cast<int>(request.others.size()); ++i) names.push_back(ball_of(request, i).id);
    return names;
  }

  py::array_t<double> vertices() const {
    const auto& v = request.table.vertices;
    py::array_t<double> out({v.size(), std::size_t{2}});
    for (std::size_t i = 0; i < v.size(); ++i) {
      out.mutable_at(i, 0) = v[i].x;
      out.mutable_at(i, 1) = v[i].y;
    }
    return out;
  }

  /// Returns name, x, y and half the mouth of each pocket.
  std::vector<std::tuple<std::string, double, double, double>> pockets() const {
    std::vector<std::tuple<std::string, double, double, double>> out;
    for (const Pocket& p : request.table.pockets) out.emplace_back(p.name, p.place().x, p.place().y, p.half());
    return out;
  }
};

Played played(const std::string& text) {
  const py::gil_scoped_release release;
  Played p{read_shot(text), {}};
  p.trajectory = simulate(p.request);
  return p;
}

/// Simulates launches. The arrays have one length: m/s, degrees and, if given, rows of top, side and masse.
py::array_t<bankshot_end> simulate_many(const std::string& text, const Array<double>& speeds,
                                        const Array<double>& angles, const std::optional<Array<double>>& spins,
                                        int threads) {
  const ShotRequest scene = read_shot(text);
  const auto count = static_cast<std::size_t>(speeds.size());
  if (static_cast<std::size_t>(angles.size()) != count ||
      (spins && static_cast<std::size_t>(spins->size()) != 3 * count))
    throw py::value_error("speeds, angles and spins must be as many");
  py::array_t<bankshot_end> ends(speeds.size());
  bankshot_end* const out = ends.mutable_data();
  const double *const speed = speeds.data(), *const angle = angles.data(),
                      *const spin = spins ? spins->data() : nullptr;
  interruptibly([&](const std::atomic<bool>& stop) {
    std::vector<bankshot_launch> launches(count);
    for (std::size_t i = 0; i < count; ++i) {
      const double* const s = spin ? spin + 3 * i : nullptr;
      const double aim = std::isfinite(angle[i]) ? wrap_angle(radians(angle[i])) : angle[i];
      launches[i] = {speed[i], aim, s ? s[0] : scene.spin.top, s ? s[1] : scene.spin.side, s ? s[2] : scene.spin.masse};
    }
    bindings::simulate_many(scene, launches, out, threads, stop);
    return 0;
  });
  return ends;
}

void translate(std::exception_ptr thrown) {
  const auto raise = [](const std::string& path, const std::string& reason) {
    const py::object type = py::module_::import("bankshot._errors").attr("InvalidInput");
    PyErr_SetObject(type.ptr(), py::make_tuple(path, reason).ptr());
  };
  try {
    std::rethrow_exception(std::move(thrown));
  } catch (const InvalidInput& e) {
    const Answer answer = invalid_answer("", e);  // its reason names the line for text that is not JSON
    raise(answer.error->path, answer.error->reason);
  } catch (const service::BadOption& e) {  // an invalid wish of `generate`
    raise("", e.what());
  } catch (const NotFound& e) {
    PyErr_SetString(PyExc_LookupError, e.what());
  }
}

}  // namespace
}  // namespace bankshot::python

PYBIND11_MODULE(_engine, m) {
  using namespace bankshot;
  using namespace bankshot::python;
  using namespace pybind11::literals;
  py::register_exception_translator(translate);
  PYBIND11_NUMPY_DTYPE(Row, t, ball, x, y, vx, vy, wx, wy, wz);
  PYBIND11_NUMPY_DTYPE(bankshot_end, time, length, x, y, vx, vy, wx, wy, wz, cushions, kind, pocket);
  m.attr("version") = BANKSHOT_VERSION;
  m.attr("learns") = static_cast<bool>(BANKSHOT_LEARN);

  py::class_<SolveFlags>(m, "SolveFlags")
      .def(py::init([](std::string planner, bool all, bool first, long budget, bool no_timing, bool no_robustness,
                       bool sensitivity, bool path, std::string noise, long depth, long plies) {
             SolveFlags f;
             f.options.planner = std::move(planner);
             f.options.all = all, f.options.first = first, f.options.sensitivity = sensitivity;
             f.budget = budget, f.no_timing = no_timing, f.no_robustness = no_robustness, f.path = path;
             f.noise = std::move(noise), f.depth = depth, f.plies = plies;
             bankshot::python::check(f);
             return f;
           }),
           py::kw_only(), "planner"_a = "auto", "all"_a = false, "first"_a = false, "budget"_a = -1,
           "no_timing"_a = false, "no_robustness"_a = false, "sensitivity"_a = false, "path"_a = false, "noise"_a = "",
           "depth"_a = 3, "plies"_a = 1);
  py::class_<Solved>(m, "Solved")
      .def("json", &Solved::json)
      .def("text", &Solved::text)
      .def(
          "svg",
          [](const Solved& s, bool dark, bool words, bool moving) {
            return draw(s.puzzle, s.answer, style_of(dark, words, moving));
          },
          "dark"_a, "words"_a, "moving"_a);
  py::class_<Played>(m, "Played")
      .def("json", &Played::json)
      .def("svg", &Played::svg, "dark"_a, "words"_a, "moving"_a)
      .def("rows", &Played::rows, "rate"_a)
      .def("balls", &Played::balls)
      .def("vertices", &Played::vertices)
      .def("pockets", &Played::pockets);

  m.def("solve", &solved, "text"_a, "flags"_a);
  m.def("solve_lines", &solve_lines, "lines"_a, "flags"_a, "threads"_a, "tell"_a);
  m.def("simulate", &played, "text"_a);
  m.def("simulate_many", &python::simulate_many, "text"_a, "speeds"_a, "angles"_a, "spins"_a, "threads"_a);
  m.def("map", &python::map, "text"_a, "columns"_a, "rows"_a, "flags"_a, "value"_a);
  m.def("verify", [](const std::string& puzzle, const std::string& answer) {
    const py::gil_scoped_release release;
    return bindings::verified(puzzle, answer).second;
  });
  m.def(
      "generate",
      [](long count, int threads, std::uint64_t seed, const std::string& table, const std::string& physics,
         const std::string& cushions, const std::string& target, int balls, const std::string& then,
         const std::string& difficulty, bool unique, bool no_spin, std::vector<double> speed) {
        return generate_lines(
            {seed, table, physics, cushions, then, difficulty, target, balls, unique, no_spin, std::move(speed)}, count,
            threads);
      },
      "count"_a, "threads"_a, py::kw_only(), "seed"_a, "table"_a, "physics"_a, "cushions"_a, "target"_a, "balls"_a,
      "then"_a, "difficulty"_a, "unique"_a, "no_spin"_a, "speed"_a);
  m.def("schema", [](const std::string& document) {
    const service::Reply reply = service::schema({{"document", document}});
    if (reply.status != 200) throw InvalidInput("", "\"" + document + "\" is no document");
    return reply.body;
  });
  m.def("tables", [] { return service::tables({}).body; });
#if BANKSHOT_LEARN
  m.def(
      "fit",
      [](const Texts& lines, std::vector<std::string> free, std::string model, int restitution, int rolling,
         int holdout, bool predict, int threads) {
        FitWish wish{.free = std::move(free), .model = std::move(model), .holdout = holdout, .predict = predict};
        wish.restitution = static_cast<FitWish::BySpeed>(restitution);
        wish.rolling = static_cast<FitWish::BySpeed>(rolling);
        wish.threads = threads;
        return python::fit(lines, std::move(wish));
      },
      "lines"_a, py::kw_only(), "free"_a, "model"_a, "restitution"_a, "rolling"_a, "holdout"_a, "predict"_a,
      "threads"_a);
#endif
}
