// SPDX-License-Identifier: MIT
//
// Runs a fuzz target without libFuzzer: it tries every file of the corpus, and then seeded changes of these files
// (bytes, pieces moved and doubled, words of the format).
//   fuzz_read_puzzle [--runs N] [--seed S] FILE|FOLDER...
#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "support/random_puzzle.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

namespace fs = std::filesystem;
using bankshot::test::Random;

void run(const std::string& text) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
}

std::size_t place(Random& r, const std::string& text) {
  return static_cast<std::size_t>(r.integer(0, static_cast<int>(text.size())));
}

std::string piece(Random& r, const std::string& text) {
  const std::size_t begin = place(r, text);
  return text.substr(begin, static_cast<std::size_t>(r.integer(0, 30)));
}

std::string changed(Random& r, std::string text, const std::string& other) {
  static const std::vector<std::string> words{"0",
                                              "-0",
                                              "1e999",
                                              "-1e-320",
                                              "1e308",
                                              "20000",
                                              "[]",
                                              "{}",
                                              "null",
                                              "true",
                                              "\"\"",
                                              "\\u0000",
                                              "\\ud800",
                                              "\"id\":",
                                              "\"v0\"",
                                              "[1,2]",
                                              ",",
                                              "\"any\"",
                                              "\"mathavan2010\"",
                                              "0.5",
                                              "\xff",
                                              std::string(1, '\0')};
  for (int changes = r.integer(1, 4); changes > 0; --changes) {
    const std::size_t at = place(r, text);
    switch (r.integer(0, 5)) {
      case 0:
        text.insert(at, piece(r, other));
        break;
      case 1:
        text.erase(at, static_cast<std::size_t>(r.integer(1, 20)));
        break;
      case 2:
        text.insert(at, words[static_cast<std::size_t>(r.integer(0, static_cast<int>(words.size()) - 1))]);
        break;
      case 3:
        text.insert(at, 1, static_cast<char>(r.integer(0, 255)));
        break;
      case 4: {
        // Replaces one number by another, because most of a puzzle is numbers.
        const std::size_t begin = text.find_first_of("0123456789", at);
        if (begin == std::string::npos) break;
        const std::size_t end = std::min(text.size(), text.find_first_not_of("0123456789.e-", begin));
        text.replace(
            begin, end - begin,
            r.chance(0.3) ? words[static_cast<std::size_t>(r.integer(0, 5))] : std::to_string(r.uniform(-3, 3)));
        break;
      }
      default:
        if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << r.integer(0, 7)));
    }
  }
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Runs a corpus and seeded changes of it");
  long runs = 0;
  std::uint64_t seed = 1;
  std::vector<std::string> paths;
  app.add_option("--runs", runs, "Changed texts to try")->capture_default_str();
  app.add_option("--seed", seed)->capture_default_str();
  app.add_option("corpus", paths, "Files and folders")->required();
  CLI11_PARSE(app, argc, argv);
  std::vector<fs::path> files;
  for (const fs::path path : paths) {
    if (!fs::is_directory(path))
      files.push_back(path);
    else
      for (const auto& entry : fs::directory_iterator(path)) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());  // the same order, and so the same changes, on every machine
  std::vector<std::string> corpus;
  for (const fs::path& file : files) {
    std::ifstream in(file, std::ios::binary);
    corpus.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    run(corpus.back());
  }
  if (corpus.empty()) return std::cerr << "the corpus is empty\n", 1;
  Random random(seed);
  const auto any = [&]() -> const std::string& {
    return corpus[static_cast<std::size_t>(random.integer(0, static_cast<int>(corpus.size()) - 1))];
  };
  for (long i = 0; i < runs; ++i) run(changed(random, any(), any()));
  std::cout << "fuzz seed " << seed << ": " << corpus.size() << " files and " << runs
            << " changes of them are read or refused\n";
}
