// SPDX-License-Identifier: MIT
//
// The answers to examples/puzzles/book.jsonl: a line each on standard output, and a page with all pictures.
//   puzzle_book PUZZLES.jsonl PAGE.svg
#include <fmt/format.h>

#include <fstream>

#include "bankshot/draw/page.hpp"
#include "bankshot/draw/svg.hpp"
#include "bankshot/geometry/boundary.hpp"
#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"

namespace {

using namespace bankshot;

std::string cushions(const Puzzle& p) {
  constexpr const char* numbers[] = {"Straight",       "One cushion",   "Two cushions",
                                     "Three cushions", "Four cushions", "Five cushions"};
  if (!p.cushions.sequence) return numbers[p.cushions.min];
  std::string names;
  for (const Contact c : *p.cushions.sequence) names += (names.empty() ? "By " : ", ") + contact_name(p.table, c);
  return names;
}

std::string question(const Puzzle& p) {
  const auto arrive = arrival_range(p);
  const std::string speed = p.speed.fixed() ? fmt::format(", struck at {:.2g} m/s", p.speed.low) : "";
  if (const auto* pocket = std::get_if<PocketTarget>(&p.target))
    return fmt::format("{} into {}{}", cushions(p), p.table.pockets[static_cast<std::size_t>(*pocket->pocket)].name,
                       speed);
  if (!arrive) return fmt::format("{} through the ring{}", cushions(p), speed);
  return cushions(p) +
         (arrive->high == 0 ? ", to rest in the ring" : fmt::format(" through the ring at {:.2g} m/s", arrive->low));
}

std::string scene(const Puzzle& p) {
  const Vec2d size = p.table.highest() - p.table.lowest();
  std::string out = p.table.is_rectangle() ? fmt::format("{:.3g} × {:.3g} m", size.x, size.y)
                                           : fmt::format("{} sides", p.table.vertices.size());
  for (const TablePreset& t : table_presets())
    if (make_table(t).vertices == p.table.vertices) out = t.name;
  out += is_ideal(p.physics)                                       ? ", no friction"
         : is_straight(p.physics)                                  ? ", rolling"
         : std::holds_alternative<Mathavan2010>(p.physics.cushion) ? ", spin after Mathavan"
                                                                   : ", spin";
  if (p.spin.top != 0) out += fmt::format(", top {:.2g}", p.spin.top);
  if (p.spin.side != 0) out += fmt::format(", side {:.2g}", p.spin.side);
  return out + (p.spin.masse != 0 ? fmt::format(", massé {:.2g}", p.spin.masse) : "");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return fmt::print(stderr, "usage: puzzle_book PUZZLES.jsonl PAGE.svg\n"), 2;
  std::vector<Chapter> book{{"Warming up", "thirty that a fair player makes nine times of ten", {}},
                            {"At home", "thirty that want care", {}},
                            {"Away", "thirty to be proud of", {}},
                            {"Only one", "ten where one answer was found, and no other", {}}};
  std::ifstream in(argv[1]);
  std::size_t number = 0;
  for (std::string line; std::getline(in, line); ++number) {
    const Puzzle puzzle = read_puzzle(line);
    const Answer answer = solve(puzzle);
    const Shot& shot = answer.shots.at(0);
    const std::string aim = fmt::format("{:.2f}°, {:.2f} m/s, chance {:.0f} %", degrees(shot.launch.angle),
                                        shot.launch.speed, 100 * *shot.success);
    fmt::print("{:3}  {:<32} {}\n", number + 1, aim, question(puzzle));
    constexpr std::size_t chapter = 30;  // puzzles; the last has 10
    book.at(number / chapter)
        .plates.push_back(
            {draw(puzzle, answer), fmt::format("{}", number + 1), {question(puzzle), scene(puzzle), aim}});
  }
  const PageStyle style{.columns = 5,
                        .plate = 480,
                        .ratio = 0.6,
                        .letter = 18,
                        .title = "One Hundred Bank Shots",
                        .subtitle = "every answer found by bankshot and proved by a forward simulation"};
  std::ofstream(argv[2]) << draw_page(book, style);
  return number == 100 ? 0 : 1;
}
