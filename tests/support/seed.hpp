// SPDX-License-Identifier: MIT
//
// Seeds of the tests tagged [long]: the usual ones, or others when .ci/nightly sets BANKSHOT_SEED. Every failure names
// its seed.
#pragma once

#include <cstdint>
#include <cstdlib>

namespace bankshot::test {

inline std::uint64_t seed_or_fresh(std::uint64_t usual) {
  const char* fresh = std::getenv("BANKSHOT_SEED");
  return fresh ? std::strtoull(fresh, nullptr, 10) + usual : usual;
}

}  // namespace bankshot::test
