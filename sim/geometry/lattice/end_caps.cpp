// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/lattice/end_caps.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "sim/core/error.h"
#include "sim/core/portable_math.h"
#include "sim/core/short_number.h"
#include "sim/geometry/lattice/level_loops.h"
#include "sim/geometry/mesh/flat_faces.h"

namespace torsio {

namespace {

using Index = std::uint32_t;

constexpr double kCone = 0.86602540;  // cosine of 30 degrees
constexpr int kRounds = 8;            // of finding the axis; it settles within four
constexpr double kNear = 0.8;         // local radii below the outermost point: the two sections whose
constexpr double kFar = 1.8;          // centroids give the axis
constexpr double kReach = 3.0;        // local radii along the surface that belong to the end
constexpr double kWidth = 1.4;        // local radii from the axis that the tip may reach
constexpr double kWander = 1.5;       // local radii: an axis further from the seed has left the end

/// A planar section through the end.
struct EndSection {
  Vec3 centroid_m;
  double radius_m = 0.0;  ///< of the circle with its area
};

struct EndAxis {
  Vec3 point_m;
  Vec3 direction;  ///< outwards
  double radius_m = 0.0;
};

class OrganEnd {
 public:
  OrganEnd(const TriangleMesh& mesh, const SurfaceTopology& topology, Index seed)
      : mesh_(mesh),
        topology_(topology),
        fromSeed_m_(edgeDistances_m(mesh, topology, {&seed, 1})),
        seed_m_(mesh.vertices_m[seed]) {
    heights_.angle_rad.assign(mesh.vertices_m.size(), 0.0);
    heights_.turns.assign(topology.halfEdges(), 0);
  }

  /// The axis at the end, or nothing when a plane misses the organ.
  std::optional<EndAxis> findAxis(double meanRadius_m) {
    EndAxis axis{seed_m_, normalized(seed_m_ - middleWithin(2.0 * meanRadius_m)), meanRadius_m};
    for (int round = 0; round < kRounds; ++round) {
      heights_.level.clear();
      double top = dot(seed_m_, axis.direction);
      for (std::size_t v = 0; v < mesh_.vertices_m.size(); ++v) {
        heights_.level.push_back(dot(mesh_.vertices_m[v], axis.direction));
        if (fromSeed_m_[v] < kReach * axis.radius_m) {
          top = std::max(top, heights_.level.back());
        }
      }
      const std::optional<EndSection> near = section(top - kNear * axis.radius_m, axis.point_m);
      const std::optional<EndSection> far = section(top - kFar * axis.radius_m, axis.point_m);
      if (!near || !far) {
        return std::nullopt;
      }
      const Vec3 along = near->centroid_m - far->centroid_m;
      if (!(norm(along) > 0.0)) {
        return std::nullopt;
      }
      axis = {near->centroid_m, normalized(along), std::min(far->radius_m, meanRadius_m)};
    }
    const Vec3 aside = seed_m_ - axis.point_m;
    const double way = norm(aside - dot(aside, axis.direction) * axis.direction);
    return way < kWander * axis.radius_m ? std::optional(axis) : std::nullopt;
  }

  /// Through the seed, along the surface normals about it: for a dome that has no axis of its own.
  EndAxis axisAtSeed(double meanRadius_m) const {
    const std::vector<Vec3> normals = vertexNormals(mesh_);
    Vec3 sum;
    for (std::size_t v = 0; v < fromSeed_m_.size(); ++v) {
      if (fromSeed_m_[v] <= 0.5 * meanRadius_m) {
        sum += normals[v];
      }
    }
    const Vec3 direction = normalized(sum);
    return {seed_m_ - meanRadius_m * direction, direction, meanRadius_m};
  }

  std::vector<Index> tip(const EndAxis& axis) const {
    const std::vector<Vec3> normals = vertexNormals(mesh_);
    std::vector<std::uint8_t> open(mesh_.vertices_m.size(), 0);
    Index start = 0;
    double highest = -1.0;
    for (Index v = 0; v < open.size(); ++v) {
      const Vec3 from = mesh_.vertices_m[v] - axis.point_m;
      const double height = dot(from, axis.direction);
      const double aside = norm(from - height * axis.direction);
      if (fromSeed_m_[v] > kReach * axis.radius_m || aside > kWidth * axis.radius_m) {
        continue;
      }
      if (height < 0.0 || dot(normals[v], axis.direction) < kCone) {
        continue;
      }
      open[v] = 1;
      if (height > highest) {
        highest = height;
        start = v;
      }
    }
    return takeConnected(topology_, open, start);
  }

 private:
  /// Mean of the vertices within a way from the seed.
  Vec3 middleWithin(double way_m) const {
    Vec3 sum;
    double count = 0.0;
    for (std::size_t v = 0; v < fromSeed_m_.size(); ++v) {
      if (fromSeed_m_[v] > way_m) {
        continue;
      }
      sum += mesh_.vertices_m[v];
      count += 1.0;
    }
    return sum / count;
  }

  /// The loop at a height whose centroid lies nearest to `point_m`.
  std::optional<EndSection> section(double height, const Vec3& point_m) const {
    const LevelTracer tracer(mesh_, topology_, heights_);
    std::optional<EndSection> best;
    for (const LevelLoop& loop : tracer.trace(height)) {
      const double radius = std::sqrt(norm(loop.areaVector_m2) / kPi);
      if (best && norm(loop.centroid_m - point_m) >= norm(best->centroid_m - point_m)) {
        continue;
      }
      best = EndSection{loop.centroid_m, radius};
    }
    return best;
  }

  const TriangleMesh& mesh_;
  const SurfaceTopology& topology_;
  std::vector<double> fromSeed_m_;
  Vec3 seed_m_;
  HarmonicField heights_;  // only the levels mean something
};

constexpr double kCapShare = 0.3;   // radius of a disc as a share of the organ's mean radius
constexpr double kFarEnough = 0.3;  // a flat end keeps this share of the organ's length from the other
constexpr double kAtTip = 0.95;     // a flat end reaches this share of the largest distance
constexpr double kNearTip = 0.75;   // or this one, when it is as large as an end
constexpr double kOfSection = 0.3;  // of the organ's mean section
constexpr Phrase kGiveEnds = Text::tr("Give two end points further apart, or a smaller cap radius.");

struct Cap {
  std::vector<Index> vertices;
  Vec3 centre_m;
  bool flat = false;
};

class CapFinder {
 public:
  CapFinder(const TriangleMesh& mesh, const SurfaceTopology& topology, const CapRequest& request)
      : mesh_(mesh), topology_(topology), request_(request), faces_(findFlatFaces(mesh, topology)) {
    faceOfTriangle_.assign(mesh.triangles.size(), kNoFace);
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      for (const Index t : faces_[f].triangles) {
        faceOfTriangle_[t] = static_cast<Index>(f);
      }
    }
  }

  EndCaps find() {
    auto [fixed, free] = request_.automatic() ? automatic() : given();
    EndCaps caps;
    caps.fixedCentre_m = fixed.centre_m;
    caps.freeCentre_m = free.centre_m;
    caps.fixedFlat = fixed.flat;
    caps.freeFlat = free.flat;
    caps.parts.assign(mesh_.vertices_m.size(), LatticePart::kSide);
    for (const Index v : fixed.vertices) {
      caps.parts[v] = LatticePart::kFixedCap;
    }
    for (const Index v : free.vertices) {
      if (caps.parts[v] == LatticePart::kFixedCap) {
        throw Error(ErrorCode::kBadMesh, Text::tr("the end caps of the organ touch"), "", kGiveEnds);
      }
      caps.parts[v] = LatticePart::kFreeCap;
    }
    fillHoles(caps.parts, LatticePart::kFixedCap, free.vertices.front());
    fillHoles(caps.parts, LatticePart::kFreeCap, fixed.vertices.front());
    return caps;
  }

 private:
  static constexpr Index kNoFace = ~Index{0};

  std::pair<Cap, Cap> given() {
    const Index fixedTriangle = nearestTriangle(mesh_, request_.fixedEnd_m);
    const Index freeTriangle = nearestTriangle(mesh_, request_.freeEnd_m);
    const Index fixedSeed = nearestCorner(fixedTriangle, request_.fixedEnd_m);
    const Index freeSeed = nearestCorner(freeTriangle, request_.freeEnd_m);
    const std::vector<double> fromFixed = distances({&fixedSeed, 1});
    const std::vector<double> fromFree = distances({&freeSeed, 1});
    setMeanRadius(fromFixed[freeSeed]);
    Cap fixed = request_.fixedCut != Vec3{} ? beyond(request_.fixedEnd_m, request_.fixedCut, "fixed")
                                            : faceOrTip(faceOfTriangle_[fixedTriangle], fromFree, fixedSeed);
    Cap free = request_.freeCut != Vec3{} ? beyond(request_.freeEnd_m, request_.freeCut, "free")
                                          : faceOrTip(faceOfTriangle_[freeTriangle], fromFixed, freeSeed);
    return {std::move(fixed), std::move(free)};
  }

  /// The two points farthest from each other along the surface (double sweep), each with the flat face at it.
  std::pair<Cap, Cap> automatic() {
    const Index start = mesh_.triangles.front().front();
    const Index first = farthest(distances({&start, 1}));
    const std::vector<double> fromFirst = distances({&first, 1});
    const Index second = farthest(fromFirst);
    setMeanRadius(fromFirst[second]);
    Cap one = faceOrTip(bestFace(fromFirst, second), fromFirst, second);
    const std::vector<double> fromOne = distances(one.vertices);
    const Index other = farthest(fromOne);
    Cap two = faceOrTip(bestFace(fromOne, other), fromOne, other);
    if (isLower(two.centre_m, one.centre_m, norm(two.centre_m - one.centre_m))) {
      std::swap(one, two);
    }
    return {std::move(one), std::move(two)};
  }

  std::vector<double> distances(std::span<const Index> sources) const {
    return edgeDistances_m(mesh_, topology_, sources);
  }

  /// The farthest vertex that can be reached.
  static Index farthest(const std::vector<double>& distance) {
    Index best = 0;
    double most = -1.0;
    for (Index v = 0; v < distance.size(); ++v) {
      if (std::isfinite(distance[v]) && distance[v] > most) {
        most = distance[v];
        best = v;
      }
    }
    return best;
  }

  Index nearestCorner(Index triangle, const Vec3& point) const {
    const TriangleMesh::Triangle& corners = mesh_.triangles[triangle];
    return *std::min_element(corners.begin(), corners.end(), [&](Index a, Index b) {
      return norm(mesh_.vertices_m[a] - point) < norm(mesh_.vertices_m[b] - point);
    });
  }

  double nearest(const FlatFace& face, const std::vector<double>& distance) const {
    double least = distance[face.vertices.front()];
    for (const Index v : face.vertices) {
      least = std::min(least, distance[v]);
    }
    return least;
  }

  /// The flat face at the extreme end `tip` that keeps farthest from the other end: the end of a bar, never
  /// one of its sides, and no flat spot halfway. Ways lead across the end of a bent bar, too, and then the
  /// largest distance lies beside it.
  Index bestFace(const std::vector<double>& fromOther, Index tip) const {
    const Index at = faceNear(fromOther, kAtTip * fromOther[tip], 0.0);
    return at != kNoFace ? at
                         : faceNear(fromOther, kNearTip * fromOther[tip],
                                    kOfSection * kPi * meanRadius_m_ * meanRadius_m_);
  }

  /// Of the flat faces that reach so far from the other end and are so large, the one that keeps farthest.
  Index faceNear(const std::vector<double>& fromOther, double reach_m, double area_m2) const {
    Index best = kNoFace;
    double most = 0.0;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const double least = nearest(faces_[f], fromOther);
      const bool atTip = std::any_of(faces_[f].vertices.begin(), faces_[f].vertices.end(),
                                     [&](Index v) { return fromOther[v] >= reach_m; });
      if (atTip && least > most && faces_[f].area_m2 >= area_m2) {
        most = least;
        best = static_cast<Index>(f);
      }
    }
    return best;
  }

  Cap faceOrTip(Index face, const std::vector<double>& fromOther, Index seed) const {
    const double length = fromOther[seed];
    if (face != kNoFace && nearest(faces_[face], fromOther) >= kFarEnough * length) {
      return {faces_[face].vertices, faces_[face].centroid_m, true};
    }
    if (!(request_.capRadius_m > 0.0)) {
      Cap tip{roundedEnd(mesh_, topology_, seed, meanRadius_m_), {}, false};
      for (const Index v : tip.vertices) {
        tip.centre_m += mesh_.vertices_m[v] / static_cast<double>(tip.vertices.size());
      }
      if (!tip.vertices.empty()) {
        return tip;
      }
    }
    return disc(seed);
  }

  Cap disc(Index seed) const {
    Cap disc{{seed}, mesh_.vertices_m[seed], false};
    const std::vector<double> fromSeed = distances({&seed, 1});
    const double radius = request_.capRadius_m > 0.0 ? request_.capRadius_m : kCapShare * meanRadius_m_;
    for (Index v = 0; v < fromSeed.size(); ++v) {
      if (v != seed && fromSeed[v] <= radius) {
        disc.vertices.push_back(v);
      }
    }
    for (const Index half : topology_.outgoing(seed)) {
      const Index v = topology_.target(half);
      if (fromSeed[v] > radius) {
        disc.vertices.push_back(v);
      }
    }
    return disc;
  }

  /// Everything beyond the plane through `point` with the outward direction `cut`: its largest piece.
  Cap beyond(const Vec3& point, const Vec3& cut, const std::string& name) const {
    const Vec3 direction = normalized(cut);
    std::vector<std::uint8_t> open(mesh_.vertices_m.size(), 0);
    for (Index v = 0; v < open.size(); ++v) {
      open[v] = dot(mesh_.vertices_m[v] - point, direction) >= 0.0 ? 1 : 0;
    }
    Cap largest{{}, point, false};
    for (Index v = 0; v < open.size(); ++v) {
      std::vector<Index> piece = takeConnected(topology_, open, v);
      if (piece.size() > largest.vertices.size()) {
        largest.vertices = std::move(piece);
      }
    }
    if (largest.vertices.empty()) {
      throw Error(ErrorCode::kBadParameter,
                  Text::tr("nothing of the organ lies beyond the cut at its %1 end", name),
                  Text::tr("%1 end", name),
                  Text::tr("Move the end point into the organ or turn the direction of the cut."));
    }
    return largest;
  }

  /// What `cap` cuts off from the other end belongs to it.
  void fillHoles(std::vector<LatticePart>& parts, LatticePart cap, Index otherEnd) const {
    std::vector<std::uint8_t> open(parts.size(), 0);
    for (Index v = 0; v < parts.size(); ++v) {
      open[v] = parts[v] != cap ? 1 : 0;
    }
    static_cast<void>(takeConnected(topology_, open, otherEnd));
    for (Index v = 0; v < parts.size(); ++v) {
      if (open[v] != 0) {
        parts[v] = cap;
      }
    }
  }

  /// Radius of the round bar with the organ's volume and length.
  void setMeanRadius(double length_m) {
    if (!(length_m > 0.0) || !std::isfinite(length_m)) {
      throw Error(ErrorCode::kBadMesh, Text::tr("the two ends of the organ are not connected or coincide"),
                  "", kGiveEnds);
    }
    meanRadius_m_ = std::sqrt(std::abs(signedVolume_m3(mesh_)) / (kPi * length_m));
  }

  const TriangleMesh& mesh_;
  const SurfaceTopology& topology_;
  const CapRequest& request_;
  std::vector<FlatFace> faces_;
  std::vector<Index> faceOfTriangle_;
  double meanRadius_m_ = 0.0;
};

}  // namespace

std::vector<Index> roundedEnd(const TriangleMesh& mesh, const SurfaceTopology& topology, Index seed,
                              double meanRadius_m) {
  OrganEnd end(mesh, topology, seed);
  const std::optional<EndAxis> axis = end.findAxis(meanRadius_m);
  std::vector<Index> tip = end.tip(axis ? *axis : end.axisAtSeed(meanRadius_m));
  constexpr std::size_t kFewest = 4;
  return tip.size() < kFewest ? std::vector<Index>{} : tip;
}

EndCaps findEndCaps(const TriangleMesh& mesh, const SurfaceTopology& topology, const CapRequest& request) {
  checkCapRequest(request);
  return CapFinder(mesh, topology, request).find();
}

bool isLower(const Vec3& a, const Vec3& b, double scale_m) noexcept {
  const double tolerance = 1e-6 * scale_m;
  if (std::abs(a.z - b.z) > tolerance) {
    return a.z < b.z;
  }
  if (std::abs(a.y - b.y) > tolerance) {
    return a.y < b.y;
  }
  return a.x < b.x;
}

void checkCapRequest(const CapRequest& request) {
  if (!isFinite(request.fixedEnd_m) || !isFinite(request.freeEnd_m) || !isFinite(request.fixedCut) ||
      !isFinite(request.freeCut)) {
    throw Error(ErrorCode::kBadParameter,
                Text::tr("an end point or cut direction of the organ is not finite"), "",
                Text::tr("Give finite numbers."));
  }
  if (!std::isfinite(request.capRadius_m) || request.capRadius_m < 0.0) {
    throw Error(
        ErrorCode::kBadParameter,
        Text::tr("the cap radius %1 mm is negative or not finite", shortNumber(1000.0 * request.capRadius_m)),
        "", Text::tr("Give 0 for the default or a positive length."));
  }
  if (request.automatic() && (request.fixedCut != Vec3{} || request.freeCut != Vec3{})) {
    throw Error(ErrorCode::kBadParameter, Text::tr("a cut needs both end points"), "",
                Text::tr("Give the two end points."));
  }
}

}  // namespace torsio
