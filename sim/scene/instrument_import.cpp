// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/instrument_import.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/core/error.h"
#include "sim/core/portable_math.h"
#include "sim/core/short_number.h"
#include "sim/geometry/mesh/mesh_check.h"
#include "sim/geometry/mesh/mesh_import.h"
#include "sim/geometry/mesh/mesh_space.h"
#include "sim/geometry/mesh/mesh_thinning.h"
#include "sim/scene/instrument_parts.h"
#include "sim/scene/scene_file.h"

namespace torsio {

namespace {

constexpr std::size_t kKeptTriangles = 40'000;  // of the whole instrument, where pieces can be thinned
constexpr std::size_t kMaxShown = 200'000;      // where they cannot
constexpr std::size_t kMinOfPiece = 400;
constexpr double kThinnest_mm = 0.5;  // across the shaft

/// Points spread evenly over the triangles, each with its share of the area, and the vertices with none.
ToolPoints pointsOn(const TriangleMesh& mesh) {
  constexpr double kMaxPoints = 2e4;
  constexpr double kClosest_mm = 0.5;
  ToolPoints points;
  double area_mm2 = 0.0;
  std::vector<std::array<Vec3, 3>> open;
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    open.push_back({kToolMetre_mm * mesh.vertices_m[t[0]], kToolMetre_mm * mesh.vertices_m[t[1]],
                    kToolMetre_mm * mesh.vertices_m[t[2]]});
    area_mm2 += 0.5 * norm(cross(open.back()[1] - open.back()[0], open.back()[2] - open.back()[0]));
  }
  const double step_mm = std::max(kClosest_mm, 1.5 * std::sqrt(area_mm2 / kMaxPoints));
  while (!open.empty()) {
    const std::array<Vec3, 3> t = open.back();
    open.pop_back();
    std::size_t longest = 0;
    const auto side_mm = [&t](std::size_t k) { return norm(t[(k + 1) % 3] - t[k]); };
    for (std::size_t k = 1; k < 3; ++k) {
      longest = side_mm(k) > side_mm(longest) ? k : longest;
    }
    if (side_mm(longest) <= step_mm) {
      points.places_mm.push_back((t[0] + t[1] + t[2]) / 3.0);
      points.shares.push_back(0.5 * norm(cross(t[1] - t[0], t[2] - t[0])));
      continue;
    }
    const Vec3& from = t[longest];
    const Vec3& to = t[(longest + 1) % 3];
    const Vec3& third = t[(longest + 2) % 3];
    const Vec3 middle = 0.5 * (from + to);
    open.push_back({from, middle, third});
    open.push_back({middle, to, third});
  }
  for (const Vec3& v : mesh.vertices_m) {
    points.places_mm.push_back(kToolMetre_mm * v);
    points.shares.push_back(0.0);
  }
  return points;
}

double distance_mm(const ToolLine& line, const Vec3& place_mm) {
  const Vec3 from = place_mm - line.point_mm;
  return norm(from - dot(from, line.direction) * line.direction);
}

/// How many pieces of a line of 4 mm have the surface about them: the shaft is the longest straight way
/// through an instrument, whatever its handle is like.
std::size_t accompanied(const ToolPoints& points, const ToolLine& line, std::size_t stride) {
  constexpr double kPiece_mm = 4.0;
  constexpr double kLongest_mm = 2000.0;
  std::vector<bool> seen(static_cast<std::size_t>(2.0 * kLongest_mm / kPiece_mm), false);
  for (std::size_t n = 0; n < points.places_mm.size(); n += stride) {
    const double along_mm = dot(points.places_mm[n] - line.point_mm, line.direction) + kLongest_mm;
    if (along_mm >= 0.0 && along_mm < 2.0 * kLongest_mm &&
        distance_mm(line, points.places_mm[n]) <= line.within_mm) {
      seen[static_cast<std::size_t>(along_mm / kPiece_mm)] = true;
    }
  }
  return static_cast<std::size_t>(std::count(seen.begin(), seen.end(), true));
}

/// About the line of the shaft: through two points of the surface between which it goes on longest.
ToolLine shaftOf(const ToolPoints& points) {
  constexpr std::size_t kTried = 90;
  constexpr std::size_t kLookedAt = 4000;
  constexpr double kWithin_mm = 8.0;
  const std::size_t all = points.places_mm.size();
  const std::size_t stride = std::max<std::size_t>(1, all / kLookedAt);
  ToolLine best;
  std::size_t most = 0;
  for (std::size_t a = 0; a < kTried; ++a) {
    for (std::size_t b = a + 1; b < kTried; ++b) {
      const Vec3& from = points.places_mm[a * all / kTried];
      const Vec3 way = points.places_mm[b * all / kTried] - from;
      if (norm(way) < 4.0 * kWithin_mm) {
        continue;
      }
      const ToolLine line{from, normalized(way), kWithin_mm};
      if (const std::size_t count = accompanied(points, line, stride); count > most) {
        most = count;
        best = line;
      }
    }
  }
  return best;
}

/// The line of a frame, within a little more than the shaft's radius: that of half of what is near.
ToolLine closerTo(const ToolPoints& points, const ToolFrame& frame, const ToolLine& line) {
  const auto [least_mm, most_mm] = reachAlong(points, frame.tip_mm, frame.z);
  ToolLine closer{frame.tip_mm + 0.5 * (least_mm + most_mm) * frame.z, frame.z, line.within_mm};
  std::vector<std::pair<double, double>> near;  // distance, share
  double whole = 0.0;
  for (std::size_t n = 0; n < points.places_mm.size(); ++n) {
    const double away_mm = distance_mm(closer, points.places_mm[n]);
    if (points.shares[n] > 0.0 && away_mm <= line.within_mm) {
      near.emplace_back(away_mm, points.shares[n]);
      whole += points.shares[n];
    }
  }
  std::sort(near.begin(), near.end());
  double sum = 0.0;
  for (const auto& [away_mm, share] : near) {
    sum += share;
    if (sum >= 0.5 * whole) {
      closer.within_mm = std::min(line.within_mm, 1.3 * away_mm + 0.5);
      break;
    }
  }
  return closer;
}

/// The radius of an instrument between two places along its shaft, by what lies outermost all round it: the
/// median of slices.
double outerRadius_mm(const std::vector<Vec3>& local_mm, double from_mm, double to_mm) {
  constexpr std::size_t kRound = 16;
  constexpr std::size_t kFewest = 6;
  const auto slices = static_cast<std::size_t>(std::clamp((to_mm - from_mm) / 2.0, 1.0, 400.0));
  std::vector<std::array<double, kRound>> outermost(slices, std::array<double, kRound>{});
  for (const Vec3& p : local_mm) {
    if (p.z < from_mm || p.z >= to_mm) {
      continue;
    }
    const auto slice =
        static_cast<std::size_t>((p.z - from_mm) / (to_mm - from_mm) * static_cast<double>(slices));
    const double turn = 0.5 + portableAtan2(p.y, p.x) / (2.0 * kPi);
    const auto round = std::min(static_cast<std::size_t>(turn * kRound), kRound - 1);
    double& most = outermost[std::min(slice, slices - 1)][round];
    most = std::max(most, std::hypot(p.x, p.y));
  }
  std::vector<double> radii_mm;
  for (const auto& slice : outermost) {
    double sum = 0.0;
    std::size_t seen = 0;
    for (const double most : slice) {
      sum += most;
      seen += most > 0.0 ? 1U : 0U;
    }
    if (seen >= kFewest) {
      radii_mm.push_back(sum / static_cast<double>(seen));
    }
  }
  if (radii_mm.empty()) {
    return 0.0;
  }
  std::nth_element(radii_mm.begin(), radii_mm.begin() + static_cast<std::ptrdiff_t>(radii_mm.size() / 2),
                   radii_mm.end());
  return radii_mm[radii_mm.size() / 2];
}

std::vector<Vec3> inFrame(const ToolPoints& points, const ToolFrame& frame) {
  std::vector<Vec3> local_mm;
  local_mm.reserve(points.places_mm.size());
  for (const Vec3& place_mm : points.places_mm) {
    local_mm.push_back(frame.local_mm(place_mm));
  }
  return local_mm;
}

/// The least distance of the points from the shaft's axis between two places along it.
double innerRadius_mm(const std::vector<Vec3>& local_mm, double from_mm, double to_mm) {
  double least_mm = 1e9;
  for (const Vec3& p : local_mm) {
    if (p.z >= from_mm && p.z <= to_mm) {
      least_mm = std::min(least_mm, std::hypot(p.x, p.y));
    }
  }
  return least_mm;
}

/// The end of a frame's line at which the jaws are: closed ones taper, and a handle is broad; between open
/// ones there is nothing.
Vec3 jawEnd(const ToolPoints& points, const ToolFrame& frame, const InstrumentImportRequest& request) {
  const double most_mm = reachAlong(points, frame.tip_mm, frame.z).second;
  const std::vector<Vec3> local_mm = inFrame(points, frame);
  const double half_mm = 0.5 * request.pivot_mm;
  const bool far = request.drawnOpen_deg > 0.0 ? innerRadius_mm(local_mm, most_mm - 0.5 * half_mm, most_mm) >
                                                     innerRadius_mm(local_mm, 0.0, 0.5 * half_mm)
                                               : outerRadius_mm(local_mm, most_mm - half_mm, most_mm + 1e-6) <
                                                     outerRadius_mm(local_mm, 0.0, half_mm);
  return frame.tip_mm + (far ? most_mm : 0.0) * frame.z;
}

/// The points with shares that make every piece of the line count alike where there is little beside it, and
/// nothing elsewhere: a handle has more surface than the shaft, and parts of it lie near the axis.
ToolPoints alongShaft(ToolPoints points, const ToolLine& line) {
  constexpr double kPiece_mm = 4.0;
  constexpr double kAlone = 0.6;  // of the surface at a place along the line
  const auto [least_mm, most_mm] = reachAlong(points, line.point_mm, line.direction);
  struct Piece {
    double near = 0.0;
    double whole = 0.0;
  };
  std::vector<Piece> pieces(static_cast<std::size_t>((most_mm - least_mm) / kPiece_mm) + 1);
  const auto pieceOf = [&, from_mm = least_mm](std::size_t n) -> Piece& {
    const double along_mm = dot(points.places_mm[n] - line.point_mm, line.direction) - from_mm;
    return pieces[static_cast<std::size_t>(std::max(along_mm, 0.0) / kPiece_mm)];
  };
  for (std::size_t n = 0; n < points.shares.size(); ++n) {
    Piece& piece = pieceOf(n);
    piece.near += distance_mm(line, points.places_mm[n]) <= line.within_mm ? points.shares[n] : 0.0;
    piece.whole += points.shares[n];
  }
  for (std::size_t n = 0; n < points.shares.size(); ++n) {
    const Piece& piece = pieceOf(n);
    points.shares[n] = piece.near > kAlone * piece.whole ? points.shares[n] / piece.near : 0.0;
  }
  return points;
}

bool isNothing(const ToolPoints& points) {
  return std::all_of(points.shares.begin(), points.shares.end(), [](double share) { return share == 0.0; });
}

ToolFrame frameOf(const ToolPoints& points, const InstrumentImportRequest& request) {
  InstrumentImportRequest places = request;
  ToolLine line = request.shaft ? ToolLine{} : shaftOf(points);
  if (line.within_mm <= 0.0) {
    return toolFrame(points, places);
  }
  if (!places.tip_mm) {
    places.tip_mm = jawEnd(points, toolFrame(points, places, line), request);
  }
  constexpr int kRounds = 6;
  ToolPoints shaft = alongShaft(points, line);
  if (isNothing(shaft)) {
    return toolFrame(points, places);  // thicker than any shaft
  }
  for (int round = 0; round < kRounds; ++round) {
    const ToolLine closer = closerTo(shaft, toolFrame(shaft, places, line), line);
    ToolPoints closerShaft = alongShaft(points, closer);
    if (isNothing(closerShaft)) {
      break;  // as wide as that all the way: no shaft to come closer to
    }
    line = closer;
    shaft = std::move(closerShaft);
  }
  if (!places.jawAxis) {
    places.jawAxis = broadestAcross(points, toolFrame(shaft, places, line), places.pivot_mm);
  }
  return toolFrame(shaft, places, line);
}

void tell(const char* code, Text what, double value, Text remedy, std::vector<ScanRemark>& remarks) {
  remarks.push_back({code, false, std::move(what), value, std::move(remedy)});
}

/// Turns closed pieces outwards and thins them to their share of what is kept; returns whether all are
/// closed.
bool makeFit(std::vector<TriangleMesh>& pieces, std::size_t triangles, const std::string& where,
             std::vector<bool>& closed) {
  const double share = static_cast<double>(kKeptTriangles) / static_cast<double>(triangles);
  std::size_t kept = 0;
  for (TriangleMesh& piece : pieces) {
    closed.push_back(isClosedBody(piece));
    MeshRepairs ignored;
    if (closed.back() && orientFaces(piece, ignored) && share < 1.0) {
      const auto most = static_cast<std::size_t>(share * static_cast<double>(piece.triangles.size()));
      piece = thinned(std::move(piece), std::max(most, kMinOfPiece));
    }
    kept += piece.triangles.size();
  }
  if (kept > kMaxShown) {
    throw Error(ErrorCode::kBadMesh,
                Text::tr("M03 %1 triangles of open surfaces; an instrument has at most %2",
                         std::to_string(kept), std::to_string(kMaxShown)),
                where, Text::tr("Decimate the surface"));
  }
  return std::all_of(closed.begin(), closed.end(), [](bool one) { return one; });
}

void requireThickness(const std::vector<Vec3>& local_mm, const std::string& where) {
  const BoundingBox box = boxOf(local_mm);
  const double thinnest_mm = std::min(box.high.x - box.low.x, box.high.y - box.low.y);
  if (thinnest_mm < kThinnest_mm) {
    throw Error(ErrorCode::kBadMesh, Text::tr("M18 the mesh is flat: %1 mm thick", shortNumber(thinnest_mm)),
                where, Text::tr("Give the surface of a whole instrument"));
  }
}

/// Before anything is said of places: most often the unit is another.
void requireInstrumentSize(const TriangleMesh& mesh, std::optional<double> unit_m, const std::string& where) {
  requireSound(mesh, where);
  const double side_m = boxOf(mesh.vertices_m).largestSide();
  requireLargestSide(
      side_m, Stated::kInstrumentSide,
      Text::tr("M09 largest side %1 is not that of an instrument (%2)",
               inPlausibleUnit(Stated::kInstrumentSide, side_m), plausibleRange(Stated::kInstrumentSide)),
      where, unit_m);
}

[[noreturn]] void refuseShape(const Text& what, const std::string& where) {
  throw Error(ErrorCode::kBadMesh, what, where,
              Text::tr("Give the hinge, its axis, the direction of the shaft and a point near the tip"));
}

/// Takes an instrument apart at its hinge and closes its jaws. The hinge is said from the tip of the closed
/// jaws; of open ones the tip lies further back by what is found in turn.
void takeApart(const std::vector<TriangleMesh>& pieces, const std::vector<bool>& closed,
               const InstrumentImportRequest& request, const std::string& where, ToolSurface& tool) {
  const int rounds = request.drawnOpen_deg > 0.0 ? 4 : 1;
  double hinge_mm = request.pivot_mm;
  for (int round = 0; round < rounds; ++round) {
    ToolSurface parts = tool;
    parts.pivot_mm = hinge_mm;
    for (std::size_t n = 0; n < pieces.size(); ++n) {
      addPiece(parts, pieces[n], closed[n]);
    }
    if (parts.shaft.triangles.empty() || parts.upperJaw.triangles.empty() ||
        parts.lowerJaw.triangles.empty()) {
      refuseShape(Text::tr("M20 the instrument has no two jaws in front of its hinge"), where);
    }
    closeJaws(parts, request.drawnOpen_deg);
    hinge_mm += request.pivot_mm - parts.pivot_mm;
    if (round + 1 == rounds) {
      tool = std::move(parts);
    }
  }
}

}  // namespace

ToolSurface toolOfMesh(RawMesh raw, const InstrumentImportRequest& request) {
  const std::string where = request.file.string();
  requireToolPlaces(request);
  if (!(request.drawnOpen_deg >= 0.0 && request.drawnOpen_deg <= 90.0)) {
    throw Error(ErrorCode::kBadParameter, Text::tr("jaws stand open by 0 to 90 degrees"), where,
                Text::tr("Give the angle of one jaw"));
  }
  ToolSurface tool;
  const bool stated = meshSpaceOf(request.file).unit_m.has_value();
  requireInstrumentSize(raw.mesh, stated ? std::nullopt : std::optional(request.scale_m), where);
  MeshImportOptions options;
  options.scale_m = request.scale_m;
  options.organ = false;
  MeshRepairs repairs;
  const TriangleMesh mesh = checkedMesh(std::move(raw.mesh), where, options, &repairs);
  const ToolPoints points = pointsOn(mesh);
  ToolFrame frame = frameOf(points, request);
  if (request.drawnOpen_deg > 0.0 && !request.jawAxis) {
    std::swap(frame.x, frame.y);  // open jaws are broadest across their hinge
    frame.y = -1.0 * frame.y;
  }
  const std::vector<Vec3> local_mm = inFrame(points, frame);
  requireThickness(local_mm, where);
  tool.tip_mm = frame.tip_mm;
  tool.axes = {frame.x, frame.y, frame.z};
  tool.pivot_mm = request.pivot_mm;
  tool.length_mm = reachAlong(points, frame.tip_mm, frame.z).second;
  if (!(tool.length_mm > 2.0 * request.pivot_mm)) {
    refuseShape(Text::tr("M20 the mesh is %1 mm long: no instrument with jaws of %2 mm",
                         shortNumber(tool.length_mm), shortNumber(request.pivot_mm)),
                where);
  }
  tool.shaftRadius_mm =
      outerRadius_mm(local_mm, request.pivot_mm + kBehindHinge_mm,
                     std::max(tool.length_mm - kBehindHinge_mm, 1.3 * request.pivot_mm + kBehindHinge_mm));
  std::vector<TriangleMesh> pieces = piecesOf(mesh);
  std::vector<bool> closed;
  if (!makeFit(pieces, mesh.triangles.size(), where, closed)) {
    tell("M11", Text::tr("some of the surface is open; it is shown as it is"),
         static_cast<double>(std::count(closed.begin(), closed.end(), false)),
         Text::tr("Close it in a mesh editor where that is seen"), tool.remarks);
  }
  for (TriangleMesh& piece : pieces) {
    for (Vec3& v : piece.vertices_m) {
      v = frame.local_mm(kToolMetre_mm * v) / kToolMetre_mm;
    }
  }
  takeApart(pieces, closed, request, where, tool);
  std::vector<Vec3> jaws_mm;
  for (const TriangleMesh* jaw : {&tool.upperJaw, &tool.lowerJaw}) {
    for (const Vec3& p : pointsOn(*jaw).places_mm) {
      jaws_mm.push_back(p);
    }
  }
  tool.tipRadius_mm = outerRadius_mm(jaws_mm, 0.1 * tool.pivot_mm, 0.5 * tool.pivot_mm);
  if (const std::size_t flat = repairs.degenerateFaces + repairs.duplicateFaces; flat > 0) {
    tell("M10", Text::tr("%1 doubled or flat {face|faces} removed", std::to_string(flat)),
         static_cast<double>(flat), "", tool.remarks);
  }
  tellPlaces(request, tool.axes[0], tool.pivot_mm, tool.remarks);
  return tool;
}

ToolSurface importInstrument(const InstrumentImportRequest& request) {
  requireUnit(request.scale_m, request.file.string());
  requireToolPlaces(request);
  return toolOfMesh(readMeshApart(request.file, request.scale_m, request.reading), request);
}

}  // namespace torsio
