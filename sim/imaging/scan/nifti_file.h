// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "sim/imaging/scan/scan_volume.h"

namespace torsio {

/// Tells whether a file is named as a NIfTI-1 file: .nii, .nii.gz, .hdr, .img, the last two also with .gz.
[[nodiscard]] bool isNiftiFile(const std::filesystem::path& file);

/// Reads a NIfTI-1 volume, plain or gzip, either byte order, one file or a .hdr beside its .img: 8 to 32 bit
/// integers, 32 and 64 bit floats, scaled by scl_slope and rounded to 16 bits. sform goes before qform before
/// pixdim; RAS becomes LPS. The texts of the header are not read: they may name the patient. Throws
/// Error{kFileMissing}, Error{kFileUnreadable} with the code of the rule (N01 to N05, D15). Damaged files of
/// every kind are refused, never trusted.
[[nodiscard]] ScanRead readNifti(const std::filesystem::path& file);

}  // namespace torsio
