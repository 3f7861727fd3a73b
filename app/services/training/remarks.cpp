// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/training/remarks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "app/services/study/remark_revision.h"
#include "app/services/training/trainee_record.h"
#include "assessment/attempt/trial_listing.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/mark.h"
#include "assessment/domain/rating/remark.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/rating/sheet.h"
#include "assessment/domain/study/curriculum.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/rating/rubric_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/trial/remark_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

/// Determines which of a trainee's trials were assigned to raters, and whether their marks were released.
class Release {
 public:
  Release(Connection& connection, const TraineeRecord& record) {
    if (!record.enrolment) {
      return;
    }
    SheetRepository sheets(connection);
    for (AssignmentStatus& status : sheets.assignments(record.cohort.id)) {
      const Assignment& assignment = status.assignment;
      if (assignment.enrolmentId != record.enrolment->id || assignment.trialId.empty()) {
        continue;
      }
      if (status.state == SheetState::kWithdrawn) {
        continue;
      }
      if (!sheets.isReleased(record.cohort.id, assignment.occasionCode)) {
        held_.insert(assignment.trialId);
      }
      asked_[assignment.trialId].push_back(std::move(status));
    }
  }
  [[nodiscard]] bool mayShow(const TrialId& trialId) const { return !held_.contains(trialId); }
  [[nodiscard]] const std::vector<AssignmentStatus>& asked(const TrialId& trialId) const {
    static const std::vector<AssignmentStatus> kNobody;
    const auto found = asked_.find(trialId);
    return found == asked_.end() ? kNobody : found->second;
  }

 private:
  std::set<std::string> held_;
  std::map<std::string, std::vector<AssignmentStatus>> asked_;
};

/// Context of the remarks of one trial.
struct AboutRemarks {
  std::set<RemarkId> answered;            ///< questions with an answer
  std::map<RemarkId, std::int64_t> read;  ///< latest version read by the actor
  std::map<RemarkId, std::vector<RemarkWording>> earlier;
};

AboutRemarks aboutRemarks(SessionContext& session, const TrialId& trialId) {
  const RemarkRepository repository(session.connection());
  AboutRemarks about;
  about.earlier = repository.earlierWordings(trialId);
  for (const ReadReceipt& receipt : repository.receipts(trialId)) {
    if (receipt.reader == session.actor().userId) {
      std::int64_t& version = about.read[receipt.remarkId];
      version = std::max(version, receipt.version);
    }
  }
  for (const TraineeQuestion& question : QuestionRepository(session.connection()).ofTrial(trialId)) {
    if (!question.answerId.empty()) {
      about.answered.insert(question.remarkId);
    }
  }
  return about;
}

TraineeRemark shown(const Remark& stored, const AboutRemarks& about, const Actor& actor) {
  const bool own = stored.author == actor.userId || stored.authorPersonId == actor.personId;
  const auto read = about.read.find(stored.id);
  const auto earlier = about.earlier.find(stored.id);
  return {.id = stored.id,
          .trialId = stored.trialId,
          .at_s = static_cast<double>(stored.time_us) * 1e-6,
          .text = stored.text,
          .version = stored.version,
          .writtenUtc_us = stored.createdUtc_us,
          .editedUtc_us = stored.editedUtc_us,
          .earlier = earlier == about.earlier.end() ? std::vector<RemarkWording>() : earlier->second,
          .own = own,
          .read = own || (read != about.read.end() && read->second >= stored.version)};
}

/// Sorts replies, including replies to replies, below what they reply to. An answered question starts a
/// thread like a physician's remark.
std::vector<TraineeRemark> threads(const std::vector<Remark>& all, const AboutRemarks& about,
                                   const Actor& actor) {
  std::map<std::string, std::string> rootOf;
  std::vector<TraineeRemark> roots;
  for (const Remark& stored : all) {
    const bool question = about.answered.contains(stored.id);
    if (stored.purpose != "remark" && !question) {
      continue;
    }
    rootOf[stored.id] = stored.id;
    roots.push_back(shown(stored, about, actor));
    roots.back().question = question;
  }
  std::vector<Remark> replies;
  for (const Remark& stored : all) {
    if (stored.purpose == "reply") {
      replies.push_back(stored);
    }
  }
  std::sort(replies.begin(), replies.end(),
            [](const Remark& a, const Remark& b) { return a.createdUtc_us < b.createdUtc_us; });
  for (const Remark& reply : replies) {
    const auto root = rootOf.find(reply.replyTo);
    if (root == rootOf.end()) {
      continue;
    }
    rootOf[reply.id] = root->second;
    for (TraineeRemark& remark : roots) {
      if (remark.id == root->second) {
        remark.replies.push_back(shown(reply, about, actor));
      }
    }
  }
  return roots;
}

TrialRemarks remarksOf(SessionContext& session, const TraineeRecord& record, const TrialListing& trial) {
  TrialRemarks out;
  out.trialId = trial.trialId;
  if (const TrainingModule* module = record.module(trial.moduleId)) {
    out.moduleTitle = module->title;
  }
  out.phaseLabel = trial.phaseLabel;
  out.startedUtc_us = trial.startedUtc_us;
  out.remarks = threads(RemarkRepository(session.connection()).remarks(trial.trialId),
                        aboutRemarks(session, trial.trialId), session.actor());
  for (const TraineeRemark& remark : out.remarks) {
    if (!remark.read) {
      ++out.unread;
    }
    for (const TraineeRemark& reply : remark.replies) {
      if (!reply.read) {
        ++out.unread;
      }
    }
  }
  return out;
}

/// Returns a remark that the actor may see.
Remark visibleRemark(SessionContext& session, const RemarkId& remarkId) {
  const TraineeRecord record = ownRecord(session, Operation::kTrialViewOwn);
  const std::optional<Remark> remark = RemarkRepository(session.connection()).find(remarkId);
  if (!remark) {
    refuseParameter(Text::tr("there is no such remark"), remarkId, Text::tr("Open the list again"));
  }
  static_cast<void>(ownTrial(session, record, remark->trialId));
  if (!Release(session.connection(), record).mayShow(remark->trialId)) {
    throw Error(ErrorCode::kPermission, Text::tr("the marks of this recording are not released yet"),
                remark->trialId, Text::tr("Try again when they are"));
  }
  return *remark;
}

double points(std::int64_t steps, const ScoreScale& scale) {
  return static_cast<double>(steps) / static_cast<double>(scale.stepsPerPoint);
}

ScoreGapRow rowOf(const std::string& code, const std::string& label, const ScoreScale& scale) {
  ScoreGapRow row;
  row.code = code;
  row.label = label;
  row.lowest = points(scale.lo, scale);
  row.highest = points(scale.hi, scale);
  row.step = 1.0 / static_cast<double>(scale.stepsPerPoint);
  return row;
}

/// Returns the rubric of this trial's sheets; without sheets, the overall mark of paper section 6.
RubricRevision rubricOf(Connection& connection, const std::vector<AssignmentStatus>& asked) {
  if (!asked.empty()) {
    const auto revision = RubricRepository(connection).revision(asked.front().assignment.rubricRevisionId);
    if (revision) {
      return *revision;
    }
  }
  RubricRevision overallOnly;
  overallOnly.overall = SubmittedMark{}.scale;
  return overallOnly;
}

struct PanelMeans {
  std::map<std::string, std::pair<double, std::size_t>> rows;
  double overall = 0.0;
  std::size_t raters = 0;
};

PanelMeans panelOf(Connection& connection, const std::vector<AssignmentStatus>& asked,
                   const RubricRevision& rubric) {
  PanelMeans means;
  SheetRepository sheets(connection);
  for (const AssignmentStatus& status : asked) {
    const std::optional<Sheet> sheet = sheets.submitted(status.assignment.id);
    if (!sheet || !sheet->overall_steps) {
      continue;
    }
    means.overall += points(*sheet->overall_steps, rubric.overall);
    ++means.raters;
    for (const SheetRow& row : sheet->rows) {
      for (const RubricLine& known : rubric.rows) {
        if (known.code != row.code || !row.score_steps) {
          continue;
        }
        means.rows[row.code].first += points(*row.score_steps, known.scale);
        ++means.rows[row.code].second;
      }
    }
  }
  if (means.raters > 0) {
    means.overall /= static_cast<double>(means.raters);
  }
  return means;
}

std::int64_t stepsOf(double value, const ScoreScale& scale, const std::string& where) {
  const double exact = value * static_cast<double>(scale.stepsPerPoint);
  const std::int64_t steps = std::llround(exact);
  const bool onScale = steps >= scale.lo && steps <= scale.hi;
  if (onScale && std::abs(exact - static_cast<double>(steps)) < 1e-6) {
    return steps;
  }
  refuseParameter(Text::tr("this scale has no such mark"), where,
                  Text::tr("Choose a mark between the ends of the scale"));
}

}  // namespace

std::vector<TrialRemarks> ownRemarks(SessionContext& session) {
  const TraineeRecord record = ownRecord(session, Operation::kTrialViewOwn);
  const Release release(session.connection(), record);
  TrialFilter filter;
  filter.traineeCode = record.code;
  filter.limit = kAllTrials;
  std::vector<TrialRemarks> all;
  for (const TrialListing& trial : TrialRepository(session.connection()).list(filter)) {
    if (!release.mayShow(trial.trialId)) {
      continue;
    }
    TrialRemarks remarks = remarksOf(session, record, trial);
    if (!remarks.remarks.empty()) {
      all.push_back(std::move(remarks));
    }
  }
  return all;
}

std::size_t unreadRemarks(SessionContext& session) {
  const TraineeRecord record = ownRecord(session, Operation::kTrialViewOwn);
  const Release release(session.connection(), record);
  const std::vector<Remark> unread =
      RemarkRepository(session.connection()).unreadOnTrialsOf(record.personId, session.actor().userId);
  return static_cast<std::size_t>(std::count_if(unread.begin(), unread.end(), [&](const Remark& remark) {
    return remark.authorPersonId != record.personId && release.mayShow(remark.trialId);
  }));
}

void markRemarkRead(SessionContext& session, const RemarkId& remarkId, std::int64_t version) {
  const Remark remark = visibleRemark(session, remarkId);
  if (version < 1 || version > remark.version) {
    refuseParameter(Text::tr("there is no such version of the remark"), remarkId,
                    Text::tr("Open the list again"));
  }
  Transaction transaction(session.connection());
  RemarkRepository(session.connection())
      .markRead({.remarkId = remark.id,
                 .version = version,
                 .reader = session.actor().userId,
                 .readerPersonId = session.actor().personId,
                 .readUtc_us = session.now_us()});
  session.note(AuditAction::kRemarkRead, AuditObject::kTrialRemark, remark.id);
  transaction.commit();
}

RemarkId replyToRemark(SessionContext& session, const RemarkId& remarkId, const std::string& text) {
  const Remark remark = visibleRemark(session, remarkId);
  if (text.empty()) {
    refuseParameter(Text::tr("the reply is empty"), "", Text::tr("Write what you want to say"));
  }
  const RemarkId id = session.ids().newUuid();
  Transaction transaction(session.connection());
  RemarkRepository(session.connection())
      .add({.id = id,
            .trialId = remark.trialId,
            .author = session.actor().userId,
            .authorPersonId = session.actor().personId,
            .purpose = "reply",
            .replyTo = remark.id,
            .tick = remark.tick,
            .time_us = remark.time_us,
            .text = text,
            .createdUtc_us = session.now_us(),
            .demonstration = remark.demonstration});
  session.note(AuditAction::kRemarkReply, AuditObject::kTrialRemark, id);
  transaction.commit();
  return id;
}

void editRemark(SessionContext& session, const RemarkId& remarkId, const std::string& text) {
  const Remark remark = visibleRemark(session, remarkId);
  reviseRemark(session, remark, text);
}

ScoreGap scoreGap(SessionContext& session, const TrialId& trialId) {
  session.require(Operation::kMarkViewOwn);
  const TraineeRecord record = ownRecord(session, Operation::kTrialViewOwn);
  static_cast<void>(ownTrial(session, record, trialId));
  const Release release(session.connection(), record);
  const RubricRevision rubric = rubricOf(session.connection(), release.asked(trialId));
  ScoreGap gap;
  gap.trialId = trialId;
  gap.overall = rowOf("", "", rubric.overall);
  for (const RubricLine& row : rubric.rows) {
    gap.rows.push_back(rowOf(row.code, row.label, row.scale));
  }
  gap.released = !release.asked(trialId).empty() && release.mayShow(trialId);

  const auto own = RemarkRepository(session.connection()).selfScores(trialId);
  gap.selfScored = !own.empty();
  if (!gap.selfScored) {
    return gap;
  }
  gap.overall.own = points(own.back().score_steps, own.back().scale);
  const PanelMeans panel =
      gap.released ? panelOf(session.connection(), release.asked(trialId), rubric) : PanelMeans{};
  gap.raters = panel.raters;
  if (panel.raters > 0) {
    gap.overall.panel = panel.overall;
  }
  for (std::size_t i = 0; i < gap.rows.size(); ++i) {
    for (const SelfScoreLine& row : own.back().rows) {
      if (row.rowCode == gap.rows[i].code) {
        gap.rows[i].own = points(row.score_steps, rubric.rows[i].scale);
      }
    }
    const auto mean = panel.rows.find(gap.rows[i].code);
    if (mean != panel.rows.end()) {
      gap.rows[i].panel = mean->second.first / static_cast<double>(mean->second.second);
    }
  }
  return gap;
}

void selfScore(SessionContext& session, const TrialId& trialId, double overall,
               const std::vector<SelfScoreRow>& rows) {
  const TraineeRecord record = ownRecord(session, Operation::kTrialViewOwn);
  const TrialListing trial = ownTrial(session, record, trialId);
  const Release release(session.connection(), record);
  const RubricRevision rubric = rubricOf(session.connection(), release.asked(trialId));
  RemarkRepository repository(session.connection());
  const auto before = repository.selfScores(trialId);
  if (!before.empty() && !release.asked(trialId).empty() && release.mayShow(trialId)) {
    throw Error(ErrorCode::kPermission, Text::tr("the physicians' marks were shown already"), trialId,
                Text::tr("Your own marks stay as they are"));
  }
  SelfScore score;
  score.id = session.ids().newUuid();
  score.trialId = trialId;
  score.traineeId = record.personId;
  score.version = static_cast<std::int64_t>(before.size()) + 1;
  score.rubricRevisionId = rubric.id;
  score.scale = rubric.overall;
  score.score_steps = stepsOf(overall, rubric.overall, "overall mark");
  for (const SelfScoreRow& row : rows) {
    const auto known = std::find_if(rubric.rows.begin(), rubric.rows.end(),
                                    [&](const RubricLine& r) { return r.code == row.code; });
    if (known == rubric.rows.end()) {
      refuseParameter(Text::tr("the sheet has no such row"), row.code, Text::tr("Open the sheet again"));
    }
    score.rows.push_back({rubric.id, row.code, stepsOf(row.points, known->scale, known->label)});
  }
  score.createdUtc_us = session.now_us();
  score.demonstration = trial.demonstration;
  Transaction transaction(session.connection());
  repository.addSelfScore(score);
  session.note(AuditAction::kTrialSelfScore, AuditObject::kTrial, trialId);
  transaction.commit();
}

}  // namespace torsio
