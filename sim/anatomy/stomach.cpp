// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/anatomy/stomach.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "sim/anatomy/curves.h"
#include "sim/anatomy/remesh.h"
#include "sim/anatomy/round_cone.h"
#include "sim/anatomy/tube.h"
#include "sim/core/angle.h"
#include "sim/core/portable_math.h"
#include "sim/geometry/mesh/mesh_check.h"
#include "sim/geometry/query/collision_mesh.h"

namespace torsio {

namespace {

// Gentle waves that no two places share: amplitude, periods along the organ and around it, phases.
struct Wave {
  double amplitude_mm;
  double along;
  double around;
  double phaseAlong;
  double phaseAround;
};

// Fades in over the first and out over the last tenth, so that the ends stay round.
double fade(double share) {
  const double edge = share < 0.5 ? share : 1.0 - share;
  constexpr double kWidth = 0.1;
  const double t = edge < kWidth ? edge / kWidth : 1.0;
  return t * t * (3.0 - 2.0 * t);
}

template <std::size_t N>
double wavesAt(const std::array<Wave, N>& waves, double share, double angle_rad) {
  double sum = 0.0;
  for (const Wave& w : waves) {
    sum += w.amplitude_mm * portableSinCos(2.0 * kPi * w.along * share + w.phaseAlong).sin *
           portableSinCos(w.around * angle_rad + w.phaseAround).cos;
  }
  return fade(share) * sum;
}

// Interpolated squares of the half-widths round the fundus off like a paraboloid, not like a cone.
std::vector<double> squares(std::vector<double> values) {
  for (double& v : values) {
    v *= v;
  }
  return values;
}

TriangleMesh inMetres(TriangleMesh mesh) {
  for (Vec3& v : mesh.vertices_m) {
    v *= kMillimetre_m;
  }
  return mesh;
}

TubeOrgan intestineOf(double edge_mm) {
  // A loop in the frontal plane, slightly out of it, 200 mm long; mm, LPS.
  const SplineCurve centreline(
      {{-84, 0, 0}, {-61, 3, 26}, {-30.5, 4, 40}, {0, 2, 44.5}, {30.5, -2, 40}, {61, -5, 26}, {84, -4, 0}});
  constexpr double kRadius_mm = 13.0;
  constexpr double kWaveHeight_mm = 0.9;
  constexpr double kWaves = 10.0;  // circular folds seen from outside, 20 mm apart
  constexpr std::array<Wave, 3> kUneven{
      {{0.35, 1.5, 1.0, 0.4, 0.7}, {0.30, 2.5, 2.0, 2.2, 1.9}, {0.20, 4.0, 3.0, 3.1, 4.4}}};
  constexpr std::size_t kRings = 180;
  constexpr std::size_t kAround = 64;
  constexpr Domes kDomes{.first = 0.35, .last = 0.35};

  const std::vector<CurveFrame> frames = framesAlong(centreline, kRings, {0, -1, 0});
  const auto size = [](double) { return SectionSize{kRadius_mm, 0.94 * kRadius_mm}; };
  const auto bump = [&kUneven](double share, double angle) {
    const double folds = kWaveHeight_mm * portableSinCos(2.0 * kPi * kWaves * share).cos;
    return fade(share) * folds + wavesAt(kUneven, share, angle);
  };
  constexpr double kAntimesenteric_deg = 270.0;  // of e1, which points to the front: the outside of the bend
  return organAlong(closedTube(frames, kAround, kDomes, size, bump), edge_mm, frames,
                    {{"first foot, antimesenteric border", 0.08, 0.0},
                     {"first foot, mesenteric border", 0.08, 180.0},
                     {"first limb, antimesenteric border", 0.28, 0.0},
                     {"first limb, mesenteric border", 0.28, 180.0},
                     {"top, antimesenteric border", 0.5, 0.0},
                     {"top, mesenteric border", 0.5, 180.0},
                     {"second limb, antimesenteric border", 0.72, 0.0},
                     {"second limb, mesenteric border", 0.72, 180.0},
                     {"second foot, antimesenteric border", 0.92, 0.0},
                     {"second foot, mesenteric border", 0.92, 180.0}},
                    kAntimesenteric_deg);
}

constexpr std::size_t kStomachRings = 200;
constexpr std::size_t kStomachAround = 112;
constexpr double kPylorus_mm = 266.5;  // from the top of the fundus along the centreline
constexpr double kIncisura_mm = 170.0;
constexpr double kCardia_mm = 53.0;

/// Top of the fundus first, through the pylorus at (-47, 4, -68) into the bulb; mm, LPS.
SplineCurve stomachCentreline() {
  return SplineCurve({{50, 30, 72},
                      {60, 22, 45},
                      {66, 10, 12},
                      {64, -4, -24},
                      {52, -16, -58},
                      {27, -23, -82},
                      {-4, -21, -90},
                      {-30, -10, -82},
                      {-47, 4, -68},
                      {-53, 10, -61.5},
                      {-58.5, 16, -54.5}});
}

/// 1 at the middle of a band, 0 from its edge on.
double hump(double away, double halfWidth) {
  const double t = std::min(std::abs(away) / halfWidth, 1.0);
  return (1.0 - t * t) * (1.0 - t * t);
}

/// Fundus, body, antrum, pylorus and bulb as one tube, without the oesophagus; mm.
TriangleMesh stomachTube(const std::vector<CurveFrame>& frames) {
  const double length = frames.back().arc;
  // Fundus, body from 43, incisura at 170, antrum, pylorus at 266, bulb. Squares round the top of the fundus
  // off like a paraboloid.
  const std::vector<double> at{0,   8,   21,  43,  72,    107,   147, 168, 192,
                               219, 240, 252, 260, 266.0, 271.0, 278, 283, length};
  std::vector<double> half{3,    19.5, 32,   39.5, 42,   39.5, 33.2, 29.5, 27,
                           22.6, 17.2, 14.2, 12.6, 11.6, 12.2, 14.5, 14.5, 11.5};
  for (double& h : half) {
    h *= h;
  }
  const MonotoneCurve halfWidth2(at, std::move(half));
  const MonotoneCurve depthRatio({0, 27, 80, 133, 173, 227, 267, length},
                                 {.95, .82, .72, .80, .92, .92, 1.0, 1.0});
  constexpr Domes kDomes{.first = 0.07, .last = 0.6};
  const auto size = [&](double share) {
    const double h = std::sqrt(halfWidth2(length * share));
    return SectionSize{h, h * depthRatio(length * share)};
  };
  const auto incisura = [&](double share, double angle_rad) {
    constexpr double kDepth_mm = 4.0;
    constexpr double kLong_mm = 36.0;
    constexpr double kBroad_rad = 1.1;
    return -kDepth_mm * hump(length * share - kIncisura_mm, kLong_mm) * hump(angle_rad - kPi, kBroad_rad);
  };
  return closedTube(frames, kStomachAround, kDomes, size, incisura);
}

/// The outer surface as one implicit body; mm.
class StomachShape {
 public:
  StomachShape()
      : frames_(framesAlong(stomachCentreline(), kStomachRings, {1, 0, 0})), tube_(stomachTube(frames_)) {}

  /// About the distance to the surface, negative inside.
  double operator()(const Vec3& p) const {
    constexpr double kShoulder = 9.0;  // where the oesophagus opens
    constexpr double kAlong = 4.0;
    return joined(tube_.closest(p).distance_m, joinedChain(oesophagus_, p, kAlong), kShoulder);
  }

  [[nodiscard]] const std::vector<CurveFrame>& frames() const { return frames_; }
  [[nodiscard]] const std::vector<RoundCone>& oesophagus() const { return oesophagus_; }

  /// Frame at a way from the pylorus towards the fundus.
  [[nodiscard]] const CurveFrame& frameAt(double arc_mm) const {
    const double place =
        (kPylorus_mm - arc_mm) / frames_.back().arc * static_cast<double>(frames_.size() - 1);
    const double last = static_cast<double>(frames_.size() - 1);
    return frames_[static_cast<std::size_t>(std::lround(std::clamp(place, 0.0, last)))];
  }

  [[nodiscard]] const CurveFrame& nearestTo(const Vec3& p) const {
    return *std::min_element(frames_.begin(), frames_.end(), [&p](const CurveFrame& a, const CurveFrame& b) {
      return dot(p - a.centre, p - a.centre) < dot(p - b.centre, p - b.centre);
    });
  }

  /// The outer surface at a way from the pylorus and an angle about it.
  [[nodiscard]] Vec3 surfaceAt(double arc_mm, double angle_deg) const {
    const CurveFrame& frame = frameAt(arc_mm);
    const SinCos a = portableSinCos(kPi - radians(angle_deg));  // the frame runs the other way round
    const Vec3 outwards = a.cos * frame.e1 + a.sin * frame.e2;
    double outside = 1.0;  // the first surface met: behind it the oesophagus may lie
    while ((*this)(frame.centre + outside * outwards) < 0.0) {
      outside += 1.0;
    }
    double inside = outside - 1.0;
    for (int i = 0; i < 40; ++i) {
      const double r = 0.5 * (inside + outside);
      ((*this)(frame.centre + r * outwards) < 0.0 ? inside : outside) = r;
    }
    return frame.centre + inside * outwards;
  }

 private:
  std::vector<CurveFrame> frames_;
  CollisionMesh tube_;
  std::vector<RoundCone> oesophagus_{{{36, 19, 30}, {22, 18, 43}, 11.0, 10.8},
                                     {{22, 18, 43}, {2, 19, 72}, 10.8, 9.8}};
};

TriangleMesh fineStomach(const StomachShape& shape) {
  constexpr double kFineVoxel_mm = 1.9;
  constexpr double kFineSlope = 1.2;
  SampleGrid grid;
  grid.step = kFineVoxel_mm;
  grid.origin = {-82.3, -62.1, -122.7};
  const Vec3 extent{205, 130, 214};
  const auto points = [](double length) { return static_cast<std::size_t>(length / kFineVoxel_mm) + 2; };
  grid.count = {points(extent.x), points(extent.y), points(extent.z)};
  return zeroSurface(grid, kFineSlope, [&shape](const Vec3& p) { return shape(p); });
}

/// The same curve from its other end, e1 to the other side.
std::vector<CurveFrame> backwards(const std::vector<CurveFrame>& frames) {
  std::vector<CurveFrame> turned(frames.rbegin(), frames.rend());
  for (CurveFrame& frame : turned) {
    frame = {frames.back().arc - frame.arc, frame.centre, -frame.tangent, -frame.e1, frame.e2};
  }
  return turned;
}

OrganPlace placeAt(const StomachShape& shape, const char* name, double arc_mm, double angle_deg) {
  return {name, arc_mm, angle_deg, kMillimetre_m * shape.surfaceAt(arc_mm, angle_deg)};
}

/// The bottom of the notch between oesophagus and fundus, seen from above.
OrganPlace angleOfHis(const StomachShape& shape) {
  constexpr double kMiddle_mm = 20.0;  // from front to back
  constexpr double kStep_mm = 0.25;
  Vec3 notch{0.0, kMiddle_mm, 100.0};
  for (double x = 18.0; x <= 44.0; x += kStep_mm) {
    Vec3 p{x, kMiddle_mm, 95.0};
    while (shape(p) > 0.02) {
      p.z -= 0.5 * shape(p);
    }
    notch = p.z < notch.z ? p : notch;
  }
  const CurveFrame& nearest = shape.nearestTo(notch);
  const Vec3 from = notch - nearest.centre;
  const double angle_deg = degrees(portableAtan2(dot(from, nearest.e2), -dot(from, nearest.e1)));
  return {"angle of His", kPylorus_mm - nearest.arc, angle_deg < 0.0 ? angle_deg + 360.0 : angle_deg,
          kMillimetre_m * notch};
}

std::vector<Vec3> lineAlong(const StomachShape& shape, double from_mm, double to_mm, double angle_deg) {
  constexpr double kStep_mm = 10.0;
  const int steps = static_cast<int>(std::lround((to_mm - from_mm) / kStep_mm));
  std::vector<Vec3> line;
  for (int k = 0; k <= steps; ++k) {
    const double arc_mm = from_mm + (to_mm - from_mm) * k / steps;
    line.push_back(kMillimetre_m * shape.surfaceAt(arc_mm, angle_deg));
  }
  return line;
}

void placeAnatomy(const StomachShape& shape, WholeStomach& stomach) {
  constexpr double kLesser_deg = 0.0;
  constexpr double kFront_deg = 90.0;
  constexpr double kGreater_deg = 180.0;
  constexpr double kBack_deg = 270.0;
  constexpr double kBody_mm = kPylorus_mm - 107.0;
  constexpr double kAntrum_mm = 50.0;
  constexpr double kFundus_mm = kPylorus_mm - 30.0;
  constexpr double kBesideCardia_deg = 30.0;
  stomach.markers = {placeAt(shape, "pylorus, front", 0.0, kFront_deg),
                     placeAt(shape, "antrum, greater curvature", kAntrum_mm, kGreater_deg),
                     placeAt(shape, "antrum, front", kAntrum_mm, kFront_deg),
                     placeAt(shape, "incisura angularis", kPylorus_mm - kIncisura_mm, kLesser_deg),
                     placeAt(shape, "body, greater curvature", kBody_mm, kGreater_deg),
                     placeAt(shape, "body, front", kBody_mm, kFront_deg),
                     placeAt(shape, "body, back", kBody_mm, kBack_deg),
                     placeAt(shape, "body, lesser curvature", kBody_mm, kLesser_deg),
                     placeAt(shape, "cardia, front", kPylorus_mm - kCardia_mm, kBesideCardia_deg),
                     placeAt(shape, "fundus, greater curvature", kFundus_mm, kGreater_deg)};
  stomach.landmarks = {angleOfHis(shape), placeAt(shape, "antrum, back", kAntrum_mm, kBack_deg),
                       placeAt(shape, "fundus, front", kFundus_mm, kFront_deg),
                       placeAt(shape, "fundus, back", kFundus_mm, kBack_deg)};
  constexpr double kBesidePylorus_mm = 6.0;
  stomach.greaterOmentum_m = lineAlong(shape, kBesidePylorus_mm, kFundus_mm, kGreater_deg);
  stomach.lesserOmentum_m = lineAlong(shape, kBesidePylorus_mm, kPylorus_mm - kCardia_mm - 14.0, kLesser_deg);
  stomach.zeroLine_m = lineAlong(shape, 0.0, kFundus_mm, kLesser_deg);
}

}  // namespace

TubeOrgan makeStomach() {
  // Fundus first, pylorus last; mm, LPS.
  const SplineCurve centreline({{50, 30, 72},
                                {60, 22, 45},
                                {66, 10, 12},
                                {64, -4, -24},
                                {52, -16, -58},
                                {27, -23, -82},
                                {-4, -21, -90},
                                {-30, -10, -82},
                                {-47, 4, -68}});
  const std::vector<double> at{0, .03, .08, .16, .27, .40, .55, .70, .82, .92, 1};
  const MonotoneCurve halfWidth2(at, squares({3, 19, 31, 40, 44, 41, 34, 27.5, 23, 15.5, 10.5}));
  const MonotoneCurve depthRatio({0, .1, .3, .5, .65, .85, 1}, {.95, .82, .72, .80, .92, .85, .95});
  constexpr std::array<Wave, 6> kWaves{{{0.45, 2.0, 1.0, 0.3, 1.1},
                                        {0.35, 3.0, 2.0, 1.9, 0.2},
                                        {0.30, 4.0, 1.0, 4.2, 2.9},
                                        {0.25, 5.0, 3.0, 0.8, 5.1},
                                        {0.20, 7.0, 2.0, 2.4, 3.7},
                                        {0.15, 9.0, 3.0, 5.5, 0.9}}};
  constexpr std::size_t kRings = 180;
  constexpr std::size_t kAround = 112;
  constexpr Domes kDomes{.first = 0.07, .last = 0.4};  // the fundus is round already
  constexpr double kEdge_mm = 3.3;
  const Vec3 outwards{1, 0, 0};  // at the fundus the greater curvature lies to the left

  const std::vector<CurveFrame> frames = framesAlong(centreline, kRings, outwards);
  const auto size = [&halfWidth2, &depthRatio](double share) {
    const double half = std::sqrt(halfWidth2(share));
    return SectionSize{half, half * depthRatio(share)};
  };
  const auto bump = [&kWaves](double share, double angle) { return wavesAt(kWaves, share, angle); };
  const TriangleMesh fine = closedTube(frames, kAround, kDomes, size, bump);
  TubeOrgan organ;
  organ.surface = inMetres(remeshed(fine, [](const Vec3&) { return kEdge_mm; }));
  organ.fixedEnd_m = kMillimetre_m * frames.back().centre;
  organ.freeEnd_m = kMillimetre_m * frames.front().centre;
  organ.ridgeZero = -frames.back().e1;
  return organ;
}

TubeOrgan organAlong(const TriangleMesh& fine, double edge_mm, const std::vector<CurveFrame>& frames,
                     const std::vector<WantedPlace>& markers, double zero_deg) {
  TubeOrgan organ;
  const TriangleMesh surface = remeshed(fine, [edge_mm](const Vec3&) { return edge_mm; });
  organ.texture = textureAlong(surface, frames);
  organ.surface = inMetres(surface);
  organ.fixedEnd_m = kMillimetre_m * frames.front().centre;
  organ.freeEnd_m = kMillimetre_m * frames.back().centre;
  organ.ridgeZero = frames.front().e1;
  organ.length_mm = frames.back().arc;
  organ.places = placesOn(organ.surface, frames, zero_deg, markers);
  return organ;
}

TubeOrgan makeIntestine(double edges) {
  constexpr double kEdge_mm = 1.4;
  return intestineOf(edges * kEdge_mm);
}

TubeOrgan makeFormerIntestine() {
  return intestineOf(2.4);
}

WholeStomach makeWholeStomach(double edges) {
  constexpr double kEdge_mm = 2.4;
  const StomachShape shape;
  WholeStomach stomach;
  TriangleMesh& surface = stomach.organ.surface;
  surface = remeshed(fineStomach(shape), [edges](const Vec3&) { return edges * kEdge_mm; });
  stomach.organ.texture = textureAlong(surface, backwards(shape.frames()));
  for (Vec3& v : surface.vertices_m) {
    v *= kMillimetre_m;
  }
  const CurveFrame& pylorus = shape.frameAt(0.0);
  stomach.organ.fixedEnd_m = kMillimetre_m * pylorus.centre;
  stomach.organ.freeEnd_m = kMillimetre_m * shape.frames().front().centre;
  stomach.organ.ridgeZero = -pylorus.e1;
  stomach.length_mm = kPylorus_mm;
  const RoundCone& stub = shape.oesophagus().back();
  stomach.cardia_m = kMillimetre_m * stub.a;
  stomach.oesophagus = normalized(stub.b - stub.a);
  // Antrum 5.1 mm over its last 46 mm, body 2.0 mm (Pickhardt and Asher 2003, AJR 181:973).
  stomach.wall = {{0.0, 5.0}, {0.22, 5.0}, {0.38, 2.0}, {1.0, 2.0}};
  placeAnatomy(shape, stomach);
  return stomach;
}

}  // namespace torsio
