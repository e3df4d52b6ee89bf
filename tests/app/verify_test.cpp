// SPDX-License-Identifier: MIT
//
// `verify` as typed in a shell: correct answers pass, and each claim that is slightly altered is named.
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/scratch_file.hpp"
#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "support/catch.hpp"
#include "support/program.hpp"
#include "support/random_puzzle.hpp"

namespace {

using namespace bankshot;
using bankshot::test::Run;
using bankshot::test::run_program;
using bankshot::test::ScratchFile;
using Catch::Contains;
using Json = nlohmann::ordered_json;
using Pointer = Json::json_pointer;

Run verify(const std::string& puzzles, const std::string& answers) {
  const ScratchFile p("puzzles.jsonl"), s("shots.jsonl");
  std::ofstream(p.path, std::ios::binary) << puzzles;
  std::ofstream(s.path, std::ios::binary) << answers;
  return run_program("verify \"" + p.path + "\" \"" + s.path + "\"");
}

std::string answer_to(const std::string& puzzle, bool all = false) {
  const Puzzle p = read_puzzle(puzzle);
  return to_json(p, solve(p, {.all = all}), false) + "\n";
}

const std::string bank =
    R"({"id":"bank","table":"pool-9ft","ball":{"at":[0.635,0.4],"spin":{"top":0.5,"side":[0,0.4]}},"target":)"
    R"({"pocket":"bottom-middle"},"cushions":["top","right"],"angle":[0,90],"speed":[0.1,9],"arrive":{"speed":0.5}})";
const std::string stop =
    R"({"id":7,"table":"carom-10ft","ball":{"at":[0.7,0.5]},"target":{"point":[2.1,0.9]},"cushions":2})";
/// This shot is made by every draw, so the tolerance is nearly all that is allowed.
const std::string sure =
    R"({"id":"sure","table":"seed","physics":"rolling","ball":{"at":[1.2,0.5]},"target":{"point":[1.5,0.6],)"
    R"("within":0.1},"cushions":0,"arrive":{"speed":2}})";
const std::string pass = R"({"id":"pass","table":"seed","physics":"rolling","ball":{"at":[0.7,0.5]},"target":)"
                         R"({"point":[2.1,0.9]},"cushions":1,"arrive":{"speed":1.2}})";

}  // namespace

TEST_CASE("verify: an answer brings back what the puzzle is about") {
  const std::string said = "{\"about\":{\"title\":\"x\"}," + pass.substr(1), other = "{\"about\":[]," + pass.substr(1);
  CHECK(verify(said + "\n", answer_to(said)).exit == 0);
  CHECK_THAT(verify(said + "\n", answer_to(other)).out, Contains("form: does not bring back the puzzle's \"about\""));
  CHECK(verify(said + "\n", answer_to(pass)).exit == 1);
}

TEST_CASE("verify: honest answers of every kind hold") {
  std::string puzzles, answers;
  Random random(11);
  for (const test::Model model : {test::Model::ideal, test::Model::rolling, test::Model::spin})
    for (int i = 0; i < 24; ++i) {
      const std::string p = write_puzzle(test::random_puzzle(random, test::families[i % 4], model).puzzle);
      puzzles += p + "\n";
      answers += answer_to(p);
    }
  const std::string weak =
      R"({"id":"weak","table":"pool-9ft","ball":{"at":[0.635,0.4]},"target":{"pocket":"top-right"},"cushions":3,"speed":[0.1,0.2]})";
  for (const char* more : {R"("aim":"safest")", R"("prefer":"soft")"}) {
    const std::string p = pass.substr(0, pass.size() - 1) + "," + more + "}";
    puzzles += p + "\n";
    answers += answer_to(p);
  }
  const std::string far = R"({"table":{"length":2,"width":1},"physics":"ideal","ball":{"at":[0.3,0.4]},"target":)"
                          R"({"point":[1.5,0.7]},"cushions":200})";
  puzzles += far + "\n";
  answers += answer_to(far);
  puzzles += stop + "\n" + weak + "\n\n{\"id\":3,\"tabel\":1}\n";
  answers += answer_to(stop, true) + answer_to(weak);
  answers += R"({"status":"invalid","shots":[],"nearest":null,"error":{"path":"","reason":"empty"},"message":"empty"})"
             "\n";
  answers +=
      R"({"id":3,"status":"invalid","shots":[],"nearest":null,"error":{"path":"/tabel","reason":"unknown"},"message":"unknown"})"
      "\n";
  const Run run = verify(puzzles, answers);
  INFO(run.out);
  CHECK(run.exit == 0);
  CHECK(run.err.empty());
  CHECK_THAT(run.out,
             Contains("79 answers: 76 solved, 1 no-shot, 0 budget, 2 invalid") && Contains("every claim holds"));
  CHECK_THAT(run.out, !Contains("fails:"));
}

TEST_CASE("verify: jaws that are touched after the target was passed do not count") {
  int jaws = 0;
  for (const char* cushions : {"0", "1"}) {
    const std::string p =
        std::string(R"({"table":"pool-9ft","physics":"rolling","ball":{"at":[1.27,0.635]},"target":)") +
        R"({"point":[0.4405,0.2045]},"arrive":{"speed":1.5},"cushions":)" + cushions + "}";
    const Puzzle puzzle = read_puzzle(p);
    const Answer answer = solve(puzzle, {.all = true});
    REQUIRE(answer.status == Status::solved);
    for (const Shot& shot : answer.shots) {
      ShotRequest on = as_request(puzzle, shot);
      on.until = {};
      const Trajectory t = simulate(on);
      jaws += std::ranges::count(t.events, EventKind::jaw, &Record::kind) > 0 && !shot.path.touches_jaws;
    }
    const Run run = verify(p + "\n", to_json(puzzle, answer, false) + "\n");
    INFO(run.out);
    CHECK(run.exit == 0);
    // An answer that claims a jaw shot for a shot without jaws is refused.
    Json lies = Json::parse(to_json(puzzle, answer, false));
    lies["shots"][0]["rattles"] = true;
    CHECK_THAT(verify(p + "\n", lies.dump() + "\n").out, Contains("form: says that it touches jaws"));
  }
  CHECK(jaws > 0);
}

TEST_CASE("verify: mathavan2010 is replayed with finer impacts") {
  test::Random random(5);
  const std::string p =
      write_puzzle(test::random_puzzle(random, test::Family::uniform, test::Model::mathavan, 1).puzzle);
  const Puzzle puzzle = read_puzzle(p);
  const Run run = verify(p + "\n", to_json(puzzle, solve(puzzle, {.robustness = false}), false) + "\n");
  INFO(run.out);
  CHECK(run.exit == 0);
}

TEST_CASE("verify: each claim that is altered by a little is named") {
  struct Lie {
    const std::string& puzzle;
    const char* where;
    Json value;  ///< a number is added to the old value, anything else replaces it
    const char* named;
  };
  const std::vector<Lie> lies{
      {bank, "/id", "bunk", "id: the answer's is \"bunk\", the puzzle's \"bank\""},
      {bank, "/status", "no-shot", "form: has a shot and is not solved"},
      {bank, "/shots", Json::array(), "form: is solved and has no shot"},
      {bank, "/message", "", "form: has no message"},
      {bank, "/shots/0/speed", 1e-6, "speed asked: arrives at"},
      {bank, "/shots/0/speed", 1e-6, "arrival speed: says"},
      {bank, "/shots/0/angle", 1e-6, "miss: says"},
      {bank, "/shots/0/angle", 1e-6, "centre: does not reach the centre"},
      {bank, "/shots/0/angle", 5.0, "target: "},
      {bank, "/shots/0/angle", 180.0, "aim: "},
      {bank, "/shots/0/spin/top", 1e-9, "spin: top"},
      {bank, "/shots/0/spin/side", 0.5, "spin: top 0.5, side 0.5, masse 0 is not the spin asked"},
      {bank, "/shots/0/cushions", {"top", "left"}, "cushions: meets top, right, not top, left"},
      {bank, "/shots/0/miss", 1e-8, "miss: says 1e-08 m"},
      {bank, "/shots/0/arrival/time", 1e-6, "time: says"},
      {bank, "/shots/0/arrival/speed", 1e-8, "arrival speed: says"},
      {bank, "/shots/0/arrival/at/0", 1e-8, "place: says"},
      {bank, "/shots/0/condition", 1e-4, "condition: says"},
      {bank, "/shots/0/margin/angle/0", -1e-4, "margin: angle of"},
      {bank, "/shots/0/margin/angle/1", -1e-4, "does not break it"},
      {bank, "/shots/0/margin/speed/1", 1e-3, "is not made"},
      {bank, "/shots/0/margin/speed/0", 1e-3, "margin: speed of"},
      {bank, "/shots/0/success", -0.25, "success: says"},
      {sure, "/shots/0/success", -0.018, "success: says"},
      {stop, "/shots/0/cushions", {"top", "bottom", "top"}, "rule: 3 cushions, and 2 to 2 are asked"},
      {stop, "/shots/0/speed", 1e-7, "centre: "},
      {stop, "/shots/0/speed", 0.1, "target: stops "},
      {stop, "/shots/0/speed", 20, "launch speed: "},
      {stop, "/shots/0/arrival/time", 1e-6, "time: "},
      {stop, "/shots/0/arrival/speed", 1e-6, "arrival speed: "},
      {stop, "/shots/0/arrival/at/1", 1e-7, "place: "},
      {pass, "/shots/0/angle", 1e-6, "centre: "},
      {pass, "/shots/0/angle", 1.0, "target: "},
      {pass, "/shots/0/speed", 1e-7, "speed asked: "},
      {pass, "/shots/0/arrival/time", 1e-6, "time: "},
      {pass, "/shots/0/spin/top", -1.0, "spin: "},
  };
  std::string puzzles, answers;
  for (const Lie& lie : lies) {
    Json a = Json::parse(answer_to(lie.puzzle));
    Json& claim = a.at(Pointer(lie.where));
    REQUIRE(claim != lie.value);
    if (lie.value.is_number())
      claim = claim.get<double>() + lie.value.get<double>();
    else
      claim = lie.value;
    puzzles += lie.puzzle + "\n";
    answers += a.dump() + "\n";
  }
  const Run run = verify(puzzles, answers);
  CHECK(run.exit == 1);
  CHECK(run.err.empty());
  std::istringstream lines(run.out);
  int number = 0;
  for (const Lie& lie : lies) {
    std::string line;
    std::getline(lines, line);
    INFO(lie.where << " " << lie.value << ": " << line);
    ++number;
    CHECK_THAT(line, Contains(":" + std::to_string(number) + ": " +
                              (number == 1 ? "\"bank\"" : Json::parse(lie.puzzle)["id"].dump()) + " fails: "));
    CHECK_THAT(line, Contains(lie.named));
  }
  CHECK_THAT(run.out, Contains(std::to_string(lies.size()) + " of " + std::to_string(lies.size()) + " answers fail"));
}

TEST_CASE("verify: statuses that do not fit the puzzle") {
  const std::string invalid =
      R"({"id":"bank","status":"invalid","shots":[],"nearest":null,"error":{"path":"/x","reason":"y"},"message":"y"})";
  CHECK_THAT(verify(bank + "\n", invalid + "\n").out, Contains("status: is invalid, and the puzzle can be read"));
  Json a = Json::parse(answer_to(bank));
  const Run run = verify("{\"id\":\"bank\"}\n", a.dump() + "\n");
  CHECK(run.exit == 1);
  CHECK_THAT(run.out, Contains("status: the puzzle cannot be read, and the answer is not `invalid`"));
}

TEST_CASE("verify: a shot of several is named by its number, and keys it does not know are told") {
  Json a = Json::parse(answer_to(stop, true));
  REQUIRE(a["shots"].size() > 2);
  a["shots"][1]["miss"] = 1e-6;
  a["shots"][2]["colour"] = "red";
  const Run run = verify(stop + "\n", a.dump() + "\n");
  CHECK(run.exit == 1);
  CHECK_THAT(run.out,
             Contains("7 fails: shot 2, miss: says 1e-06 m") && Contains("not known here, so not checked: colour"));
}

TEST_CASE("verify: bad files are told with their line") {
  const std::string good = answer_to(bank);
  Json other = Json::parse(good);
  other["shots"][0]["pocket"] = "top-left";
  const std::string elsewhere = other.dump() + "\n";
  const auto [puzzles, answers, reason] = GENERATE_COPY(table<std::string, std::string, std::string>({
      {bank + "\n", "nonsense\n", "shots.jsonl:1: not JSON"},
      {bank + "\n" + bank + "\n", good + "{\"id\":\"bank\"}\n", "shots.jsonl:2: /status: this key is required"},
      {bank + "\n" + bank + "\n", good, "shots.jsonl:2: ends here, and "},
      {bank + "\n", elsewhere, "/shots/0/pocket: \"top-left\" is not the pocket that this shot reaches"},
      {bank + "\n", good + good, "shots.jsonl:2: has an answer more than "},
  }));
  const Run run = verify(puzzles, answers);
  CHECK(run.exit == 2);
  CHECK_THAT(run.err, Contains(reason));
  CHECK(run.err.find('\n') == run.err.size() - 1);
}

TEST_CASE("verify: files that cannot be read") {
  const Run none = run_program("verify /no/such.jsonl /no/such.jsonl");
  CHECK(none.exit == 2);
  CHECK_THAT(none.err, Contains("/no/such.jsonl: cannot be read: No such file"));
  CHECK(run_program("verify / /").exit == 2);
  CHECK_THAT(run_program("verify - -").err, Contains("cannot both be standard input"));
  CHECK(run_program("verify").exit == 2);
}

TEST_CASE("verify: a play in which the cue ball falls is not made") {
  // Straight into the pocket, and the cue ball follows the 8.
  const std::string p =
      R"({"table":"pool-9ft","ball":{"at":[1.27,0.6],"spin":{"top":1}},"others":[{"id":"8","at":[1.27,0.3]}],)"
      R"("target":{"ball":"8","then":{"pocket":"bottom-middle"}},"cushions":0,"aim":"centre","arrive":{"speed":1.5}})";
  const Json answer = Json::parse(answer_to(p));
  REQUIRE(answer.at("status") == "solved");
  const Json& shot = answer["shots"][0];
  REQUIRE(shot.at("scratch") == true);
  CHECK(shot.at("cue_rests") == "bottom-middle");
  CHECK(shot.at("margin").at("angle") == Json{0, 0});
  const Run honest = verify(p + "\n", answer.dump() + "\n");
  INFO(honest.out);
  CHECK(honest.exit == 0);
  Json lies = answer;
  lies["shots"][0]["success"] = 0.9;
  CHECK_THAT(verify(p + "\n", lies.dump() + "\n").out, Contains("success: says 0.9"));
  lies = answer;
  lies["shots"][0]["margin"]["angle"] = {-0.1, 0.1};
  CHECK_THAT(verify(p + "\n", lies.dump() + "\n").out, Contains("margin: is not 0, and the cue ball falls"));
}

TEST_CASE("verify: value is success less the costs of cushions, speed and tip") {
  const std::string p = R"({"table":"pool-9ft","ball":{"at":[0.635,0.4],"spin":{"side":0.5}},"target":)"
                        R"({"pocket":"bottom-middle"},"cushions":["top","right"],"aim":"centre"})";
  Json answer = Json::parse(answer_to(p));
  Json& shot = answer["shots"][0];
  REQUIRE(!shot.contains("rattles"));
  const double cost = 0.005 * 2 + 0.004 * shot.at("speed").get<double>() + 0.02 * 0.4 * 0.5;
  shot["value"] = shot.at("success").get<double>() - cost;
  CHECK(verify(p + "\n", answer.dump() + "\n").exit == 0);
  shot["value"] = shot.at("success").get<double>() - cost + 1e-6;
  CHECK_THAT(verify(p + "\n", answer.dump() + "\n").out, Contains("value: says"));
}

TEST_CASE("verify --noise holds answers against the player whom batch was asked for") {
  const std::string answer = run_program("solve --json --no-timing --noise beginner", bank).out;
  const ScratchFile p("puzzles.jsonl"), s("shots.jsonl");
  std::ofstream(p.path, std::ios::binary) << bank << "\n";
  std::ofstream(s.path, std::ios::binary) << answer;
  const std::string files = "\"" + p.path + "\" \"" + s.path + "\"";
  CHECK(run_program("verify --noise beginner " + files).exit == 0);
  CHECK_THAT(run_program("verify --noise pro " + files).out, Contains("success: says"));
  CHECK(run_program("verify --noise nobody " + files).exit == 2);
}
