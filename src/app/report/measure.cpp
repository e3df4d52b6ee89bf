// SPDX-License-Identifier: MIT
#include "app/report/measure.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <thread>

namespace bankshot::app::report {

Spread spread(std::vector<double> numbers) {
  if (numbers.empty()) return {};
  std::sort(numbers.begin(), numbers.end());
  const auto at = [&](double share) {
    const double place = share * static_cast<double>(numbers.size() - 1);
    const auto below = static_cast<std::size_t>(place), above = std::min(below + 1, numbers.size() - 1);
    // Equal numbers are not interpolated: they may be infinite.
    if (numbers[below] == numbers[above]) return numbers[below];
    return numbers[below] + (numbers[above] - numbers[below]) * (place - static_cast<double>(below));
  };
  return {at(0.1), at(0.5), at(0.9)};
}

std::string machine() {
  std::string processor = "unknown processor";
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("model name")) {
      processor = line.substr(std::min(line.find(':') + 2, line.size()));
      break;
    }
  const unsigned cores = std::thread::hardware_concurrency();
  return fmt::format("{}, {} core{}; {}; commit {}", processor, cores, cores == 1 ? "" : "s", BANKSHOT_COMPILER,
                     BANKSHOT_COMMIT);
}

std::string short_number(double x) {
  if (x == 0 || !std::isfinite(x)) return x == 0 ? "0" : x > 0 ? "∞" : "–";
  const double size = std::abs(x);
  constexpr double many = 1e5, few = 1e-3;
  return size >= many || size < few ? fmt::format("{:.1e}", x) : fmt::format("{:.3g}", x);
}

std::string short_count(double x) {
  if (!(x >= 99.5)) return fmt::format("{:.2g}", x);
  const double unit = std::pow(10, std::floor(std::log10(x)) - 1);
  std::string digits = fmt::format("{:.0f}", std::round(x / unit) * unit);
  for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, ",");
  return digits;
}

std::string short_power(double x) { return fmt::format("{:.2f}", std::round(100 * x) / 100 + 0.0); }

namespace {

struct Unit {
  double size;
  const char* name;
};

/// Formats x in the largest unit of which there is at least one, to three digits.
template <std::size_t n>
std::string in_units(double x, const Unit (&units)[n]) {
  constexpr double nearly_one = 0.9995;  // 999.5 of the next unit would be written as 1e+03
  if (x == 0 || !std::isfinite(x)) return short_number(x);
  for (const Unit& u : units)
    if (std::abs(x) >= nearly_one * u.size) return fmt::format("{:.3g} {}", x / u.size, u.name);
  return fmt::format("{:.1e} {}", x / units[n - 1].size, units[n - 1].name);
}

}  // namespace

std::string short_time(double seconds) {
  constexpr Unit units[] = {{1, "s"}, {1e-3, "ms"}, {1e-6, "µs"}, {1e-9, "ns"}};
  return in_units(seconds, units);
}

std::string short_length(double metres) {
  constexpr Unit units[] = {{1, "m"}, {1e-3, "mm"}, {1e-6, "µm"}, {1e-9, "nm"}};
  if (metres > 0 && metres < 1e-9) return fmt::format("{:.1e} m", metres);
  return in_units(metres, units);
}

}  // namespace bankshot::app::report
