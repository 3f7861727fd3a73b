// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/geometry/lattice/section_lattice.h"
#include "sim/scene/organ_file.h"
#include "sim/scene/organ_judgement.h"
#include "sim/scene/pattern_judgement.h"

namespace torsio {

/// An organ as it was judged, with what had to be found for that.
struct FittedOrgan {
  OrganEnds ends;
  OrganJudgement judgement;  ///< of its shape, with what the patterns add
  std::vector<PatternJudgement>
      patterns;            ///< of its anatomy, in the scene's order; none: its shape is refused
  bool otherEnds = false;  ///< ends or cuts are others than those that were named

  /// Tells whether a finding refuses it.
  [[nodiscard]] bool refused() const;
};

/// Coarser surfaces of an organ; null: none.
struct CoarserSurfaces {
  const TriangleMesh* judged = nullptr;  ///< of kJudgedTriangles, if the organ has more and it exists already
  const TriangleMesh* drawn = nullptr;   ///< whose shapes the patterns keep (judgePattern())
};

/// Judges an organ as its scenes move it: its shape (judgeOrgan), and each pattern of its anatomy
/// (judgePatterns). It is refused if its shape is or if no pattern leaves it whole. Then the ends are taken
/// another way: of an organ on a stalk, that which is narrower is held, with discs in place of rounded tips;
/// of one whose ends are named, a branch on its side is taken for none of its sections, with a warning; of
/// any other, cuts across its ends. Where something is to be said of one that is cut, and nothing with planes
/// for sections, those are taken. Throws as readSceneFile().
/// `other`: coarser surfaces of the same organ.
[[nodiscard]] FittedOrgan fitOrgan(const OrganFile& organ, const std::filesystem::path& assets,
                                   const CoarserSurfaces& other = {});

/// Returns the lattice's options for an organ with these ends.
[[nodiscard]] LatticeOptions latticeFor(const OrganEnds& ends);

/// Returns the share of the length, from the held end, that the patterns of a scene wring: below 1 where the
/// organ hangs on a stalk, 1 of any other and of no scene.
[[nodiscard]] double wrungShare(const std::filesystem::path& assets, const std::string& anatomy);

}  // namespace torsio
