// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scan_files.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <vector>
#include <zlib.h>

namespace torsio::testing {

namespace {

/// Writes numbers into a header in the file's byte order.
class HeadWriter {
 public:
  explicit HeadWriter(bool swapped) : swapped_(swapped), bytes_(348, '\0') {}
  template <typename Number>
  void put(std::size_t place, Number number) {
    auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    if (swapped_) {
      std::reverse(raw.begin(), raw.end());
    }
    std::memcpy(bytes_.data() + place, raw.data(), raw.size());
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  bool swapped_;
  std::string bytes_;
};

template <typename Number>
void appendNumber(std::string& bytes, double value, bool swapped) {
  auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(static_cast<Number>(value));
  if (swapped) {
    std::reverse(raw.begin(), raw.end());
  }
  bytes.append(raw.data(), raw.size());
}

std::int16_t bitsOf(std::int16_t datatype) {
  switch (datatype) {
    case 2:
    case 256:
      return 8;
    case 4:
    case 512:
      return 16;
    case 64:
    case 1024:
    case 1280:
      return 64;
    default:
      return 32;
  }
}

/// Finds where a ray along x through (y, z) crosses the surface.
void addCrossings(const TriangleMesh& mesh, const std::array<std::size_t, 2>& rays, const Vec3& first_m,
                  double y_m, double z_m, std::vector<std::vector<double>>& crossings) {
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.vertices_m[t[0]];
    const Vec3& b = mesh.vertices_m[t[1]];
    const Vec3& c = mesh.vertices_m[t[2]];
    const double all = (b.y - a.y) * (c.z - a.z) - (c.y - a.y) * (b.z - a.z);
    if (all == 0.0) {
      continue;
    }
    const auto from = [](double least, double first, double step) {
      return static_cast<std::size_t>(std::max(0.0, std::ceil((least - first) / step)));
    };
    for (std::size_t k = from(std::min({a.z, b.z, c.z}), first_m.z, z_m); k < rays[1]; ++k) {
      const double z = first_m.z + static_cast<double>(k) * z_m;
      if (z > std::max({a.z, b.z, c.z})) {
        break;
      }
      for (std::size_t j = from(std::min({a.y, b.y, c.y}), first_m.y, y_m); j < rays[0]; ++j) {
        const double y = first_m.y + static_cast<double>(j) * y_m;
        if (y > std::max({a.y, b.y, c.y})) {
          break;
        }
        const double u = ((y - a.y) * (c.z - a.z) - (c.y - a.y) * (z - a.z)) / all;
        const double v = ((b.y - a.y) * (z - a.z) - (y - a.y) * (b.z - a.z)) / all;
        if (u >= 0.0 && v >= 0.0 && u + v < 1.0) {
          crossings[k * rays[0] + j].push_back(a.x + u * (b.x - a.x) + v * (c.x - a.x));
        }
      }
    }
  }
}

}  // namespace

ScanVolume blankScan(const std::array<std::size_t, 3>& count, const Vec3& voxel_mm, const Vec3& corner_mm,
                     std::int16_t value) {
  ScanVolume scan;
  scan.count = count;
  scan.values.assign(count[0] * count[1] * count[2], value);
  scan.origin_mm = corner_mm;
  scan.step_mm = {Vec3{voxel_mm.x, 0, 0}, Vec3{0, voxel_mm.y, 0}, Vec3{0, 0, voxel_mm.z}};
  return scan;
}

ScanVolume blankScanAround(const TriangleMesh& mesh, const Vec3& voxel_mm, double margin_mm) {
  Vec3 low = 1000.0 * mesh.vertices_m.front();
  Vec3 high = low;
  for (const Vec3& v : mesh.vertices_m) {
    low = {std::min(low.x, 1000.0 * v.x), std::min(low.y, 1000.0 * v.y), std::min(low.z, 1000.0 * v.z)};
    high = {std::max(high.x, 1000.0 * v.x), std::max(high.y, 1000.0 * v.y), std::max(high.z, 1000.0 * v.z)};
  }
  const auto voxels = [margin_mm](double side_mm, double one_mm) {
    return static_cast<std::size_t>(std::ceil((side_mm + 2.0 * margin_mm) / one_mm));
  };
  return blankScan({voxels(high.x - low.x, voxel_mm.x), voxels(high.y - low.y, voxel_mm.y),
                    voxels(high.z - low.z, voxel_mm.z)},
                   voxel_mm, low - Vec3{margin_mm, margin_mm, margin_mm});
}

void fillWith(ScanVolume& scan, const TriangleMesh& mesh, std::int16_t value) {
  constexpr std::size_t kRays = 2;  // per voxel, each way; slightly shifted, so that none hits a vertex
  const double x_mm = scan.step_mm[0].x;
  const double y_m = 0.001 * scan.step_mm[1].y / kRays;
  const double z_m = 0.001 * scan.step_mm[2].z / kRays;
  const std::array<std::size_t, 2> rays{kRays * scan.count[1], kRays * scan.count[2]};
  const Vec3 first_m{0.0, 0.001 * (scan.origin_mm.y - 0.2503 * scan.step_mm[1].y),
                     0.001 * (scan.origin_mm.z - 0.2507 * scan.step_mm[2].z)};
  std::vector<std::vector<double>> crossings(rays[0] * rays[1]);
  addCrossings(mesh, rays, first_m, y_m, z_m, crossings);
  std::vector<float> covered(scan.values.size(), 0.0F);
  for (std::size_t ray = 0; ray < crossings.size(); ++ray) {
    std::vector<double>& x_m = crossings[ray];
    std::sort(x_m.begin(), x_m.end());
    float* const row = covered.data() + scan.index(0, ray % rays[0] / kRays, ray / rays[0] / kRays);
    for (std::size_t n = 0; n + 1 < x_m.size(); n += 2) {
      // In voxels from the left face of the first one.
      const double from = std::max(0.0, (1000.0 * x_m[n] - scan.origin_mm.x) / x_mm + 0.5);
      const double to =
          std::min(static_cast<double>(scan.count[0]), (1000.0 * x_m[n + 1] - scan.origin_mm.x) / x_mm + 0.5);
      for (auto i = static_cast<std::size_t>(from); static_cast<double>(i) < to; ++i) {
        const double left = std::max(from, static_cast<double>(i));
        const double right = std::min(to, static_cast<double>(i + 1));
        row[i] += static_cast<float>((right - left) / (kRays * kRays));
      }
    }
  }
  for (std::size_t n = 0; n < covered.size(); ++n) {
    const auto was = static_cast<float>(scan.values[n]);
    scan.values[n] =
        static_cast<std::int16_t>(std::lround(was + covered[n] * (static_cast<float>(value) - was)));
  }
}

std::string niftiHead(const ScanVolume& scan, const NiftiStyle& style) {
  HeadWriter head(style.swapped);
  head.put<std::int32_t>(0, 348);
  head.put<std::int16_t>(40, 3);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    head.put(42 + 2 * axis, static_cast<std::int16_t>(scan.count[axis]));
    head.put(80 + 4 * axis, static_cast<float>(norm(scan.step_mm[axis])));
    const Vec3& step = scan.step_mm[axis];
    if (style.sform) {
      head.put(280 + 4 * axis, static_cast<float>(-step.x));
      head.put(296 + 4 * axis, static_cast<float>(-step.y));
      head.put(312 + 4 * axis, static_cast<float>(step.z));
    }
  }
  head.put(70, style.datatype);
  head.put(72, bitsOf(style.datatype));
  head.put<float>(76, 1.0F);
  head.put<float>(108, style.twoFiles ? 0.0F : 352.0F);
  head.put(112, style.slope);
  head.put(116, style.intercept);
  head.put(123, style.units);
  if (style.sform) {
    head.put<std::int16_t>(254, 1);
    head.put(292, static_cast<float>(-scan.origin_mm.x));
    head.put(308, static_cast<float>(-scan.origin_mm.y));
    head.put(324, static_cast<float>(scan.origin_mm.z));
  }
  if (style.qform) {
    head.put<std::int16_t>(252, 1);
    head.put(264, 1.0F);  // a half turn about z: RAS for axes in LPS directions
    head.put(268, static_cast<float>(-scan.origin_mm.x));
    head.put(272, static_cast<float>(-scan.origin_mm.y));
    head.put(276, static_cast<float>(scan.origin_mm.z));
  }
  std::string bytes = head.bytes();
  bytes.replace(148, 17, "DOE^JANE 19670401");  // left in the description by some converters
  bytes.replace(344, 3, style.twoFiles ? "ni1" : "n+1");
  return style.twoFiles ? bytes : bytes + std::string(4, '\0');
}

std::string niftiVoxels(const ScanVolume& scan, const NiftiStyle& style) {
  std::string bytes;
  const double slope = style.slope == 0.0F ? 1.0 : static_cast<double>(style.slope);
  for (const std::int16_t value : scan.values) {
    const double stored = (value - static_cast<double>(style.intercept)) / slope;
    switch (style.datatype) {
      case 2:
        appendNumber<std::uint8_t>(bytes, stored, style.swapped);
        break;
      case 4:
        appendNumber<std::int16_t>(bytes, stored, style.swapped);
        break;
      case 8:
        appendNumber<std::int32_t>(bytes, stored, style.swapped);
        break;
      case 16:
        appendNumber<float>(bytes, stored, style.swapped);
        break;
      case 64:
        appendNumber<double>(bytes, stored, style.swapped);
        break;
      case 256:
        appendNumber<std::int8_t>(bytes, stored, style.swapped);
        break;
      case 512:
        appendNumber<std::uint16_t>(bytes, stored, style.swapped);
        break;
      case 1024:
        appendNumber<std::int64_t>(bytes, stored, style.swapped);
        break;
      case 1280:
        appendNumber<std::uint64_t>(bytes, stored, style.swapped);
        break;
      default:
        appendNumber<std::uint32_t>(bytes, stored, style.swapped);
    }
  }
  return bytes;
}

std::string gzipped(const std::string& bytes) {
  z_stream stream{};
  deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
  std::string packed(deflateBound(&stream, bytes.size()) + 32, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

}  // namespace torsio::testing
