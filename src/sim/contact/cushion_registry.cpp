// SPDX-License-Identifier: MIT
#include "bankshot/contact/cushion_registry.hpp"

namespace bankshot {
namespace {

template <class Variant>
using NumberIn = std::conditional_t<std::is_const_v<Variant>, const double, double>;

template <class Variant>
NumberIn<Variant>* tolerance_in(Variant& cushion) {
  NumberIn<Variant>* place = nullptr;
  const auto find = [&]([[maybe_unused]] auto& law) {
    if constexpr (requires { law.tolerance; }) place = &law.tolerance;
  };
  std::visit(find, cushion);
  return place;
}

template <class Variant>
NumberIn<Variant>* friction_in(Variant& cushion) {
  NumberIn<Variant>* place = nullptr;
  const auto find = [&]([[maybe_unused]] auto& law) {
    if constexpr (requires { law.sliding_friction; }) place = &law.sliding_friction;
  };
  std::visit(find, cushion);
  return place;
}

}  // namespace

std::optional<std::size_t> find_cushion_model(std::string_view key) {
  for (std::size_t i = 0; i < cushion_registry.size(); ++i)
    if (cushion_registry[i].in_files && cushion_registry[i].key == key) return i;
  return {};
}

CushionVariant default_cushion(std::size_t index) {
  return []<class... Law>(std::type_identity<std::variant<Law...>>, std::size_t i) {
    const CushionVariant all[] = {Law{}...};
    return all[i];
  }(std::type_identity<CushionVariant>{}, index);
}

double* find_coefficient(CushionVariant& cushion, const CushionCoefficient& coefficient) {
  double* place = nullptr;
  const auto find = [&](const CushionCoefficient& c, double& number) {
    if (&c == &coefficient) place = &number;
  };
  std::visit([&](auto& law) { for_each_coefficient(law, find); }, cushion);
  return place;
}

void take_coefficients(CushionVariant& cushion, const CushionVariant& from) {
  const auto take = [&](const CushionCoefficient& c, double number) {
    if (double* const place = find_coefficient(cushion, c)) *place = number;
  };
  const Restitution e = std::visit([](const auto& law) { return law.restitution; }, from);
  std::visit([&](auto& law) { law.restitution = e; }, cushion);
  std::visit([&](const auto& law) { for_each_coefficient(law, take); }, from);
}

double* cloth_friction(CushionVariant& cushion) { return friction_in(cushion); }
const double* cloth_friction(const CushionVariant& cushion) { return friction_in(cushion); }

double* impact_tolerance(CushionVariant& cushion) { return tolerance_in(cushion); }
const double* impact_tolerance(const CushionVariant& cushion) { return tolerance_in(cushion); }

}  // namespace bankshot
