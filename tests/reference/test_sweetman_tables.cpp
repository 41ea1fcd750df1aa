// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "reference_cpu/neighbours/all_pairs.hpp"
#include "reference_cpu/neighbours/chain_cells.hpp"
#include "tests/reference/scenes.hpp"

/// The worked examples of Sweetman, chapters 2 and 3. There particles and cells count from 1 and 0
/// means none; here they count from 0 and −1 means none.
namespace grainproof::testing {
namespace {

using namespace reference;

Bodies bodies_at(const std::vector<Vec3>& positions, double diameter) {
  Scene scene = empty_scene(linear(1e3, Damping{0.0}), 1e-4);
  for (const Vec3& position : positions) add_particle(scene, diameter, position);
  return bodies_of(scene);
}

// The positions stand in a figure that is lost. These have the printed neighbours: a triangular
// lattice of spacing 1.4 for diameter 1, where the search radius of half a diameter reaches 1.5, with
// particles 8 and 12 off it.
const std::vector<Vec3> twelve{{0.0, 0.0, 0.0},  {1.4, 0.0, 0.0},  {2.8, 0.0, 0.0},  {4.2, 0.0, 0.0},
                               {0.7, -1.2, 0.0}, {2.1, -1.2, 0.0}, {3.5, -1.2, 0.0}, {5.4, -0.6, 0.0},
                               {0.0, -2.4, 0.0}, {1.4, -2.4, 0.0}, {2.8, -2.4, 0.0}, {3.9, -3.3, 0.0}};

/// Table 2.1.
const std::vector<std::vector<int>> near_neighbours{
    {2, 5}, {3, 5, 6}, {4, 6, 7}, {7, 8}, {6, 9, 10}, {7, 10, 11}, {11}, {}, {10}, {11}, {12}, {}};

/// Tables 2.6 and 2.12: where each particle's entries begin, at seven words an entry.
const std::vector<int> nebor{1, 15, 36, 57, 71, 92, 113, 0, 120, 127, 134, 0};

void expect_printed_lists(const PairList& list) {
  for (std::size_t i = 0; i < twelve.size(); ++i) {
    std::vector<int> partners;
    for (int pair = list.first(i); pair < list.last(i); ++pair) partners.push_back(list.partner(pair) + 1);
    EXPECT_EQ(partners, near_neighbours[i]) << "particle " << i + 1;
    EXPECT_EQ(partners.empty() ? 0 : 1 + 7 * list.first(i), nebor[i]) << "particle " << i + 1;
  }
}

PeriodicBox open_box() {
  return PeriodicBox({.lower = Vec3::Constant(-10.0), .upper = Vec3::Constant(10.0)});
}

TEST(SweetmanTables, TwelveParticlesHaveTheListsOfTable2_1And2_12) {
  PairList list;
  list_all_pairs(bodies_at(twelve, 1.0), open_box(), 0.5, list);
  expect_printed_lists(list);
}

TEST(SweetmanTables, ChainCellsGiveTheSameLists) {
  const Bodies bodies = bodies_at(twelve, 1.0);
  ChainCells chains;
  chains.fill(grid_over(bodies, open_box(), 1.5), bodies);
  PairList list;
  chains.list_pairs(bodies, open_box(), 0.5, list);
  expect_printed_lists(list);
}

/// Table 3.1.
const std::vector<Vec3> twenty_five{
    {0.0, 0.0, 0.0},   {0.1, 0.0, 0.0},   {0.1, 0.15, 0.0},  {0.25, 0.0, 0.0},  {0.99, 0.99, 0.0},
    {0.26, 0.0, 0.0},  {0.27, 0.26, 0.0}, {0.0, 0.27, 0.0},  {0.0, 0.87, 0.0},  {0.2, 0.3, 0.0},
    {0.1, 0.5, 0.0},   {0.43, 0.54, 0.0}, {0.1, 0.7, 0.0},   {0.9, 0.2, 0.0},   {0.11, 0.65, 0.0},
    {0.1, 0.4, 0.0},   {0.1, 0.57, 0.0},  {0.6, 0.0, 0.0},   {0.2, 0.0, 0.0},   {0.11, 0.23, 0.0},
    {0.29, 0.76, 0.0}, {0.31, 0.56, 0.0}, {0.57, 0.87, 0.0}, {0.43, 0.32, 0.0}, {0.85, 0.38, 0.0}};

CellGrid unit_square() {
  return {Vec3::Zero(), {5, 5, 1}, Vec3::Constant(5.0), {false, false, false}};
}

ChainCells chains_of(std::size_t particles) {
  ChainCells chains;
  chains.fill(unit_square(), bodies_at({twenty_five.begin(), twenty_five.begin() + particles}, 0.1));
  return chains;
}

// Tables 3.2 and 3.3.
TEST(SweetmanTables, ParticlesAreChainedOneByOne) {
  EXPECT_EQ(chains_of(1).head(0), 0);
  EXPECT_EQ(chains_of(1).next(0), -1);
  EXPECT_EQ(chains_of(2).head(0), 1);
  EXPECT_EQ(chains_of(2).next(1), 0);
}

// Table 3.4, LIST, HEAD and CELL. Tables 3.6 and 3.7 contradict it and are not used.
TEST(SweetmanTables, TwentyFiveParticlesHaveTheChainsOfTable3_4) {
  const std::vector<int> list{0, 1, 2, 0, 0, 4, 0, 0, 0, 7, 0, 0, 0, 0, 13, 11, 16, 0, 6, 8, 0, 0, 0, 0, 14};
  const std::vector<int> head{3, 19, 0,  18, 0, 20, 10, 24, 0, 25, 17, 22, 12,
                              0, 0,  15, 21, 0, 0,  0,  9,  0, 23, 0,  5};
  const std::vector<int> cell{1,  1,  1,  2,  25, 2, 7, 6,  21, 7,  11, 13, 16,
                              10, 16, 11, 11, 4,  2, 6, 17, 12, 23, 8,  10};
  const ChainCells chains = chains_of(25);
  for (int i = 0; i < 25; ++i) {
    EXPECT_EQ(chains.next(i) + 1, list[i]) << "particle " << i + 1;
    EXPECT_EQ(chains.head(i) + 1, head[i]) << "cell " << i + 1;
    EXPECT_EQ(chains.cell(i) + 1, cell[i]) << "particle " << i + 1;
  }
}

// 0.6/0.2 falls just short of 3, 0.6 · 5 does not: the cell's inverse width decides where particle 18 is.
TEST(SweetmanTables, Particle18NeedsTheInverseOfTheCellWidth) {
  EXPECT_EQ(static_cast<int>(0.6 / 0.2), 2);
  EXPECT_EQ(chains_of(25).cell(17) + 1, 4);
}

// Table 3.5: the first cell of 5 × 5 × 5 with periodic faces, offsets −1, 0, 1 with z fastest.
TEST(SweetmanTables, FirstCellHasTheNeighboursOfTable3_5) {
  const CellGrid cube{Vec3::Zero(), {5, 5, 5}, Vec3::Constant(5.0), {true, true, true}};
  const std::vector<int> printed{125, 25,  50, 105, 5,   30, 110, 10,  35, 121, 21,  46, 101, 1,
                                 26,  106, 6,  31,  122, 22, 47,  102, 2,  27,  107, 7,  32};
  std::vector<int> found;
  for (const std::int32_t cell : CellNeighbours(cube, 0)) found.push_back(cell + 1);
  EXPECT_EQ(found, printed);
}

}  // namespace
}  // namespace grainproof::testing
