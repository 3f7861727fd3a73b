// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/study/day_board.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "app/services/devices/device_readiness.h"
#include "app/services/scoring/scoring_service.h"
#include "app/services/study/cohort_service.h"
#include "app/services/study/day_plan.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/assignment.h"
#include "db/connection/connection.h"
#include "db/repository/rating/call_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/occasion_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/station_repository.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

/// Distributes time without a phase over the phases of one kind, in order.
void fillInOrder(const StudyArm& arm, PhaseKind kind, std::int64_t time_us,
                 std::vector<std::int64_t>& spent_us) {
  for (std::size_t i = 0; i < arm.phases.size() && time_us > 0; ++i) {
    if (arm.phases[i].kind != kind) {
      continue;
    }
    const std::int64_t room_us = std::max<std::int64_t>(0, arm.phases[i].duration_us - spent_us[i]);
    const std::int64_t part_us = std::min(room_us, time_us);
    spent_us[i] += part_us;
    time_us -= part_us;
  }
}

void countRest(const StudyArm& arm, std::int64_t duration_us, PhaseProgress& progress) {
  progress.restUsed_us += duration_us;
  ++progress.rests;
  progress.restLeft_us =
      arm.restSplittable ? std::max<std::int64_t>(0, arm.restAllowance_us - progress.restUsed_us) : 0;
}

/// `arm`: without phases for a person without a group.
void fillTraining(DayBoardRow& row, const StudyArm& arm, const std::vector<Exposure>& exposures) {
  row.armLabel = arm.label;
  row.restAllowance_us = arm.restAllowance_us;
  row.progress = phaseProgress(arm, exposures);
  for (const ExposureKind kind : {ExposureKind::kVirtual, ExposureKind::kReal}) {
    if (!isPlanned(arm, kind)) {
      row.unplanned.push_back(kind);
    }
  }
  row.done = !arm.phases.empty() && row.progress.phase == arm.phases.size();
  if (!row.done && !arm.phases.empty()) {
    row.phaseLabel = arm.phases[row.progress.phase].label;
    row.phaseKind = storedText(arm.phases[row.progress.phase].kind);
  }
}

/// Number of sheets of a trainee at an occasion.
struct SheetCount {
  std::size_t asked = 0;  ///< not withdrawn
  std::size_t missing = 0;
};
/// By enrolment and occasion code.
using SheetCounts = std::map<std::pair<std::string, std::string>, SheetCount>;

/// Returns the latest occasion reached with this training time. If several have the same time, the first one
/// with missing sheets: a follow-up is due when the occasion before it is complete. Without a code if there
/// is none.
Occasion occasionDue(const Occasions& occasions, std::int64_t trained_us, const EnrolmentId& enrolmentId,
                     const SheetCounts& sheets) {
  Occasion due;
  for (const Occasion& occasion : occasions) {
    if (!occasion.afterExposure_us || trained_us < *occasion.afterExposure_us) {
      continue;
    }
    if (due.afterExposure_us == occasion.afterExposure_us) {
      const auto count = sheets.find({enrolmentId, due.code});
      if (count == sheets.end() || count->second.asked == 0 || count->second.missing > 0) {
        continue;
      }
    }
    due = occasion;
  }
  return due;
}

}  // namespace

bool isPlanned(const StudyArm& arm, ExposureKind kind) {
  return kind == ExposureKind::kRest || arm.phases.empty() ||
         std::any_of(arm.phases.begin(), arm.phases.end(),
                     [kind](const TrainingPhase& phase) { return exposureIn(phase.kind) == kind; });
}

PhaseProgress phaseProgress(const StudyArm& arm, std::span<const Exposure> exposures) {
  PhaseProgress progress;
  progress.restLeft_us = arm.restAllowance_us;
  std::vector<std::int64_t> spent_us(arm.phases.size(), 0);
  std::map<ExposureKind, std::int64_t> unnamed_us;
  for (const Exposure& exposure : exposures) {
    if (exposure.kind == ExposureKind::kRest) {
      countRest(arm, exposure.duration_us, progress);
      continue;
    }
    (exposure.kind == ExposureKind::kVirtual ? progress.virtual_us : progress.real_us) +=
        exposure.duration_us;
    const auto phase = std::find_if(arm.phases.begin(), arm.phases.end(), [&](const TrainingPhase& p) {
      return !exposure.phaseId.empty() && p.id == exposure.phaseId;
    });
    if (phase == arm.phases.end()) {
      unnamed_us[exposure.kind] += exposure.duration_us;
    } else {
      spent_us[static_cast<std::size_t>(phase - arm.phases.begin())] += exposure.duration_us;
    }
  }
  for (const PhaseKind kind : {PhaseKind::kReal, PhaseKind::kVirtual}) {
    fillInOrder(arm, kind, unnamed_us[exposureIn(kind)], spent_us);
  }
  while (progress.phase < arm.phases.size() &&
         spent_us[progress.phase] >= arm.phases[progress.phase].duration_us) {
    ++progress.phase;
  }
  if (progress.phase < arm.phases.size()) {
    progress.inPhase_us = spent_us[progress.phase];
    progress.left_us = arm.phases[progress.phase].duration_us - progress.inPhase_us;
  }
  return progress;
}

namespace {

/// Data of a cohort by enrolment.
struct Today {
  std::vector<DaySlot> slots;                ///< half a day before and after
  std::map<std::string, std::int64_t> seen;  ///< last time of training, rest or call
  std::map<std::string, std::vector<Exposure>> exposures;
  std::map<std::string, RunningTrial> running;
  std::map<std::string, std::size_t> deviations;
  SheetCounts sheets;
  std::map<std::string, std::set<std::string>> called;  ///< codes of occasions with an ended call
  std::map<std::string, std::set<std::string>> open;    ///< codes of occasions with an open call
};

Today readToday(SessionContext& session, const CohortId& cohortId) {
  StudyRepository study(session.connection());
  Today today;
  for (Exposure& exposure : study.exposures(cohortId)) {
    today.exposures[exposure.enrolmentId].push_back(std::move(exposure));
  }
  for (const auto& [enrolment, exposures] : today.exposures) {
    for (const Exposure& exposure : exposures) {
      std::int64_t& seen_us = today.seen[enrolment];
      seen_us = std::max(seen_us, exposure.startedUtc_us + exposure.duration_us);
    }
  }
  for (const LiveCall& call : CallRepository(session.connection()).calls(cohortId)) {
    std::int64_t& seen_us = today.seen[call.enrolmentId];
    seen_us = std::max(seen_us, call.cancelled ? 0 : call.calledUtc_us);
    if (!call.cancelled) {
      (call.endedUtc_us ? today.called : today.open)[call.enrolmentId].insert(call.occasionCode);
    }
  }
  today.slots = SlotRepository(session.connection())
                    .between(cohortId, session.now_us() - kHalfDay_us, session.now_us() + kHalfDay_us);
  for (RunningTrial& trial : study.runningTrials(cohortId)) {
    today.running.emplace(trial.enrolmentId, std::move(trial));
  }
  for (const ProtocolDeviation& deviation : study.deviations(cohortId)) {
    ++today.deviations[deviation.enrolmentId];
  }
  for (const AssignmentStatus& status : SheetRepository(session.connection()).assignments(cohortId)) {
    SheetCount& count = today.sheets[{status.assignment.enrolmentId, status.assignment.occasionCode}];
    count.asked += status.state == SheetState::kWithdrawn ? 0U : 1U;
    count.missing += isOutstanding(status.state) ? 1U : 0U;
  }
  return today;
}

/// In the order of `occasions`.
void fillSheets(DayBoardRow& row, const Occasions& occasions, Today& today) {
  const std::set<std::string>& called = today.called[row.enrolmentId];
  const std::set<std::string>& open = today.open[row.enrolmentId];
  for (const Occasion& occasion : occasions) {
    const std::size_t missing = today.sheets[{row.enrolmentId, occasion.code}].missing;
    if (open.contains(occasion.code)) {
      row.sheetsToCome += missing;
    } else if (occasion.code == row.occasionDue.code) {
      row.sheetsMissing = missing;
    } else if (missing > 0 && called.contains(occasion.code)) {
      row.calledSheets.push_back({occasion, missing});
    }
  }
}

}  // namespace

std::size_t DayBoardRow::allSheetsMissing() const noexcept {
  std::size_t missing = sheetsMissing;
  for (const OccasionSheets& one : calledSheets) {
    missing += one.missing;
  }
  return missing;
}

Text sheetsText(const DayBoardRow& row) {
  const std::size_t missing = row.allSheetsMissing();
  if (row.sheetsToCome == 0) {
    return missing == 0 ? Text() : Text(std::to_string(missing));
  }
  return missing == 0 ? Text::tr("%1 to come", row.sheetsToCome)
                      : Text::tr("%1, %2 to come", missing, row.sheetsToCome);
}

DayBoard dayBoard(SessionContext& session, const CohortId& cohortId) {
  session.require(Operation::kStudySetup);
  StudyRepository study(session.connection());
  DayBoard board;
  board.asOfUtc_us = session.now_us();
  board.stations = StationRepository(session.connection()).board();
  const Cohort cohort = study.cohort(cohortId);
  board.cohortName = cohort.name;
  board.occasions = occasionsOfCohort(session.connection(), cohortId);
  const auto version = CurriculumRepository(session.connection()).version(cohort.curriculumVersionId);
  board.hasCurriculum = version.has_value();
  std::map<std::string, const StudyArm*> armOfGroup;
  for (const StudyGroup& group : study.groups(cohortId)) {
    if (!version) {
      break;
    }
    for (const StudyArm& arm : version->arms) {
      if (arm.id == group.armId) {
        armOfGroup[group.id] = &arm;
      }
    }
  }
  Today today = readToday(session, cohortId);
  for (const Enrolment& enrolment : study.enrolments(cohortId)) {
    DayBoardRow row;
    row.enrolmentId = enrolment.id;
    row.traineeId = enrolment.traineeId;
    row.traineeCode = enrolment.traineeCode;
    row.state = enrolment.state;
    row.groupCode = enrolment.groupCode;
    row.deviations = today.deviations[enrolment.id];
    const auto arm = armOfGroup.find(enrolment.groupId);
    fillTraining(row, arm == armOfGroup.end() ? StudyArm{} : *arm->second, today.exposures[enrolment.id]);
    row.occasionDue = occasionDue(board.occasions, row.trained_us(), enrolment.id, today.sheets);
    fillSheets(row, board.occasions, today);
    if (const auto trial = today.running.find(enrolment.id); trial != today.running.end()) {
      row.runningTrialId = trial->second.trialId;
      row.station = trial->second.station;
      row.runningSinceUtc_us = trial->second.startedUtc_us;
    }
    if (const DaySlot* slot = slotAt(today.slots, enrolment.id, board.asOfUtc_us)) {
      row.slot = *slot;
      row.overdue = row.state != EnrolmentState::kWithdrawn && row.runningTrialId.empty() &&
                    board.asOfUtc_us > slot->startsUtc_us + kSlotGrace_us &&
                    today.seen[enrolment.id] < slot->startsUtc_us - kSlotGrace_us;
    }
    board.rows.push_back(std::move(row));
  }
  return board;
}

namespace {

/// Runs of other days are ignored.
constexpr std::int64_t kOfToday_us = 12LL * 3600 * 1'000'000;

std::optional<DayAlert> servoAlert(const StationState& station, std::int64_t asOfUtc_us) {
  if (!station.lastHealth || asOfUtc_us - station.lastEndedUtc_us > kOfToday_us) {
    return std::nullopt;
  }
  const Text trouble = servoTrouble(*station.lastHealth, station.lastTicks);
  if (trouble.empty()) {
    return std::nullopt;
  }
  return DayAlert{.kind = DayAlert::Kind::kServoUneven,
                  .subject = station.station,
                  .station = station.station,
                  .sinceUtc_us = station.lastEndedUtc_us,
                  .reason = trouble,
                  .remedy = servoRemedy(*station.lastHealth)};
}

}  // namespace

std::vector<DayAlert> dayAlerts(const DayBoard& board) {
  using Kind = DayAlert::Kind;
  std::vector<DayAlert> alerts;
  const auto silent = [&](const StationState& station) {
    return board.asOfUtc_us - station.heartbeatUtc_us > kStationSilence_us;
  };
  for (const StationState& station : board.stations) {
    if (!silent(station)) {
      const StationDevice device = storedDevice(station);
      if (device.light == Light::kRed) {
        alerts.push_back({.kind = Kind::kDeviceUnfit,
                          .subject = station.station,
                          .station = station.station,
                          .sinceUtc_us = device.checkedUtc_us,
                          .reason = device.problem});
      }
      if (std::optional<DayAlert> uneven = servoAlert(station, board.asOfUtc_us)) {
        alerts.push_back(std::move(*uneven));
      }
      continue;
    }
    const bool records = !station.trialId.empty() && !station.ended;
    alerts.push_back({.kind = records ? Kind::kTrialOpen : Kind::kStationSilent,
                      .subject = records ? station.traineeCode : station.station,
                      .station = station.station,
                      .sinceUtc_us = station.heartbeatUtc_us});
  }
  std::stable_partition(alerts.begin(), alerts.end(),
                        [](const DayAlert& alert) { return alert.kind == Kind::kTrialOpen; });
  std::size_t withoutGroup = 0;
  std::map<std::size_t, DayAlert> sheets;  // by the occasion's position
  for (const DayBoardRow& row : board.rows) {
    if (row.state == EnrolmentState::kWithdrawn) {
      continue;
    }
    if (row.groupCode.empty()) {
      ++withoutGroup;
    }
    const auto missing = [&](const Occasion& occasion, std::size_t count) {
      const auto [alert, isNew] =
          sheets.try_emplace(board.occasions.positionOf(occasion.code).value_or(board.occasions.size()),
                             DayAlert{.kind = Kind::kSheetsMissing, .occasion = occasion});
      alert->second.count += count;
    };
    if (row.sheetsMissing > 0) {
      missing(row.occasionDue, row.sheetsMissing);
    }
    for (const OccasionSheets& called : row.calledSheets) {
      missing(called.occasion, called.missing);
    }
    if (row.overdue) {
      alerts.push_back({.kind = Kind::kSlotOverdue,
                        .subject = row.traineeCode,
                        .station = row.slot->place,
                        .sinceUtc_us = row.slot->startsUtc_us});
    }
    if (!row.done && row.progress.restUsed_us > row.restAllowance_us) {
      alerts.push_back({.kind = Kind::kRestTooLong, .subject = row.traineeCode});
    }
  }
  for (const auto& [position, alert] : sheets) {
    alerts.push_back(alert);
  }
  if (withoutGroup > 0) {
    alerts.push_back({.kind = Kind::kNoGroup, .count = withoutGroup});
  }
  return alerts;
}

namespace {

/// Swaps times and places; changes nothing unless both have a slot.
void swapSlots(SessionContext& session, const CohortId& cohortId, const EnrolmentId& one,
               const EnrolmentId& other) {
  const std::int64_t now_us = session.now_us();
  const std::vector<DaySlot> slots = daySlots(session, cohortId, now_us - kHalfDay_us, now_us + kHalfDay_us);
  const DaySlot* first = slotAt(slots, one, now_us);
  const DaySlot* second = slotAt(slots, other, now_us);
  if (first == nullptr || second == nullptr) {
    return;
  }
  SlotRepository repository(session.connection());
  for (const auto& [slot, comes] : {std::pair(first, other), std::pair(second, one)}) {
    repository.give(slot->id, comes);
    session.note(AuditAction::kSlotPlan, AuditObject::kEnrolment, comes, slotJson(*slot));
  }
}

}  // namespace

void swapTurns(SessionContext& session, const CohortId& cohortId, const EnrolmentId& enrolmentId,
               const EnrolmentId& otherEnrolmentId, const std::string& reason) {
  session.require(Operation::kStudySetup);
  if (enrolmentId == otherEnrolmentId) {
    refuse(Text::tr("choose two different trainees"), cohortId, Text::tr("Choose another trainee"));
  }
  Transaction transaction(session.connection());
  std::map<std::string, std::string> codes;
  for (const Enrolment& enrolment : StudyRepository(session.connection()).enrolments(cohortId)) {
    codes[enrolment.id] = enrolment.traineeCode;
  }
  for (const std::string& id : {enrolmentId, otherEnrolmentId}) {
    if (!codes.contains(id)) {
      refuse(Text::tr("this trainee is not in the cohort"), id, Text::tr("Choose one from the list"));
    }
  }
  for (const auto& [id, other] :
       {std::pair(enrolmentId, otherEnrolmentId), std::pair(otherEnrolmentId, enrolmentId)}) {
    reportDeviation(session, {.cohortId = cohortId,
                              .enrolmentId = id,
                              .kind = std::string(storedText(DeviationKind::kSwapped)),
                              .description = "turn swapped with " + codes.at(other) +
                                             (reason.empty() ? "" : ": " + reason)});
  }
  swapSlots(session, cohortId, enrolmentId, otherEnrolmentId);
  transaction.commit();
}

Text alertText(const DayAlert& alert, const std::string& since, const Text& occasion) {
  using Kind = DayAlert::Kind;
  switch (alert.kind) {
    case Kind::kTrialOpen:
      return Text::tr("%1 was recording at %2, which has not answered since %3. Go and look.", alert.subject,
                      alert.station, since);
    case Kind::kStationSilent:
      return Text::tr("%1 has not answered since %2.", alert.subject, since);
    case Kind::kDeviceUnfit:
      return Text::tr("%1: the device is not fit for graded runs: %2.", alert.subject, alert.reason);
    case Kind::kServoUneven:
      return Text::tr("%1, last run: %2. %3.", alert.subject, alert.reason, alert.remedy);
    case Kind::kSlotOverdue:
      return Text::tr("%1 was expected at %2, %3, and has not begun.", alert.subject, since, alert.station);
    case Kind::kRestTooLong:
      return Text::tr("%1 has rested longer than allowed.", alert.subject);
    case Kind::kSheetsMissing:
      return Text::tr("%1: sheets still missing: %2.", occasion, alert.count);
    case Kind::kNoGroup:
      return Text::tr("Trainees without a group: %1. Draw them under Allocation.", alert.count);
  }
  return {};
}

}  // namespace torsio
