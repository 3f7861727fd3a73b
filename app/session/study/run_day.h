// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/session/access/workplace.h"
#include "db/repository/curriculum_repository.h"
#include "db/repository/station_repository.h"
#include "db/repository/study_repository.h"

namespace torsio {

/// Where somebody stands in an arm, from the time that was logged.
struct PhaseProgress {
  std::size_t phase = 0;  ///< position in StoredArm::phases; their number: all done
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
[[nodiscard]] PhaseProgress phaseProgress(const StoredArm& arm, std::span<const StoredExposure> exposures);

/// One line of the board.
struct RunDayRow {
  std::string enrolmentId{};
  std::string traineeId{};
  std::string traineeCode{};
  std::string state{};      ///< of the enrolment
  std::string groupCode{};  ///< empty: not allocated
  std::string armLabel{};
  std::string phaseLabel{};  ///< empty: no curriculum, or all done
  std::string phaseKind{};
  PhaseProgress progress{};
  bool done = false;              ///< all phases
  std::string scoringPointDue{};  ///< the newest one that the exposure has reached: "pre", "mid", "post"
  std::size_t sheetsMissing = 0;  ///< of that scoring point
  std::string runningTrialId{};   ///< empty: nothing runs
  std::string station{};          ///< where it runs
  std::int64_t runningSinceUtc_us = 0;
  std::size_t deviations = 0;
};

struct RunDayBoard {
  std::string cohortName{};
  std::vector<RunDayRow> rows{};         ///< by group and number
  std::vector<StationState> stations{};  ///< by name; silent for kStationSilence_us: not answering
  std::int64_t asOfUtc_us = 0;
};
/// Everything about today in one look. kStudySetup.
[[nodiscard]] RunDayBoard runDayBoard(Workplace& workplace, const std::string& cohortId);

}  // namespace torsio
