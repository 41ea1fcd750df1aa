// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// A hundred thousand contacts in random states under every law, half of them with a moving wall: what the
// kernels make of each, against the reference. One step of the explicit trapezoid turns the forces of the
// start into velocities.
#include <cmath>
#include <random>

#include "device_fixture.hpp"
#include "opencl/pair_laws.hpp"
#include "reference_cpu/reference_engine.hpp"
#include "scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

constexpr std::size_t pairs = 50000, on_wall = 50000;
constexpr double mu = 0.4, k_t = 8e4, youngs = 6e7, poisson = 0.3;

struct SweptLaw {
  const char* name;
  ContactLaws laws;
};

void PrintTo(const SweptLaw& law, std::ostream* out) {
  *out << law.name;
}

const NormalLaw linear = LinearNormal{stiffness, Restitution{0.7}};
const NormalLaw hertz = HertzNormal{Restitution{0.7}};
const HistoryFriction lammps{mu, k_t, 0.5};
const HistoryFriction liggghts{mu, k_t, 1.0, CoulombLimit::spring, TorqueArm::overlap};
const HistoryFriction rescaled{
    mu, k_t, 0.3, CoulombLimit::spring, TorqueArm::radius, SpringTurn::project_and_rescale};
const HistoryFriction keeping{mu,
                              0.0,
                              0.5,
                              CoulombLimit::spring_and_dashpot,
                              TorqueArm::radius,
                              SpringTurn::project,
                              SpringMemory::force};

const SweptLaw swept[] = {
    {"linear", {linear}},
    {"damping_ratio_and_cohesion",
     {LinearNormal{stiffness, DampingRatio{0.2}}, Frictionless{}, LinearCohesion{2e4}}},
    {"no_tension_dynamic", {LinearNormal{stiffness, Restitution{0.6}, true}, DynamicFriction{mu}}},
    {"step_friction", {linear, StepFriction{mu, 100.0}}},
    {"collision_time_friction", {linear, CollisionTimeFriction{mu, 1e4}}},
    {"damped_friction", {linear, DampedFriction{mu, 1e4}}},
    {"history_of_lammps", {linear, lammps}},
    {"history_of_liggghts", {linear, liggghts}},
    {"history_rescaled", {linear, rescaled}},
    {"hertz", {hertz, lammps}},
    {"hertz_damping_ratio", {HertzNormal{DampingRatio{0.2}}, liggghts}},
    {"hertz_keeping_force", {hertz, keeping}},
    {"constant_rolling", {linear, lammps, NoCohesion{}, ConstantTorqueRolling{0.2}}},
    {"constant_rolling_hertz", {hertz, Frictionless{}, NoCohesion{}, ConstantTorqueRolling{0.2}}},
    {"spring_rolling", {linear, lammps, NoCohesion{}, SpringRolling{0.2}}},
    {"spring_rolling_hertz_shortened_arm", {hertz, liggghts, NoCohesion{}, SpringRolling{0.2}}},
};

class Dice {
 public:
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  Vec3 vector(double most) { return {between(-most, most), between(-most, most), between(-most, most)}; }

 private:
  std::mt19937_64 engine_{20261122};
};

/// Many single contacts, too far from each other to meet.
class ManyContacts {
 public:
  explicit ManyContacts(const ContactLaws& laws) : laws_(laws) {
    scene.domain = {Vec3(-18.0, -18.0, -2.0), Vec3(18.0, 18.0, 4.5), {}};
    scene.materials = {{"glass", density, Elasticity{youngs, poisson}}};
    scene.contacts = ContactTable(1);
    scene.contacts.set(0, 0, laws);
    scene.rotation = true;
    scene.walls = {{"belt", 0, Plane{Vec3::Zero(), Vec3::UnitZ()}, Translating{{0.4, -0.3, 0.2}}}};
    scene.run.integrator = Integrator::euler_trapezoid;
    scene.run.end = scene.run.step = 0.02;
    scene.run.overlap_limit = 100.0;
    scene.run.sample_times = {0.0, scene.run.end};
    for (std::size_t k = 0; k < pairs; ++k) add_pair(k);
    for (std::size_t k = 0; k < on_wall; ++k) add_on_wall(k);
  }

  Scene scene;
  std::vector<double> force_scale;  ///< of the contact of every particle, N

 private:
  Particle& add(const Vec3& position, double radius) {
    scene.particles.push_back(
        sphere(static_cast<std::int64_t>(scene.particles.size()), position, dice_.vector(1.0), 2 * radius));
    scene.particles.back().angular_velocity = dice_.vector(30.0);
    scene.particles.back().effect_diameter = 2.2 * radius;
    return scene.particles.back();
  }

  void add_pair(std::size_t k) {
    const Vec3 site(0.3 * static_cast<double>(k % 106) - 15.9,
                    0.3 * static_cast<double>(k / 106 % 106) - 15.9,
                    0.4 + 0.4 * static_cast<double>(k / (106 * 106)));
    const double one = dice_.between(0.03, 0.06), two = dice_.between(0.03, 0.06);
    const Vec3 n = dice_.vector(1.0).normalized();
    const double overlap = drawn_overlap();
    const Particle first = add(site, one);
    Particle& second = add(site + (one + two - overlap) * n, two);
    move_past(second, first.velocity + one * first.angular_velocity.cross(n), n);
    finish({first.id, second.id, 0, Vec3::Zero()}, n, overlap, one * two / (one + two), 2);
  }

  void add_on_wall(std::size_t k) {
    const double r = dice_.between(0.03, 0.06), overlap = drawn_overlap();
    const Vec3 site(0.14 * static_cast<double>(k % 224) - 15.7, 0.14 * static_cast<double>(k / 224) - 15.7,
                    r - overlap);
    Particle& body = add(site, r);
    move_past(body, std::get<Translating>(scene.walls[0].motion).velocity, Vec3::UnitZ());
    finish({body.id, -1, 0, Vec3::Zero()}, Vec3::UnitZ(), overlap, r, 1);
  }

  /// At a slip that has a direction in single precision too, where it is known to 2e-7 m/s.
  void move_past(Particle& body, const Vec3& surface, const Vec3& n) {
    while (true) {
      const Vec3 v = body.velocity - body.diameter / 2 * body.angular_velocity.cross(n) - surface;
      if ((v - v.dot(n) * n).norm() > 0.2) return;
      body.velocity = dice_.vector(1.0);
    }
  }

  /// Deep enough for the step to change velocities by more than a tenth of what they are: what is seen of a
  /// force in single is rounded with them.
  double drawn_overlap() { return dice_.between(2e-4, 1e-3); }

  void finish(ContactMemory memory, const Vec3& n, double overlap, double radius, std::size_t bodies) {
    const bool is_hertz = std::holds_alternative<HertzNormal>(laws_.normal);
    const double modulus = youngs / (2 * (1 - poisson * poisson));
    const double elastic =
        is_hertz ? 4.0 / 3.0 * modulus * std::sqrt(radius) * std::pow(overlap, 1.5) : stiffness * overlap;
    // A reach of a tenth of a radius is some millimetres.
    const auto* cohesion = std::get_if<LinearCohesion>(&laws_.cohesion);
    force_scale.insert(force_scale.end(), bodies,
                       elastic + (cohesion != nullptr ? cohesion->stiffness * 0.1 * radius : 0.0));
    const auto* history = std::get_if<HistoryFriction>(&laws_.friction);
    if (history == nullptr || dice_.between(0, 1) < 0.1) return;
    memory.tangential_displacement = nearly_across(n, 1.5 * mu * elastic / k_t);
    if (history->memory == SpringMemory::force) memory.overlap = overlap * dice_.between(0.5, 1.5);
    if (std::holds_alternative<SpringRolling>(laws_.rolling))
      memory.rolling_torque = dice_.vector(0.3 * radius * elastic);
    scene.remembered.push_back(memory);
  }

  /// A spring that has to be turned into the tangent plane, but does not stand upright on it.
  Vec3 nearly_across(const Vec3& n, double most) {
    const Vec3 drawn = dice_.vector(most), flat = drawn - drawn.dot(n) * n;
    return flat + 0.2 * flat.norm() * n;
  }

  ContactLaws laws_;
  Dice dice_;
};

struct Worst {
  double force = 0.0, torque = 0.0;  ///< over the force scale, and over it times the radius
};

Worst worst_difference(const ManyContacts& many, const Frame& seen, const Frame& expected) {
  Worst worst;
  for (std::size_t i = 0; i < seen.velocity.size(); ++i) {
    const Particle& p = many.scene.particles[i];
    const double h = many.scene.run.step, m = mass_of(p, many.scene), inertia = inertia_of(p, many.scene);
    const double force = m * (expected.velocity[i] - p.velocity).norm() / h;
    const double scale = std::max(force, many.force_scale[i]);
    const double d_force = m * (seen.velocity[i] - expected.velocity[i]).norm() / h;
    const double d_torque = inertia * (seen.angular_velocity[i] - expected.angular_velocity[i]).norm() / h;
    // Written so that NaN counts.
    if (!(d_force / scale <= worst.force)) worst.force = d_force / scale;
    if (!(d_torque / (scale * p.diameter / 2) <= worst.torque))
      worst.torque = d_torque / (scale * p.diameter / 2);
  }
  return worst;
}

class ForceSweep : public ::testing::TestWithParam<SweptLaw> {};

TEST_P(ForceSweep, EveryContactIsAsTheReferenceHasIt) {
  const ManyContacts many(GetParam().laws);
  reference::ReferenceEngine reference;
  ASSERT_TRUE(reference.supports(many.scene, {})) << reference.supports(many.scene, {}).because;
  const Frame expected = reference.observe(many.scene, {}).frames.back();
  ASSERT_EQ(expected.step, 1) << "the reference did not take the step";
  for (const Precision precision : {Precision::double_precision, Precision::single_precision}) {
    const Frame seen = observed(options_for(precision), many.scene).frames.back();
    const Worst worst = worst_difference(many, seen, expected);
    const bool is_double = precision == Precision::double_precision;
    RecordProperty(is_double ? "double_force" : "single_force", ::testing::PrintToString(worst.force));
    RecordProperty(is_double ? "double_torque" : "single_torque", ::testing::PrintToString(worst.torque));
    // An overlap of 0.4 % of a radius is known to 250 roundings of 2^-53, which is 3e-14 of the force; single
    // keeps positions as integers, so that a dozen roundings of forces and velocities remain, of 6e-8 each.
    const double tolerance = is_double ? 1e-12 : 2e-6;
    EXPECT_LE(worst.force, tolerance) << name_of(precision);
    EXPECT_LE(worst.torque, tolerance) << name_of(precision);
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, ForceSweep, ::testing::ValuesIn(swept),
                         [](const auto& param) { return std::string(param.param.name); });

}  // namespace
}  // namespace grainproof::opencl::testing
