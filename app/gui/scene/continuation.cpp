// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/continuation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "app/gui/scene/outline.h"

namespace torsio::gui {

namespace {

constexpr std::size_t kTubeRings = 25;
constexpr std::size_t kTubeSides = 18;
constexpr float kInside = 0.9F;        // of the organ's end: it covers where the tube begins
constexpr float kWaist = 0.12F;        // by which the tube is narrower half-way
constexpr double kAtTheEnd_m = 0.015;  // from the middle of the shipped stomach's ends to their skin

struct OpenRing {
  QVector3D middle;
  float radius = 0.0F;
};

OpenRing openRing(const std::array<SkinAnchor, 4>& anchors, const OrganSurface& surface) {
  OpenRing ring;
  for (const SkinAnchor& anchor : anchors) {
    ring.middle += markerPlace(anchor, surface) / static_cast<float>(anchors.size());
  }
  for (const SkinAnchor& anchor : anchors) {
    ring.radius += (markerPlace(anchor, surface) - ring.middle).length() / static_cast<float>(anchors.size());
  }
  return ring;
}

std::array<SkinAnchor, 4> anchorsRound(const Scene& scene, const Vec3& middle_m, const Vec3& direction) {
  const Vec3 aside = std::abs(direction.y) < 0.9 ? Vec3{0.0, 1.0, 0.0} : Vec3{1.0, 0.0, 0.0};
  const Vec3 first = normalized(cross(direction, aside));
  const Vec3 second = cross(direction, first);
  constexpr double kBeside_m = 0.010;
  return {skinAnchor(scene, middle_m + kBeside_m * first), skinAnchor(scene, middle_m + kBeside_m * second),
          skinAnchor(scene, middle_m - kBeside_m * first), skinAnchor(scene, middle_m - kBeside_m * second)};
}

/// A tube's centre line: from an end of the organ, in its direction, to the painted part, in its direction.
class Way {
 public:
  Way(const QVector3D& from, const QVector3D& outwards, const QVector3D& to, const QVector3D& onwards)
      : from_(from), to_(to) {
    const float length = (to - from).length();
    first_ = length * outwards;
    last_ = length * onwards;
  }
  [[nodiscard]] QVector3D at(float t) const {
    const float u = 1.0F - t;
    return (1.0F + 2.0F * t) * u * u * from_ + t * u * u * first_ + (3.0F - 2.0F * t) * t * t * to_ -
           t * t * u * last_;
  }

 private:
  QVector3D from_;
  QVector3D to_;
  QVector3D first_;
  QVector3D last_;
};

EdgeVertex corner(const QVector3D& at, const QVector3D& normal) {
  return {
      {at.x(), at.y(), at.z()}, {normal.x(), normal.y(), normal.z()}, {1.0F, 1.0F, 1.0F, 1.0F}, {0.0F, 0.0F}};
}

/// Appends the triangles of a tube; its frames turn no more than they must.
void appendTube(const Way& way, float radius, std::vector<EdgeVertex>& corners) {
  std::vector<EdgeVertex> rings;
  QVector3D aside;
  for (std::size_t i = 0; i < kTubeRings; ++i) {
    constexpr float kStep = 1e-3F;
    const float t = static_cast<float>(i) / static_cast<float>(kTubeRings - 1);
    const QVector3D middle = way.at(t);
    const QVector3D along = (way.at(t + kStep) - way.at(t - kStep)).normalized();
    if (i == 0) {
      aside = QVector3D::crossProduct(along,
                                      std::abs(along.y()) < 0.9F ? QVector3D(0, 1, 0) : QVector3D(1, 0, 0));
    }
    aside = (aside - QVector3D::dotProduct(aside, along) * along).normalized();
    const QVector3D across = QVector3D::crossProduct(along, aside);
    const float wide = radius * (1.0F - kWaist * 4.0F * t * (1.0F - t));
    for (std::size_t k = 0; k < kTubeSides; ++k) {
      const float angle = 6.2831853F * static_cast<float>(k) / static_cast<float>(kTubeSides);
      const QVector3D normal = std::cos(angle) * aside + std::sin(angle) * across;
      rings.push_back(corner(middle + wide * normal, normal));
    }
  }
  for (std::size_t i = 0; i + 1 < kTubeRings; ++i) {
    for (std::size_t k = 0; k < kTubeSides; ++k) {
      const EdgeVertex& a = rings[i * kTubeSides + k];
      const EdgeVertex& b = rings[i * kTubeSides + (k + 1) % kTubeSides];
      const EdgeVertex& c = rings[(i + 1) * kTubeSides + k];
      const EdgeVertex& d = rings[(i + 1) * kTubeSides + (k + 1) % kTubeSides];
      corners.insert(corners.end(), {a, b, d, a, d, c});
    }
  }
}

}  // namespace

std::vector<Continuation> stomachContinuations(const Scene& scene) {
  struct Open {
    Vec3 middle_m;
    Vec3 outwards;
    QPointF painted;
    QPointF onwards;
  };
  // Middles of stub and bulb, a little before their rounded ends: assets/organs/README.md, sim/anatomy.
  static const std::array kOpen{
      Open{{0.0054, 0.0188, 0.0671}, normalized(Vec3{-20.0, 1.0, 29.0}), {-0.236, 0.98}, {-0.01, 1.0}},
      Open{{-0.0575, 0.0150, -0.0560}, normalized(Vec3{-5.5, 6.0, 7.0}), {-1.00, -0.13}, {-0.97, -0.24}}};
  constexpr double kBefore_m = 0.008;
  std::vector<Continuation> ends;
  for (const Open& open : kOpen) {
    const double away_m = scene.collision.closest(open.middle_m).distance_m;
    if (away_m > 0.0 || away_m < -kAtTheEnd_m) {
      return {};
    }
    ends.push_back({anchorsRound(scene, open.middle_m, open.outwards),
                    anchorsRound(scene, open.middle_m - kBefore_m * open.outwards, open.outwards),
                    open.painted, open.onwards});
  }
  return ends;
}

ContinuationGeometry::ContinuationGeometry() {
  announceEdgeVertices(*this);
}

void ContinuationGeometry::join(std::vector<Continuation> ends, const PaintedGround& ground,
                                const OrganSurface& surface) {
  ends_ = std::move(ends);
  ground_ = ground;
  reshape();
  follow(surface);
}

void ContinuationGeometry::follow(const OrganSurface& surface) {
  std::vector<EdgeVertex> corners;
  drawnEnds_.clear();
  for (const Continuation& one : ends_) {
    const OpenRing end = openRing(one.end, surface);
    const OpenRing before = openRing(one.before, surface);
    const float radius = kInside * std::min(end.radius, before.radius);
    const QVector3D onwards(static_cast<float>(one.onwards.x()), static_cast<float>(one.onwards.y()), 0.0F);
    // It lies on the ground where the painted part goes on.
    const QVector3D painted = ground_.at(one.painted) + QVector3D(0.0F, 0.0F, radius);
    appendTube(Way(end.middle, (end.middle - before.middle).normalized(), painted, onwards.normalized()),
               radius, corners);
    drawnEnds_.push_back({end.middle, painted});
  }
  constexpr float kHuge = std::numeric_limits<float>::max();
  QVector3D low(kHuge, kHuge, kHuge);
  QVector3D high = -low;
  for (const EdgeVertex& vertex : corners) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], vertex.position[k]);
      high[k] = std::max(high[k], vertex.position[k]);
    }
  }
  setVertexData({reinterpret_cast<const char*>(corners.data()),
                 static_cast<qsizetype>(corners.size() * sizeof(EdgeVertex))});
  if (!corners.empty()) {
    setBounds(low, high);
  }
  update();
}

}  // namespace torsio::gui
