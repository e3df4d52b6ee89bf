// SPDX-License-Identifier: MIT
#include "bankshot/simulate/acceptance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/motion/launched.hpp"
#include "bankshot/scene/puzzle.hpp"
#include "bankshot/simulate/simulator.hpp"
#include "bankshot/simulate/with_physics.hpp"

namespace bankshot {
namespace {

/// Simulates balls that roll at one pocket.
class Rolls {
 public:
  Rolls(const Scene& scene, int pocket, double speed)
      : physics_(scene.physics),
        boundary_(scene.table, scene.ball.body),
        pocket_(scene.table.pockets[static_cast<std::size_t>(pocket)]),
        contact_(Contact::pocket(pocket)),
        view_(view(scene.table, pocket_)),
        speed_(speed) {
    if (!(norm(view_.out) > 0))
      throw InvalidInput(fmt::format("/table/pockets/{}", pocket), "stands in the open: balls come from all sides");
  }

  int steepest() const { return static_cast<int>(std::ceil(degrees(view_.half_view))) - 1; }
  double widest() const { return pocket_.half() + norm(pocket_.at - pocket_.place()) + boundary_.body.radius; }

  Entry entry(double angle, double offset) const {
    const Vec2d u = turned(angle), to_place = pocket_.place() - pocket_.at;
    const Vec2d at = pocket_.at + perpendicular(u) * offset + u * (dot(u, to_place) - reach());
    if (boundary_.clearance(at) < -boundary_.touch) return Entry::past;
    const State<double> start = launched(at, boundary_.body.radius, u * speed_, LaunchSpin{.top = 1});
    return with_physics(physics_, [&](const auto& motion, const auto& cushion) {
      return followed(Simulator(boundary_, motion, cushion, start));
    });
  }

 private:
  double reach() const { return 6 * pocket_.half(); }

  Vec2d turned(double angle) const { return view_.out * std::cos(angle) + perpendicular(view_.out) * std::sin(angle); }

  template <class Sim>
  Entry followed(Sim sim) const {
    constexpr double far = 1.5;  // a ball this many times farther away than its start has left the pocket
    bool bounced = false, jaw = false;
    for (;;) {
      const Event e = sim.step();
      jaw = jaw || (e.kind == EventKind::jaw && e.contact.jaw_pocket() == contact_.index);
      bounced = bounced || e.bounces();
      if (e.kind == EventKind::pocket && e.contact == contact_) return bounced ? Entry::rattles : Entry::clean;
      if (e.final() || norm(sim.state().at - pocket_.place()) > far * reach()) return jaw ? Entry::out : Entry::past;
    }
  }

  const Physics& physics_;
  Boundary boundary_;
  const Pocket& pocket_;
  Contact contact_;
  PocketView view_;
  double speed_;
};

}  // namespace

const char* name(Entry entry) {
  constexpr const char* names[] = {"past", "comes-out", "rattles-in", "clean"};
  return names[static_cast<int>(entry)];
}

double Acceptance::width(int degrees, Entry at_least) const {
  return step * static_cast<double>(std::ranges::count_if(offsets(degrees), [&](Entry e) { return e >= at_least; }));
}

Acceptance acceptance(const Scene& scene, int pocket, double speed) {
  const Rolls rolls(scene, pocket, speed);
  Acceptance out{speed, rolls.steepest(), static_cast<int>(std::ceil(rolls.widest() / Acceptance::step))};
  for (int degree = -out.steepest; degree <= out.steepest; ++degree)
    for (int k = -out.widest; k <= out.widest; ++k)
      out.entries.push_back(rolls.entry(radians(degree), k * Acceptance::step));
  return out;
}

std::string to_csv(std::span<const Acceptance> windows) {
  std::string out = "speed_m_per_s,angle_deg,offset_m,entry\n";
  for (const Acceptance& w : windows)
    for (int degree = -w.steepest; degree <= w.steepest; ++degree)
      for (int k = -w.widest; k <= w.widest; ++k)
        fmt::format_to(std::back_inserter(out), "{},{},{:.4f},{}\n", w.speed, degree, k * Acceptance::step,
                       name(w.at(degree, k)));
  return out;
}

}  // namespace bankshot
