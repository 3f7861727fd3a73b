// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/protocol_terms.h"

namespace torsio {

/// The centre that owns this database; one row.
struct Centre {
  CentreId id{};
  std::string name{};
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
};

/// People who go through a study together.
struct Cohort {
  CohortId id{};
  std::string name{};  ///< unique
  std::string description{};
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
  CurriculumVersionId curriculumVersionId{};  ///< filled when read; empty: none assigned yet
  CohortState state = CohortState::kDraft;    ///< filled when read
  /// Planned equivalence margin in points, above 0. Empty: none was planned.
  std::optional<double> equivalenceMargin{};
};

/// An arm of the study (paper section 6: 40 min virtual; 20 + 20 min; 40 min real).
struct StudyGroup {
  GroupId id{};
  CohortId cohortId{};
  std::int64_t number = 0;  ///< 1, 2, 3
  std::string code{};       ///< "G1"
  std::string label{};      ///< "40 min virtual"
  ArmId armId{};            ///< filled when read: arm of the curriculum; empty: no curriculum yet
};

/// One person in one cohort, with the group they were allocated to.
struct Enrolment {
  EnrolmentId id{};
  CohortId cohortId{};
  TraineeId traineeId{};
  GroupId groupId{};               ///< empty before allocation
  std::int64_t numberInGroup = 0;  ///< 1 ..; 0 before allocation
  EnrolmentState state = EnrolmentState::kEnrolled;
  std::int64_t enrolledUtc_us = 0;
  bool demonstration = false;
  std::string traineeCode{};  ///< filled when read
  std::string groupCode{};    ///< filled when read; empty before allocation
};

/// Time spent training or resting. Append-only.
struct Exposure {
  ExposureId id{};
  EnrolmentId enrolmentId{};
  PhaseId phaseId{};  ///< empty: outside any phase
  ExposureKind kind = ExposureKind::kVirtual;
  std::int64_t startedUtc_us = 0;
  std::int64_t duration_us = 0;
  std::string recordedBy{};
  bool demonstration = false;
};

/// A deviation from the protocol. Append-only.
struct ProtocolDeviation {
  DeviationId id{};
  CohortId cohortId{};
  EnrolmentId enrolmentId{};  ///< empty: the whole cohort
  std::string kind{};         ///< stored text of a DeviationKind
  std::string description{};
  std::int64_t happenedUtc_us = 0;
  std::string reportedBy{};
  std::int64_t reportedUtc_us = 0;
  bool demonstration = false;
};

/// A trial without a closing row: still running, or interrupted and not yet closed.
struct RunningTrial {
  TrialId trialId{};
  EnrolmentId enrolmentId{};
  std::string station{};
  std::string phaseLabel{};
  std::int64_t startedUtc_us = 0;
};

/// Where an imported study came from. Its rows refer to it. Append-only.
struct StudyImport {
  ImportId id{};
  CohortId cohortId{};
  std::string layout{};            ///< "Torsio", "JIGSAWS"
  std::string source{};            ///< as the data name it
  std::string contentHash{};       ///< BLAKE2b-256
  std::string earlierJson = "[]";  ///< where the source had it from, oldest first
  std::string signedBy{};          ///< public key whose signature was checked; empty: unsigned
  UserId importedBy{};
  std::int64_t importedUtc_us = 0;
};

/// A named snapshot of a cohort's data. Append-only.
struct DataFreeze {
  FreezeId id{};
  CohortId cohortId{};
  std::string name{};         ///< unique in the record
  std::string contentHash{};  ///< BLAKE2b-256 of the contents
  std::string manifestJson{};
  std::string createdBy{};
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
};

using DaySlotId = Id<struct DaySlotIdTag>;

/// An appointment: trainee, place and time.
struct DaySlot {
  DaySlotId id{};
  EnrolmentId enrolmentId{};
  std::string place{};  ///< a station or a room
  std::int64_t startsUtc_us = 0;
  std::int64_t duration_us = 0;
  std::string traineeCode{};  ///< filled when read

  [[nodiscard]] std::int64_t endsUtc_us() const noexcept { return startsUtc_us + duration_us; }
};

/// A trainee who has not begun by this time after the start of the slot is overdue.
inline constexpr std::int64_t kSlotGrace_us = 5LL * 60 * 1'000'000;

}  // namespace torsio
