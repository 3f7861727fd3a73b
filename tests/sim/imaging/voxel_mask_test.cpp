// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/imaging/surface/voxel_mask.h"

#include <random>

#include <gtest/gtest.h>

namespace torsio {
namespace {

constexpr VoxelMask::Count kCount{70, 9, 8};  // a row of more than one word

VoxelMask scattered(unsigned perThousand) {
  std::mt19937 random(3);
  VoxelMask mask(kCount);
  for (std::size_t z = 0; z < kCount[2]; ++z) {
    for (std::size_t y = 0; y < kCount[1]; ++y) {
      for (std::size_t x = 0; x < kCount[0]; ++x) {
        if (random() % 1000 < perThousand) {
          mask.set(x, y, z);
        }
      }
    }
  }
  return mask;
}

/// Whether a voxel or one of its neighbours is set: those over faces, or over corners too.
bool nearSet(const VoxelMask& mask, std::size_t x, std::size_t y, std::size_t z, bool corners) {
  for (int dz = -1; dz <= 1; ++dz) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const long px = static_cast<long>(x) + dx;
        const long py = static_cast<long>(y) + dy;
        const long pz = static_cast<long>(z) + dz;
        const bool inGrid = px >= 0 && py >= 0 && pz >= 0 && px < 70 && py < 9 && pz < 8;
        if (inGrid && (corners || std::abs(dx) + std::abs(dy) + std::abs(dz) <= 1) &&
            mask.at(static_cast<std::size_t>(px), static_cast<std::size_t>(py),
                    static_cast<std::size_t>(pz))) {
          return true;
        }
      }
    }
  }
  return false;
}

TEST(VoxelMask, GrowsOverFacesThenOverCorners) {
  const VoxelMask mask = scattered(20);
  const VoxelMask once = mask.grown(1);
  const VoxelMask twice = mask.grown(2);
  for (std::size_t z = 0; z < kCount[2]; ++z) {
    for (std::size_t y = 0; y < kCount[1]; ++y) {
      for (std::size_t x = 0; x < kCount[0]; ++x) {
        ASSERT_EQ(once.at(x, y, z), nearSet(mask, x, y, z, false));
        ASSERT_EQ(twice.at(x, y, z), nearSet(once, x, y, z, true));
      }
    }
  }
}

TEST(VoxelMask, ShrinksAsItsBackgroundGrows) {
  const VoxelMask mask = scattered(900);
  const VoxelMask less = mask.shrunk(1);
  EXPECT_GT(less.voxels(), 0U);
  for (std::size_t z = 1; z + 1 < kCount[2]; ++z) {
    for (std::size_t y = 1; y + 1 < kCount[1]; ++y) {
      for (std::size_t x = 1; x + 1 < kCount[0]; ++x) {
        ASSERT_EQ(less.at(x, y, z), mask.at(x, y, z) && mask.at(x - 1, y, z) && mask.at(x + 1, y, z) &&
                                        mask.at(x, y - 1, z) && mask.at(x, y + 1, z) &&
                                        mask.at(x, y, z - 1) && mask.at(x, y, z + 1));
      }
    }
  }
}

TEST(VoxelMask, ListsItsPiecesTheLargestFirst) {
  VoxelMask mask(kCount);
  for (std::size_t x = 10; x < 68; ++x) {
    mask.set(x, 4, 4);
  }
  mask.set(68, 5, 4);  // touches the row over an edge only: a piece of its own
  mask.set(20, 5, 4);
  mask.set(20, 6, 4);
  mask.set(0, 0, 0);
  mask.set(0, 0, 1);
  const MaskPieces pieces(mask, {0, 0, 0}, kCount);
  ASSERT_EQ(pieces.list().size(), 3U);
  EXPECT_EQ(pieces.list()[0].voxels, 60U);
  EXPECT_EQ(pieces.list()[1].voxels, 2U);
  EXPECT_EQ(pieces.at(20, 6, 4), 0U);
  EXPECT_EQ(pieces.at(68, 5, 4), 2U);
  EXPECT_EQ(pieces.at(30, 5, 4), 3U);
  EXPECT_DOUBLE_EQ(pieces.list()[1].middle[2], 0.5);
  EXPECT_TRUE(pieces.list()[1].atBorder[0] && pieces.list()[1].atBorder[2] && pieces.list()[1].atBorder[4]);
  EXPECT_FALSE(pieces.list()[0].atBorder[1]);
  EXPECT_EQ(pieces.mask(0).voxels(), 60U);
}

TEST(VoxelMask, FillsWhatIsEnclosedAndPutsLidsOnCutEnds) {
  VoxelMask tube({20, 20, 20});  // open at z = 3, closed at z = 16
  for (std::size_t z = 3; z < 17; ++z) {
    for (std::size_t y = 5; y < 15; ++y) {
      for (std::size_t x = 5; x < 15; ++x) {
        const bool wall = x == 5 || x == 14 || y == 5 || y == 14 || z == 16;
        if (wall) {
          tube.set(x, y, z);
        }
      }
    }
  }
  EXPECT_EQ(tube.filled().voxels(), tube.voxels());
  fillLids(tube, {3, 3, 3}, {17, 17, 17});
  EXPECT_EQ(tube.filled().voxels(), 10U * 10U * 14U);
}

}  // namespace
}  // namespace torsio
