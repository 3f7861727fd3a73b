// SPDX-License-Identifier: GPL-3.0-or-later
// Calls to the real arm: the sheets of those who score there, and the administrator who calls.
#include <algorithm>
#include <string>
#include <utility>

#include "app/services/review/review_queue.h"
#include "app/services/study/live_call.h"
#include "app/web/case_json.h"
#include "app/web/router.h"
#include "app/web/web_desk.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"

namespace torsio::web {

namespace {

using nlohmann::json;

constexpr std::size_t kLongestRoom = 200;
constexpr std::size_t kLongestCode = 200;
constexpr std::size_t kLongestReasonToCall = 1000;
const char* const kCall = "call ";

/// Returns the lines with a stamp that differs when they do.
json liveJson(Call& call) {
  const std::vector<QueueLine> lines = liveLines(call.context);
  const std::int64_t now_us = call.context.now_us();
  json shown = jsonList(lines, [&](const QueueLine& line) -> json {
    return {{"case", call.session->handleOf(line.shown.assignmentId)},
            {"label", line.shown.label},
            {"state", stateName(line.state)},
            {"open", line.call && line.call->open},
            {"room", line.call ? line.call->room : ""},
            {"older", isOfEarlierDay(line, now_us)}};
  });
  const bool goesOn = callsGoOn(lines, now_us);
  Digest stamp;
  stamp.update(std::string_view(shown.dump() + (goesOn ? "+" : "-")));
  return {{"lines", std::move(shown)}, {"calls_go_on", goesOn}, {"stamp", stamp.hex()}};
}

HttpResponse answerLive(Call& call) {
  return jsonAnswer(liveJson(call));
}

HttpResponse answerNews(Call& call) {
  const json live = liveJson(call);
  return live.at("stamp") == call.parts.front() ? HttpResponse{.status = kNothingNew} : jsonAnswer(live);
}

AssignmentId sheetOr(const Call& call, const char* field) {
  const auto found = call.session->caseOf(call.body.textOrNone(field, kLongestCode));
  return found ? *found : AssignmentId();
}

HttpResponse answerFollow(Call& call) {
  const CallGuide guide = guideToCall(liveLines(call.context), sheetOr(call, "shown"),
                                      call.body.whole("busy", 0, 1) == 1, sheetOr(call, "followed"));
  if (!guide.called) {
    return jsonAnswer({{"called", nullptr}});
  }
  return jsonAnswer({{"called",
                      {{"case", call.session->handleOf(guide.called->shown.assignmentId)},
                       {"label", guide.called->shown.label},
                       {"room", guide.called->call->room}}},
                     {"opens", guide.opens},
                     {"other_room", guide.otherRoom}});
}

json callsJson(Call& call, const CohortId& cohortId) {
  const std::vector<CalledCase> called = calledCases(call.context, cohortId);
  json calls = jsonList(called, [&](const CalledCase& one) -> json {
    return {{"call", call.session->handleFor(kCall + one.call.id.text())},
            {"open", !one.call.endedUtc_us.has_value()},
            {"label", one.caseLabel},
            {"trainee", one.traineeCode},
            {"occasion", said(call, Text(one.occasion.label))},
            {"room", one.call.room},
            {"asked", one.asked},
            {"submitted", one.submitted},
            {"missing", one.missing.size()},
            {"missing_text", said(call, missingText(one, missingCodes(one)))},
            {"may_cancel", one.mayCancel}};
  });
  return {{"calls", std::move(calls)}};
}

HttpResponse answerCalls(Call& call) {
  return jsonAnswer(callsJson(call, cohortOf(call)));
}

/// Calls a trainee. Without a reason, a call that the curriculum does not expect is answered with its
/// objection instead.
HttpResponse answerCallTrainee(Call& call) {
  const CohortId cohortId = cohortOf(call);
  CallRequest request{
      .cohortId = cohortId,
      .enrolmentId = enrolmentWithCode(call.context, cohortId, call.body.text("code", kLongestCode)),
      .occasionCode = call.body.textOrNone("occasion", kLongestCode),
      .room = call.body.text("room", kLongestRoom),
      .reason = call.body.textOrNone("reason", kLongestReasonToCall)};
  if (request.reason.empty() && !request.room.empty()) {
    const CallCheck check = checkCall(call.context, request);
    if (check.objection) {
      return jsonAnswer({{"objection", said(call, *check.objection)},
                         {"occasion", said(call, Text(check.occasion.label))}});
    }
  }
  (void)callTrainee(call.context, request);
  call.desk.tellCalls();
  return answerCalls(call);
}

LiveCallId callOf(const Call& call) {
  if (const auto found = objectOf(call, call.parts.back(), kCall)) {
    return LiveCallId(*found);
  }
  refuseParameter(Text::tr("there is no such call"), "", Text::tr("Load the page again"));
}

HttpResponse answerEnd(Call& call) {
  endCall(call.context, cohortOf(call), callOf(call));
  call.desk.tellCalls();
  return answerCalls(call);
}

HttpResponse answerCancel(Call& call) {
  cancelCall(call.context, cohortOf(call), callOf(call),
             call.body.textOrNone("reason", kLongestReasonToCall));
  call.desk.tellCalls();
  return answerCalls(call);
}

/// Returns the text of a reminder, and audits it.
HttpResponse answerRemind(Call& call) {
  const CohortId cohortId = cohortOf(call);
  const LiveCallId id = callOf(call);
  const std::vector<CalledCase> calls = calledCases(call.context, cohortId);
  const auto found =
      std::find_if(calls.begin(), calls.end(), [&](const CalledCase& one) { return one.call.id == id; });
  if (found == calls.end() || found->missing.empty()) {
    refuse(Text::tr("no sheet of this call is missing any more"), "", Text::tr("Read the list again"));
  }
  noteCopiedReminder(call.context, cohortId, *found);
  return jsonAnswer({{"text", said(call, reminderText(*found))}});
}

}  // namespace

std::vector<Route> liveRoutes() {
  constexpr auto kIn = RouteAccess::kSignedIn;
  return {{"GET", "/api/live", kIn, answerLive},
          {.method = "GET", .path = "/api/live/*", .answer = answerNews, .waits = true},
          {"POST", "/api/live/follow", kIn, answerFollow},
          {"GET", "/api/cohorts/*/calls", kIn, answerCalls},
          {"POST", "/api/cohorts/*/calls", kIn, answerCallTrainee},
          {"POST", "/api/cohorts/*/calls/*/end", kIn, answerEnd},
          {"POST", "/api/cohorts/*/calls/*/cancel", kIn, answerCancel},
          {"POST", "/api/cohorts/*/calls/*/remind", kIn, answerRemind}};
}

}  // namespace torsio::web
