// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <vector>

#include "model/scene.hpp"

namespace grainproof::opencl {

template <class Shape>
struct NearWall {
  Shape shape;
  std::int32_t material;
  std::int32_t index;  ///< among Scene::walls
};

/// The walls that a particle inside the domain can touch; rectangles without what lies far outside.
struct NearWalls {
  std::vector<NearWall<Plane>> planes;
  std::vector<NearWall<Rectangle>> rectangles;
};

NearWalls near_walls(const Scene& scene);

/// Half the largest effect diameter, m.
double largest_reach(const Scene& scene);

}  // namespace grainproof::opencl
