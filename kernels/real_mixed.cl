// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Forces and velocities as floats, beside positions in double.
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
typedef float real;
typedef float3 real3;
typedef float4 real4;
#define REAL_MAX FLT_MAX
#define PI ((real)0x1.921fb54442d18p+1f)
