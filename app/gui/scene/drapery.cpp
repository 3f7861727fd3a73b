// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/drapery.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "sim/scene/tissue_look.h"

namespace torsio::gui {

namespace {

constexpr int kSides = 52;
constexpr double kMetre_mm = 1e-3;

double eased(double low, double high, double value) {
  const double t = std::clamp((value - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// Centre and half extents of a slab of a body, across it.
struct Section {
  double x = 0.0;
  double y = 0.0;
  double halfX = 0.0;
  double halfY = 0.0;
};

/// `points`: two coordinates across, then along.
Section sectionOf(std::span<const Vec3> points, double from, double to) {
  constexpr double kHuge = std::numeric_limits<double>::max();
  double low[2] = {kHuge, kHuge};
  double high[2] = {-kHuge, -kHuge};
  for (const Vec3& p : points) {
    if (p.z >= from && p.z <= to) {
      low[0] = std::min(low[0], p.x);
      high[0] = std::max(high[0], p.x);
      low[1] = std::min(low[1], p.y);
      high[1] = std::max(high[1], p.y);
    }
  }
  return {0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]), 0.5 * (high[0] - low[0]),
          0.5 * (high[1] - low[1])};
}

/// A ring of cloth: its position along, and its width relative to the body inside.
struct Ring {
  double along = 0.0;
  double wide = 1.0;
};

/// A turned-back hem, in half widths. Its rim touches the body, so that there is no gap.
constexpr std::array<Ring, 10> kHem{{{0.03, 0.82},
                                     {-0.02, 1.02},
                                     {-0.015, 1.06},
                                     {0.02, 1.085},
                                     {0.10, 1.095},
                                     {0.28, 1.115},
                                     {0.45, 1.135},
                                     {0.50, 1.125},
                                     {0.545, 1.095},
                                     {0.60, 1.08}}};

/// Builds a closed surface over rings of kSides points each; the ends close at their centres.
TriangleMesh skinOver(const std::vector<std::array<Vec3, kSides>>& rings) {
  TriangleMesh mesh;
  constexpr auto kAround = static_cast<std::uint32_t>(kSides);
  const auto middle = [](const std::array<Vec3, kSides>& ring) {
    Vec3 sum;
    for (const Vec3& p : ring) {
      sum += p;
    }
    return sum / static_cast<double>(kSides);
  };
  mesh.vertices_m.push_back(kMetre_mm * middle(rings.front()));
  for (const std::array<Vec3, kSides>& ring : rings) {
    for (const Vec3& p : ring) {
      mesh.vertices_m.push_back(kMetre_mm * p);
    }
  }
  mesh.vertices_m.push_back(kMetre_mm * middle(rings.back()));
  const auto last = static_cast<std::uint32_t>(rings.size() - 1) * kAround;
  const auto end = static_cast<std::uint32_t>(mesh.vertices_m.size() - 1);
  for (std::uint32_t i = 0; i < kAround; ++i) {
    const std::uint32_t here = 1 + i;
    const std::uint32_t next = 1 + (i + 1) % kAround;
    mesh.triangles.push_back({0, next, here});
    for (std::uint32_t at = 0; at < last; at += kAround) {
      mesh.triangles.push_back({here + at, next + at, next + at + kAround});
      mesh.triangles.push_back({here + at, next + at + kAround, here + at + kAround});
    }
    mesh.triangles.push_back({here + last, next + last, end});
  }
  return mesh;
}

double noise(double x, double y, double z) {
  return static_cast<double>(tissueNoise({x, y, z}));
}

/// Folds of cloth round an arm, in half widths: broad ones, narrower ones along the arm, creases.
double foldAt(double angle, double along) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const double crease = 1.0 - 2.0 * std::abs(noise(1.9 * c, 1.9 * s + 5.0, 0.55 * along));
  return 0.15 * noise(1.2 * c, 1.2 * s, 0.75 * along) + 0.10 * noise(2.9 * c + 4.0, 2.9 * s, 0.33 * along) +
         0.06 * crease + 0.05 * noise(3.1 * c, 3.1 * s + 9.0, 1.9 * along);
}

/// Slant of the hem, half widths.
double hemAt(double angle, double along) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return (1.0 - eased(0.6, 2.0, along)) *
         (0.13 * noise(1.1 * c + 2.0, 1.1 * s, 1.0) + 0.05 * noise(2.6 * c, 2.6 * s + 3.0, 2.0));
}

/// Amplitude of the folds: the hem is smoother than the loose cloth behind it, and its rim fits closely.
double foldedAt(double along) {
  return 0.35 * eased(0.0, 0.4, along) + 0.65 * eased(0.5, 1.9, along);
}

/// Returns the rings of a hem and the cloth behind it, `length` half widths long, denser near the hem.
std::vector<Ring> ringsOf(double length, double widening) {
  constexpr int kRings = 34;
  std::vector<Ring> rings(kHem.begin(), kHem.end());
  for (int k = 1; k <= kRings; ++k) {
    const double share = static_cast<double>(k) / kRings;
    const double along = kHem.back().along + length * share * (0.35 + 0.65 * share);
    rings.push_back({along, kHem.back().wide + widening * eased(0.0, 3.0, along)});
  }
  return rings;
}

}  // namespace

TriangleMesh drapeOverArm(const OrganSurface& arm, float ground_mm) {
  std::vector<Vec3> points;  // x, towards the viewer, down the arm
  double end = -std::numeric_limits<double>::max();
  for (const SurfaceVertex& v : arm.vertices()) {
    points.push_back({static_cast<double>(v.position[0]), static_cast<double>(v.position[2]),
                      -static_cast<double>(v.position[1])});
    end = std::max(end, points.back().z);
  }
  constexpr double kSlab_mm = 30.0;
  const Section section = sectionOf(points, end - kSlab_mm, end);
  const double size = std::max(section.halfX, section.halfY);
  constexpr double kCovered = 0.42;  // covered part of the arm, half widths
  constexpr double kLength = 15.0;   // half widths: extends beyond the painted square
  const auto ground = static_cast<double>(ground_mm);
  std::vector<std::array<Vec3, kSides>> rings;
  for (const Ring& ring : ringsOf(kLength, 0.28)) {
    const double loose = eased(0.5, 2.2, ring.along);
    const double flat = eased(0.75 * kLength, kLength, ring.along);  // its end lies on the table
    std::array<Vec3, kSides>& places = rings.emplace_back();
    for (int k = 0; k < kSides; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / kSides;
      const double wide = ring.wide + foldedAt(ring.along) * foldAt(angle, ring.along);
      const double along = ring.along + hemAt(angle, ring.along);
      const double below = std::max(0.0, -std::sin(angle));
      const double x = section.x + section.halfX * wide * std::cos(angle) * (1.0 + 0.75 * loose * below);
      double towards = section.y + section.halfY * wide * std::sin(angle);
      towards += loose * eased(0.0, 0.8, below) * (ground - towards);
      towards = std::max(towards + 0.9 * flat * (ground - towards), ground);
      places[static_cast<std::size_t>(k)] = {x, -(end + size * (along - kCovered)), towards};
    }
  }
  return skinOver(rings);
}

TriangleMesh gownSleeve(const TriangleMesh& glove) {
  std::vector<Vec3> points;
  double end = -std::numeric_limits<double>::max();
  for (const Vec3& v : glove.vertices_m) {
    points.push_back(v / kMetre_mm);
    end = std::max(end, points.back().z);
  }
  constexpr double kSlab_mm = 14.0;
  constexpr double kStep_mm = 24.0;
  const Section cuff = sectionOf(points, end - kSlab_mm, end);
  const Section before = sectionOf(points, end - kSlab_mm - kStep_mm, end - kStep_mm);
  const double slope[2] = {(cuff.x - before.x) / kStep_mm, (cuff.y - before.y) / kStep_mm};
  const double size = std::max(cuff.halfX, cuff.halfY);
  constexpr double kCovered = 0.75;
  constexpr double kLength = 19.0;
  std::vector<std::array<Vec3, kSides>> rings;
  for (const Ring& ring : ringsOf(kLength, 0.45)) {
    const double z = end + size * (ring.along - kCovered);
    const double on = z - (end - 0.5 * kSlab_mm);
    // The path of the cuff, which bends until the arm runs along the shaft.
    constexpr double kBend_mm = 160.0;
    const double aside = on < 0.0 ? on : kBend_mm * (1.0 - std::exp(-on / kBend_mm));
    const double over = std::clamp((ring.along - kHem.back().along) / kLength - 0.9, 0.0, 0.1) / 0.1;
    const double shut = std::sqrt(1.0 - 0.98 * over * over);  // rounded end
    std::array<Vec3, kSides>& places = rings.emplace_back();
    for (int k = 0; k < kSides; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / kSides;
      const double wide = shut * (ring.wide + 0.8 * foldedAt(ring.along) * foldAt(angle, ring.along));
      places[static_cast<std::size_t>(k)] = {cuff.x + slope[0] * aside + cuff.halfX * wide * std::cos(angle),
                                             cuff.y + slope[1] * aside + cuff.halfY * wide * std::sin(angle),
                                             z + 0.5 * size * hemAt(angle, ring.along)};
    }
  }
  return skinOver(rings);
}

}  // namespace torsio::gui
