// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/imaging/scan/nifti_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <span>
#include <string>
#include <vector>
#include <zlib.h>

#include "sim/core/error.h"
#include "sim/imaging/scan/nifti_header.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kVoxelsAtOnce = 65'536;

[[noreturn]] void refuseVoxels(const Text& what, const std::string& where) {
  throw Error(ErrorCode::kFileUnreadable, what, where, Text::tr("Copy or export the file again"));
}

/// Null when it cannot be opened, or is a pipe or a device, which may never answer.
gzFile opened(const fs::path& file) {
  std::error_code failed;
  return fs::is_regular_file(file, failed) ? gzopen(file.c_str(), "rb") : nullptr;
}

/// A file that is read from front to back, gzip or not.
class ZippedFile {
 public:
  explicit ZippedFile(const fs::path& file) : where_(file.string()), file_(opened(file)) {
    if (file_ == nullptr) {
      refuseVoxels(Text::tr("N04 the file cannot be opened"), where_);
    }
    gzbuffer(file_, 1U << 18U);
  }
  ~ZippedFile() { gzclose(file_); }
  ZippedFile(const ZippedFile&) = delete;
  ZippedFile& operator=(const ZippedFile&) = delete;

  /// Reads as many bytes as there is room for; false when there are fewer.
  [[nodiscard]] bool read(std::span<unsigned char> room) {
    const int got = gzread(file_, room.data(), static_cast<unsigned>(room.size()));
    return got >= 0 && static_cast<std::size_t>(got) == room.size();
  }
  [[nodiscard]] bool skip(std::uint64_t bytes) {
    std::array<unsigned char, 4096> rest{};
    while (bytes > 0) {
      const std::size_t now = static_cast<std::size_t>(std::min<std::uint64_t>(bytes, rest.size()));
      if (!read({rest.data(), now})) {
        return false;
      }
      bytes -= now;
    }
    return true;
  }
  /// Reads on to the end, where gzip keeps its check sum; false when it is wrong or missing.
  [[nodiscard]] bool endsWell() {
    std::array<unsigned char, 4096> rest{};
    int got = 0;
    int rounds = 0;
    do {
      got = gzread(file_, rest.data(), rest.size());
    } while (got > 0 && ++rounds < 16'384);  // what follows is none of the scan
    int status = Z_OK;
    gzerror(file_, &status);
    return got >= 0 && (status == Z_OK || status == Z_STREAM_END);
  }

 private:
  std::string where_;
  gzFile file_ = nullptr;
};

template <typename Number>
double numberAt(const unsigned char* place, bool swapped) {
  std::array<unsigned char, sizeof(Number)> raw{};
  std::memcpy(raw.data(), place, sizeof(Number));
  if (swapped) {
    std::reverse(raw.begin(), raw.end());
  }
  return static_cast<double>(std::bit_cast<Number>(raw));
}

using NumberReader = double (*)(const unsigned char*, bool);

NumberReader readerOf(std::int16_t datatype) {
  switch (datatype) {
    case 2:
      return &numberAt<std::uint8_t>;
    case 4:
      return &numberAt<std::int16_t>;
    case 8:
      return &numberAt<std::int32_t>;
    case 16:
      return &numberAt<float>;
    case 64:
      return &numberAt<double>;
    case 256:
      return &numberAt<std::int8_t>;
    case 512:
      return &numberAt<std::uint16_t>;
    default:
      return &numberAt<std::uint32_t>;
  }
}

/// Reads the voxels; returns how many were no numbers.
std::size_t readVoxels(ZippedFile& file, const NiftiHeader& header, const std::string& where,
                       std::vector<std::int16_t>& values) {
  const NumberReader number = readerOf(header.datatype);
  const std::size_t all = header.count[0] * header.count[1] * header.count[2];
  values.reserve(std::min(all, std::size_t{1} << 22U));  // a header may promise what the file does not hold
  std::vector<unsigned char> bytes(kVoxelsAtOnce * header.voxelBytes);
  std::size_t none = 0;
  while (values.size() < all) {
    const std::size_t now = std::min(kVoxelsAtOnce, all - values.size());
    if (!file.read({bytes.data(), now * header.voxelBytes})) {
      refuseVoxels(Text::tr("N04 the file ends, or is damaged, after %1 of %2 voxels",
                            std::to_string(values.size()), std::to_string(all)),
                   where);
    }
    if (values.capacity() < values.size() + now) {
      values.reserve(std::min(all, 2 * values.capacity() + now));
    }
    for (std::size_t i = 0; i < now; ++i) {
      const double value =
          number(bytes.data() + i * header.voxelBytes, header.swapped) * header.slope + header.intercept;
      none += std::isnan(value) ? 1 : 0;
      values.push_back(std::isnan(value)
                           ? kOutsideScan_HU
                           : static_cast<std::int16_t>(std::lround(std::clamp(value, -32768.0, 32767.0))));
    }
  }
  return none;
}

/// The file with the voxels of a header in a file of its own, or the header of such voxels.
fs::path besideWith(const fs::path& file, const std::string& from, const std::string& to) {
  std::string name = file.filename().string();
  const std::size_t ending = name.rfind(from);
  const fs::path plain = file.parent_path() / (name.substr(0, ending) + to);
  const fs::path zipped = plain.string() + ".gz";
  return !fs::exists(plain) && fs::exists(zipped) ? zipped : plain;
}

bool isNamed(const fs::path& file, const std::string& ending) {
  const std::string name = file.filename().string();
  return name.ends_with(ending) || name.ends_with(ending + ".gz");
}

}  // namespace

bool isNiftiFile(const fs::path& file) {
  return isNamed(file, ".nii") || isNamed(file, ".hdr") || isNamed(file, ".img");
}

ScanRead readNifti(const fs::path& file) {
  const fs::path head = isNamed(file, ".img") ? besideWith(file, ".img", ".hdr") : file;
  const std::string where = head.string();
  std::error_code failed;
  if (!fs::exists(head, failed)) {
    throw Error(ErrorCode::kFileMissing, Text::tr("there is no such file"), where,
                Text::tr("Check the path"));
  }
  ScanRead scan;
  std::array<unsigned char, kNiftiHeaderBytes> bytes{};
  ZippedFile first(head);
  if (!first.read(bytes)) {
    throw Error(ErrorCode::kFileUnreadable,
                Text::tr("N01 the file is shorter than a NIfTI header, or damaged"), where,
                Text::tr("Give a NIfTI-1 file, .nii or .nii.gz"));
  }
  const NiftiHeader header = niftiHeader(bytes, where, scan.remarks);
  const fs::path body = header.twoFiles ? besideWith(head, ".hdr", ".img") : head;
  if (header.twoFiles && (!isNamed(head, ".hdr") || !fs::exists(body, failed))) {
    refuseVoxels(
        Text::tr("N04 the voxels lie in a file of their own, NAME.img beside NAME.hdr, and it is missing"),
        where);
  }
  ZippedFile second(body);
  if (!second.skip(header.offset)) {
    refuseVoxels(Text::tr("N04 the file ends before its voxels begin"), body.string());
  }
  const std::size_t none = readVoxels(second, header, body.string(), scan.volume.values);
  if (!second.endsWell()) {
    refuseVoxels(Text::tr("N04 the file is damaged: its check sum is wrong"), body.string());
  }
  if (none > 0) {
    scan.remarks.push_back({"N03", true,
                            Text::tr("%1 {voxel|voxels} without a number count as air", std::to_string(none)),
                            static_cast<double>(none), Text::tr("Check where the scan has no values")});
  }
  scan.volume.count = header.count;
  scan.volume.origin_mm = header.origin_mm;
  scan.volume.step_mm = header.step_mm;
  return scan;
}

}  // namespace torsio
