// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/imaging/scan/dicom_series.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "sim/core/error.h"
#include "sim/core/plain_text.h"
#include "sim/core/plausible.h"
#include "sim/core/short_number.h"
#include "sim/core/text.h"
#include "sim/imaging/scan/dicom_slice.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMaxFiles = 50'000;
constexpr int kDeepest = 12;
constexpr std::size_t kListedSeries = 12;
constexpr double kUnitTolerance = 1e-3;
constexpr double kSameDirection = 1e-3;
constexpr double kSameSpacing_mm = 1e-4;
constexpr long kMaxSide_px = 8192;

[[noreturn]] void refuseSeries(const Text& what, const std::string& where, const Text& remedy) {
  throw Error(ErrorCode::kFileUnreadable, what, where, remedy);
}

/// Everything below a folder that looks like DICOM.
struct DicomFiles {
  std::vector<DicomSlice> slices;
  std::vector<std::size_t> damaged;  ///< numbers of files
  std::vector<fs::path> files;
  NamingWords words;
};

/// The name of a file, or its number where the name holds a part of the patient's.
std::string sayableName(const fs::path& file, std::size_t number, const NamingWords& words) {
  std::string small = file.filename().string();
  std::transform(small.begin(), small.end(), small.begin(),
                 [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  const bool names = std::any_of(words.begin(), words.end(), [&small](const std::string& word) {
    return small.find(word) != std::string::npos;
  });
  return names ? "file " + std::to_string(number + 1) : file.filename().string();
}

DicomFiles collected(const fs::path& folder) {
  DicomFiles found;
  std::error_code failed;
  fs::recursive_directory_iterator entries(folder, fs::directory_options::skip_permission_denied, failed);
  for (; !failed && entries != fs::recursive_directory_iterator(); entries.increment(failed)) {
    if (entries.depth() >= kDeepest) {
      entries.disable_recursion_pending();
    }
    std::error_code unknown;
    if (entries->is_regular_file(unknown) && !entries->is_symlink(unknown)) {
      found.files.push_back(entries->path());
    }
    if (found.files.size() > kMaxFiles) {
      refuseSeries(Text::tr("D15 the folder holds more than %1 files", std::to_string(kMaxFiles)),
                   folder.string(), Text::tr("Give the folder of one scan"));
    }
  }
  std::sort(found.files.begin(), found.files.end());
  for (std::size_t i = 0; i < found.files.size(); ++i) {
    DicomSlice slice;
    const DicomLook look = lookAtDicom(found.files[i], slice, found.words);
    if (look == DicomLook::kDamaged) {
      found.damaged.push_back(i);
    } else if (look == DicomLook::kSlice) {
      slice.name = std::to_string(i);  // named when all words are known
      found.slices.push_back(std::move(slice));
    }
  }
  for (DicomSlice& slice : found.slices) {
    slice.name = sayableName(slice.file, static_cast<std::size_t>(std::stoul(slice.name)), found.words);
  }
  return found;
}

using SeriesMap = std::map<std::string, std::vector<DicomSlice>>;

/// The CT series, by their UIDs; refuses a folder without one, with what there is.
SeriesMap seriesOf(DicomFiles& found, const std::string& where) {
  if (found.slices.empty()) {
    refuseSeries(found.damaged.empty() ? Text::tr("D01 there is no DICOM file in this folder")
                                       : Text::tr("D04 file %1 is damaged or cut short",
                                                  sayableName(found.files[found.damaged.front()],
                                                              found.damaged.front(), found.words)),
                 where, Text::tr("Give a folder of DICOM files, or a NIfTI file"));
  }
  SeriesMap series;
  std::map<std::string, std::size_t> others;
  for (DicomSlice& slice : found.slices) {
    if (slice.modality == "CT" && !slice.picture) {
      series[slice.series].push_back(std::move(slice));
    } else {
      const bool known = slice.modality.size() <= 4 && !slice.modality.empty();
      ++others[slice.picture ? "localizer" : known ? slice.modality : "other"];
    }
  }
  if (series.empty()) {
    std::vector<Text> texts;
    for (const auto& [kind, files] : others) {
      texts.push_back(Text::verbatim("%1 %2", std::to_string(files), kind));
    }
    refuseSeries(Text::tr("D02 there is no CT series in this folder: %1", listed(texts)), where,
                 Text::tr("Give a folder with the slices of a CT"));
  }
  if (!found.damaged.empty()) {
    const std::size_t first = found.damaged.front();
    refuseSeries(
        Text::tr("D04 file %1 is damaged or cut short", sayableName(found.files[first], first, found.words)),
        where, Text::tr("Copy or export the scan again"));
  }
  return series;
}

Text seriesText(std::size_t number, const std::vector<DicomSlice>& slices) {
  const DicomSlice& first = slices.front();
  return Text::tr("series %1: %2 {slice|slices} of %3 x %4", std::to_string(number),
                  std::to_string(slices.size()), std::to_string(first.columns), std::to_string(first.rows));
}

std::vector<DicomSlice> chosenSeries(SeriesMap& all, int wanted, const std::string& where,
                                     std::vector<ScanRemark>& remarks) {
  std::vector<Text> texts;
  std::vector<std::vector<DicomSlice>*> series;
  std::size_t largest = 0;
  for (auto& [uid, slices] : all) {
    series.push_back(&slices);
    if (texts.size() < kListedSeries) {
      texts.push_back(seriesText(series.size(), slices));
    }
    if (slices.size() > series[largest]->size()) {
      largest = series.size() - 1;
    }
  }
  if (wanted > static_cast<int>(series.size())) {
    refuseSeries(Text::tr("D03 there is no series %1: %2", std::to_string(wanted), listed(texts)), where,
                 Text::tr("Choose one with --series N"));
  }
  if (wanted == 0 && series.size() > 1) {
    remarks.push_back({"D03", false,
                       Text::tr("series %1 was taken, the one with the most slices: %2",
                                std::to_string(largest + 1), listed(texts)),
                       static_cast<double>(series.size()), Text::tr("Choose another one with --series N")});
  }
  return std::move(*series[wanted > 0 ? static_cast<std::size_t>(wanted - 1) : largest]);
}

/// Refuses a transfer syntax that is not read.
void requireSyntax(const DicomSlice& slice, const std::string& where) {
  // Implicit, explicit, big endian, deflated, RLE, JPEG lossless, JPEG-LS lossless and near-lossless.
  constexpr std::array<std::string_view, 9> kRead{
      "1.2.840.10008.1.2",      "1.2.840.10008.1.2.1",    "1.2.840.10008.1.2.2",
      "1.2.840.10008.1.2.1.99", "1.2.840.10008.1.2.5",    "1.2.840.10008.1.2.4.57",
      "1.2.840.10008.1.2.4.70", "1.2.840.10008.1.2.4.80", "1.2.840.10008.1.2.4.81"};
  if (std::find(kRead.begin(), kRead.end(), slice.syntax) != kRead.end()) {
    return;
  }
  const bool jpeg2000 = slice.syntax == "1.2.840.10008.1.2.4.90" || slice.syntax == "1.2.840.10008.1.2.4.91";
  refuseSeries(
      jpeg2000
          ? Text::tr("D05 slice %1 is compressed with JPEG 2000 (%2), which is not read", slice.name,
                     slice.syntax)
          : Text::tr("D05 slice %1 is compressed in a way that is not read (%2)", slice.name, slice.syntax),
      where, Text::tr("Export the scan without compression, or convert each file with gdcmconv --raw"));
}

void requirePixels(const DicomSlice& slice, const std::string& where) {
  const Text again = Text::tr("Export the slices of the CT themselves");
  if (slice.frames != 1) {
    refuseSeries(Text::tr("D12 slice %1 holds %2 frames", slice.name, std::to_string(slice.frames)), where,
                 Text::tr("Export the scan with one slice a file"));
  }
  if (slice.samples != 1 || slice.photometric != "MONOCHROME2" || slice.bitsAllocated != 16) {
    refuseSeries(
        Text::tr(
            "D12 slice %1 has %2 {bit|bits} a value, %3 {value|values} a pixel and the colours %4; 16, 1 and "
            "MONOCHROME2 are read",
            slice.name, std::to_string(slice.bitsAllocated), std::to_string(slice.samples),
            plainLine(slice.photometric)),
        where, again);
  }
  if (!slice.rescaleType.empty() && slice.rescaleType != "HU") {
    refuseSeries(Text::tr("D13 slice %1 says that its values are of the type %2, not Hounsfield units",
                          slice.name, plainLine(slice.rescaleType)),
                 where, again);
  }
  if (slice.rows < 2 || slice.columns < 2 || slice.rows > kMaxSide_px || slice.columns > kMaxSide_px ||
      slice.bitsStored < 8 || slice.bitsStored > 16 || slice.highBit + 1 < slice.bitsStored ||
      slice.highBit > 15) {
    refuseSeries(
        Text::tr("D06 slice %1 has no valid size or depth: %2 x %3 pixels, %4 bits", slice.name,
                 std::to_string(slice.columns), std::to_string(slice.rows), std::to_string(slice.bitsStored)),
        where, again);
  }
}

void requirePlace(const DicomSlice& slice, const std::string& where) {
  const auto refuse = [&](const char* tag) {
    refuseSeries(Text::tr("D06 slice %1 has no valid %2", slice.name, std::string(tag)), where,
                 Text::tr("Export the scan again with its geometry"));
  };
  if (!slice.comma.empty()) {
    refuseSeries(
        Text::tr("D06 slice %1 writes its numbers with a decimal comma: %2", slice.name, slice.comma), where,
        Text::tr("Export the scan again with decimal points, as DICOM requires"));
  }
  if (!slice.slope || !slice.intercept || *slice.slope == 0.0 || std::abs(*slice.slope) > 1e3 ||
      std::abs(*slice.intercept) > 1e5) {
    refuse("Rescale Slope or Intercept (0028,1053)");
  }
  if (!slice.spacing_mm || !std::all_of(slice.spacing_mm->begin(), slice.spacing_mm->end(),
                                        [](double s) { return isPlausible(Stated::kVoxelSide, 1e-3 * s); })) {
    refuse("Pixel Spacing (0028,0030)");
  }
  if (!slice.position_mm || norm(*slice.position_mm) > 1e5) {
    refuse("Image Position (0020,0032)");
  }
  if (!slice.directions || std::abs(norm((*slice.directions)[0]) - 1.0) > kUnitTolerance ||
      std::abs(norm((*slice.directions)[1]) - 1.0) > kUnitTolerance ||
      std::abs(dot((*slice.directions)[0], (*slice.directions)[1])) > kUnitTolerance) {
    refuse("Image Orientation (0020,0037)");
  }
}

/// Refuses slices that do not lie on one grid; reports scales that change.
void requireAlike(const std::vector<DicomSlice>& slices, const std::string& where,
                  std::vector<ScanRemark>& remarks) {
  const DicomSlice& first = slices.front();
  bool rescaled = false;
  for (const DicomSlice& slice : slices) {
    const auto& [a, b] = std::pair(*slice.directions, *first.directions);
    const bool alike = slice.rows == first.rows && slice.columns == first.columns &&
                       std::abs((*slice.spacing_mm)[0] - (*first.spacing_mm)[0]) <= kSameSpacing_mm &&
                       std::abs((*slice.spacing_mm)[1] - (*first.spacing_mm)[1]) <= kSameSpacing_mm &&
                       norm(a[0] - b[0]) <= kSameDirection && norm(a[1] - b[1]) <= kSameDirection;
    if (!alike) {
      refuseSeries(Text::tr("D07 slice %1 has another size, spacing or orientation than slice %2", slice.name,
                            first.name),
                   where, Text::tr("Give one series of one scan"));
    }
    rescaled = rescaled || *slice.slope != *first.slope || *slice.intercept != *first.intercept;
  }
  if (rescaled) {
    remarks.push_back({"D14", false, Text::tr("the slices have different scales; each was read with its own"),
                       std::nullopt, ""});
  }
}

std::vector<std::int16_t> pixelsOf(const DicomSlice& slice, const std::string& where) {
  std::vector<std::int16_t> values(static_cast<std::size_t>(slice.rows * slice.columns));
  if (!readDicomPixels(slice, values)) {
    refuseSeries(Text::tr("D04 slice %1 is damaged or cut short: its pixels cannot be read", slice.name),
                 where, Text::tr("Copy or export the scan again"));
  }
  return values;
}

/// Refuses slices that differ at one place.
void requireTwins(const DicomStack& stack, const std::string& where, std::vector<ScanRemark>& remarks) {
  for (std::size_t i = 0; i < stack.twins.size(); ++i) {
    const DicomSlice& other = stack.slices[stack.twinOf[i]];
    if (pixelsOf(stack.twins[i], where) != pixelsOf(other, where)) {
      refuseSeries(Text::tr("D08 slices %1 and %2 are at the same position but differ", stack.twins[i].name,
                            other.name),
                   where, Text::tr("Give one series of one scan"));
    }
  }
  if (!stack.twins.empty()) {
    remarks.push_back(
        {"D08", true,
         Text::tr("%1 {slice|slices} that were there twice left out", std::to_string(stack.twins.size())),
         static_cast<double>(stack.twins.size()), Text::tr("Check that the scan is whole")});
  }
}

void readLayers(const DicomStack& stack, const std::string& where, ScanVolume& volume) {
  const std::size_t area = volume.count[0] * volume.count[1];
  volume.values.resize(area * volume.count[2]);
  std::vector<std::int16_t> below;
  std::vector<std::int16_t> above;
  std::size_t next = 0;  // slice that `above` becomes
  for (std::size_t layer = 0; layer < stack.layers; ++layer) {
    const auto at = static_cast<double>(layer);
    while (next < stack.slices.size() && (next == 0 || stack.at[next - 1] < at - 1e-6)) {
      below = std::move(above);
      above = pixelsOf(stack.slices[next++], where);
    }
    std::int16_t* const to = volume.values.data() + layer * area;
    const double last = stack.at[next - 1];
    if (below.empty() || last <= at + 1e-6) {
      std::copy(above.begin(), above.end(), to);
      continue;
    }
    const double share = (last - at) / (last - stack.at[next - 2]);  // of the slice below
    for (std::size_t n = 0; n < area; ++n) {
      to[n] = static_cast<std::int16_t>(std::lround(share * below[n] + (1.0 - share) * above[n]));
    }
  }
}

}  // namespace

ScanRead readDicomSeries(const DicomRequest& request) {
  const std::string where = request.folder.string();
  static const bool kPrepared = (prepareDicom(), true);
  static_cast<void>(kPrepared);
  ScanRead scan;
  DicomFiles found = collected(request.folder);
  SeriesMap all = seriesOf(found, where);
  std::vector<DicomSlice> slices = chosenSeries(all, request.series, where, scan.remarks);
  for (const DicomSlice& slice : slices) {
    requireSyntax(slice, where);
    requirePixels(slice, where);
    requirePlace(slice, where);
  }
  requireAlike(slices, where, scan.remarks);
  const DicomStack stack = stacked(std::move(slices), request.resample, where, scan.remarks);
  scan.volume.count = {static_cast<std::size_t>(stack.slices.front().columns),
                       static_cast<std::size_t>(stack.slices.front().rows), stack.layers};
  requireSize(scan.volume.count, where);
  requireTwins(stack, where, scan.remarks);
  scan.volume.origin_mm = stack.origin_mm;
  scan.volume.step_mm = stack.step_mm;
  readLayers(stack, where, scan.volume);
  return scan;
}

}  // namespace torsio
