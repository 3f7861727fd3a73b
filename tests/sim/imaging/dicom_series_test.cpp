// SPDX-License-Identifier: GPL-3.0-or-later
// CT series as scanners write them, and everything that may be wrong with one.
#include "sim/imaging/scan/dicom_series.h"

#include <algorithm>
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <filesystem>
#include <functional>
#include <random>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "tests/support/dicom_files.h"
#include "tests/support/refusal.h"
#include "tests/support/scan_files.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;

using testing::DicomStyle;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using testing::writeDicomSeries;

/// A new empty folder.
fs::path seriesFolder(const std::string& name) {
  const fs::path folder = fs::path(::testing::TempDir()) / ("dicom-" + std::to_string(getpid()) + "-" + name);
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

/// A small volume in which every voxel differs, within what 12 bits hold.
ScanVolume countedSlices(std::size_t slices = 12) {
  ScanVolume scan = testing::blankScan({6, 5, slices}, {0.7, 0.9, 2.5}, {-20.0, 35.0, 110.0});
  for (std::size_t n = 0; n < scan.values.size(); ++n) {
    scan.values[n] = static_cast<std::int16_t>(static_cast<int>(n % 3000) - 1000);
  }
  return scan;
}

ScanRead readFolder(const fs::path& folder, bool resample = false, int series = 0) {
  return readDicomSeries({folder, series, resample});
}

std::string refusalOfFolder(const fs::path& folder, bool resample = false, int series = 0) {
  return testing::refusalText([&] { return readFolder(folder, resample, series); },
                              ErrorCode::kFileUnreadable);
}

std::string refusalOfSeries(const std::string& name, const DicomStyle& style, std::size_t slices = 12) {
  const fs::path folder = seriesFolder(name);
  writeDicomSeries(folder, countedSlices(slices), style);
  return refusalOfFolder(folder);
}

const ScanRemark* remarkOf(const ScanRead& read, const std::string& code) {
  const auto at = std::find_if(read.remarks.begin(), read.remarks.end(),
                               [&code](const ScanRemark& one) { return one.code == code; });
  return at == read.remarks.end() ? nullptr : &*at;
}

void putText(DcmDataset& data, const DcmTagKey& tag, const std::string& text) {
  ASSERT_TRUE(data.putAndInsertString(tag, text.c_str()).good());
}

TEST(DicomSeries, ReadsEveryCodingThatIsRead) {
  const ScanVolume written = countedSlices();
  for (const char* syntax : {"plain", "implicit", "deflated", "big-endian", "rle", "jpeg", "jpeg-ls"}) {
    for (const bool isSigned : {false, true}) {
      const fs::path folder = seriesFolder(syntax);
      writeDicomSeries(folder, written,
                       {.syntax = syntax, .intercept = isSigned ? 0.0 : -1024.0, .isSigned = isSigned});
      const ScanRead read = readFolder(folder);
      EXPECT_EQ(read.volume.values, written.values) << syntax;
      EXPECT_TRUE(read.remarks.empty());
      for (const Vec3& corner : {Vec3{0, 0, 0}, Vec3{5, 0, 0}, Vec3{0, 4, 0}, Vec3{0, 0, 11}}) {
        EXPECT_LT(norm(read.volume.place_mm(corner) - written.place_mm(corner)), 1e-6);
      }
    }
  }
}

TEST(DicomSeries, ScalesEachSliceByItsOwn) {
  const fs::path folder = seriesFolder("scales");
  writeDicomSeries(folder, countedSlices(), {.change = [](DcmDataset& data, std::size_t slice) {
                     if (slice == 4) {
                       putText(data, DCM_RescaleIntercept, "-1000");
                     }
                   }});
  const ScanRead read = readFolder(folder);
  EXPECT_EQ(read.volume.values[4 * 30], countedSlices().values[4 * 30] + 24);
  EXPECT_EQ(read.volume.values[3 * 30], countedSlices().values[3 * 30]);
  ASSERT_NE(remarkOf(read, "D14"), nullptr);
  EXPECT_FALSE(remarkOf(read, "D14")->warning);
}

TEST(DicomSeries, TakesPaddingForAirAndHoldsValuesInBounds) {
  const fs::path folder = seriesFolder("padding");
  ScanVolume scan = countedSlices();
  scan.values[0] = -1500;
  scan.values[1] = 20'000;
  writeDicomSeries(folder, scan,
                   {.intercept = 0.0, .isSigned = true, .change = [](DcmDataset& data, std::size_t) {
                      data.putAndInsertSint16(DCM_PixelPaddingValue, -1500);
                    }});
  const ScanVolume read = readFolder(folder).volume;
  EXPECT_EQ(read.values[0], kOutsideScan_HU);
  EXPECT_EQ(read.values[1], 3071);
}

TEST(DicomSeries, LeansItsVoxelsWhereTheGantryWasTilted) {
  // The Philips phantom: 2.3708 mm along, 0.7933 mm across: 18.5 degrees.
  ScanVolume tilted = countedSlices();
  tilted.step_mm[2] = {0.0, -0.7933, 2.3708};
  const fs::path folder = seriesFolder("tilt");
  writeDicomSeries(folder, tilted);
  const ScanRead read = readFolder(folder);
  ASSERT_NE(remarkOf(read, "D10"), nullptr);
  EXPECT_NEAR(remarkOf(read, "D10")->value.value(), 18.5, 0.01);
  EXPECT_LT(norm(read.volume.step_mm[2] - tilted.step_mm[2]), 1e-6);
  tilted.step_mm[2] = {0.0, 2.0, 2.3708};
  writeDicomSeries(seriesFolder("steep"), tilted);
  EXPECT_THAT(
      refusalOfFolder(fs::path(::testing::TempDir()) / ("dicom-" + std::to_string(getpid()) + "-steep")),
      StartsWith("D10"));
}

TEST(DicomSeries, NamesADecimalComma) {
  for (const auto& [tag, value] : {std::pair(DCM_ImagePositionPatient, "-20,5\\35\\110,25"),
                                   {DCM_PixelSpacing, "0,9\\0,7"},
                                   {DCM_ImageOrientationPatient, "1,0\\0\\0\\0\\1\\0"},
                                   {DCM_RescaleSlope, "1,0"},
                                   {DCM_RescaleIntercept, "-1024,0"}}) {
    const std::string said = refusalOfSeries(
        "comma",
        {.change = [tag = tag, value = value](DcmDataset& data, std::size_t) { putText(data, tag, value); }});
    EXPECT_THAT(said, StartsWith("D06")) << value;
    EXPECT_THAT(said, HasSubstr("a decimal comma: " + std::string(value)));
  }
}

TEST(DicomSeries, GoesByPositionsAndFillsGapsOnlyWhenAsked) {
  // Slice 5 is missing, and thickness lies.
  const fs::path folder = seriesFolder("gap");
  ScanVolume scan = countedSlices();
  for (std::size_t n = 0; n < scan.values.size(); ++n) {
    scan.values[n] = static_cast<std::int16_t>(100 * (n / 30));  // grows from slice to slice
  }
  writeDicomSeries(folder, scan);
  fs::remove(folder / ("slice" + std::to_string(7 * 5 + 3) + ".dcm"));
  EXPECT_THAT(refusalOfFolder(folder),
              StartsWith("D09 the slices are unevenly spaced: 5 mm between slice31.dcm and slice45.dcm"));
  const ScanRead read = readFolder(folder, true);
  ASSERT_NE(remarkOf(read, "D09"), nullptr);
  EXPECT_TRUE(remarkOf(read, "D09")->warning);
  EXPECT_EQ(read.volume.count[2], 12U);
  EXPECT_EQ(read.volume.values, scan.values);  // half way between 400 and 600
}

TEST(DicomSeries, DropsASliceThatIsThereTwiceAndRefusesTwoThatDiffer) {
  const fs::path folder = seriesFolder("twice");
  writeDicomSeries(folder, countedSlices());
  fs::copy_file(folder / "slice10.dcm", folder / "again.dcm");
  const ScanRead read = readFolder(folder);
  EXPECT_EQ(read.volume.count[2], 12U);
  ASSERT_NE(remarkOf(read, "D08"), nullptr);
  const fs::path other = seriesFolder("differ");
  writeDicomSeries(other, countedSlices());
  ScanVolume shifted = countedSlices();
  std::reverse(shifted.values.begin(), shifted.values.end());
  writeDicomSeries(other / "more", shifted);
  EXPECT_THAT(refusalOfFolder(other), StartsWith("D08"));
}

TEST(DicomSeries, TakesTheLargestSeriesOrTheOneAskedFor) {
  const fs::path folder = seriesFolder("several");
  writeDicomSeries(folder / "a", countedSlices(10), {.series = "1.2.1"});
  writeDicomSeries(folder / "b" / "c", countedSlices(14), {.series = "1.2.2"});
  writeDicomSeries(folder / "d", countedSlices(20), {.modality = "MR", .series = "1.2.3"});
  writeFileAtomically(folder / "readme.txt", "no DICOM");
  const ScanRead read = readFolder(folder);
  EXPECT_EQ(read.volume.count[2], 14U);
  ASSERT_NE(remarkOf(read, "D03"), nullptr);
  EXPECT_THAT(remarkOf(read, "D03")->what.str(), HasSubstr("series 1: 10 slices of 6 x 5"));
  EXPECT_EQ(readFolder(folder, false, 1).volume.count[2], 10U);
  EXPECT_THAT(refusalOfFolder(folder, false, 3), StartsWith("D03"));
}

TEST(DicomSeries, RefusesWithTheRuleThatIsBroken) {
  using Change = std::function<void(DcmDataset&, std::size_t)>;
  const auto text = [](const DcmTagKey& tag, const char* value) {
    return Change([tag, value](DcmDataset& data, std::size_t) { putText(data, tag, value); });
  };
  const auto without = [](const DcmTagKey& tag) {
    return Change([tag](DcmDataset& data, std::size_t) { data.findAndDeleteElement(tag); });
  };
  const auto inOne = [](const Change& change) {
    return Change([change](DcmDataset& data, std::size_t slice) {
      if (slice == 7) {
        change(data, slice);
      }
    });
  };
  const auto whole = [](const DcmTagKey& tag, Uint16 value) {
    return Change([tag, value](DcmDataset& data, std::size_t) { data.putAndInsertUint16(tag, value); });
  };
  const std::vector<std::pair<std::string, Change>> cases{
      {"D02", text(DCM_Modality, "MR")},
      {"D02", text(DCM_ImageType, "ORIGINAL\\PRIMARY\\LOCALIZER")},
      {"D04", inOne(whole(DCM_Rows, 50))},
      {"D06", inOne(without(DCM_PixelSpacing))},
      {"D06", inOne(text(DCM_PixelSpacing, "0\\0.7"))},
      {"D06", inOne(without(DCM_ImagePositionPatient))},
      {"D06", inOne(text(DCM_ImageOrientationPatient, "1\\0\\0\\1\\0\\0"))},
      {"D06", inOne(without(DCM_RescaleSlope))},
      {"D06", inOne(text(DCM_RescaleSlope, "0"))},
      {"D06", inOne(whole(DCM_BitsStored, 0))},
      {"D07", inOne(text(DCM_PixelSpacing, "0.9\\0.8"))},
      {"D07", inOne(text(DCM_ImageOrientationPatient, "0\\1\\0\\-1\\0\\0"))},
      {"D07", inOne(text(DCM_ImagePositionPatient, "-10\\35\\127.5"))},
      {"D12", inOne(text(DCM_NumberOfFrames, "3"))},
      {"D12", inOne(whole(DCM_BitsAllocated, 8))},
      {"D12", inOne(text(DCM_PhotometricInterpretation, "MONOCHROME1"))},
      {"D13", inOne(text(DCM_RescaleType, "ED"))},
  };
  for (const auto& [code, change] : cases) {
    const std::string refused = refusalOfSeries("broken", {.change = change});
    // Rows that promise more pixels than there are differ from the other slices first.
    EXPECT_THAT(refused, StartsWith(code == "D04" ? "D07" : code)) << refused;
  }
  EXPECT_THAT(refusalOfSeries("rows", {.change = whole(DCM_Rows, 50)}), StartsWith("D04"));
  EXPECT_THAT(refusalOfSeries("few", {}, 9), StartsWith("D11"));
  EXPECT_THAT(refusalOfFolder(seriesFolder("empty")), StartsWith("D01"));
}

/// Replaces all occurrences of a text in a file by another one as long.
void rewrite(const fs::path& file, const std::string& from, const std::string& to) {
  std::string bytes = readFile(file);
  for (std::size_t at = bytes.find(from); at != std::string::npos; at = bytes.find(from, at + to.size())) {
    bytes.replace(at, from.size(), to);
  }
  writeFileAtomically(file, bytes);
}

TEST(DicomSeries, RefusesJpeg2000WithTheRemedy) {
  const fs::path folder = seriesFolder("j2k");
  writeDicomSeries(folder, countedSlices(), {.syntax = "jpeg"});
  for (const auto& entry : fs::directory_iterator(folder)) {
    rewrite(entry.path(), "1.2.840.10008.1.2.4.70", "1.2.840.10008.1.2.4.90");
  }
  EXPECT_THAT(refusalOfFolder(folder), StartsWith("D05"));
  EXPECT_THAT(refusalOfFolder(folder), HasSubstr("JPEG 2000 (1.2.840.10008.1.2.4.90)"));
}

TEST(DicomSeries, NeverSaysWhoThePatientIs) {
  const fs::path folder = seriesFolder("named");
  writeDicomSeries(folder, countedSlices(), {.names = "DOE_JANE_"});
  fs::remove(folder / "DOE_JANE_10.dcm");
  writeDicomSeries(folder / "cut", countedSlices(1), {.series = "1.2.9", .names = "pid4711-"});
  const std::string gap = refusalOfFolder(folder);
  EXPECT_THAT(gap, StartsWith("D09"));
  EXPECT_THAT(gap, HasSubstr("between file "));
  const fs::path cut = folder / "cut" / "pid4711-3.dcm";
  fs::resize_file(cut, 300);
  const std::string damaged = refusalOfFolder(folder);
  EXPECT_THAT(damaged, StartsWith("D04"));
  for (const std::string& said : {gap, damaged}) {
    for (const char* word : {"DOE", "JANE", "Doe", "Jane", "4711", "1967"}) {
      EXPECT_THAT(said, Not(HasSubstr(word)));
    }
  }
}

TEST(DicomSeries, NeverLetsADamagedFileThrough) {
  // Whatever is done to a slice, the series is read with all of its voxels, or refused.
  const fs::path folder = seriesFolder("fuzz");
  std::mt19937 random(8);
  const auto below = [&random](std::size_t limit) { return static_cast<std::size_t>(random()) % limit; };
  std::size_t refused = 0;
  for (const char* syntax : {"plain", "rle", "jpeg", "jpeg-ls"}) {
    writeDicomSeries(folder, countedSlices(), {.syntax = syntax});
    const fs::path file = folder / "slice24.dcm";
    const std::string good = readFile(file);
    for (int round = 0; round < 60; ++round) {
      std::string bytes = good;
      for (std::size_t changes = 1 + below(3); changes > 0; --changes) {
        const std::size_t at = 128 + below(bytes.size() - 128);
        if (below(4) == 0) {
          bytes.resize(at + 1);
        } else {
          bytes[at] = static_cast<char>(random());
        }
      }
      writeFileAtomically(file, bytes);
      try {
        const ScanVolume volume = readFolder(folder).volume;
        ASSERT_EQ(volume.values.size(), volume.count[0] * volume.count[1] * volume.count[2]);
      } catch (const Error&) {
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 80U);
}

}  // namespace
}  // namespace torsio
