// SPDX-License-Identifier: MIT
#include "support/program.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace bankshot::test {
namespace {

std::string slurp(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + path.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A folder that is removed with its owner.
class Scratch {
 public:
  Scratch() {
    std::string name = (std::filesystem::temp_directory_path() / "bankshot-test-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("cannot make a folder for the test");
    path = name;
  }
  ~Scratch() { std::filesystem::remove_all(path); }
  std::filesystem::path path;
};

}  // namespace

Run run_shell(std::string commands, const std::string& input) {
  const std::string word = "PROGRAM";
  for (std::size_t at = 0; (at = commands.find(word, at)) != std::string::npos;)
    commands.replace(at, word.size(), "\"" BANKSHOT_PROGRAM "\"");
  const Scratch scratch;
  const auto file = [&](const char* name) { return (scratch.path / name).string(); };
  std::ofstream(file("in"), std::ios::binary) << input;
  const std::string command =
      "{ " + commands + "\n} <\"" + file("in") + "\" >\"" + file("out") + "\" 2>\"" + file("err") + "\"";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), slurp(file("out")), slurp(file("err"))};
}

Run run_program(const std::string& arguments, const std::string& input) {
  return run_shell("PROGRAM " + arguments, input);
}

std::string read_repository_file(const std::string& path) {
  return slurp(std::filesystem::path(BANKSHOT_REPOSITORY) / path);
}

}  // namespace bankshot::test
