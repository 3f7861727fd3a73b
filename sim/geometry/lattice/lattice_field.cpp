// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/lattice/lattice_field.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/portable_math.h"
#include "sim/geometry/lattice/straight_axis.h"

namespace torsio {

namespace {

constexpr int kLeastIntervals = 256;    // of the centreline
constexpr int kWaySteps = 256;          // of the ridge angle at a station
constexpr std::size_t kStations = 400;  // level lines traced for the axis of a curved organ
constexpr double kSmoothing = 0.012;    // of the length; removes the steps of the mesh from the axis
constexpr double kSmoothingOfRadius = 0.25;
constexpr double kMaxSmoothingOfRadius = 0.5;
constexpr double kBeforeBranch = 0.5;  // of the last section's radius: what is left out before a branching
constexpr double kStride = 0.25;       // of a section's radius: over this way its centre must advance
constexpr double kSpeck = 1e-3;        // of the perimeter: a loop of rounding noise
constexpr double kSharpestTurn_rad = 0.5 * kPi;  // of the axis within one mean radius of the section

std::string inDegrees(double angle_rad) {
  return std::to_string(std::lround(degrees(angle_rad))) + " degrees";
}
std::string millimetres(double length_m) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f mm", length_m * 1000.0);
  return text;
}

/// Straight pieces between the entries of an ascending table.
double interpolate(std::span<const double> from, std::span<const double> to, double x) {
  const auto after = std::upper_bound(from.begin() + 1, from.end() - 1, x);
  const auto i = static_cast<std::size_t>(after - from.begin());
  const double step = from[i] - from[i - 1];
  const double share = step > 0.0 ? std::clamp((x - from[i - 1]) / step, 0.0, 1.0) : 0.0;
  return to[i - 1] + share * (to[i] - to[i - 1]);
}

/// Linear in a table of wayAtAngles.
double shareAtAngle(const std::vector<double>& ways, double angle_rad) {
  const double turns = angle_rad / (2.0 * kPi);
  const double place = (turns - std::floor(turns)) * kWaySteps;
  const auto i = std::min(static_cast<std::size_t>(place), static_cast<std::size_t>(kWaySteps - 1));
  return ways[i] + (place - static_cast<double>(i)) * (ways[i + 1] - ways[i]);
}

/// Stations of the axis: a multiple of the section spacing, so that every section lies on one.
int intervalsFor(int sections) {
  const int steps = sections - 1;
  return steps * ((kLeastIntervals + steps - 1) / steps);
}

/// Levels at equal shares of the vertices: the field changes most where the organ is thin.
std::vector<double> quantileLevels(const LatticeField& field) {
  std::vector<double> values;
  for (std::size_t v = 0; v < field.parts.size(); ++v) {
    if (field.parts[v] == LatticePart::kSide) {
      values.push_back(field.harmonic.level[v]);
    }
  }
  std::sort(values.begin(), values.end());
  constexpr double kApart = 1e-12;
  std::vector<double> levels{0.0};
  for (std::size_t k = 0; k < kStations && !values.empty(); ++k) {
    const double level = values[k * values.size() / kStations];
    if (level > levels.back() + kApart && level < 1.0 - kApart) {
      levels.push_back(level);
    }
  }
  levels.push_back(1.0);
  const std::size_t parts = (kStations / 2 + levels.size() - 2) / (levels.size() - 1);
  if (parts < 2) {
    return levels;
  }
  std::vector<double> denser;  // a coarse mesh has few vertices: lines between them
  for (std::size_t k = 0; k + 1 < levels.size(); ++k) {
    for (std::size_t part = 0; part < parts; ++part) {
      const double share = static_cast<double>(part) / static_cast<double>(parts);
      denser.push_back(levels[k] + share * (levels[k + 1] - levels[k]));
    }
  }
  denser.push_back(1.0);
  return denser;
}

/// What is kept of the level line of a station.
struct Station {
  Vec3 centre_m;
  double radius_m = 0.0;  ///< of the circle with the section's area
  Vec3 normal;            ///< of the loop's plane, towards the free end
};

class FieldBuilder {
 public:
  FieldBuilder(const TriangleMesh& mesh, const LatticeOptions& options) : field_(mesh), options_(options) {}

  LatticeField build() {
    if (options_.mode != LatticeMode::kAutomatic) {
      field_.mode = options_.mode;
    } else if (isStraightBar(field_.mesh, field_.topology, capRequest())) {
      field_.mode = LatticeMode::kStraightAxis;
    }
    if (field_.mode == LatticeMode::kStraightAxis) {
      buildStraight();
    } else {
      buildHarmonic();
    }
    const double start_m = options_.ridgeZeroFraction * field_.centreline.length_m();
    const LevelLoop loop = field_.loopAt(start_m, "the section on which ridge 0 starts");
    field_.rule.anchor_rad = exitAlongE1(loop, field_.centreline.frameAt(start_m)).angle_rad;
    field_.rule.alongE1 = field_.centreline.straight() && allStarShaped_;
    field_.rule.spacing = options_.spacing == RidgeSpacing::kAngle && allStarShaped_
                              ? RidgeSpacing::kAngle
                              : RidgeSpacing::kArcLength;
    findStarts();
    return std::move(field_);
  }

 private:
  [[nodiscard]] CapRequest capRequest() const {
    return {options_.fixedEnd_m, options_.freeEnd_m, options_.fixedCut, options_.freeCut,
            options_.capRadius_m};
  }

  void buildStraight() {
    const StraightAxis axis = findStraightAxis(field_.mesh, field_.topology, capRequest());
    std::vector<double> levels = axisLevels(field_.mesh, axis);
    for (const double level : levels) {
      field_.parts.push_back(level <= 0.0   ? LatticePart::kFixedCap
                             : level >= 1.0 ? LatticePart::kFreeCap
                                            : LatticePart::kSide);
    }
    requireWholeSections(levels, axis.length_m);
    field_.harmonic = solveHarmonicField(field_.mesh, field_.topology, field_.parts, std::move(levels));
    const int intervals = intervalsFor(options_.sections);
    for (int i = 0; i <= intervals; ++i) {
      field_.stationLevels.push_back(static_cast<double>(i) / intervals);
      field_.stationArcs_m.push_back(axis.length_m * field_.stationLevels.back());
    }
    traceStations();
    std::vector<Vec3> centres;
    centres.reserve(stations_.size());
    for (std::size_t k = 0; k < stations_.size(); ++k) {
      // The height of the plane, not of the centroid, whose last digits are rounded.
      const Vec3 aside = stations_[k].centre_m - axis.origin_m;
      const double height = field_.stationArcs_m[k];
      centres.push_back(stations_[k].centre_m + (height - dot(aside, axis.direction)) * axis.direction);
    }
    field_.centreline = Centreline::straightAlong(axis.direction, axis.length_m, centres, options_.ridgeZero);
  }

  void buildHarmonic() {
    const EndCaps caps = findEndCaps(field_.mesh, field_.topology, capRequest());
    field_.parts = caps.parts;
    field_.harmonic = solveHarmonicField(field_.mesh, field_.topology, field_.parts);
    field_.stationLevels = quantileLevels(field_);
    traceStations();
    trimEnds(caps);
    std::vector<Vec3> line;
    std::vector<double> radii;
    for (const Station& station : stations_) {
      line.push_back(station.centre_m);
      radii.push_back(station.radius_m);
    }
    double length = 0.0;
    for (std::size_t k = 1; k < line.size(); ++k) {
      length += norm(line[k] - line[k - 1]);
    }
    if (!(length > 0.0)) {
      throw Error(ErrorCode::kBadMesh, Text::tr("the axis of the organ has no length"), "",
                  Text::tr("Give two end points further apart."));
    }
    std::nth_element(radii.begin(), radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2),
                     radii.end());
    // Where the levels climb over a bump (a thumb, the cardia) their centroids jump aside: smoothed more.
    const double radius = radii[radii.size() / 2];
    double smoothing = std::min(kSmoothing * length, kSmoothingOfRadius * radius);
    for (;; smoothing *= 2.0) {
      field_.centreline =
          Centreline::curved(line, smoothing, intervalsFor(options_.sections), options_.ridgeZero,
                             options_.ridgeZeroFraction, field_.stationArcs_m);
      const Turn turn = sharpestTurn();
      if (turn.angle_rad <= kSharpestTurn_rad) {
        return;
      }
      if (2.0 * smoothing > kMaxSmoothingOfRadius * radius) {
        refuseKink(turn);
      }
    }
  }

  /// Where a cap is not a flat face its rim is a jagged line of vertices; the field smooths that out within
  /// an edge length, and there the organ begins and ends. With caps that were found, not given, it also ends
  /// where it branches, as at the knuckles: what lies beyond follows the end section.
  void trimEnds(const EndCaps& caps) {
    std::vector<double> way(stations_.size(), 0.0);      // of the centres
    std::vector<double> surface(stations_.size(), 0.0);  // along the surface: a dome opens up as it advances
    for (std::size_t k = 1; k < way.size(); ++k) {
      const double step = norm(stations_[k].centre_m - stations_[k - 1].centre_m);
      way[k] = way[k - 1] + step;
      surface[k] = surface[k - 1] + std::hypot(step, stations_[k].radius_m - stations_[k - 1].radius_m);
    }
    const auto [first, last] = capRequest().automatic() ? unbranchedPart(way) : wholePart();
    const double edge = std::min(meanEdge_m(), 0.1 * surface.back());
    double low = field_.stationLevels[first];
    double high = field_.stationLevels[last];
    if (first == 0 && !caps.fixedFlat) {
      low = interpolate(surface, field_.stationLevels, edge);
    }
    if (last + 1 == way.size() && !caps.freeFlat) {
      high = interpolate(surface, field_.stationLevels, surface.back() - edge);
    }
    if (low == 0.0 && high == 1.0) {
      return;
    }
    for (std::size_t v = 0; v < field_.parts.size(); ++v) {
      double& level = field_.harmonic.level[v];
      level = (level - low) / (high - low);
      if (level <= 0.0) {
        field_.parts[v] = LatticePart::kFixedCap;
      }
      if (level >= 1.0) {
        field_.parts[v] = LatticePart::kFreeCap;
      }
    }
    field_.stationLevels = quantileLevels(field_);
    traceStations();
  }

  [[nodiscard]] std::pair<std::size_t, std::size_t> wholePart() const { return {0, stations_.size() - 1}; }

  /// First and last station of the longest part on which the centres advance. Where a level line runs up and
  /// down several fingers its centre turns back instead.
  [[nodiscard]] std::pair<std::size_t, std::size_t> unbranchedPart(const std::vector<double>& way) const {
    std::pair<std::size_t, std::size_t> best{0, 0};
    for (std::size_t first = 0; first < stations_.size(); ++first) {
      std::size_t last = first;
      while (last + 1 < stations_.size() && advances(last, way)) {
        ++last;
      }
      if (way[last] - way[first] > way[best.second] - way[best.first]) {
        best = {first, last};
      }
      first = last;
    }
    // Shortly before it branches, the organ is no longer a tube.
    auto [from, to] = best;
    while (best.first > 0 && from < to &&
           way[from] - way[best.first] < kBeforeBranch * stations_[best.first].radius_m) {
      ++from;
    }
    while (best.second + 1 < stations_.size() && from < to &&
           way[best.second] - way[to] < kBeforeBranch * stations_[best.second].radius_m) {
      --to;
    }
    return from < to ? std::pair{from, to} : wholePart();
  }

  /// True when the centre a stride further on lies ahead of this one.
  [[nodiscard]] bool advances(std::size_t k, const std::vector<double>& way) const {
    const auto further =
        std::lower_bound(way.begin(), way.end() - 1, way[k] + kStride * stations_[k].radius_m);
    const auto next = static_cast<std::size_t>(further - way.begin());
    return dot(stations_[next].centre_m - stations_[k].centre_m, stations_[k].normal) >= 0.0;
  }

  [[nodiscard]] double meanEdge_m() const {
    double total = 0.0;
    for (std::uint32_t half = 0; half < field_.topology.halfEdges(); ++half) {
      total += norm(field_.mesh.vertices_m[field_.topology.target(half)] -
                    field_.mesh.vertices_m[field_.topology.origin(half)]);
    }
    return total / field_.topology.halfEdges();
  }

  void traceStations() {
    stations_.clear();
    field_.stationWays.clear();
    allStarShaped_ = true;
    const LevelTracer tracer(field_.mesh, field_.topology, field_.harmonic);
    tracer.traceAll(field_.stationLevels, [this](std::size_t k, std::vector<LevelLoop> loops) {
      const LevelLoop loop = stationLoop(k, std::move(loops));
      stations_.push_back(
          {loop.centroid_m, std::sqrt(norm(loop.areaVector_m2) / kPi), normalized(loop.areaVector_m2)});
      field_.stationWays.push_back(wayAtAngles(loop, kWaySteps));
      if (allStarShaped_) {
        const Vec3 along = normalized(loop.areaVector_m2);
        const Vec3 across = anyPerpendicular(along);
        allStarShaped_ = isStarShaped(loop, {loop.centroid_m, along, across, cross(along, across)});
      }
    });
  }

  void findStarts() {
    std::vector<double>& starts = field_.stationStarts;
    const auto add = [&starts](double share) {
      starts.push_back(starts.empty() ? share : share + std::round(starts.back() - share));
    };
    if (!field_.rule.alongE1) {
      for (const std::vector<double>& ways : field_.stationWays) {
        add(shareAtAngle(ways, field_.rule.anchor_rad));
      }
      return;
    }
    const LevelTracer tracer(field_.mesh, field_.topology, field_.harmonic);
    tracer.traceAll(field_.stationLevels, [&](std::size_t k, std::vector<LevelLoop> loops) {
      const LevelLoop loop = stationLoop(k, std::move(loops));
      add(shareOfWay(loop, exitAlongE1(loop, field_.centreline.frameAt(field_.stationArcs_m[k])).way_m));
    });
  }

  /// Every plane that becomes a section gives one loop. Looked at first: what follows needs a tube.
  void requireWholeSections(const std::vector<double>& levels, double length_m) const {
    HarmonicField heights;
    heights.level = levels;
    heights.angle_rad.assign(levels.size(), 0.0);
    heights.turns.assign(field_.topology.halfEdges(), 0);
    std::vector<double> planes;
    planes.reserve(static_cast<std::size_t>(options_.sections));
    for (int j = 0; j < options_.sections; ++j) {
      planes.push_back(static_cast<double>(j) / (options_.sections - 1));
    }
    const LevelTracer tracer(field_.mesh, field_.topology, heights);
    tracer.traceAll(planes, [&](std::size_t j, std::vector<LevelLoop> loops) {
      theOneLoop(std::move(loops), field_.mode,
                 sectionName(static_cast<int>(j), options_.sections, planes[j] * length_m));
    });
  }

  LevelLoop stationLoop(std::size_t k, std::vector<LevelLoop> loops) const {
    return organLoop(std::move(loops), field_.mode,
                     "level " + std::to_string(field_.stationLevels[k]) + " of the harmonic field");
  }

  struct Turn {
    double angle_rad = 0.0;
    double radius_m = 0.0;  ///< of the section; the turn is taken over this length
    double arc_m = 0.0;
  };

  [[nodiscard]] Turn sharpestTurn() const {
    const Centreline& line = field_.centreline;
    Turn sharpest;
    for (std::size_t k = 0; k < stations_.size(); ++k) {
      const double arc = field_.stationArcs_m[k];
      const double half = 0.5 * stations_[k].radius_m;
      const Vec3 before = line.frameAt(arc - half).tangent;
      const Vec3 after = line.frameAt(arc + half).tangent;
      const double turn = portableAtan2(norm(cross(before, after)), dot(before, after));
      if (turn > sharpest.angle_rad) {
        sharpest = {turn, 2.0 * half, arc};
      }
    }
    return sharpest;
  }

  [[noreturn]] static void refuseKink(const Turn& turn) {
    throw Error(
        ErrorCode::kBadMesh,
        Text::tr("the centreline has a kink: it turns by %1 within one radius (%2) of the organ, %3 from "
                 "the fixed end; at most %4 are allowed",
                 inDegrees(turn.angle_rad), millimetres(turn.radius_m), millimetres(turn.arc_m),
                 inDegrees(kSharpestTurn_rad)),
        "",
        Text::tr("Move the end points so that the axis follows the organ, or cut the organ at the kink."));
  }

  LatticeField field_;
  LatticeOptions options_;
  std::vector<Station> stations_;
  bool allStarShaped_ = true;
};

}  // namespace

double LatticeField::arcAtLevel_m(double level) const {
  return interpolate(stationLevels, stationArcs_m, level);
}

double LatticeField::levelAtArc(double arc_m) const {
  return interpolate(stationArcs_m, stationLevels, arc_m);
}

double LatticeField::ridgeAngle_rad(double level, double angle_rad) const {
  const auto after = std::upper_bound(stationLevels.begin() + 1, stationLevels.end() - 1, level);
  const auto k = static_cast<std::size_t>(after - stationLevels.begin());
  const double step = stationLevels[k] - stationLevels[k - 1];
  const double share = std::clamp((level - stationLevels[k - 1]) / step, 0.0, 1.0);
  const auto blend = [share](double from, double to) { return from + share * (to - from); };
  const double way =
      blend(shareAtAngle(stationWays[k - 1], angle_rad), shareAtAngle(stationWays[k], angle_rad)) -
      blend(stationStarts[k - 1], stationStarts[k]);
  const double turn = way - std::floor(way);
  constexpr double kRounded = 1e-12;  // a point on ridge 0 has the angle 0, not almost 2 pi
  return turn > 1.0 - kRounded ? 0.0 : 2.0 * kPi * turn;
}

LevelLoop LatticeField::loopAt(double arc_m, const std::string& name) const {
  const double level = levelAtArc(arc_m);
  const LevelTracer tracer(mesh, topology, harmonic);
  return theOneLoop(tracer.trace(level, level >= 1.0), mode, name);
}

LevelLoop theOneLoop(std::vector<LevelLoop> loops, LatticeMode mode, const std::string& name) {
  const bool straight = mode == LatticeMode::kStraightAxis;
  const Phrase remedy =
      straight ? Text::tr("Use the harmonic mode, or move the end points off branches and fingers.")
               : Text::tr("Check the mesh for thin spikes, or give other end points.");
  if (loops.empty()) {
    throw Error(ErrorCode::kBadMesh, Text::tr("the section does not meet the organ"), name, remedy);
  }
  const auto real = std::count_if(loops.begin(), loops.end(), [&](const LevelLoop& loop) {
    return loop.perimeter_m > kSpeck * loops.front().perimeter_m;
  });
  if (real != 1) {
    throw Error(
        ErrorCode::kBadMesh,
        Text::tr("the section cuts the organ in %1 loops, exactly one is needed", std::to_string(real)), name,
        remedy);
  }
  return std::move(loops.front());
}

LevelLoop organLoop(std::vector<LevelLoop> loops, LatticeMode mode, const std::string& name) {
  if (mode == LatticeMode::kStraightAxis && !loops.empty()) {
    return std::move(loops.front());
  }
  return theOneLoop(std::move(loops), mode, name);
}

std::string placeName(double arc_m) {
  return "the section " + millimetres(arc_m) + " from the fixed end";
}

std::string sectionName(int j, int sections, double arc_m) {
  return "section " + std::to_string(j + 1) + " of " + std::to_string(sections) + " (" + millimetres(arc_m) +
         " from the fixed end)";
}

LatticeField buildLatticeField(const TriangleMesh& mesh, const LatticeOptions& options) {
  return FieldBuilder(mesh, options).build();
}

}  // namespace torsio
