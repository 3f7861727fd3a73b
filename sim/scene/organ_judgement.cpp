// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/organ_judgement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "sim/core/contracts.h"
#include "sim/core/portable_math.h"
#include "sim/core/short_number.h"
#include "sim/geometry/mesh/mesh_crossings.h"
#include "sim/geometry/mesh/mesh_thinning.h"

namespace torsio {

namespace {

constexpr double kNeverRefused = std::numeric_limits<double>::infinity();

/// Area and the two second moments of an outline about its centroid.
struct OutlineMoments {
  double area = 0.0;
  double aspect = 1.0;  ///< long over short side of the rectangle with the same second moments
};

OutlineMoments momentsOf(std::span<const Point2> outline) {
  double area = 0.0;
  double cx = 0.0;
  double cy = 0.0;
  double xx = 0.0;
  double yy = 0.0;
  double xy = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto [x0, y0] = outline[i];
    const auto [x1, y1] = outline[(i + 1) % outline.size()];
    const double twice = x0 * y1 - x1 * y0;
    area += twice / 2.0;
    cx += (x0 + x1) * twice / 6.0;
    cy += (y0 + y1) * twice / 6.0;
    xx += (x0 * x0 + x0 * x1 + x1 * x1) * twice / 12.0;
    yy += (y0 * y0 + y0 * y1 + y1 * y1) * twice / 12.0;
    xy += (x0 * y1 + 2.0 * x0 * y0 + 2.0 * x1 * y1 + x1 * y0) * twice / 24.0;
  }
  OutlineMoments moments;
  moments.area = area;
  if (!(area > 0.0)) {
    return moments;
  }
  xx -= cx * cx / area;
  yy -= cy * cy / area;
  xy -= cx * cy / area;
  const double middle = 0.5 * (xx + yy);
  const double apart = std::sqrt(0.25 * (xx - yy) * (xx - yy) + xy * xy);
  moments.aspect = std::sqrt((middle + apart) / std::max(middle - apart, 1e-12 * middle));
  return moments;
}

double meanWidth_m(double area_m2) {
  return 2.0 * std::sqrt(std::max(area_m2, 0.0) / kPi);
}

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void measureSections(const SectionLattice& lattice, double wrung, OrganMeasures& measures) {
  std::vector<double> aspects;
  std::vector<double> widths_m;
  double narrowest_m = 0.0;
  double widestInside_m = 0.0;
  double widestBeyond_m = 0.0;
  for (int j = 0; j < lattice.sections(); ++j) {
    const OutlineMoments moments = momentsOf(lattice.outline_m(j));
    const double width_m = meanWidth_m(moments.area);
    const double place = lattice.sectionArc_m(j) / lattice.length_m();
    const double share = place / wrung;
    if (share > 1.0) {
      widestBeyond_m = std::max(widestBeyond_m, width_m);
      continue;
    }
    // A stalk goes over into what it carries: its last tenth is none of its width.
    if (wrung == 1.0 || share <= 0.9) {
      measures.widest_m = std::max(measures.widest_m, width_m);
    }
    if (share < 0.1 || share > 0.9) {
      continue;
    }
    widths_m.push_back(width_m);
    aspects.push_back(moments.aspect);
    if (narrowest_m == 0.0 || width_m < narrowest_m) {
      narrowest_m = width_m;
      measures.narrowestAt = place;
    }
    if (width_m > widestInside_m) {
      widestInside_m = width_m;
      measures.widestAt = place;
    }
  }
  measures.elongation = measures.widest_m > 0.0 ? wrung * measures.length_m / measures.widest_m : 0.0;
  measures.widthRatio = narrowest_m > 0.0 ? widestInside_m / narrowest_m : 1.0;
  measures.flatness = aspects.empty() ? measures.flatness : median(aspects);
  if (wrung < 1.0 && !widths_m.empty() && widestBeyond_m > 0.0) {
    measures.stalkWidth = median(widths_m) / widestBeyond_m;
  }
}

/// How far a place fixed in the section moves along the axis as the section does, as a share: below 0 where
/// neighbouring sections run into each other, inside of a bend sharper than the organ is wide.
void measureOverlap(const SectionLattice& lattice, double wrung, OrganMeasures& measures) {
  const double step_m = lattice.length_m() / 400.0;
  std::size_t places = 0;
  std::size_t overlapping = 0;
  for (int j = 1; j + 1 < lattice.sections(); ++j) {
    const double arc_m = lattice.sectionArc_m(j);
    if (arc_m > wrung * lattice.length_m()) {
      break;
    }
    const AxisFrame before = lattice.frameAt(arc_m - step_m);
    const AxisFrame here = lattice.frameAt(arc_m);
    const AxisFrame behind = lattice.frameAt(arc_m + step_m);
    const double way_m = dot(behind.centre_m - before.centre_m, here.tangent);
    for (const auto& [x, y] : lattice.outline_m(j)) {
      const Vec3 turn = x * (behind.e1 - before.e1) + y * (behind.e2 - before.e2);
      ++places;
      overlapping += way_m + dot(turn, here.tangent) <= 0.0 ? 1U : 0U;
    }
  }
  measures.overlap = places > 0 ? static_cast<double>(overlapping) / static_cast<double>(places) : 0.0;
}

/// Radius of the round section of the same area at an arc length.
class MeanRadius {
 public:
  explicit MeanRadius(const SectionLattice& lattice) : length_m_(lattice.length_m()) {
    for (int j = 0; j < lattice.sections(); ++j) {
      radii_m_.push_back(0.5 * meanWidth_m(momentsOf(lattice.outline_m(j)).area));
    }
  }
  [[nodiscard]] double at_m(double arc_m) const {
    const double place = arc_m / length_m_ * static_cast<double>(radii_m_.size() - 1);
    const auto low = std::min(static_cast<std::size_t>(std::max(place, 0.0)), radii_m_.size() - 2);
    const double share = std::clamp(place - static_cast<double>(low), 0.0, 1.0);
    return (1.0 - share) * radii_m_[low] + share * radii_m_[low + 1];
  }

 private:
  double length_m_ = 0.0;
  std::vector<double> radii_m_;
};

/// Tells whether a point of an end stands off the end section, as a branch does; the flat or rounded end
/// itself does not, nor what lies beyond a cut that was asked for.
bool isBeyond(const SectionLattice& lattice, LatticePart part, const Vec3& p, double width_m) {
  constexpr double kOfWidth = 0.25;
  const bool fixed = part == LatticePart::kFixedCap;
  if ((fixed ? lattice.options().fixedCut : lattice.options().freeCut) != Vec3{}) {
    return false;
  }
  const AxisFrame end = lattice.frameAt(fixed ? 0.0 : lattice.length_m());
  return std::abs(dot(p - end.centre_m, end.tangent)) > kOfWidth * width_m;
}

/// A branch hangs on one section: its surface stands off the plane of that section.
/// What a stalk carries turns as a whole, whatever its shape.
void measureBranches(const TriangleMesh& mesh, const SectionLattice& lattice, double wrung,
                     OrganMeasures& measures) {
  const MeanRadius radius(lattice);
  double whole_m2 = 0.0;
  double branch_m2 = 0.0;
  double beyond_m2 = 0.0;
  double caps_m2 = 0.0;
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    const std::uint32_t v = t[0];
    const Vec3& p = mesh.vertices_m[v];
    const double area_m2 = 0.5 * norm(cross(mesh.vertices_m[t[1]] - p, mesh.vertices_m[t[2]] - p));
    whole_m2 += area_m2;
    const LatticePart part = lattice.vertexParts()[v];
    if (wrung < 1.0 && (part == LatticePart::kFreeCap ||
                        lattice.vertexCoordinates()[v].arc_m > wrung * lattice.length_m())) {
      continue;
    }
    if (part != LatticePart::kSide) {
      caps_m2 += area_m2;
      beyond_m2 += isBeyond(lattice, part, p, measures.widest_m) ? area_m2 : 0.0;
      continue;
    }
    const double arc_m = lattice.vertexCoordinates()[v].arc_m;
    const AxisFrame frame = lattice.frameAt(arc_m);
    if (std::abs(dot(p - frame.centre_m, frame.tangent)) > radius.at_m(arc_m)) {
      branch_m2 += area_m2;
    }
  }
  measures.branch = branch_m2 / whole_m2;
  measures.beyond = beyond_m2 / whole_m2;
  measures.caps = caps_m2 / whole_m2;
}

/// Where all of the organ is meant.
Text wholeOrgan() {
  return Text::tr("the whole organ");
}

Text percent(double share) {
  return Text::verbatim("%1 %", shortNumber(100.0 * share));
}

class Findings {
 public:
  explicit Findings(std::vector<OrganFinding>& findings) : findings_(findings) {}
  /// Adds a finding where the value passes the limit of a warning or of a refusal.
  void atLeast(double value, double refused, double warned, OrganFinding finding) {
    add(value, !(value >= refused), !(value >= warned), std::move(finding));
  }
  void atMost(double value, double refused, double warned, OrganFinding finding) {
    add(value, !(value <= refused), !(value <= warned), std::move(finding));
  }

 private:
  void add(double value, bool refused, bool warned, OrganFinding finding) {
    if (!refused && !warned) {
      return;
    }
    finding.value = value;
    finding.weight = refused ? FindingWeight::kRefusal : FindingWeight::kWarning;
    findings_.push_back(std::move(finding));
  }
  std::vector<OrganFinding>& findings_;
};

OrganFinding finding(const char* code, Text what, Text remedy) {
  return {code, FindingWeight::kWarning, std::move(what), wholeOrgan(), std::nullopt, std::move(remedy)};
}

Text askForEnds() {
  return Text::tr("Name the ends of the organ, or cut off what is not part of it");
}

OrganFinding tooShort(const OrganMeasures& m, const OrganLimits& limits, double wrung) {
  if (wrung < 1.0) {
    return finding("M20",
                   Text::tr("the stalk, the part that is wrung, is %1 times as long as wide; a twist needs "
                            "a length of at least %2",
                            shortNumber(m.elongation), shortNumber(limits.usualElongation)),
                   Text::tr("Name the ends of the organ: the root of its stalk is the held one"));
  }
  return finding("M20",
                 Text::tr("the organ is %1 times as long as wide; a twist needs a length of at least %2",
                          shortNumber(m.elongation), shortNumber(limits.usualElongation)),
                 Text::tr("Choose an organ that is longer than wide, or name its ends"));
}

void judgeShape(const OrganMeasures& m, const OrganLimits& limits, double wrung, Findings& findings) {
  findings.atLeast(m.elongation, limits.leastElongation, limits.usualElongation, tooShort(m, limits, wrung));
  findings.atMost(
      m.stalkWidth, limits.mostStalkWidth, limits.mostStalkWidth,
      finding("M20",
              Text::tr("the organ has no stalk: the part that is twisted is %1 times as wide as the rest",
                       shortNumber(m.stalkWidth)),
              Text::tr("Name the ends of the organ: the root of its stalk is the held one")));
  findings.atMost(
      m.branch, limits.mostBranch, limits.usualBranch,
      finding("M20",
              Text::tr("the organ branches: %1 of its surface stands off its section", percent(m.branch)),
              askForEnds()));
  findings.atMost(m.beyond, limits.mostBeyond, limits.usualBeyond,
                  finding("M20",
                          Text::tr("the organ branches: %1 of its surface lies beyond the ends of its axis",
                                   percent(m.beyond)),
                          askForEnds()));
  findings.atMost(m.flatness, limits.mostFlatness, limits.usualFlatness,
                  finding("M18",
                          Text::tr("the organ is flat: its sections are %1 times as broad as thick",
                                   shortNumber(m.flatness)),
                          Text::tr("Choose an organ with rounder sections")));
  findings.atMost(
      m.overlap, kNeverRefused, limits.usualOverlap,
      finding("M22",
              Text::tr("sections run into each other in %1 of the organ: it bends more sharply than it "
                       "is wide",
                       percent(m.overlap)),
              Text::tr("Name the ends of the organ, or take a part of it that bends less")));
  findings.atMost(
      m.widthRatio, kNeverRefused, limits.usualWidthRatio,
      finding("M25",
              Text::tr("the organ is %1 times as wide in one place as in another: all of the twist goes "
                       "into the narrow part",
                       shortNumber(m.widthRatio)),
              Text::tr("Take one part of it, or name the ends of that part")));
}

void judgeSurface(const OrganMeasures& m, std::size_t triangles, const OrganLimits& limits,
                  Findings& findings) {
  findings.atMost(static_cast<double>(m.crossingsAtRest) / static_cast<double>(triangles),
                  limits.mostCrossingShare, 0.0,
                  finding("M17",
                          Text::tr("the surface crosses itself in %1 {pair|pairs} of triangles",
                                   std::to_string(m.crossingsAtRest)),
                          Text::tr("Repair the surface in a mesh editor")));
}

}  // namespace

OrganJudgement judgeOrgan(const TriangleMesh& whole, const LatticeOptions& options, double wrung,
                          const OrganLimits& limits) {
  TORSIO_EXPECTS(wrung > 0.0 && wrung <= 1.0);
  OrganJudgement judgement;
  OrganMeasures& measures = judgement.measures;
  try {
    const bool large = whole.triangles.size() > kJudgedTriangles;
    const TriangleMesh fewer = large ? thinned(whole, kJudgedTriangles) : TriangleMesh{};
    const TriangleMesh& mesh = large ? fewer : whole;
    const SectionLattice lattice(mesh, options);
    measures.length_m = lattice.length_m();
    measureSections(lattice, wrung, measures);
    measureOverlap(lattice, wrung, measures);
    measureBranches(mesh, lattice, wrung, measures);
    measures.crossingsAtRest = crossingTriangles(whole).size();
  } catch (const Error& refusal) {
    OrganFinding none = findingOf(refusal);
    none.code = none.code == "M00" ? "M20" : none.code;
    none.where = none.where.empty() ? wholeOrgan() : none.where;
    judgement.findings.push_back(std::move(none));
    return judgement;
  }
  Findings findings(judgement.findings);
  judgeShape(measures, limits, wrung, findings);
  judgeSurface(measures, whole.triangles.size(), limits, findings);
  std::stable_sort(judgement.findings.begin(), judgement.findings.end(),
                   [](const OrganFinding& a, const OrganFinding& b) { return a.code < b.code; });
  return judgement;
}

}  // namespace torsio
