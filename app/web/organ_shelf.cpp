// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/web/organ_shelf.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <QBuffer>
#include <QImage>

#include "app/web/binary_container.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"
#include "sim/scene/skin/tissue_skin.h"
#include "sim/scene/tissue_look.h"

namespace torsio::web {

namespace {

constexpr std::size_t kMaxSkins = 16;  // half a megabyte each
constexpr std::size_t kNameDigits = 32;
constexpr int kColourQuality = 86;
constexpr int kHeightQuality = 78;
constexpr float kPlaceStep_px = 0.0625F;

/// Digest of everything that paintSkin() reads of a scene.
std::string organDigest(const Scene& scene) {
  Digest digest;
  digest.update(scene.id);
  for (const Vec3& place_m : scene.mesh.vertices_m) {
    for (const double part : {place_m.x, place_m.y, place_m.z}) {
      digest.update(part);
    }
  }
  for (const TriangleMesh::Triangle& triangle : scene.mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      digest.update(static_cast<std::int64_t>(corner));
    }
  }
  for (const LatticeCoordinate& place : scene.lattice().vertexCoordinates()) {
    digest.update(place.arc_m);
    digest.update(place.angle_rad);
  }
  return digest.hex();
}

std::string nameOf(const std::string& bytes) {
  Digest digest;
  digest.update(std::string_view(bytes));
  return digest.hex().substr(0, kNameDigits);
}

void addPicture(BinaryContainer& container, const std::string& name, const QImage& image, int quality) {
  QBuffer file;
  file.open(QIODevice::WriteOnly);
  if (!image.save(&file, "JPG", quality)) {
    throw Error(ErrorCode::kFileMissing, Text::verbatim("Qt writes no JPEG pictures here"), "",
                Text::verbatim("Install the image formats of Qt (Debian: libqt6gui6)"));
  }
  const QByteArray& bytes = file.data();
  container.add(name, std::span(reinterpret_cast<const std::uint8_t*>(bytes.constData()),
                                static_cast<std::size_t>(bytes.size())));
}

}  // namespace

std::string skinPicture(const Scene& scene) {
  const TissueLook look = tissueLook(scene.id);
  const TissueSkin skin = paintSkin(scene, look);
  const SkinCharts& charts = skin.charts;
  std::vector<std::uint32_t> vertices;
  std::vector<float> places;
  for (const SkinCharts::Corner& corner : charts.corners) {
    vertices.push_back(corner.vertex);
    places.insert(places.end(), corner.place.begin(), corner.place.end());
  }
  std::vector<std::uint32_t> index;
  for (const TriangleMesh::Triangle& triangle : charts.triangles) {
    index.insert(index.end(), triangle.begin(), triangle.end());
  }
  BinaryContainer container;
  container.meta() = {
      {"width", charts.width},
      {"height", charts.height},
      {"look",
       {{"wetness", look.clearcoat}, {"scatter", look.scatter}, {"relief_mm", look.paintedRelief_mm}}}};
  container.addDifferences("corner", std::span<const std::uint32_t>(vertices), 1);
  container.addMultiples("place", places, kPlaceStep_px, 2);
  container.addDifferences("index", std::span<const std::uint32_t>(index), 3);
  const QImage map(skin.rgba.data(), charts.width, charts.height, 4 * charts.width, QImage::Format_RGBA8888);
  QImage height(charts.width, charts.height, QImage::Format_Grayscale8);
  for (int y = 0; y < charts.height; ++y) {
    const std::uint8_t* from = map.constScanLine(y);
    std::uint8_t* to = height.scanLine(y);
    for (int x = 0; x < charts.width; ++x) {
      to[x] = from[4 * x + 3];
    }
  }
  // The raw bytes of the colour: the fourth channel is not transparency.
  QImage colour = map;
  colour.reinterpretAsFormat(QImage::Format_RGBX8888);
  addPicture(container, "colour", colour, kColourQuality);
  addPicture(
      container, "relief",
      height.scaled(charts.width / 2, charts.height / 2, Qt::IgnoreAspectRatio, Qt::SmoothTransformation),
      kHeightQuality);
  return gzipped(container.bytes());
}

std::string OrganShelf::putSkin(const Scene& scene) {
  const std::string organ = organDigest(scene);
  const std::lock_guard one(painting_);  // requests for the same organ wait for its skin
  {
    const std::lock_guard lock(mutex_);
    const auto found = std::find_if(skins_.begin(), skins_.end(),
                                    [&organ](const Skin& skin) { return skin.organ == organ; });
    if (found != skins_.end()) {
      skins_.splice(skins_.begin(), skins_, found);
      return skins_.front().name;
    }
  }
  auto bytes = std::make_shared<const std::string>(skinPicture(scene));
  const std::lock_guard lock(mutex_);
  skins_.push_front({organ, nameOf(*bytes), std::move(bytes)});
  if (skins_.size() > kMaxSkins) {
    skins_.pop_back();
  }
  return skins_.front().name;
}

OrganShelf::Body OrganShelf::putBody(std::string bytes) {
  std::string name = nameOf(bytes);
  const std::lock_guard lock(mutex_);
  std::erase_if(bodies_, [](const auto& one) { return one.second.expired(); });
  std::weak_ptr<const std::string>& kept = bodies_[name];
  auto body = kept.lock();
  if (body == nullptr) {
    body = std::make_shared<const std::string>(std::move(bytes));
    kept = body;
  }
  return {std::move(name), std::move(body)};
}

std::shared_ptr<const std::string> OrganShelf::find(const std::string& name) {
  const std::lock_guard lock(mutex_);
  const auto skin =
      std::find_if(skins_.begin(), skins_.end(), [&name](const Skin& one) { return one.name == name; });
  if (skin != skins_.end()) {
    return skin->bytes;
  }
  const auto body = bodies_.find(name);
  return body == bodies_.end() ? nullptr : body->second.lock();
}

}  // namespace torsio::web
