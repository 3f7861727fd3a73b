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

inline constexpr double kMaxMinutes = 100'000.0;  ///< that a time of a curriculum may have

// While a curriculum is being written, its CurriculumVersion carries codes in place of ids: a module's
// `id` is its code, `requires_` and TrainingPhase::moduleId name codes. Publishing gives real ids.

/// Something that keeps a draft from being published.
/// The fields of an editor that a problem can be about.
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

/// Where in a draft a problem is, for an editor that says it beside the field.
struct CurriculumSpot {
  enum class Part : std::uint8_t { kWhole, kModule, kArm, kOccasion };
  Part part = Part::kWhole;
  std::size_t row = 0;  ///< of the modules, arms or known occasions
  CurriculumField field = CurriculumField::kCode;
};

struct CurriculumProblem {
  Text where{};  ///< "module V2", "arm G1, phase 2", "occasion mid"
  Text what{};
  Text remedy{};
  CurriculumSpot spot{};
};

/// Lists everything that is wrong, in reading order; empty: can be published. Scenes and patterns are looked
/// up in `assets`; with an empty path they are not checked. `known`: the occasions that it may name.
[[nodiscard]] std::vector<CurriculumProblem> curriculumProblems(const CurriculumVersion& content,
                                                                const std::filesystem::path& assets,
                                                                const Occasions& known);

/// The draft as JSON text (format "torsio curriculum 1": degrees, minutes and seconds), and back. Reading is
/// strict: unknown and misspelt fields, wrong types and numbers out of range are refused with their place.
/// Throws Error{kBadData}; `name` stands for the file.
[[nodiscard]] std::string curriculumJson(const CurriculumVersion& content);
[[nodiscard]] CurriculumVersion parseCurriculum(const std::string& json, const std::string& name);

/// A curriculum that ships as a file of assets/curricula.
struct CurriculumTemplate {
  std::string id{};  ///< file name without .json
  std::string title{};
  std::string description{};
  CurriculumVersion content{};
};
/// All templates, ordered by id. Throws Error{kFileMissing, kFileUnreadable, kBadData}.
[[nodiscard]] std::vector<CurriculumTemplate> curriculumTemplates(const std::filesystem::path& assets);

/// Returns a stored version as a draft: modules, arms and phases carry their codes in place of ids.
[[nodiscard]] CurriculumVersion withCodes(CurriculumVersion version);
/// Returns a draft with new ids in place of codes, taken from `ids` for the modules, then for each arm and
/// its phases. Throws std::out_of_range for a code that no module has: a draft is checked before it is
/// stored.
[[nodiscard]] CurriculumVersion withIds(CurriculumVersion draft, IdSource& ids);

}  // namespace torsio
