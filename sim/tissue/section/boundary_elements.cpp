// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/section/boundary_elements.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/LU>

#include "sim/core/contracts.h"
#include "sim/core/portable_math.h"

namespace torsio {

namespace {

/// G may carry any constant because the fluxes sum to zero; this one keeps the equations away from the shape
/// size at which the logarithm makes them singular (logarithmic capacity 1). Outlines have area 1 here.
constexpr double kFarAway = 32.0;

struct Edge {
  Point2 a;
  Point2 b;
  Point2 tangent;
  Point2 normal;  // out of the material
  double length = 0.0;
  int loop = 0;
};

double dotOf(const Point2& a, const Point2& b) {
  return a[0] * b[0] + a[1] * b[1];
}

/// One edge seen from a point x: y = x + xi t + d n. The four integrals that everything is made of.
struct View {
  double xi0 = 0.0, xi1 = 0.0;  // along the edge
  double distance = 0.0;        // d
  double angle = 0.0;           // integral of d / r^2
  double log0 = 0.0, log1 = 0.0;

  View(const Edge& edge, const Point2& x) {
    const Point2 p = {edge.a[0] - x[0], edge.a[1] - x[1]};
    const Point2 q = {edge.b[0] - x[0], edge.b[1] - x[1]};
    xi0 = dotOf(p, edge.tangent);
    xi1 = dotOf(q, edge.tangent);
    distance = dotOf(p, edge.normal);
    angle = portableAtan2(p[0] * q[1] - p[1] * q[0], dotOf(p, q));
    log0 = 0.5 * portableLog(dotOf(p, p));
    log1 = 0.5 * portableLog(dotOf(q, q));
  }
  [[nodiscard]] double ofLog() const { return xi1 * log1 - xi0 * log0 - (xi1 - xi0) + distance * angle; }
  /// Integrals of xi ln r, xi d / r^2 and xi^2 d / r^2.
  [[nodiscard]] double ofXiLog() const {
    const double r0 = xi0 * xi0 + distance * distance, r1 = xi1 * xi1 + distance * distance;
    return 0.5 * (r1 * log1 - r0 * log0) - 0.25 * (r1 - r0);
  }
  [[nodiscard]] double ofXi() const { return distance * (log1 - log0); }
  [[nodiscard]] double ofXi2() const { return distance * (xi1 - xi0) - distance * distance * angle; }
};

/// -2 pi times the integral of r^2/4 dG/dn over the edge.
double parabola(const View& v, const Edge& edge, const Point2& x) {
  const Point2 foot = {x[0] + v.distance * edge.normal[0], x[1] + v.distance * edge.normal[1]};
  return 0.25 * (dotOf(foot, foot) * v.angle + 2.0 * dotOf(x, edge.tangent) * v.ofXi() + v.ofXi2());
}

class BoundaryProblem {
 public:
  BoundaryProblem(std::span<const BoundaryLoop> loops, double polarMoment, double area)
      : loops_(loops), polarMoment_(polarMoment), area_(area) {
    for (int k = 0; k < static_cast<int>(loops.size()); ++k) {
      firstEdge_.push_back(edges_.size());
      const auto& points = loops[static_cast<std::size_t>(k)].points;
      for (std::size_t i = 0; i < points.size(); ++i) {
        Edge e{points[i], points[(i + 1) % points.size()], {}, {}, 0.0, k};
        const double dx = e.b[0] - e.a[0], dy = e.b[1] - e.a[1];
        e.length = std::sqrt(dx * dx + dy * dy);
        e.tangent = {dx / e.length, dy / e.length};
        e.normal = {e.tangent[1], -e.tangent[0]};
        edges_.push_back(e);
      }
    }
    firstEdge_.push_back(edges_.size());
  }

  BoundaryFields solve() {
    solveFluxes();
    BoundaryFields out;
    out.torsionConstant = polarMoment_;
    for (std::size_t j = 0; j < edges_.size(); ++j) {
      const Edge& e = edges_[j];
      const double r2 = (dotOf(e.a, e.a) + dotOf(e.a, e.b) + dotOf(e.b, e.b)) / 3.0;  // mean over the edge
      out.torsionConstant -= flux_[j] * r2 * e.length;
    }
    out.slope.resize(loops_.size());
    for (std::size_t j = 0; j < edges_.size(); ++j) {
      out.slope[static_cast<std::size_t>(edges_[j].loop)].push_back(
          std::abs(flux_[j] - 0.5 * dotOf(edges_[j].a, edges_[j].normal)));
    }
    fillWarping(out);
    out.sag = largestHeight();
    return out;
  }

 private:
  void solveFluxes() {
    const auto n = static_cast<Eigen::Index>(edges_.size());
    const auto holes = static_cast<Eigen::Index>(loops_.size()) - 1;
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + holes, n + holes);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n + holes);
    const double shift = portableLog(kFarAway);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Edge& here = edges_[static_cast<std::size_t>(i)];
      const Point2 x = {0.5 * (here.a[0] + here.b[0]), 0.5 * (here.a[1] + here.b[1])};
      // Everything times -2 pi.
      right(i) = -kPi * 0.25 * dotOf(x, x);
      if (here.loop > 0) {
        matrix(i, n + here.loop - 1) += kPi;
      }
      for (Eigen::Index j = 0; j < n; ++j) {
        const Edge& e = edges_[static_cast<std::size_t>(j)];
        if (i == j) {
          matrix(i, j) = e.length * (portableLog(0.5 * e.length) - 1.0 - shift);
          continue;
        }
        const View v(e, x);
        matrix(i, j) = v.ofLog() - shift * e.length;
        right(i) += parabola(v, e, x);
        if (e.loop > 0) {
          matrix(i, n + e.loop - 1) -= v.angle;
        }
      }
      if (here.loop > 0) {
        matrix(n + here.loop - 1, i) = here.length;
      }
    }
    const Eigen::VectorXd solution = matrix.partialPivLu().solve(right);
    flux_.assign(solution.data(), solution.data() + n);
    plateau_.assign(solution.data() + n, solution.data() + n + holes);
    closeLoops();
  }

  /// psi must close round every loop, so the mean flux of a loop is zero.
  void closeLoops() {
    for (std::size_t k = 0; k + 1 < firstEdge_.size(); ++k) {
      double sum = 0.0, length = 0.0;
      for (std::size_t j = firstEdge_[k]; j < firstEdge_[k + 1]; ++j) {
        sum += flux_[j] * edges_[j].length;
        length += edges_[j].length;
      }
      for (std::size_t j = firstEdge_[k]; j < firstEdge_[k + 1]; ++j) {
        flux_[j] -= sum / length;
      }
    }
  }

  void fillWarping(BoundaryFields& out) const {
    for (std::size_t k = 0; k < loops_.size(); ++k) {
      std::vector<double> psi;
      double value = 0.0;
      for (std::size_t j = firstEdge_[k]; j < firstEdge_[k + 1]; ++j) {
        psi.push_back(value);
        value -= 2.0 * flux_[j] * edges_[j].length;
      }
      out.warping.push_back(std::move(psi));
    }
    for (std::size_t k = 1; k < loops_.size(); ++k) {
      const double offset = holeOffset(out, k);
      for (double& psi : out.warping[k]) {
        psi += offset;
      }
    }
    // Integral of psi = boundary integral of psi d(r^2/4)/dn: the other term of Green's identity closes.
    double sum = 0.0;
    for (std::size_t j = 0; j < edges_.size(); ++j) {
      const auto [first, second] = ends(out, j);
      sum += 0.25 * (first + second) * edges_[j].length * dotOf(edges_[j].a, edges_[j].normal);
    }
    for (auto& loop : out.warping) {
      for (double& psi : loop) {
        psi -= sum / area_;
      }
    }
  }

  /// psi at both ends of edge j.
  [[nodiscard]] std::pair<double, double> ends(const BoundaryFields& out, std::size_t j) const {
    const auto loop = static_cast<std::size_t>(edges_[j].loop);
    const auto& psi = out.warping[loop];
    const std::size_t i = j - firstEdge_[loop];
    return {psi[i], psi[(i + 1) % psi.size()]};
  }

  /// The constant between psi on hole k and psi on the outline: at a point x inside the hole, outside the
  /// material, Green's identity for psi reads 0, and the flux of G out of the material into the hole is 1.
  [[nodiscard]] double holeOffset(const BoundaryFields& out, std::size_t k) const {
    const Point2 x = pointInside(loops_[k].points);
    double sum = 0.0;
    for (std::size_t j = 0; j < edges_.size(); ++j) {
      const Edge& e = edges_[j];
      const View v(e, x);
      const auto [first, second] = ends(out, j);
      const double rise = (second - first) / e.length;
      sum -= dotOf(x, e.tangent) * v.ofLog() + v.ofXiLog();  // dpsi/dn = y . t
      sum += (first - rise * v.xi0) * v.angle + rise * v.ofXi();
    }
    return sum / (2.0 * kPi);
  }

  /// Middle of the widest stretch inside the polygon at a height where no point lies.
  static Point2 pointInside(std::span<const Point2> polygon) {
    std::vector<double> heights;
    for (const Point2& p : polygon) {
      heights.push_back(p[1]);
    }
    std::sort(heights.begin(), heights.end());
    double low = heights.front(), high = heights.front();
    for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
      if (heights[i + 1] - heights[i] > high - low) {
        low = heights[i], high = heights[i + 1];
      }
    }
    const double y = 0.5 * (low + high);
    std::vector<double> crossings;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point2& a = polygon[i];
      const Point2& b = polygon[(i + 1) % polygon.size()];
      if ((a[1] > y) != (b[1] > y)) {
        crossings.push_back(a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]));
      }
    }
    std::sort(crossings.begin(), crossings.end());
    TORSIO_EXPECTS(crossings.size() >= 2);
    std::size_t best = 0;
    for (std::size_t i = 2; i + 1 < crossings.size(); i += 2) {
      if (crossings[i + 1] - crossings[i] > crossings[best + 1] - crossings[best]) {
        best = i;
      }
    }
    return {0.5 * (crossings[best] + crossings[best + 1]), y};
  }

  [[nodiscard]] bool inMaterial(const Point2& x) const {
    if (!contains(loops_[0].points, x)) {
      return false;
    }
    for (std::size_t k = 1; k < loops_.size(); ++k) {
      if (contains(loops_[k].points, x)) {
        return false;
      }
    }
    return true;
  }

  /// z inside the material, by the representation formula; -1 elsewhere.
  [[nodiscard]] double heightAt(const Point2& x) const {
    if (!inMaterial(x)) {
      return -1.0;
    }
    double sum = 0.0;
    for (std::size_t j = 0; j < edges_.size(); ++j) {
      const View v(edges_[j], x);
      sum += parabola(v, edges_[j], x) - flux_[j] * v.ofLog();
      if (edges_[j].loop > 0) {
        sum += plateau_[static_cast<std::size_t>(edges_[j].loop) - 1] * v.angle;
      }
    }
    return sum / (2.0 * kPi) - 0.25 * dotOf(x, x);
  }

  /// A grid over the section, then ever smaller steps from the best place (z has no other tops nearby at the
  /// grid's width; the exact place matters little at a maximum).
  [[nodiscard]] double largestHeight() const {
    constexpr int kGrid = 16;
    Point2 low = loops_[0].points[0], high = low;
    for (const Point2& p : loops_[0].points) {
      for (std::size_t k = 0; k < 2; ++k) {
        low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
      }
    }
    Point2 best{};
    double top = -1.0;
    const auto visit = [&](const Point2& x) {
      const double z = heightAt(x);
      if (z <= top) {
        return false;
      }
      top = z, best = x;
      return true;
    };
    for (int i = 0; i < kGrid; ++i) {
      for (int j = 0; j < kGrid; ++j) {
        visit({low[0] + (i + 0.5) / kGrid * (high[0] - low[0]),
               low[1] + (j + 0.5) / kGrid * (high[1] - low[1])});
      }
    }
    Point2 step = {(high[0] - low[0]) / kGrid, (high[1] - low[1]) / kGrid};
    while (step[0] > 1e-4 || step[1] > 1e-4) {
      const Point2 c = best;
      bool better = false;
      for (const Point2& d : {Point2{1, 0}, Point2{-1, 0}, Point2{0, 1}, Point2{0, -1}}) {
        better = visit({c[0] + d[0] * step[0], c[1] + d[1] * step[1]}) || better;
      }
      if (!better) {
        step = {0.5 * step[0], 0.5 * step[1]};
      }
    }
    for (const double plateau : plateau_) {
      top = std::max(top, plateau);
    }
    return top;
  }

  std::span<const BoundaryLoop> loops_;
  double polarMoment_;
  double area_;
  std::vector<Edge> edges_;
  std::vector<std::size_t> firstEdge_;  // per loop, and the end
  std::vector<double> flux_;            // dH/dn per edge
  std::vector<double> plateau_;         // c per hole
};

}  // namespace

BoundaryFields solveBoundaryElements(std::span<const BoundaryLoop> loops, double polarMoment, double area) {
  TORSIO_EXPECTS(!loops.empty());
  return BoundaryProblem(loops, polarMoment, area).solve();
}

}  // namespace torsio
