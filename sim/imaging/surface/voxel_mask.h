// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/imaging/surface/scan_request.h"
#include "sim/imaging/surface/work_grid.h"

namespace torsio {

/// Which voxels of a grid belong to something, a bit each. What lies outside of the grid does not.
class VoxelMask {
 public:
  using Count = std::array<std::size_t, 3>;

  explicit VoxelMask(const Count& count);

  [[nodiscard]] const Count& count() const noexcept { return count_; }
  [[nodiscard]] bool at(std::size_t x, std::size_t y, std::size_t z) const noexcept {
    return ((row(y, z)[x / 64] >> (x % 64)) & 1U) != 0;
  }
  void set(std::size_t x, std::size_t y, std::size_t z) noexcept {
    bits_[(z * count_[1] + y) * words_ + x / 64] |= std::uint64_t{1} << (x % 64);
  }
  [[nodiscard]] std::size_t voxels() const noexcept;
  [[nodiscard]] const std::uint64_t* row(std::size_t y, std::size_t z) const noexcept {
    return bits_.data() + (z * count_[1] + y) * words_;
  }
  [[nodiscard]] std::size_t wordsInRow() const noexcept { return words_; }

  // With a mask of the same grid.
  void add(const VoxelMask& other);
  void keepOnly(const VoxelMask& other);
  void remove(const VoxelMask& other);

  /// Grows by whole voxels, nearly as a ball: faces first, then corners too, and so on.
  [[nodiscard]] VoxelMask grown(int voxels) const;
  /// Shrinks so; what lies outside of the grid takes nothing away.
  [[nodiscard]] VoxelMask shrunk(int voxels) const;
  /// Takes up everything that cannot be reached from the border of the grid without crossing a face of this.
  [[nodiscard]] VoxelMask filled() const { return filledFrom(6); }
  /// Takes up, in a grid of one layer, everything that cannot be reached from its borders along x and y.
  [[nodiscard]] VoxelMask filledInPlane() const { return filledFrom(4); }
  /// Grows and shrinks again: gaps of up to twice so many voxels close. The grid needs that much margin.
  [[nodiscard]] VoxelMask closed(int voxels) const { return grown(voxels).shrunk(voxels); }

 private:
  [[nodiscard]] VoxelMask filledFrom(std::size_t borders) const;
  void invert();
  void grow(bool corners);

  Count count_;
  std::size_t words_;
  std::vector<std::uint64_t> bits_;
};

/// A part of a mask whose voxels hang together by their faces.
struct MaskPiece {
  std::size_t voxels = 0;
  std::array<double, 3> middle{};  ///< mean of its voxels
  std::array<bool, 6>
      atBorder{};  ///< touches the first, last voxel along x, y, z of the part of the grid asked for
};

/// The pieces of a mask, the largest first.
class MaskPieces {
 public:
  /// `low` and `high` (excluded) bound the part of the grid whose border MaskPiece::atBorder means.
  MaskPieces(const VoxelMask& mask, const VoxelMask::Count& low, const VoxelMask::Count& high);

  [[nodiscard]] const std::vector<MaskPiece>& list() const noexcept { return pieces_; }
  /// Returns the piece of a voxel, or list().size() where there is none.
  [[nodiscard]] std::size_t at(std::size_t x, std::size_t y, std::size_t z) const noexcept;
  /// Returns the voxels of those pieces for which `wanted` holds true.
  [[nodiscard]] VoxelMask mask(const std::vector<bool>& wanted) const;
  [[nodiscard]] VoxelMask mask(std::size_t piece) const;

 private:
  struct Run {
    std::uint32_t from = 0;
    std::uint32_t to = 0;  ///< excluded
    std::uint32_t piece = 0;
  };
  void listRuns(const VoxelMask& mask);
  std::vector<std::uint32_t> joinedRuns();
  void measure(const VoxelMask::Count& low, const VoxelMask::Count& high);

  VoxelMask::Count count_;
  std::vector<Run> runs_;
  std::vector<std::size_t> firstOfRow_;
  std::vector<MaskPiece> pieces_;
};

/// Fills the holes that a mask has in the outermost layers of a part of the grid, each layer by itself: an
/// organ that is cut there gets a lid. `low`, `high` (excluded): the part.
void fillLids(VoxelMask& mask, const VoxelMask::Count& low, const VoxelMask::Count& high);

/// Calls `visit(x, y, z)` for each voxel of a part of a volume, [low, high), whose middle lies in a dab.
template <typename Visit>
void eachVoxelIn(const BrushDab& dab, const ScanVolume& volume, const std::array<std::size_t, 3>& low,
                 const std::array<std::size_t, 3>& high, const Visit& visit) {
  const Vec3 middle = volume.voxelAt(dab.centre_mm);
  const std::array<double, 3> at{middle.x, middle.y, middle.z};
  std::array<std::size_t, 3> first{};
  std::array<std::size_t, 3> behind{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // Half of the ball in voxels, between the planes of the other two axes.
    const Vec3 planes = cross(volume.step_mm[(axis + 1) % 3], volume.step_mm[(axis + 2) % 3]);
    const double half = dab.radius_mm * norm(planes) / std::abs(volume.voxel_mm3());
    const auto least = static_cast<double>(low[axis]);
    const auto most = static_cast<double>(high[axis]);
    first[axis] = static_cast<std::size_t>(std::clamp(std::ceil(at[axis] - half), least, most));
    behind[axis] = static_cast<std::size_t>(std::clamp(std::floor(at[axis] + half) + 1.0, least, most));
  }
  for (std::size_t z = first[2]; z < behind[2]; ++z) {
    for (std::size_t y = first[1]; y < behind[1]; ++y) {
      for (std::size_t x = first[0]; x < behind[0]; ++x) {
        const Vec3 place_mm =
            volume.place_mm({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
        if (norm(place_mm - dab.centre_mm) <= dab.radius_mm) {
          visit(x, y, z);
        }
      }
    }
  }
}

/// What strokes of a brush did to a mask, in voxels.
struct BrushWork {
  std::size_t added = 0;
  std::size_t erased = 0;
};

/// Mends `mask` by hand: each dab adds or erases a ball, in their order, within the scan. What was erased is
/// also taken from `tissue`, the voxels whose values say where the border lies.
BrushWork brushOver(const WorkGrid& grid, const std::vector<BrushDab>& dabs, VoxelMask& mask,
                    VoxelMask& tissue);

}  // namespace torsio
