// SPDX-License-Identifier: MIT
//
// The rows of the registry of cushion laws, and what is drawn from them.
#include "bankshot/contact/cushion_registry.hpp"

#include <algorithm>
#include <set>

#include "bankshot/scene/coefficients.hpp"
#include "bankshot/scene/json.hpp"
#include "planners/trace/varied.hpp"
#include "support/catch.hpp"
#include "support/models.hpp"

using namespace bankshot;
using namespace bankshot::test;

namespace {

constexpr std::string_view scene =
    R"("table": "pool-9ft", "ball": {"at": [0.6, 0.4], "radius": 0.028575}, "target": {"point": [1, 1]}})";

Puzzle read_with(const std::string& cushion) {
  return read_puzzle(R"({"physics": {"model": "spin", "cushion": )" + cushion + "}, " + std::string(scene));
}

Puzzle puzzle_with(const CushionVariant& cushion) {
  Puzzle p = read_with("{}");
  p.physics.cushion = cushion;
  if (double* const of_cloth = cloth_friction(p.physics.cushion))
    *of_cloth = std::get<SlideRoll>(p.physics.motion).sliding_friction;
  return p;
}

std::vector<double> numbers_of(const CushionVariant& cushion) {
  std::vector<double> out;
  const auto add = [&](double number) { out.push_back(number); };
  std::visit([&](const auto& law) { add(law.restitution.at_rest), for_each_number(law, add); }, cushion);
  return out;
}

/// Returns a law of each model that files can describe, with random coefficients.
std::vector<CushionVariant> random_laws(Random& r) {
  std::vector<CushionVariant> out;
  const auto add = [&]<class... Law>(std::type_identity<std::tuple<Law...>>) { (out.emplace_back(draw<Law>(r)), ...); };
  add(std::type_identity<Cushions>{});
  std::erase_if(out, [](const CushionVariant& law) { return !model_of(law).in_files; });
  return out;
}

}  // namespace

TEST_CASE("the rows of cushion laws are complete") {
  std::set<std::string_view> keys;
  for (const CushionModel& model : cushion_registry) {
    INFO(model.key);
    CHECK(keys.insert(model.key).second);
    CHECK(!model.about.empty());
    CHECK(find_cushion_model(model.key).has_value() == model.in_files);
    CHECK(!(model.tried_by_fit && (model.integrated || !model.in_files)));
  }
  CHECK(!find_cushion_model("rubber"));
  for (std::size_t i = 0; i < cushion_registry.size(); ++i) {
    INFO(cushion_registry[i].key);
    const CushionVariant law = default_cushion(i);
    CHECK(law.index() == i);
    CHECK(cushion_registry[i].integrated == (impact_tolerance(law) != nullptr));
    std::vector<const CushionCoefficient*> own;
    const auto add = [&](const CushionCoefficient& c, double) { own.push_back(&c); };
    std::visit([&](const auto& its) { for_each_coefficient(its, add); }, law);
    auto left = std::begin(cushion_coefficients);
    for (const CushionCoefficient* c : own) {
      left = std::find(left, std::end(cushion_coefficients), c);
      CHECK(left != std::end(cushion_coefficients));
    }
  }
}

TEST_CASE("every cushion law is read as it was written") {
  Random r(1);
  int read = 0;
  for (int i = 0; i < 20; ++i)
    for (const CushionVariant& law : random_laws(r)) {
      INFO(model_of(law).key);
      const Puzzle p = puzzle_with(law), again = read_puzzle(write_puzzle(p));
      CHECK(again.physics.cushion.index() == law.index());
      CHECK(numbers_of(again.physics.cushion) == numbers_of(p.physics.cushion));
      ++read;
    }
  CHECK(read >= 20 * 4);
}

TEST_CASE("a coefficient is found by its path, and belongs where the registry says") {
  Random r(2);
  int found = 0, refused = 0;
  for (const CushionVariant& law : random_laws(r))
    for (const CushionCoefficient* c : cushion_coefficients) {
      INFO(model_of(law).key << ", " << c->name);
      Puzzle p = puzzle_with(law);
      double* const place = find_coefficient(p.physics.cushion, *c);
      const auto by_path = coefficient(p.physics, c->name);
      CHECK(by_path == (place ? std::vector{place} : std::vector<double*>{}));
      CushionVariant usual = UsualCushion{};
      const bool may_stand = place || find_coefficient(usual, *c);
      const std::string given = R"({"model": ")" + std::string(model_of(law).key) + R"(", ")" + std::string(c->key()) +
                                R"(": )" + std::string(c->example) + "}";
      if (may_stand) {
        CHECK_NOTHROW(read_with(given));
        ++found;
      } else {
        CHECK_THROWS_WITH(read_with(given), Catch::Contains("alone"));
        ++refused;
      }
      if (!place) continue;
      for (const double beyond : {c->low - 0.5, c->high + 0.5}) {
        *place = beyond * c->scale(p.ball.body.radius);
        if (std::isfinite(beyond)) CHECK_THROWS_AS(validate(p), InvalidInput);
      }
    }
  CHECK(found >= 9);
  CHECK(refused >= 3);
}

TEST_CASE("every coefficient of a cushion can vary, under the name of its row") {
  Random r(3);
  for (const CushionVariant& law : random_laws(r)) {
    INFO(model_of(law).key);
    planning::VariedPhysics<planning::one_varies> varied(puzzle_with(law).physics);
    const auto named = varied.coefficients(false);
    const auto check = [&](const CushionCoefficient& c, double number) {
      const auto at = std::ranges::find(named, c.name, [](const auto& one) { return std::string_view(one.name); });
      REQUIRE(at != named.end());
      CHECK(at->at.front()->a == number);
    };
    std::visit([&](const auto& its) { for_each_coefficient(its, check); }, law);
  }
}

TEST_CASE("another law takes the coefficients that both have") {
  const Stronge from{.height = 0.035, .restitution = {0.8, -0.01}, .friction = 0.3, .frequency_ratio = 1.5};
  CushionVariant han = Han2005{}, mirror = Mirror{}, back = Stronge{};
  take_coefficients(han, from);
  take_coefficients(mirror, from);
  take_coefficients(back, han);
  CHECK(numbers_of(han) == std::vector<double>{0.8, 0.3, 0.035});
  CHECK(numbers_of(mirror) == std::vector<double>{0.8});
  CHECK(numbers_of(back) == std::vector<double>{0.8, 0.3, 0.035, 1.8});
}
