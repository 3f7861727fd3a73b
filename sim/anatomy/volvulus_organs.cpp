// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/anatomy/volvulus_organs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "sim/anatomy/curves.h"
#include "sim/anatomy/remesh.h"
#include "sim/anatomy/round_cone.h"
#include "sim/anatomy/tube.h"
#include "sim/core/angle.h"
#include "sim/core/portable_math.h"
#include "sim/geometry/query/collision_mesh.h"

namespace torsio {

namespace {

// 0 up to `low`, 1 from `high` on, smooth between.
double rise(double x, double low, double high) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// 1 at the middle of a band round the section, 0 from its edge on.
double band(double angle_rad, double middle_rad, double halfWidth_rad) {
  double away_rad = std::abs(angle_rad - middle_rad);
  away_rad = std::min(away_rad, 2.0 * kPi - away_rad);
  const double t = std::min(away_rad / halfWidth_rad, 1.0);
  return (1.0 - t * t) * (1.0 - t * t);
}

// Along a straight axis, close together where the organ's outline bends round its far end.
std::vector<CurveFrame> straightFrames(const Vec3& from, const Vec3& to, const Vec3& e1, std::size_t count) {
  const double length = norm(to - from);
  const Vec3 tangent = (to - from) / length;
  std::vector<CurveFrame> frames;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(count - 1);
    const double share = portableSinCos(0.5 * kPi * t).sin;
    frames.push_back({length * share, from + tangent * (length * share), tangent, e1, cross(tangent, e1)});
  }
  return frames;
}

// Squares of half-widths: an ellipse of half axis `half` between shares `begins` and 1 on a stalk.
double ellipseSquare(double share, double begins, double half) {
  const double middle = 0.5 * (begins + 1.0);
  const double u = (share - middle) / (1.0 - middle);
  return half * half * std::max(0.0, 1.0 - u * u);
}

// The rounded maximum of two squares of half-widths.
double roundedMaximum(double a, double b, double round) {
  const double h = std::max(round - std::abs(a - b), 0.0);
  return std::max(a, b) + h * h / (4.0 * round);
}

// How far the coils of small bowel stand back behind the outline of the pack at a point: tubes between the
// lines where a wave that meanders over the pack, with a few others, is 0.
double coils_mm(const Vec3& p, double depth_mm) {
  constexpr double kWave_mm = 48.0;  // two coils
  constexpr double kTop = 3.0;       // of the sum, where a coil is highest
  constexpr double kRound = 1.5;     // of the groove between two
  constexpr int kOthers = 8;
  constexpr double kGolden_rad = 2.39996322972865332;
  const auto sine = [](double way_mm, double wave_mm, double phase) {
    return portableSinCos(2.0 * kPi / wave_mm * way_mm + phase).sin;
  };
  const double meander_mm =
      p.z + 8.0 * sine(p.x, 66.0, 0.6) + 3.0 * sine(p.x, 37.0, 2.0) + 5.0 * sine(p.y, 58.0, 1.1);
  double sum = 3.0 * sine(meander_mm, kWave_mm, 0.4);
  for (int i = 0; i < kOthers; ++i) {
    const double height = (2.0 * i + 1.0) / kOthers - 1.0;
    const SinCos round = portableSinCos(kGolden_rad * i);
    const double across = std::sqrt(1.0 - height * height);
    sum += 0.45 * sine(dot(Vec3{across * round.cos, height, across * round.sin}, p), kWave_mm, 1.7 * i * i);
  }
  const double away = std::sqrt(sum * sum + kRound * kRound) - kRound;
  const double low = 1.0 - std::min(away / kTop, 1.0);
  return -depth_mm * low * low;
}

}  // namespace

TubeOrgan makeTestis(double edges) {
  constexpr double kCord_mm = 6.0;
  constexpr double kLength_mm = 110.0;
  constexpr double kPole = 60.0 / kLength_mm;  // where the cord ends, as a share of the length
  constexpr std::size_t kRings = 260;
  constexpr std::size_t kAround = 112;
  constexpr Domes kDomes{.first = 0.5, .last = 0.5};
  constexpr double kEdge_mm = 0.8;
  const double back_rad = 0.5 * kPi;  // of e2

  const std::vector<CurveFrame> frames = straightFrames({0, 0, kLength_mm}, {0, 0, 0}, {-1, 0, 0}, kRings);
  const auto half = [](double share, double widest_mm) {
    const double fades = 1.0 - rise(share, 0.7, 0.9);
    const double cord = kCord_mm * kCord_mm * fades;
    return std::sqrt(
        std::max(roundedMaximum(ellipseSquare(share, kPole, widest_mm), cord, 14.0 * fades + 0.1), 0.25));
  };
  const auto size = [&half](double share) { return SectionSize{half(share, 10.0), half(share, 15.0)}; };
  const MonotoneCurve epididymis({0.50, 0.56, 0.62, 0.70, 0.80, 0.88, 0.94, 1.0},
                                 {0.0, 3.8, 4.6, 2.8, 2.2, 3.4, 2.6, 0.0});
  const auto bump = [&epididymis, back_rad](double share, double angle) {
    const double strands = 0.7 * rise(share, 0.02, 0.08) * (1.0 - rise(share, kPole - 0.06, kPole + 0.02)) *
                           portableSinCos(3.0 * angle + 4.0 * kPi * share).cos;
    const double ridge =
        epididymis(share) * (1.3 * band(angle, back_rad, 0.62) - 0.3 * band(angle, back_rad, 0.95));
    return strands + ridge;
  };
  // 0 medial, 90 back, 180 lateral, 270 front.
  return organAlong(closedTube(frames, kAround, kDomes, size, bump), edges * kEdge_mm, frames,
                    {{"cord, upper end, front", 0.1, 270.0},
                     {"cord, middle, front", 0.3, 270.0},
                     {"cord, middle, back", 0.3, 90.0},
                     {"cord, lower end, front", 0.48, 270.0},
                     {"testis, upper pole, front", 0.6, 270.0},
                     {"testis, middle, medial", 0.77, 0.0},
                     {"testis, middle, lateral", 0.77, 180.0},
                     {"testis, middle, front", 0.77, 270.0},
                     {"epididymis, body", 0.77, 90.0},
                     {"testis, lower pole, front", 0.97, 270.0}});
}

TubeOrgan makeSigmoid(double edges) {
  // From the patient's left foot of the loop over its top to the right one; mm, LPS.
  const SplineCurve centreline({{28, 0, 0},
                                {31, -2, 40},
                                {46, -6, 88},
                                {66, -10, 138},
                                {74, -14, 186},
                                {60, -17, 232},
                                {32, -19, 258},
                                {0, -19, 266},
                                {-32, -19, 258},
                                {-60, -17, 232},
                                {-74, -14, 186},
                                {-66, -10, 138},
                                {-46, -6, 88},
                                {-31, -2, 40},
                                {-28, 0, 0}});
  const MonotoneCurve radius({0, .05, .12, .2, .32, .5, .68, .8, .88, .95, 1},
                             {17, 21, 30, 34, 37, 38, 37, 34, 30, 21, 17});
  constexpr double kSacs = 17.0;
  constexpr std::size_t kRings = 420;
  constexpr std::size_t kAround = 132;
  constexpr Domes kDomes{.first = 0.35, .last = 0.35};
  constexpr double kEdge_mm = 3.7;

  const std::vector<CurveFrame> frames = framesAlong(centreline, kRings, {1, 0, 0});
  const auto size = [&radius](double share) { return SectionSize{radius(share), radius(share)}; };
  const auto bump = [](double share, double angle) {
    const double nearTaenia = 0.5 * (1.0 + portableSinCos(3.0 * angle).cos);  // 1 on a taenia
    const double valley = nearTaenia * nearTaenia * nearTaenia;
    const int sector = static_cast<int>(std::floor(3.0 * angle / (2.0 * kPi)));  // between two taeniae
    const double sac = portableSinCos(kPi * (kSacs * share + sector / 3.0)).cos;
    const double fold = sac * sac * sac * sac;
    const double ends = rise(share, 0.01, 0.06) * (1.0 - rise(share, 0.94, 0.99));
    return ends * (1.5 - 3.0 * valley - 4.0 * fold * (1.0 - valley));
  };
  return organAlong(closedTube(frames, kAround, kDomes, size, bump), edges * kEdge_mm, frames,
                    {{"foot towards the descending colon, taenia libera", 0.05, 0.0},
                     {"foot towards the descending colon, mesenteric border", 0.05, 180.0},
                     {"descending limb, taenia libera", 0.22, 0.0},
                     {"descending limb, mesenteric border", 0.22, 180.0},
                     {"top, taenia libera", 0.5, 0.0},
                     {"top, mesenteric border", 0.5, 180.0},
                     {"rectal limb, taenia libera", 0.78, 0.0},
                     {"rectal limb, mesenteric border", 0.78, 180.0},
                     {"foot towards the rectum, taenia libera", 0.95, 0.0},
                     {"foot towards the rectum, mesenteric border", 0.95, 180.0}});
}

TubeOrgan makeBowelLoop(double edges) {
  // From the patient's left foot of the loop over its top to the right one, bowed to the front; mm, LPS.
  const SplineCurve centreline({{16, 0, 0},
                                {18, -6, 24},
                                {25, -18, 54},
                                {34, -24, 86},
                                {36, -15, 116},
                                {24, 0, 140},
                                {0, 6, 149},
                                {-24, 0, 140},
                                {-36, -15, 116},
                                {-34, -24, 86},
                                {-25, -18, 54},
                                {-18, -6, 24},
                                {-16, 0, 0}});
  constexpr double kRadius_mm = 13.0;
  constexpr double kWaveHeight_mm = 0.9;
  constexpr double kWaves = 17.0;  // circular folds seen from outside, 20 mm apart
  constexpr std::size_t kRings = 300;
  constexpr std::size_t kAround = 64;
  constexpr Domes kDomes{.first = 0.35, .last = 0.35};
  constexpr double kEdge_mm = 1.75;

  std::vector<CurveFrame> frames = framesAlong(centreline, kRings, {1, 0, 0});
  for (CurveFrame& frame : frames) {  // the bow would turn them about the curve: e1 stays outside of the loop
    const Vec3 out = frame.centre - Vec3{0, -12, 75};
    frame.e1 = normalized(out - dot(out, frame.tangent) * frame.tangent);
    frame.e2 = cross(frame.tangent, frame.e1);
  }
  const auto size = [](double) { return SectionSize{kRadius_mm, 0.94 * kRadius_mm}; };
  const auto bump = [](double share, double) {
    const double ends = rise(share, 0.01, 0.06) * (1.0 - rise(share, 0.94, 0.99));
    return ends * kWaveHeight_mm * portableSinCos(2.0 * kPi * kWaves * share).cos;
  };
  return organAlong(closedTube(frames, kAround, kDomes, size, bump), edges * kEdge_mm, frames,
                    {{"first foot, antimesenteric border", 0.05, 0.0},
                     {"first foot, mesenteric border", 0.05, 180.0},
                     {"first limb, antimesenteric border", 0.24, 0.0},
                     {"first limb, mesenteric border", 0.24, 180.0},
                     {"top, antimesenteric border", 0.5, 0.0},
                     {"top, mesenteric border", 0.5, 180.0},
                     {"second limb, antimesenteric border", 0.76, 0.0},
                     {"second limb, mesenteric border", 0.76, 180.0},
                     {"second foot, antimesenteric border", 0.95, 0.0},
                     {"second foot, mesenteric border", 0.95, 180.0}});
}

namespace {

// How the midgut was drawn first: stalk along y, towards the front.
constexpr double kMidgutRoot_mm = 70.0;
constexpr double kMidgutLength_mm = 130.0;

/// Stalk and pack of coils, which lies `aside` of the stalk's line from where the stalk ends; mm.
TriangleMesh packOnStalk(const std::vector<CurveFrame>& frames, double coil_mm, const Vec3& aside) {
  constexpr double kStalk_mm = 8.0;
  constexpr double kPole = 60.0 / kMidgutLength_mm;
  constexpr double kHalfWidth_mm = 62.0;
  constexpr double kHalfHeight_mm = 52.0;
  constexpr double kHalfDepth_mm = 35.0;
  constexpr std::size_t kAround = 240;
  constexpr Domes kDomes{.first = 0.5, .last = 0.5};
  const auto half = [](double share, double widest_mm) {
    const double fades = 1.0 - rise(share, 0.6, 0.9);
    const double stalk = kStalk_mm * kStalk_mm * fades;
    return std::sqrt(
        std::max(roundedMaximum(ellipseSquare(share, kPole, widest_mm), stalk, 40.0 * fades + 0.1), 0.25));
  };
  const auto size = [&half](double share) {
    return SectionSize{half(share, kHalfWidth_mm), half(share, kHalfHeight_mm)};
  };
  TriangleMesh fine = closedTube(frames, kAround, kDomes, size, [](double, double) { return 0.0; });
  const Vec3 middle{0, kHalfDepth_mm - 60.0, 0};
  for (Vec3& v : fine.vertices_m) {
    const Vec3 from = v - middle;
    const Vec3 outwards =
        normalized(Vec3{from.x / (kHalfWidth_mm * kHalfWidth_mm), from.y / (kHalfDepth_mm * kHalfDepth_mm),
                        from.z / (kHalfHeight_mm * kHalfHeight_mm)});
    // Not on the stalk, and fading in where the pack begins.
    const double share = (kMidgutRoot_mm - v.y) / kMidgutLength_mm;
    v += outwards * (rise(share, kPole + 0.02, kPole + 0.12) * coils_mm(v, coil_mm)) +
         rise(share, kPole + 0.02, kPole + 0.3) * aside;
  }
  return fine;
}

}  // namespace

TubeOrgan makeFormerMidgut() {
  constexpr std::size_t kRings = 300;
  constexpr double kEdge_mm = 2.0;
  const std::vector<CurveFrame> frames = straightFrames({0, 70, 0}, {0, -60, 0}, {1, 0, 0}, kRings);
  // 0 left, 90 up, 180 right, 270 down.
  return organAlong(packOnStalk(frames, 6.0, {}), kEdge_mm, frames, {});
}

TubeOrgan makeMidgut(double edges) {
  constexpr std::size_t kRings = 200;
  constexpr double kEdge_mm = 2.1;
  constexpr double kDrawnEdge_mm = 2.0;
  constexpr double kCoil_mm = 7.0;
  constexpr double kVoxel_mm = 1.9;
  constexpr double kSlope = 1.3;
  constexpr double kShoulder_mm = 6.0;  // where the limb leaves the pack
  // Right of the stalk, as in malrotated bowel.
  const Vec3 aside{-14, 0, -5};
  // The jejunal limb, from the pack beside the stalk up to its root.
  const std::vector<RoundCone> limb{{{-40, -14, 12}, {-33, 12, 12}, 9.0, 8.0},
                                    {{-33, 12, 12}, {-24, 34, 6}, 8.0, 7.5},
                                    {{-24, 34, 6}, {-21, 56, 2}, 7.5, 7.5},
                                    {{-21, 56, 2}, {-21, 80, 0}, 7.5, 7.0}};
  const std::vector<CurveFrame> drawn = straightFrames({0, 70, 0}, {0, -60, 0}, {1, 0, 0}, kRings);
  const CollisionMesh pack(
      remeshed(packOnStalk(drawn, kCoil_mm, aside), [](const Vec3&) { return kDrawnEdge_mm; }));
  SampleGrid grid;
  grid.step = kVoxel_mm;
  grid.origin = {-92.3, -72.1, -72.7};
  const auto points = [](double length) { return static_cast<std::size_t>(length / kVoxel_mm) + 2; };
  grid.count = {points(160.0), points(176.0), points(140.0)};
  TriangleMesh fine = zeroSurface(grid, kSlope, [&](const Vec3& p) {
    return joined(pack.closest(p).distance_m, joinedChain(limb, p, 3.0), kShoulder_mm);
  });
  // Hung up: the stalk comes down from behind the colon and forward.
  const SinCos tilt = portableSinCos(radians(44.0));
  const auto hung = [&tilt](const Vec3& p) {
    return Vec3{p.x, tilt.cos * p.y - tilt.sin * p.z, tilt.sin * p.y + tilt.cos * p.z};
  };
  std::vector<CurveFrame> frames = drawn;
  for (CurveFrame& frame : frames) {
    frame = {frame.arc, hung(frame.centre), hung(frame.tangent), hung(frame.e1), hung(frame.e2)};
  }
  std::transform(fine.vertices_m.begin(), fine.vertices_m.end(), fine.vertices_m.begin(), hung);
  // 0 left, 90 up, 180 right, 270 down.
  return organAlong(fine, edges * kEdge_mm, frames,
                    {{"stalk, root, left", 0.1, 0.0},
                     {"stalk, middle, above", 0.27, 90.0},
                     {"stalk, middle, below", 0.27, 270.0},
                     {"stalk, at the pack, left", 0.43, 0.0},
                     {"pack, left", 0.73, 0.0},
                     {"pack, above", 0.73, 90.0},
                     {"pack, right", 0.73, 180.0},
                     {"pack, below", 0.73, 270.0},
                     {"pack, front, above", 0.94, 90.0},
                     {"pack, front, below", 0.94, 270.0}});
}

}  // namespace torsio
