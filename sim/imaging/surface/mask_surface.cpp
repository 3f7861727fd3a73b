// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/imaging/surface/mask_surface.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "sim/core/contracts.h"
#include "sim/core/portable_math.h"
#include "sim/geometry/mesh/iso_surface.h"

namespace torsio {

namespace {

constexpr std::size_t kRoom = 4;  // voxels round the organ, for the blur
constexpr int kBlurReach = 3;
constexpr double kMetresPerMillimetre = 1e-3;

/// Blurs along one axis; what lies outside of the part is 0.
void blurAlong(OrganShares& part, std::size_t axis, const std::array<float, kBlurReach + 1>& weights) {
  const std::size_t stride = axis == 0 ? 1 : axis == 1 ? part.count[0] : part.count[0] * part.count[1];
  const std::size_t length = part.count[axis];
  const std::size_t lines = part.shares.size() / length;
  std::vector<float> line(length + 2 * kBlurReach, 0.0F);
  for (std::size_t n = 0; n < lines; ++n) {
    const std::size_t start = n / stride * stride * length + n % stride;
    for (std::size_t i = 0; i < length; ++i) {
      line[i + kBlurReach] = part.shares[start + i * stride];
    }
    for (std::size_t i = 0; i < length; ++i) {
      float sum = weights[0] * line[i + kBlurReach];
      for (std::size_t away = 1; away <= kBlurReach; ++away) {
        sum += weights[away] * (line[i + kBlurReach - away] + line[i + kBlurReach + away]);
      }
      part.shares[start + i * stride] = sum;
    }
  }
}

}  // namespace

OrganShares emptyShares(const VoxelMask& mask) {
  OrganShares part;
  std::array<std::size_t, 3> low = mask.count();
  std::array<std::size_t, 3> high{};
  for (std::size_t z = 0; z < mask.count()[2]; ++z) {
    for (std::size_t y = 0; y < mask.count()[1]; ++y) {
      for (std::size_t x = 0; x < mask.count()[0]; ++x) {
        if (mask.at(x, y, z)) {
          low = {std::min(low[0], x), std::min(low[1], y), std::min(low[2], z)};
          high = {std::max(high[0], x + 1), std::max(high[1], y + 1), std::max(high[2], z + 1)};
        }
      }
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    TORSIO_EXPECTS(low[axis] >= kRoom && high[axis] + kRoom <= mask.count()[axis]);
    part.first[axis] = low[axis] - kRoom;
    part.count[axis] = high[axis] - low[axis] + 2 * kRoom;
  }
  part.shares.assign(part.count[0] * part.count[1] * part.count[2], 0.0F);
  return part;
}

VoxelMask maskOf(const OrganShares& shares, const VoxelMask::Count& count) {
  VoxelMask mask(count);
  eachVoxelOf(shares, [&](std::size_t n, std::size_t x, std::size_t y, std::size_t z) {
    if (shares.shares[n] >= 0.5F) {
      mask.set(x, y, z);
    }
  });
  return mask;
}

OrganShares agreeing(OrganShares shares, const VoxelMask& organ) {
  eachVoxelOf(shares, [&](std::size_t n, std::size_t x, std::size_t y, std::size_t z) {
    float& share = shares.shares[n];
    if (organ.at(x, y, z) != (share >= 0.5F)) {
      share = organ.at(x, y, z) ? 1.0F : 0.0F;
    }
  });
  return shares;
}

double volume_mm3(const OrganShares& shares, const ScanVolume& grid) {
  double sum = 0.0;
  for (const float share : shares.shares) {
    sum += static_cast<double>(share);
  }
  return sum * std::abs(grid.voxel_mm3());
}

OrganShares organShares(const WorkGrid& grid, const VoxelMask& organ, const FoundPiece& found) {
  OrganShares part = emptyShares(organ);
  const VoxelMask inner = organ.shrunk(1);
  VoxelMask reach = organ.grown(1);
  reach.keepOnly(found.piece.grown(1));  // where it was closed or filled, the tissue says nothing
  eachVoxelOf(part, [&](std::size_t n, std::size_t x, std::size_t y, std::size_t z) {
    const bool within = organ.at(x, y, z);
    if (!within && !reach.at(x, y, z)) {
      return;
    }
    const double share = found.level.share(grid.volume.values[grid.volume.index(x, y, z)]);
    if (within) {
      const bool border = !inner.at(x, y, z) && found.piece.at(x, y, z);
      part.shares[n] = border ? static_cast<float>(share) : 1.0F;
    } else if (share < 0.5) {  // a neighbour of the same tissue, not the organ
      part.shares[n] = static_cast<float>(share);
    }
  });
  return part;
}

TriangleMesh surfaceOf(OrganShares part, const ScanVolume& grid, double blur) {
  std::array<float, kBlurReach + 1> weights{};
  double sum = 0.0;
  for (std::size_t away = 0; away < weights.size(); ++away) {
    const auto distance = static_cast<double>(away);
    const double weight = portableExp(-0.5 * distance * distance / (blur * blur));
    weights[away] = static_cast<float>(weight);
    sum += away == 0 ? weight : 2.0 * weight;
  }
  for (float& weight : weights) {
    weight = static_cast<float>(static_cast<double>(weight) / sum);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    blurAlong(part, axis, weights);
  }
  const std::size_t area = part.count[0] * part.count[1];
  const SampleGrid samples{{}, 1.0, part.count};
  TriangleMesh mesh = isoSurface(samples, [&part, area](std::size_t z, std::span<double> layer) {
    for (std::size_t n = 0; n < area; ++n) {
      layer[n] = 0.5 - static_cast<double>(part.shares[z * area + n]);
    }
  });
  const Vec3 first{static_cast<double>(part.first[0]), static_cast<double>(part.first[1]),
                   static_cast<double>(part.first[2])};
  for (Vec3& v : mesh.vertices_m) {
    v = kMetresPerMillimetre * grid.place_mm(first + v);
  }
  if (grid.voxel_mm3() < 0.0) {
    for (TriangleMesh::Triangle& t : mesh.triangles) {
      std::swap(t[1], t[2]);
    }
  }
  return mesh;
}

}  // namespace torsio
