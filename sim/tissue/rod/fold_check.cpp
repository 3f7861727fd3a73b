// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/rod/fold_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "sim/core/contracts.h"
#include "sim/core/short_number.h"

namespace torsio {

namespace {

constexpr std::array<double, 2> kDepths{0.5, 0.95};  // of the way from the axis to the surface
constexpr double kDifference_m = 1e-7;

double determinantAt(const Vec3& p, const std::function<Vec3(const Vec3&)>& map) {
  const auto column = [&](const Vec3& step) {
    return (map(p + step) - map(p - step)) / (2.0 * kDifference_m);
  };
  return dot(column({kDifference_m, 0, 0}),
             cross(column({0, kDifference_m, 0}), column({0, 0, kDifference_m})));
}

}  // namespace

FoldLimit FoldReport::passed(const FoldLimits& limits) const noexcept {
  if (!(minDeterminant >= limits.leastDeterminant)) {
    return FoldLimit::kDeterminant;
  }
  if (static_cast<double>(crossings) > limits.mostCrossings) {
    return FoldLimit::kCrossings;
  }
  return volumeRatio >= limits.leastVolume && volumeRatio <= limits.mostVolume ? FoldLimit::kNone
                                                                               : FoldLimit::kVolume;
}

Text FoldReport::reason(const FoldLimits& limits) const {
  switch (passed(limits)) {
    case FoldLimit::kDeterminant:
      return Text::tr("det F, the local volume ratio, falls to %1", shortNumber(minDeterminant));
    case FoldLimit::kCrossings:
      return Text::tr("the surface crosses itself in %1 {pair|pairs} of triangles",
                      std::to_string(crossings));
    case FoldLimit::kVolume:
      return Text::tr("the volume becomes %1 of what it was", shortNumber(volumeRatio));
    case FoldLimit::kNone:
      break;
  }
  return {};
}

FoldCheck::FoldCheck(const TriangleMesh& mesh, const SectionLattice& lattice)
    : rest_(mesh), volume_m3_(signedVolume_m3(mesh)), crossingsAtRest_(crossingTriangles(mesh)) {
  for (int j = 1; j + 1 < lattice.sections(); ++j) {
    const Vec3 centre = lattice.frameAt(lattice.sectionArc_m(j)).centre_m;
    inside_m_.push_back(centre);
    for (int ridge = 0; ridge < lattice.ridges(); ++ridge) {
      for (const double depth : kDepths) {
        inside_m_.push_back(centre + depth * (lattice.keyPoint_m(ridge, j) - centre));
      }
    }
  }
}

FoldReport FoldCheck::judge(std::span<const Vec3> vertices_m,
                            const std::function<Vec3(const Vec3&)>& toDeformed_m) const {
  TORSIO_EXPECTS(vertices_m.size() == rest_.vertices_m.size());
  TriangleMesh now;
  now.vertices_m.assign(vertices_m.begin(), vertices_m.end());
  now.triangles = rest_.triangles;
  FoldReport report;
  report.volumeRatio = signedVolume_m3(now) / volume_m3_;
  const std::vector<TrianglePair> crossings = crossingTriangles(now);
  std::vector<TrianglePair> fresh;
  std::set_difference(crossings.begin(), crossings.end(), crossingsAtRest_.begin(), crossingsAtRest_.end(),
                      std::back_inserter(fresh));
  report.crossings = fresh.size();
  for (const Vec3& p : inside_m_) {
    const double determinant = determinantAt(p, toDeformed_m);
    report.minDeterminant = std::min(report.minDeterminant, determinant);
    report.maxDeterminant = std::max(report.maxDeterminant, determinant);
  }
  return report;
}

}  // namespace torsio
