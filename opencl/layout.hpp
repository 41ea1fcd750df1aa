// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "opencl/cl.hpp"
#include "opencl/precision.hpp"

/// The host's twins of the types in kernels/position_fixed.cl and kernels/position_double.cl,
/// kernels/world.cl. kernels/sizes.cl reports the device's sizes, which are compared whenever a program is
/// built.
namespace grainproof::opencl {

struct Single {
  static constexpr Precision precision = Precision::single_precision;
  using Real = cl_float;
  using Real4 = cl_float4;

  struct Position {
    cl_int4 whole;
    cl_float4 part;
  };
  struct Reach {
    cl_int whole;
    cl_float part;
  };
  struct Box {
    cl_int4 whole;
    cl_float4 part;
    cl_int4 period;
    cl_float4 period_part;
    cl_int4 half_period;
    cl_ulong4 zone_scale;
    cl_int4 zones;
    cl_float4 quantum;
    Reach skin;
    Reach half_skin;
  };
  struct PlaneShape {
    cl_int4 whole;
    cl_float4 part;
    cl_long4 normal_whole;
    cl_float4 normal_part;
    cl_float4 normal;
  };
  struct RectangleShape {
    Position centre;
    cl_int4 half_whole;
    cl_float4 half_part;
  };
  struct CylinderShape {
    PlaneShape across[2];
    Reach radius;
  };
  struct Wave {
    cl_ulong4 offset;
    cl_ulong4 turns;
    cl_float4 radians;
  };
};

struct Double {
  static constexpr Precision precision = Precision::double_precision;
  using Real = cl_double;
  using Real4 = cl_double4;
  using Reach = cl_double;

  struct Position {
    cl_double4 at;
  };
  struct Box {
    cl_double4 lower;
    cl_double4 upper;
    cl_double4 period;
    cl_double4 half_period;
    cl_double4 zone_scale;
    cl_int4 zones;
    Reach skin;
    Reach half_skin;
  };
  struct PlaneShape {
    cl_double4 point;
    cl_double4 normal;
  };
  struct RectangleShape {
    Position centre;
    cl_double4 half_extent;
  };
  struct CylinderShape {
    PlaneShape across[2];
    Reach radius;
  };
  struct Wave {
    cl_double4 origin;
    cl_double4 number;
  };
};

/// Positions of the one, all else of the other.
struct Mixed {
  static constexpr Precision precision = Precision::mixed_precision;
  using Real = Single::Real;
  using Real4 = Single::Real4;
  using Reach = Double::Reach;
  using Position = Double::Position;
  using Box = Double::Box;
  using PlaneShape = Double::PlaneShape;
  using RectangleShape = Double::RectangleShape;
  using CylinderShape = Double::CylinderShape;
  using Wave = Double::Wave;
};

/// What `f` makes of a precision's types: f(Single{}), f(Mixed{}) or f(Double{}).
template <class F>
auto with_types_of(Precision precision, const F& f) {
  switch (precision) {
    case Precision::single_precision:
      return f(Single{});
    case Precision::mixed_precision:
      return f(Mixed{});
    case Precision::double_precision:
      break;
  }
  return f(Double{});
}

template <class P>
struct Constants {
  typename P::Position gravity_centre;
  typename P::Wave wave;
  typename P::Real4 gravity;
  typename P::Real4 stream;
  typename P::Real4 time;
  typename P::Real4 limits;
  cl_int4 counts;
  cl_int4 walls;
};

template <class P>
struct PairLaw {
  typename P::Real stiffness, damping, damping_root_mass, lowest;
  typename P::Real friction, viscosity, viscosity_root_mass, cohesion;
  typename P::Real sliding, spring, spring_damping, spring_damping_root_mass;
  typename P::Real rolling;
  cl_int rolls, history, hertz;
};

template <class P>
struct Surface {
  typename P::Real4 velocity, spin, offset;
  cl_int4 wall;
};

template <class P>
struct PlaneOf {
  typename P::PlaneShape shape;
  Surface<P> surface;
};

template <class P>
struct RectangleOf {
  typename P::RectangleShape shape;
  Surface<P> surface;
};

template <class P>
struct CylinderOf {
  typename P::CylinderShape shape;
  Surface<P> surface;
};

template <class P>
struct Stand {
  typename P::RectangleShape shape;
  typename P::Real4 velocity, offset;
  cl_int tracked;
};

template <class P>
struct Tally {
  typename P::Real4 support, weight, drag, other, braking, rubbing, twisting, resisting;
};

template <class P>
struct LedgerSums {
  typename P::Real4 sum[3];
  typename P::Real4 rest[3];
  typename P::Real4 start;
};

template <class P>
struct WallTally {
  typename P::Real4 force, moment;
};

template <class P>
struct WallSums {
  typename P::Real4 sum[2];
  typename P::Real4 rest[2];
};

/// Bits of PairLaw::history, kernels/world.cl.
enum HistoryBit {
  limit_on_spring = 1,
  arm_shortened = 2,
  turn_projects = 4,
  remembers = 8,
  keeps_force = 16
};

/// Signals and causes of kernels/faults.cl.
enum Signal { stale_at, escaped_at, overlapped_at, halted, signal_count };
enum Cause { not_a_number = 1, left_domain = 2, too_deep = 3, leapt = 4 };
inline constexpr cl_int never = 0x7fffffff;

}  // namespace grainproof::opencl
