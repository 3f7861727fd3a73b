// SPDX-License-Identifier: GPL-3.0-or-later
// Of the allocation: opening the seal, repeating the draw, and the cards for the envelopes.
#include <map>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/services/access/two_people.h"
#include "app/services/study/allocation_design.h"
#include "app/services/study/allocation_service.h"
#include "app/services/study/draw_field.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/cohort.h"
#include "db/connection/connection.h"
#include "db/repository/study/study_repository.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

bool isSimulated(StudyRepository& study, const DesignId& designId) {
  for (const Cohort& cohort : study.cohorts()) {
    for (const LockedDesign& design : study.designs(cohort.id)) {
      if (design.id == designId) {
        return design.demonstration;
      }
    }
  }
  return false;
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
  for (const Cohort& cohort : study.cohorts()) {
    const std::vector<LockedDesign> designs = study.designs(cohort.id);
    if (designs.empty() || designs.back().id != designId || !reason.empty()) {
      continue;
    }
    if (const std::size_t waiting = readDrawField(session, cohort.id).waiting().size(); waiting > 0) {
      refuse(
          Text::tr("%1 {person still waits|people still wait} for a group: the seed would tell them theirs",
                   waiting),
          cohort.name, Text::tr("Allocate them first, or give a reason"));
    }
  }
  if (!isSimulated(study, designId)) {
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
  AllocationCheck check;
  const auto wrong = [&](const Text& finding) {
    check.sound = false;
    check.finding = finding;
    return check;
  };
  for (const Cohort& cohort : study.cohorts()) {
    std::vector<std::string> groupCodes;
    std::map<std::string, GroupId> groupIds;
    for (const StudyGroup& group : study.groups(cohort.id)) {
      groupCodes.push_back(group.code);
      groupIds[group.code] = group.id;
    }
    for (const LockedDesign& stored : study.designs(cohort.id)) {
      if (stored.id != designId) {
        continue;
      }
      const std::vector<AllocationEntry> records = study.allocations(designId);
      const std::vector<AllocationEntry> drawn = drawnOf(records);
      check.records = records.size();
      check.overrides = records.size() - drawn.size();
      if (const auto broken = study.firstBrokenAllocation(designId)) {
        return wrong(Text::tr("record %1 does not fit into the chain", *broken));
      }
      const AllocationDesign design = designFromStored(stored, groupCodes, drawn.size());
      const std::uint64_t seed = seedFrom(study.sealedSeed(designId), designId);
      if (seedCommitment(design, seed, study.sealedSalt(designId)) != stored.seedCommitment) {
        return wrong(Text::tr("seed and design do not give the published commitment"));
      }
      const std::map<std::string, std::string> codes = codesOf(study, cohort.id);
      if (drawn.empty()) {
        return check;
      }
      Allocator allocator(design, seed);
      for (const AllocationEntry& record : drawn) {
        const AllocationRecord again =
            allocator.assign(personFromRecord(design, codes.at(record.enrolmentId), record.covariatesJson));
        if (groupIds[design.arms.at(again.arm)] != record.groupId ||
            static_cast<std::int64_t>(again.drawsAfter) != record.drawAfter) {
          return wrong(Text::tr("record %1 does not follow from the seed", record.sequence));
        }
      }
      std::map<std::string, std::string> lastGroup;
      for (const AllocationEntry& record : records) {
        lastGroup[record.enrolmentId] = record.groupId;
      }
      for (const Enrolment& enrolment : study.enrolments(cohort.id)) {
        const auto last = lastGroup.find(enrolment.id);
        if (last != lastGroup.end() && last->second != enrolment.groupId) {
          return wrong(Text::tr("%1 is in a group that no record tells of", enrolment.traineeCode));
        }
      }
      return check;
    }
  }
  refuse(Text::tr("there is no such design"), designId, Text::tr("Choose one from the list"));
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
    throw Error(ErrorCode::kBadData, Text::tr("nobody is allocated yet"), cohortId,
                Text::tr("Lock a design and allocate first"));
  }
  session.note({.action = AuditAction::kAllocationCards,
                .objectKind = AuditObject::kAllocationDesign,
                .objectId = designs.back().id,
                .newJson = nlohmann::json{{"cards", cards.size()}}.dump()});
  transaction.commit();
  return cards;
}

}  // namespace torsio
