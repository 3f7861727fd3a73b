// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/core/text.h"
#include "sim/core/vec3.h"

namespace torsio {

/// What lies outside of a scan, and where it was padded: air.
inline constexpr std::int16_t kOutsideScan_HU = -1024;
/// Most voxels of a scan: 1.5 GB of memory.
inline constexpr std::uint64_t kMaxVoxels = 750'000'000;

/// A scan on a grid of voxels: Hounsfield units of a CT, or the numbers of a label mask. Millimetres, LPS (x
/// to the patient's left, y to the back, z to the head).
struct ScanVolume {
  std::array<std::size_t, 3> count{};  ///< voxels along i, j, k
  std::vector<std::int16_t> values;    ///< i runs fastest
  Vec3 origin_mm;                      ///< middle of the first voxel
  std::array<Vec3, 3> step_mm{};       ///< from a voxel to its neighbour along i, j, k; any three directions

  [[nodiscard]] std::size_t index(std::size_t i, std::size_t j, std::size_t k) const noexcept {
    return (k * count[1] + j) * count[0] + i;
  }
  /// Returns the place of a voxel; fractions lie between voxels.
  [[nodiscard]] Vec3 place_mm(const Vec3& ijk) const noexcept;
  /// Returns the voxel, with fractions, at a place.
  [[nodiscard]] Vec3 voxelAt(const Vec3& place_mm) const noexcept;
  /// Returns the volume of one voxel; negative where i, j, k are left-handed.
  [[nodiscard]] double voxel_mm3() const noexcept;
};

/// Something that a reader has to say about a scan that can be used.
struct ScanRemark {
  std::string code;             ///< of the rule, "D10"; docs/organs.md lists them
  bool warning = false;         ///< bears on the organ's numbers; otherwise only a remark
  Text what;                    ///< one sentence without a full stop, without the code
  std::optional<double> value;  ///< measured, in the unit that `what` names
  Text remedy;                  ///< one imperative sentence, or ""
};

/// A scan as a file or a folder has it.
struct ScanRead {
  ScanVolume volume;
  std::vector<ScanRemark> remarks;
  bool hounsfield = true;  ///< a CT; else whatever the file's numbers mean
};

/// Throws Error{kFileUnreadable} when a volume of CT holds no air, no soft tissue, or one value only: D13.
void requireHounsfield(const ScanVolume& volume, const std::string& where);

/// Throws Error{kFileUnreadable}, D15, for more voxels than kMaxVoxels. `count` is positive.
void requireSize(const std::array<std::size_t, 3>& count, const std::string& where);

}  // namespace torsio
