// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "assessment/domain/study/curriculum.h"
#include "assessment/domain/study/occasion.h"
#include "sim/core/text.h"

namespace torsio {

class IdSource;

inline constexpr double kMaxMinutes = 100'000.0;  ///< maximum for any time in a curriculum

// In a draft, the CurriculumVersion has codes instead of ids: in a module's `id`, in `requires_` and in
// TrainingPhase::moduleId. Publishing creates ids.

/// Fields of the editor that can have a problem.
enum class CurriculumField : std::uint8_t {
  kCode,
  kTitle,
  kScene,
  kTarget,
  kLimits,
  kPrerequisites,
  kMastery,
  kPhases,
  kTime
};

/// Location of a problem, for showing it next to the field.
struct CurriculumSpot {
  enum class Part : std::uint8_t { kWhole, kModule, kArm, kOccasion };
  Part part = Part::kWhole;
  std::size_t row = 0;  ///< index of the module, arm or known occasion
  CurriculumField field = CurriculumField::kCode;
};

struct CurriculumProblem {
  Text where{};  ///< "module V2", "arm G1, phase 2", "occasion mid"
  Text what{};
  Text remedy{};
  CurriculumSpot spot{};
};

/// Lists all problems in reading order; empty: can be published. Checks scenes and patterns against `assets`
/// unless empty. `known`: the occasions that may be used.
[[nodiscard]] std::vector<CurriculumProblem> curriculumProblems(const CurriculumVersion& content,
                                                                const std::filesystem::path& assets,
                                                                const Occasions& known);

/// Convert a draft to JSON text (format "torsio curriculum 1": degrees, minutes and seconds), and back.
/// Parsing is strict: rejects unknown and misspelt fields, wrong types and numbers out of range, with their
/// place. Throws Error{kBadData}; `name`: file name for messages.
[[nodiscard]] std::string curriculumJson(const CurriculumVersion& content);
[[nodiscard]] CurriculumVersion parseCurriculum(const std::string& json, const std::string& name);

/// A curriculum shipped in assets/curricula.
struct CurriculumTemplate {
  std::string id{};  ///< file name without .json
  std::string title{};
  std::string description{};
  CurriculumVersion content{};
};
/// Returns all templates, ordered by id. Throws Error{kFileMissing, kFileUnreadable, kBadData}.
[[nodiscard]] std::vector<CurriculumTemplate> curriculumTemplates(const std::filesystem::path& assets);

/// Converts a stored version to a draft: modules, arms and phases have codes instead of ids.
[[nodiscard]] CurriculumVersion withCodes(CurriculumVersion version);
/// Converts a draft to a version with new ids, taken from `ids` for the modules, then for each arm and its
/// phases. Throws std::out_of_range for an unknown module code: check a draft before storing it.
[[nodiscard]] CurriculumVersion withIds(CurriculumVersion draft, IdSource& ids);

}  // namespace torsio
