// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/review/case_sheet.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/services/access/centre_settings.h"
#include "app/services/access/signing.h"
#include "app/services/review/panel_opening.h"
#include "app/services/review/sheet_editor.h"
#include "app/services/review/watched_time.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/mark.h"
#include "assessment/domain/rating/written_words.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/repository/base/id_source.h"
#include "db/repository/rating/call_repository.h"
#include "db/repository/rating/desk_repository.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/rating/rubric_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

nlohmann::json seenJson(const BlindedCase& shown, const WatchLog& watched) {
  nlohmann::json json = shown.live ? nlohmann::json() : viewingNote(watched);
  json["worked_s"] = watched.worked_us() / 1'000'000;
  return json;
}

void requireSheetWords(const Sheet& sheet, const std::string& label) {
  const Text where = Text::tr("case %1", label);
  requireWords(sheet.comment, kLongestComment, where);
  requireWords(sheet.notAssessableReason, kLongestReason, where);
  for (const SheetRow& row : sheet.rows) {
    requireWords(row.notAssessableReason, kLongestReason, where);
  }
}

/// Throws unless the live case was called: a trainee who is not at the arm cannot be scored.
void requireCalled(SessionContext& session, const Assignment& assignment) {
  if (assignment.trialId.empty() &&
      !CallRepository(session.connection()).wasCalled(assignment.enrolmentId, assignment.occasionCode)) {
    refuse(Text::tr("this case has not been called to the real arm yet"),
           Text::tr("case %1", assignment.caseLabel),
           Text::tr("Its sheet opens by itself when an administrator calls it"));
  }
}

}  // namespace

nlohmann::json viewingNote(const WatchLog& watched) {
  return {{"watched", std::round(watched.share() * 1000.0) / 1000.0},
          {"slowest", watched.slowest()},
          {"fastest", watched.fastest()}};
}

ViewingRules viewingRules(SessionContext& session) {
  session.require(Operation::kMarkSubmit);
  return centreViewingRules(session.connection());
}

ViewingRules centreViewingRules(Connection& connection) {
  return {.minimumWatched = centreSetting<kMinimumWatched_percent>(connection) / 100.0,
          .speeds = centreSetting<kPlaybackSpeeds>(connection)};
}

KeptAt keptAt(SessionContext& session) {
  session.require(Operation::kMarkSubmit);
  return session.connection().engine() == Engine::kSqlite ? KeptAt::kThisMachine : KeptAt::kServer;
}

OpenedSheet openSheet(SessionContext& session, const AssignmentId& assignmentId) {
  const Assignment assignment = ownAssignment(session, Operation::kMarkSubmit, assignmentId);
  SheetRepository sheets(session.connection());
  DeskRepository desk(session.connection());
  OpenedSheet opened;
  opened.shown = blindedCase(session, assignmentId);
  opened.rubric = RubricRepository(session.connection()).revision(assignment.rubricRevisionId).value();
  const std::int64_t length_us = opened.shown.length_us.value_or(0);
  opened.watched = WatchLog(length_us);
  if (const auto sealed = sheets.submitted(assignmentId)) {
    opened.sheet = *sealed;
    opened.state = SheetState::kSubmitted;
    opened.panelOpen = panelOpenedToUtc_us(session.connection(), assignment.enrolmentId,
                                           assignment.occasionCode, assignment.raterId)
                           .has_value();
  } else if (const auto draft = sheets.draft(assignmentId)) {
    opened.sheet = *draft;
    opened.state = SheetState::kDraft;
  }
  if (opened.shown.live) {
    opened.calledUtc_us = CallRepository(session.connection())
                              .lastCalledUtc_us(assignment.enrolmentId, assignment.occasionCode);
  }
  if (opened.state != SheetState::kSubmitted) {
    requireCalled(session, assignment);
    if (const auto seen = desk.draftViewing(assignmentId)) {
      opened.watched = WatchLog(length_us, *seen);
    }
  }
  return opened;
}

std::int64_t saveSheet(SessionContext& session, const AssignmentId& assignmentId, Sheet sheet,
                       const WatchLog& watched) {
  const Assignment assignment = ownAssignment(session, Operation::kMarkSubmit, assignmentId);
  Transaction transaction(session.connection());
  SheetRepository sheets(session.connection());
  if (sheets.submitted(assignmentId)) {
    throw SheetSealed(assignment.caseLabel);
  }
  requireCalled(session, assignment);
  sheet.changedUtc_us = session.now_us();
  requireSheetWords(sheet, assignment.caseLabel);
  const std::int64_t revision = sheets.saveDraft(assignmentId, sheet);
  DeskRepository desk(session.connection());
  WatchLog all = watched;
  if (const auto seen = desk.draftViewing(assignmentId)) {
    all.join(WatchLog(watched.length_us(), *seen));
  }
  desk.saveDraftViewing(assignmentId, all.stored());
  transaction.commit();
  return revision;
}

SheetCheck checkSheet(const RubricRevision& rubric, const Sheet& sheet, bool live, const WatchLog& watched,
                      const ViewingRules& rules) {
  const SheetEditor whole(rubric, sheet);
  std::vector<SheetLine> lines;
  for (const std::string& row : whole.order()) {
    lines.push_back({row, whole.scale(row), whole.answer(row)});
  }
  std::optional<RecordingWatched> seen;
  if (!live) {
    seen = RecordingWatched{watched.share(), watched.slowest(), watched.fastest()};
  }
  return checkSheetLines(lines, seen, rules);
}

SheetCheck checkSheet(const OpenedSheet& opened, const Sheet& sheet, const WatchLog& watched,
                      const ViewingRules& rules, std::int64_t now_us) {
  SheetCheck check = checkSheet(opened.rubric, sheet, opened.shown.live, watched, rules);
  if (opened.calledUtc_us) {
    check.soonAfterCall_us = soonAfterCall_us(*opened.calledUtc_us, now_us);
  }
  return check;
}

void requireWatched(const SheetCheck& check, const Text& where) {
  if (check.watchedTooLittle) {
    refuse(Text::tr("only %1 % of the recording has been played", std::lround(check.watchedShare * 100.0)),
           where, Text::tr("Play the rest before you submit"));
  }
  if (check.speedNotAllowed) {
    refuse(Text::tr("the recording was played at a speed that is not allowed"), where,
           Text::tr("Play it again at an allowed speed"));
  }
}

SheetSealed::SheetSealed(const std::string& caseLabel)
    : Error(ErrorCode::kBadData, Text::tr("this sheet is sealed already"), Text::tr("case %1", caseLabel),
            Text::tr("Open it again to read it, or to change it with a reason")) {}

namespace {

void seal(SessionContext& session, const Assignment& assignment, const Sheet& sheet,
          const OpenedSheet& opened, const WatchLog& watched) {
  const AssignmentId& assignmentId = opened.shown.assignmentId;
  const MarkId markId = session.ids().newUuid();
  Transaction transaction(session.connection());
  SheetRepository(session.connection()).submit(assignmentId, markId, sheet, "", session.now_us());
  DeskRepository(session.connection()).sealViewing(assignmentId, markId, watched.stored());
  sign(session,
       {.objectId = markId, .meaning = SignatureMeaning::kScored, .demonstration = assignment.demonstration});
  session.note(AuditAction::kSheetSubmit, AuditObject::kAssignment, assignmentId,
               seenJson(opened.shown, watched));
  transaction.commit();
}

}  // namespace

void submitSheet(SessionContext& session, const AssignmentId& assignmentId, const Sheet& sheet,
                 const WatchLog& watchedHere) {
  const Assignment assignment = ownAssignment(session, Operation::kMarkSubmit, assignmentId);
  requireSheetWords(sheet, assignment.caseLabel);
  const OpenedSheet opened = openSheet(session, assignmentId);
  if (opened.state == SheetState::kSubmitted) {
    throw SheetSealed(opened.shown.label);
  }
  WatchLog watched = watchedHere;
  watched.join(opened.watched);
  const SheetCheck check =
      checkSheet(opened.rubric, sheet, opened.shown.live, watched, viewingRules(session));
  requireWatched(check, Text::tr("case %1", opened.shown.label));
  try {
    seal(session, assignment, sheet, opened, watched);
  } catch (const DbError&) {
    if (SheetRepository(session.connection()).submitted(assignmentId)) {
      throw SheetSealed(opened.shown.label);  // by another page, between the question and the answer
    }
    throw;
  }
  endSigning(session);
}

void amendSheet(SessionContext& session, const AssignmentId& assignmentId, const Sheet& sheet,
                const std::string& reason, PanelMarks panel) {
  const Assignment assignment = ownAssignment(session, Operation::kMarkSubmit, assignmentId);
  const std::string where = "case " + assignment.caseLabel;
  if (reason.empty()) {
    refuseParameter(Text::tr("changing a submitted mark needs a reason"), where,
                    Text::tr("Write why you change it"));
  }
  requireWords(reason, kLongestReason, Text::tr("case %1", assignment.caseLabel));
  requireSheetWords(sheet, assignment.caseLabel);
  SheetRepository sheets(session.connection());
  if (!sheets.submitted(assignmentId)) {
    refuse(Text::tr("this sheet is not submitted yet"), where, Text::tr("Fill it in and submit it"));
  }
  if (panel == PanelMarks::kUnseen && panelOpenedToUtc_us(session.connection(), assignment.enrolmentId,
                                                          assignment.occasionCode, assignment.raterId)) {
    refuse(Text::tr("the marks of the panel are open now"), where,
           Text::tr("Move your mark with a reason; it is flagged as moved after the panel's marks"));
  }
  Transaction transaction(session.connection());
  const MarkId markId = session.ids().newUuid();
  sheets.submit(assignmentId, markId, sheet, reason, session.now_us());
  sign(session, {.objectId = markId,
                 .meaning = SignatureMeaning::kAmended,
                 .reason = reason,
                 .demonstration = assignment.demonstration});
  session.note(AuditAction::kSheetAmend, AuditObject::kAssignment, assignmentId, {}, reason);
  transaction.commit();
  endSigning(session);
}

std::vector<SheetVersion> sheetVersions(SessionContext& session, const AssignmentId& assignmentId) {
  const Assignment assignment = ownAssignment(session, Operation::kMarkSubmit, assignmentId);
  const std::optional<std::int64_t> opened_us = panelOpenedToUtc_us(
      session.connection(), assignment.enrolmentId, assignment.occasionCode, assignment.raterId);
  std::vector<SheetVersion> versions;
  for (const SubmittedMark& mark :
       RatingRepository(session.connection())
           .history(assignment.enrolmentId, assignment.raterId, assignment.occasionCode)) {
    versions.push_back({mark.version, mark.score_steps, mark.comment, mark.amendReason, mark.submittedUtc_us,
                        mark.version > 1 && opened_us && mark.submittedUtc_us > *opened_us});
  }
  return versions;
}

OpenedSheet reportViewing(SessionContext& session, const AssignmentId& assignmentId,
                          const std::vector<PlayedStretch>& played) {
  const ViewingRules rules = viewingRules(session);
  Transaction transaction(session.connection());
  OpenedSheet opened = openSheet(session, assignmentId);
  const Text where = Text::tr("case %1", opened.shown.label);
  const std::vector<PlayedStretch> stretches = playable(played, rules, where);
  if (opened.state == SheetState::kSubmitted) {
    throw SheetSealed(opened.shown.label);
  }
  if (opened.shown.live) {
    refuse(Text::tr("this case is scored live and has no recording"), where,
           Text::tr("Read the queue again"));
  }
  opened.watched = watchedInBrowser(session, assignmentId.text(), std::move(opened.watched), stretches);
  DeskRepository(session.connection()).saveDraftViewing(assignmentId, opened.watched.stored());
  transaction.commit();
  return opened;
}

}  // namespace torsio
