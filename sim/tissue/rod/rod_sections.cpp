// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/rod/rod_sections.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/index.h"
#include "sim/core/short_number.h"
#include "sim/tissue/rod/rod_warping.h"
#include "sim/tissue/twist/held_warping.h"
#include "sim/tissue/twist/section_fields.h"
#include "sim/tissue/twist/twist_model.h"

namespace torsio {

namespace {

constexpr double kShearFactor = 0.9;  // of a circle; 0.85 changes the torque of a bent tube by 0.2 %
constexpr double kOvalRamp = 1.4;     // of R sqrt(R / t): so near to a held end a wall is kept round
constexpr double kLeastRestFibre =
    0.25;                             // j0: a section that reaches the centre of its bend is cut off there
constexpr double kMaxCoupling = 0.5;  // of the energy that shear and twist may exchange through a bend
constexpr double kBendStiffness = 200.0;  // k_b of the bend limit, assumed
constexpr double kLeastBendLimit = 0.40;  // z0
constexpr double kAboveRest = 0.02;       // z0 over z at rest
constexpr double kTipSlope = 1.0;         // |dr/ds| from which on an end is a tip
constexpr double kLongestTip = 0.25;      // of the length
constexpr double kSmoothedEnd = 0.04;  // of the length: so near to an end the smoothed axis has lost its bend
constexpr double kMaxOnward = 0.5;     // cosine to the centreline: an end that bends more has a hook, no bend
constexpr double kArcShare = 2.0 / 3.0;  // of a step along the rod; the rest counts compliance
constexpr int kDivisionPlaces = 1001;
constexpr int kHalvings = 60;
constexpr int kTipSteps = 200;  // of the length

// Gauss-Legendre on [0, 1]: four points along an element, six from the axis to the outline, three on an edge.
constexpr std::array<double, 4> kArcPoints{0.069431844202973712, 0.33000947820757187, 0.66999052179242813,
                                           0.93056815579702629};
constexpr std::array<double, 4> kArcWeights{0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                                            0.17392742256872693};

// Stiffness or compliance of a section: stretch 1-3, curvature 1-3; symmetric, row after row.
using Matrix6 = std::array<double, 36>;

// Inverse of a symmetric positive definite matrix by Gauss-Jordan, no pivoting needed. Same bits everywhere.
Matrix6 inverse(Matrix6 a) {
  for (std::size_t k = 0; k < 6; ++k) {
    const double pivot = 1.0 / a[7 * k];
    for (std::size_t j = 0; j < 6; ++j) {
      a[6 * k + j] *= j == k ? 0.0 : pivot;
    }
    a[7 * k] = pivot;
    for (std::size_t i = 0; i < 6; ++i) {
      if (i == k) {
        continue;
      }
      const double factor = a[6 * i + k];
      a[6 * i + k] = 0.0;
      for (std::size_t j = 0; j < 6; ++j) {
        a[6 * i + j] -= factor * a[6 * k + j];
      }
    }
  }
  return a;
}

Matrix6 stiffnessOf(const RodElement& e) {
  Matrix6 k{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      k[6 * i + j] = e.stretch_N[3 * i + j];
      k[6 * i + j + 3] = e.coupling_Nm[3 * i + j];
      k[6 * (j + 3) + i] = e.coupling_Nm[3 * i + j];
      k[6 * (i + 3) + j + 3] = e.bend_Nm2[3 * i + j];
    }
  }
  return k;
}

void setStiffness(RodElement& e, const Matrix6& k) {
  const auto mean = [&k](std::size_t i, std::size_t j) { return 0.5 * (k[6 * i + j] + k[6 * j + i]); };
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      e.stretch_N[3 * i + j] = mean(i, j);
      e.coupling_Nm[3 * i + j] = mean(i, j + 3);
      e.bend_Nm2[3 * i + j] = mean(i + 3, j + 3);
    }
  }
  e.axial_N = e.stretch_N[8];  // the axial law is neo-Hookean: l - 1 / l^2 in place of 3 (l - 1)
  e.stretch_N[8] = 0.0;
}

Quat quatOfFrame(const AxisFrame& f) {
  // Shepperd's method: the largest of the four squares decides which root is taken.
  const double m[3][3] = {
      {f.e1.x, f.e2.x, f.tangent.x}, {f.e1.y, f.e2.y, f.tangent.y}, {f.e1.z, f.e2.z, f.tangent.z}};
  const double trace = m[0][0] + m[1][1] + m[2][2];
  Quat q;
  if (trace >= m[0][0] && trace >= m[1][1] && trace >= m[2][2]) {
    q = {1.0 + trace, m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]};
  } else if (m[0][0] >= m[1][1] && m[0][0] >= m[2][2]) {
    q = {m[2][1] - m[1][2], 1.0 + 2.0 * m[0][0] - trace, m[0][1] + m[1][0], m[0][2] + m[2][0]};
  } else if (m[1][1] >= m[2][2]) {
    q = {m[0][2] - m[2][0], m[0][1] + m[1][0], 1.0 + 2.0 * m[1][1] - trace, m[1][2] + m[2][1]};
  } else {
    q = {m[1][0] - m[0][1], m[0][2] + m[2][0], m[1][2] + m[2][1], 1.0 + 2.0 * m[2][2] - trace};
  }
  return normalized(q);
}

void checkMaterial(const RodMaterial& material, int elements) {
  requireShearModulus(material.shearModulus_Pa, Text::tr("material"));
  if (!(material.poisson >= 0.0 && material.poisson <= 0.5)) {
    refuseParameter(
        Text::tr("Poisson's ratio is %1, but must lie in 0..0.5", std::to_string(material.poisson)),
        Text::tr("material"), Text::tr("Give 0.5 for incompressible tissue."));
  }
  if (elements < 2 || elements >= kMaxRodNodes) {
    refuseParameter(
        Text::tr("%1 {element|elements} asked for; a rod takes 2 to %2", elements, kMaxRodNodes - 1),
        Text::tr("rod"), Text::tr("Choose a number inside the range."));
  }
}

// One section of the organ.
struct SectionPart {
  RodElement stiffness;               // as of a short element there, axial law linear
  std::array<double, 3> second_m2{};  // mean of x x, x y, y y over the section, about its centroid
  double axial_N = 0.0;               // E A
};

// Builder: one section after another becomes stiffness, and the sections of an element its mean compliance.
class RodMaker {
 public:
  RodMaker(const SectionLattice& lattice, const SolvedSections& sections, const RodMaterial& material,
           const RodDivision& division)
      : lattice_(lattice),
        sections_(sections),
        shear_Pa_(material.shearModulus_Pa),
        poisson_(material.poisson),
        young_Pa_(2.0 * material.shearModulus_Pa * (1.0 + material.poisson)),
        wall_(material.wall),
        corrections_(material.corrections),
        ends_(material.ends),
        division_(division),
        count_(division.elements) {}

  OrganRod make() {
    divide(endOfTip(1.0), lattice_.length_m() - endOfTip(-1.0));
    placeNodes();
    if (corrections_.restrainedEnds && wall_.empty()) {
      warping_.emplace(lattice_, sections_, rod_.arcs_m.front(), rod_.arcs_m.back(), young_Pa_ / shear_Pa_,
                       ends_);
    }
    std::vector<double> arcs;
    for (int i = 0; i < count_; ++i) {
      for (const double share : kArcPoints) {
        arcs.push_back(rod_.arcs_m[at(i)] + share * length(i));
      }
    }
    const std::vector<LatticeOutline> outlines = lattice_.outlinesAt(arcs);
    for (int i = 0; i < count_; ++i) {
      const std::size_t first = kArcPoints.size() * at(i);
      rod_.elements.push_back(element(i, std::span(arcs).subspan(first, kArcPoints.size()),
                                      std::span(outlines).subspan(first, kArcPoints.size())));
    }
    return std::move(rod_);
  }

 private:
  [[nodiscard]] double length(int i) const { return rod_.arcs_m[at(i + 1)] - rod_.arcs_m[at(i)]; }

  // Equal steps of kArcShare of the length and the rest of the compliance: a thin end, which takes most of a
  // twist, gets shorter elements, because an element turns by less than half a turn.
  void divide(double first_m, double last_m) {
    const std::vector<double> compliances =
        sectionCompliances(sections_.profile(), kDivisionPlaces, lattice_.length_m(), shear_Pa_);
    const HermiteTable compliance(0.0, lattice_.length_m() / (kDivisionPlaces - 1), compliances, true);
    const double from = compliance.value(first_m);
    const double rise = compliance.value(last_m) - from;
    const auto progress = [&](double arc_m) {
      return kArcShare * (arc_m - first_m) / (last_m - first_m) +
             (1.0 - kArcShare) * (compliance.value(arc_m) - from) / rise;
    };
    double node = 0.0;
    int before = 0;
    if (division_.node_m > first_m && division_.node_m < last_m) {
      node = progress(division_.node_m);
      before = std::clamp(static_cast<int>(std::lround(node * count_)), 1, count_ - 1);
    }
    for (int i = 0; i <= count_; ++i) {
      const double wanted =
          i < before ? node * i / before : node + (1.0 - node) * (i - before) / (count_ - before);
      double low = first_m;
      double high = last_m;
      for (int halving = 0; halving < kHalvings; ++halving) {
        const double middle = 0.5 * (low + high);
        (progress(middle) < wanted ? low : high) = middle;
      }
      rod_.arcs_m.push_back(0.5 * (low + high));
    }
    rod_.arcs_m.front() = first_m;
    rod_.arcs_m.back() = last_m;
    if (before > 0) {
      rod_.arcs_m[at(before)] = division_.node_m;
    }
  }

  // Way from an end to where the organ is a tube: `direction` 1 from the fixed end, -1 from the free one.
  [[nodiscard]] double endOfTip(double direction) const {
    const double step = lattice_.length_m() / kTipSteps;
    const double start = direction > 0.0 ? 0.0 : lattice_.length_m();
    for (double way = 0.0; way < kLongestTip * lattice_.length_m(); way += step) {
      const double here = sections_.profile().radius_m(start + direction * way);
      if (sections_.profile().radius_m(start + direction * (way + step)) - here <= kTipSlope * step) {
        return way;
      }
    }
    return 0.0;
  }

  void placeNodes() {
    rod_.rest.count = count_ + 1;
    for (int i = 0; i <= count_; ++i) {
      const AxisFrame frame = frameAt(rod_.arcs_m[at(i)]);
      rod_.rest.nodes[at(i)] = {frame.centre_m, quatOfFrame(frame)};
      rod_.radii_m.push_back(sections_.profile().radius_m(rod_.arcs_m[at(i)]));
    }
  }

  // Near its ends the centreline keeps the end points but not the bend: there the tangent goes on turning as
  // it does just inside.
  [[nodiscard]] AxisFrame frameAt(double arc_m) const {
    AxisFrame frame = lattice_.frameAt(arc_m);
    const double margin = kSmoothedEnd * lattice_.length_m();
    const double end = arc_m < margin ? margin : lattice_.length_m() - margin;
    if (arc_m >= margin && arc_m <= end) {
      return frame;
    }
    const Vec3 pivot = lattice_.frameAt(end).tangent;
    const Vec3 inside = lattice_.frameAt(2.0 * end - arc_m).tangent;
    const Vec3 onward = normalized(2.0 * dot(pivot, inside) * pivot - inside);
    if (dot(onward, frame.tangent) < kMaxOnward) {
      return frame;
    }
    frame.tangent = onward;
    frame.e1 = normalized(frame.e1 - dot(frame.e1, frame.tangent) * frame.tangent);
    frame.e2 = cross(frame.tangent, frame.e1);
    return frame;
  }

  [[nodiscard]] SectionPart section(double arc_m, std::span<const Point2> outline,
                                    const std::array<double, 3>& bend) const {
    const double wall_m = wall_.thickness_m(arc_m / lattice_.length_m());
    const std::vector<Point2> inner = wall_.empty() ? std::vector<Point2>{} : innerOutline(outline, wall_m);
    const SectionMoments plain = less(momentsOf(outline, 0.0, 0.0), momentsOf(inner, 0.0, 0.0));
    const SectionMoments m = less(momentsOf(outline, bend[0], bend[1]), momentsOf(inner, bend[0], bend[1]));
    const double cx = plain.x_m3 / plain.area_m2;
    const double cy = plain.y_m3 / plain.area_m2;
    const auto polar = [cx, cy](const SectionMoments& s) {
      return s.xx_m4 + s.yy_m4 - 2.0 * (cx * s.x_m3 + cy * s.y_m3) + (cx * cx + cy * cy) * s.area_m2;
    };
    const WallSection wall =
        wall_.empty() ? WallSection{} : wallSection(outline, {&wall_m, 1}, kSaidInMillimetres);
    const double straight_m4 =
        wall_.empty() ? sections_.profile().at(arc_m).torsionConstant_m4 : wall.torsionConstant;
    RodElement e;
    const double shear_N = shearFactor(inner, plain.area_m2) * shear_Pa_ * m.area_m2;
    e.stretch_N = {shear_N, 0, 0, 0, shear_N, 0, 0, 0, young_Pa_ * m.area_m2};
    // What bending at rest alone shifts, as of sections that turn without warping; of a straight bar the
    // shear centre says it all.
    double shiftX = m.x_m3 - m.area_m2 * cx;
    double shiftY = m.y_m3 - m.area_m2 * cy;
    double torsion_m4 = straight_m4 * polar(m) / polar(plain);
    HeldWarping::Place warping;
    if (warping_) {
      warping = warping_->at(arc_m);
      const BentTorsion bent = bentTorsion(outline, bend[0], bend[1]);
      shiftX = shear_N / shear_Pa_ * bent.shear_m[1];
      shiftY = -shear_N / shear_Pa_ * bent.shear_m[0];
      torsion_m4 = straight_m4 * bent.stiffening / (warping.compliance * taperFactor(arc_m)) +
                   (shiftX * bent.shear_m[1] - shiftY * bent.shear_m[0]);
    }
    const double most2 = kMaxCoupling * kShearFactor * m.area_m2 * torsion_m4;
    const double size2 = shiftX * shiftX + shiftY * shiftY;
    if (size2 > most2) {
      const double scale = std::sqrt(most2 / size2);
      shiftX *= scale;
      shiftY *= scale;
    }
    e.coupling_Nm = {
        0, 0, -shear_Pa_ * shiftY, 0, 0, shear_Pa_ * shiftX, young_Pa_ * m.y_m3, -young_Pa_ * m.x_m3, 0};
    const double bending_Pa = young_Pa_ * ovalFactor(arc_m, wall.radius, wall_m, bend);
    e.bend_Nm2 = {
        bending_Pa * m.yy_m4,  -bending_Pa * m.xy_m4, 0, -bending_Pa * m.xy_m4, bending_Pa * m.xx_m4, 0, 0, 0,
        shear_Pa_ * torsion_m4};
    if (warping_) {
      bendStiffly(e, outline, arc_m);
    }
    // Where the warping changes along the organ, twist strains its fibres: on the mean that is a stretch.
    e.coupling_Nm[8] = young_Pa_ * warping.stretchShift_m3;
    e.bend_Nm2[8] += young_Pa_ * warping.stretchShift_m3 * warping.stretchShift_m3 / m.area_m2;
    const std::array<double, 2> centre = sections_.shearCentre_m(arc_m);
    addShearCentre(e, centre[0], centre[1]);
    return {e,
            {(plain.xx_m4 - cx * plain.x_m3) / plain.area_m2, (plain.xy_m4 - cx * plain.y_m3) / plain.area_m2,
             (plain.yy_m4 - cy * plain.y_m3) / plain.area_m2},
            young_Pa_ * plain.area_m2};
  }

  void bendStiffly(RodElement& e, std::span<const Point2> outline, double arc_m) const {
    std::vector<double> away_m{arc_m - rod_.arcs_m.front()};
    if (ends_ == EndCondition::kBothHeld) {
      away_m.push_back(rod_.arcs_m.back() - arc_m);
    }
    const FlatBending s = flatBending(outline, poisson_, away_m);
    const double a = e.bend_Nm2[0];
    const double b = e.bend_Nm2[1];
    const double c = e.bend_Nm2[4];
    const double ab = s.xx * b + s.xy * c;
    const double aa = s.xx * a + s.xy * b;
    const double ba = s.xy * a + s.yy * b;
    const double bb = s.xy * b + s.yy * c;
    e.bend_Nm2[0] = aa * s.xx + ab * s.xy;
    e.bend_Nm2[1] = aa * s.xy + ab * s.yy;
    e.bend_Nm2[3] = ba * s.xx + bb * s.xy;
    e.bend_Nm2[4] = ba * s.xy + bb * s.yy;
  }

  [[nodiscard]] double taperFactor(double arc_m) const {
    return corrections_.taper ? taperCompliance(sections_.profile(), arc_m, lattice_.length_m(),
                                                lattice_.length_m() / kTipSteps)
                              : 1.0;
  }

  static SectionMoments less(const SectionMoments& a, const SectionMoments& b) {
    return {a.area_m2 - b.area_m2, a.x_m3 - b.x_m3,   a.y_m3 - b.y_m3,
            a.xx_m4 - b.xx_m4,     a.xy_m4 - b.xy_m4, a.yy_m4 - b.yy_m4};
  }

  // Cowper's shear factor of a round tube for nu = 0.5, from the squared ratio of its radii: 0.9 of a filled
  // one.
  static double shearFactor(std::span<const Point2> inner, double material_m2) {
    if (inner.empty()) {
      return kShearFactor;
    }
    const double hole_m2 = std::max(0.0, momentsOf(inner, 0.0, 0.0).area_m2);
    const double ratio2 = hole_m2 / (hole_m2 + material_m2);
    const double sum2 = (1.0 + ratio2) * (1.0 + ratio2);
    return 9.0 * sum2 / (10.0 * sum2 + 26.0 * ratio2);
  }

  // What is left of the bending stiffness of a wall that is bent at rest: von Karman's factor where the
  // section can go oval, 1 at the held ends.
  [[nodiscard]] double ovalFactor(double arc_m, double radius_m, double wall_m,
                                  const std::array<double, 3>& bend) const {
    const double curvature_per_m = std::sqrt(bend[0] * bend[0] + bend[1] * bend[1]);
    if (wall_.empty() || curvature_per_m <= 0.0) {
      return 1.0;
    }
    const double bent = wall_m / (curvature_per_m * radius_m * radius_m);
    const double square = bent * bent / (1.0 - poisson_ * poisson_);
    const double flexibility = (10.0 + 12.0 * square) / (1.0 + 12.0 * square);
    const double away_m = std::min(arc_m - rod_.arcs_m.front(), rod_.arcs_m.back() - arc_m);
    const double ramp = std::clamp(away_m / (kOvalRamp * radius_m * std::sqrt(radius_m / wall_m)), 0.0, 1.0);
    return 1.0 / (1.0 + (flexibility - 1.0) * ramp);
  }

  static RodBendLimit bendLimit(const std::array<double, 3>& second_m2, double axial_N,
                                const std::array<double, 3>& curvature) {
    const double bx = curvature[1];
    const double by = -curvature[0];
    const double bend2 = bx * bx + by * by;
    const double along =
        second_m2[0] * bx * bx + 2.0 * second_m2[1] * bx * by + second_m2[2] * by * by;  // <xi^2> bend^2
    const double lever = bend2 > 0.0 ? -2.0 * along / bend2 : 0.0;
    RodBendLimit limit;
    limit.lever_m = {lever * bx, lever * by};
    limit.spread_m2 = {4.0 * second_m2[0], 4.0 * second_m2[1], 4.0 * second_m2[2]};
    const double atRest = lever * bend2 + 2.0 * std::sqrt(along);
    limit.limit = std::max(kLeastBendLimit, atRest + kAboveRest);
    limit.stiffness_N = 0.25 * kBendStiffness * axial_N;
    return limit;
  }

  [[nodiscard]] RodElement element(int i, std::span<const double> arcs,
                                   std::span<const LatticeOutline> outlines) const {
    RodElement result;
    result.length_m = length(i);
    const RodStrain rest = rodStrain(result.length_m, rod_.rest.nodes[at(i)], rod_.rest.nodes[at(i + 1)]);
    if (!(rest.stretch.z > 0.0)) {
      const double share = 0.5 * (rod_.arcs_m[at(i)] + rod_.arcs_m[at(i + 1)]) / lattice_.length_m();
      throw Error(ErrorCode::kBadMesh,
                  Text::tr("the organ's axis turns back on itself at %1 of its length", shortNumber(share)),
                  Text::tr("rod"), Text::tr("Name its ends, with a cut across each"));
    }
    result.restStrain = {rest.stretch.x, rest.stretch.y, rest.stretch.z};
    result.restCurvature_per_m = {rest.curvature_per_m.x, rest.curvature_per_m.y, rest.curvature_per_m.z};
    Matrix6 compliance{};
    std::array<double, 3> second{};
    double axial_N = 0.0;
    for (std::size_t p = 0; p < arcs.size(); ++p) {
      const SectionPart here = section(arcs[p], outlines[p].points_m, result.restCurvature_per_m);
      const Matrix6 part = inverse(stiffnessOf(here.stiffness));
      for (std::size_t k = 0; k < compliance.size(); ++k) {
        compliance[k] += kArcWeights[p] * part[k];
      }
      for (std::size_t k = 0; k < second.size(); ++k) {
        second[k] += kArcWeights[p] * here.second_m2[k];
      }
      axial_N += kArcWeights[p] * here.axial_N;
    }
    setStiffness(result, inverse(compliance));
    result.bendLimit = bendLimit(second, axial_N, result.restCurvature_per_m);
    return result;
  }

  const SectionLattice& lattice_;
  const SolvedSections& sections_;
  double shear_Pa_;
  double poisson_;
  double young_Pa_;
  WallMap wall_;
  TorsionCorrections corrections_;
  EndCondition ends_;
  RodDivision division_;
  int count_;
  std::optional<HeldWarping> warping_;
  OrganRod rod_;
};

}  // namespace

double restFibre(const Point2& point_m, double kappa1_per_m, double kappa2_per_m) {
  return std::max(kLeastRestFibre, 1.0 + kappa1_per_m * point_m[1] - kappa2_per_m * point_m[0]);
}

SectionMoments momentsOf(std::span<const Point2> outline_m, double kappa1_per_m, double kappa2_per_m) {
  SectionMoments sum;
  for (const SectionPoint& point : pointsOf(outline_m)) {
    const auto [x, y] = point.place_m;
    const double weight = point.weight_m2 / restFibre(point.place_m, kappa1_per_m, kappa2_per_m);
    sum.area_m2 += weight;
    sum.x_m3 += weight * x;
    sum.y_m3 += weight * y;
    sum.xx_m4 += weight * x * x;
    sum.xy_m4 += weight * x * y;
    sum.yy_m4 += weight * y * y;
  }
  return sum;
}

OrganRod rodOfOrgan(const SectionLattice& lattice, const SolvedSections& sections,
                    const RodMaterial& material, const RodDivision& division) {
  checkMaterial(material, division.elements);
  return RodMaker(lattice, sections, material, division).make();
}

}  // namespace torsio
