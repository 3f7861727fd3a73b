// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/organ_shadow.h"

#include <algorithm>
#include <cstddef>

#include <QByteArray>
#include <QSignalBlocker>

namespace torsio::gui {

namespace {

// Shift of the shadow per millimetre above the ground; the lamp is at the upper left.
constexpr float kRight = 0.32F;
constexpr float kDown = 0.36F;
constexpr int kSide = OrganShadow::kSide_px;
constexpr int kPasses = 3;  // of box filters in both directions: nearly a Gaussian

/// Averages five values along lines with `step`, from `in` to `out`, both squares of kSide.
void soften(std::span<const std::uint8_t> in, std::span<std::uint8_t> out, int step, int line) {
  constexpr int kReach = 2;
  constexpr int kCount = 2 * kReach + 1;
  const auto at = [&](int row, int place) {
    return static_cast<std::size_t>(row * line + std::clamp(place, 0, kSide - 1) * step);
  };
  for (int row = 0; row < kSide; ++row) {
    int sum = 0;
    for (int k = -kReach; k <= kReach; ++k) {
      sum += in[at(row, k)];
    }
    for (int place = 0; place < kSide; ++place) {
      out[at(row, place)] = static_cast<std::uint8_t>(sum / kCount);
      sum += in[at(row, place + kReach + 1)] - in[at(row, place - kReach)];
    }
  }
}

}  // namespace

OrganShadow::OrganShadow() : shade_(static_cast<std::size_t>(kSide) * kSide, 0), other_(shade_.size(), 0) {}

OrganShadow::OrganShadow(const QVector3D& centre_mm, float radius_mm, float ground_mm) : OrganShadow() {
  centre_mm_ = centre_mm;
  radius_mm_ = radius_mm;
  ground_mm_ = ground_mm;
}

std::span<const std::uint8_t> OrganShadow::cast(const OrganSurface& organ,
                                                std::span<const std::uint32_t> of) {
  std::fill(shade_.begin(), shade_.end(), std::uint8_t{0});
  if (radius_mm_ <= 0.0F) {
    return shade_;
  }
  const std::span<const SurfaceVertex> vertices = organ.vertices();
  // Several pixels, because the vertices of a coarse mesh, or a few of a fine one, are further apart than
  // one.
  const int spot = of.empty() ? 2 : 3;
  const std::size_t count = of.empty() ? vertices.size() : of.size();
  for (std::size_t i = 0; i < count; ++i) {
    put(vertices[of.empty() ? i : of[i]], spot);
  }
  for (int pass = 0; pass < kPasses; ++pass) {
    soften(shade_, other_, 1, kSide);
    soften(other_, shade_, kSide, 1);
  }
  return shade_;
}

void OrganShadow::put(const SurfaceVertex& v, int spot) {
  const float scale = 0.5F * static_cast<float>(kSide) / (kShadowReach * radius_mm_);
  const float height = v.position[2] - ground_mm_;
  const float x = scale * (v.position[0] - centre_mm_.x() + kRight * height);
  const float y = scale * (v.position[1] - centre_mm_.y() - kDown * height);
  const int column = static_cast<int>(x) + kSide / 2 - (spot - 2);
  const int row = static_cast<int>(y) + kSide / 2 - (spot - 2);
  if (column < 1 || row < 1 || column > kSide - spot || row > kSide - spot) {
    return;
  }
  for (int k = 0; k < spot; ++k) {
    std::fill_n(&shade_[static_cast<std::size_t>((row + k) * kSide + column)], spot, std::uint8_t{255});
  }
}

void ShadowTexture::setShade(std::span<const std::uint8_t> shade) {
  setSize({kSide, kSide});
  setFormat(R8);
  setHasTransparency(false);
  setTextureData(
      QByteArray(reinterpret_cast<const char*>(shade.data()), static_cast<qsizetype>(shade.size())));
}

QSSGRenderGraphObject* ShadowTexture::updateSpatialNode(QSSGRenderGraphObject* node) {
  // As in MovingGeometry: a notification would request one more, identical frame.
  QSignalBlocker quiet(this);
  if (node == nullptr) {
    quiet.unblock();
  }
  return QQuick3DTextureData::updateSpatialNode(node);
}

}  // namespace torsio::gui
