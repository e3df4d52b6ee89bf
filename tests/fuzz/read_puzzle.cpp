// SPDX-License-Identifier: MIT
//
// Reads any text as a puzzle and as a shot. The reader must either understand it, so that it is written and read back
// to the same, or refuse it with an answer that is one line of JSON.
//
// With clang this is a libFuzzer target (CMake option BANKSHOT_FUZZ):
//   build/fuzz/tests/fuzz_read_puzzle -max_total_time=600 found tests/fuzz/corpus
// Otherwise main.cpp runs the corpus and seeded changes of it.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "bankshot/plan/answer.hpp"
#include "bankshot/scene/json.hpp"

namespace {

using namespace bankshot;

void require(bool holds, const char* what, std::string_view text) {
  if (holds) return;
  std::fprintf(stderr, "%s: %.*s\n", what, static_cast<int>(text.size()), text.data());
  std::abort();
}

template <class Read>
void refused_in_one_line(Read&& read, std::string_view text) {
  try {
    read();
  } catch (const InvalidInput& e) {
    const std::string line = to_json(invalid_answer(read_id(text), e, read_about(text)));
    require(line.find('\n') == std::string::npos, "the answer is more than a line", text);
    require(nlohmann::json::accept(line), "the answer is no JSON", text);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  refused_in_one_line(
      [&] {
        const std::string once = write_puzzle(read_puzzle(text));
        try {
          require(write_puzzle(read_puzzle(once)) == once, "written and read again it differs", text);
        } catch (const InvalidInput& e) {
          require(false, e.what(), text);
        }
      },
      text);
  refused_in_one_line([&] { read_shot(text); }, text);
  return 0;
}
