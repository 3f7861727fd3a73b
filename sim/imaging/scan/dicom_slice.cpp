// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/imaging/scan/dicom_slice.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <fstream>
#include <string_view>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/portable_math.h"
#include "sim/core/short_number.h"

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

/// A decimal comma, which DICOM does not know, ends a number: what follows would be lost without a word.
std::string valueWithComma(DcmItem& item) {
  for (const DcmTagKey& tag : {DCM_ImagePositionPatient, DCM_PixelSpacing, DCM_ImageOrientationPatient,
                               DCM_RescaleSlope, DCM_RescaleIntercept}) {
    std::string value = textOf(item, tag);
    const bool numbers = value.find_first_not_of("0123456789+-.,eE\\ ") == std::string::npos;  // names nobody
    if (numbers && value.find(',') != std::string::npos) {
      return value;
    }
  }
  return {};
}

void takeGeometry(DcmItem& item, DicomSlice& slice) {
  slice.comma = valueWithComma(item);
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
  slice.rescaleType = textOf(item, DCM_RescaleType);
  Sint32 frames = 1;
  slice.frames = item.findAndGetSint32(DCM_NumberOfFrames, frames).good() ? static_cast<long>(frames) : 1L;
  if (const auto from = storedOf(item, DCM_PixelPaddingValue, slice.isSigned)) {
    const long to = storedOf(item, DCM_PixelPaddingRangeLimit, slice.isSigned).value_or(*from);
    slice.padding = {std::min(*from, to), std::max(*from, to)};
  }
}

constexpr double kSamePlace_mm = 0.01;
constexpr double kEvenShare = 0.01;  // of the distance
constexpr double kEven_mm = 0.01;
constexpr double kLeastShift_mm = 0.02;  // a slice, across: less does not count as tilt
constexpr double kMaxStray_mm = 0.1;     // off a straight line through the slices
constexpr double kMaxTilt_deg = 35.0;
constexpr std::size_t kMinSlices = 10;
constexpr double kCoarse_mm = 6.0;
constexpr double kLong = 8.0;  // longest over shortest side of a voxel
constexpr double kDegrees = 180.0 / kPi;

[[noreturn]] void refuseStack(const Text& what, const std::string& where, const Text& remedy) {
  throw Error(ErrorCode::kFileUnreadable, what, where, remedy);
}

/// Takes slices at the place of another one out of the stack.
void partTwins(DicomStack& stack, std::vector<double>& along_mm) {
  std::vector<DicomSlice> kept;
  std::vector<double> places_mm;
  for (std::size_t i = 0; i < stack.slices.size(); ++i) {
    if (!kept.empty() && along_mm[i] - places_mm.back() < kSamePlace_mm) {
      stack.twins.push_back(std::move(stack.slices[i]));
      stack.twinOf.push_back(kept.size() - 1);
      continue;
    }
    kept.push_back(std::move(stack.slices[i]));
    places_mm.push_back(along_mm[i]);
  }
  stack.slices = std::move(kept);
  along_mm = std::move(places_mm);
}

/// Checks that the slices lie evenly, or makes room for layers in between; returns the distance of layers.
double spaced(const std::vector<double>& along_mm, bool resample, const std::string& where, DicomStack& stack,
              std::vector<ScanRemark>& remarks) {
  std::vector<double> gaps_mm;
  for (std::size_t i = 1; i < along_mm.size(); ++i) {
    gaps_mm.push_back(along_mm[i] - along_mm[i - 1]);
  }
  std::vector<double> sorted_mm = gaps_mm;
  std::sort(sorted_mm.begin(), sorted_mm.end());
  const double usual_mm = sorted_mm[sorted_mm.size() / 2];
  const auto off = [usual_mm](double gap_mm) { return std::abs(gap_mm - usual_mm); };
  const auto worst = std::max_element(gaps_mm.begin(), gaps_mm.end(),
                                      [&off](double a, double b) { return off(a) < off(b); });
  const bool even = off(*worst) <= std::max(kEvenShare * usual_mm, kEven_mm);
  const auto after = static_cast<std::size_t>(worst - gaps_mm.begin());
  if (!even) {
    const Text what = Text::tr("D09 the slices are unevenly spaced: %1 mm between %2 and %3, elsewhere %4 mm",
                               shortNumber(*worst), stack.slices[after].name, stack.slices[after + 1].name,
                               shortNumber(usual_mm));
    if (!resample) {
      refuseStack(what, where,
                  Text::tr("Look for slices that are missing, or take them as they are with --resample"));
    }
    remarks.push_back(
        {"D09", true,
         Text::tr("the slices are unevenly spaced, up to %1 mm apart: the gaps are interpolated",
                  shortNumber(*worst)),
         *worst, Text::tr("Give a scan with slices at even distances")});
  }
  const double whole_mm = along_mm.back() - along_mm.front();
  const double step_mm = even ? whole_mm / static_cast<double>(gaps_mm.size()) : sorted_mm.front();
  stack.layers = even ? along_mm.size() : static_cast<std::size_t>(std::floor(whole_mm / step_mm + 1e-6)) + 1;
  for (std::size_t i = 0; i < along_mm.size(); ++i) {
    stack.at.push_back(even ? static_cast<double>(i) : (along_mm[i] - along_mm.front()) / step_mm);
  }
  return step_mm;
}

/// How the slices shift across per millimetre along: the tilt of the gantry.
Vec3 shiftOf(const DicomStack& stack, const Vec3& normal, const std::string& where,
             std::vector<ScanRemark>& remarks) {
  const Vec3 first = *stack.slices.front().position_mm;
  const Vec3 way = *stack.slices.back().position_mm - first;
  const double along_mm = dot(way, normal);
  const Vec3 shift = (way - along_mm * normal) / along_mm;
  for (const DicomSlice& slice : stack.slices) {
    const Vec3 from = *slice.position_mm - first;
    const double here_mm = dot(from, normal);
    const double stray_mm = norm(from - here_mm * (normal + shift));
    if (stray_mm > kMaxStray_mm) {
      refuseStack(
          Text::tr("D07 slice %1 is shifted by %2 mm against the others", slice.name, shortNumber(stray_mm)),
          where, Text::tr("Give one series of one scan"));
    }
  }
  const double aSlice_mm = along_mm / static_cast<double>(stack.slices.size() - 1);
  if (norm(shift) * aSlice_mm <= kLeastShift_mm) {
    return {};
  }
  const double tilt_deg = kDegrees * std::atan(norm(shift));
  if (tilt_deg > kMaxTilt_deg) {
    refuseStack(Text::tr("D10 the gantry was tilted by %1 degrees, at most %2 are corrected",
                         shortNumber(tilt_deg), shortNumber(kMaxTilt_deg)),
                where, Text::tr("Give a scan with an upright gantry"));
  }
  remarks.push_back(
      {"D10", false,
       Text::tr("the gantry was tilted by %1 degrees; the voxels lean so much", shortNumber(tilt_deg)),
       tilt_deg, ""});
  return shift;
}

void remarkOnVoxels(const DicomStack& stack, std::vector<ScanRemark>& remarks) {
  std::array<double, 3> sides_mm{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    sides_mm[axis] = norm(stack.step_mm[axis]);
  }
  const double longest_mm = *std::max_element(sides_mm.begin(), sides_mm.end());
  const double shortest_mm = *std::min_element(sides_mm.begin(), sides_mm.end());
  if (sides_mm[2] > kCoarse_mm || longest_mm > kLong * shortest_mm) {
    remarks.push_back({"D11", true,
                       Text::tr("the scan is coarse: voxels of %1 x %2 x %3 mm", shortNumber(sides_mm[0]),
                                shortNumber(sides_mm[1]), shortNumber(sides_mm[2])),
                       longest_mm, Text::tr("Give a series with thinner slices")});
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

namespace torsio {

DicomStack stacked(std::vector<DicomSlice> slices, bool resample, const std::string& where,
                   std::vector<ScanRemark>& remarks) {
  DicomStack stack;
  const auto [alongRow, alongColumn] = *slices.front().directions;
  const Vec3 normal = normalized(cross(alongRow, alongColumn));
  std::stable_sort(slices.begin(), slices.end(), [&normal](const DicomSlice& a, const DicomSlice& b) {
    return dot(*a.position_mm, normal) < dot(*b.position_mm, normal);
  });
  std::vector<double> along_mm;
  for (const DicomSlice& slice : slices) {
    along_mm.push_back(dot(*slice.position_mm, normal));
  }
  stack.slices = std::move(slices);
  partTwins(stack, along_mm);
  if (stack.slices.size() < kMinSlices) {
    refuseStack(Text::tr("D11 the series has %1 {slice|slices} at different places, at least %2 are needed",
                         std::to_string(stack.slices.size()), std::to_string(kMinSlices)),
                where, Text::tr("Give a whole series"));
  }
  const double layer_mm = spaced(along_mm, resample, where, stack, remarks);
  const Vec3 shift = shiftOf(stack, normal, where, remarks);
  const DicomSlice& first = stack.slices.front();
  stack.origin_mm = *first.position_mm;
  stack.step_mm = {(*first.spacing_mm)[1] * normalized(alongRow),
                   (*first.spacing_mm)[0] * normalized(alongColumn), layer_mm * (normal + shift)};
  remarkOnVoxels(stack, remarks);
  return stack;
}

}  // namespace torsio
