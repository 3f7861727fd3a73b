// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/twist/twist_model_tables.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "sim/core/contracts.h"
#include "sim/core/error.h"
#include "sim/core/index.h"
#include "sim/core/portable_math.h"
#include "sim/core/short_number.h"
#include "sim/tissue/twist/held_warping.h"
#include "sim/tissue/twist/twist_model_map.h"
#include "sim/tissue/twist/twist_model_sections.h"

namespace torsio {

void requireShearModulus(double shearModulus_Pa, const Text& where) {
  if (shearModulus_Pa >= kSoftest_Pa && shearModulus_Pa <= kStiffest_Pa) {
    return;  // false for NaN
  }
  refuseParameter(Text::tr("the shear modulus is %1 Pa, but must lie in %2 to %3 Pa",
                           shortNumber(shearModulus_Pa), shortNumber(kSoftest_Pa), shortNumber(kStiffest_Pa)),
                  where, Text::tr("Give G in pascal; for nearly incompressible tissue it is E / 3."));
}

namespace {

constexpr std::size_t kArcs = 97;
constexpr std::size_t kAngles = 48;
constexpr double kSmoothing = 0.05;  // pull of the neighbours, in vertices a node
constexpr double kBeyondEnd = 0.25;  // of the radius: there the shift has died away
constexpr int kSweeps = 200;         // carry values across the widest gap between vertices

struct Polar {
  double angle_rad = 0.0;
  double radius_m = 0.0;
};

Polar polarOf(const AxisFrame& frame, const Vec3& point_m) {
  const Vec3 u = point_m - frame.centre_m;
  const double x = dot(u, frame.e1);
  const double y = dot(u, frame.e2);
  return {portableAtan2(y, x), std::sqrt(x * x + y * y)};
}

constexpr int kStrainNodes = 65;
constexpr double kShareRounding = 1e-12;
constexpr double kHeldFade = 0.5;  // of the radius

void checkNumber(double value, double low, double high, const char* name) {
  if (value >= low && value <= high) {
    return;  // false for NaN
  }
  refuseParameter(Text::verbatim("%1 is %2, but must lie in %3..%4", std::string(name), std::to_string(value),
                                 std::to_string(low), std::to_string(high)),
                  Text::verbatim("twist model options"), Text::verbatim("Choose a value inside the range."));
}

void checkOptions(const TwistModelOptions& o, const Material& material) {
  requireShearModulus(material.shearModulus_Pa, Text::tr("material %1", material.id));
  checkNumber(o.foundationLengths, 0.0, 1e6, "foundationLengths");
  if (o.foundationLengths > 0.0) {
    checkNumber(o.foundationLengths, 0.05, 1e6, "foundationLengths");
  }
  checkNumber(o.stiffeningStrain, 0.0, 1e6, "stiffeningStrain");
  checkNumber(o.stiffnessCap_N_per_m, 1.0, 1e6, "stiffnessCap_N_per_m");
  checkNumber(o.sectionPoints, 16.0, 10000.0, "sectionPoints");
  checkNumber(o.solvedSections, 2.0, kMaxSections, "solvedSections");
  const bool paper = o.formulation == Formulation::kPaper;
  if (o.poynting && (paper || o.ends != EndCondition::kClampedFree)) {
    refuseParameter(Text::verbatim("the axial stretch needs a free end and the Saint-Venant formulation"),
                    Text::verbatim("twist model options"), Text::verbatim("Switch poynting off."));
  }
  if (paper && (o.foundationLengths > 0.0 || o.centre == TwistCentre::kShearCentre)) {
    refuseParameter(Text::verbatim("the paper's formulation knows neither a foundation nor a shear centre"),
                    Text::verbatim("twist model options"),
                    Text::verbatim("Use the Saint-Venant formulation."));
  }
}

// Builder: the steps of the constructor in order, each a screen.
class TableMaker {
 public:
  TableMaker(const TriangleMesh& mesh, const SectionLattice& lattice, const Material& material,
             const TwistModelOptions& options)
      : mesh_(mesh),
        lattice_(lattice),
        material_(material),
        options_(options),
        solved_(solvedSections(lattice, options)) {}

  TwistModel::Tables make() {
    makeTwist();
    makeProfiles();
    tables_.arcs = ArcField(mesh_, lattice_);
    makeVertices();
    makeReach();
    makePatches();
    if (options_.poynting) {
      makeElongation();
    }
    if (tables_.linear && options_.paperInterpolation == PaperInterpolation::kComponents) {
      makeComponents();
    }
    makeStrain();
    return std::move(tables_);
  }

 private:
  [[nodiscard]] double length() const { return lattice_.length_m(); }
  [[nodiscard]] int intervals() const { return fineNodes(lattice_.sections()) - 1; }
  [[nodiscard]] double step() const { return length() / intervals(); }

  template <typename F>
  HermiteTable table(F&& f) const {
    std::vector<double> values;
    for (int i = 0; i <= intervals(); ++i) {
      values.push_back(f(length() * i / intervals()));
    }
    return {0.0, step(), std::move(values), true};
  }

  void makeTwist();
  void makeProfiles();
  void makeVertices();
  void makeReach();
  void makePatches();
  void makeElongation();
  void makeComponents();
  void makeStrain();
  [[nodiscard]] double warpingShare(std::size_t vertex, std::span<const double> freeRim_m) const;
  [[nodiscard]] std::vector<double> freeRim() const;

  const TriangleMesh& mesh_;
  const SectionLattice& lattice_;
  const Material& material_;
  const TwistModelOptions& options_;
  SolvedSections solved_;
  HermiteTable compliance_;  // of Saint-Venant: C(s)
  TwistModel::Tables tables_;
};

void TableMaker::makeTwist() {
  tables_.linear = options_.formulation == Formulation::kPaper;
  std::vector<double> nodes;
  if (tables_.linear) {
    std::vector<PaperSection> sections;
    for (int j = 0; j < lattice_.sections(); ++j) {
      const double arc = lattice_.sectionArc_m(j);
      sections.push_back({solved_.sag_m2(arc), solved_.profile().at(arc).area_m2});
    }
    const PaperTwist twist = paperTwist(sections, length(), material_.shearModulus_Pa, options_.paper);
    nodes = krigedNodes(twist.angle_rad, length(), options_.kriging);
    tables_.spacing_m = twist.spacing_m;
    tables_.lift = HermiteTable(0.0, step(), krigedNodes(twist.lift_m2, length(), options_.kriging), false);
  } else {
    constexpr double kYoungOverShear = 3.0;  // incompressible
    std::optional<HeldWarping> held;
    if (options_.corrections.restrainedEnds) {
      held.emplace(lattice_, solved_, 0.0, length(), kYoungOverShear, options_.ends);
    }
    nodes = sectionCompliances(solved_.profile(), intervals() + 1, length(), material_.shearModulus_Pa,
                               options_.corrections.taper, held ? &*held : nullptr);
    compliance_ = HermiteTable(0.0, step(), nodes, true);
  }
  tables_.twist = TorsionTable(0.0, step(), std::move(nodes), options_.ends,
                               {options_.foundationLengths * length()}, tables_.linear);
}

void TableMaker::makeProfiles() {
  tables_.radius = table([&](double s) { return solved_.profile().radius_m(s); });
  tables_.shear = table([&](double s) { return solved_.maxShear_m(s); });
  tables_.shiftedCentre = options_.centre == TwistCentre::kShearCentre;
  if (!tables_.shiftedCentre) {
    return;
  }
  tables_.centreX = table([&](double s) { return solved_.shearCentre_m(s)[0]; });
  tables_.centreY = table([&](double s) { return solved_.shearCentre_m(s)[1]; });
}

// Distance of the free end's outline from the axis, by ridge angle.
std::vector<double> TableMaker::freeRim() const {
  const int j = lattice_.sections() - 1;
  std::vector<double> radii;
  for (const Point2& p : lattice_.outline_m(j)) {
    radii.push_back(std::sqrt(p[0] * p[0] + p[1] * p[1]));
  }
  return onEqualAngles(lattice_.outlineAngles_rad(j), radii, SolvedSections::kAngles);
}

// A held end keeps its section flat: psi fades in over half a radius. In the cap of a free end psi falls with
// the square of the distance from the axis, as it does for an ellipse, and dies away within a radius beyond
// it.
double TableMaker::warpingShare(std::size_t vertex, std::span<const double> freeRim_m) const {
  const LatticeCoordinate& coordinate = lattice_.vertexCoordinates()[vertex];
  const auto fade = [&](double fromEnd, double end) {
    const double t = std::clamp(fromEnd / (kHeldFade * tables_.radius.value(end)), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
  };
  double share = fade(coordinate.arc_m, 0.0);
  if (options_.ends == EndCondition::kBothHeld) {
    return share * fade(length() - coordinate.arc_m, length());
  }
  if (lattice_.vertexParts()[vertex] != LatticePart::kFreeCap) {
    return share;
  }
  const double rim = atAngle(freeRim_m, coordinate.angle_rad);
  const AxisFrame frame = lattice_.frameAt(coordinate.arc_m);
  const Vec3 u = mesh_.vertices_m[vertex] - frame.centre_m;
  const double along = dot(u, frame.tangent);
  const double across2 = std::max(0.0, dot(u, u) - along * along);
  const double left = std::clamp(1.0 - std::abs(along) / rim, 0.0, 1.0);
  return share * std::min(1.0, across2 / (rim * rim)) * left * left * (3.0 - 2.0 * left);
}

void TableMaker::makeVertices() {
  const std::span<const LatticeCoordinate> coordinates = lattice_.vertexCoordinates();
  TORSIO_EXPECTS(coordinates.size() == mesh_.vertices_m.size());
  const bool warped = options_.warping && !tables_.linear;
  std::vector<std::vector<double>> rows;
  if (warped) {
    for (int i = 0; i <= intervals(); ++i) {
      rows.push_back(solved_.warping_m2(length() * i / intervals()));
    }
  }
  const std::vector<double> rim = freeRim();
  tables_.vertices.reserve(coordinates.size());
  const TwistMap map(tables_, lattice_, {});
  for (std::size_t v = 0; v < coordinates.size(); ++v) {
    const double arc = coordinates[v].arc_m;
    TwistVertex vertex{mesh_.vertices_m[v], map.centreAt(arc), arc, 0.0, tables_.twist.placeAt(arc)};
    if (warped) {
      const double place = std::clamp(arc / step(), 0.0, static_cast<double>(intervals()));
      const std::size_t low = std::min(static_cast<std::size_t>(place), at(intervals() - 1));
      const double t = place - static_cast<double>(low);
      const double angle = coordinates[v].angle_rad;
      const double psi = (1.0 - t) * atAngle(rows[low], angle) + t * atAngle(rows[low + 1], angle);
      vertex.warp_m2 = psi * warpingShare(v, rim);
    }
    tables_.vertices.push_back(vertex);
  }
}

// The shares are at most 1 where A rises and B falls along the organ.
void TableMaker::makeReach() {
  TwistModel::Tables::Reach& reach = tables_.reach;
  std::vector<const TwistVertex*> byArc;
  for (const TwistVertex& vertex : tables_.vertices) {
    byArc.push_back(&vertex);
    reach.radius_m =
        std::max(reach.radius_m, norm(cross(vertex.line.direction, vertex.rest_m - vertex.line.point_m)));
    reach.warp_m2 = std::max(reach.warp_m2, std::abs(vertex.warp_m2));
    reach.risingSlope = std::max(reach.risingSlope, std::abs(vertex.torsion.rising.slope));
    reach.fallingSlope = std::max(reach.fallingSlope, std::abs(vertex.torsion.falling.slope));
  }
  std::sort(byArc.begin(), byArc.end(),
            [](const TwistVertex* a, const TwistVertex* b) { return a->arc_m < b->arc_m; });
  const double rounding = kShareRounding * std::abs(tables_.twist.rising(length()).value);
  const auto unordered = [rounding](const TwistVertex* a, const TwistVertex* b) {
    const TorsionTable::Place& one = a->torsion;
    const TorsionTable::Place& next = b->torsion;
    return one.rising.value > next.rising.value + rounding || one.rising.value < -rounding ||
           one.falling.value < next.falling.value - kShareRounding || next.falling.value < -kShareRounding;
  };
  reach.bounded = !tables_.linear && !options_.poynting &&
                  std::adjacent_find(byArc.begin(), byArc.end(), unordered) == byArc.end();
}

void TableMaker::makePatches() {
  const int n = lattice_.ridges();
  for (int j = 0; j + 1 < lattice_.sections(); ++j) {
    const double arc = 0.5 * (lattice_.sectionArc_m(j) + lattice_.sectionArc_m(j + 1));
    const std::vector<double> row = solved_.shear_m(arc);
    for (int k = 0; k < n; ++k) {
      tables_.patchArc_m.push_back(arc);
      tables_.patchShear_Pa_m.push_back(material_.shearModulus_Pa * atAngle(row, 2.0 * kPi * (k + 0.5) / n));
    }
  }
}

void TableMaker::makeElongation() {
  tables_.poynting = true;
  tables_.stretch = table([&](double s) {
    const TorsionSection section = solved_.profile().at(s);
    const double slope = compliance_.at(s).slope;
    return slope * slope * section.polarMoment_m4 / (2.0 * section.area_m2);
  });
  std::array<Vec3, 4> sum{};
  tables_.elongation_m.push_back(sum);
  for (int i = 0; i < intervals(); ++i) {
    const double middle = (i + 0.5) * step();
    const double q = tables_.stretch.value(middle);
    const Vec3 tangent = lattice_.frameAt(middle).tangent;
    double power = 1.0;
    for (Vec3& part : sum) {
      power *= q;
      part += (power * step()) * tangent;
    }
    tables_.elongation_m.push_back(sum);
  }
}

void TableMaker::makeComponents() {
  const int n = lattice_.ridges();
  const int m = lattice_.sections();
  tables_.components = true;
  for (int j = 0; j < m; ++j) {
    const double arc = lattice_.sectionArc_m(j);
    const AxisFrame frame = lattice_.frameAt(arc);
    for (int k = 0; k < n; ++k) {
      const Vec3 u = lattice_.keyPoint_m(k, j) - frame.centre_m;
      const Vec3 move = paperDisplacement(dot(u, frame.e1), dot(u, frame.e2), 1.0, tables_.lift.value(arc),
                                          tables_.spacing_m);
      tables_.keyTurn_m.push_back(move.x * frame.e1 + move.y * frame.e2);
      tables_.keyLift_m.push_back(move.z * frame.tangent);
    }
  }
  std::vector<double> arcs;
  arcs.reserve(at(m));
  for (int j = 0; j < m; ++j) {
    arcs.push_back(lattice_.sectionArc_m(j));
  }
  std::vector<double> queries;
  for (const LatticeCoordinate& coordinate : lattice_.vertexCoordinates()) {
    queries.push_back(coordinate.arc_m);
    const double place = coordinate.angle_rad * n / (2.0 * kPi);
    const int ridge = std::min(static_cast<int>(place), n - 1);
    tables_.ridgePlaces.push_back({ridge, std::clamp(place - ridge, 0.0, 1.0)});
  }
  tables_.alongRidge = std::make_shared<const KrigingTable>(Kriging1d(arcs, options_.kriging), queries);
}

void TableMaker::makeStrain() {
  tables_.stiffeningStrain = options_.stiffeningStrain;
  std::vector<double> values;
  for (int g = 0; g < kStrainNodes; ++g) {
    const double grasp = length() * g / (kStrainNodes - 1);
    const TwistMap map(tables_, lattice_, {grasp, 1.0});
    double most = 0.0;
    for (int i = 0; i <= intervals(); ++i) {
      const double arc = length() * i / intervals();
      most = std::max(most, std::abs(map.rate(arc)) * tables_.shear.value(arc));
    }
    const double stiffness = 1.0 / tables_.twist.compliance(grasp);
    values.push_back(most / stiffness);
  }
  tables_.strainPerTorque = HermiteTable(0.0, length() / (kStrainNodes - 1), std::move(values), true);
}

}  // namespace

ArcField::ArcField(const TriangleMesh& mesh, const SectionLattice& lattice) : length_m_(lattice.length_m()) {
  if (lattice.straight()) {
    return;
  }
  std::vector<Node> sums(kArcs * kAngles);
  std::vector<double> weights(kArcs * kAngles, 0.0);
  for (std::size_t v = 0; v < mesh.vertices_m.size(); ++v) {
    const double nearest = lattice.nearestArc_m(mesh.vertices_m[v]);
    const bool beyondEnd = nearest <= 0.0 || nearest >= length_m_;
    if (beyondEnd) {
      continue;  // a cap: its arc length is that of the end
    }
    const Polar polar = polarOf(lattice.frameAt(nearest), mesh.vertices_m[v]);
    const Place place = placeOf(nearest, polar.angle_rad);
    for (std::size_t i = 0; i < 4; ++i) {
      sums[place.node[i]].shift_m += place.weight[i] * (lattice.vertexCoordinates()[v].arc_m - nearest);
      sums[place.node[i]].radius_m += place.weight[i] * polar.radius_m;
      weights[place.node[i]] += place.weight[i];
    }
  }
  fillGaps(std::move(sums), std::move(weights));
}

// Each node takes the mean of its vertices and, lightly, of its neighbours: nodes without a vertex take
// theirs from around.
void ArcField::fillGaps(std::vector<Node> sums, std::vector<double> weights) {
  nodes_.assign(kArcs * kAngles, Node{});
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (std::size_t i = 0; i < kArcs; ++i) {
      for (std::size_t a = 0; a < kAngles; ++a) {
        const std::size_t here = i * kAngles + a;
        Node sum = sums[here];
        double weight = weights[here];
        const auto pull = [&](std::size_t other) {
          sum.shift_m += kSmoothing * nodes_[other].shift_m;
          sum.radius_m += kSmoothing * nodes_[other].radius_m;
          weight += kSmoothing;
        };
        pull(i * kAngles + (a + 1) % kAngles);
        pull(i * kAngles + (a + kAngles - 1) % kAngles);
        if (i > 0) {
          pull(here - kAngles);
        }
        if (i + 1 < kArcs) {
          pull(here + kAngles);
        }
        nodes_[here] = {sum.shift_m / weight, sum.radius_m / weight};
      }
    }
  }
}

ArcField::Place ArcField::placeOf(double arc_m, double polar_rad) const noexcept {
  const double along = std::clamp(arc_m / length_m_, 0.0, 1.0) * static_cast<double>(kArcs - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(along), kArcs - 2);
  const double t = along - static_cast<double>(i);
  double round = polar_rad / (2.0 * kPi);
  round = (round - std::floor(round)) * static_cast<double>(kAngles);
  const std::size_t a = std::min(static_cast<std::size_t>(round), kAngles - 1);
  const double u = round - static_cast<double>(a);
  const std::size_t b = a + 1 < kAngles ? a + 1 : 0;
  Place place;
  place.node[0] = i * kAngles + a, place.weight[0] = (1.0 - t) * (1.0 - u);
  place.node[1] = i * kAngles + b, place.weight[1] = (1.0 - t) * u;
  place.node[2] = (i + 1) * kAngles + a, place.weight[2] = t * (1.0 - u);
  place.node[3] = (i + 1) * kAngles + b, place.weight[3] = t * u;
  return place;
}

double ArcField::arcAt(const SectionLattice& lattice, const Vec3& point_m) const noexcept {
  const double nearest = lattice.nearestArc_m(point_m);
  if (nodes_.empty()) {
    return nearest;
  }
  const AxisFrame frame = lattice.frameAt(nearest);
  const Polar polar = polarOf(frame, point_m);
  const Place place = placeOf(nearest, polar.angle_rad);
  double shift = 0.0;
  double radius = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    shift += place.weight[i] * nodes_[place.node[i]].shift_m;
    radius += place.weight[i] * nodes_[place.node[i]].radius_m;
  }
  double fade = polar.radius_m < radius ? polar.radius_m / radius : 1.0;
  if (nearest <= 0.0 || nearest >= length_m_) {  // what lies beyond an end follows it rigidly
    const double beyond = std::abs(dot(point_m - frame.centre_m, frame.tangent));
    fade *= std::max(0.0, 1.0 - beyond / (kBeyondEnd * radius));
  }
  return std::clamp(nearest + fade * shift, 0.0, length_m_);
}

TwistModel::Tables makeTwistTables(const TriangleMesh& mesh, const SectionLattice& lattice,
                                   const Material& material, const TwistModelOptions& options) {
  checkOptions(options, material);
  return TableMaker(mesh, lattice, material, options).make();
}

}  // namespace torsio
