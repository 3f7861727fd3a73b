// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/cohort.h"
#include "assessment/domain/study/curriculum.h"
#include "assessment/domain/study/day_slot.h"
#include "assessment/domain/study/occasion.h"
#include "assessment/domain/study/protocol_terms.h"
#include "assessment/domain/study/station_state.h"
#include "sim/core/text.h"

namespace torsio {

/// Where somebody stands in an arm, from the time that was logged.
struct PhaseProgress {
  std::size_t phase = 0;  ///< position in StudyArm::phases; their number: all done
  std::int64_t inPhase_us = 0;
  std::int64_t left_us = 0;     ///< of this phase
  std::int64_t virtual_us = 0;  ///< spent so far
  std::int64_t real_us = 0;
  std::int64_t restUsed_us = 0;
  std::int64_t restLeft_us = 0;
  std::size_t rests = 0;
};
/// Time with a phase id counts for that phase; other virtual or real time fills the phases of its kind in
/// order. Rest counts for no phase. An allowance that may not be split is used up by the first rest.
[[nodiscard]] PhaseProgress phaseProgress(const StudyArm& arm, std::span<const Exposure> exposures);

/// Tells whether an arm spends time on this. Rest it always may; one without phases plans nothing, and
/// nothing is beside its plan.
[[nodiscard]] bool isPlanned(const StudyArm& arm, ExposureKind kind);

/// Sheets of one trainee at one occasion that are not in.
struct OccasionSheets {
  Occasion occasion{};
  std::size_t missing = 0;  ///< at least one
};

/// One line of the board.
struct DayBoardRow {
  EnrolmentId enrolmentId{};
  TraineeId traineeId{};
  std::string traineeCode{};
  EnrolmentState state = EnrolmentState::kEnrolled;
  std::string groupCode{};  ///< empty: not allocated
  std::string armLabel{};
  std::string phaseLabel{};  ///< empty: no curriculum, or all done
  std::string phaseKind{};
  PhaseProgress progress{};
  std::int64_t restAllowance_us = 0;
  bool done = false;                           ///< all phases
  std::vector<ExposureKind> unplanned{};       ///< what the arm spends no time on (isPlanned())
  Occasion occasionDue{};                      ///< the newest one that the exposure has reached; of
                                               ///< several, the first that lacks sheets; no code: none
  std::size_t sheetsMissing = 0;               ///< of that occasion
  std::vector<OccasionSheets> calledSheets{};  ///< of other occasions that the trainee was called to
  TrialId runningTrialId{};                    ///< empty: nothing runs
  std::string station{};                       ///< where it runs
  std::int64_t runningSinceUtc_us = 0;
  std::size_t deviations = 0;
  std::optional<DaySlot> slot{};  ///< of today that counts now (slotAt()); empty: none planned
  bool overdue = false;           ///< the slot has begun, the trainee has not

  [[nodiscard]] std::int64_t trained_us() const noexcept { return progress.virtual_us + progress.real_us; }
  /// Of the occasion that is due and of all that the trainee was called to.
  [[nodiscard]] std::size_t allSheetsMissing() const noexcept;
};

struct DayBoard {
  std::string cohortName{};
  bool hasCurriculum = false;
  Occasions occasions{};                 ///< of the cohort
  std::vector<DayBoardRow> rows{};       ///< by group and number
  std::vector<StationState> stations{};  ///< by name; silent for kStationSilence_us: not answering
  std::int64_t asOfUtc_us = 0;
};
/// Something that whoever runs the day should look at.
struct DayAlert {
  enum class Kind {
    kStationSilent,  ///< no heartbeat; `subject` is the station
    kDeviceUnfit,    ///< the last check of a device forbids scored runs; `subject` is the station
    kServoUneven,    ///< the last run there had its force cut or ticks skipped; `subject` is the station
    kTrialOpen,      ///< a recording runs on a station that sends no heartbeat
    kSlotOverdue,    ///< the slot has begun, nothing was trained or scored; `station` is the place
    kRestTooLong,    ///< longer than the curriculum allows
    kSheetsMissing,  ///< of an occasion that the exposure has reached, or that trainees were called to
    kNoGroup,        ///< enrolled, but not allocated
  };
  Kind kind = Kind::kStationSilent;
  std::string subject{};  ///< station or code of the trainee
  std::string station{};
  Occasion occasion{};
  std::int64_t sinceUtc_us = 0;
  std::size_t count = 0;
  Text reason{};  ///< why a device is not fit; what was wrong with the run
  Text remedy{};  ///< what to do about the run
};
/// Most urgent first. What does not concern one person counts once: groups that are not drawn, missing sheets
/// by occasion.
[[nodiscard]] std::vector<DayAlert> dayAlerts(const DayBoard& board);

/// Two trainees take each other's turn today, and each other's slot where both have one; their groups stay as
/// they were drawn. A deviation of kind "swapped" for each, naming the other, both or none. kStudySetup.
/// Throws Error{kBadData} for one and the same trainee.
void swapTurns(SessionContext& session, const CohortId& cohortId, const EnrolmentId& enrolmentId,
               const EnrolmentId& otherEnrolmentId, const std::string& reason);

/// Everything about today in one look. kStudySetup.
[[nodiscard]] DayBoard dayBoard(SessionContext& session, const CohortId& cohortId);

/// An alert of the day in one sentence, the same wherever it is shown. `since` and `occasion`: as the place
/// writes a time, and names an occasion.
[[nodiscard]] Text alertText(const DayAlert& alert, const std::string& since, const Text& occasion);

}  // namespace torsio
