// SPDX-License-Identifier: MIT
//
// Measurements of the report. A time is processor time of the thread, so that other programs hardly count, and the
// least of some repeats, since a machine only adds to it. Medians come with the 10 % and 90 % quantiles.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "app/clock.hpp"

namespace bankshot::app::report {

/// Returns the seconds that one call of f takes: the least of three repeats, each with as many calls as fill `enough`
/// seconds. A call that takes `long_enough` is measured once.
template <class F>
double seconds_of(F&& f) {
  constexpr double enough = 50e-6, long_enough = 5e-3;
  constexpr int repeats = 3;
  const auto timed = [&](long calls) {
    const double begin = cpu_seconds();
    for (long i = 0; i < calls; ++i) f();
    return (cpu_seconds() - begin) / static_cast<double>(calls);
  };
  double least = timed(1);
  if (least >= long_enough) return least;
  long calls = 1;
  while (static_cast<double>(calls) * least < enough) {
    calls *= 2;
    least = std::min(least, timed(calls));
  }
  for (int i = 0; i < repeats; ++i) least = std::min(least, timed(calls));
  return least;
}

/// Median and spread of some numbers.
struct Spread {
  double low = 0, median = 0, high = 0;  ///< 10 %, 50 %, 90 %
};
Spread spread(std::vector<double> numbers);

/// Returns "Processor, cores, compiler, commit".
std::string machine();

/// Formats a number for a table: three digits, with a power of ten if it is very large or small. Times and lengths get
/// a unit, such as "0.34 µs".
std::string short_number(double x);
std::string short_count(double x);  ///< two digits, "12,000"
std::string short_power(double x);  ///< two decimals, without the sign of 0
std::string short_time(double seconds);
std::string short_length(double metres);

}  // namespace bankshot::app::report
