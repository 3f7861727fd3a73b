// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/imaging/surface/work_grid.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "sim/core/error.h"

namespace torsio {

namespace {

/// What one sample takes of a row of voxels.
struct Shares {
  std::size_t first = 0;
  std::vector<float> weights;  ///< of first, first + 1 ...; their sum is 1
};

/// `samples` of `voxels`, both over the same length.
std::vector<Shares> sharesOf(std::size_t voxels, std::size_t samples) {
  const double ratio = static_cast<double>(voxels) / static_cast<double>(samples);
  const double half = 0.5 * std::max(1.0, ratio);
  std::vector<Shares> all(samples);
  for (std::size_t s = 0; s < samples; ++s) {
    const double middle = (static_cast<double>(s) + 0.5) * ratio;
    const double from = std::max(0.0, middle - half);
    const double to = std::min(static_cast<double>(voxels), middle + half);
    Shares& one = all[s];
    one.first = std::min(static_cast<std::size_t>(from), voxels - 1);
    for (std::size_t v = one.first; static_cast<double>(v) < to && v < voxels; ++v) {
      const double part = std::min(to, static_cast<double>(v + 1)) - std::max(from, static_cast<double>(v));
      one.weights.push_back(static_cast<float>(part / (to - from)));
    }
  }
  return all;
}

/// Slices of a scan, sampled anew along i and j, each made once.
class SampledSlices {
 public:
  SampledSlices(const ScanVolume& scan, const VoxelRange& range, const std::array<std::size_t, 3>& samples,
                const std::function<float(std::int16_t)>& valueOf)
      : scan_(scan),
        range_(range),
        samples_(samples),
        alongI_(sharesOf(range.high[0] - range.low[0], samples[0])),
        alongJ_(sharesOf(range.high[1] - range.low[1], samples[1])),
        values_(65'536) {
    for (std::size_t v = 0; v < values_.size(); ++v) {
      values_[v] = valueOf(static_cast<std::int16_t>(static_cast<int>(v) - 32'768));
    }
  }

  /// Slice k of the range; those before it are forgotten.
  const std::vector<float>& at(std::size_t k, std::size_t oldest) {
    while (!kept_.empty() && first_ < oldest) {
      kept_.pop_front();
      ++first_;
    }
    if (kept_.empty()) {
      first_ = oldest;
    }
    while (first_ + kept_.size() <= k) {
      kept_.push_back(sampled(first_ + kept_.size()));
    }
    return kept_[k - first_];
  }

 private:
  std::vector<float> sampled(std::size_t k) const {
    const std::size_t rows = range_.high[1] - range_.low[1];
    std::vector<float> narrow(samples_[0] * rows);
    for (std::size_t j = 0; j < rows; ++j) {
      const std::int16_t* const row =
          scan_.values.data() + scan_.index(range_.low[0], range_.low[1] + j, range_.low[2] + k);
      for (std::size_t s = 0; s < samples_[0]; ++s) {
        const Shares& take = alongI_[s];
        float sum = 0.0F;
        for (std::size_t w = 0; w < take.weights.size(); ++w) {
          sum += take.weights[w] * values_[static_cast<std::size_t>(row[take.first + w] + 32'768)];
        }
        narrow[j * samples_[0] + s] = sum;
      }
    }
    std::vector<float> slice(samples_[0] * samples_[1], 0.0F);
    for (std::size_t s = 0; s < samples_[1]; ++s) {
      const Shares& take = alongJ_[s];
      float* const to = slice.data() + s * samples_[0];
      for (std::size_t w = 0; w < take.weights.size(); ++w) {
        const float* const from = narrow.data() + (take.first + w) * samples_[0];
        for (std::size_t x = 0; x < samples_[0]; ++x) {
          to[x] += take.weights[w] * from[x];
        }
      }
    }
    return slice;
  }

  const ScanVolume& scan_;
  const VoxelRange& range_;
  std::array<std::size_t, 3> samples_;
  std::vector<Shares> alongI_;
  std::vector<Shares> alongJ_;
  std::vector<float> values_;  // of every value that a voxel may have
  std::deque<std::vector<float>> kept_;
  std::size_t first_ = 0;
};

}  // namespace

VoxelRange rangeOf(const ScanVolume& scan, const std::optional<ScanBox>& box, const std::string& where) {
  VoxelRange range{{0, 0, 0}, scan.count};
  if (!box) {
    return range;
  }
  Vec3 low{1e9, 1e9, 1e9};
  Vec3 high{-1e9, -1e9, -1e9};
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Vec3 at =
        scan.voxelAt({(*box)[corner & 1U].x, (*box)[(corner >> 1U) & 1U].y, (*box)[corner >> 2U].z});
    low = {std::min(low.x, at.x), std::min(low.y, at.y), std::min(low.z, at.z)};
    high = {std::max(high.x, at.x), std::max(high.y, at.y), std::max(high.z, at.z)};
  }
  const std::array<std::pair<double, double>, 3> sides{{{low.x, high.x}, {low.y, high.y}, {low.z, high.z}}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto last = static_cast<double>(scan.count[axis]);
    const double from = std::clamp(std::ceil(sides[axis].first), 0.0, last);
    const double to = std::clamp(std::floor(sides[axis].second) + 1.0, 0.0, last);
    if (!(to - from >= 2.0)) {
      throw Error(ErrorCode::kFileUnreadable, Text::tr("D16 the box does not overlap the scan"), where,
                  Text::tr("Give two opposite corners in millimetres: x to the left, y to the back, z up"));
    }
    range.low[axis] = static_cast<std::size_t>(from);
    range.high[axis] = static_cast<std::size_t>(to);
  }
  return range;
}

WorkGrid workGrid(const ScanVolume& scan, const VoxelRange& range, double mostVoxels,
                  const std::function<float(std::int16_t)>& valueOf, std::int16_t outside) {
  std::array<double, 3> sides_mm{};
  double least_mm = 1e9;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double voxel_mm = norm(scan.step_mm[axis]);
    least_mm = std::min(least_mm, voxel_mm);
    sides_mm[axis] = voxel_mm * static_cast<double>(range.high[axis] - range.low[axis]);
  }
  const double step_mm = std::max(least_mm, std::cbrt(sides_mm[0] * sides_mm[1] * sides_mm[2] / mostVoxels));
  WorkGrid grid;
  ScanVolume& work = grid.volume;
  std::array<std::size_t, 3> samples{};
  double product_mm3 = 1.0;
  Vec3 corner{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    samples[axis] = static_cast<std::size_t>(std::max(1.0, std::round(sides_mm[axis] / step_mm)));
    work.count[axis] = samples[axis] + 2 * WorkGrid::kMargin;
    const double ratio =
        static_cast<double>(range.high[axis] - range.low[axis]) / static_cast<double>(samples[axis]);
    work.step_mm[axis] = ratio * scan.step_mm[axis];
    product_mm3 *= norm(work.step_mm[axis]);
    const double first =
        static_cast<double>(range.low[axis]) - 0.5 + (0.5 - static_cast<double>(WorkGrid::kMargin)) * ratio;
    (axis == 0 ? corner.x : axis == 1 ? corner.y : corner.z) = first;
  }
  grid.step_mm = std::cbrt(product_mm3);
  work.origin_mm = scan.place_mm(corner);
  work.values.assign(work.count[0] * work.count[1] * work.count[2], outside);
  SampledSlices slices(scan, range, samples, valueOf);
  const std::vector<Shares> alongK = sharesOf(range.high[2] - range.low[2], samples[2]);
  std::vector<float> layer(samples[0] * samples[1]);
  for (std::size_t s = 0; s < samples[2]; ++s) {
    std::fill(layer.begin(), layer.end(), 0.0F);
    for (std::size_t w = 0; w < alongK[s].weights.size(); ++w) {
      const std::vector<float>& slice = slices.at(alongK[s].first + w, alongK[s].first);
      for (std::size_t n = 0; n < layer.size(); ++n) {
        layer[n] += alongK[s].weights[w] * slice[n];
      }
    }
    for (std::size_t n = 0; n < layer.size(); ++n) {
      work.values[work.index(n % samples[0] + WorkGrid::kMargin, n / samples[0] + WorkGrid::kMargin,
                             s + WorkGrid::kMargin)] = static_cast<std::int16_t>(std::lround(layer[n]));
    }
  }
  return grid;
}

}  // namespace torsio
