// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "varied_scenes.hpp"

#include <functional>
#include <map>
#include <random>

#include "scenes.hpp"
#include "varied_walls.hpp"

namespace grainproof::opencl::testing {
namespace {

constexpr double spacing = lattice_spacing;
constexpr int across = 3;

/// The uniform distribution of the standard library differs between libraries; this one does not.
class Dice {
 public:
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  Vec3 vector(double most) { return {between(-most, most), between(-most, most), between(-most, most)}; }

 private:
  std::mt19937_64 engine_{20260101};
};

void add_spheres(Scene& scene, int layers) {
  Dice dice;
  std::int64_t id = 10;
  for (int k = 0; k < layers; ++k)
    for (int j = 0; j < across; ++j)
      for (int i = 0; i < across; ++i) {
        const double d = dice.between(0.08, 0.12);
        const Vec3 site = scene.domain.lower + spacing * Vec3(i + 0.5, j + 0.5, k + 0.5);
        Particle p = sphere(id, site + dice.vector(0.005), dice.vector(3.0), d);
        p.effect_diameter = 1.1 * d;
        scene.particles.push_back(p);
        id += 3;
      }
}

void add_planes(Scene& scene) {
  for (int axis = 0; axis < 3; ++axis) {
    scene.domain.boundary[static_cast<std::size_t>(axis)] = Boundary::wall;
    const Vec3 normal = Vec3::Unit(axis);
    scene.walls.push_back({"lower", 0, Plane{scene.domain.lower, normal}});
    scene.walls.push_back({"upper", 0, Plane{scene.domain.upper, -normal}});
  }
}

/// Thin walls just inside the faces, closed but for rounding.
void add_rectangles(Scene& scene) {
  for (int axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true}) {
      Rectangle r{scene.domain.lower, scene.domain.upper};
      (upper ? r.lower : r.upper)[axis] = upper ? r.upper[axis] : r.lower[axis];
      scene.walls.push_back({upper ? "upper" : "lower", 0, r});
    }
  const Vec3 middle = (scene.domain.lower + scene.domain.upper) / 2;
  scene.walls.push_back({"shelf", 0, Rectangle{middle - Vec3(0.06, 0.01, 0), middle + Vec3(0.02, 0.03, 0)}});
}

Scene filled(int layers) {
  Scene scene = empty_scene(0.8);
  scene.domain.lower = {-0.1, 0.2, 3.0};
  scene.domain.upper = scene.domain.lower + spacing * Vec3(across, across, layers);
  scene.run.step /= 2;
  scene.run.end = varied_steps * scene.run.step;
  scene.run.sample_times = {0.0, scene.run.end};
  add_spheres(scene, layers);
  return scene;
}

Scene boxed(int layers) {
  Scene scene = filled(layers);
  add_planes(scene);
  scene.gravity = ConstantGravity{{0.3, 0, -9.81}};
  return scene;
}

Scene rubbing(int layers, FrictionLaw friction, bool no_tension = false) {
  Scene scene = boxed(layers);
  scene.contacts.set(0, 0, {LinearNormal{stiffness, Restitution{0.8}, no_tension}, friction, NoCohesion{}});
  return scene;
}

Scene of_integrator(int layers, Integrator integrator) {
  Scene scene = boxed(layers);
  scene.run.integrator = integrator;
  scene.flow = UniformFlow{0.05, {1, 0, 0.5}};
  return scene;
}

Scene periodic(int layers) {
  Scene scene = filled(layers);
  scene.domain.boundary = {Boundary::periodic, Boundary::periodic, Boundary::periodic};
  return scene;
}

Scene sticky(int layers) {
  Scene scene = boxed(layers);
  scene.contacts.set(0, 0,
                     {LinearNormal{stiffness, Restitution{0.8}, false}, Frictionless{}, LinearCohesion{5e3}});
  return scene;
}

Scene of_two_materials(int layers) {
  Scene scene = boxed(layers);
  scene.materials.push_back({"lead", 11000.0});
  scene.contacts = ContactTable(2);
  scene.contacts.set(0, 0,
                     {LinearNormal{stiffness, Restitution{0.8}, false}, DynamicFriction{0.3}, NoCohesion{}});
  scene.contacts.set(0, 1, {LinearNormal{2e5, Damping{50.0}, false}, Frictionless{}, LinearCohesion{1e3}});
  scene.contacts.set(1, 1, {LinearNormal{3e5, Restitution{0.5}, true}, StepFriction{0.5, 1e5}, NoCohesion{}});
  for (std::size_t i = 0; i < scene.particles.size(); i += 3) scene.particles[i].material = 1;
  scene.walls[0].material = 1;
  return scene;
}

Scene with_fixed(int layers) {
  Scene scene = rubbing(layers, DampedFriction{0.4, 1e5});
  for (std::size_t i = 0; i < scene.particles.size(); i += 5) {
    scene.particles[i].fixed = true;
    scene.particles[i].velocity = Vec3::Zero();
  }
  return scene;
}

Scene in_vortices(int layers) {
  Scene scene = periodic(layers);
  scene.domain.boundary[2] = Boundary::open;
  scene.flow = TaylorGreenFlow{0.2, 2.0, 7.5};
  scene.domain.lower.z() -= 1.0;
  scene.domain.upper.z() += 1.0;
  return scene;
}

Scene around_a_centre(int layers) {
  Scene scene = filled(layers);
  add_rectangles(scene);
  scene.gravity = CentralGravity{9.81, (scene.domain.lower + scene.domain.upper) / 2};
  return scene;
}

Scene shaken(int layers) {
  Scene scene = boxed(layers);
  scene.gravity = RotatingGravity{9.81, 0.05};
  return scene;
}

Scene in_a_tilted_trough(int layers) {
  Scene scene = boxed(layers);
  const Vec3 normal = Vec3(0.3, -0.2, 1.0).normalized();
  const Vec3 nearest_site = scene.domain.lower + spacing * Vec3(0.5, across - 0.5, 0.5);
  scene.walls.push_back({"ramp", 0, Plane{nearest_site - 0.08 * normal, normal}});
  return scene;
}

/// Spheres that turn, each at its own rate.
void spin(Scene& scene) {
  Dice dice;
  scene.rotation = true;
  for (Particle& p : scene.particles) p.angular_velocity = dice.vector(40.0);
}

constexpr HistoryFriction lammps{0.5, 8e4, 0.5};
constexpr HistoryFriction liggghts{
    0.5, 8e4, 1.0, CoulombLimit::spring, TorqueArm::overlap, SpringTurn::project_and_rescale};
constexpr HistoryFriction projected{
    0.3, 8e4, 0.0, CoulombLimit::spring, TorqueArm::radius, SpringTurn::project};

Scene turning(int layers, FrictionLaw friction, Integrator integrator = Integrator::velocity_verlet) {
  Scene scene = rubbing(layers, friction);
  scene.run.integrator = integrator;
  spin(scene);
  return scene;
}

Scene turning_across_faces(int layers) {
  Scene scene = turning(layers, liggghts);
  scene.walls.clear();
  scene.domain.boundary = {Boundary::periodic, Boundary::periodic, Boundary::periodic};
  return scene;
}

Scene of_hertz(int layers) {
  Scene scene = turning(layers, Frictionless{});
  scene.materials[0].elasticity = Elasticity{2e6, 0.3};
  scene.contacts.set(0, 0, {HertzNormal{Restitution{0.7}}, HistoryFriction{0.5, 0.0, 1.0}, NoCohesion{}});
  return scene;
}

Scene of_hertz_and_springs(int layers) {
  Scene scene = of_two_materials(layers);
  spin(scene);
  for (Material& material : scene.materials) material.elasticity = Elasticity{3e6, 0.25};
  scene.contacts.set(0, 0, {HertzNormal{Restitution{0.8}}, DynamicFriction{0.3}, NoCohesion{}});
  scene.contacts.set(1, 1, {HertzNormal{Restitution{0.1}}, liggghts, LinearCohesion{1e3}});
  scene.contacts.set(0, 1, {LinearNormal{1e5, Restitution{0.5}, true}, lammps, NoCohesion{}});
  for (Particle& p : scene.particles)
    if (p.id % 7 == 0) {
      p.fixed = true;
      p.velocity = p.angular_velocity = Vec3::Zero();
    }
  return scene;
}

Scene in_rough_rectangles(int layers) {
  Scene scene = around_a_centre(layers);
  scene.contacts.set(0, 0, {LinearNormal{stiffness, Restitution{0.8}, false}, lammps, NoCohesion{}});
  spin(scene);
  return scene;
}

using Maker = std::function<Scene(int)>;

const std::map<std::string, Maker>& makers() {
  static const std::map<std::string, Maker> table{
      {"boxed", boxed},
      {"dynamic_friction", [](int n) { return rubbing(n, DynamicFriction{0.5}); }},
      {"step_friction",
       [](int n) {
         return rubbing(n, StepFriction{0.5, 1e5});
       }},
      {"collision_time_friction",
       [](int n) {
         return rubbing(n, CollisionTimeFriction{0.5, 1e5});
       }},
      {"damped_friction",
       [](int n) {
         return rubbing(n, DampedFriction{0.5, 1e5});
       }},
      {"no_tension", [](int n) { return rubbing(n, DynamicFriction{0.5}, true); }},
      {"euler_trapezoid", [](int n) { return of_integrator(n, Integrator::euler_trapezoid); }},
      {"implicit_drag", [](int n) { return of_integrator(n, Integrator::euler_trapezoid_implicit_drag); }},
      {"leapfrog_verlet", [](int n) { return of_integrator(n, Integrator::leapfrog_verlet); }},
      {"velocity_verlet", [](int n) { return of_integrator(n, Integrator::velocity_verlet); }},
      {"periodic", periodic},
      {"sticky", sticky},
      {"two_materials", of_two_materials},
      {"fixed", with_fixed},
      {"vortices", in_vortices},
      {"central_gravity_in_rectangles", around_a_centre},
      {"rotating_gravity", shaken},
      {"tilted_plane", in_a_tilted_trough},
      {"history", [](int n) { return rubbing(n, projected); }},
      {"turning_lammps", [](int n) { return turning(n, lammps, Integrator::leapfrog_verlet); }},
      {"turning_liggghts", [](int n) { return turning(n, liggghts); }},
      {"turning_damped",
       [](int n) {
         return turning(n, DampedFriction{0.5, 1e5}, Integrator::euler_trapezoid);
       }},
      {"turning_periodic", turning_across_faces},
      {"turning_in_rectangles", in_rough_rectangles},
      {"hertz", of_hertz},
      {"hertz_and_springs", of_hertz_and_springs},
      {"drum", [](int n) { return in_a_drum(turning(n, liggghts)); }},
      {"paddle", [](int n) { return swept_by_a_paddle(turning_across_faces(n)); }},
      {"rolling_steadily",
       [](int n) {
         return rolling_steadily(turning(n, DampedFriction{0.5, 1e5}, Integrator::leapfrog_verlet));
       }},
  };
  return table;
}

}  // namespace

std::vector<std::string> varied_scene_names() {
  std::vector<std::string> names;
  for (const auto& [name, maker] : makers()) names.push_back(name);
  return names;
}

Scene varied_scene(const std::string& name, int layers) {
  return makers().at(name)(layers);
}

}  // namespace grainproof::opencl::testing
