// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/linear_system.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "analytic/contact_scales.hpp"
#include "analytic/crowd.hpp"
#include "analytic/spectral_limit.hpp"
#include "tests/analytic/scenes.hpp"

namespace grainproof::analytic {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double k = 1e5, k_t = 2.0 / 7.0 * k, d = 0.1, squeeze = 1.0 - 1e-6;

/// Sites in units of a diameter, pressed together by 1e-6 of it in a periodic box.
Scene crystal(const std::vector<Vec3>& sites, const Vec3& box, bool friction) {
  Scene scene = glass_scene({k, Restitution{1.0}});
  scene.rotation = friction;
  if (friction)
    scene.contacts.set(0, 0, ContactLaws{LinearNormal{k, Restitution{1.0}}, HistoryFriction{0.5, k_t, 0.0}});
  scene.domain = {
      Vec3::Zero(), box * d * squeeze, {Boundary::periodic, Boundary::periodic, Boundary::periodic}};
  for (const Vec3& site : sites) add_sphere(scene, site * d * squeeze, Vec3::Zero());
  return scene;
}

Scene simple_cubic(bool friction) {
  std::vector<Vec3> sites;
  for (int i = 0; i < 64; ++i) sites.emplace_back(i % 4, i / 4 % 4, i / 16);
  return crystal(sites, Vec3::Constant(4.0), friction);
}

Scene face_centred(bool friction) {
  std::vector<Vec3> sites;
  for (int i = 0; i < 64; ++i)
    if ((i % 4 + i / 4 % 4 + i / 16) % 2 == 0)
      sites.push_back(Vec3(i % 4, i / 4 % 4, i / 16) * std::sqrt(0.5));
  return crystal(sites, Vec3::Constant(4.0 * std::sqrt(0.5)), friction);
}

double undamped(const Scene& scene) {
  return undamped_limit(symmetric_parts(scene, linearised(scene, Prestress::left_out)));
}

const double m = sphere_mass(2000.0, d);

TEST(LinearSystem, OfAPairHasItsReducedMassAndTwoSeventhsForItsSlip) {
  Scene scene = glass_scene({k, Restitution{1.0}});
  add_sphere(scene, Vec3(0.02, 0.01, 0.0), Vec3::Zero());
  add_sphere(scene, Vec3(0.02, 0.01, 0.0) + 0.0999 * Vec3(1, 2, 2) / 3.0, Vec3::Zero());
  EXPECT_NEAR(undamped(scene) / (2.0 / std::sqrt(2.0 * k / m)), 1.0, 1e-12);
  scene.rotation = true;
  scene.contacts.set(0, 0,
                     ContactLaws{LinearNormal{k, Restitution{1.0}}, HistoryFriction{0.5, 3.0 * k, 0.0}});
  EXPECT_NEAR(undamped(scene) / (2.0 / std::sqrt(3.5 * 3.0 * k * 2.0 / m)), 1.0, 1e-12);
}

TEST(LinearSystem, OfASimpleCubicLatticeIsStifferByTwo) {
  EXPECT_NEAR(undamped(simple_cubic(false)) / (2.0 / std::sqrt(4.0 * k / m)), 1.0, 1e-9);
}

TEST(LinearSystem, OfAFaceCentredLatticeIsStifferByFour) {
  EXPECT_NEAR(undamped(face_centred(false)) / (2.0 / std::sqrt(8.0 * k / m)), 1.0, 1e-9);
}

// All turn alike: each contact slips by 2 r ω, and 12 − 4 of its directions' parts stand across.
TEST(LinearSystem, OfAFaceCentredLatticeWithFrictionTurnsFastest) {
  EXPECT_NEAR(undamped(face_centred(true)) / (2.0 / std::sqrt(2.5 * 16.0 * k_t / m)), 1.0, 1e-9);
}

TEST(SymmetricParts, TogetherHaveTheSpectrumOfTheWhole) {
  const Scene scene = face_centred(true);
  const LinearSystem whole = linearised(scene, Prestress::kept);
  const auto spectrum = [](const LinearSystem& system) {
    return VectorXd(
        Eigen::SelfAdjointEigenSolver<MatrixXd>(system.stiffness + system.remembered).eigenvalues());
  };
  std::vector<double> of_parts;
  const auto parts = symmetric_parts(scene, whole);
  ASSERT_EQ(parts.size(), 8u);
  for (const LinearSystem& part : parts) {
    const VectorXd some = spectrum(part);
    of_parts.insert(of_parts.end(), some.begin(), some.end());
  }
  std::ranges::sort(of_parts);
  const VectorXd all = spectrum(whole);
  ASSERT_EQ(static_cast<std::size_t>(all.size()), of_parts.size());
  for (std::size_t i = 0; i < of_parts.size(); ++i)
    EXPECT_NEAR(of_parts[i], all[static_cast<Eigen::Index>(i)], 1e-10 * all.maxCoeff());
}

/// ½ k δ² of every contact, against which the matrix is held by differences.
double elastic_energy(const Scene& scene) {
  double energy = 0.0;
  for (std::size_t i = 0; i < scene.particles.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double overlap = d - (scene.particles[i].position - scene.particles[j].position).norm();
      if (overlap > 0.0) energy += 0.5 * k * overlap * overlap;
    }
  return energy;
}

TEST(LinearSystem, IsTheSecondDerivativeOfTheEnergyWherePrestressIsKept) {
  Scene scene = glass_scene({k, Restitution{1.0}});
  for (const Vec3& place : {Vec3(0, 0, 0), Vec3(0.09, 0.01, 0), Vec3(0.04, 0.08, 0.01)})
    add_sphere(scene, place, Vec3::Zero());
  const LinearSystem system = linearised(scene, Prestress::kept);
  const double h = 1e-5;
  for (Eigen::Index a = 0; a < 9; ++a)
    for (Eigen::Index b = 0; b < 9; ++b) {
      double difference = 0.0;
      for (const double one : {-h, h})
        for (const double other : {-h, h}) {
          Scene moved = scene;
          moved.particles[a / 3].position[a % 3] += one;
          moved.particles[b / 3].position[b % 3] += other;
          difference += one * other * elastic_energy(moved) / (4.0 * std::pow(h, 4));
        }
      EXPECT_NEAR(system.stiffness(a, b) * m, difference, 1e-4 * k) << a << " " << b;
    }
}

TEST(LinearSystem, LosesItsFreeMotionsAndNothingElse) {
  Scene scene = glass_scene();
  add_sphere(scene, Vec3::Zero(), Vec3::Zero());
  add_sphere(scene, Vec3(0.0999, 0.0, 0.0), Vec3::Zero());
  EXPECT_EQ(without_free_motions(linearised(scene, Prestress::left_out)).size(), 1);
}

/// Equal spheres about one, none touching another, in random directions.
std::vector<Vec3> random_neighbours(std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::vector<Vec3> found;
  for (int tried = 0; tried < 3000 && found.size() < 12; ++tried) {
    Vec3 one = Vec3(normal(random), normal(random), normal(random)).normalized();
    // Half of them lean on one before.
    if (!found.empty() && tried % 2 == 0) {
      const Vec3& other = found[random() % found.size()];
      one = (0.5 * other + std::sqrt(0.75) * (one - one.dot(other) * other).normalized()).normalized();
    }
    if (std::ranges::all_of(found, [&](const Vec3& other) { return one.dot(other) < 0.5 + 1e-12; }))
      found.push_back(one);
  }
  return found;
}

TEST(Crowd, IsNeverExceededByNeighboursThatFindRoom) {
  Scene scene = glass_scene();
  for (int i = 0; i < 30; ++i) add_sphere(scene, Vec3::Zero(), Vec3::Zero());
  const Crowd crowd = crowd_of(scene, d);
  std::mt19937 random(5);
  double along = 0.0, across = 0.0;
  for (int sample = 0; sample < 300; ++sample) {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    Vec3 resultant = Vec3::Zero();
    const auto neighbours = random_neighbours(random);
    for (const Vec3& one : neighbours) {
      sum += one * one.transpose();
      resultant += one;
    }
    EXPECT_LE(static_cast<double>(neighbours.size()), crowd.contacts);
    EXPECT_LE(resultant.norm(), crowd.resultant);
    const double here = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sum).eigenvalues().maxCoeff();
    EXPECT_LE(here, crowd.along);
    along = std::max(along, here);
    const double aside = static_cast<double>(neighbours.size()) -
                         Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sum).eigenvalues().minCoeff();
    EXPECT_LE(aside, crowd.across);
    across = std::max(across, aside);
  }
  EXPECT_GT(along, 3.0);  // or the search would say nothing
  EXPECT_GT(across, 6.0);
}

TEST(Crowd, CountsWallsThatCanBeTouchedTogether) {
  Scene scene = glass_scene();
  add_sphere(scene, Vec3::Constant(0.2), Vec3::Zero());
  for (int axis = 0; axis < 3; ++axis) {
    scene.walls.push_back({"low", 0, Plane{Vec3::Zero(), Vec3::Unit(axis)}});
    scene.walls.push_back({"high", 0, Plane{Vec3::Constant(0.5), -Vec3::Unit(axis)}});
  }
  const Crowd wide = crowd_of(scene, d), filled = crowd_of(scene, 0.5001);
  EXPECT_EQ(wide.contacts, 3.0);
  EXPECT_NEAR(wide.along, 1.0, 1e-12);
  EXPECT_EQ(filled.contacts, 6.0);
  EXPECT_NEAR(filled.along, 2.0, 1e-12);
}

TEST(Crowd, OfOneNeighbourIsNone) {
  Scene scene = glass_scene();
  add_sphere(scene, Vec3::Zero(), Vec3::Zero());
  EXPECT_TRUE(crowd_of(scene, d).alone());
  add_sphere(scene, Vec3(0.2, 0, 0), Vec3::Zero());
  EXPECT_TRUE(crowd_of(scene, d).alone());
  add_floor(scene);
  EXPECT_FALSE(crowd_of(scene, d).alone());
}

class GuardOfCrystals : public testing::TestWithParam<std::tuple<Integrator, double, bool>> {};

TEST_P(GuardOfCrystals, NeverPermitsAStepAboveTheirLimit) {
  const auto [integrator, restitution, friction] = GetParam();
  for (const auto make : {simple_cubic, face_centred}) {
    Scene scene = make(friction);
    scene.run.integrator = integrator;
    ContactLaws laws = scene.contacts.at(0, 0);
    laws.normal = LinearNormal{k, Restitution{restitution}};
    if (friction) laws.friction = HistoryFriction{0.5, k_t, 0.5};
    scene.contacts.set(0, 0, laws);
    const auto parts = symmetric_parts(scene, linearised(scene, Prestress::left_out));
    std::vector<LinearSystem> bound;
    for (const LinearSystem& part : parts) bound.push_back(without_free_motions(part));
    const double limit = spectral_limit(linear_scheme(integrator), bound);
    const double permitted = stability_limit(scene).step;
    EXPECT_LE(permitted, limit * (1.0 + 1e-4));
    // A guard that refuses everything would pass, too.
    if (make == face_centred) {
      EXPECT_GE(permitted, 0.5 * limit);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, GuardOfCrystals,
                         testing::Combine(testing::Values(Integrator::euler_trapezoid,
                                                          Integrator::velocity_verlet),
                                          testing::Values(1.0, 0.8, 0.1), testing::Bool()));

/// Of the quickest motion, by a step of that size: a dashpot along the tangent plane may itself be as large.
double growth_of(const Scene& scene, double h) {
  const LinearScheme& scheme = linear_scheme(scene.run.integrator);
  std::vector<LinearSystem> bound;
  for (const LinearSystem& part :
       symmetric_parts(scene, linearised(scene, Prestress::left_out, {scheme.weakens, h})))
    bound.push_back(without_free_motions(part));
  return growth_a_step(scheme, bound, h);
}

class GuardOfCreepingCrystals : public testing::TestWithParam<std::tuple<Integrator, bool, FrictionLaw>> {};

TEST_P(GuardOfCreepingCrystals, NeverPermitsAStepAboveTheirLimit) {
  const auto& [integrator, rotation, friction] = GetParam();
  Scene scene = face_centred(true);
  scene.rotation = rotation;
  scene.run.integrator = integrator;
  scene.contacts.set(0, 0, ContactLaws{LinearNormal{k, Restitution{0.8}}, friction});
  const double permitted = stability_limit(scene).step;
  EXPECT_LE(growth_of(scene, permitted), 1.0 + 1e-9);
  // A guard that refuses everything would pass, too.
  EXPECT_GT(growth_of(scene, 2.0 * permitted), 1.0 + 1e-6);
}

INSTANTIATE_TEST_SUITE_P(
    , GuardOfCreepingCrystals,
    testing::Combine(testing::Values(Integrator::euler_trapezoid, Integrator::velocity_verlet,
                                     Integrator::velocity_verlet_predicted,
                                     Integrator::velocity_verlet_implicit, Integrator::onset_corrected),
                     testing::Bool(),
                     testing::Values(FrictionLaw{StepFriction{0.5, k_t}},
                                     FrictionLaw{CollisionTimeFriction{0.5, k_t}},
                                     FrictionLaw{DampedFriction{0.5, k_t}})));

}  // namespace
}  // namespace grainproof::analytic
