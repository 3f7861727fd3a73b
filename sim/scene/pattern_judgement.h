// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "sim/core/text.h"
#include "sim/scene/organ_file.h"
#include "sim/scene/organ_state.h"
#include "sim/scene/rod_organ.h"
#include "sim/scene/scene.h"
#include "sim/tissue/rod/fold_check.h"

namespace torsio {

/// How a surface lies when the organ is turned.
struct TurnedShape {
  double angle_rad = 0.0;
  std::vector<Vec3> places_m;  ///< of its vertices
};

/// What a pattern does to an organ on the way to its target.
struct PatternJudgement {
  std::string id;
  bool accepted = false;
  double leastDeterminant = 1.0;       ///< of det F
  double volumeRatio = 1.0;            ///< over that at rest, where it is farthest from 1
  std::size_t crossings = 0;           ///< most new pairs of triangles that cross
  double leastDeterminant60 = 1.0;     ///< of det F within the first 60 degrees
  std::string code;                    ///< of the rule that refuses it, "M23"; empty: accepted
  Text reason;                         ///< why, one sentence without a full stop; empty: accepted
  std::optional<double> brokenAt_rad;  ///< turn at which it breaks; none: accepted, or it cannot be started
  double wholeShare = 0.0;             ///< of the way to the target, along which the organ stays whole
  std::vector<TurnedShape> shapes;     ///< of the surface to draw: half as far as it stays whole, and there
};

/// Measures how the organ of a scene lies: `check` of its mesh and lattice.
[[nodiscard]] FoldReport foldOf(const Scene& scene, const FoldCheck& check, const OrganState& state);

/// A limit that a deformation passes.
struct BrokenLimit {
  std::string code;  ///< of the rule of docs/organs.md, "M23"; empty: none
  Text reason;       ///< one sentence without a full stop
};

/// Returns the limit of tissue that the organ of a scene passes as it lies. A wall folds by design and its
/// content may escape: a hollow organ is whole while it is not inside out and holds at least half its volume.
[[nodiscard]] BrokenLimit brokenLimit(const Scene& scene, const FoldReport& fold);

/// Says why a turn of a rod goes no further than an angle.
[[nodiscard]] Text turnEndsAt(double angle_rad, TurnEnd end);

/// Turns the organ of a scene by its pattern to the target in steps, or through all twists with which it may
/// come, and judges whether it stays whole. `drawn`: the same organ's surface of which shapes are to be kept;
/// null: none are.
[[nodiscard]] PatternJudgement judgePattern(const Scene& scene, const TriangleMesh* drawn = nullptr);

inline constexpr std::size_t kAllPatterns = std::numeric_limits<std::size_t>::max();

/// Builds the scene of each pattern that the anatomy of an organ offers, as sceneOfOrgan() does, and judges
/// it; in their order, the first `most`. A scene that cannot be built is a pattern that is refused. Uses two
/// threads. `drawn`: see judgePattern().
[[nodiscard]] std::vector<PatternJudgement> judgePatterns(const std::filesystem::path& assets,
                                                          const OrganFile& organ,
                                                          std::size_t most = kAllPatterns,
                                                          const TriangleMesh* drawn = nullptr);

/// Returns the ids of the patterns that leave the organ whole.
[[nodiscard]] std::vector<std::string> acceptedAmong(const std::vector<PatternJudgement>& patterns);

/// Makes the finding of a pattern that breaks: a refusal.
[[nodiscard]] OrganFinding brokenFinding(const PatternJudgement& pattern);

/// Puts what these patterns break in place of what others broke among findings: if none leaves the organ
/// whole, the one that goes farthest refuses it; any other is a pattern that is left out, a note.
void replaceBroken(const std::vector<PatternJudgement>& patterns, std::vector<OrganFinding>& findings);

}  // namespace torsio
