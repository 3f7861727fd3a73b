// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/markers.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "sim/base/error.h"

namespace torsio::gui {

namespace {

constexpr double kMetresPerMillimetre = 0.001;

}  // namespace

std::vector<SkinAnchor> organMarkers(const Scene& scene, const std::filesystem::path& assets) {
  const std::filesystem::path path = assets / "organs" / (scene.id + "_markers.json");
  QFile file(QString::fromStdString(path.string()));
  if (!file.open(QIODevice::ReadOnly)) return {};
  const QJsonArray entries =
      QJsonDocument::fromJson(file.readAll()).object()[QLatin1String("markers")].toArray();
  std::vector<SkinAnchor> markers;
  for (const QJsonValue& entry : entries) {
    const QJsonArray place_mm = entry.toObject()[QLatin1String("position_mm")].toArray();
    if (place_mm.size() != 3) {
      throw Error(ErrorCode::kBadData, "a marker has no position of three numbers", path.string(),
                  "Correct the file, or remove it");
    }
    const Vec3 place_m{place_mm[0].toDouble() * kMetresPerMillimetre,
                       place_mm[1].toDouble() * kMetresPerMillimetre,
                       place_mm[2].toDouble() * kMetresPerMillimetre};
    markers.push_back(skinAnchor(scene, place_m));
  }
  return markers;
}

QVector3D markerPlace(const SkinAnchor& marker, const OrganSurface& surface) {
  QVector3D place;
  for (std::size_t k = 0; k < 3; ++k) {
    const SurfaceVertex& v = surface.vertices()[marker.corners[k]];
    place += marker.weights[k] * QVector3D(v.position[0], v.position[1], v.position[2]);
  }
  return place;
}

}  // namespace torsio::gui
