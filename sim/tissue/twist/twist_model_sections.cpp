// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/twist/twist_model_sections.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "sim/core/angle.h"
#include "sim/core/contracts.h"
#include "sim/core/error.h"
#include "sim/core/index.h"
#include "sim/core/portable_math.h"
#include "sim/tissue/twist/twist_model.h"

namespace torsio {

namespace {

std::vector<double> equalArcs(double length_m, int count) {
  std::vector<double> arcs;
  arcs.reserve(at(count));
  for (int k = 0; k < count; ++k) {
    arcs.push_back(std::min(length_m, length_m * k / (count - 1)));
  }
  return arcs;
}

// Turning about (x0, y0) instead of the centroid adds a tilt of the section to psi; the stress stays the
// same.
double tilt(const Point2& point, const std::array<double, 2>& centroid, const std::array<double, 2>& centre) {
  return (centre[0] - centroid[0]) * (point[1] - centroid[1]) -
         (centre[1] - centroid[1]) * (point[0] - centroid[0]);
}

double areaOf(std::span<const Point2> points) {
  double twice = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point2& a = points[i];
    const Point2& b = points[i + 1 < points.size() ? i + 1 : 0];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return 0.5 * twice;
}

// Fewer points at equal ridge angles, blown up to the old area: J goes with the square of the area, so that
// what the chords cut off is made good.
LatticeOutline drawnAgain(const LatticeOutline& full, int count) {
  std::vector<double> x;
  std::vector<double> y;
  for (const Point2& p : full.points_m) {
    x.push_back(p[0]), y.push_back(p[1]);
  }
  const std::vector<double> evenX = onEqualAngles(full.angles_rad, x, count);
  const std::vector<double> evenY = onEqualAngles(full.angles_rad, y, count);
  LatticeOutline outline;
  for (int a = 0; a < count; ++a) {
    const std::size_t i = static_cast<std::size_t>(a);
    outline.points_m.push_back({evenX[i], evenY[i]});
    outline.angles_rad.push_back(kTurn * a / count);
  }
  const double area = areaOf(outline.points_m);
  const double factor = area > 0.0 ? std::sqrt(areaOf(full.points_m) / area) : 1.0;
  for (Point2& p : outline.points_m) {
    p = {factor * p[0], factor * p[1]};
  }
  return outline;
}

SectionProperties solvedOutline(SectionSolver& solver, LatticeOutline& outline, int points, double arc_m) {
  if (outline.points_m.size() > static_cast<std::size_t>(points)) {
    try {
      LatticeOutline fewer = drawnAgain(outline, points);
      SectionProperties properties = solver.solve(fewer.points_m);
      outline = std::move(fewer);
      return properties;
    } catch (const Error&) {  // fewer points may cross where the full outline does not
    }
  }
  try {
    return solver.solve(outline.points_m);
  } catch (const Error& error) {
    throw Error(error.code(), error.happened(),
                Text::tr("the section %1 mm from the fixed end", std::to_string(1000.0 * arc_m)),
                error.remedy());
  }
}

SolvedSection solved(SectionSolver& solver, LatticeOutline outline, double arc_m,
                     const SolvedSections::Options& options) {
  const SectionProperties p = solvedOutline(solver, outline, options.points, arc_m);
  SolvedSection section;
  section.torsion = {p.torsionConstant, p.polarMoment, p.area};
  section.sag_m2 = p.sag;
  section.maxShear_m = p.maxShear;
  section.shearCentre_m = p.shearCentre;
  const std::array<double, 2> centre =
      options.aboutShearCentre ? p.shearCentre : std::array<double, 2>{0.0, 0.0};
  std::vector<double> warping = p.outlineWarping;
  for (std::size_t i = 0; i < warping.size(); ++i) {
    warping[i] += tilt(outline.points_m[i], p.centroid, centre);
  }
  section.warping_m2 = onEqualAngles(outline.angles_rad, warping, SolvedSections::kAngles);
  section.shear_m = onEqualAngles(outline.angles_rad, p.outlineShear, SolvedSections::kAngles);
  return section;
}

std::vector<TorsionSection> torsionOf(std::span<const SolvedSection> sections) {
  std::vector<TorsionSection> torsion;
  for (const SolvedSection& s : sections) {
    torsion.push_back(s.torsion);
  }
  return torsion;
}

}  // namespace

std::vector<double> onEqualAngles(std::span<const double> angles_rad, std::span<const double> values,
                                  int count) {
  TORSIO_EXPECTS(!angles_rad.empty() && angles_rad.size() == values.size());
  const std::size_t n = angles_rad.size();
  std::vector<double> result;
  std::size_t next = 0;  // first outline point beyond the wanted angle
  for (int k = 0; k < count; ++k) {
    const double angle = kTurn * k / count;
    while (next < n && angles_rad[next] <= angle) {
      ++next;
    }
    const std::size_t low = next == 0 ? n - 1 : next - 1;
    const std::size_t high = next == n ? 0 : next;
    const double from = next == 0 ? angles_rad[low] - kTurn : angles_rad[low];
    const double to = next == n ? angles_rad[high] + kTurn : angles_rad[high];
    const double t = to > from ? (angle - from) / (to - from) : 0.0;
    result.push_back(values[low] + t * (values[high] - values[low]));
  }
  return result;
}

double atAngle(std::span<const double> table, double angle_rad) noexcept {
  const double n = static_cast<double>(table.size());
  double place = angle_rad * n / kTurn;
  place -= n * std::floor(place / n);
  const std::size_t low = std::min(static_cast<std::size_t>(place), table.size() - 1);
  const std::size_t high = low + 1 < table.size() ? low + 1 : 0;
  return table[low] + (place - static_cast<double>(low)) * (table[high] - table[low]);
}

SolvedSections SolvedSections::solve(const SectionLattice& lattice, const Options& options) {
  const std::vector<double> arcs = equalArcs(lattice.length_m(), options.sections);
  std::vector<LatticeOutline> outlines = lattice.outlinesAt(arcs);
  SectionSolver solver(options.solver);
  std::vector<SolvedSection> sections;
  sections.reserve(arcs.size());
  for (std::size_t k = 0; k < arcs.size(); ++k) {
    sections.push_back(solved(solver, std::move(outlines[k]), arcs[k], options));
  }
  return {arcs, std::move(sections), options.kriging};
}

SolvedSections::SolvedSections(std::vector<double> arcs_m, std::vector<SolvedSection> sections,
                               const KrigingOptions& kriging)
    : arcs_m_(std::move(arcs_m)),
      sections_(std::move(sections)),
      profile_(arcs_m_, torsionOf(sections_), kriging),
      kriging_(arcs_m_, kriging) {
  for (const SolvedSection& s : sections_) {
    const double area = std::sqrt(s.torsion.torsionConstant_m4);
    const double length = std::sqrt(area);
    sagLength_.push_back(std::sqrt(s.sag_m2));
    shear_.push_back(s.maxShear_m);
    centreX_.push_back(s.shearCentre_m[0]);
    centreY_.push_back(s.shearCentre_m[1]);
    std::vector<double> warping = s.warping_m2;
    for (double& w : warping) {
      w /= area;
    }
    warpingShare_.push_back(std::move(warping));
    std::vector<double> shear = s.shear_m;
    for (double& t : shear) {
      t /= length;
    }
    shearShare_.push_back(std::move(shear));
  }
}

double SolvedSections::sag_m2(double arc_m) const {
  const double least = 0.5 * *std::min_element(sagLength_.begin(), sagLength_.end());
  const double length = std::max(kriging_.estimate(arc_m, sagLength_), least);
  return length * length;
}

double SolvedSections::maxShear_m(double arc_m) const {
  return std::max(0.0, kriging_.estimate(arc_m, shear_));
}

std::array<double, 2> SolvedSections::shearCentre_m(double arc_m) const {
  return {kriging_.estimate(arc_m, centreX_), kriging_.estimate(arc_m, centreY_)};
}

std::vector<double> SolvedSections::krigedRow(double arc_m, double scale,
                                              std::span<const std::vector<double>> rows) const {
  const KrigingWeights weights = kriging_.weights(arc_m);
  std::vector<double> row(static_cast<std::size_t>(kAngles), 0.0);
  for (std::size_t n = 0; n < weights.lambda.size(); ++n) {
    const std::vector<double>& from = rows[static_cast<std::size_t>(weights.first) + n];
    for (std::size_t a = 0; a < row.size(); ++a) {
      row[a] += scale * weights.lambda[n] * from[a];
    }
  }
  return row;
}

std::vector<double> SolvedSections::warping_m2(double arc_m) const {
  return krigedRow(arc_m, std::sqrt(profile_.at(arc_m).torsionConstant_m4), warpingShare_);
}

std::vector<double> SolvedSections::shear_m(double arc_m) const {
  std::vector<double> row =
      krigedRow(arc_m, std::sqrt(std::sqrt(profile_.at(arc_m).torsionConstant_m4)), shearShare_);
  for (double& t : row) {
    t = std::max(0.0, t);
  }
  return row;
}

SolvedSections solvedSections(const SectionLattice& lattice, const TwistModelOptions& options) {
  return SolvedSections::solve(lattice, {.sections = options.solvedSections,
                                         .points = options.sectionPoints,
                                         .aboutShearCentre = options.centre == TwistCentre::kShearCentre,
                                         .solver = options.sectionSolver,
                                         .kriging = options.kriging});
}

}  // namespace torsio
