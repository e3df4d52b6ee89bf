// SPDX-License-Identifier: MIT
//
// Tests `pocket` as typed in a shell.
#include "app/scratch_file.hpp"
#include "support/catch.hpp"
#include "support/program.hpp"

namespace {

using bankshot::test::Run;
using bankshot::test::run_program;
using bankshot::test::ScratchFile;
using Catch::Contains;

TEST_CASE("pocket: a table of lines, a picture and their widths") {
  const ScratchFile csv("window.csv"), svg("window.svg");
  const Run run = run_program("pocket pool-7ft bottom-left --speed 1 3 -o " + csv.path + " -o " + svg.path);
  REQUIRE(run.exit == 0);
  CHECK_THAT(run.out, Contains("0°      49.5    78.5      49.5    70.5"));
  CHECK_THAT(csv.text(), Catch::StartsWith("speed_m_per_s,angle_deg,offset_m,entry\n") &&
                             Contains("\n1,0,0.0000,clean\n") && Contains("\n3,20,-0.0200,comes-out\n"));
  CHECK_THAT(svg.text(), Contains("What pocket bottom-left takes") && Contains("3 m/s") && Contains("exact line"));
}

TEST_CASE("pocket: what is wrong is told in one line") {
  const auto error = [](const std::string& arguments) {
    const Run run = run_program("pocket " + arguments + " -o window.svg");
    CHECK(run.exit == 2);
    return run.err;
  };
  CHECK_THAT(error("pool-9ft bottom"), Contains("\"bottom\" is no pocket; known are bottom-left, bottom-middle"));
  CHECK_THAT(error("carom-10ft top-left"), Contains("this table has no pockets"));
  CHECK_THAT(error("pool-9f top-left"), Contains("table: "));
  CHECK_THAT(error("pool-9ft top-left --speed 0"), Contains("--speed"));
}

}  // namespace
