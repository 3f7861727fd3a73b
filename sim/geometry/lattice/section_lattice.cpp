// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/lattice/section_lattice.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/core/contracts.h"
#include "sim/core/error.h"
#include "sim/core/portable_math.h"
#include "sim/geometry/lattice/lattice_field.h"
#include "sim/geometry/lattice/side_branch.h"

namespace torsio {

namespace {

void checkCount(int value, int least, int most, const Text& what, const Text& why) {
  if (value >= least && value <= most) {
    return;
  }
  throw Error(ErrorCode::kBadParameter,
              why.empty() ? Text::tr("%1 %2 asked for; the lattice takes %3 to %4", value, what, least, most)
                          : Text::tr("%1 %2 asked for; the lattice takes %3 to %4 (%5)", value, what, least,
                                     most, why),
              what, Text::tr("Give a number between %1 and %2.", least, most));
}

void check(const LatticeOptions& options) {
  checkCount(options.ridges, kMinRidges, kMaxRidges, Text::tr("ridges"),
             Text::tr("two ridges cannot bound an area"));
  checkCount(options.sections, kMinSections, kMaxSections, Text::tr("sections"), "");
  if (!isFinite(options.ridgeZero)) {
    throw Error(ErrorCode::kBadParameter, Text::tr("the direction of ridge 0 is not finite"), "",
                Text::tr("Give three finite numbers."));
  }
  if (!(options.ridgeZeroFraction >= 0.0 && options.ridgeZeroFraction <= 1.0)) {
    throw Error(ErrorCode::kBadParameter,
                Text::tr("the place of the direction of ridge 0 is %1 of the length, it must lie in 0..1",
                         std::to_string(options.ridgeZeroFraction)),
                "", Text::tr("Give a fraction between 0 and 1."));
  }
}

/// Polar angle in the frame, [0, 2 pi).
double polarAngle_rad(const AxisFrame& frame, const Vec3& point_m) {
  const Point2 p = inFrame(frame, point_m);
  const double angle = portableAtan2(p[1], p[0]);
  return angle < 0.0 ? std::min(angle + 2.0 * kPi, std::nextafter(2.0 * kPi, 0.0)) : angle;
}

/// Coordinates of every vertex. `ends`: the outlines of the first and the last section.
std::vector<LatticeCoordinate> vertexCoordinatesOf(const LatticeField& field, const SectionOutline& fixedEnd,
                                                   const SectionOutline& freeEnd) {
  const Centreline& line = field.centreline;
  const AxisFrame frames[2] = {line.frameAt(0.0), line.frameAt(line.length_m())};
  std::vector<LatticeCoordinate> coordinates(field.mesh.vertices_m.size());
  for (std::size_t v = 0; v < coordinates.size(); ++v) {
    const Vec3& p = field.mesh.vertices_m[v];
    LatticeCoordinate& c = coordinates[v];
    if (field.parts[v] != LatticePart::kSide) {
      const bool free = field.parts[v] == LatticePart::kFreeCap;
      c.arc_m = free ? line.length_m() : 0.0;
      c.angle_rad = ridgeAngleTowards(free ? freeEnd : fixedEnd, inFrame(frames[free ? 1 : 0], p));
      continue;
    }
    const double level = field.harmonic.level[v];
    c.arc_m = field.arcAtLevel_m(level);
    c.angle_rad = field.rule.spacing == RidgeSpacing::kAngle
                      ? polarAngle_rad(line.frameAt(c.arc_m), p)
                      : field.ridgeAngle_rad(level, field.harmonic.angle_rad[v]);
  }
  return coordinates;
}

}  // namespace

SectionLattice::SectionLattice(const TriangleMesh& mesh, const LatticeOptions& options) : options_(options) {
  check(options);
  if (options.branchCut != Vec3{}) {
    trimmed_ = std::make_shared<const TrimmedOrgan>(mesh, options.branchRoot_m, options.branchCut);
  }
  LatticeField field = buildLatticeField(trimmed_ ? trimmed_->mesh() : mesh, options);
  centreline_ = field.centreline;

  const auto count = static_cast<std::size_t>(sections());
  std::vector<double> levels;
  levels.reserve(count);
  for (int j = 0; j < sections(); ++j) {
    levels.push_back(field.levelAtArc(sectionArc_m(j)));
  }
  levels.back() = 1.0;
  std::vector<LevelLoop> loops;
  loops.reserve(count);
  const LevelTracer tracer(field.mesh, field.topology, field.harmonic);
  tracer.traceAll(levels, [&](std::size_t j, std::vector<LevelLoop> found) {
    const int section = static_cast<int>(j);
    loops.push_back(
        theOneLoop(std::move(found), field.mode, sectionName(section, sections(), sectionArc_m(section))));
  });
  if (field.rule.spacing == RidgeSpacing::kAngle) {
    for (int j = 0; j < sections(); ++j) {
      if (isStarShaped(loops[static_cast<std::size_t>(j)], frameAt(sectionArc_m(j)))) {
        continue;
      }
      field.rule.spacing = RidgeSpacing::kArcLength;  // for the whole organ: ridges must not jump
      break;
    }
  }
  spacing_ = field.rule.spacing;

  std::vector<SectionOutline> outlines;
  outlines.reserve(count);
  for (int j = 0; j < sections(); ++j) {
    outlines.push_back(cutOutline(loops[static_cast<std::size_t>(j)], frameAt(sectionArc_m(j)), field.rule,
                                  ridges(), sectionName(j, sections(), sectionArc_m(j))));
  }
  coordinates_ = vertexCoordinatesOf(field, outlines.front(), outlines.back());
  parts_ = field.parts;
  if (trimmed_) {
    coordinates_ = trimmed_->toWhole(coordinates_);
    parts_ = trimmed_->toWhole(parts_);
  }
  for (SectionOutline& outline : outlines) {
    keyPoints_m_.insert(keyPoints_m_.end(), outline.ridges_m.begin(), outline.ridges_m.end());
    outlines_m_.push_back(std::move(outline.points_m));
    outlineAngles_.push_back(std::move(outline.angles_rad));
  }
  field_ = std::make_shared<const LatticeField>(std::move(field));
}

double SectionLattice::sectionArc_m(int j) const {
  TORSIO_EXPECTS(j >= 0 && j < sections());
  return length_m() * j / (sections() - 1);
}

Vec3 SectionLattice::keyPoint_m(int ridge, int j) const {
  TORSIO_EXPECTS(ridge >= 0 && ridge < ridges() && j >= 0 && j < sections());
  return keyPoints_m_[static_cast<std::size_t>(j) * static_cast<std::size_t>(ridges()) +
                      static_cast<std::size_t>(ridge)];
}

std::span<const Point2> SectionLattice::outline_m(int j) const {
  TORSIO_EXPECTS(j >= 0 && j < sections());
  return outlines_m_[static_cast<std::size_t>(j)];
}

std::span<const double> SectionLattice::outlineAngles_rad(int j) const {
  TORSIO_EXPECTS(j >= 0 && j < sections());
  return outlineAngles_[static_cast<std::size_t>(j)];
}

std::vector<LatticeOutline> SectionLattice::outlinesAt(std::span<const double> arcs_m) const {
  std::vector<double> levels;
  levels.reserve(arcs_m.size());
  for (const double arc : arcs_m) {
    TORSIO_EXPECTS(arc >= 0.0 && arc <= length_m());
    levels.push_back(arc < length_m() ? field_->levelAtArc(arc) : 1.0);
  }
  std::vector<LatticeOutline> outlines;
  outlines.reserve(arcs_m.size());
  const LevelTracer tracer(field_->mesh, field_->topology, field_->harmonic);
  tracer.traceAll(levels, [&](std::size_t k, std::vector<LevelLoop> found) {
    const std::string name = placeName(arcs_m[k]);
    SectionOutline outline = cutOutline(organLoop(std::move(found), field_->mode, name), frameAt(arcs_m[k]),
                                        field_->rule, ridges(), name);
    outlines.push_back({std::move(outline.points_m), std::move(outline.angles_rad)});
  });
  return outlines;
}

LatticePoint SectionLattice::surfacePoint(const LatticeCoordinate& coordinate) const {
  TORSIO_EXPECTS(std::isfinite(coordinate.arc_m) && std::isfinite(coordinate.angle_rad));
  const double arc = std::clamp(coordinate.arc_m, 0.0, length_m());
  const LevelLoop loop = field_->loopAt(arc, "the section of the asked-for point");
  const LatticePoint point =
      pointOnLoop(loop, frameAt(arc), field_->rule, coordinate.angle_rad, field_->mesh);
  return trimmed_ ? trimmed_->toWhole(point) : point;
}

}  // namespace torsio
