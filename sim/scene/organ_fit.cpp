// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/organ_fit.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "sim/core/short_number.h"
#include "sim/geometry/lattice/side_branch.h"
#include "sim/geometry/mesh/mesh_check.h"
#include "sim/geometry/mesh/mesh_thinning.h"
#include "sim/geometry/mesh/surface_topology.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/scene_file.h"

namespace torsio {

namespace {

constexpr std::size_t kTriedTriangles = 25'000;
constexpr std::array kRootShares{0.5, 0.6, 0.4, 0.7, 0.2, 0.0};  // of a branch's width, into the organ
constexpr std::array kRootTurns{0.8, 1.0, 1.2};     // from along the branch to away from the organ
constexpr std::array kCapShares{0.04, 0.06, 0.08};  // radius of a disc, of the organ's largest side

bool refused(const OrganJudgement& judgement) {
  return std::any_of(judgement.findings.begin(), judgement.findings.end(),
                     [](const OrganFinding& one) { return one.weight == FindingWeight::kRefusal; });
}

/// The two vertices farthest from each other along the surface, first the one with less about it: the root
/// of a stalk.
std::array<Vec3, 2> stalkAndTop_m(const TriangleMesh& mesh) {
  const SurfaceTopology topology(mesh);
  const auto farthest = [](const std::vector<double>& from) {
    return static_cast<std::uint32_t>(std::max_element(from.begin(), from.end()) - from.begin());
  };
  std::uint32_t one = mesh.triangles.front().front();
  one = farthest(edgeDistances_m(mesh, topology, {&one, 1}));
  const std::vector<double> fromOne = edgeDistances_m(mesh, topology, {&one, 1});
  const std::uint32_t other = farthest(fromOne);
  const std::vector<double> fromOther = edgeDistances_m(mesh, topology, {&other, 1});
  double byOne_m2 = 0.0;
  double byOther_m2 = 0.0;
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.vertices_m[t[0]];
    const double area_m2 = norm(cross(mesh.vertices_m[t[1]] - a, mesh.vertices_m[t[2]] - a));
    byOne_m2 += fromOne[t[0]] < 0.25 * fromOne[other] ? area_m2 : 0.0;
    byOther_m2 += fromOther[t[0]] < 0.25 * fromOne[other] ? area_m2 : 0.0;
  }
  const Vec3& p = mesh.vertices_m[one];
  const Vec3& q = mesh.vertices_m[other];
  return byOne_m2 <= byOther_m2 ? std::array{p, q} : std::array{q, p};
}

/// An organ on its way to a judgement.
struct Fitting {
  const TriangleMesh& mesh;
  double wrung = 1.0;
  bool partial = false;  ///< twisted in parts of it only

  [[nodiscard]] FittedOrgan with(const OrganEnds& ends) const {
    FittedOrgan fitted{ends, judgeOrgan(mesh, latticeFor(ends), wrung)};
    if (partial) {
      allowPartialTwist(fitted.judgement);
    }
    return fitted;
  }

  /// The stalk's root held, with discs about the ends: a rounded tip takes in too much of a pack.
  [[nodiscard]] std::optional<FittedOrgan> onItsStalk(OrganEnds ends) const {
    if (!ends.fixedEnd_m) {
      const auto [root_m, top_m] = stalkAndTop_m(mesh);
      ends.fixedEnd_m = root_m;
      ends.freeEnd_m = top_m;
    }
    const double side_m = checkMesh(mesh).largestSide_m();
    for (const double share : kCapShares) {
      ends.capRadius_m = share * side_m;
      FittedOrgan fitted = with(ends);
      if (!refused(fitted.judgement)) {
        return fitted;
      }
    }
    return std::nullopt;
  }

  /// With planes for sections, where that leaves nothing to say: a cut through a fine mesh is jagged, and the
  /// axis that is found bends towards it.
  [[nodiscard]] std::optional<FittedOrgan> withPlanes(OrganEnds ends) const {
    ends.straight = true;
    FittedOrgan fitted = with(ends);
    return fitted.judgement.findings.empty() ? std::optional(std::move(fitted)) : std::nullopt;
  }

  /// Without what hangs on its side between the named ends.
  [[nodiscard]] std::optional<FittedOrgan> withoutBranch(const OrganEnds& ends) const {
    const bool large = mesh.triangles.size() > kJudgedTriangles;
    const TriangleMesh fewer = large ? thinned(mesh, kJudgedTriangles) : TriangleMesh{};
    const std::optional<SideBranch> branch =
        findSideBranch(large ? fewer : mesh, *ends.fixedEnd_m, *ends.freeEnd_m);
    if (!branch) {
      return std::nullopt;
    }
    const TriangleMesh tried =
        mesh.triangles.size() > kTriedTriangles ? thinned(mesh, kTriedTriangles) : TriangleMesh{};
    const Fitting trial{tried.triangles.empty() ? mesh : tried, wrung, partial};
    // The fillet at its root belongs to it as well, and how the cut lies decides how the sections run beside
    // it: the first cut that leaves nothing to say, else the best.
    std::optional<OrganEnds> best;
    double most = -1.0;
    bool clean = false;
    for (const double share : kRootShares) {
      for (const double turn : kRootTurns) {
        OrganEnds cut = ends;
        cut.branchCut = normalized((1.0 - turn) * branch->outward + turn * branch->away);
        cut.branchRoot_m = branch->root_m - share * branch->width_m * cut.branchCut;
        const FittedOrgan fitted = trial.with(cut);
        if (!refused(fitted.judgement) && !clean && fitted.judgement.measures.leastDeterminant60 > most) {
          most = fitted.judgement.measures.leastDeterminant60;
          best = cut;
          clean = fitted.judgement.findings.empty();
        }
      }
      if (clean) {
        break;
      }
    }
    if (!best) {
      return std::nullopt;
    }
    FittedOrgan fitted = with(*best);
    if (refused(fitted.judgement)) {
      return std::nullopt;
    }
    fitted.judgement.findings.push_back(
        {"M20", FindingWeight::kWarning,
         Text::tr(
             "a branch on the side, %1 mm wide and %2 mm long, belongs to no section: it follows its root",
             shortNumber(1000.0 * branch->width_m), shortNumber(1000.0 * branch->length_m)),
         Text::tr("the whole organ"), 1000.0 * branch->length_m,
         Text::tr("Cut the branch off in a mesh editor if it is not part of the organ")});
    return fitted;
  }
};

}  // namespace

FittedOrgan fitOrgan(const TriangleMesh& mesh, const OrganEnds& ends, const std::filesystem::path& assets,
                     const std::string& anatomy) {
  const double wrung = wrungShare(assets, anatomy);
  const Fitting fitting{mesh, wrung, wrung == 1.0 && !twistsAsAWhole(assets, anatomy)};
  FittedOrgan asNamed = fitting.with(ends);
  const bool cut = ends.fixedCut != Vec3{} || ends.freeCut != Vec3{};
  if (cut && !asNamed.judgement.findings.empty() && !ends.straight) {
    if (std::optional<FittedOrgan> straight = fitting.withPlanes(ends)) {
      return std::move(*straight);
    }
  }
  if (!refused(asNamed.judgement)) {
    return asNamed;
  }
  std::optional<FittedOrgan> other;
  if (wrung < 1.0) {
    other = fitting.onItsStalk(ends);
  } else if (ends.fixedEnd_m && ends.freeEnd_m && ends.branchCut == Vec3{}) {
    other = fitting.withoutBranch(ends);
  }
  return other ? std::move(*other) : std::move(asNamed);
}

LatticeOptions latticeFor(const OrganEnds& ends) {
  LatticeOptions lattice;
  lattice.mode = ends.straight ? LatticeMode::kStraightAxis : LatticeMode::kAutomatic;
  if (ends.fixedEnd_m && ends.freeEnd_m) {
    lattice.fixedEnd_m = *ends.fixedEnd_m;
    lattice.freeEnd_m = *ends.freeEnd_m;
  }
  lattice.fixedCut = ends.fixedCut;
  lattice.freeCut = ends.freeCut;
  lattice.capRadius_m = ends.capRadius_m;
  lattice.branchRoot_m = ends.branchRoot_m;
  lattice.branchCut = ends.branchCut;
  return lattice;
}

bool twistsAsAWhole(const std::filesystem::path& assets, const std::string& anatomy) {
  if (anatomy.empty()) {
    return true;
  }
  const SceneDescription scene = readSceneFile(assets, anatomy);
  return std::any_of(scene.patterns.begin(), scene.patterns.end(),
                     [](const PatternDescription& one) { return one.pattern.detorsion == nullptr; });
}

double wrungShare(const std::filesystem::path& assets, const std::string& anatomy) {
  if (twistsAsAWhole(assets, anatomy)) {
    return 1.0;
  }
  double most = 0.0;
  for (const PatternDescription& one : readSceneFile(assets, anatomy).patterns) {
    const std::vector<WrungSpan>& spans = one.pattern.detorsion->spans;
    if (spans.size() != 1 || spans.front().held != 0.0 || !(spans.front().mobile > 0.0)) {
      return 1.0;
    }
    most = std::max(most, spans.front().mobile);
  }
  return most;
}

void allowPartialTwist(OrganJudgement& judgement) {
  if (judgement.shapeless()) {
    return;
  }
  for (OrganFinding& finding : judgement.findings) {
    if (finding.weight == FindingWeight::kRefusal && finding.code >= "M22") {
      finding.weight = FindingWeight::kWarning;
    }
  }
}

}  // namespace torsio
