// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/long_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "benchmarks/common/stability_cases.hpp"
#include "input/uniform.hpp"
#include "model/errors.hpp"
#include "reference_cpu/reference_engine.hpp"

namespace grainproof::bench {
namespace {

constexpr double glass = 2000.0;          // kg/m³
constexpr double stiffness = 1e5;         // N/m
constexpr double sphere = 0.1;            // m
constexpr double weight = 9.81;           // m/s²
constexpr double flight_share = 0.5;      // of a contact, between two of them
constexpr double steps_a_contact = 21.7;  // no whole number: every bounce begins at another phase of a step
constexpr std::int64_t period_steps = 1600;
constexpr double frequency = 100.0;  // Hz

double mass_of(const Scene& scene, const Particle& particle) {
  return scene.materials[particle.material].density * std::numbers::pi / 6.0 * std::pow(particle.diameter, 3);
}

Scene empty(const std::string& title, const Vec3& box, double density, const ContactLaws& laws) {
  Scene scene;
  scene.title = title;
  scene.run.end = 1.0;
  scene.run.sample_times = {0.0, 1.0};
  scene.domain = {Vec3::Zero(), box};
  scene.materials = {{"glass", density}};
  scene.contacts = ContactTable(1);
  scene.contacts.set(0, 0, laws);
  return scene;
}

void add(Scene& scene, double diameter, const Vec3& position, const Vec3& velocity = Vec3::Zero()) {
  const auto id = static_cast<std::int64_t>(scene.particles.size()) + 1;
  scene.particles.push_back({id, 0, false, diameter, diameter, position, velocity});
}

/// Two spheres of unlike mass in a box that they almost fill: they meet in its middle and across its faces in
/// turn. Their centre of mass is at rest.
LongPlan bounces(bool quick) {
  constexpr double one = 0.1, other = 0.096, box = 0.2;
  Scene scene = empty("bounces", Vec3(box, 0.5, 0.5), glass, {LinearNormal{stiffness, Restitution{1.0}}});
  scene.domain.boundary[0] = Boundary::periodic;
  add(scene, one, Vec3(0.25 * box, 0.25, 0.25));
  add(scene, other, Vec3(0.75 * box, 0.25, 0.25));
  const double contact = contact_time_of(scene), speed = (box - one - other) / (flight_share * contact);
  const double heavy = mass_of(scene, scene.particles[0]), light = mass_of(scene, scene.particles[1]);
  scene.particles[0].velocity.x() = speed * light / (heavy + light);
  scene.particles[1].velocity.x() = -speed * heavy / (heavy + light);
  scene.run.step = contact / steps_a_contact;
  LongPlan plan{"bounces", scene, 0, 100, 40, true, contact, speed, speed * contact / std::numbers::pi};
  plan.steps = static_cast<std::int64_t>(std::ceil((quick ? 1e4 : 1e6) * steps_a_bounce(plan)));
  return plan;
}

/// 25, 16 and 9 spheres in three layers, as cannonballs lie, a little apart and a little disturbed; in a
/// tray, since on a bare floor spheres roll from under such a heap.
Scene heaped(double restitution) {
  ContactLaws laws{LinearNormal{stiffness, Restitution{restitution}}};
  laws.friction = HistoryFriction{0.7, 2.0 / 7.0 * stiffness, 0.5};
  Scene scene = empty("pile", Vec3(1.0, 1.0, 0.5), glass, laws);
  scene.rotation = true;
  scene.walls.push_back({"floor", 0, Plane{Vec3::Zero(), Vec3::UnitZ()}});
  scene.gravity = ConstantGravity{-weight * Vec3::UnitZ()};
  input::Uniform uniform(5);
  const double spacing = 1.0005 * sphere;
  const double half = 0.5 * (4.0 * spacing + sphere) + 1e-4 * sphere;
  for (const int axis : {0, 1})
    for (const double side : {-1.0, 1.0})
      scene.walls.push_back(
          {(side < 0.0 ? "low " : "high ") + std::string(axis == 0 ? "x" : "y"), 0,
           Plane{Vec3(0.5, 0.5, 0.0) + side * half * Vec3::Unit(axis), -side * Vec3::Unit(axis)}});
  for (int layer = 0; layer < 3; ++layer)
    for (int i = 0; i < 5 - layer; ++i)
      for (int j = 0; j < 5 - layer; ++j)
        add(scene, sphere,
            Vec3(0.5 + (i - 0.5 * (4 - layer)) * spacing, 0.5 + (j - 0.5 * (4 - layer)) * spacing,
                 0.5 * sphere + layer * spacing * std::numbers::sqrt2 / 2.0) +
                1e-4 * sphere * (uniform.in_cube() + Vec3(0.0, 0.0, 1.0)));
  scene.run.step = contact_time_of(scene) / 50.0;
  return scene;
}

/// Come to rest under contacts that lose most of what is left, once for all engines: places and springs.
const State& settled_pile() {
  static const State state = [] {
    reference::ReferenceEngine engine;
    const auto run = engine.start(heaped(0.1), {});
    run->advance(300000);
    return run->state();
  }();
  return state;
}

LongPlan pile(bool quick) {
  Scene scene = heaped(0.5);
  const State& rest = settled_pile();
  for (std::size_t i = 0; i < scene.particles.size(); ++i) scene.particles[i].position = rest.position[i];
  scene.remembered = rest.contacts;
  LongPlan plan{"pile", scene, quick ? 100000 : 10000000, 100,
                16,     false, contact_time_of(scene),    std::sqrt(weight * sphere),
                1.0};
  plan.unit_overlap = at(seen(plan, first_frame(scene)), Look::overlap);
  return plan;
}

/// Ten layers of a hundred on a floor that shakes at three times their weight.
LongPlan vibrated(bool quick) {
  constexpr double d = 1e-3, soft = 100.0, accelerations = 3.0;
  ContactLaws laws{LinearNormal{soft, Restitution{0.9}}};
  laws.friction = HistoryFriction{0.5, 2.0 / 7.0 * soft, 0.5};
  Scene scene = empty("vibrated", Vec3(10.5 * d, 10.5 * d, 40.0 * d), 2500.0, laws);
  scene.domain.lower.z() = -d;
  scene.domain.boundary = {Boundary::periodic, Boundary::periodic, Boundary::open};
  scene.rotation = true;
  scene.gravity = ConstantGravity{-weight * Vec3::UnitZ()};
  const double amplitude = accelerations * weight / std::pow(2.0 * std::numbers::pi * frequency, 2);
  scene.walls.push_back(
      {"floor", 0, Plane{Vec3::Zero(), Vec3::UnitZ()}, Vibrating{amplitude * Vec3::UnitZ(), frequency, 0.0}});
  input::Uniform uniform(7);
  for (int n = 0; n < 1000; ++n)
    add(scene, d,
        d * (Vec3(0.525 + n % 10 * 1.05, 0.525 + n / 10 % 10 * 1.05, 0.53 + n / 100 * 1.05) +
             0.02 * uniform.in_cube()));
  scene.run.step = 1.0 / (frequency * static_cast<double>(period_steps));
  const std::int64_t periods = quick ? 6 : 625;
  return {"vibrated",
          scene,
          periods * period_steps,
          quick ? 6 : 125,
          quick ? 16 : 40,
          false,
          contact_time_of(scene),
          std::sqrt(weight * d),
          d};
}

/// Largest overlap, and the energy in normal springs.
struct Pressed {
  double overlap = 0.0, energy = 0.0;
};

double stiffness_of(const Scene& scene) {
  return std::get<LinearNormal>(scene.contacts.at(0, 0).normal).stiffness;
}

double height_above(const Wall& wall, const Vec3& x) {
  const auto& plane = std::get<Plane>(wall.shape);
  return (x - plane.point).dot(plane.normal);
}

Pressed pressed(const LongPlan& plan, const Frame& frame) {
  const Scene& scene = plan.scene;
  Pressed found;
  const auto add_overlap = [&](double overlap) {
    if (overlap <= 0.0) return;
    found.overlap = std::max(found.overlap, overlap);
    found.energy += 0.5 * stiffness_of(scene) * overlap * overlap;
  };
  std::vector<std::size_t> by_height(frame.position.size());
  for (std::size_t i = 0; i < by_height.size(); ++i) by_height[i] = i;
  std::ranges::sort(by_height, {}, [&](std::size_t i) { return frame.position[i].z(); });
  const double reach = std::ranges::max(scene.particles, {}, &Particle::diameter).diameter;
  for (std::size_t a = 0; a < by_height.size(); ++a)
    for (std::size_t b = a + 1; b < by_height.size(); ++b) {
      const std::size_t i = by_height[a], j = by_height[b];
      Vec3 between = frame.position[j] - frame.position[i];
      if (between.z() > reach) break;
      for (int axis = 0; axis < 3; ++axis)
        if (scene.domain.periodic(axis)) {
          const double period = scene.domain.extent()[axis];
          between[axis] -= period * std::round(between[axis] / period);
        }
      add_overlap(0.5 * (scene.particles[i].diameter + scene.particles[j].diameter) - between.norm());
    }
  // A floor that moves is not where it is drawn: its overlaps are left to the engine's own limit.
  for (const Wall& wall : scene.walls)
    if (std::holds_alternative<Still>(wall.motion))
      for (std::size_t i = 0; i < frame.position.size(); ++i)
        add_overlap(0.5 * scene.particles[i].diameter - height_above(wall, frame.position[i]));
  return found;
}

/// How far a body is from where it started, through the nearest faces.
Vec3 moved(const Scene& scene, const Frame& frame, std::size_t i) {
  Vec3 shift = frame.position[i] - scene.particles[i].position;
  for (int axis = 0; axis < 3; ++axis)
    if (scene.domain.periodic(axis))
      shift[axis] -= scene.domain.extent()[axis] * std::round(shift[axis] / scene.domain.extent()[axis]);
  return shift;
}

bool is_lost(const Scene& scene, const Vec3& x) {
  return !(x.allFinite() && (x.array() >= scene.domain.lower.array()).all() &&
           (x.array() <= scene.domain.upper.array()).all());
}

}  // namespace

Frame first_frame(const Scene& scene) {
  Frame frame;
  for (const Particle& particle : scene.particles) {
    frame.position.push_back(particle.position);
    frame.velocity.push_back(particle.velocity);
    if (scene.rotation) frame.angular_velocity.push_back(particle.angular_velocity);
  }
  return frame;
}

double steps_a_bounce(const LongPlan& plan) {
  return (1.0 + flight_share) * plan.contact_s / plan.scene.run.step;
}

/// Energy in all but tangential springs, J, and of the vibrated bed that of its motion only; momentum over
/// all mass, m/s, of the bed along x only; position of the centre, m, in the pile the largest way of a body,
/// in the bed the height of the centre.
Seen seen(const LongPlan& plan, const Frame& frame) {
  const Scene& scene = plan.scene;
  const bool bed = plan.name == "vibrated", heap = plan.name == "pile";
  const Pressed contacts = pressed(plan, frame);
  Seen found{};
  Vec3 momentum = Vec3::Zero(), centre = Vec3::Zero();
  double mass = 0.0, farthest = 0.0, kinetic = 0.0, height = 0.0;
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    const Particle& particle = scene.particles[i];
    const double m = mass_of(scene, particle);
    const Vec3& v = frame.velocity[i];
    const Vec3 way = moved(scene, frame, i);
    double speed = v.norm();
    kinetic += 0.5 * m * v.squaredNorm();
    if (scene.rotation) {
      const double rim = 0.5 * particle.diameter * frame.angular_velocity[i].norm();
      kinetic += 0.2 * m * rim * rim;
      speed = std::max(speed, rim);
    }
    mass += m;
    momentum += m * v;
    centre += m * way;
    height += m * frame.position[i].z();
    farthest = std::max(farthest, way.norm());
    at(found, Look::speed) = std::max(at(found, Look::speed), speed);
    at(found, Look::lost) += is_lost(scene, frame.position[i]) ? 1.0 : 0.0;
  }
  const double lifted = heap ? weight * height : 0.0;
  // Within a contact a scheme's own energy is another than the spring's: bounces count between contacts.
  const bool counts = plan.name != "bounces" || contacts.overlap == 0.0;
  at(found, Look::energy) = bed ? kinetic : counts ? kinetic + contacts.energy + lifted : 0.0;
  at(found, Look::momentum) = (bed ? momentum.x() : momentum.norm()) / mass;
  at(found, Look::position) = heap ? farthest : bed ? height / mass : centre.norm() / mass;
  at(found, Look::overlap) = contacts.overlap;
  return found;
}

LongPlan long_plan(const std::string& name, Integrator integrator, bool quick) {
  LongPlan plan;
  if (name == "bounces")
    plan = bounces(quick);
  else if (name == "pile")
    plan = pile(quick);
  else if (name == "vibrated")
    plan = vibrated(quick);
  else
    throw InputRefused("found scene " + name + "; expected bounces, pile or vibrated");
  plan.scene.run.integrator = integrator;
  return plan;
}

}  // namespace grainproof::bench
