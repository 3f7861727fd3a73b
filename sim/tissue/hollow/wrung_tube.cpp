// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/hollow/wrung_tube.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <utility>

#include "sim/core/angle.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr double kFoldBending = 2.5;  // c_b, set once by runs in three dimensions (docs/model.md H.3)
// Of a clamped plate in shear, 8.98 pi^2 E / (12 (1 - nu^2)) over G for nu = 0.5 (Timoshenko).
constexpr double kPlateBuckling = 8.98 * kPi * kPi / 3.0;
constexpr double kCrestWay = 1.4142135623730951;  // along a crest at 45 degrees, of the way along the axis
constexpr double kPacking = 200.0;                // stiffness of the packed wall, over G t
constexpr double kTolerance = 1e-9;               // of the residual
constexpr double kLoosest = 1e-5;                 // residual at which a balance still counts
constexpr double kLongestStep = 0.15;             // of the radius
constexpr double kDifference = 1e-6;
constexpr int kMaxIterations = 400;
constexpr int kMaxShifts = 40;
constexpr std::size_t kBand =
    6;  // three unknowns a node, neighbours coupled: the diagonal and five beside it
constexpr std::size_t kEndElements = 2;  // beside a clamp, which count for no onset
constexpr double kSameEnergy = 1e-9;

using ElementPlace = std::array<double, 6>;  // r, z, turn of both nodes

// One element of the tube: two nodes and the wall between them.
struct TubeElement {
  double radius = 1.0;
  double thickness = 0.1;
  double length = 1.0;  // unloaded, along the wall
  WallLaw law;

  [[nodiscard]] WallMetric metric(const ElementPlace& q) const noexcept {
    const double r = 0.5 * (q[0] + q[3]);
    const double dr = (q[3] - q[0]) / length;
    const double dz = (q[4] - q[1]) / length;
    const double along = r * (q[5] - q[2]) / length;
    const double around = r / radius;
    return {dr * dr + along * along + dz * dz, along * around, around * around};
  }
  [[nodiscard]] double weight() const noexcept { return kTurn * radius * length * thickness; }
  [[nodiscard]] static double volume(const ElementPlace& q) noexcept {
    return kPi / 3.0 * (q[0] * q[0] + q[0] * q[3] + q[3] * q[3]) * (q[4] - q[1]);
  }
  [[nodiscard]] double energy(const ElementPlace& q, double pressure) const noexcept {
    return weight() * wallEnergy(law, metric(q)) - pressure * volume(q);
  }
  [[nodiscard]] ElementPlace gradient(const ElementPlace& q, double pressure) const noexcept {
    const double r = 0.5 * (q[0] + q[3]);
    const double dr = (q[3] - q[0]) / length;
    const double dz = (q[4] - q[1]) / length;
    const double rate = (q[5] - q[2]) / length;
    const double along = r * rate;
    const double around = r / radius;
    const WallMetric s = wallStress(law, metric(q));
    const double w = weight();
    const double onSlope = 2.0 * w * dr * s.a / length;
    const double onRise = 2.0 * w * dz * s.a / length;
    const double onAlong = w * (2.0 * along * s.a + around * s.b);
    const double onAround = w * (along * s.b + 2.0 * around * s.c);
    const double onRadius = 0.5 * (onAlong * rate + onAround / radius);
    const double onTurn = onAlong * r / length;
    const double third = pressure * kPi / 3.0;
    const double height = q[4] - q[1];
    const double face = third * (q[0] * q[0] + q[0] * q[3] + q[3] * q[3]);
    return {onRadius - onSlope - third * (2.0 * q[0] + q[3]) * height, -onRise + face, -onTurn,
            onRadius + onSlope - third * (2.0 * q[3] + q[0]) * height, onRise - face,  onTurn};
  }
};

double square(double x) {
  return x * x;
}

// What one balance works on: the elements, the forces and the band of the tangent.
struct Balance {
  Balance(const WrungTube& wrung, std::span<const WallLaw> laws) : tube(wrung), wall(wrung.wall()) {
    const std::size_t n = wall.radius.size();
    const double height = wall.length / static_cast<double>(n - 1);
    for (std::size_t e = 0; e + 1 < n; ++e) {
      const double rise = wall.radius[e + 1] - wall.radius[e];
      elements.push_back({0.5 * (wall.radius[e] + wall.radius[e + 1]),
                          0.5 * (wall.thickness[e] + wall.thickness[e + 1]),
                          std::sqrt(height * height + rise * rise), laws[e]});
      scale += elements.back().thickness / static_cast<double>(n - 1);
    }
    free.assign(3 * n, true);
    for (const std::size_t fixed : {std::size_t{0}, std::size_t{1}, std::size_t{2}, 3 * n - 3, 3 * n - 1}) {
      free[fixed] = false;
    }
    free[3 * n - 2] = wall.freeLength;
  }

  [[nodiscard]] static ElementPlace place(const std::vector<double>& x, std::size_t e) {
    ElementPlace q{};
    std::copy_n(x.begin() + static_cast<std::ptrdiff_t>(3 * e), q.size(), q.begin());
    return q;
  }
  [[nodiscard]] double packing(std::size_t node) const {
    return kPacking * wall.thickness[node] * elements[std::min(node, elements.size() - 1)].length;
  }
  [[nodiscard]] double depth(const std::vector<double>& x, std::size_t node) const {
    return std::max(tube.packedRadius(node) - x[3 * node], 0.0);
  }

  [[nodiscard]] double energy(const std::vector<double>& x, double pressure) const {
    double sum = 0.0;
    for (std::size_t e = 0; e < elements.size(); ++e) {
      sum += elements[e].energy(place(x, e), pressure);
    }
    for (std::size_t i = 0; i <= elements.size(); ++i) {
      sum += packing(i) * square(depth(x, i));
    }
    return sum - wall.pull * x[x.size() - 2];
  }

  void gradient(const std::vector<double>& x, double pressure) {
    force.assign(x.size(), 0.0);
    for (std::size_t e = 0; e < elements.size(); ++e) {
      const ElementPlace g = elements[e].gradient(place(x, e), pressure);
      for (std::size_t k = 0; k < g.size(); ++k) {
        force[3 * e + k] += g[k];
      }
    }
    for (std::size_t i = 0; i <= elements.size(); ++i) {
      force[3 * i] -= 2.0 * packing(i) * depth(x, i);
    }
    force[force.size() - 2] -= wall.pull;
  }

  [[nodiscard]] double residual() const {
    double most = 0.0;
    for (std::size_t k = 0; k < force.size(); ++k) {
      most = free[k] ? std::max(most, std::abs(force[k])) : most;
    }
    return most / scale;
  }

  // Lower band of the tangent, row after row: band[kBand k + d] is the entry (k, k - d).
  void tangent(const std::vector<double>& x, double pressure) {
    band.assign(kBand * x.size(), 0.0);
    for (std::size_t e = 0; e < elements.size(); ++e) {
      std::array<ElementPlace, 6> columns{};
      ElementPlace q = place(x, e);
      for (std::size_t k = 0; k < q.size(); ++k) {
        const double here = q[k];
        q[k] = here + kDifference;
        columns[k] = elements[e].gradient(q, pressure);
        q[k] = here - kDifference;
        const ElementPlace low = elements[e].gradient(q, pressure);
        q[k] = here;
        for (std::size_t i = 0; i < low.size(); ++i) {
          columns[k][i] = (columns[k][i] - low[i]) / (2.0 * kDifference);
        }
      }
      for (std::size_t i = 0; i < q.size(); ++i) {
        for (std::size_t k = 0; k <= i; ++k) {
          band[kBand * (3 * e + i) + i - k] += 0.5 * (columns[k][i] + columns[i][k]);
        }
      }
    }
    for (std::size_t i = 0; i <= elements.size(); ++i) {
      band[kBand * 3 * i] += depth(x, i) > 0.0 ? 2.0 * packing(i) : 0.0;
    }
  }

  // Solves (tangent + shift) step = -force by Cholesky's method; false where that is not positive definite.
  [[nodiscard]] bool newtonStep(double shift) {
    const std::size_t n = force.size();
    factor = band;
    step.assign(n, 0.0);
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t d = std::min(kBand - 1, k); d > 0; --d) {
        double& entry = factor[kBand * k + d];
        const std::size_t j = k - d;
        if (!free[k] || !free[j]) {
          entry = 0.0;
          continue;
        }
        for (std::size_t m = k >= kBand ? k - kBand + 1 : 0; m < j; ++m) {
          if (j - m < kBand) {
            entry -= factor[kBand * k + k - m] * factor[kBand * j + j - m];
          }
        }
        entry /= factor[kBand * j];
      }
      double pivot = free[k] ? band[kBand * k] + shift : 1.0;
      for (std::size_t d = 1; d <= std::min(kBand - 1, k); ++d) {
        pivot -= square(factor[kBand * k + d]);
      }
      if (!(pivot > 0.0)) {
        return false;
      }
      factor[kBand * k] = std::sqrt(pivot);
      double sum = free[k] ? -force[k] : 0.0;
      for (std::size_t d = 1; d <= std::min(kBand - 1, k); ++d) {
        sum -= factor[kBand * k + d] * step[k - d];
      }
      step[k] = sum / factor[kBand * k];
    }
    for (std::size_t k = n; k-- > 0;) {
      for (std::size_t d = 1; d < kBand && k + d < n; ++d) {
        step[k] -= factor[kBand * (k + d) + d] * step[k + d];
      }
      step[k] /= factor[kBand * k];
    }
    return true;
  }

  // x + step, no longer than kLongestStep; false where a node would pass the axis.
  [[nodiscard]] bool stepped(const std::vector<double>& x, std::vector<double>& to) const {
    double most = 0.0;
    for (const double s : step) {
      most = std::max(most, std::abs(s));
    }
    const double share = most > kLongestStep ? kLongestStep / most : 1.0;
    to.resize(x.size());
    bool inside = true;
    for (std::size_t k = 0; k < x.size(); ++k) {
      to[k] = x[k] + share * step[k];
      inside = inside && (k % 3 != 0 || to[k] > 0.0);
    }
    return inside;
  }

  const WrungTube& tube;
  const TubeWall& wall;
  std::vector<TubeElement> elements;
  std::vector<bool> free;
  double scale = 0.0;
  std::vector<double> force;
  std::vector<double> band;
  std::vector<double> factor;
  std::vector<double> step;
};

}  // namespace

WrungTube::WrungTube(TubeWall wall, int waves) : wall_(std::move(wall)) {
  const auto positive = [](double x) { return x > 0.0 && std::isfinite(x); };
  bool good = wall_.radius.size() >= 5 && wall_.thickness.size() == wall_.radius.size() && waves >= 1 &&
              positive(wall_.length) && positive(wall_.gentLimit) && positive(wall_.ends[0]) &&
              positive(wall_.ends[1]);
  good = good && std::all_of(wall_.radius.begin(), wall_.radius.end(), positive) &&
         std::all_of(wall_.thickness.begin(), wall_.thickness.end(), positive);
  if (!good) {
    refuseParameter(Text::verbatim("a wall has no length, radius, thickness or limit"),
                    Text::verbatim("tube"), Text::verbatim("Give at least 5 places and positive numbers."));
  }
  const std::size_t last = wall_.radius.size() - 1;
  even_ = wall_.ends[0] == wall_.ends[1];
  for (std::size_t e = 0; e < last; ++e) {
    const double share =
        (wall_.thickness[e] + wall_.thickness[e + 1]) / (wall_.radius[e] + wall_.radius[e + 1]);
    const double hold = kFoldBending * share * share * waves * waves / 3.0;
    laws_.push_back({wall_.gentLimit, wall_.foldsNeedRoom ? std::max(hold, roomHold(e)) : hold});
    even_ =
        even_ && wall_.radius[e] == wall_.radius[last - e] && wall_.thickness[e] == wall_.thickness[last - e];
  }
}

// A fold ends at a held end, and its crest runs at about 45 degrees to the axis: what buckles is a plate no
// longer than the way along the crest, clamped at its edges.
double WrungTube::roomHold(std::size_t element) const noexcept {
  const std::size_t elements = wall_.radius.size() - 1;
  const double thickness = 0.5 * (wall_.thickness[element] + wall_.thickness[element + 1]);
  const double step = wall_.length / static_cast<double>(elements);
  const double away = (0.5 + static_cast<double>(std::min(element, elements - 1 - element))) * step;
  const double slender = thickness / (kCrestWay * away);
  return kPlateBuckling * slender * slender;
}

double WrungTube::packedRadius(std::size_t node) const noexcept {
  return std::sqrt(2.0 * wall_.radius[node] * wall_.thickness[node]);
}

WrungShape WrungTube::start() const {
  WrungShape shape;
  const std::size_t last = wall_.radius.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(last);
    const double held =
        (1.0 - share) * wall_.ends[0] / wall_.radius[0] + share * wall_.ends[1] / wall_.radius[last];
    shape.nodes.push_back({held * wall_.radius[i], wall_.length * share, 0.0});
  }
  return shape;
}

void WrungTube::balance(double angle_rad, double pressure, WrungShape& shape) const {
  Balance work(*this, laws_);
  std::vector<double> x;
  for (const WrungShape::Node& node : shape.nodes) {
    x.insert(x.end(), {node.r, node.z, node.turn_rad});
  }
  const std::size_t n = x.size();
  x[0] = wall_.ends[0], x[1] = 0.0, x[2] = 0.0;
  x[n - 3] = wall_.ends[1], x[n - 1] = angle_rad;
  if (!wall_.freeLength) {
    x[n - 2] = wall_.length;
  }
  std::vector<double> next;
  double shift = 1e-6 * work.scale;
  double energy = work.energy(x, pressure);
  work.gradient(x, pressure);
  shape.iterations = 0;
  while (work.residual() > kTolerance && shape.iterations < kMaxIterations) {
    ++shape.iterations;
    work.tangent(x, pressure);
    bool better = false;
    for (int k = 0; k < kMaxShifts && !better; ++k) {
      if (!work.newtonStep(shift)) {
        shift = std::max(4.0 * shift, 1e-6 * work.scale);
        continue;
      }
      const double least = energy + 1e-13 * std::abs(energy);
      if (work.stepped(x, next)) {
        const double there = work.energy(next, pressure);
        better = there < least;
        energy = better ? there : energy;
      }
      shift = better ? std::max(shift / 8.0, 1e-12 * work.scale) : std::max(4.0 * shift, 1e-8 * work.scale);
    }
    if (!better) {
      break;
    }
    x.swap(next);
    work.gradient(x, pressure);
  }
  for (std::size_t i = 0; i < shape.nodes.size(); ++i) {
    shape.nodes[i] = {x[3 * i], x[3 * i + 1], x[3 * i + 2]};
  }
  shape.residual = work.residual();
  shape.energy = energy;
  shape.torque = work.force[n - 1];
  shape.volume = 0.0;
  shape.folding = -1.0;
  for (std::size_t e = 0; e < work.elements.size(); ++e) {
    const ElementPlace q = Balance::place(x, e);
    shape.volume += TubeElement::volume(q);
    if (e >= kEndElements && e + kEndElements < work.elements.size()) {
      const double excess = wallStretch(work.elements[e].metric(q)).excess;
      shape.folding = std::max(shape.folding, excess / laws_[e].foldHold - 0.25);
    }
  }
}

WrungShape WrungTube::mirrored(const WrungShape& shape) const {
  WrungShape image = shape;
  const std::size_t last = shape.nodes.size() - 1;
  const WrungShape::Node end = shape.nodes[last];
  for (std::size_t i = 0; i <= last; ++i) {
    const WrungShape::Node& from = shape.nodes[last - i];
    image.nodes[i] = {from.r, end.z - from.z, end.turn_rad - from.turn_rad};
  }
  return image;
}

void WrungTube::solve(double angle_rad, double pressure, WrungShape& shape) const {
  balance(angle_rad, pressure, shape);
  if (!(shape.residual <= kLoosest)) {
    throw Error(ErrorCode::kFolded,
                Text::verbatim("the wall finds no balance at %1 degrees", std::to_string(degrees(angle_rad))),
                Text::verbatim("wall"), Text::verbatim("Turn less far, or give another wall or pressure."));
  }
  if (shape.folding <= 0.0) {
    return;
  }
  const auto narrowest = [](const WrungShape& s) {
    const auto less = [](const WrungShape::Node& a, const WrungShape::Node& b) { return a.r < b.r; };
    return std::min_element(s.nodes.begin(), s.nodes.end(), less) - s.nodes.begin();
  };
  WrungShape image = mirrored(shape);
  if (even_) {  // the image is in balance as it stands
    shape.nodes = narrowest(image) > narrowest(shape) ? image.nodes : shape.nodes;
    return;
  }
  balance(angle_rad, pressure, image);
  const double gain = shape.energy - image.energy;
  if (image.residual <= kLoosest && gain > kSameEnergy * std::abs(shape.energy)) {
    shape = std::move(image);
  }
}

}  // namespace torsio
