// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/base/progress.h"
#include "app/services/study/cohort_service.h"
#include "assessment/domain/rating/instrument.h"
#include "assessment/domain/study/cohort.h"
#include "assessment/domain/study/protocol_terms.h"
#include "assessment/domain/study/study_statement.h"
#include "sim/record/trial.h"

namespace torsio {

/// A person in imported data.
struct LandedPerson {
  std::string name{};   ///< name used in the data
  std::string code{};   ///< requested code; empty: the next free one
  std::string group{};  ///< code of a group of the cohort; empty: none
  std::string sex{};
  std::string level{};
  EnrolmentState state = EnrolmentState::kEnrolled;
};
struct LandedRater {
  std::string name{};
  std::string code{};       ///< see LandedPerson::code
  std::string classCode{};  ///< of the record's rater classes
};
/// A position in the curriculum by codes; empty: none.
struct LandedPlace {
  std::string module{};
  std::string arm{};
  std::size_t phase = 0;  ///< index in its arm; used only if there is an arm
};
struct LandedTrial {
  Trial trial{};         ///< without an id: gets a new one, with code and hash
  std::string person{};  ///< LandedPerson::name
  LandedPlace place{};
  std::optional<AttemptMode> mode{};
};
struct LandedExposure {
  std::string person{};
  ExposureKind kind = ExposureKind::kVirtual;
  std::int64_t startedUtc_us = 0;
  std::int64_t duration_us = 0;
  LandedPlace place{};
};
struct LandedDeviation {
  std::string person{};  ///< empty: whole cohort
  std::string kind{};
  std::string description{};
  std::int64_t happenedUtc_us = 0;
};
/// An imported curriculum; without a name: none.
struct LandedCurriculum {
  std::string name{};
  std::string description{};
  std::string json{};  ///< from curriculumJson()
};
struct LandedMark {
  std::string person{};
  std::string rater{};
  std::string occasion{};  ///< code or label; added if unknown
  std::int64_t steps = 0;
  std::optional<std::size_t> trial{};  ///< index in LandedStudy::trials
};

/// A complete imported study with its own cohort and people.
struct LandedStudy {
  NewCohort cohort{};
  LandedCurriculum curriculum{};
  std::filesystem::path assets{};  ///< where the curriculum's exercises are looked up
  std::vector<LandedPerson> people{};
  std::vector<LandedRater> raters{};
  std::vector<std::string> occasions{};  ///< in order of time
  std::vector<LandedTrial> trials{};
  ScoreScale scale{};
  std::vector<LandedMark> marks{};
  std::vector<LandedExposure> exposures{};
  std::vector<LandedDeviation> deviations{};
  std::string markComment{};  ///< stored with each mark: its origin
  /// Layout, source, hash, where the source had it from, and who signed it; landStudy() sets the rest. Every
  /// imported mark and recording refers to it.
  StudyImport origin{};
  StudyStatements statements{};
};

/// Result of an import.
struct LandedOutcome {
  CohortId cohortId{};
  std::map<std::string, std::string> codes{};  ///< codes in the record by name
};

/// Requires the rights for landStudy(): kStudySetup, kStudyEnrol, kPersonEdit, kCurriculumEdit.
void requireLanding(SessionContext& session);

/// Origin of a study, for the audit trail.
struct LandingNote {
  std::string json{};    ///< layout, counts and hash of the source
  std::string reason{};  ///< reason for the import
};

/// Imports a study, all or nothing. Audited: the import itself with its note, and cohort, people, enrolments,
/// occasions, recordings and marks as if entered one by one. requireLanding(). Throws Error{kBadData} for an
/// unknown rater class, or a code or recording that exists already; {kBadParameter} if another cohort has the
/// name; DbError; exceptions of `progress` stop the import.
LandedOutcome landStudy(SessionContext& session, LandedStudy study, const LandingNote& note,
                        const ProgressCallback& progress = {});

}  // namespace torsio
