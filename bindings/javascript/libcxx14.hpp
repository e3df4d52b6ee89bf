// SPDX-License-Identifier: MIT
//
// C++20 features that our code uses and that libc++ 14 of emscripten 3.1.6 lacks. It is included before each of our
// files in the WebAssembly build, and nowhere else. It can be removed when Debian's emscripten has a newer libc++.
#pragma once

#include <algorithm>
#include <functional>
#include <iterator>
#include <thread>

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 15000

namespace std {
namespace ranges {

template <class Range, class Does>
bool any_of(Range&& range, Does does) {
  return std::any_of(std::begin(range), std::end(range), [&](auto&& x) -> bool { return std::invoke(does, x); });
}
template <class Range, class Does>
bool none_of(Range&& range, Does does) {
  return !ranges::any_of(range, does);
}
template <class Range, class Does>
bool all_of(Range&& range, Does does) {
  return std::all_of(std::begin(range), std::end(range), [&](auto&& x) -> bool { return std::invoke(does, x); });
}
template <class Range, class Does, class Part = identity>
auto find_if(Range&& range, Does does, Part part = {}) {
  return std::find_if(std::begin(range), std::end(range),
                      [&](auto&& x) -> bool { return std::invoke(does, std::invoke(part, x)); });
}
template <class Range, class T, class Part = identity>
auto find(Range&& range, const T& value, Part part = {}) {
  return ranges::find_if(
      range, [&](auto&& x) { return x == value; }, part);
}
template <class Range, class Does, class Part = identity>
auto count_if(Range&& range, Does does, Part part = {}) {
  return std::count_if(std::begin(range), std::end(range),
                       [&](auto&& x) -> bool { return std::invoke(does, std::invoke(part, x)); });
}
template <class Range, class T, class Part = identity>
auto count(Range&& range, const T& value, Part part = {}) {
  return ranges::count_if(
      range, [&](auto&& x) { return x == value; }, part);
}
template <class A, class B, class Same = std::equal_to<>>
bool equal(A&& a, B&& b, Same same = {}) {
  return std::equal(std::begin(a), std::end(a), std::begin(b), std::end(b),
                    [&](auto&& x, auto&& y) -> bool { return std::invoke(same, x, y); });
}
template <class Less, class Part>
auto by(Less& less, Part& part) {
  return [&](auto&& x, auto&& y) -> bool { return std::invoke(less, std::invoke(part, x), std::invoke(part, y)); };
}
template <class Range, class Less = std::less<>, class Part = identity>
void sort(Range&& range, Less less = {}, Part part = {}) {
  std::sort(std::begin(range), std::end(range), by(less, part));
}
template <class Range, class Less = std::less<>, class Part = identity>
void stable_sort(Range&& range, Less less = {}, Part part = {}) {
  std::stable_sort(std::begin(range), std::end(range), by(less, part));
}
template <class It, class Less = std::less<>, class Part = identity>
void stable_sort(It first, It last, Less less, Part part) {
  std::stable_sort(first, last, by(less, part));
}
template <class Range, class Less = std::less<>, class Part = identity>
auto min_element(Range&& range, Less less = {}, Part part = {}) {
  return std::min_element(std::begin(range), std::end(range), by(less, part));
}
template <class Range, class Less = std::less<>, class Part = identity>
auto max_element(Range&& range, Less less = {}, Part part = {}) {
  return std::max_element(std::begin(range), std::end(range), by(less, part));
}
template <class Range, class Does>
void for_each(Range&& range, Does does) {
  std::for_each(std::begin(range), std::end(range), does);
}
template <class Range, class T, class Less = std::less<>, class Part = identity>
auto lower_bound(Range&& range, const T& value, Less less = {}, Part part = {}) {
  return std::lower_bound(std::begin(range), std::end(range), value,
                          [&](auto&& x, const T& v) -> bool { return std::invoke(less, std::invoke(part, x), v); });
}
template <class Range, class T, class Less = std::less<>, class Part = identity>
auto upper_bound(Range&& range, const T& value, Less less = {}, Part part = {}) {
  return std::upper_bound(std::begin(range), std::end(range), value,
                          [&](const T& v, auto&& x) -> bool { return std::invoke(less, v, std::invoke(part, x)); });
}
template <class Range>
void reverse(Range&& range) {
  std::reverse(std::begin(range), std::end(range));
}
template <class Range, class To>
void move(Range&& range, To to) {
  std::move(std::begin(range), std::end(range), to);
}
template <class Range, class To, class Does>
void copy_if(Range&& range, To to, Does does) {
  std::copy_if(std::begin(range), std::end(range), to, does);
}

}  // namespace ranges

class jthread : public thread {
 public:
  using thread::thread;
  jthread(jthread&&) = default;
  jthread& operator=(jthread&&) = default;
  ~jthread() {
    if (joinable()) join();
  }
};

}  // namespace std

#endif
