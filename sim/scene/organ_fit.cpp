// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/organ_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <future>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "sim/core/error.h"
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
constexpr std::array kCutShares{0.03, 0.1};         // of the length, from an end
constexpr double kMaxBehindCuts = 0.25;             // of the surface
constexpr std::array kCapShares{0.04, 0.06, 0.08};  // radius of a disc, of the organ's largest side

bool refusedAmong(const std::vector<OrganFinding>& findings) {
  return std::any_of(findings.begin(), findings.end(),
                     [](const OrganFinding& one) { return one.weight == FindingWeight::kRefusal; });
}

std::size_t countAccepted(const FittedOrgan& fitted) {
  return acceptedAmong(fitted.patterns).size();
}

/// Says in the refusal of a pattern that cuts were tried.
void tellTried(std::vector<OrganFinding>& findings) {
  for (OrganFinding& one : findings) {
    if (one.weight == FindingWeight::kRefusal && one.code >= "M23") {
      one.remedy = Text::tr(
          "Cuts across its ends were tried and do not help: take a part of it that bends "
          "less, or name other ends");
    }
  }
}

/// A millimetre's tenth, so that a command can name the place.
Vec3 roundedPlace(const Vec3& p) {
  const auto tenth = [](double x_m) { return std::round(1e4 * x_m) / 1e4; };
  return {tenth(p.x), tenth(p.y), tenth(p.z)};
}

Vec3 roundedDirection(const Vec3& d) {
  const auto thousandth = [](double x) { return std::round(1e3 * x) / 1e3; };
  return {thousandth(d.x), thousandth(d.y), thousandth(d.z)};
}

/// Ends with a cut across each.
OrganEnds cutAcross(const Vec3& fixed_m, const Vec3& fixedOut, const Vec3& free_m, const Vec3& freeOut) {
  OrganEnds ends;
  ends.fixedEnd_m = roundedPlace(fixed_m);
  ends.freeEnd_m = roundedPlace(free_m);
  ends.fixedCut = roundedDirection(fixedOut);
  ends.freeCut = roundedDirection(freeOut);
  return ends;
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

/// An organ on its way to a judgement: a surface that is thin enough for many tries.
class Fitting {
 public:
  Fitting(const OrganFile& organ, const std::filesystem::path& assets, const TriangleMesh* drawn)
      : organ_(organ), assets_(assets), drawn_(drawn), wrung_(wrungShare(assets, organ.anatomy)) {}

  [[nodiscard]] FittedOrgan fit() const {
    FittedOrgan asNamed = with(organ_.ends);
    const OrganEnds& ends = organ_.ends;
    const bool stalk = wrung_ < 1.0;
    const bool plain = !stalk && ends.branchCut == Vec3{} && ends.capRadius_m == 0.0;
    std::optional<FittedOrgan> other;
    if (plain && ends.fixedEnd_m && !asNamed.judgement.findings.empty()) {
      other = withoutBranch(ends, asNamed);
    }
    if (!other && asNamed.refused()) {
      other = stalk ? onItsStalk(ends) : plain ? cutAtItsEnds(ends) : std::nullopt;
      if (!other && plain && ends.fixedCut == Vec3{} && ends.freeCut == Vec3{}) {
        tellTried(asNamed.judgement.findings);
      }
    }
    return other ? std::move(*other) : std::move(asNamed);
  }

 private:
  [[nodiscard]] FittedOrgan judged(const OrganEnds& ends, std::size_t patterns) const {
    FittedOrgan fitted{ends, judgeOrgan(organ_.mesh, latticeFor(ends), wrung_), {}, false};
    if (!fitted.refused()) {
      OrganFile organ = organ_;
      organ.ends = ends;
      fitted.patterns = judgePatterns(assets_, organ, patterns, drawn_);
      replaceBroken(fitted.patterns, fitted.judgement.findings);
    }
    return fitted;
  }

  /// With planes for sections where it is cut and that leaves nothing to say: a cut through a fine mesh is
  /// jagged, and the axis that is found bends towards it.
  [[nodiscard]] FittedOrgan with(const OrganEnds& ends, std::size_t patterns = kAllPatterns) const {
    FittedOrgan fitted = judged(ends, patterns);
    const bool cut = ends.fixedCut != Vec3{} || ends.freeCut != Vec3{};
    if (!cut || ends.straight || fitted.judgement.findings.empty()) {
      return fitted;
    }
    OrganEnds straight = ends;
    straight.straight = true;
    FittedOrgan planes = judged(straight, patterns);
    return planes.judgement.findings.empty() ? std::move(planes) : std::move(fitted);
  }

  /// The stalk's root held, with discs about the ends: a rounded tip takes in too much of a pack.
  [[nodiscard]] std::optional<FittedOrgan> onItsStalk(OrganEnds ends) const {
    if (!ends.fixedEnd_m) {
      const auto [root_m, top_m] = stalkAndTop_m(organ_.mesh);
      ends.fixedEnd_m = root_m;
      ends.freeEnd_m = top_m;
    }
    const double side_m = checkMesh(organ_.mesh).largestSide_m();
    for (const double share : kCapShares) {
      ends.capRadius_m = share * side_m;
      FittedOrgan fitted = with(ends);
      if (!fitted.refused()) {
        return fitted;
      }
    }
    return std::nullopt;
  }

  /// Without what hangs on its side between the named ends, if no fewer patterns leave it whole than with it.
  [[nodiscard]] std::optional<FittedOrgan> withoutBranch(const OrganEnds& ends,
                                                         const FittedOrgan& withIt) const {
    const std::optional<SideBranch> branch = findSideBranch(organ_.mesh, *ends.fixedEnd_m, *ends.freeEnd_m);
    if (!branch) {
      return std::nullopt;
    }
    OrganFile fewer = organ_;
    if (fewer.mesh.triangles.size() > kTriedTriangles) {
      fewer.mesh = thinned(fewer.mesh, kTriedTriangles);
    }
    const Fitting trial{fewer, assets_, nullptr};
    // The fillet at its root belongs to it as well, and how the cut lies decides how the sections run beside
    // it: the first cut that leaves nothing to say, else the best.
    std::optional<OrganEnds> best;
    double most = -1.0;
    for (std::size_t tried = 0; tried < kRootShares.size() * kRootTurns.size(); ++tried) {
      const double turn = kRootTurns[tried % kRootTurns.size()];
      OrganEnds cut = ends;
      cut.branchCut = normalized((1.0 - turn) * branch->outward + turn * branch->away);
      cut.branchRoot_m =
          branch->root_m - kRootShares[tried / kRootTurns.size()] * branch->width_m * cut.branchCut;
      const FittedOrgan fitted = trial.with(cut, 1);
      if (!fitted.refused() && fitted.patterns.front().leastDeterminant > most) {
        most = fitted.patterns.front().leastDeterminant;
        best = cut;
      }
      if (best && fitted.judgement.findings.empty()) {
        break;
      }
    }
    if (!best) {
      return std::nullopt;
    }
    FittedOrgan fitted = with(*best);
    if (fitted.refused() || (!withIt.refused() && countAccepted(fitted) < countAccepted(withIt))) {
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

  /// Ways to cut it across its ends: at right angles to the axis, or to the line between the ends.
  [[nodiscard]] std::vector<OrganEnds> cuts(const OrganEnds& ends) const {
    std::vector<OrganEnds> ways;
    auto [fixed_m, free_m] = stalkAndTop_m(organ_.mesh);
    try {
      const SectionLattice lattice(organ_.mesh, latticeFor(ends));
      fixed_m = lattice.frameAt(0.0).centre_m;
      free_m = lattice.frameAt(lattice.length_m()).centre_m;
      for (const double share : kCutShares) {
        const AxisFrame first = lattice.frameAt(share * lattice.length_m());
        const AxisFrame last = lattice.frameAt((1.0 - share) * lattice.length_m());
        ways.push_back(cutAcross(first.centre_m, -first.tangent, last.centre_m, last.tangent));
      }
    } catch (const Error&) {
      fixed_m = ends.fixedEnd_m.value_or(fixed_m);  // no axis: the line will do
      free_m = ends.freeEnd_m.value_or(free_m);
    }
    const Vec3 way_m = free_m - fixed_m;
    const Vec3 along = normalized(way_m);
    for (const double share : kCutShares) {
      ways.push_back(cutAcross(fixed_m + share * way_m, -along, free_m - share * way_m, along));
    }
    return ways;
  }

  /// With the cuts that most patterns bear.
  [[nodiscard]] std::optional<FittedOrgan> cutAtItsEnds(const OrganEnds& ends) const {
    if (ends.fixedCut != Vec3{} || ends.freeCut != Vec3{}) {
      return std::nullopt;
    }
    const std::vector<OrganEnds> ways = cuts(ends);
    std::optional<FittedOrgan> best;
    for (std::size_t i = 0; i < ways.size(); i += 2) {  // two at a time
      std::vector<std::future<FittedOrgan>> tried;
      for (std::size_t k = i; k < std::min(i + 2, ways.size()); ++k) {
        tried.push_back(std::async(std::launch::async, [this, &ways, k] { return with(ways[k]); }));
      }
      for (std::future<FittedOrgan>& one : tried) {
        FittedOrgan fitted = one.get();
        const bool usable = !fitted.refused() && fitted.judgement.measures.caps <= kMaxBehindCuts;
        if (usable && countAccepted(fitted) > (best ? countAccepted(*best) : 0)) {
          best = std::move(fitted);
          best->otherEnds = true;
        }
      }
      if (best && countAccepted(*best) == best->patterns.size()) {
        break;
      }
    }
    return best;
  }

  const OrganFile& organ_;
  const std::filesystem::path& assets_;
  const TriangleMesh* drawn_;
  double wrung_ = 1.0;
};

}  // namespace

bool FittedOrgan::refused() const {
  return refusedAmong(judgement.findings);
}

FittedOrgan fitOrgan(const OrganFile& organ, const std::filesystem::path& assets,
                     const CoarserSurfaces& other) {
  if (organ.mesh.triangles.size() <= kJudgedTriangles) {
    return Fitting(organ, assets, other.drawn).fit();
  }
  // Its shape and what is tried: of a thinned surface. The patterns: of the whole, which has the last word.
  OrganFile whole = organ;
  const auto judgeWhole = [&](FittedOrgan& fitted) {
    whole.ends = fitted.ends;
    fitted.patterns = judgePatterns(assets, whole, kAllPatterns, other.drawn);
    replaceBroken(fitted.patterns, fitted.judgement.findings);
  };
  OrganFile fewer = organ;
  fewer.mesh = other.judged != nullptr ? *other.judged : thinned(organ.mesh, kJudgedTriangles);
  const double wrung = wrungShare(assets, organ.anatomy);
  FittedOrgan fitted{organ.ends, judgeOrgan(fewer.mesh, latticeFor(organ.ends), wrung), {}, false};
  if (fitted.judgement.findings.empty()) {
    judgeWhole(fitted);
    if (!fitted.refused()) {
      return fitted;
    }
  }
  fitted = Fitting(fewer, assets, other.drawn).fit();
  if (!fitted.refused()) {
    judgeWhole(fitted);
  }
  return fitted;
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

double wrungShare(const std::filesystem::path& assets, const std::string& anatomy) {
  if (anatomy.empty()) {
    return 1.0;
  }
  double most = 0.0;
  for (const PatternDescription& one : readSceneFile(assets, anatomy).patterns) {
    if (one.pattern.detorsion == nullptr) {
      return 1.0;
    }
    const std::vector<WrungSpan>& spans = one.pattern.detorsion->spans;
    if (spans.size() != 1 || spans.front().held != 0.0 || !(spans.front().mobile > 0.0)) {
      return 1.0;
    }
    most = std::max(most, spans.front().mobile);
  }
  return most;
}

}  // namespace torsio
