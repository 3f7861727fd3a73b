// SPDX-License-Identifier: GPL-3.0-or-later
// Revealing the seed, replaying the allocation, and cards for envelopes.
#include <map>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/services/access/two_people.h"
#include "app/services/scoring/stored_allocation.h"
#include "app/services/study/allocation_service.h"
#include "app/services/study/draw_field.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/cohort.h"
#include "db/connection/connection.h"
#include "db/repository/study/study_repository.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

std::optional<LockedDesign> designIn(StudyRepository& study, const DesignId& designId) {
  for (const Cohort& cohort : study.cohorts()) {
    for (LockedDesign& design : study.designs(cohort.id)) {
      if (design.id == designId) {
        return std::move(design);
      }
    }
  }
  return std::nullopt;
}

}  // namespace

std::string revealSeed(SessionContext& session, const DesignId& designId, const std::string& reason) {
  session.require(Operation::kAllocationReveal);
  Transaction transaction(session.connection());
  StudyRepository study(session.connection());
  const std::string seed = study.sealedSeed(designId);
  if (seed.empty()) {
    refuse(Text::tr("there is no such design"), designId, Text::tr("Choose one from the list"));
  }
  const LockedDesign design = designIn(study, designId).value();
  if (reason.empty() && study.designs(design.cohortId).back().id == designId) {
    const DrawField field = readDrawField(session, design.cohortId);
    if (const std::size_t waiting = field.waiting().size(); waiting > 0) {
      refuse(
          Text::tr("%1 {person still waits|people still wait} for a group: the seed would tell them theirs",
                   waiting),
          field.cohort.name, Text::tr("Allocate them first, or give a reason"));
    }
  }
  if (!design.demonstration) {
    requireSecondPerson(session, DutyAct::kRevealAllocation, designId);
  }
  study.revealSeed(designId, session.now_us());
  session.note({.action = AuditAction::kAllocationReveal,
                .objectKind = AuditObject::kAllocationDesign,
                .objectId = designId,
                .reason = reason});
  transaction.commit();
  return seed;
}

AllocationCheck checkAllocation(SessionContext& session, const DesignId& designId) {
  session.require(Operation::kAllocationView);
  StudyRepository study(session.connection());
  const std::optional<LockedDesign> stored = designIn(study, designId);
  if (!stored) {
    refuse(Text::tr("there is no such design"), designId, Text::tr("Choose one from the list"));
  }
  return repeatedDraw(study, *stored, study.sealedSeed(designId), study.sealedSalt(designId));
}

std::vector<SealedCard> takeOutCards(SessionContext& session, const CohortId& cohortId) {
  session.require(Operation::kAllocationRun);
  Transaction transaction(session.connection());
  StudyRepository study(session.connection());
  const std::vector<LockedDesign> designs = study.designs(cohortId);
  std::map<std::string, std::string> codes = codesOf(study, cohortId);
  std::map<std::string, StudyGroup> groups;
  for (const StudyGroup& group : study.groups(cohortId)) {
    groups[group.id] = group;
  }
  std::vector<SealedCard> cards;
  if (!designs.empty()) {
    for (const AllocationEntry& record : study.allocations(designs.back().id)) {
      cards.push_back({record.sequence, codes[record.enrolmentId], groups[record.groupId].code,
                       groups[record.groupId].label});
    }
  }
  if (cards.empty()) {
    refuse(Text::tr("nobody is allocated yet"), cohortId, Text::tr("Lock a design and allocate first"));
  }
  session.note({.action = AuditAction::kAllocationCards,
                .objectKind = AuditObject::kAllocationDesign,
                .objectId = designs.back().id,
                .newJson = nlohmann::json{{"cards", cards.size()}}.dump()});
  transaction.commit();
  return cards;
}

}  // namespace torsio
