// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/study/live_call.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/services/scoring/scoring_service.h"
#include "app/services/study/cohort_service.h"
#include "app/services/study/day_board.h"
#include "app/services/study/open_sheets.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/assignment.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/call_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/study_repository.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace {

std::string plainCode(const std::string& code) {
  std::string plain;
  for (const char c : code) {
    if (std::isspace(static_cast<unsigned char>(c)) == 0) {
      plain.push_back(static_cast<char>(std::toupper(static_cast<unsigned char>(c))));
    }
  }
  return plain;
}

std::int64_t minutesOf(std::int64_t span_us) {
  return std::lround(std::floor(static_cast<double>(span_us) / kMinute_us));
}

/// Returns why the curriculum does not expect a call now; empty: it is due.
std::optional<Text> objectionTo(const Occasion& wanted, const DayBoardRow& row) {
  if (!wanted.afterExposure_us) {
    return std::nullopt;
  }
  const std::int64_t trained_us = row.trained_us();
  if (trained_us < *wanted.afterExposure_us) {
    return Text::tr("%1 has trained %2 of %3 min", row.traineeCode, minutesOf(trained_us),
                    minutesOf(*wanted.afterExposure_us));
  }
  const bool laterDue =
      row.occasionDue.afterExposure_us && *row.occasionDue.afterExposure_us > *wanted.afterExposure_us;
  if (laterDue || (*wanted.afterExposure_us == 0 && trained_us > 0)) {
    return Text::tr("%1 has trained %2 min already", row.traineeCode, minutesOf(trained_us));
  }
  return std::nullopt;
}

/// Live sheets of a case that were not withdrawn.
struct LiveSheets {
  std::string caseLabel;
  std::size_t asked = 0;
  std::size_t submitted = 0;
  std::int64_t newestMark_us = 0;
  std::vector<RaterId> missing;

  [[nodiscard]] bool isSealedSince(const LiveCall& call) const noexcept {
    return newestMark_us >= call.calledUtc_us;
  }
};
using SheetsOfCases = std::map<std::pair<EnrolmentId, std::string>, LiveSheets>;

SheetsOfCases liveSheets(SessionContext& session, const CohortId& cohortId) {
  SheetsOfCases all;
  for (const AssignmentStatus& status : SheetRepository(session.connection()).assignments(cohortId)) {
    const Assignment& one = status.assignment;
    if (status.state == SheetState::kWithdrawn || !one.trialId.empty()) {
      continue;
    }
    LiveSheets& sheets = all[{one.enrolmentId, one.occasionCode}];
    sheets.caseLabel = one.caseLabel;
    ++sheets.asked;
    if (status.state == SheetState::kSubmitted) {
      ++sheets.submitted;
      sheets.newestMark_us = std::max(sheets.newestMark_us, status.changedUtc_us);
    } else {
      sheets.missing.push_back(one.raterId);
    }
  }
  return all;
}

DayBoardRow rowOf(SessionContext& session, const CallRequest& request) {
  DayBoard board = dayBoard(session, request.cohortId);
  const auto found = std::find_if(board.rows.begin(), board.rows.end(), [&](const DayBoardRow& row) {
    return row.enrolmentId == request.enrolmentId;
  });
  if (found == board.rows.end()) {
    refuse(Text::tr("this trainee is not in the cohort"), request.enrolmentId,
           Text::tr("Choose one from the list"));
  }
  if (found->state == EnrolmentState::kWithdrawn) {
    refuse(Text::tr("has withdrawn from the study"), found->traineeCode, Text::tr("Call somebody else"));
  }
  return std::move(*found);
}

LiveCall openCall(SessionContext& session, const CohortId& cohortId, const LiveCallId& callId) {
  for (LiveCall& call : CallRepository(session.connection()).calls(cohortId)) {
    if (call.id == callId && !call.endedUtc_us) {
      return std::move(call);
    }
  }
  refuse(Text::tr("this call has ended already"), callId, Text::tr("Refresh Today's sessions"));
}

nlohmann::json callJson(const std::string& occasionCode, const std::string& room) {
  return {{"occasion", occasionCode}, {"room", room}};
}

/// Returns who is at the arm; the call may be of another cohort than the one on the screen.
Text whoIsCalled(SessionContext& session, const LiveCall& call) {
  for (const Cohort& cohort : StudyRepository(session.connection()).cohorts()) {
    for (const DayBoardRow& row : dayBoard(session, cohort.id).rows) {
      if (row.enrolmentId == call.enrolmentId) {
        return Text::tr("%1 (cohort %2) is called in this room", row.traineeCode, cohort.name);
      }
    }
  }
  return Text::tr("another trainee is called in this room");
}

/// Returns the open call of the same case; throws if the room or trainee is in another call.
std::optional<LiveCallId> alreadyCalled(SessionContext& session, const CallRequest& request,
                                        const Occasion& occasion) {
  CallRepository calls(session.connection());
  for (const LiveCall& call : calls.calls(request.cohortId)) {
    if (call.endedUtc_us || call.enrolmentId != request.enrolmentId) {
      continue;
    }
    if (call.occasionCode == occasion.code && call.room == request.room) {
      return call.id;
    }
    refuse(Text::tr("this trainee is called in %1 already", call.room), request.room,
           Text::tr("End that call first"));
  }
  if (const std::optional<LiveCall> other = calls.openIn(request.room)) {
    refuse(whoIsCalled(session, *other), request.room, Text::tr("End that call first"));
  }
  return std::nullopt;
}

}  // namespace

CallCheck checkCall(SessionContext& session, const CallRequest& request) {
  session.require(Operation::kStudySetup);
  refuseWhenClosed(StudyRepository(session.connection()).cohort(request.cohortId));
  const DayBoardRow row = rowOf(session, request);
  CallCheck check;
  if (request.occasionCode.empty()) {
    check.occasion = row.occasionDue;
    if (check.occasion.code.empty()) {
      refuse(Text::tr("no occasion is due"), row.traineeCode, Text::tr("Choose the occasion"));
    }
  } else {
    const Occasions occasions = occasionsOfCohort(session.connection(), request.cohortId);
    if (!occasions.contains(request.occasionCode)) {
      refuse(Text::tr("this cohort has no such occasion"), request.occasionCode,
             Text::tr("Choose one from the list"));
    }
    check.occasion = occasions.named(request.occasionCode);
  }
  const SheetsOfCases cases = liveSheets(session, request.cohortId);
  const auto sheets = cases.find({request.enrolmentId, check.occasion.code});
  if (sheets == cases.end()) {
    refuse(Text::tr("no rater is asked to score %1 on the real arm at the occasion \"%2\"", row.traineeCode,
                    check.occasion.label),
           Text::tr("the scoring plan"), Text::tr("Invite raters under Scoring"));
  }
  if (sheets->second.missing.empty()) {
    refuse(Text::tr("all sheets of the occasion \"%1\" are in", check.occasion.label), row.traineeCode,
           Text::tr("Call somebody else"));
  }
  check.objection = objectionTo(check.occasion, row);
  return check;
}

LiveCallId callTrainee(SessionContext& session, const CallRequest& request) {
  session.require(Operation::kStudySetup);
  if (request.room.empty()) {
    refuseParameter(Text::tr("a call needs a room"), Text::tr("today's sessions"),
                    Text::tr("Enter the room of the real arm"));
  }
  Transaction transaction(session.connection());
  const CallCheck check = checkCall(session, request);
  if (check.objection && request.reason.empty()) {
    refuseParameter(*check.objection, check.occasion.code, Text::tr("Say why the trainee is called anyway"));
  }
  if (const auto open = alreadyCalled(session, request, check.occasion)) {
    return *open;
  }
  if (check.objection) {
    reportDeviation(session, {.cohortId = request.cohortId,
                              .enrolmentId = request.enrolmentId,
                              .kind = "other",
                              .description = "called for \"" + check.occasion.label + "\" although " +
                                             check.objection->str() + ": " + request.reason});
  }
  const LiveCall call{.id = session.ids().newUuid(),
                      .enrolmentId = request.enrolmentId,
                      .occasionCode = check.occasion.code,
                      .room = request.room,
                      .calledBy = session.actor().userId,
                      .calledUtc_us = session.now_us()};
  CallRepository(session.connection()).add(std::span(&call, 1));
  session.note(AuditAction::kCallBegin, AuditObject::kLiveCall, call.id,
               callJson(call.occasionCode, call.room));
  transaction.commit();
  return call.id;
}

void endCall(SessionContext& session, const CohortId& cohortId, const LiveCallId& callId) {
  session.require(Operation::kStudySetup);
  Transaction transaction(session.connection());
  const LiveCall call = openCall(session, cohortId, callId);
  CallRepository(session.connection()).end(callId, false, session.now_us());
  session.note(AuditAction::kCallEnd, AuditObject::kLiveCall, callId, callJson(call.occasionCode, call.room));
  transaction.commit();
}

void cancelCall(SessionContext& session, const CohortId& cohortId, const LiveCallId& callId,
                const std::string& reason) {
  session.require(Operation::kStudySetup);
  if (reason.empty()) {
    refuseParameter(Text::tr("withdrawing a call needs a reason"), callId,
                    Text::tr("Say in a few words why"));
  }
  Transaction transaction(session.connection());
  const LiveCall call = openCall(session, cohortId, callId);
  const SheetsOfCases cases = liveSheets(session, cohortId);
  const auto sheets = cases.find({call.enrolmentId, call.occasionCode});
  if (sheets != cases.end() && sheets->second.isSealedSince(call)) {
    refuse(Text::tr("a sheet of this call is submitted already"), sheets->second.caseLabel,
           Text::tr("End the call and report a deviation"));
  }
  CallRepository(session.connection()).end(callId, true, session.now_us());
  session.note(AuditAction::kCallCancel, AuditObject::kLiveCall, callId,
               callJson(call.occasionCode, call.room), reason);
  transaction.commit();
}

std::vector<CalledCase> calledCases(SessionContext& session, const CohortId& cohortId) {
  session.require(Operation::kStudySetup);
  // If a case was called twice, only the latest call counts.
  std::map<std::pair<EnrolmentId, std::string>, LiveCall> newest;
  for (LiveCall& call : CallRepository(session.connection()).calls(cohortId)) {
    if (!call.cancelled) {
      newest[{call.enrolmentId, call.occasionCode}] = std::move(call);
    }
  }
  if (newest.empty()) {
    return {};  // the board polls every few seconds, mostly without calls
  }
  std::map<EnrolmentId, std::string> codes;
  for (const Enrolment& enrolment : StudyRepository(session.connection()).enrolments(cohortId)) {
    codes[enrolment.id] = enrolment.traineeCode;
  }
  const Occasions occasions = occasionsOfCohort(session.connection(), cohortId);
  const SheetsOfCases sheets = liveSheets(session, cohortId);
  std::map<RaterId, std::string> raters;
  for (const Rater& rater : PeopleRepository(session.connection()).raters()) {
    raters[rater.person.id] = rater.person.code;
  }
  std::vector<CalledCase> all;
  for (const auto& [key, call] : newest) {
    const auto found = sheets.find(key);
    const LiveSheets known = found == sheets.end() ? LiveSheets{} : found->second;
    if (call.endedUtc_us && known.missing.empty()) {
      continue;
    }
    CalledCase one{.call = call,
                   .caseLabel = known.caseLabel,
                   .traineeCode = codes[key.first],
                   .occasion = occasions.named(key.second),
                   .asked = known.asked,
                   .submitted = known.submitted,
                   .mayCancel = !call.endedUtc_us && !known.isSealedSince(call)};
    for (const RaterId& rater : known.missing) {
      one.missing.push_back(raters[rater]);
    }
    std::sort(one.missing.begin(), one.missing.end());
    all.push_back(std::move(one));
  }
  std::sort(all.begin(), all.end(), [](const CalledCase& a, const CalledCase& b) {
    return std::pair(a.call.endedUtc_us.has_value(), a.call.calledUtc_us) <
           std::pair(b.call.endedUtc_us.has_value(), b.call.calledUtc_us);
  });
  return all;
}

std::string missingCodes(const CalledCase& called) {
  std::string codes;
  for (const std::string& code : called.missing) {
    codes += (codes.empty() ? "" : ", ") + code;
  }
  return codes;
}

Text missingText(const CalledCase& called, const std::string& codes) {
  if (called.call.endedUtc_us) {
    return called.missing.empty() ? Text() : Text::tr("missing: %1", codes);
  }
  return called.missing.empty() || called.submitted == 0 ? Text() : Text::tr("still to come: %1", codes);
}

Text reminderText(const CalledCase& called) {
  return Text::tr("Please submit your sheet of case %1 in Torsio (Live sheet): %2", called.caseLabel,
                  missingCodes(called));
}

void noteCopiedReminder(SessionContext& session, const CohortId& cohortId, const CalledCase& called) {
  std::vector<Reminder> reminded;
  for (Reminder& one : reminders(session, cohortId)) {
    std::erase_if(one.sheets, [&](const SheetAwaited& sheet) {
      return !sheet.live || sheet.caseLabel != called.caseLabel;
    });
    if (!one.sheets.empty()) {
      reminded.push_back(std::move(one));
    }
  }
  noteReminders(session, reminded, ReminderWay::kCopied);
}

std::string callStamp(SessionContext& session) {
  return CallRepository(session.connectionWithoutRight()).stamp();
}

EnrolmentId enrolmentWithCode(SessionContext& session, const CohortId& cohortId, const std::string& code) {
  session.require(Operation::kStudySetup);
  for (const Enrolment& enrolment : StudyRepository(session.connection()).enrolments(cohortId)) {
    if (plainCode(enrolment.traineeCode) == plainCode(code)) {
      return enrolment.id;
    }
  }
  refuse(Text::tr("nobody in this cohort has this code"), code,
         Text::tr("Scan the card again, or type the code"));
}

}  // namespace torsio
