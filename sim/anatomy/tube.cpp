// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/anatomy/tube.h"

#include <algorithm>
#include <cmath>

#include "sim/core/portable_math.h"

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

}  // namespace

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
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    mesh.triangles.push_back({ringCount * n, next, i});
    for (std::uint32_t r = 0; r + 1 < ringCount; ++r) {
      const std::uint32_t a = r * n + i;
      const std::uint32_t b = r * n + next;
      mesh.triangles.push_back({a, b, b + n});
      mesh.triangles.push_back({a, b + n, a + n});
    }
    const std::uint32_t last = (ringCount - 1) * n;
    mesh.triangles.push_back({last + i, last + next, ringCount * n + 1});
  }
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

}  // namespace torsio
