// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <ostream>
#include <string_view>

#include "opencl/engine.hpp"

namespace grainproof::faults {

/// One piece of one kernel file, as it is and as somebody might have written it by mistake.
struct KernelFault {
  const char* name;
  const char* file;
  const char* printed;
  const char* planted;
  const char* scene;  ///< the case that must notice
  opencl::Precision precision = opencl::Precision::double_precision;
  opencl::Path path = opencl::Path::automatic;
  double skin = -1.0;  ///< m; negative leaves it to the engine
  int samples = 0;     ///< of the case's sweep, where so few of them do; 0 is all
};

inline void PrintTo(const KernelFault& fault, std::ostream* out) {
  *out << fault.file << ": " << fault.planted;
}

inline constexpr std::array kernel_faults{
    KernelFault{"DashpotPushes", "linear_normal.cl", "- dashpot(law", "+ dashpot(law",
                "normal_collision_wall"},
    KernelFault{"PlaneTakesHalfTheMass", "walls_common.cl", "square_root(1 / self",
                "square_root((real)0.5 / self", "normal_collision_wall"},
    KernelFault{"ReducedMassLeftOut", "spheres.cl", "square_root(1 / (inverse_a + inverse_b))",
                "square_root(1 / inverse_a)", "normal_collision_two_bodies"},
    KernelFault{"NormalVelocityOfAParticleWithItself", "spheres.cl",
                "c.velocity = self.velocity - other.velocity", "c.velocity = self.velocity - self.velocity",
                "normal_collision_two_bodies"},
    KernelFault{"FrictionTimesVelocity", "friction_viscous.cl", "slip * (-force / speed)", "slip * (-force)",
                "oblique_wall"},
    KernelFault{"FrictionDrivesTheSlip", "friction_viscous.cl", "(-force / speed)", "(force / speed)",
                "oblique_wall"},
    KernelFault{"TensionAllowed", "linear_normal.cl", "return greater_of(force, law.lowest)", "return force",
                "no_tension"},
    KernelFault{"CohesionRepels", "contact.cl", "-attraction(", "attraction(", "cohesive_collision"},
    KernelFault{"CohesionFromTheBodySurface", "spheres.cl", "overlap_of(s, reach, w.box) : 0",
                "overlap_of(s, radii, w.box) : 0", "cohesive_collision"},
    KernelFault{"TrapezoidParenthesis", "euler_trapezoid.cl", "before + m.velocity",
                "before + (real)0.5 * m.velocity", "drag"},
    KernelFault{"KickOfHalfAStepTwice", "velocity_verlet.cl", "if (step > 1) {", "if (step > 0) {",
                "free_fall"},
    KernelFault{"DragHalved", "drag_in_force.cl", "* drag_rate(w, self.index)",
                "* (real)0.5 * drag_rate(w, self.index)", "drag"},
    KernelFault{"VortexWithThreeCosines", "flow_taylor_green.cl", "2 * amplitude * c.x * c.y * s.z",
                "2 * amplitude * c.x * s.y * c.z", "taylor_green"},
    KernelFault{"TorqueArmOfTheWholeRadius", "rotation.cl", "radius - (real)0.5 * overlap : radius",
                "radius : radius", "history_pair_liggghts"},
    KernelFault{"TorqueTheOtherWayRound", "rotation.cl", "arm * across(rubbing, normal)",
                "arm * across(normal, rubbing)", "sliding_to_rolling"},
    KernelFault{"SpinsSubtractedInAPair", "rotation.cl", "w.spins[i].xyz + arm_j", "w.spins[i].xyz - arm_j",
                "history_pair"},
    KernelFault{"SpringDoesNotTurn", "history.cl", "TURN_PROJECTS) return flat",
                "TURN_PROJECTS) return spring", "history_pair"},
    KernelFault{"SpringKeptWhileItSlides", "history.cl", "g.spring = (g.force - damped) / stiffness;", "",
                "history_pair"},
    KernelFault{"SpringNotCutByTheStiffnessThatGrows", "history.cl", "return stiffer ?", "return false ?",
                "hertz_memory"},
    KernelFault{"HalfOfMindlinsStiffness", "history.cl", "const real stiffness = law.spring * rise.factor",
                "const real stiffness = (real)0.5 * law.spring * rise.factor", "hertz_memory"},
    KernelFault{"SpringLostAtARebuild", "carry.cl", "known ? old_springs[", "false ? old_springs[",
                "history_pair", opencl::Precision::double_precision, opencl::Path::zoned, 0.0, 1},
    KernelFault{"SpringTurnedByTheDistanceAcrossTheBox", "spheres.cl", "  meet(load, c, law);",
                "  const real3 far = normalize(self.position.at.xyz - other.position.at.xyz);\n"
                "  c.memory->xyz -= dot(c.memory->xyz, far) * far;\n  meet(load, c, law);",
                "history_periodic"},
    KernelFault{"WallVelocityIgnored", "walls_common.cl", "self.velocity - c.surface", "self.velocity",
                "wall_dragging"},
    KernelFault{"MovingWallStaysWhereItIsDrawn", "walls_moving.cl", "return stand.tracked ? plane_through",
                "return false ? plane_through", "wall_vibrating"},
    KernelFault{"TurningWallHasNoSpeed", "walls_moving.cl", "stand.velocity.xyz + turning",
                "stand.velocity.xyz", "drum_spin_up"},
    KernelFault{"InsideOfACylinderWiderByTheRadius", "cylinders.cl", "inside ? -overlap_of(s, difference_of(",
                "inside ? -overlap_of(s, sum_of(", "cylinder_inside"},
    KernelFault{"OutsideOfACylinderNarrower", "cylinders.cl", ": overlap_of(s, sum_of(",
                ": overlap_of(s, difference_of(", "cylinder_outside"},
    KernelFault{"RollingDriven", "rolling_constant.cl", "(-most / rate)", "(most / rate)",
                "rolling_constant_torque"},
    KernelFault{"RollingTimesTheRate", "rolling_constant.cl", "(-most / rate)", "(-most)",
                "rolling_constant_torque"},
    KernelFault{"RollingSpringWithoutLimit", "rolling_spring.cl", "if (held > most) torque *= most / held;",
                "", "rolling_spring"},
    KernelFault{"RollingSpringWoundBackwards", "rolling_spring.cl", "xyz - (r.winding", "xyz + (r.winding",
                "rolling_pair_spring"},
    KernelFault{"QuaternionTurnedByTheWholeAngle", "quaternion.cl", "(real)0.5 * (real4)(v", "(real4)(v",
                "orientation_exponential"},
    KernelFault{"ImpulseOfAWallNotKept", "ledger_kept.cl", "force = (real4)(f, 0)", "force = (real4)(0)",
                "drum_spin_up"},
    KernelFault{"ForceOfAWallHasNoArm", "ledger_kept.cl", "(moment + a.couple", "(a.couple", "drum_spin_up"},
    KernelFault{"WorkOfAWallNotKept", "ledger_kept.cl", "  a->driven += along(force, surface);", "",
                "drum_spin_up"},
    KernelFault{"ImageOfAPairDropped", "position_double.cl",
                "d > half_period ? d - period :", "d > half_period ? d :", "periodic_gas"},
    KernelFault{"RemainderDropped", "position_fixed.cl", "*part = left - step;", "*part = 0;", "slow_drift",
                opencl::Precision::single_precision},
    KernelFault{"ZoneSearchOneSided", "pairs.cl", "z >= 0 && z < zones", "z >= 0 && z <= zone",
                "periodic_gas", opencl::Precision::double_precision, opencl::Path::zoned},
    KernelFault{"ListKeptTooLong", "steps.cl", "w.box->half_skin", "w.box->skin", "periodic_gas",
                opencl::Precision::double_precision, opencl::Path::zoned},
    KernelFault{"RectangleWithoutAnEdge", "position_double.cl", "d > half_extent ? d - half_extent",
                "d > half_extent ? 0", "hard_rectangle_edge"},
    KernelFault{"LeapUnnoticed", "drift.cl", "limits.y > 0", "limits.y < 0", "hard_leap_later"},
    KernelFault{"OverlapLimitIgnored", "spheres.cl", "if (c.overlap > w", "if (c.overlap < -w",
                "hard_too_soft"},
    KernelFault{"ListWithoutItsSkin", "pairs.cl", "sum_of(reach, w.box->skin)", "reach", "hard_one_zone"},
    KernelFault{"LastOfAZoneLeftOut", "pairs.cl", "m < to", "m + 1 < to", "hard_one_zone"},
    KernelFault{"ParticleMeetsItself", "pairs.cl", "j == self.index", "false", "hard_one_zone"},
    KernelFault{"WrappedAtOneFaceOnly", "position_double.cl", "x >= upper ? x - period", "x >= upper ? x",
                "hard_periodic_face"},
    KernelFault{"ImageOnTheOtherSide", "position_fixed.cl", "*whole -= images * period",
                "*whole += images * period", "hard_periodic_face", opencl::Precision::single_precision},
    KernelFault{"GravityLeftOut", "forces.cl", "self.inverse_mass + gravity", "self.inverse_mass",
                "hard_one_in_many_zones"},
};

/// Of every kind one or two, for every day; tests/faults/score.py plants all.
inline constexpr std::string_view quick_kernel_faults[] = {"ReducedMassLeftOut",
                                                           "FrictionTimesVelocity",
                                                           "CohesionRepels",
                                                           "DragHalved",
                                                           "TorqueArmOfTheWholeRadius",
                                                           "SpringDoesNotTurn",
                                                           "SpinsSubtractedInAPair",
                                                           "HalfOfMindlinsStiffness",
                                                           "WallVelocityIgnored",
                                                           "MovingWallStaysWhereItIsDrawn",
                                                           "OutsideOfACylinderNarrower",
                                                           "RollingSpringWoundBackwards",
                                                           "RemainderDropped",
                                                           "ZoneSearchOneSided",
                                                           "RectangleWithoutAnEdge",
                                                           "LeapUnnoticed",
                                                           "OverlapLimitIgnored",
                                                           "ListWithoutItsSkin",
                                                           "LastOfAZoneLeftOut",
                                                           "WrappedAtOneFaceOnly",
                                                           "ImageOnTheOtherSide",
                                                           "GravityLeftOut"};

}  // namespace grainproof::faults
