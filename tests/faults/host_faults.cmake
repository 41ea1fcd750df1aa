# SPDX-FileCopyrightText: 2026 The Grainproof authors
# SPDX-License-Identifier: BSD-3-Clause
# Mistakes in the reference and in the closed forms: an expression as it is, as somebody might have written it,
# and the case that must notice. Changed signs, dropped terms, wrong constants, stale buffers, zones that are off.
host_fault(MassOfACube FILE reference_cpu/bodies.cpp CASE settling
  PRINTED "std::numbers::pi"
  PLANTED "6.0")
host_fault(ReducedMassLeftOut FILE reference_cpu/contact_loops.hpp CASE normal_collision_two_bodies
  PRINTED "1.0 / (one.inverse_mass + two.inverse_mass)"
  PLANTED "1.0 / two.inverse_mass")
host_fault(FrictionDrivesTheSlip FILE reference_cpu/laws/friction.hpp CASE oblique_wall
  PRINTED "-magnitude / speed"
  PLANTED "magnitude / speed")
host_fault(CohesionRepels FILE reference_cpu/laws/linear_cohesion.hpp CASE cohesive_collision
  PRINTED "-stiffness * effect_overlap"
  PLANTED "stiffness * effect_overlap")
host_fault(LogarithmNotSquared FILE reference_cpu/laws/linear_normal.cpp CASE normal_collision_wall
  PRINTED "log * log"
  PLANTED "log")
host_fault(HalfStepOfTheStart FILE reference_cpu/integrators/leapfrog_verlet.cpp CASE free_fall
  PRINTED "steps_done == 0"
  PLANTED "steps_done < 0")
host_fault(InertiaOfADisc FILE reference_cpu/bodies.cpp CASE sliding_to_rolling
  PRINTED "0.4 * body.radius"
  PLANTED "0.5 * body.radius")
host_fault(ListKeptTooLong FILE reference_cpu/neighbours/verlet_list.cpp CASE gravity_shift_box
  PRINTED "4.0 * largest_square"
  PLANTED "0.01 * largest_square")
host_fault(DashpotPushes FILE reference_cpu/laws/linear_normal.hpp CASE normal_collision_wall
  PRINTED "eta * normal_velocity"
  PLANTED "-eta * normal_velocity")
host_fault(TensionAllowed FILE reference_cpu/laws/linear_normal.hpp CASE no_tension
  PRINTED "std::max(sum, 0.0)"
  PLANTED "sum")
host_fault(DashpotHalved FILE reference_cpu/laws/linear_normal.cpp CASE normal_collision_wall
  PRINTED "2.0 * ratio_for(law, given.value)"
  PLANTED "ratio_for(law, given.value)")
host_fault(LogarithmWithoutPi FILE reference_cpu/laws/linear_normal.cpp CASE normal_collision_wall
  PRINTED "std::numbers::pi * std::numbers::pi"
  PLANTED "1.0")
host_fault(DriftOfHalfAStep FILE reference_cpu/integrators/velocity_verlet.cpp CASE free_fall
  PRINTED "body.position += body.velocity * step"
  PLANTED "body.position += body.velocity * half_step")
host_fault(TrapezoidParenthesis FILE reference_cpu/integrators/euler_trapezoid.cpp CASE free_fall
  PRINTED "0.5 * step"
  PLANTED "step")
host_fault(ImplicitDragWithoutItsShare FILE reference_cpu/integrators/euler_trapezoid_implicit_drag.cpp CASE drag
  PRINTED "1.0 + steps_per_response"
  PLANTED "1.0")
host_fault(DragHalved FILE reference_cpu/laws/drag.hpp CASE drag
  PRINTED "18.0 * viscosity"
  PLANTED "9.0 * viscosity")
host_fault(DragAgainstTheStream FILE reference_cpu/laws/drag.hpp CASE drag
  PRINTED "rate * (fluid_velocity - velocity)"
  PLANTED "rate * (velocity - fluid_velocity)")
host_fault(VortexThatIsNotFreeOfDivergence FILE reference_cpu/laws/flow.cpp CASE taylor_green OPENCL
  PRINTED "-2.0 * sine.x()"
  PLANTED "2.0 * sine.x()")
host_fault(GravityTurnsEvenly FILE reference_cpu/laws/gravity.cpp CASE rotating_gravity OPENCL
  PRINTED "turns * turns"
  PLANTED "turns")
host_fault(HertzHalved FILE reference_cpu/laws/hertz_normal.hpp CASE hertz_unequal
  PRINTED "4.0 / 3.0 * modulus"
  PLANTED "2.0 / 3.0 * modulus")
host_fault(ComplianceWithoutPoisson FILE reference_cpu/laws/hertz_normal.cpp CASE chung_ooi_1
  PRINTED "1.0 - solid.poisson_ratio * solid.poisson_ratio"
  PLANTED "1.0")
host_fault(MindlinHalved FILE reference_cpu/laws/hertz_normal.cpp CASE hertz_memory OPENCL
  PRINTED "8.0 * shear_modulus"
  PLANTED "4.0 * shear_modulus")
host_fault(TsujiWithoutHisRoot FILE reference_cpu/laws/hertz_normal.cpp CASE chung_ooi_3
  PRINTED "2.0 * std::sqrt(5.0 / 6.0)"
  PLANTED "2.0")
host_fault(SpringCutWhileTheContactFalls FILE reference_cpu/contact_force.cpp CASE hertz_memory OPENCL
  PRINTED "springs.overlap < point.overlap"
  PLANTED "springs.overlap > point.overlap")
host_fault(RadiiAdded FILE reference_cpu/touch.hpp CASE hertz_unequal
  PRINTED "one * two / (one + two)"
  PLANTED "one + two")
host_fault(ArmNotShortened FILE reference_cpu/touch.hpp CASE history_pair_liggghts OPENCL
  PRINTED "laws.arm_shortening * meet.overlap"
  PLANTED "0.0 * meet.overlap")
host_fault(FrictionTurnsOneBodyOnly FILE reference_cpu/touch.hpp CASE history_pair OPENCL
  PRINTED "bodies_.angular_acceleration[meet.first] -= arms.first * normal_cross_friction"
  PLANTED "bodies_.angular_acceleration[meet.first] += arms.first * normal_cross_friction")
host_fault(SpringForgotten FILE reference_cpu/touch.hpp CASE history_pair OPENCL
  PRINTED "history_.recall(memory_key(meet), meet.second)"
  PLANTED "ContactSprings{}")
host_fault(RollingDriven FILE reference_cpu/laws/rolling.cpp CASE rolling_constant_torque
  PRINTED "-most / rate"
  PLANTED "most / rate")
host_fault(RollingSpringWithoutLimit FILE reference_cpu/laws/rolling.cpp CASE rolling_spring
  PRINTED "magnitude > most"
  PLANTED "false")
host_fault(RollingSpringWoundBackwards FILE reference_cpu/laws/rolling.cpp CASE rolling_pair_spring OPENCL
  PRINTED "stiffness * elapsed"
  PLANTED "-stiffness * elapsed")
host_fault(StaticFrictionWithoutTheStep FILE reference_cpu/laws/friction.cpp CASE sliding_step
  PRINTED "given.stiffness * step"
  PLANTED "given.stiffness")
host_fault(ContactTimeWithoutPi FILE reference_cpu/laws/friction.cpp CASE sliding_collision_time
  PRINTED "friction_stiffness * std::numbers::pi"
  PLANTED "friction_stiffness")
host_fault(DashpotLeftOutOfFriction FILE reference_cpu/laws/friction.hpp CASE sliding_damped_soft
  PRINTED "with_dashpot ? eta : 0.0"
  PLANTED "0.0")
host_fault(QuaternionTurnedByTheWholeAngle FILE reference_cpu/orientations.cpp CASE orientation_exponential
  PRINTED "0.5 * rotation.norm()"
  PLANTED "rotation.norm()")
host_fault(PlaneFromBehind FILE reference_cpu/surfaces.hpp CASE normal_collision_wall
  PRINTED "(position - plane.point).dot(plane.normal)"
  PLANTED "(plane.point - position).dot(plane.normal)")
host_fault(CylinderTooWide FILE reference_cpu/surfaces.hpp CASE cylinder_outside
  PRINTED "from_axis - cylinder.radius"
  PLANTED "from_axis + cylinder.radius")
host_fault(RectangleOfHalfItsSize FILE reference_cpu/surfaces.hpp CASE hard_rectangle_edge
  PRINTED "0.5 * (rectangle.upper - rectangle.lower)"
  PLANTED "0.25 * (rectangle.upper - rectangle.lower)")
host_fault(ImageOfAPairDropped FILE reference_cpu/periodic_box.hpp CASE hard_periodic_face
  PRINTED "apart[axis] -= period_[axis]"
  PLANTED "apart[axis] -= 0.0")
host_fault(WallContactWithoutVelocity FILE reference_cpu/contact_loops.hpp CASE normal_collision_wall
  PRINTED "body.velocity - meet.wall_velocity"
  PLANTED "body.velocity - body.velocity")
host_fault(VibrationWithoutItsRate FILE reference_cpu/walls.cpp CASE wall_vibrating
  PRINTED "rate * std::cos(angle)"
  PLANTED "std::cos(angle)")
host_fault(OneZoneOff FILE reference_cpu/neighbours/chain_cells.cpp CASE gravity_shift_box
  PRINTED "other > cell"
  PLANTED "other > cell + 1")
host_fault(ForcesNotCleared FILE reference_cpu/reference_run.cpp CASE free_fall
  PRINTED "std::ranges::fill(bodies_.acceleration, Vec3::Zero())"
  PLANTED "bodies_.acceleration.end()")
host_fault(WallsOneStepBehind FILE reference_cpu/reference_run.cpp CASE wall_vibrating
  PRINTED "walls_.move_to(time())"
  PLANTED "walls_.move_to(time() - scene_.run.step)")
host_fault(LeapUnnoticed FILE reference_cpu/reference_run.cpp CASE hard_leap_later
  PRINTED "body.velocity.squaredNorm() * (step * step)"
  PLANTED "0.0 * step")
host_fault(OverlapLimitIgnored FILE reference_cpu/contact_loops.hpp CASE hard_too_soft
  PRINTED "watch.overlap_limit() * std::min(one.radius, two.radius)"
  PLANTED "1e300")
host_fault(KineticEnergyDoubled FILE reference_cpu/ledger_keeper.cpp CASE hard_wall_over_fixed
  PRINTED "0.5 * bodies.mass[i]"
  PLANTED "bodies.mass[i]")
host_fault(DissipationOfTheWrongSign FILE reference_cpu/ledger_keeper.cpp CASE gas_turning
  PRINTED "-contact.dashpot.dot(path)"
  PLANTED "contact.dashpot.dot(path)")
host_fault(SpringLeavesOutCohesionE2 FILE analytic/passage.cpp CASE cohesive_sticking
  PRINTED "stiffness_ - attraction_"
  PLANTED "stiffness_")
host_fault(SphereMassOfItsRadius FILE analytic/contact_scales.cpp CASE settling
  PRINTED "density * pi / 6.0"
  PLANTED "density * pi / 3.0")
host_fault(ApproachWithAMinusE3 FILE analytic/linear_motion.cpp CASE cohesive_collision
  PRINTED "decay * (1.0 - 0.5 * lost)"
  PLANTED "decay * 0.5 * lost")
host_fault(DecayDoubled FILE analytic/linear_motion.cpp CASE normal_collision_wall
  PRINTED "equation.damping / (2.0 * equation.mass)"
  PLANTED "equation.damping / equation.mass")
host_fault(DampingRatioLinearised FILE analytic/contact_scales.cpp CASE mfix_01
  PRINTED "loss / std::hypot(pi, loss)"
  PLANTED "loss / pi")
host_fault(ClosedFrictionWithoutTheStep FILE analytic/slip_friction.cpp CASE sliding_step
  PRINTED "law.stiffness * step"
  PLANTED "law.stiffness")
host_fault(ClosedFrictionWithoutItsDashpot FILE analytic/slip_friction.cpp CASE sliding_damped
  PRINTED "law.stiffness * impact_time + damping(normal, e.mass)"
  PLANTED "law.stiffness * impact_time")
host_fault(OnsetImpulseHalved FILE reference_cpu/onset/events.cpp CASE onset_normal
  PRINTED "body.velocity += impulse * body.inverse_mass"
  PLANTED "body.velocity += 0.5 * impulse * body.inverse_mass")
host_fault(OnsetWithoutItsShift FILE reference_cpu/onset/events.cpp CASE onset_normal
  PRINTED "body.position += shift * body.inverse_mass"
  PLANTED "body.position += 0.0 * shift")
host_fault(DashpotThatSeesNothingOfItself FILE reference_cpu/implicit_touch.hpp CASE implicit_settling
  PRINTED "1.0 + half_step_ * damping * inverse_mass"
  PLANTED "1.0")
host_fault(SpringDoesNotRollAlong FILE reference_cpu/onset/half_step.hpp CASE onset_history OPENCL
  PRINTED "(spring.dot(meet.normal) * c) * along"
  PLANTED "0.0 * c * along")
host_fault(SlipDoesNotTurn FILE reference_cpu/laws/tangential_spring.cpp CASE onset_history OPENCL
  PRINTED "(2.0 / beyond) * rest - once"
  PLANTED "once")
host_fault(BendTheOtherWay FILE reference_cpu/onset/bends.hpp CASE onset_history OPENCL
  PRINTED "-0.5 * now_.step * room"
  PLANTED "0.5 * now_.step * room")
host_fault(TurnoverAsIfForTheWholeStep FILE reference_cpu/onset/bends.hpp CASE onset_history OPENCL
  PRINTED "crossing.elapsed - now_.step"
  PLANTED "0.0")
host_fault(ImpulseBeyondTheLimit FILE reference_cpu/onset/partial_contact.cpp CASE onset_history OPENCL
  PRINTED "most_first - held.dot(along)"
  PLANTED "most_first + held.dot(along)")
host_fault(ImplicitSlipOfABodyThatCannotTurn FILE reference_cpu/implicit_touch.hpp CASE oblique_schemes OPENCL
  PRINTED "arms.second * arms.second * spins[meet.second].inverse_inertia"
  PLANTED "0.0 * arms.second")
host_fault(NegativeKicksTakenForwards FILE reference_cpu/reference_run.cpp CASE pefrl_pressed
  PRINTED "part.kick * step"
  PLANTED "std::abs(part.kick) * step")
host_fault(SpringWithoutTheDriftToTheBoundary FILE reference_cpu/reference_run.cpp CASE oblique_schemes OPENCL
  PRINTED "(lacking + part.drift) * step"
  PLANTED "part.drift * step")
