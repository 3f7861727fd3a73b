// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "assessment/study/protocol_terms.h"

namespace torsio {

/// The centre that owns this record; one row.
struct Centre {
  std::string id{};
  std::string name{};
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
};

/// People who go through a study together.
struct Cohort {
  std::string id{};
  std::string name{};  ///< unique
  std::string description{};
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
  std::string curriculumVersionId{};  ///< filled when read; empty: follows none yet
};

/// An arm of the study (paper section 6: 40 min virtual; 20 + 20 min; 40 min real).
struct StudyGroup {
  std::string id{};
  std::string cohortId{};
  std::int64_t number = 0;  ///< 1, 2, 3
  std::string code{};       ///< "G1"
  std::string label{};      ///< "40 min virtual"
  std::string armId{};      ///< filled when read: what it goes through; empty: no curriculum yet
};

/// One person in one cohort, with the group they were allocated to.
struct Enrolment {
  std::string id{};
  std::string cohortId{};
  std::string traineeId{};
  std::string groupId{};           ///< empty before allocation
  std::int64_t numberInGroup = 0;  ///< 1 ..; 0 before allocation
  EnrolmentState state = EnrolmentState::kEnrolled;
  std::int64_t enrolledUtc_us = 0;
  bool demonstration = false;
  std::string traineeCode{};  ///< filled when read
  std::string groupCode{};    ///< filled when read; empty before allocation
};

/// Time that was spent training or resting. Append-only.
struct Exposure {
  std::string id{};
  std::string enrolmentId{};
  std::string phaseId{};  ///< empty: outside any phase
  std::string kind{};     ///< "virtual", "real", "rest"
  std::int64_t startedUtc_us = 0;
  std::int64_t duration_us = 0;
  std::string recordedBy{};
  bool demonstration = false;
};

/// Something that did not go by the protocol. Append-only.
struct ProtocolDeviation {
  std::string id{};
  std::string cohortId{};
  std::string enrolmentId{};  ///< empty: the whole cohort
  std::string kind{};         ///< "device failed", "late", "swapped" ...
  std::string description{};
  std::int64_t happenedUtc_us = 0;
  std::string reportedBy{};
  std::int64_t reportedUtc_us = 0;
  bool demonstration = false;
};

/// A trial of a cohort that has no closing row: it is running, or was interrupted and not closed yet.
struct RunningTrial {
  std::string trialId{};
  std::string enrolmentId{};
  std::string station{};
  std::string phaseLabel{};
  std::int64_t startedUtc_us = 0;
};

/// A named state of a cohort's data. Append-only.
struct DataFreeze {
  std::string id{};
  std::string cohortId{};
  std::string name{};         ///< unique in the record
  std::string contentHash{};  ///< BLAKE2b-256 over what went into it
  std::string manifestJson{};
  std::string createdBy{};
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
};

}  // namespace torsio
