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

std::span<const std::uint8_t> OrganShadow::cast(const OrganSurface& organ) {
  std::fill(shade_.begin(), shade_.end(), std::uint8_t{0});
  if (radius_mm_ <= 0.0F) {
    return shade_;
  }
  const float scale = 0.5F * static_cast<float>(kSide) / (kShadowReach * radius_mm_);
  for (const SurfaceVertex& v : organ.vertices()) {
    const float height = v.position[2] - ground_mm_;
    const float x = scale * (v.position[0] - centre_mm_.x() + kRight * height);
    const float y = scale * (v.position[1] - centre_mm_.y() - kDown * height);
    const int column = static_cast<int>(x) + kSide / 2;
    const int row = static_cast<int>(y) + kSide / 2;
    if (column < 1 || row < 1 || column >= kSide - 1 || row >= kSide - 1) {
      continue;
    }
    // Four pixels, because the vertices of a coarse mesh are further apart than one.
    std::uint8_t* here = &shade_[static_cast<std::size_t>(row) * kSide + static_cast<std::size_t>(column)];
    here[0] = here[1] = here[kSide] = here[kSide + 1] = 255;
  }
  for (int pass = 0; pass < kPasses; ++pass) {
    soften(shade_, other_, 1, kSide);
    soften(other_, shade_, kSide, 1);
  }
  return shade_;
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
