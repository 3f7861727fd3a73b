// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/skin/vessels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "sim/core/angle.h"
#include "sim/core/random.h"
#include "sim/scene/skin/skin_charts.h"

namespace torsio {

namespace {

constexpr std::uint64_t kSeed = 7;
constexpr std::size_t kMaxPieces = 60'000;
constexpr std::size_t kTaper = 6;  // pieces over which a vessel that is stopped grows thin

/// Where a tissue's vessels come from and how far they go.
struct Plan {
  std::vector<double> borders_rad;  // ridge angle of each main vessel
  double mainRadius_m;
  double branchRadius_m;
  double leastRadius_m;
  double spacing_m;       // between branches of one side
  double wander_rad;      // of the main vessel about its border
  double thinning_per_m;  // share of the radius lost on the way
  double clearance_m;     // between vessels that do not fork from one another
  double step_m;
  double meander;  // how much a branch bends
};

Plan planOf(TissueKind kind) {
  switch (kind) {
    case TissueKind::kIntestine:
      return {{std::numbers::pi}, 0.0010, 0.00052, 0.00009, 0.0060, 0.10, 6.0, 0.0011, 0.0008, 0.8};
    case TissueKind::kSkin:
      return {
          {0.35, 1.25, 2.0, 2.9, 4.3, 5.2}, 0.0014, 0.0010, 0.0006, 0.060, 0.16, 2.0, 0.0080, 0.0015, 0.6};
    case TissueKind::kSerosa:
      break;
  }
  return {{0.0, std::numbers::pi}, 0.0016, 0.00090, 0.00011, 0.0150, 0.05, 5.0, 0.0015, 0.0010, 0.9};
}

struct Tip {
  SurfaceWalker walker;
  double radius_m = 0.0;
  double sinceFork_m = 0.0;
  double bend = 0.0;
  std::uint32_t branch = 0;
  std::array<std::size_t, kTaper> recent{};  // its newest pieces, newest first
  std::size_t pieces = 0;
};

class Growth {
 public:
  Growth(const TriangleMesh& mesh, const SectionLattice& lattice, const Plan& plan)
      : mesh_(mesh), lattice_(lattice), plan_(plan), walk_(mesh), random_(kSeed) {}

  std::vector<VesselPiece> grow() {
    for (const double border : plan_.borders_rad) {
      traceMain(border);
      sproutAlong();
    }
    // Side by side, so that no tree takes all the room.
    while (!tips_.empty() && pieces_.size() < kMaxPieces) {
      std::vector<Tip> next;
      for (Tip& tip : tips_) {
        advance(tip, next);
      }
      tips_ = std::move(next);
    }
    return std::move(pieces_);
  }

 private:
  struct Crossing {
    Vec3 middle_m;
    double arc_m;
    std::uint32_t triangle;
  };

  double wander(double arc_m) const {
    const double x = arc_m / lattice_.length_m() * kTurn;
    return plan_.wander_rad * (std::sin(2.3 * x) + 0.6 * std::sin(5.1 * x + 1.7));
  }

  /// A main vessel is the line on which the ridge angle is that of the border.
  void traceMain(double border_rad) {
    crossings_.clear();
    const auto coordinates = lattice_.vertexCoordinates();
    const auto parts = lattice_.vertexParts();
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      const TriangleMesh::Triangle& corner = mesh_.triangles[t];
      std::array<double, 3> away{};
      bool usable = true;
      for (std::size_t k = 0; k < 3; ++k) {
        const LatticeCoordinate& c = coordinates[corner[k]];
        away[k] = std::remainder(c.angle_rad - border_rad - wander(c.arc_m), kTurn);
        usable = usable && parts[corner[k]] == LatticePart::kSide && std::abs(away[k]) < 1.0;
      }
      if (usable) {
        cut(t, away);
      }
    }
    std::sort(crossings_.begin(), crossings_.end(),
              [](const Crossing& a, const Crossing& b) { return a.arc_m < b.arc_m; });
  }

  void cut(std::uint32_t t, const std::array<double, 3>& away) {
    const TriangleMesh::Triangle& corner = mesh_.triangles[t];
    std::vector<Vec3> ends;
    double arc_m = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t n = (k + 1) % 3;
      arc_m += lattice_.vertexCoordinates()[corner[k]].arc_m / 3.0;
      if ((away[k] < 0.0) == (away[n] < 0.0)) {
        continue;
      }
      const double share = away[k] / (away[k] - away[n]);
      ends.push_back(mesh_.vertices_m[corner[k]] * (1.0 - share) + mesh_.vertices_m[corner[n]] * share);
    }
    if (ends.size() != 2) {
      return;
    }
    const double place = arc_m / lattice_.length_m();
    const double fade = std::min({1.0, place / 0.08, (1.0 - place) / 0.08});
    add(ends[0], ends[1], plan_.mainRadius_m * (0.7 + 0.3 * fade), std::max(0.0, fade), 0);
    crossings_.push_back({(ends[0] + ends[1]) * 0.5, arc_m, t});
  }

  void sproutAlong() {
    double next_m = plan_.spacing_m * random_.uniform();
    double side = 1.0;
    for (const Crossing& c : crossings_) {
      if (c.arc_m < next_m) {
        continue;
      }
      next_m = c.arc_m + 0.5 * plan_.spacing_m * (0.6 + 0.8 * random_.uniform());
      side = -side;
      Tip tip;
      tip.walker = {c.middle_m, {}, c.triangle};
      const Vec3 along = lattice_.frameAt(c.arc_m).tangent;
      const Vec3 round = cross(along, walk_.normal(c.triangle)) * side;
      walk_.head(tip.walker, round + along * (0.7 * (random_.uniform() - 0.5)));
      tip.radius_m = plan_.branchRadius_m * (0.55 + 0.45 * random_.uniform());
      tip.branch = ++branches_;
      tips_.push_back(tip);
    }
  }

  void advance(Tip& tip, std::vector<Tip>& next) {
    const Vec3 before_m = tip.walker.place_m;
    tip.bend = 0.86 * tip.bend + 0.16 * plan_.meander * (random_.uniform() - 0.5);
    walk_.turn(tip.walker, tip.bend);
    const bool goesOn = walk_.step(tip.walker, plan_.step_m);
    tip.sinceFork_m += plan_.step_m;
    tip.radius_m *= 1.0 - plan_.thinning_per_m * plan_.step_m;
    const bool free = tip.sinceFork_m <= 2.0 * plan_.clearance_m || !occupied(tip);
    if (!goesOn || !free || tip.radius_m < plan_.leastRadius_m) {
      taper(tip);
      return;
    }
    // Fine ends sink into the wall.
    const double rest = (tip.radius_m - plan_.leastRadius_m) / plan_.branchRadius_m;
    add(before_m, tip.walker.place_m, tip.radius_m, std::min(1.0, 0.25 + 3.0 * rest), tip.branch);
    std::shift_right(tip.recent.begin(), tip.recent.end(), 1);
    tip.recent[0] = pieces_.size() - 1;
    ++tip.pieces;
    if (tip.sinceFork_m > forkAfter(tip)) {
      fork(tip, next);
    }
    next.push_back(tip);
  }

  void taper(const Tip& tip) {
    for (std::size_t i = 0; i < std::min(kTaper, tip.pieces); ++i) {
      VesselPiece& piece = pieces_[tip.recent[i]];
      const float share = (static_cast<float>(i) + 0.5F) / static_cast<float>(kTaper);
      piece.radius_m *= 0.45F + 0.55F * share;
      piece.strength *= 0.3F + 0.7F * share;
    }
  }

  double forkAfter(const Tip& tip) {
    return plan_.clearance_m * (2.5 + 3.0 * random_.uniform()) + 8.0 * tip.radius_m;
  }

  void fork(Tip& tip, std::vector<Tip>& next) {
    const double side = random_.uniform() < 0.5 ? 1.0 : -1.0;
    Tip child = tip;
    child.pieces = 0;
    child.branch = ++branches_;
    child.radius_m *= 0.58 + 0.2 * random_.uniform();
    child.bend = 0.0;
    child.sinceFork_m = 0.0;
    walk_.turn(child.walker, side * (0.45 + 0.4 * random_.uniform()));
    next.push_back(child);
    tip.radius_m *= 0.90;
    tip.sinceFork_m = 0.0;
    walk_.turn(tip.walker, -side * (0.08 + 0.18 * random_.uniform()));
  }

  struct Mark {
    Vec3 place_m;
    std::uint32_t branch;
  };

  std::uint64_t cellOf(const Vec3& p, int dx, int dy, int dz) const {
    const double size_m = plan_.clearance_m * 1.5;
    const auto index = [size_m](double v, int d) {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(v / size_m)) + d + (1 << 20));
    };
    return (index(p.x, dx) << 42U) ^ (index(p.y, dy) << 21U) ^ index(p.z, dz);
  }

  bool occupied(const Tip& tip) const {
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dz = -1; dz <= 1; ++dz) {
          const auto cell = marks_.find(cellOf(tip.walker.place_m, dx, dy, dz));
          if (cell == marks_.end()) {
            continue;
          }
          for (const Mark& mark : cell->second) {
            if (mark.branch == tip.branch) {
              continue;
            }
            const Vec3 way = mark.place_m - tip.walker.place_m;
            // What lies behind is where it came from.
            if (norm(way) < plan_.clearance_m && dot(way, tip.walker.heading) > 0.0) {
              return true;
            }
          }
        }
      }
    }
    return false;
  }

  void add(const Vec3& from_m, const Vec3& to_m, double radius_m, double strength, std::uint32_t branch) {
    pieces_.push_back({from_m, to_m, static_cast<float>(radius_m), static_cast<float>(strength)});
    marks_[cellOf(to_m, 0, 0, 0)].push_back({to_m, branch});
  }

  const TriangleMesh& mesh_;
  const SectionLattice& lattice_;
  Plan plan_;
  SurfaceWalk walk_;
  Random random_;
  std::vector<Crossing> crossings_;
  std::vector<Tip> tips_;
  std::vector<VesselPiece> pieces_;
  std::unordered_map<std::uint64_t, std::vector<Mark>> marks_;
  std::uint32_t branches_ = 0;
};

}  // namespace

std::vector<VesselPiece> growVessels(const TriangleMesh& mesh, const SectionLattice& lattice,
                                     const TissueLook& look) {
  return Growth(mesh, lattice, planOf(look.kind)).grow();
}

}  // namespace torsio
