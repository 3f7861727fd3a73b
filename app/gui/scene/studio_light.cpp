// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/studio_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <QByteArray>
#include <QSize>
#include <QVector3D>
#include <qfloat16.h>

namespace torsio::gui {

namespace {

constexpr int kWidth = 32;
constexpr int kHeight = 16;

/// A round lamp with a soft rim.
struct Lamp {
  QVector3D direction;  ///< towards the lamp
  float radius_deg;
  float softness_deg;
  QVector3D radiance;
};

const std::array<Lamp, 4>& lamps() {
  static const std::array<Lamp, 4> kLamps = {{
      {QVector3D(-0.35F, 0.85F, 0.55F).normalized(), 15.0F, 7.0F, {14.0F, 13.6F, 13.0F}},  // operating lamp
      {QVector3D(0.75F, 0.55F, 0.55F).normalized(), 11.0F, 9.0F, {4.6F, 4.8F, 5.2F}},      // second lamp
      {QVector3D(-0.95F, 0.05F, 0.30F).normalized(), 20.0F, 16.0F, {1.1F, 1.2F, 1.35F}},   // wall panel
      {QVector3D(0.25F, 0.25F, -0.95F).normalized(), 18.0F, 14.0F, {2.2F, 2.3F, 2.5F}},    // from behind: rim
  }};
  return kLamps;
}

QVector3D radianceTowards(const QVector3D& direction) {
  const float height = direction.y();
  // Ceiling, walls, floor: a neutral room, a little warm from below where tissue lights tissue.
  const float t = 0.5F + 0.5F * height;
  QVector3D sum = QVector3D(0.26F, 0.225F, 0.21F) * (1.0F - t) + QVector3D(0.62F, 0.65F, 0.68F) * t;
  for (const Lamp& lamp : lamps()) {
    const float cosine = std::clamp(QVector3D::dotProduct(direction, lamp.direction), -1.0F, 1.0F);
    const float angle_deg = std::acos(cosine) * 180.0F / std::numbers::pi_v<float>;
    const float rim =
        std::clamp((lamp.radius_deg + lamp.softness_deg - angle_deg) / lamp.softness_deg, 0.0F, 1.0F);
    sum += lamp.radiance * (rim * rim * (3.0F - 2.0F * rim));
  }
  return sum;
}

}  // namespace

StudioLight::StudioLight() {
  QByteArray pixels(static_cast<qsizetype>(kWidth) * kHeight * 4 * static_cast<qsizetype>(sizeof(qfloat16)),
                    Qt::Uninitialized);
  auto* out = reinterpret_cast<qfloat16*>(pixels.data());
  for (int row = 0; row < kHeight; ++row) {
    const float polar =
        std::numbers::pi_v<float> * (static_cast<float>(kHeight - row) - 0.5F) / kHeight;  // bottom row first
    for (int column = 0; column < kWidth; ++column) {
      const float turn = 2.0F * std::numbers::pi_v<float> * (static_cast<float>(column) + 0.5F) / kWidth;
      const QVector3D direction(-std::sin(polar) * std::sin(turn), std::cos(polar),
                                -std::sin(polar) * std::cos(turn));
      const QVector3D radiance = radianceTowards(direction);
      *out++ = qfloat16(radiance.x());
      *out++ = qfloat16(radiance.y());
      *out++ = qfloat16(radiance.z());
      *out++ = qfloat16(1.0F);
    }
  }
  setSize(QSize(kWidth, kHeight));
  setFormat(QQuick3DTextureData::RGBA16F);
  setHasTransparency(false);
  setTextureData(pixels);
}

}  // namespace torsio::gui
