// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "sim/core/vec3.h"
#include "sim/imaging/scan/scan_volume.h"

namespace torsio {

inline constexpr std::size_t kNiftiHeaderBytes = 348;

/// What the reader needs of a NIfTI-1 header, checked.
struct NiftiHeader {
  bool swapped = false;   ///< the file's byte order is not this machine's
  bool twoFiles = false;  ///< the voxels lie in a file of their own
  std::array<std::size_t, 3> count{};
  std::int16_t datatype = 0;
  std::size_t voxelBytes = 0;
  std::uint64_t offset = 0;  ///< of the first voxel in its file
  double slope = 1.0;
  double intercept = 0.0;
  Vec3 origin_mm;  ///< LPS
  std::array<Vec3, 3> step_mm{};
};

/// Takes a header apart and checks it; adds what there is to say of it to `remarks`. Throws
/// Error{kFileUnreadable}: N01 (no header), N02 (dimensions), N03 (datatype), N04 (offset), N05 (geometry),
/// D15.
[[nodiscard]] NiftiHeader niftiHeader(std::span<const unsigned char, kNiftiHeaderBytes> bytes,
                                      const std::string& where, std::vector<ScanRemark>& remarks);

/// Tells whether a file is named as a NIfTI-1 file: .nii, .nii.gz, .hdr, .img, the last two also with .gz;
/// capitals count as small letters.
[[nodiscard]] bool isNiftiFile(const std::filesystem::path& file);

/// Reads a NIfTI-1 volume, plain or gzip, either byte order, one file or a .hdr beside its .img: 8 to 64 bit
/// integers, 32 and 64 bit floats, scaled by scl_slope and rounded to 16 bits. sform goes before qform before
/// pixdim; RAS becomes LPS. The texts of the header are not read: they may name the patient. Throws
/// Error{kFileMissing}, Error{kFileUnreadable} with the code of the rule (N01 to N05, D15). Damaged files of
/// every kind are refused, never trusted.
[[nodiscard]] ScanRead readNifti(const std::filesystem::path& file);

}  // namespace torsio
