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
#include "assessment/domain/study/occasion.h"
#include "assessment/domain/study/protocol_terms.h"
#include "assessment/domain/study/station_state.h"
#include "sim/core/text.h"

namespace torsio {

/// Progress of a person in an arm, from the logged time.
struct PhaseProgress {
  std::size_t phase = 0;  ///< index in StudyArm::phases; their number: all done
  std::int64_t inPhase_us = 0;
  std::int64_t left_us = 0;     ///< of this phase
  std::int64_t virtual_us = 0;  ///< spent so far
  std::int64_t real_us = 0;
  std::int64_t restUsed_us = 0;
  std::int64_t restLeft_us = 0;
  std::size_t rests = 0;
};
/// Time with a phase id counts for that phase; other virtual or real time is distributed over the phases of
/// its kind in order. Rest counts for no phase. An allowance that may not be split is used up by the first
/// rest.
[[nodiscard]] PhaseProgress phaseProgress(const StudyArm& arm, std::span<const Exposure> exposures);

/// Returns whether an arm plans this kind of time. Rest is always allowed; for an arm without phases,
/// everything is.
[[nodiscard]] bool isPlanned(const StudyArm& arm, ExposureKind kind);

/// Missing sheets of a trainee at an occasion.
struct OccasionSheets {
  Occasion occasion{};
  std::size_t missing = 0;  ///< at least one
};

/// One row of the board.
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
  std::vector<ExposureKind> unplanned{};       ///< kinds of time that the arm does not plan (isPlanned())
  Occasion occasionDue{};                      ///< latest one reached; if there are several, the first one
                                               ///< with missing sheets; without a code: none
  std::size_t sheetsMissing = 0;               ///< at that occasion, unless its call is open
  std::size_t sheetsToCome = 0;                ///< of an open call: they are being scored
  std::vector<OccasionSheets> calledSheets{};  ///< at other occasions that the trainee was called for
  TrialId runningTrialId{};                    ///< empty: none
  std::string station{};                       ///< of the running trial
  std::int64_t runningSinceUtc_us = 0;
  std::size_t deviations = 0;
  std::optional<DaySlot> slot{};  ///< today's slot that applies now (slotAt()); empty: none
  bool overdue = false;           ///< the slot has begun, but the trainee has not

  [[nodiscard]] std::int64_t trained_us() const noexcept { return progress.virtual_us + progress.real_us; }
  /// Counts the occasion due and all that the trainee was called for; not those of an open call.
  [[nodiscard]] std::size_t allSheetsMissing() const noexcept;
};

struct DayBoard {
  std::string cohortName{};
  bool hasCurriculum = false;
  Occasions occasions{};                 ///< of the cohort
  std::vector<DayBoardRow> rows{};       ///< by group and number
  std::vector<StationState> stations{};  ///< by name; silent after kStationSilence_us
  std::int64_t asOfUtc_us = 0;
};
/// Something that needs attention today.
struct DayAlert {
  enum class Kind {
    kStationSilent,  ///< no heartbeat; `subject` is the station
    kDeviceUnfit,    ///< the last device check forbids scored runs; `subject` is the station
    kServoUneven,    ///< force was cut or ticks were skipped in the last run; `subject` is the station
    kTrialOpen,      ///< a recording is running on a station without heartbeat
    kSlotOverdue,    ///< the slot has begun without training or scoring; `station` is the place
    kRestTooLong,    ///< longer than the curriculum allows
    kSheetsMissing,  ///< at an occasion that was reached or called
    kNoGroup,        ///< enrolled but not allocated
  };
  Kind kind = Kind::kStationSilent;
  std::string subject{};  ///< station or trainee code
  std::string station{};
  Occasion occasion{};
  std::int64_t sinceUtc_us = 0;
  std::size_t count = 0;
  Text reason{};  ///< why a device is not fit, or what was wrong with the run
  Text remedy{};  ///< remedy for the run
};
/// Most urgent first. Alerts that concern no single person are merged: missing groups, missing sheets by
/// occasion, in the order of occasions.
[[nodiscard]] std::vector<DayAlert> dayAlerts(const DayBoard& board);

/// Swaps the turns of two trainees today, and their slots if both have one; their groups do not change.
/// Records a deviation of kind "swapped" for each, naming the other; all or nothing. kStudySetup. Throws
/// Error{kBadData} if both are the same trainee.
void swapTurns(SessionContext& session, const CohortId& cohortId, const EnrolmentId& enrolmentId,
               const EnrolmentId& otherEnrolmentId, const std::string& reason);

/// Returns today's overview. kStudySetup.
[[nodiscard]] DayBoard dayBoard(SessionContext& session, const CohortId& cohortId);

/// Describes the sheets of a row: "2", "3 to come", "2, 3 to come"; empty: none.
[[nodiscard]] Text sheetsText(const DayBoardRow& row);

/// Describes an alert of the day in one sentence, the same everywhere. `since` and `occasion`: formatted by
/// the caller.
[[nodiscard]] Text alertText(const DayAlert& alert, const std::string& since, const Text& occasion);

}  // namespace torsio
