// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "analytic/closed_forms.hpp"
#include "model/errors.hpp"
#include "tests/analytic/scenes.hpp"

namespace grainproof::analytic {
namespace {

struct Refusal {
  std::string label;
  std::string form;
  std::function<void(Scene&)> spoil;
  std::string because;
};

Scene pair() {
  Scene scene = glass_scene();
  add_sphere(scene, Vec3::Zero(), Vec3::Zero());
  add_sphere(scene, {0.11, 0, 0}, {-1.0, 0, 0});
  return scene;
}

const Refusal refusals[] = {
    {"Flow", "normal_collision",
     [](Scene& s) {
       s.flow = UniformFlow{1e-3, Vec3::Zero()};
     },
     "fluid"},
    {"RotatingGravity", "normal_collision",
     [](Scene& s) {
       s.gravity = RotatingGravity{9.81, 2.0};
     },
     "gravity"},
    {"Periodic", "normal_collision",
     [](Scene& s) {
       s.domain.boundary[1] = Boundary::periodic;
       s.domain.lower[1] = s.particles[0].position[1] - 0.04;
     },
     "reaches one of its faces"},
    {"ThirdParticle", "normal_collision",
     [](Scene& s) {
       add_sphere(s, {9, 9, 9}, {0, 0, 0});
     },
     "3 particles"},
    {"Aside", "normal_collision", [](Scene& s) { s.particles[1].velocity.y() = 0.1; }, "line of centres"},
    {"Receding", "normal_collision", [](Scene& s) { s.particles[1].velocity.x() = 1.0; }, "never touch"},
    {"AllFixed", "normal_collision",
     [](Scene& s) {
       for (auto& p : s.particles) p.fixed = true;
     },
     "nothing moves"},
    {"NoCohesion", "cohesive_collision", [](Scene&) {}, "no cohesion"},
    {"HeadOn", "oblique_collision", [](Scene&) {}, "along the line"},
    {"NoWall", "sliding", [](Scene&) {}, "no wall"},
    {"NoWeight", "settling", [](Scene&) {}, "gravity does not pull"},
    {"NoFlow", "drag", [](Scene&) {}, "no uniform flow"},
    {"Meeting", "free_fall", [](Scene&) {}, "might meet"},
    {"MeetingInAStream", "drag",
     [](Scene& s) {
       s.flow = UniformFlow{1e-3, Vec3::Zero()};
     },
     "might meet"},
    {"MeetingAWall", "free_fall",
     [](Scene& s) {
       s.particles.pop_back();
       s.gravity = ConstantGravity{{0, 0, -9.81}};
       s.particles[0].position.z() = 0.0501;
       add_floor(s);
     },
     "might meet wall floor"},
};

class EveryRefusal : public testing::TestWithParam<Refusal> {};

TEST_P(EveryRefusal, SaysWhy) {
  Scene scene = pair();
  GetParam().spoil(scene);
  const auto form = make_closed_form(GetParam().form);
  const Support support = form->supports(scene, {});
  EXPECT_FALSE(support);
  EXPECT_NE(support.because.find(GetParam().because), std::string::npos) << support.because;
  EXPECT_THROW(form->observe(scene, {}), EngineFailed);
}

INSTANTIATE_TEST_SUITE_P(, EveryRefusal, testing::ValuesIn(refusals),
                         [](const auto& param) { return param.param.label; });

TEST(Refusals, ALedgerIsNotKept) {
  Request request;
  request.ledger = true;
  EXPECT_FALSE(make_closed_form("normal_collision")->supports(pair(), request));
}

TEST(Refusals, TheAnalyticEngineListsEveryReason) {
  Scene scene = pair();
  scene.flow = TaylorGreenFlow{1e-3, 1.0, 1.0};
  const Support support = make_analytic_engine()->supports(scene, {});
  EXPECT_FALSE(support);
  for (const auto name : closed_form_names()) EXPECT_NE(support.because.find(name), std::string::npos);
  EXPECT_THROW(make_analytic_engine()->observe(scene, {}), EngineFailed);
}

}  // namespace
}  // namespace grainproof::analytic
