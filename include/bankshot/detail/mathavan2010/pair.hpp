// SPDX-License-Identifier: MIT
//
// One number of the cushion and one of the cloth, computed side by side. Two doubles share one register, so that one
// instruction serves both.
#pragma once

#include <cstddef>

namespace bankshot::detail::mathavan {

template <class T>
struct Pair {
  T cushion{}, cloth{};

  const T& operator[](std::size_t k) const { return k == 0 ? cushion : cloth; }
  friend Pair operator+(const Pair& a, const Pair& b) { return {a.cushion + b.cushion, a.cloth + b.cloth}; }
  friend Pair operator-(const Pair& a, const Pair& b) { return {a.cushion - b.cushion, a.cloth - b.cloth}; }
  friend Pair operator*(const Pair& a, const Pair& b) { return {a.cushion * b.cushion, a.cloth * b.cloth}; }
  friend Pair operator*(const T& a, const Pair& b) { return {a * b.cushion, a * b.cloth}; }
};

#if defined(__GNUC__)
template <>
struct Pair<double> {
  using Both [[gnu::vector_size(2 * sizeof(double))]] = double;
  Both both;

  Pair() = default;
  Pair(double cushion, double cloth) : both{cushion, cloth} {}
  explicit Pair(const Both& b) : both(b) {}

  double operator[](std::size_t k) const { return both[k]; }
  friend Pair operator+(const Pair& a, const Pair& b) { return Pair(a.both + b.both); }
  friend Pair operator-(const Pair& a, const Pair& b) { return Pair(a.both - b.both); }
  friend Pair operator*(const Pair& a, const Pair& b) { return Pair(a.both * b.both); }
  friend Pair operator*(double a, const Pair& b) { return Pair(a * b.both); }
};
#endif

}  // namespace bankshot::detail::mathavan
