// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/core/vec3.h"
#include "sim/imaging/scan/scan_volume.h"

namespace torsio {

// For the .cpp files of this folder only.

/// What the reader needs of the header of one DICOM file, as the file has it.
struct DicomSlice {
  std::filesystem::path file;
  std::string name;  ///< by which it may be called in a message
  std::string series;
  std::string modality;
  std::string photometric;
  std::string rescaleType;  ///< "HU"; empty: not stated, which for a CT means the same
  std::string syntax;       ///< UID of its transfer syntax
  bool picture = false;     ///< a localizer or a screen shot
  bool isSigned = false;
  long rows = 0;
  long columns = 0;
  long bitsAllocated = 0;
  long bitsStored = 0;
  long highBit = 0;
  long samples = 0;
  long frames = 1;
  std::string
      comma;  ///< the first value of the geometry or scale that holds a comma, as it is written; or empty
  std::optional<double> slope;
  std::optional<double> intercept;
  std::optional<std::array<double, 2>> spacing_mm;  ///< between rows, between columns
  std::optional<Vec3> position_mm;
  std::optional<std::array<Vec3, 2>> directions;  ///< along a row, along a column
  std::optional<std::array<long, 2>> padding;     ///< stored values that mean nothing, from and to
};

/// Words of the patient's name and number, in small letters: a file's name may hold them.
using NamingWords = std::vector<std::string>;

/// What looking at one file gave.
enum class DicomLook { kNone, kDamaged, kSlice };

/// Makes the decoders known; once before anything else of this header, by one thread.
void prepareDicom();

/// Reads the header of a file; words of the patient's name are added to `words`.
[[nodiscard]] DicomLook lookAtDicom(const std::filesystem::path& file, DicomSlice& slice, NamingWords& words);

/// Reads the pixels of a slice in Hounsfield units; false when the file is damaged or holds too few.
[[nodiscard]] bool readDicomPixels(const DicomSlice& slice, std::span<std::int16_t> values);

/// Slices in their order along the patient, and the grid that they make.
struct DicomStack {
  std::vector<DicomSlice> slices;   ///< one a place
  std::vector<DicomSlice> twins;    ///< at the place of another one; their pixels have to be the same
  std::vector<std::size_t> twinOf;  ///< whose
  std::vector<double> at;           ///< place of each slice, in layers of the grid from the first
  std::size_t layers = 0;           ///< of the grid; as many as slices where they lie evenly
  Vec3 origin_mm;
  std::array<Vec3, 3> step_mm{};
};

/// Orders slices of one size, spacing and orientation by their positions. Throws Error{kFileUnreadable}: D07
/// (shifted against each other), D09 (uneven distances, unless `resample`), D10 (tilted by more than 35
/// degrees), D11 (fewer than 10). What else there is to say is added to `remarks`.
[[nodiscard]] DicomStack stacked(std::vector<DicomSlice> slices, bool resample, const std::string& where,
                                 std::vector<ScanRemark>& remarks);

}  // namespace torsio
