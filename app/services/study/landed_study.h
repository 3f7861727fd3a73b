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
#include "assessment/domain/study/protocol_terms.h"
#include "sim/record/trial.h"

namespace torsio {

/// Somebody who comes with data from elsewhere.
struct LandedPerson {
  std::string name{};   ///< as the data call them
  std::string code{};   ///< wanted in the record; empty: the next free one
  std::string group{};  ///< code of a group of the cohort; empty: in none
  std::string sex{};
  std::string level{};
  EnrolmentState state = EnrolmentState::kEnrolled;
};
struct LandedRater {
  std::string name{};
  std::string code{};       ///< as above
  std::string classCode{};  ///< of the record
};
/// Where in the curriculum something belongs, by codes; empty: nowhere.
struct LandedPlace {
  std::string module{};
  std::string arm{};
  std::size_t phase = 0;  ///< position in its arm; counts where there is an arm
};
struct LandedTrial {
  Trial trial{};         ///< without an id a new one, its code and its hash are filled in
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
  std::string person{};  ///< empty: the whole cohort
  std::string kind{};
  std::string description{};
  std::int64_t happenedUtc_us = 0;
};
/// A curriculum that comes along; without a name there is none.
struct LandedCurriculum {
  std::string name{};
  std::string description{};
  std::string json{};  ///< of curriculumJson()
};
struct LandedMark {
  std::string person{};
  std::string rater{};
  std::string occasion{};  ///< code or label; one that the record does not know is added
  std::int64_t steps = 0;
  std::optional<std::size_t> trial{};  ///< of LandedStudy::trials
};

/// A whole study from elsewhere: its own cohort, its own people.
struct LandedStudy {
  NewCohort cohort{};
  LandedCurriculum curriculum{};
  std::filesystem::path assets{};  ///< where the exercises of the curriculum are looked up
  std::vector<LandedPerson> people{};
  std::vector<LandedRater> raters{};
  std::vector<std::string> occasions{};  ///< in order of time
  std::vector<LandedTrial> trials{};
  ScoreScale scale{};
  std::vector<LandedMark> marks{};
  std::vector<LandedExposure> exposures{};
  std::vector<LandedDeviation> deviations{};
  std::string markComment{};  ///< kept with each mark: where it is from
};

/// What is in the record now.
struct LandedOutcome {
  CohortId cohortId{};
  std::map<std::string, std::string> codes{};  ///< code in the record by name
};

/// Rights that landStudy() asks for: kStudySetup, kStudyEnrol, kPersonEdit, kCurriculumEdit.
void requireLanding(SessionContext& session);

/// Where a study came from, for the audit trail.
struct LandingNote {
  std::string json{};    ///< layout, counts and hash of what was read
  std::string reason{};  ///< why it was imported
};

/// Enters a study: all of it or nothing. Audited: the import itself with its note, and cohort, people,
/// enrolments, occasions, recordings and marks as if somebody had entered each. requireLanding(). Throws
/// Error{kBadData} for a class of raters that the record does not have, a code or recording that it has
/// already; {kBadParameter} for the name of another cohort; DbError; what `progress` throws stops it.
LandedOutcome landStudy(SessionContext& session, LandedStudy study, const LandingNote& note,
                        const ProgressCallback& progress = {});

}  // namespace torsio
