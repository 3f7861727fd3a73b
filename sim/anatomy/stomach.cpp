// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/anatomy/stomach.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "sim/anatomy/curves.h"
#include "sim/anatomy/remesh.h"
#include "sim/anatomy/tube.h"
#include "sim/core/portable_math.h"
#include "sim/geometry/mesh/mesh_check.h"

namespace torsio {

namespace {

// Gentle waves that no two places share: amplitude, periods along the organ and around it, phases.
struct Wave {
  double amplitude_mm;
  double along;
  double around;
  double phaseAlong;
  double phaseAround;
};

// Fades in over the first and out over the last tenth, so that the ends stay round.
double fade(double share) {
  const double edge = share < 0.5 ? share : 1.0 - share;
  constexpr double kWidth = 0.1;
  const double t = edge < kWidth ? edge / kWidth : 1.0;
  return t * t * (3.0 - 2.0 * t);
}

template <std::size_t N>
double wavesAt(const std::array<Wave, N>& waves, double share, double angle_rad) {
  double sum = 0.0;
  for (const Wave& w : waves) {
    sum += w.amplitude_mm * portableSinCos(2.0 * kPi * w.along * share + w.phaseAlong).sin *
           portableSinCos(w.around * angle_rad + w.phaseAround).cos;
  }
  return fade(share) * sum;
}

// Interpolated squares of the half-widths round the fundus off like a paraboloid, not like a cone.
std::vector<double> squares(std::vector<double> values) {
  for (double& v : values) {
    v *= v;
  }
  return values;
}

TriangleMesh inMetres(TriangleMesh mesh) {
  for (Vec3& v : mesh.vertices_m) {
    v *= kMillimetre_m;
  }
  return mesh;
}

}  // namespace

TubeOrgan makeStomach() {
  // Fundus first, pylorus last; mm, LPS.
  const SplineCurve centreline({{50, 30, 72},
                                {60, 22, 45},
                                {66, 10, 12},
                                {64, -4, -24},
                                {52, -16, -58},
                                {27, -23, -82},
                                {-4, -21, -90},
                                {-30, -10, -82},
                                {-47, 4, -68}});
  const std::vector<double> at{0, .03, .08, .16, .27, .40, .55, .70, .82, .92, 1};
  const MonotoneCurve halfWidth2(at, squares({3, 19, 31, 40, 44, 41, 34, 27.5, 23, 15.5, 10.5}));
  const MonotoneCurve depthRatio({0, .1, .3, .5, .65, .85, 1}, {.95, .82, .72, .80, .92, .85, .95});
  constexpr std::array<Wave, 6> kWaves{{{0.45, 2.0, 1.0, 0.3, 1.1},
                                        {0.35, 3.0, 2.0, 1.9, 0.2},
                                        {0.30, 4.0, 1.0, 4.2, 2.9},
                                        {0.25, 5.0, 3.0, 0.8, 5.1},
                                        {0.20, 7.0, 2.0, 2.4, 3.7},
                                        {0.15, 9.0, 3.0, 5.5, 0.9}}};
  constexpr std::size_t kRings = 180;
  constexpr std::size_t kAround = 112;
  constexpr Domes kDomes{.first = 0.07, .last = 0.4};  // the fundus is round already
  constexpr double kEdge_mm = 3.3;
  const Vec3 outwards{1, 0, 0};  // at the fundus the greater curvature lies to the left

  const std::vector<CurveFrame> frames = framesAlong(centreline, kRings, outwards);
  const auto size = [&halfWidth2, &depthRatio](double share) {
    const double half = std::sqrt(halfWidth2(share));
    return SectionSize{half, half * depthRatio(share)};
  };
  const auto bump = [&kWaves](double share, double angle) { return wavesAt(kWaves, share, angle); };
  const TriangleMesh fine = closedTube(frames, kAround, kDomes, size, bump);
  TubeOrgan organ;
  organ.surface = inMetres(remeshed(fine, [](const Vec3&) { return kEdge_mm; }));
  organ.fixedEnd_m = kMillimetre_m * frames.back().centre;
  organ.freeEnd_m = kMillimetre_m * frames.front().centre;
  organ.ridgeZero = -frames.back().e1;
  return organ;
}

namespace {

TubeOrgan intestineOf(double edge_mm) {
  // A loop in the frontal plane, slightly out of it, 200 mm long; mm, LPS.
  const SplineCurve centreline(
      {{-84, 0, 0}, {-61, 3, 26}, {-30.5, 4, 40}, {0, 2, 44.5}, {30.5, -2, 40}, {61, -5, 26}, {84, -4, 0}});
  constexpr double kRadius_mm = 13.0;
  constexpr double kWaveHeight_mm = 0.9;
  constexpr double kWaves = 10.0;  // circular folds seen from outside, 20 mm apart
  constexpr std::array<Wave, 3> kUneven{
      {{0.35, 1.5, 1.0, 0.4, 0.7}, {0.30, 2.5, 2.0, 2.2, 1.9}, {0.20, 4.0, 3.0, 3.1, 4.4}}};
  constexpr std::size_t kRings = 180;
  constexpr std::size_t kAround = 64;
  constexpr Domes kDomes{.first = 0.35, .last = 0.35};

  const std::vector<CurveFrame> frames = framesAlong(centreline, kRings, {0, -1, 0});
  const auto size = [](double) { return SectionSize{kRadius_mm, 0.94 * kRadius_mm}; };
  const auto bump = [&kUneven](double share, double angle) {
    const double folds = kWaveHeight_mm * portableSinCos(2.0 * kPi * kWaves * share).cos;
    return fade(share) * folds + wavesAt(kUneven, share, angle);
  };
  TubeOrgan organ;
  const TriangleMesh surface =
      remeshed(closedTube(frames, kAround, kDomes, size, bump), [edge_mm](const Vec3&) { return edge_mm; });
  organ.texture = textureAlong(surface, frames);
  organ.surface = inMetres(surface);
  organ.fixedEnd_m = kMillimetre_m * frames.front().centre;
  organ.freeEnd_m = kMillimetre_m * frames.back().centre;
  organ.ridgeZero = frames.front().e1;
  organ.length_mm = frames.back().arc;
  constexpr double kAntimesenteric_deg = 270.0;  // of e1, which points to the front: the outside of the bend
  organ.places = placesOn(organ.surface, frames, kAntimesenteric_deg,
                          {{"first foot, antimesenteric border", 0.08, 0.0},
                           {"first foot, mesenteric border", 0.08, 180.0},
                           {"first limb, antimesenteric border", 0.28, 0.0},
                           {"first limb, mesenteric border", 0.28, 180.0},
                           {"top, antimesenteric border", 0.5, 0.0},
                           {"top, mesenteric border", 0.5, 180.0},
                           {"second limb, antimesenteric border", 0.72, 0.0},
                           {"second limb, mesenteric border", 0.72, 180.0},
                           {"second foot, antimesenteric border", 0.92, 0.0},
                           {"second foot, mesenteric border", 0.92, 180.0}});
  return organ;
}

}  // namespace

TubeOrgan makeIntestine(double edges) {
  constexpr double kEdge_mm = 1.4;
  return intestineOf(edges * kEdge_mm);
}

TubeOrgan makeFormerIntestine() {
  return intestineOf(2.4);
}

}  // namespace torsio
