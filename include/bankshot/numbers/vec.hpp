// SPDX-License-Identifier: MIT
//
// Plane vectors over any scalar: double, a dual number, a 50-digit number.
// Mixed products (double × T) are allowed, because geometry is always double and motion is T.
#pragma once

#include <cmath>

#include "bankshot/numbers/scalar.hpp"

namespace bankshot {

template <class T>
struct Vec2 {
  T x{}, y{};

  Vec2& operator+=(const Vec2& o) { return x += o.x, y += o.y, *this; }
  Vec2& operator-=(const Vec2& o) { return x -= o.x, y -= o.y, *this; }
  friend Vec2 operator+(Vec2 a, const Vec2& b) { return a += b; }
  friend Vec2 operator-(Vec2 a, const Vec2& b) { return a -= b; }
  friend Vec2 operator-(const Vec2& a) { return {-a.x, -a.y}; }
  friend Vec2 operator*(const Vec2& a, const T& s) { return {a.x * s, a.y * s}; }
  friend Vec2 operator*(const T& s, const Vec2& a) { return a * s; }
  friend Vec2 operator/(const Vec2& a, const T& s) { return {a.x / s, a.y / s}; }
  friend bool operator==(const Vec2&, const Vec2&) = default;
};

using Vec2d = Vec2<double>;

/// Components along x, y and z; z is up.
template <class T>
struct Vec3 {
  T x{}, y{}, z{};
  friend bool operator==(const Vec3&, const Vec3&) = default;
};

template <class A, class B>
auto dot(const Vec2<A>& a, const Vec2<B>& b) {
  return a.x * b.x + a.y * b.y;
}

/// Returns the z component of a × b, which is positive if b lies anticlockwise of a.
template <class A, class B>
auto cross(const Vec2<A>& a, const Vec2<B>& b) {
  return a.x * b.y - a.y * b.x;
}

/// Multiplies a vector with derivatives by a plain number.
template <class T>
requires has_derivatives<T> Vec2<T>
operator*(const Vec2<T>& a, const Real<T>& s) { return {a.x * s, a.y * s}; }

template <class T>
Vec2<Real<T>> value(const Vec2<T>& a) {
  return {value(a.x), value(a.y)};
}

/// Returns `a` turned by +90 degrees.
template <class T>
Vec2<T> perpendicular(const Vec2<T>& a) {
  return {-a.y, a.x};
}

template <class T>
T norm(const Vec2<T>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}

/// Converts a vector to another scalar. Geometry, which is double, enters a computation in T this way.
template <class T, class U>
Vec2<T> to(const Vec2<U>& a) {
  return {T(a.x), T(a.y)};
}

}  // namespace bankshot
