// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "sim/geometry/lattice/section_lattice.h"
#include "sim/geometry/mesh/triangle_mesh.h"
#include "sim/scene/organ_file.h"
#include "sim/scene/organ_judgement.h"

namespace torsio {

/// An organ as it was judged, with what had to be found for that.
struct FittedOrgan {
  OrganEnds ends;
  OrganJudgement judgement;
};

/// Judges an organ (judgeOrgan) as the patterns of its anatomy twist it: along its whole length, or on its
/// stalk. Where that refuses it the ends are taken another way: of an organ on a stalk, that which is
/// narrower is held, with discs in place of rounded tips; of one whose ends are named, a branch on its side
/// is taken for none of its sections, with a warning. Where something is to be said of one that is cut at a
/// named end, and nothing with planes for sections, those are taken. `anatomy`: id of a scene, empty: not
/// known. Throws as readSceneFile().
[[nodiscard]] FittedOrgan fitOrgan(const TriangleMesh& mesh, const OrganEnds& ends,
                                   const std::filesystem::path& assets, const std::string& anatomy);

/// Returns the lattice's options for an organ with these ends.
[[nodiscard]] LatticeOptions latticeFor(const OrganEnds& ends);

/// Tells whether the patterns of a scene twist an organ along its whole length, as it is judged: not where it
/// came twisted in parts of it. Of no scene: true.
[[nodiscard]] bool twistsAsAWhole(const std::filesystem::path& assets, const std::string& anatomy);

/// Returns the share of the length, from the held end, that the patterns of a scene wring: below 1 where the
/// organ hangs on a stalk, 1 of any other and of no scene.
[[nodiscard]] double wrungShare(const std::filesystem::path& assets, const std::string& anatomy);

/// Makes warnings of the refusals about a twist along the whole length.
void allowPartialTwist(OrganJudgement& judgement);

}  // namespace torsio
