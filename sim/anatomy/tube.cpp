// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/anatomy/tube.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sim/anatomy/curves.h"
#include "sim/core/angle.h"
#include "sim/core/portable_math.h"
#include "sim/geometry/query/collision_mesh.h"

namespace torsio {

namespace {

constexpr std::size_t kDomeRings = 6;

struct Ring {
  Vec3 centre;
  Vec3 e1, e2;
  SectionSize size;
  double share = 0.0;
};

Ring domeRing(const CurveFrame& end, const SectionSize& size, const Domes& domes, double share,
              std::size_t k) {
  const SinCos a = portableSinCos(0.5 * kPi * static_cast<double>(k) / static_cast<double>(kDomeRings));
  const double height = (share == 0.0 ? -domes.first : domes.last) * 0.5 * (size.e1 + size.e2);
  return {
      end.centre + (height * a.sin) * end.tangent, end.e1, end.e2, {size.e1 * a.cos, size.e2 * a.cos}, share};
}

/// The skin in millimetres, met from the curve inside it.
class Skin {
 public:
  Skin(const TriangleMesh& surface_m, const std::vector<CurveFrame>& frames, double zero_deg)
      : skin_(surface_m), frames_(frames), zero_deg_(zero_deg) {}

  [[nodiscard]] Vec3 at_m(double share, double angle_deg) const {
    const CurveFrame& frame = frames_[nearest(share)];
    const SinCos a = portableSinCos(radians(angle_deg + zero_deg_));
    const Vec3 outwards = a.cos * frame.e1 + a.sin * frame.e2;
    const Vec3 centre_m = kMillimetre_m * frame.centre;
    double outside_m = kMillimetre_m;  // the first surface met: a loop comes near itself
    while (skin_.closest(centre_m + outside_m * outwards).distance_m < 0.0) {
      outside_m += kMillimetre_m;
    }
    double inside_m = outside_m - kMillimetre_m;
    for (int i = 0; i < 40; ++i) {
      const double r_m = 0.5 * (inside_m + outside_m);
      (skin_.closest(centre_m + r_m * outwards).distance_m < 0.0 ? inside_m : outside_m) = r_m;
    }
    return centre_m + inside_m * outwards;
  }

  [[nodiscard]] double length_mm() const { return frames_.back().arc; }
  [[nodiscard]] double arc_mm(double share) const { return frames_[nearest(share)].arc; }

 private:
  [[nodiscard]] std::size_t nearest(double share) const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < frames_.size(); ++i) {
      if (std::abs(frames_[i].arc - share * length_mm()) <
          std::abs(frames_[best].arc - share * length_mm())) {
        best = i;
      }
    }
    return best;
  }

  CollisionMesh skin_;
  const std::vector<CurveFrame>& frames_;
  double zero_deg_;
};

}  // namespace

void joinRings(TriangleMesh& mesh, std::uint32_t around, std::uint32_t rings) {
  const std::uint32_t last = (rings - 1) * around;
  for (std::uint32_t i = 0; i < around; ++i) {
    const std::uint32_t next = (i + 1) % around;
    mesh.triangles.push_back({rings * around, next, i});
    for (std::uint32_t r = 0; r + 1 < rings; ++r) {
      const std::uint32_t a = r * around + i;
      const std::uint32_t b = r * around + next;
      mesh.triangles.push_back({a, b, b + around});
      mesh.triangles.push_back({a, b + around, a + around});
    }
    mesh.triangles.push_back({last + i, last + next, rings * around + 1});
  }
}

TriangleMesh closedTube(const std::vector<CurveFrame>& frames, std::size_t around, const Domes& domes,
                        const std::function<SectionSize(double)>& size,
                        const std::function<double(double, double)>& bump) {
  std::vector<Ring> rings;
  for (std::size_t k = kDomeRings - 1; k > 0; --k) {
    rings.push_back(domeRing(frames.front(), size(0.0), domes, 0.0, k));
  }
  for (const CurveFrame& f : frames) {
    const double share = f.arc / frames.back().arc;
    rings.push_back({f.centre, f.e1, f.e2, size(share), share});
  }
  for (std::size_t k = 1; k < kDomeRings; ++k) {
    rings.push_back(domeRing(frames.back(), size(1.0), domes, 1.0, k));
  }

  TriangleMesh mesh;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < around; ++i) {
      const double angle = 2.0 * kPi * static_cast<double>(i) / static_cast<double>(around);
      const SinCos a = portableSinCos(angle);
      const Vec3 radius = (ring.size.e1 * a.cos) * ring.e1 + (ring.size.e2 * a.sin) * ring.e2;
      mesh.vertices_m.push_back(ring.centre + radius + bump(ring.share, angle) * normalized(radius));
    }
  }
  const auto n = static_cast<std::uint32_t>(around);
  const auto ringCount = static_cast<std::uint32_t>(rings.size());
  mesh.vertices_m.push_back(domeRing(frames.front(), size(0.0), domes, 0.0, kDomeRings).centre);
  mesh.vertices_m.push_back(domeRing(frames.back(), size(1.0), domes, 1.0, kDomeRings).centre);
  joinRings(mesh, n, ringCount);
  return mesh;
}

std::vector<std::array<float, 2>> textureAlong(const TriangleMesh& surface,
                                               const std::vector<CurveFrame>& frames) {
  std::vector<std::array<float, 2>> texture;
  texture.reserve(surface.vertices_m.size());
  for (const Vec3& p : surface.vertices_m) {
    const auto nearest =
        std::min_element(frames.begin(), frames.end(), [&p](const CurveFrame& a, const CurveFrame& b) {
          return dot(p - a.centre, p - a.centre) < dot(p - b.centre, p - b.centre);
        });
    const Vec3 from = p - nearest->centre;
    const double angle_rad = portableAtan2(dot(from, nearest->e2), dot(from, nearest->e1));
    const double turn = angle_rad / (2.0 * kPi);
    texture.push_back(
        {static_cast<float>(nearest->arc / frames.back().arc), static_cast<float>(turn - std::floor(turn))});
  }
  return texture;
}

OrganPlaces placesOn(const TriangleMesh& surface, const std::vector<CurveFrame>& frames, double zero_deg,
                     const std::vector<WantedPlace>& wanted) {
  constexpr double kStep_mm = 10.0;
  constexpr double kFirst = 0.03;  // the line stays away from the rounded ends
  const Skin skin(surface, frames, zero_deg);
  OrganPlaces places;
  for (const WantedPlace& place : wanted) {
    places.markers.push_back(
        {place.name, skin.arc_mm(place.share), place.angle_deg, skin.at_m(place.share, place.angle_deg)});
  }
  const double span_mm = (1.0 - 2.0 * kFirst) * skin.length_mm();
  const int steps = static_cast<int>(std::lround(span_mm / kStep_mm));
  for (int k = 0; k <= steps; ++k) {
    places.zeroLine_m.push_back(skin.at_m(kFirst + (1.0 - 2.0 * kFirst) * k / steps, 0.0));
  }
  return places;
}

}  // namespace torsio
