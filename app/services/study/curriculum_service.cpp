// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/study/curriculum_service.h"

#include <algorithm>
#include <map>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/services/study/curriculum_content.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/cohort.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/occasion_repository.h"
#include "db/repository/study/study_repository.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

Curriculum curriculumOf(CurriculumRepository& repository, const CurriculumId& curriculumId) {
  for (Curriculum& curriculum : repository.curricula()) {
    if (curriculum.id == curriculumId) {
      return curriculum;
    }
  }
  refuse(Text::tr("there is no such curriculum"), curriculumId, Text::tr("Choose one from the list"));
}

/// Returns the audit action of a change to `state`; publishing creates a version as a draft.
AuditAction actionOf(CurriculumState state) {
  switch (state) {
    case CurriculumState::kDraft:
      return AuditAction::kCurriculumPublish;
    case CurriculumState::kRunning:
      return AuditAction::kCurriculumRunning;
    case CurriculumState::kClosed:
      return AuditAction::kCurriculumClosed;
  }
  throw ContractError("no such state");
}

void moveTo(SessionContext& session, const CurriculumVersionId& versionId, CurriculumState state,
            const std::string& reason) {
  session.require(Operation::kCurriculumEdit);
  Transaction transaction(session.connection());
  CurriculumRepository(session.connection())
      .moveTo(versionId, state, session.actor().userId, session.now_us());
  session.note(actionOf(state), AuditObject::kCurriculumVersion, versionId, {{"state", storedText(state)}},
               reason);
  transaction.commit();
}

}  // namespace

std::vector<CurriculumRow> curricula(SessionContext& session) {
  session.require(Operation::kPersonViewCoded);
  CurriculumRepository repository(session.connection());
  std::map<CurriculumVersionId, std::vector<std::string>> followers;
  for (const Cohort& cohort : StudyRepository(session.connection()).cohorts()) {
    followers[cohort.curriculumVersionId].push_back(cohort.name);
  }
  std::vector<CurriculumRow> rows;
  for (Curriculum& curriculum : repository.curricula()) {
    CurriculumRow row;
    if (const auto draft = repository.draft(curriculum.id)) {
      row.hasDraft = true;
      row.draftChangedUtc_us = draft->changedUtc_us;
    }
    for (const CurriculumVersionId& id : repository.versionIds(curriculum.id)) {
      const CurriculumVersion version = repository.version(id).value();
      row.versions.push_back(
          {id, version.number, version.note, version.state, version.createdUtc_us, followers[id]});
    }
    row.curriculum = std::move(curriculum);
    rows.push_back(std::move(row));
  }
  return rows;
}

CurriculumVersion publishedContent(SessionContext& session, const CurriculumVersionId& versionId) {
  session.require(Operation::kPersonViewCoded);
  auto version = CurriculumRepository(session.connection()).version(versionId);
  if (!version) {
    refuse(Text::tr("there is no such version"), versionId, Text::tr("Choose one from the list"));
  }
  return withCodes(*std::move(version));
}

CurriculumId addCurriculum(SessionContext& session, const std::string& name, const std::string& description,
                           const std::optional<CurriculumVersion>& content, bool demonstration) {
  session.require(Operation::kCurriculumEdit);
  if (name.empty()) {
    refuseParameter(Text::tr("the curriculum has no name"), Text::tr("curriculum"), Text::tr("Enter one"));
  }
  Transaction transaction(session.connection());
  CurriculumRepository repository(session.connection());
  const CurriculumId id = session.ids().newUuid();
  repository.addCurriculum({id, name, description, session.now_us(), demonstration});
  repository.saveDraft(id, {0, curriculumJson(content.value_or(CurriculumVersion{})), session.actor().userId,
                            session.now_us()});
  session.note(AuditAction::kCurriculumAdd, AuditObject::kCurriculum, id);
  transaction.commit();
  return id;
}

CurriculumDraft curriculumDraft(SessionContext& session, const CurriculumId& curriculumId) {
  session.require(Operation::kCurriculumEdit);
  CurriculumRepository repository(session.connection());
  const Curriculum curriculum = curriculumOf(repository, curriculumId);
  if (const auto draft = repository.draft(curriculumId)) {
    return {draft->revision, parseCurriculum(draft->contentJson, curriculum.name), draft->changedBy,
            draft->changedUtc_us};
  }
  const std::vector<CurriculumVersionId> versions = repository.versionIds(curriculumId);
  if (versions.empty()) {
    return {};
  }
  return {0, withCodes(repository.version(versions.back()).value()), "", 0};
}

std::int64_t saveCurriculumDraft(SessionContext& session, const CurriculumId& curriculumId,
                                 const CurriculumDraft& draft) {
  session.require(Operation::kCurriculumEdit);
  Transaction transaction(session.connection());
  const std::int64_t revision = CurriculumRepository(session.connection())
                                    .saveDraft(curriculumId, {draft.revision, curriculumJson(draft.content),
                                                              session.actor().userId, session.now_us()});
  // Every save is audited: merging saves of one person would hide who wrote what.
  session.note(AuditAction::kCurriculumSaveDraft, AuditObject::kCurriculumDraft, curriculumId,
               {{"revision", revision}});
  transaction.commit();
  return revision;
}

CurriculumVersionId publishCurriculum(SessionContext& session, const CurriculumId& curriculumId,
                                      const std::string& note, const std::filesystem::path& assets) {
  session.require(Operation::kCurriculumEdit);
  Transaction transaction(session.connection());
  const CurriculumDraft draft = curriculumDraft(session, curriculumId);
  const Occasions known = OccasionRepository(session.connection()).all();
  for (const CurriculumProblem& problem : curriculumProblems(draft.content, assets, known)) {
    refuse(problem.what, problem.where, problem.remedy);
  }
  CurriculumRepository repository(session.connection());
  CurriculumVersion version = withIds(draft.content, session.ids());
  version.id = session.ids().newUuid();
  version.curriculumId = curriculumId;
  version.number = static_cast<std::int64_t>(repository.versionIds(curriculumId).size() + 1);
  version.note = note;
  version.createdUtc_us = session.now_us();
  repository.addVersion(version, session.actor().userId);
  session.note(
      AuditAction::kCurriculumPublish, AuditObject::kCurriculumVersion, version.id,
      {{"curriculum", curriculumId}, {"number", version.number}, {"draft_revision", draft.revision}});
  transaction.commit();
  return version.id;
}

void runCurriculum(SessionContext& session, const CurriculumVersionId& versionId, const std::string& reason) {
  moveTo(session, versionId, CurriculumState::kRunning, reason);
}

void closeCurriculum(SessionContext& session, const CurriculumVersionId& versionId,
                     const std::string& reason) {
  moveTo(session, versionId, CurriculumState::kClosed, reason);
}

}  // namespace torsio
