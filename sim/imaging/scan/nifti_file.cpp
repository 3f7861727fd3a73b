// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/imaging/scan/nifti_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstring>
#include <span>
#include <string>
#include <utility>
#include <vector>
#include <zlib.h>

#include "sim/core/error.h"
#include "sim/core/plausible.h"
#include "sim/core/short_number.h"

namespace torsio {

namespace {

constexpr std::int32_t kNifti2Bytes = 540;
constexpr std::int16_t kMaxSide = 4096;
constexpr double kMaxOffset = 64e6;
constexpr double kMillimetre_m = 1e-3;
constexpr double kMaxShear = 0.01745;  // cosine of 89 degrees
constexpr double kFarthest_mm = 1e5;

// Where the fields lie.
constexpr std::size_t kDim = 40;
constexpr std::size_t kDatatype = 70;
constexpr std::size_t kBitpix = 72;
constexpr std::size_t kPixdim = 76;
constexpr std::size_t kVoxOffset = 108;
constexpr std::size_t kSlope = 112;
constexpr std::size_t kUnits = 123;
constexpr std::size_t kQformCode = 252;
constexpr std::size_t kSformCode = 254;
constexpr std::size_t kQuaternion = 256;
constexpr std::size_t kQoffset = 268;
constexpr std::size_t kSrow = 280;
constexpr std::size_t kMagic = 344;

[[noreturn]] void refuseHeader(const Text& what, const std::string& where, const Text& remedy) {
  throw Error(ErrorCode::kFileUnreadable, what, where, remedy);
}

/// Reads numbers out of a header in the byte order of its file.
class HeaderBytes {
 public:
  HeaderBytes(std::span<const unsigned char, kNiftiHeaderBytes> bytes, bool swapped)
      : bytes_(bytes), swapped_(swapped) {}

  template <typename Number>
  [[nodiscard]] Number at(std::size_t place) const {
    std::array<unsigned char, sizeof(Number)> raw{};
    std::memcpy(raw.data(), bytes_.data() + place, sizeof(Number));
    if (swapped_) {
      std::reverse(raw.begin(), raw.end());
    }
    return std::bit_cast<Number>(raw);
  }
  [[nodiscard]] double real(std::size_t place) const { return static_cast<double>(at<float>(place)); }
  [[nodiscard]] double pixdim(std::size_t axis) const { return real(kPixdim + 4 * axis); }

 private:
  std::span<const unsigned char, kNiftiHeaderBytes> bytes_;
  bool swapped_;
};

/// Tells whether the bytes of a header are swapped; refuses anything that is not a header.
bool headerIsSwapped(std::span<const unsigned char, kNiftiHeaderBytes> bytes, const std::string& where) {
  for (const bool swapped : {false, true}) {
    const auto size = HeaderBytes(bytes, swapped).at<std::int32_t>(0);
    if (size == static_cast<std::int32_t>(kNiftiHeaderBytes)) {
      return swapped;
    }
    if (size == kNifti2Bytes) {
      refuseHeader(Text::tr("N01 this is a NIfTI-2 file; NIfTI-1 is read"), where,
                   Text::tr("Save it as NIfTI-1"));
    }
  }
  refuseHeader(Text::tr("N01 this is not a NIfTI file: its header does not begin with 348"), where,
               Text::tr("Give a NIfTI-1 file, .nii or .nii.gz"));
}

bool hasTwoFiles(const HeaderBytes& bytes, const std::string& where) {
  const std::array<char, 4> magic{bytes.at<char>(kMagic), bytes.at<char>(kMagic + 1),
                                  bytes.at<char>(kMagic + 2), bytes.at<char>(kMagic + 3)};
  if (magic == std::array{'n', '+', '1', '\0'}) {
    return false;
  }
  if (magic == std::array{'n', 'i', '1', '\0'}) {
    return true;
  }
  refuseHeader(
      Text::tr("N01 the file has no NIfTI mark: an Analyze file does not say where left and right are"),
      where, Text::tr("Convert the scan to NIfTI-1 again from its DICOM files"));
}

void readDimensions(const HeaderBytes& bytes, const std::string& where, NiftiHeader& header) {
  const auto dimensions = bytes.at<std::int16_t>(kDim);
  if (dimensions < 3 || dimensions > 7) {
    refuseHeader(
        Text::tr("N02 the file has %1 {dimension|dimensions}, a volume has 3", std::to_string(dimensions)),
        where, Text::tr("Give one volume"));
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto side = bytes.at<std::int16_t>(kDim + 2 * (axis + 1));
    if (side < 1 || side > kMaxSide) {
      refuseHeader(Text::tr("N02 dimension %1 is %2, it must lie between 1 and %3", std::to_string(axis + 1),
                            std::to_string(side), std::to_string(kMaxSide)),
                   where, Text::tr("Export the scan again"));
    }
    header.count[axis] = static_cast<std::size_t>(side);
  }
  for (std::size_t axis = 4; axis <= static_cast<std::size_t>(dimensions); ++axis) {
    const auto volumes = bytes.at<std::int16_t>(kDim + 2 * axis);
    if (volumes != 1) {
      refuseHeader(Text::tr("N02 the file holds a series of volumes: dimension %1 is %2",
                            std::to_string(axis), std::to_string(volumes)),
                   where, Text::tr("Give one volume"));
    }
  }
  requireSize(header.count, where);
}

void readDatatype(const HeaderBytes& bytes, const std::string& where, NiftiHeader& header) {
  // NIfTI's numbers: uint8, int16, int32, float32, float64, int8, uint16, uint32, int64, uint64
  constexpr std::array<std::pair<std::int16_t, std::size_t>, 10> kKnown{
      {{2, 1}, {4, 2}, {8, 4}, {16, 4}, {64, 8}, {256, 1}, {512, 2}, {768, 4}, {1024, 8}, {1280, 8}}};
  header.datatype = bytes.at<std::int16_t>(kDatatype);
  const auto known = std::find_if(kKnown.begin(), kKnown.end(),
                                  [&header](const auto& one) { return one.first == header.datatype; });
  if (known == kKnown.end()) {
    refuseHeader(Text::tr("N03 voxels of datatype %1 (colour or complex numbers) are not read",
                          std::to_string(header.datatype)),
                 where, Text::tr("Save the volume with 16-bit whole numbers"));
  }
  header.voxelBytes = known->second;
  const auto bits = bytes.at<std::int16_t>(kBitpix);
  if (bits != 0 && static_cast<std::size_t>(bits) != 8 * header.voxelBytes) {
    refuseHeader(Text::tr("N03 datatype %1 with %2 bits a voxel contradicts itself",
                          std::to_string(header.datatype), std::to_string(bits)),
                 where, Text::tr("Export the scan again"));
  }
}

void readOffset(const HeaderBytes& bytes, const std::string& where, NiftiHeader& header) {
  const double offset = bytes.real(kVoxOffset);
  const double least = header.twoFiles ? 0.0 : static_cast<double>(kNiftiHeaderBytes);
  if (!(offset >= 0.0 && offset <= kMaxOffset) || (offset > 0.0 && offset < least)) {
    refuseHeader(Text::tr("N04 the voxels are said to begin at byte %1", shortNumber(offset)), where,
                 Text::tr("Export the scan again"));
  }
  // Some writers leave it 0, which means right behind the header and its four bytes of extensions.
  header.offset =
      offset > 0.0 || header.twoFiles ? static_cast<std::uint64_t>(offset) : kNiftiHeaderBytes + 4;
}

void readScale(const HeaderBytes& bytes, NiftiHeader& header) {
  const double slope = bytes.real(kSlope);
  const double intercept = bytes.real(kSlope + 4);
  if (std::isfinite(slope) && slope != 0.0) {  // 0, or no number: not scaled
    header.slope = slope;
    header.intercept = std::isfinite(intercept) ? intercept : 0.0;
  }
}

/// Millimetres in the file's unit of length.
double unitOf(const HeaderBytes& bytes, const std::string& where, std::vector<ScanRemark>& remarks) {
  switch (bytes.at<unsigned char>(kUnits) & 7U) {
    case 1:
      return 1000.0;
    case 2:
      return 1.0;
    case 3:
      return 0.001;
    case 0:
      remarks.push_back({"N06", true, Text::tr("the file names no unit of length; millimetres are assumed"),
                         std::nullopt, Text::tr("Check the size of the organ")});
      return 1.0;
    default:
      break;
  }
  refuseHeader(Text::tr("N06 the file's unit of length is unknown"), where,
               Text::tr("Save the volume with lengths in millimetres"));
}

/// Columns of the rotation that NIfTI keeps as three parts of a unit quaternion.
std::array<Vec3, 3> rotationOf(const HeaderBytes& bytes, const std::string& where) {
  double b = bytes.real(kQuaternion);
  double c = bytes.real(kQuaternion + 4);
  double d = bytes.real(kQuaternion + 8);
  const double rest = b * b + c * c + d * d;
  if (!(rest <= 1.01)) {
    refuseHeader(Text::tr("N05 the file's rotation is invalid: its quaternion is %1 long",
                          shortNumber(std::sqrt(rest))),
                 where, Text::tr("Export the scan again"));
  }
  double a = std::sqrt(std::max(0.0, 1.0 - rest));
  if (rest > 1.0) {
    const double length = std::sqrt(rest);
    b /= length, c /= length, d /= length, a = 0.0;
  }
  return {Vec3{a * a + b * b - c * c - d * d, 2.0 * (b * c + a * d), 2.0 * (b * d - a * c)},
          Vec3{2.0 * (b * c - a * d), a * a + c * c - b * b - d * d, 2.0 * (c * d + a * b)},
          Vec3{2.0 * (b * d + a * c), 2.0 * (c * d - a * b), a * a + d * d - c * c - b * b}};
}

/// Geometry in the file's own axes, RAS, in its unit.
void readPlace(const HeaderBytes& bytes, const std::string& where, NiftiHeader& header,
               std::vector<ScanRemark>& remarks) {
  if (bytes.at<std::int16_t>(kSformCode) > 0) {
    const auto row = [&bytes](std::size_t r, std::size_t column) {
      return bytes.real(kSrow + 16 * r + 4 * column);
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
      header.step_mm[axis] = {row(0, axis), row(1, axis), row(2, axis)};
    }
    header.origin_mm = {row(0, 3), row(1, 3), row(2, 3)};
    return;
  }
  header.step_mm = {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  if (bytes.at<std::int16_t>(kQformCode) > 0) {
    header.step_mm = rotationOf(bytes, where);
    header.origin_mm = {bytes.real(kQoffset), bytes.real(kQoffset + 4), bytes.real(kQoffset + 8)};
    header.step_mm[2] *= bytes.pixdim(0) < 0.0 ? -1.0 : 1.0;
  } else {
    remarks.push_back(
        {"N06", true,
         Text::tr("the file does not state the patient's position: left and right may be swapped"),
         std::nullopt, Text::tr("Convert the scan again from its DICOM files")});
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    header.step_mm[axis] *= std::abs(bytes.pixdim(axis + 1));
  }
}

void checkPlace(const NiftiHeader& header, double unit_mm, const std::string& where) {
  const Text again = Text::tr("Resample the volume to voxels with right angles, or export it again");
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const StatedValue side{Stated::kVoxelSide, kMillimetre_m * norm(header.step_mm[axis])};
    if (!isPlausible(side.quantity, side.value)) {
      const auto likely = unitThatFits({&side, 1}, kMillimetre_m * unit_mm);
      refuseHeader(
          Text::tr("N05 voxels are %1 along axis %2; %3 is plausible",
                   inPlausibleUnit(side.quantity, side.value), axis + 1, plausibleRange(side.quantity)),
          where,
          likely ? Text::tr("The numbers seem to be %1: save the volume with that unit", likely->name)
                 : again);
    }
  }
  if (!isFinite(header.origin_mm) || norm(header.origin_mm) > kFarthest_mm) {
    refuseHeader(Text::tr("N05 the file's origin is out of range"), where, again);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double shear = dot(normalized(header.step_mm[axis]), normalized(header.step_mm[(axis + 1) % 3]));
    if (std::abs(shear) > kMaxShear) {
      refuseHeader(Text::tr("N05 the volume is sheared: two of its axes are %1 degrees off a right angle",
                            shortNumber(std::abs(std::asin(std::clamp(shear, -1.0, 1.0))) * 57.29577951)),
                   where, again);
    }
  }
}

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
    } while (got > 0 && ++rounds < 16'384);  // the rest is not part of the scan
    int status = Z_OK;
    gzerror(file_, &status);
    return got >= 0 && (status == Z_OK || status == Z_STREAM_END);
  }

 private:
  std::string where_;
  gzFile file_ = nullptr;
};

constexpr double kMaxWhole = 32767.0;  // that a volume holds

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
    case 1024:
      return &numberAt<std::int64_t>;
    case 1280:
      return &numberAt<std::uint64_t>;
    default:
      return &numberAt<std::uint32_t>;
  }
}

/// Refuses a whole number that does not fit: cut off, the labels of a mask would become one.
void requireFits(double value, const NiftiHeader& header, const std::string& where) {
  constexpr std::int16_t kFloat = 16;
  constexpr std::int16_t kDouble = 64;
  const bool whole = header.datatype != kFloat && header.datatype != kDouble && header.slope == 1.0 &&
                     header.intercept == 0.0;
  if (whole && value > kMaxWhole) {
    throw Error(ErrorCode::kFileUnreadable,
                Text::tr("N08 a voxel has the number %1; whole numbers up to %2 are read",
                         std::to_string(static_cast<std::int64_t>(std::min(value, 9e15))),
                         std::to_string(static_cast<int>(kMaxWhole))),
                where, Text::tr("Number the labels of the mask anew, from 1 on"));
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
      if (value > kMaxWhole) {
        requireFits(value, header, where);
      }
      values.push_back(std::isnan(value)
                           ? kOutsideScan_HU
                           : static_cast<std::int16_t>(std::lround(std::clamp(value, -32768.0, kMaxWhole))));
    }
  }
  return none;
}

/// The name of a file in small letters: endings are written either way.
std::string smallName(const fs::path& file) {
  std::string name = file.filename().string();
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) {
    return c < 0x80 ? static_cast<char>(std::tolower(c)) : static_cast<char>(c);
  });
  return name;
}

/// The file with the voxels of a header in a file of its own, or the header of such voxels.
fs::path besideWith(const fs::path& file, const std::string& from, const std::string& to) {
  const std::string name = file.filename().string();
  const std::string stem = name.substr(0, smallName(file).rfind(from));
  std::string large = to;
  std::transform(large.begin(), large.end(), large.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  for (const std::string& ending : {to, large, to + ".gz", large + ".GZ", to + ".GZ", large + ".gz"}) {
    if (const fs::path beside = file.parent_path() / (stem + ending); fs::exists(beside)) {
      return beside;
    }
  }
  return file.parent_path() / (stem + to);
}

bool isNamed(const fs::path& file, const std::string& ending) {
  const std::string name = smallName(file);
  return name.ends_with(ending) || name.ends_with(ending + ".gz");
}

}  // namespace

NiftiHeader niftiHeader(std::span<const unsigned char, kNiftiHeaderBytes> bytes, const std::string& where,
                        std::vector<ScanRemark>& remarks) {
  NiftiHeader header;
  header.swapped = headerIsSwapped(bytes, where);
  const HeaderBytes numbers(bytes, header.swapped);
  header.twoFiles = hasTwoFiles(numbers, where);
  readDimensions(numbers, where, header);
  readDatatype(numbers, where, header);
  readOffset(numbers, where, header);
  readScale(numbers, header);
  const double unit_mm = unitOf(numbers, where, remarks);
  readPlace(numbers, where, header, remarks);
  for (Vec3* const v : {&header.origin_mm, &header.step_mm[0], &header.step_mm[1], &header.step_mm[2]}) {
    *v = {-unit_mm * v->x, -unit_mm * v->y, unit_mm * v->z};  // RAS to LPS
  }
  checkPlace(header, unit_mm, where);
  return header;
}

namespace fs = std::filesystem;

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
        Text::tr("N04 the voxels are in a separate file, NAME.img beside NAME.hdr, which is missing"), where);
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
