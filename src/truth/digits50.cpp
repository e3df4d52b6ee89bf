// SPDX-License-Identifier: MIT
#include <boost/multiprecision/cpp_dec_float.hpp>

#include "truth/follow.hpp"
#include "truth/many_balls.hpp"

namespace bankshot::truth {
namespace {

template <unsigned digits>
using Digits =
    boost::multiprecision::number<boost::multiprecision::cpp_dec_float<digits>, boost::multiprecision::et_off>;
using Digits50 = Digits<50>;

constexpr double fine_impact = 1e-20;

}  // namespace

Physics refined(Physics p) {
  if (double* const error = impact_tolerance(p.cushion)) *error = fine_impact;
  return p;
}

Path run_truth(const Run& run) { return run.all ? run_all_truth(run) : recorded<Digits50>(run); }
Path run_double(const Run& run) { return run.all ? run_all_double(run) : recorded<double>(run); }

Path run_in_digits(const Run& run, int digits) {
  constexpr int few = 25, many = 100;
  return digits == few ? recorded<Digits<few>>(run) : digits == many ? recorded<Digits<many>>(run) : run_truth(run);
}

Jacobian truth_jacobian(const Run& run) {
  const Digits50 step("1e-20");
  Jacobian j{};
  for (int k = 0; k < 7; ++k) {
    Vec2<Digits50> ends[2];
    for (int side = 0; side < 2; ++side) {
      State<Digits50> s = start_of<Digits50>(run);
      Digits50* const inputs[] = {&s.at.x, &s.at.y, &s.velocity.x, &s.velocity.y, &s.spin.x, &s.spin.y, &s.spin.z};
      *inputs[k] += side == 0 ? step : Digits50(-step);
      follow<Digits50>(run, s, [&](const Event&, const auto& sim) { ends[side] = sim.state().at; });
    }
    j.d[0][k] = rounded(Digits50((ends[0].x - ends[1].x) / (2 * step)));
    j.d[1][k] = rounded(Digits50((ends[0].y - ends[1].y) / (2 * step)));
  }
  return j;
}

}  // namespace bankshot::truth
