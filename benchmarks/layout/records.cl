// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// A particle as one record of 128 bytes, or as packed arrays: moving it, and looking at its partners.
typedef struct {
  float4 position;
  float4 velocity;
  float4 spin;
  float4 force;
  float4 torque;
  float4 properties[3];
} Record;

__kernel void move_records(__global Record* particle, float step) {
  const size_t i = get_global_id(0);
  const float4 velocity = particle[i].velocity + particle[i].force * step;
  particle[i].velocity = velocity;
  particle[i].position += velocity * step;
}

__kernel void move_arrays(__global float4* position, __global float4* velocity, __global const float4* force,
                          float step) {
  const size_t i = get_global_id(0);
  const float4 faster = velocity[i] + force[i] * step;
  velocity[i] = faster;
  position[i] += faster * step;
}

__kernel void gather_records(__global Record* particle, __global const int* starts, __global const int* partners) {
  const size_t i = get_global_id(0);
  const float4 here = particle[i].position;
  float4 force = (float4)(0.0f);
  for (int k = starts[i]; k < starts[i + 1]; ++k) {
    const float4 apart = particle[partners[k]].position - here;
    force += apart * fmax(1.0f - dot(apart, apart), 0.0f);
  }
  particle[i].force = force;
}

__kernel void gather_arrays(__global const float4* position, __global float4* forces, __global const int* starts,
                            __global const int* partners) {
  const size_t i = get_global_id(0);
  const float4 here = position[i];
  float4 force = (float4)(0.0f);
  for (int k = starts[i]; k < starts[i + 1]; ++k) {
    const float4 apart = position[partners[k]] - here;
    force += apart * fmax(1.0f - dot(apart, apart), 0.0f);
  }
  forces[i] = force;
}
