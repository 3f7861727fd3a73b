// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/imaging/scan/dicom_slice.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <fstream>
#include <string_view>

// DCMTK's configuration header first: the others need it.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcrledrg.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpeg/djdecode.h>
#include <dcmtk/dcmjpls/djdecode.h>

#include "sim/imaging/scan/scan_volume.h"

namespace torsio {

namespace {

constexpr double kLeast_HU = -1024.0;
constexpr double kMost_HU = 3071.0;  // metal beyond
constexpr std::size_t kShortestWord = 3;

/// Begins as a DICOM file does, with or without the 128 bytes in front.
bool looksLikeDicom(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::array<char, 132> bytes{};
  in.read(bytes.data(), bytes.size());
  const auto got = static_cast<std::size_t>(in.gcount());
  if (got == bytes.size() && std::string_view(bytes.data() + 128, 4) == "DICM") {
    return true;
  }
  const bool firstGroup = bytes[0] == '\x08' || bytes[0] == '\x02';
  return got > 16 && firstGroup && bytes[1] == '\0' && bytes[2] <= '\x20' && bytes[2] >= '\0' &&
         bytes[3] == '\0';
}

std::string textOf(DcmItem& item, const DcmTagKey& tag) {
  OFString text;
  return item.findAndGetOFStringArray(tag, text).good() ? std::string(text.c_str(), text.length())
                                                        : std::string();
}

std::optional<double> numberOf(DcmItem& item, const DcmTagKey& tag, unsigned long position = 0) {
  double number = 0.0;
  return item.findAndGetFloat64(tag, number, position).good() && std::isfinite(number) ? std::optional(number)
                                                                                       : std::nullopt;
}

long wholeOf(DcmItem& item, const DcmTagKey& tag, long otherwise) {
  Uint16 number = 0;
  return item.findAndGetUint16(tag, number).good() ? static_cast<long>(number) : otherwise;
}

std::optional<Vec3> vectorOf(DcmItem& item, const DcmTagKey& tag, unsigned long first) {
  const auto x = numberOf(item, tag, first);
  const auto y = numberOf(item, tag, first + 1);
  const auto z = numberOf(item, tag, first + 2);
  return x && y && z ? std::optional(Vec3{*x, *y, *z}) : std::nullopt;
}

/// A stored value may be written signed or not, as its header says; both come as 16 bits.
std::optional<long> storedOf(DcmItem& item, const DcmTagKey& tag, bool isSigned) {
  Uint16 raw = 0;
  Sint16 whole = 0;
  if (item.findAndGetUint16(tag, raw).good()) {
    return isSigned ? static_cast<long>(static_cast<std::int16_t>(raw)) : static_cast<long>(raw);
  }
  return item.findAndGetSint16(tag, whole).good() ? std::optional<long>(whole) : std::nullopt;
}

void addWords(const std::string& text, NamingWords& words) {
  std::string word;
  for (const char c : text + "^") {
    const auto letter = static_cast<unsigned char>(c);
    if (std::isalnum(letter) != 0 || letter >= 128) {
      word += static_cast<char>(std::tolower(letter));
      continue;
    }
    if (word.size() >= kShortestWord && std::find(words.begin(), words.end(), word) == words.end()) {
      words.push_back(word);
    }
    word.clear();
  }
}

void takeGeometry(DcmItem& item, DicomSlice& slice) {
  const auto betweenRows = numberOf(item, DCM_PixelSpacing, 0);
  const auto betweenColumns = numberOf(item, DCM_PixelSpacing, 1);
  if (betweenRows && betweenColumns) {
    slice.spacing_mm = {*betweenRows, *betweenColumns};
  }
  slice.position_mm = vectorOf(item, DCM_ImagePositionPatient, 0);
  const auto alongRow = vectorOf(item, DCM_ImageOrientationPatient, 0);
  const auto alongColumn = vectorOf(item, DCM_ImageOrientationPatient, 3);
  if (alongRow && alongColumn) {
    slice.directions = {*alongRow, *alongColumn};
  }
}

void takePixelFormat(DcmItem& item, DicomSlice& slice) {
  slice.photometric = textOf(item, DCM_PhotometricInterpretation);
  slice.rows = wholeOf(item, DCM_Rows, 0);
  slice.columns = wholeOf(item, DCM_Columns, 0);
  slice.bitsAllocated = wholeOf(item, DCM_BitsAllocated, 0);
  slice.bitsStored = wholeOf(item, DCM_BitsStored, 0);
  slice.highBit = wholeOf(item, DCM_HighBit, slice.bitsStored - 1);
  slice.samples = wholeOf(item, DCM_SamplesPerPixel, 1);
  slice.isSigned = wholeOf(item, DCM_PixelRepresentation, 0) == 1;
  slice.slope = numberOf(item, DCM_RescaleSlope);
  slice.intercept = numberOf(item, DCM_RescaleIntercept);
  Sint32 frames = 1;
  slice.frames = item.findAndGetSint32(DCM_NumberOfFrames, frames).good() ? static_cast<long>(frames) : 1L;
  if (const auto from = storedOf(item, DCM_PixelPaddingValue, slice.isSigned)) {
    const long to = storedOf(item, DCM_PixelPaddingRangeLimit, slice.isSigned).value_or(*from);
    slice.padding = {std::min(*from, to), std::max(*from, to)};
  }
}

}  // namespace

void prepareDicom() {
  OFLog::configure(OFLogger::OFF_LOG_LEVEL);  // what it would say may name the patient
  DcmRLEDecoderRegistration::registerCodecs();
  DJDecoderRegistration::registerCodecs();
  DJLSDecoderRegistration::registerCodecs();
}

DicomLook lookAtDicom(const std::filesystem::path& file, DicomSlice& slice, NamingWords& words) {
  if (!looksLikeDicom(file)) {
    return DicomLook::kNone;
  }
  DcmFileFormat format;
  const OFCondition read = format.loadFileUntilTag(file.c_str(), EXS_Unknown, EGL_noChange, DCM_MaxReadLength,
                                                   ERM_autoDetect, DCM_PixelData);
  DcmDataset* const data = format.getDataset();
  if (read.bad() || data == nullptr) {
    return DicomLook::kDamaged;
  }
  addWords(textOf(*data, DCM_PatientName), words);
  addWords(textOf(*data, DCM_PatientID), words);
  slice.file = file;
  slice.series = textOf(*data, DCM_SeriesInstanceUID);
  slice.modality = textOf(*data, DCM_Modality);
  const std::string kind = textOf(*data, DCM_ImageType);
  slice.picture = kind.find("LOCALIZER") != std::string::npos || kind.find("SECONDARY") != std::string::npos;
  const DcmXfer syntax(data->getOriginalXfer());
  slice.syntax = syntax.getXferID();
  takePixelFormat(*data, slice);
  takeGeometry(*data, slice);
  return DicomLook::kSlice;
}

bool readDicomPixels(const DicomSlice& slice, std::span<std::int16_t> values) {
  DcmFileFormat format;
  if (format.loadFile(slice.file.c_str()).bad()) {
    return false;
  }
  DcmDataset* const data = format.getDataset();
  if (data->chooseRepresentation(EXS_LittleEndianExplicit, nullptr).bad()) {
    return false;
  }
  const Uint16* pixels = nullptr;
  unsigned long count = 0;
  if (data->findAndGetUint16Array(DCM_PixelData, pixels, &count).bad() || pixels == nullptr ||
      count < values.size()) {
    return false;
  }
  const auto shift = static_cast<unsigned>(slice.highBit + 1 - slice.bitsStored);
  const auto bits = static_cast<unsigned>(slice.bitsStored);
  const std::uint32_t mask = (std::uint32_t{1} << bits) - 1;
  const long signBit = 1L << (bits - 1);
  for (std::size_t i = 0; i < values.size(); ++i) {
    long stored = static_cast<long>((static_cast<std::uint32_t>(pixels[i]) >> shift) & mask);
    if (slice.isSigned && (stored & signBit) != 0) {
      stored -= 2 * signBit;
    }
    const bool nothing = slice.padding && stored >= (*slice.padding)[0] && stored <= (*slice.padding)[1];
    const double value =
        static_cast<double>(stored) * slice.slope.value_or(1.0) + slice.intercept.value_or(0.0);
    values[i] = nothing ? kOutsideScan_HU
                        : static_cast<std::int16_t>(std::lround(std::clamp(value, kLeast_HU, kMost_HU)));
  }
  return true;
}

}  // namespace torsio
