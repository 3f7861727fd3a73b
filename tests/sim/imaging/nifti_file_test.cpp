// SPDX-License-Identifier: GPL-3.0-or-later
// NIfTI-1 as the standard has it, and everything that may be wrong with it.
#include "sim/imaging/scan/nifti_file.h"

#include <array>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

#ifndef _WIN32
#include <sys/stat.h>
#endif

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "tests/support/refusal.h"
#include "tests/support/scan_files.h"

namespace torsio {
namespace {

using testing::niftiBytes;
using testing::NiftiStyle;
using ::testing::StartsWith;

std::filesystem::path niftiFile(const std::string& name) {
  return std::filesystem::path(::testing::TempDir()) / ("nifti-" + std::to_string(getpid()) + "-" + name);
}

/// A small volume in which every voxel differs.
ScanVolume countedScan() {
  ScanVolume scan = testing::blankScan({4, 3, 2}, {1.5, 2.0, 4.0}, {-20.0, 35.0, 110.0});
  for (std::size_t n = 0; n < scan.values.size(); ++n) {
    scan.values[n] = static_cast<std::int16_t>(3 * n + 1);
  }
  return scan;
}

ScanRead readBytes(const std::string& bytes, const std::string& name = "one.nii") {
  const auto file = niftiFile(name);
  writeFileAtomically(file, bytes);
  return readNifti(file);
}

std::string refusalOf(const std::string& bytes, const std::string& name = "bad.nii") {
  return testing::refusalText([&] { return readBytes(bytes, name); });
}

/// The bytes with a number of the header replaced.
template <typename Number>
std::string with(std::string bytes, std::size_t place, Number number) {
  std::memcpy(bytes.data() + place, &number, sizeof(number));
  return bytes;
}

void expectPlaced(const ScanVolume& read, const ScanVolume& written) {
  for (const Vec3& corner : {Vec3{0, 0, 0}, Vec3{3, 0, 0}, Vec3{0, 2, 0}, Vec3{0, 0, 1}}) {
    EXPECT_LT(norm(read.place_mm(corner) - written.place_mm(corner)), 1e-4);
    EXPECT_LT(norm(read.voxelAt(written.place_mm(corner)) - corner), 1e-4);
  }
}

TEST(NiftiFile, ReadsEveryDatatypeInBothByteOrders) {
  const ScanVolume written = countedScan();
  constexpr std::array<std::int16_t, 10> kDatatypes{2, 4, 8, 16, 64, 256, 512, 768, 1024, 1280};
  for (const std::int16_t datatype : kDatatypes) {
    for (const bool swapped : {false, true}) {
      const ScanRead read = readBytes(niftiBytes(written, {.datatype = datatype, .swapped = swapped}));
      EXPECT_EQ(read.volume.values, written.values) << datatype;
      EXPECT_EQ(read.volume.count, written.count);
      EXPECT_TRUE(read.remarks.empty());
      expectPlaced(read.volume, written);
    }
  }
}

TEST(NiftiFile, ReadsGzipAndTwoFiles) {
  const ScanVolume written = countedScan();
  EXPECT_EQ(readBytes(testing::gzipped(niftiBytes(written)), "zip.nii.gz").volume.values, written.values);
  const NiftiStyle two{.twoFiles = true};
  writeFileAtomically(niftiFile("two.hdr"), testing::niftiHead(written, two));
  EXPECT_THAT(refusalOf(testing::niftiHead(written, two), "lonely.hdr"), StartsWith("N04"));
  writeFileAtomically(niftiFile("two.img.gz"), testing::gzipped(testing::niftiVoxels(written, two)));
  EXPECT_EQ(readNifti(niftiFile("two.hdr")).volume.values, written.values);
  EXPECT_TRUE(isNiftiFile("a/b.nii.gz"));
  EXPECT_FALSE(isNiftiFile("a/b.dcm"));
}

TEST(NiftiFile, TakesEndingsInCapitals) {
  const ScanVolume written = countedScan();
  EXPECT_TRUE(isNiftiFile("a/B.NII"));
  EXPECT_TRUE(isNiftiFile("a/B.Nii.GZ"));
  EXPECT_EQ(readBytes(testing::gzipped(niftiBytes(written)), "zip.NII.GZ").volume.values, written.values);
  const NiftiStyle two{.twoFiles = true};
  for (const auto& [head, voxels] : {std::pair("a.HDR", "a.IMG"), {"b.hdr", "b.IMG"}, {"c.HDR", "c.img"}}) {
    writeFileAtomically(niftiFile(head), testing::niftiHead(written, two));
    writeFileAtomically(niftiFile(voxels), testing::niftiVoxels(written, two));
    EXPECT_EQ(readNifti(niftiFile(head)).volume.values, written.values) << head;
    EXPECT_EQ(readNifti(niftiFile(voxels)).volume.values, written.values) << voxels;
  }
  writeFileAtomically(niftiFile("d.HDR"), testing::niftiHead(written, two));
  writeFileAtomically(niftiFile("d.IMG.GZ"), testing::gzipped(testing::niftiVoxels(written, two)));
  EXPECT_EQ(readNifti(niftiFile("d.HDR")).volume.values, written.values);
}

TEST(NiftiFile, ScalesItsValues) {
  ScanVolume written = countedScan();
  for (std::int16_t& value : written.values) {
    value = static_cast<std::int16_t>(2 * value - 1024);
  }
  const NiftiStyle style{.datatype = 512, .slope = 2.0F, .intercept = -1024.0F};
  EXPECT_EQ(readBytes(niftiBytes(written, style)).volume.values, written.values);
  // No slope means no scale, whatever the intercept says.
  const std::string plain = with<float>(niftiBytes(countedScan()), 116, 100.0F);
  EXPECT_EQ(readBytes(plain).volume.values, countedScan().values);
}

TEST(NiftiFile, RefusesWholeNumbersThatItCannotHoldAndBoundsMeasuredOnes) {
  // Unsigned 16 bits with the sign bit set: 32768 and more.
  ScanVolume large = countedScan();
  large.values[5] = -1;
  EXPECT_THAT(refusalOf(niftiBytes(large, {.datatype = 512}), "label.nii"), StartsWith("N08"));
  EXPECT_THAT(refusalOf(niftiBytes(large, {.datatype = 512}), "label.nii"), HasSubstr("65535"));
  ScanVolume negative = countedScan();
  negative.values[5] = -1;
  EXPECT_EQ(readBytes(niftiBytes(negative, {.datatype = 4})).volume.values, negative.values);
  // A scale makes a measurement of it, which is bounded.
  const NiftiStyle scaled{.datatype = 512, .slope = 2.0F};
  ScanVolume bright = countedScan();
  bright.values[5] = 32767;
  EXPECT_GE(readBytes(niftiBytes(bright, scaled)).volume.values[5], 32766);
}

TEST(NiftiFile, PlacesBySformThenQformThenSpacing) {
  const ScanVolume written = countedScan();
  expectPlaced(readBytes(niftiBytes(written, {.sform = false, .qform = true})).volume, written);
  // With both, the sform decides.
  const std::string both = with<float>(niftiBytes(written, {.qform = true}), 268, 5000.0F);
  expectPlaced(readBytes(both).volume, written);
  const ScanRead none = readBytes(niftiBytes(written, {.sform = false}));
  ASSERT_EQ(none.remarks.size(), 1U);
  EXPECT_EQ(none.remarks[0].code, "N06");
  EXPECT_TRUE(none.remarks[0].warning);
  EXPECT_DOUBLE_EQ(norm(none.volume.step_mm[2]), 4.0);
}

TEST(NiftiFile, TurnsRightToLeft) {
  // Voxel (1, 0, 0) lies 10 mm to the right of the first in RAS: at -10 mm in LPS.
  ScanVolume scan = testing::blankScan({4, 3, 2}, {10, 10, 10}, {0, 0, 0});
  std::string bytes = niftiBytes(scan);
  bytes = with<float>(bytes, 280, 10.0F);
  const ScanVolume read = readBytes(bytes).volume;
  EXPECT_DOUBLE_EQ(read.step_mm[0].x, -10.0);
  EXPECT_LT(read.voxel_mm3(), 0.0);  // left-handed voxels: told by their volume
}

TEST(NiftiFile, KnowsMetresAndMicrometres) {
  ScanVolume metres = countedScan();
  for (Vec3& step : metres.step_mm) {
    step *= 0.001;
  }
  metres.origin_mm *= 0.001;
  expectPlaced(readBytes(niftiBytes(metres, {.units = 1})).volume, countedScan());
  const ScanRead unnamed = readBytes(niftiBytes(countedScan(), {.units = 0}));
  ASSERT_EQ(unnamed.remarks.size(), 1U);
  EXPECT_EQ(unnamed.remarks[0].code, "N06");
}

TEST(NiftiFile, RefusesWithTheRuleThatIsBroken) {
  const std::string good = niftiBytes(countedScan());
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<std::pair<std::string, std::string>> cases{
      {"N01", ""},
      {"N01", std::string(348, 'x')},
      {"N01", with<std::int32_t>(good, 0, 540)},
      {"N01", with<char>(good, 344, 'A')},
      {"N02", with<std::int16_t>(good, 40, 0)},
      {"N02", with<std::int16_t>(good, 42, -4)},
      {"N02", with<std::int16_t>(good, 44, 32767)},
      {"N02", with<std::int16_t>(with<std::int16_t>(good, 40, 4), 48, 12)},
      {"N03", with<std::int16_t>(good, 70, 128)},
      {"N03", with<std::int16_t>(good, 72, 8)},
      {"N04", with<float>(good, 108, -1.0F)},
      {"N04", with<float>(good, 108, kNan)},
      {"N04", with<float>(good, 108, 1e9F)},
      {"N04", good.substr(0, good.size() - 1)},
      {"N04", good.substr(0, 350)},
      {"N05", with<float>(good, 280, 0.0F)},
      {"N05", with<float>(good, 280, kNan)},
      {"N05", with<float>(good, 292, 1e30F)},
      {"N05", with<float>(good, 284, 1.0F)},
      {"N05", with<float>(niftiBytes(countedScan(), {.sform = false, .qform = true}), 256, 3.0F)},
      {"N05 voxels are", with<unsigned char>(good, 123, 1)},  // millimetres that the header calls metres
      {"N06", with<unsigned char>(good, 123, 5)},
      {"D15", with<std::int16_t>(with<std::int16_t>(with<std::int16_t>(good, 42, 4096), 44, 4096), 46, 4096)},
  };
  for (const auto& [code, bytes] : cases) {
    EXPECT_THAT(refusalOf(bytes), StartsWith(code + " "));
  }
  std::string zipped = testing::gzipped(good);
  EXPECT_THAT(refusalOf(zipped.substr(0, zipped.size() - 6), "cut.nii.gz"), StartsWith("N04"));
  zipped[zipped.size() - 7] = static_cast<char>(~zipped[zipped.size() - 7]);  // of the check sum
  EXPECT_THAT(refusalOf(zipped, "sum.nii.gz"), StartsWith("N0"));  // so small a file is unpacked at once
  EXPECT_THROW(static_cast<void>(readNifti(niftiFile("none.nii"))), Error);
}

TEST(NiftiFile, CountsVoxelsWithoutANumberAsAir) {
  std::string bytes = niftiBytes(countedScan(), {.datatype = 16});
  bytes = with<float>(bytes, 352, std::numeric_limits<float>::quiet_NaN());
  bytes = with<float>(bytes, 356, 1e30F);
  const ScanRead read = readBytes(bytes);
  EXPECT_EQ(read.volume.values[0], kOutsideScan_HU);
  EXPECT_EQ(read.volume.values[1], 32767);
  ASSERT_EQ(read.remarks.size(), 1U);
  EXPECT_EQ(read.remarks[0].code, "N03");
}

TEST(NiftiFile, NeverLetsADamagedFileThrough) {
  // Whatever is done to a file, it is read into a volume of the size that its header promises, or refused.
  std::mt19937 random(20);
  const auto below = [&random](std::size_t limit) { return static_cast<std::size_t>(random()) % limit; };
  const std::string plain = niftiBytes(countedScan(), {.qform = true});
  const std::string zipped = testing::gzipped(plain);
  std::size_t refused = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string bytes = round % 3 == 0 ? zipped : plain;
    for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
      const std::size_t at = below(bytes.size());
      switch (below(4)) {
        case 0:
          bytes[at] = static_cast<char>(random());
          break;
        case 1:
          bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
          break;
        case 2:
          bytes.erase(at, 1 + below(8));
          break;
        default:
          bytes.resize(1 + below(bytes.size()));
      }
      if (bytes.empty()) {
        bytes = "x";
      }
    }
    const auto file = niftiFile("fuzz.nii");
    writeFileAtomically(file, bytes);
    try {
      const ScanVolume volume = readNifti(file).volume;
      ASSERT_EQ(volume.values.size(), volume.count[0] * volume.count[1] * volume.count[2]);
      for (const Vec3& step : volume.step_mm) {
        ASSERT_TRUE(isFinite(step) && norm(step) > 0.0);
      }
      ASSERT_TRUE(isFinite(volume.origin_mm));
    } catch (const Error& error) {
      ASSERT_EQ(error.code(), ErrorCode::kFileUnreadable);
      ++refused;
    }
  }
  EXPECT_GT(refused, 1000U);
}

#ifndef _WIN32
TEST(NiftiFile, APipeIsRefusedAndNotWaitedFor) {
  const auto pipe = niftiFile("pipe.nii");
  std::filesystem::remove(pipe);
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);

  EXPECT_THROW((void)readNifti(pipe), Error);

  std::filesystem::remove(pipe);
}
#endif

}  // namespace
}  // namespace torsio
