// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/section/section_solver.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>

#include "sim/core/contracts.h"
#include "sim/core/error.h"
#include "sim/core/index.h"
#include "sim/tissue/section/boundary_elements.h"
#include "sim/tissue/section/boundary_values.h"
#include "sim/tissue/section/plane_mesh.h"
#include "sim/tissue/section/quadratic_elements.h"
#include "sim/tissue/section/section_outline.h"

namespace torsio {

namespace {

/// Rays of a polar mesh that graze the outline more flatly than this give needles; triangulate instead.
constexpr double kLeastGrazingSine = 0.25;
/// More rays than this would all be needles at the outline.
constexpr std::size_t kMaxRays = 1024;
/// Part of the gap that the elements split in one round hold (Doerfler marking).
constexpr double kMarkedShare = 0.7;

void requireRange(double value, double low, double high, const char* name) {
  if (value >= low && value <= high) {
    return;  // false for NaN
  }
  throw Error(ErrorCode::kBadParameter,
              Text::verbatim("%1 is %2, outside %3 to %4", std::string(name), std::to_string(value),
                             std::to_string(low), std::to_string(high)),
              Text::verbatim("section solver options"), Text::verbatim("Choose a value inside the range"));
}

std::vector<char> worstElements(const std::vector<double>& gap) {
  std::vector<std::size_t> order(gap.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&gap](std::size_t a, std::size_t b) { return gap[a] != gap[b] ? gap[a] > gap[b] : a < b; });
  const double total = std::accumulate(gap.begin(), gap.end(), 0.0);
  std::vector<char> marked(gap.size(), 0);
  double sum = 0.0;
  for (const std::size_t t : order) {
    if (sum >= kMarkedShare * total) {
      break;
    }
    sum += gap[t];
    marked[t] = 1;
  }
  return marked;
}

/// Largest value of a quadratic along one edge, from its ends and its middle.
double topOfEdge(double a, double middle, double b) {
  const double curvature = a - 2.0 * middle + b;
  const double slope = b - a;
  double best = std::max({a, middle, b});
  // Top of the parabola at t in [-1, 1] measured from the middle.
  if (curvature < 0.0 && std::abs(slope) < -2.0 * curvature) {
    best = std::max(best, middle - slope * slope / (8.0 * curvature));
  }
  return best;
}

/// Largest value of a quadratic field on one element: on an edge, or where its gradient vanishes inside.
double topOfElement(const std::array<int, 6>& element, const std::vector<double>& values) {
  const auto v = [&](int k) { return values[at(element[at(k)])]; };
  double best =
      std::max({topOfEdge(v(1), v(3), v(2)), topOfEdge(v(2), v(4), v(0)), topOfEdge(v(0), v(5), v(1))});
  // In coordinates (s, t) with corners (0,0), (1,0), (0,1): f = f0 + gs s + gt t + (hss s^2 + htt t^2)/2 +
  // hst s t.
  const double gs = -3.0 * v(0) - v(1) + 4.0 * v(5), gt = -3.0 * v(0) - v(2) + 4.0 * v(4);
  const double hss = 4.0 * (v(0) + v(1) - 2.0 * v(5)), htt = 4.0 * (v(0) + v(2) - 2.0 * v(4));
  const double hst = 4.0 * (v(0) + v(3) - v(4) - v(5));
  const double det = hss * htt - hst * hst;
  if (det <= 0.0 || hss >= 0.0) {
    return best;
  }
  const double s = (hst * gt - htt * gs) / det, t = (hst * gs - hss * gt) / det;
  if (s >= 0.0 && t >= 0.0 && s + t <= 1.0) {
    best = std::max(best, v(0) + 0.5 * (gs * s + gt * t));
  }
  return best;
}

/// Integrals of psi, psi x, psi y decide where the shear centre lies: moving the centre of twist by (a, b)
/// changes psi by -b x + a y, and the moments of psi must vanish.
Point2 shearCentreOf(const QuadraticFields& f, const SectionShape& shape) {
  double px = 0.0, py = 0.0;
  // Cubic integrand: the product of two quadratics is enough, through the mass matrix of the element.
  for (const auto& element : f.elements) {
    const Point2 &a = f.nodes[at(element[0])], &b = f.nodes[at(element[1])], &c = f.nodes[at(element[2])];
    const double area = 0.5 * orientation(a, b, c);
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      const double corner = f.warping[at(element[at(k)])], middle = f.warping[at(element[at(3 + k)])];
      // integral phi_k lambda_k = A/30, phi_k lambda_j = -A/60, middle (i, j): lambda_i A 2/15, lambda_k
      // A/15.
      const auto moment = [&](std::size_t d) {
        const double pk = f.nodes[at(element[at(k)])][d], pi = f.nodes[at(element[at(i)])][d],
                     pj = f.nodes[at(element[at(j)])][d];
        return area * (corner * (pk / 30.0 - (pi + pj) / 60.0) + middle * (2.0 * (pi + pj) + pk) / 15.0);
      };
      px += moment(0);
      py += moment(1);
    }
  }
  // px - b xx + a xy = 0 and py - b xy + a yy = 0.
  const double det = shape.xx * shape.yy - shape.xy * shape.xy;
  return {(px * shape.xy - py * shape.xx) / det, (px * shape.yy - py * shape.xy) / det};
}

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& v : values) {
    v *= factor;
  }
  return values;
}

}  // namespace

class SectionSolver::Impl {
 public:
  explicit Impl(const SectionSolverOptions& options) : options_(options) {
    requireRange(options.outlinePoints, 3, 4096, "outlinePoints");
    requireRange(options.rings, 1, 256, "rings");
    requireRange(options.bracket, 1e-9, 1.0, "bracket");
    requireRange(options.maxNodes, 16, 2000000, "maxNodes");
  }

  SectionProperties solve(std::span<const Point2> outline, std::span<const std::vector<Point2>> holes,
                          SectionField* field) {
    const SectionShape shape = prepareSection(outline, holes, options_.outlinePoints);
    if (field != nullptr) {
      *field = {};
    }
    if (options_.method != SectionMethod::kBoundaryElements) {
      if (const auto mesh = meshOf(shape)) {
        return byFiniteElements(shape, *mesh, field);
      }
      if (options_.method == SectionMethod::kFiniteElements) {
        throw Error(ErrorCode::kBadParameter,
                    Text::verbatim("edges of the outline all but touch: no mesh fits between them"),
                    Text::verbatim("outline"),
                    Text::verbatim("Use boundary elements, or join the points that touch"));
      }
    }
    return byBoundaryElements(shape);
  }

 private:
  static std::optional<PlaneMesh> meshOf(const SectionShape& shape, int rings) {
    const BoundaryLoop& outline = shape.outline.boundary;
    if (shape.holes.empty() && outline.points.size() <= kMaxRays &&
        grazingSine(outline.points, Point2{}) >= kLeastGrazingSine) {
      return polarMesh(outline, Point2{}, rings);
    }
    std::vector<BoundaryLoop> holes;
    for (const SampledLoop& hole : shape.holes) {
      holes.push_back(hole.boundary);
    }
    return polygonMesh(outline, holes);
  }
  [[nodiscard]] std::optional<PlaneMesh> meshOf(const SectionShape& shape) const {
    return meshOf(shape, options_.rings);
  }

  /// Twice, so that a round halves the size of the marked elements.
  static void split(PlaneMesh& mesh, std::vector<char> marked) {
    bisect(mesh, marked);
    marked.resize(mesh.triangles.size(), 1);
    bisect(mesh, marked);
  }

  SectionProperties byFiniteElements(const SectionShape& shape, PlaneMesh mesh, SectionField* field) {
    QuadraticFields fields = first_.solve(mesh, shape.holeAreas);
    while (fields.upper - fields.lower > options_.bracket * fields.lower &&
           static_cast<int>(fields.nodes.size()) < options_.maxNodes) {
      split(mesh, worstElements(fields.gap));
      fields = refined_.solve(mesh, shape.holeAreas);
    }
    SectionProperties out = commonPart(shape);
    const double u2 = shape.unit * shape.unit;
    out.methodUsed = SectionMethod::kFiniteElements;
    out.torsionLower = fields.lower * u2 * u2;
    out.torsionUpper = fields.upper * u2 * u2;
    out.torsionConstant = 0.5 * (out.torsionLower + out.torsionUpper);
    out.volume = 0.25 * out.torsionConstant;
    double top = 0.0;
    for (const auto& element : fields.elements) {
      top = std::max(top, topOfElement(element, fields.membrane));
    }
    out.sag = top * u2;
    fillBoundary(out, shape, boundaryValues(shape, fields));
    const Point2 centre = shearCentreOf(fields, shape);
    out.shearCentre = {shape.origin[0] + shape.unit * centre[0], shape.origin[1] + shape.unit * centre[1]};
    if (field != nullptr) {
      *field = fieldOf(shape, std::move(fields));
    }
    return out;
  }

  /// The bracket is an estimate here: the change from this outline to one divided twice as finely.
  SectionProperties byBoundaryElements(const SectionShape& shape) const {
    std::vector<BoundaryLoop> coarse{shape.outline.boundary}, fine;
    for (const SampledLoop& hole : shape.holes) {
      coarse.push_back(hole.boundary);
    }
    for (const BoundaryLoop& loop : coarse) {
      fine.push_back(halved(loop));
    }
    const double first = solveBoundaryElements(coarse, shape.polarMoment, shape.area).torsionConstant;
    const BoundaryFields fields = solveBoundaryElements(fine, shape.polarMoment, shape.area);
    SectionProperties out = commonPart(shape);
    const double u2 = shape.unit * shape.unit;
    const double change = std::abs(fields.torsionConstant - first);
    out.methodUsed = SectionMethod::kBoundaryElements;
    out.torsionConstant = fields.torsionConstant * u2 * u2;
    out.torsionLower = (fields.torsionConstant - change) * u2 * u2;
    out.torsionUpper = (fields.torsionConstant + change) * u2 * u2;
    out.volume = 0.25 * out.torsionConstant;
    out.sag = fields.sag * u2;
    out.shearCentre = out.centroid;
    fillBoundary(out, shape, boundaryValues(shape, fields));
    return out;
  }

  static BoundaryLoop halved(const BoundaryLoop& loop) {
    BoundaryLoop out;
    out.length = loop.length;
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      const Point2& a = loop.points[i];
      const Point2& b = loop.points[(i + 1) % loop.points.size()];
      const double end = i + 1 < loop.points.size() ? loop.arc[i + 1] : loop.length;
      out.points.push_back(a);
      out.points.push_back({0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])});
      out.arc.push_back(loop.arc[i]);
      out.arc.push_back(0.5 * (loop.arc[i] + end));
    }
    return out;
  }

  static SectionProperties commonPart(const SectionShape& shape) {
    SectionProperties out;
    const double u2 = shape.unit * shape.unit;
    out.area = shape.area * u2;
    out.centroid = shape.origin;
    out.polarMoment = shape.polarMoment * u2 * u2;
    return out;
  }

  static void fillBoundary(SectionProperties& out, const SectionShape& shape, BoundaryValues values) {
    const double u2 = shape.unit * shape.unit;
    out.maxShear = values.maxShear * shape.unit;
    out.warpingMin = values.warpingMin * u2;
    out.warpingMax = values.warpingMax * u2;
    out.outlineWarping = scaled(std::move(values.warping[0]), u2);
    out.outlineShear = scaled(std::move(values.shear[0]), shape.unit);
    for (std::size_t k = 1; k < values.warping.size(); ++k) {
      out.holeWarping.push_back(scaled(std::move(values.warping[k]), u2));
      out.holeShear.push_back(scaled(std::move(values.shear[k]), shape.unit));
    }
  }

  static SectionField fieldOf(const SectionShape& shape, QuadraticFields fields) {
    SectionField field;
    const double u2 = shape.unit * shape.unit;
    field.nodes = std::move(fields.nodes);
    for (Point2& p : field.nodes) {
      p = {shape.origin[0] + shape.unit * p[0], shape.origin[1] + shape.unit * p[1]};
    }
    field.elements = std::move(fields.elements);
    field.membrane = scaled(std::move(fields.membrane), u2);
    field.warping = scaled(std::move(fields.warping), u2);
    return field;
  }

  SectionSolverOptions options_;
  QuadraticElements first_;    // the mesh as cut: its topology repeats from section to section
  QuadraticElements refined_;  // after splitting: every one is different
};

SectionSolver::SectionSolver(const SectionSolverOptions& options) : impl_(std::make_unique<Impl>(options)) {}
SectionSolver::~SectionSolver() = default;
SectionSolver::SectionSolver(SectionSolver&&) noexcept = default;
SectionSolver& SectionSolver::operator=(SectionSolver&&) noexcept = default;

SectionProperties SectionSolver::solve(std::span<const std::array<double, 2>> outline,
                                       std::span<const std::vector<std::array<double, 2>>> holes,
                                       SectionField* field) {
  return impl_->solve(outline, holes, field);
}

SectionProperties solveSection(std::span<const std::array<double, 2>> outline,
                               const SectionSolverOptions& options,
                               std::span<const std::vector<std::array<double, 2>>> holes) {
  return SectionSolver(options).solve(outline, holes);
}

std::optional<SectionField::Value> SectionField::at(const std::array<double, 2>& point) const {
  // A point on an edge belongs to both sides; rounding must not put it outside.
  constexpr double kSlack = -1e-9;
  for (const auto& element : elements) {
    const Point2 &a = nodes[torsio::at(element[0])], &b = nodes[torsio::at(element[1])],
                 &c = nodes[torsio::at(element[2])];
    const double area2 = orientation(a, b, c);
    const double l1 = orientation(a, point, c) / area2, l2 = orientation(a, b, point) / area2;
    const double l0 = 1.0 - l1 - l2;
    if (l0 < kSlack || l1 < kSlack || l2 < kSlack) {
      continue;
    }
    const std::array<double, 6> shape = {l0 * (2 * l0 - 1), l1 * (2 * l1 - 1), l2 * (2 * l2 - 1),
                                         4 * l1 * l2,       4 * l2 * l0,       4 * l0 * l1};
    // d shape / d l1 and d l2 with l0 = 1 - l1 - l2.
    const std::array<double, 6> d1 = {1 - 4 * l0, 4 * l1 - 1, 0, 4 * l2, -4 * l2, 4 * (l0 - l1)};
    const std::array<double, 6> d2 = {1 - 4 * l0, 0, 4 * l2 - 1, 4 * l1, 4 * (l0 - l2), -4 * l1};
    const Point2 g1 = {(c[1] - a[1]) / area2, -(c[0] - a[0]) / area2};
    const Point2 g2 = {-(b[1] - a[1]) / area2, (b[0] - a[0]) / area2};
    Value value;
    Point2 slope{};
    for (std::size_t k = 0; k < 6; ++k) {
      const double z = membrane[torsio::at(element[k])];
      value.membrane += shape[k] * z;
      value.warping += shape[k] * warping[torsio::at(element[k])];
      for (std::size_t d = 0; d < 2; ++d) {
        slope[d] += z * (d1[k] * g1[d] + d2[k] * g2[d]);
      }
    }
    value.shear = {2.0 * slope[1], -2.0 * slope[0]};
    return value;
  }
  return std::nullopt;
}

}  // namespace torsio
