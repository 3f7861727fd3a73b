// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/study/allocation_service.h"

#include <algorithm>
#include <map>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/services/access/two_people.h"
#include "app/services/base/build_info.h"
#include "app/services/scoring/stored_allocation.h"
#include "app/services/study/cohort_service.h"
#include "app/services/study/draw_field.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/study/cohort.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/study/study_repository.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr std::size_t kTries = 200;

/// What the design in use has allocated.
struct StoredDraw {
  LockedDesign stored;
  std::vector<AllocationEntry> records;
  std::map<std::string, std::int64_t> highestNumber;  ///< in use, by group
};

/// The same, with the generator after the last draw.
struct OpenDraw {
  StoredDraw done;
  AllocationDesign design;
  Allocator allocator;
};

LockedDesign designInUse(SessionContext& session, const Cohort& cohort) {
  const std::vector<LockedDesign> designs = StudyRepository(session.connection()).designs(cohort.id);
  if (designs.empty()) {
    refuse(Text::tr("no allocation design is locked"), cohort.name, Text::tr("Lock one first"));
  }
  return designs.back();
}

std::vector<Enrolment> requireWaiting(const DrawField& field) {
  std::vector<Enrolment> waiting = field.waiting();
  if (waiting.empty()) {
    refuse(Text::tr("nobody waits for a group"), field.cohort.name, Text::tr("Enrol trainees first"));
  }
  return waiting;
}

/// Says in the trail that the seed is taken out; a server shows it to nobody before (may_read_seed()).
/// Outside of a transaction, so that the entry stays whatever comes after it.
void takeSeedOut(SessionContext& session, const DesignId& designId) {
  session.note(AuditAction::kAllocationTakeSeed, AuditObject::kAllocationDesign, designId);
}

StoredDraw readDraw(SessionContext& session, const DrawField& field) {
  StudyRepository study(session.connection());
  StoredDraw done{.stored = designInUse(session, field.cohort), .records = {}, .highestNumber = {}};
  done.records = study.allocations(done.stored.id);
  for (const Enrolment& enrolment : study.enrolments(field.cohort.id)) {
    std::int64_t& highest = done.highestNumber[enrolment.groupId];
    highest = std::max(highest, enrolment.numberInGroup);
  }
  return done;
}

/// After takeSeedOut().
OpenDraw openDraw(SessionContext& session, const DrawField& field) {
  StudyRepository study(session.connection());
  StoredDraw done = readDraw(session, field);
  const std::vector<AllocationEntry> drawn = drawnOf(done.records);
  const AllocationDesign design = designFromStored(done.stored, field.groupCodes(), drawn.size());
  Allocator allocator(design, seedFrom(study.sealedSeed(done.stored.id), done.stored.id));
  const std::map<std::string, std::string> codes = codesOf(study, field.cohort.id);
  for (const AllocationEntry& record : drawn) {
    const AllocationRecord again =
        allocator.assign(personFromRecord(design, codes.at(record.enrolmentId), record.covariatesJson));
    if (static_cast<std::int64_t>(again.drawsAfter) != record.drawAfter) {
      refuse(Text::tr("the records do not follow from the sealed seed"), done.stored.id,
             Text::tr("Run the check of the allocation before anybody else is allocated"));
    }
  }
  return {std::move(done), design, std::move(allocator)};
}

AllocationEntry draw(SessionContext& session, const DrawField& field, OpenDraw& open,
                     const Enrolment& enrolment) {
  StudyRepository study(session.connection());
  const AllocationPerson person = personForDraw(open.design, field.trainees.at(enrolment.traineeId));
  const AllocationRecord drawn = open.allocator.assign(person);
  const StudyGroup& group = field.groups.at(drawn.arm);
  AllocationEntry record;
  record.id = session.ids().newUuid();
  record.designId = open.done.stored.id;
  record.sequence = static_cast<std::int64_t>(open.done.records.size() + 1);
  record.enrolmentId = enrolment.id;
  record.groupId = group.id;
  record.numberInGroup = ++open.done.highestNumber[group.id];
  record.covariatesJson = covariatesJson(open.design, person);
  record.countsBeforeJson = numbersJson(open.design.arms, drawn.countsBefore);
  record.scoresJson = numbersJson(open.design.arms, drawn.scores);
  record.drawBefore = static_cast<std::int64_t>(drawn.drawsBefore);
  record.drawAfter = static_cast<std::int64_t>(drawn.drawsAfter);
  record.allocatedBy = session.actor().userId;
  record.softwareVersion = softwareVersion();
  record.allocatedUtc_us = session.now_us();
  record.demonstration = field.cohort.demonstration;
  record = study.allocate(std::span(&record, 1)).front();
  open.done.records.push_back(record);
  session.note(AuditAction::kAllocationDraw, AuditObject::kAllocation, record.id,
               {{"enrolment", enrolment.id}, {"record", record.recordHash}});
  return record;
}

AllocationDesignRow rowOf(StudyRepository& study, const LockedDesign& stored,
                          const std::vector<std::string>& groups) {
  const std::vector<AllocationEntry> records = study.allocations(stored.id);
  const std::size_t drawn = drawnOf(records).size();
  return {stored, designFromStored(stored, groups, drawn), records.size(), records.size() - drawn};
}

/// Adds one trial allocation to a preview's statistics.
void addTry(BalancePreview& preview, const Allocation& tried, const DrawField& field,
            const std::vector<Enrolment>& people) {
  const auto difference = [](const std::vector<std::size_t>& counts) {
    const auto [low, high] = std::minmax_element(counts.begin(), counts.end());
    return *high - *low;
  };
  std::vector<std::size_t> sizes(preview.groups.size(), 0);
  for (const AllocationRecord& record : tried.records) {
    ++sizes.at(record.arm);
  }
  preview.worstSizeDifference = std::max(preview.worstSizeDifference, difference(sizes));
  for (BalancePreview::Level& level : preview.levels) {
    std::vector<std::size_t> counts(preview.groups.size(), 0);
    for (const AllocationRecord& record : tried.records) {
      const Trainee& trainee = field.trainees.at(people.at(record.position).traineeId);
      if (factorValue(trainee, level.factor) == level.level) {
        ++counts.at(record.arm);
      }
    }
    for (std::size_t g = 0; g < counts.size(); ++g) {
      level.expected[g] += static_cast<double>(counts[g]) / static_cast<double>(kTries);
    }
    level.worstDifference = std::max(level.worstDifference, difference(counts));
    level.meanDifference += static_cast<double>(difference(counts)) / static_cast<double>(kTries);
  }
}

}  // namespace

BalancePreview previewBalance(SessionContext& session, const AllocationPlan& plan) {
  session.require(Operation::kAllocationRun);
  DrawField field = readDrawField(session, plan.cohortId);
  BalancePreview preview;
  preview.groups = field.groupCodes();
  std::vector<Enrolment> people = field.waiting();
  preview.people = people.size();
  for (const Enrolment& enrolment : people) {
    const Trainee& trainee = field.trainees.at(enrolment.traineeId);
    const bool complete =
        std::none_of(plan.factors.begin(), plan.factors.end(),
                     [&](const std::string& name) { return factorValue(trainee, name).empty(); });
    if (!complete) {
      preview.missing.push_back(enrolment.traineeCode);
    }
  }
  if (!preview.missing.empty() || people.empty()) {
    return preview;
  }
  const AllocationDesign design = designOf(field, plan);
  for (const Term<BalanceFactor>& factor : kBalanceFactors) {
    const std::string name(factor.stored);
    for (const std::string& level : factorOf(field, name).levels) {
      const auto count = std::count_if(people.begin(), people.end(), [&](const Enrolment& enrolment) {
        return factorValue(field.trainees.at(enrolment.traineeId), name) == level;
      });
      preview.levels.push_back({name, level, static_cast<std::size_t>(count),
                                std::vector<double>(preview.groups.size(), 0.0), 0, 0.0});
    }
  }
  std::vector<AllocationPerson> persons;
  for (const Enrolment& enrolment : people) {
    persons.push_back(personForDraw(design, field.trainees.at(enrolment.traineeId)));
  }
  preview.tries = kTries;
  for (std::size_t seed = 1; seed <= kTries; ++seed) {
    addTry(preview, allocate(design, seed, persons, !design.stratumTotals.empty()), field, people);
  }
  return preview;
}

AllocationDesignRow lockAllocation(SessionContext& session, const AllocationPlan& plan,
                                   const std::string& supersedeReason) {
  session.require(Operation::kAllocationRun);
  Transaction transaction(session.connection());
  const DrawField field = readDrawField(session, plan.cohortId);
  refuseWhenClosed(field.cohort);
  StudyRepository study(session.connection());
  const std::vector<LockedDesign> before = study.designs(plan.cohortId);
  if (!before.empty() && !study.allocations(before.back().id).empty() && supersedeReason.empty()) {
    refuse(Text::tr("allocation has begun with another design"), field.cohort.name,
           Text::tr("Give a reason; people in a group stay in it"));
  }
  (void)requireWaiting(field);
  const AllocationDesign design = designOf(field, plan);
  const std::uint64_t seed = plan.seed ? *plan.seed : drawSeed(session.ids());
  LockedDesign stored;
  stored.id = session.ids().newUuid();
  stored.cohortId = plan.cohortId;
  stored.algorithm = storedText(design.method);
  stored.algorithmVersion = kAllocationVersion;
  stored.parametersJson = designJson(design);
  stored.generator = kAllocationGenerator;
  stored.salt = drawSalt(session.ids());
  stored.seedCommitment = seedCommitment(design, seed, stored.salt);
  stored.seed = std::to_string(seed);
  stored.lockedUtc_us = session.now_us();
  if (!before.empty()) {
    stored.lockedUtc_us = std::max(stored.lockedUtc_us, before.back().lockedUtc_us + 1);
  }
  stored.demonstration = field.cohort.demonstration;
  study.lockDesign(stored);
  stored.seed.clear();
  stored.salt.clear();
  session.note(before.empty() ? AuditAction::kAllocationLock : AuditAction::kAllocationSupersede,
               AuditObject::kAllocationDesign, stored.id,
               {{"cohort", plan.cohortId},
                {"commitment", stored.seedCommitment},
                {"seed_given", plan.seed.has_value()}},
               supersedeReason);
  transaction.commit();
  return {stored, design, 0, 0};
}

std::vector<AllocationDesignRow> allocationDesigns(SessionContext& session, const CohortId& cohortId) {
  session.require(Operation::kAllocationView);
  StudyRepository study(session.connection());
  std::vector<std::string> groups;
  for (const StudyGroup& group : study.groups(cohortId)) {
    groups.push_back(group.code);
  }
  std::vector<AllocationDesignRow> rows;
  for (const LockedDesign& stored : study.designs(cohortId)) {
    rows.push_back(rowOf(study, stored, groups));
  }
  return rows;
}

std::vector<AllocationEntry> allocations(SessionContext& session, const DesignId& designId) {
  session.require(Operation::kAllocationView);
  return StudyRepository(session.connection()).allocations(designId);
}

std::size_t allocateAll(SessionContext& session, const CohortId& cohortId) {
  session.require(Operation::kAllocationRun);
  {
    const DrawField field = readDrawField(session, cohortId);
    const LockedDesign design = designInUse(session, field.cohort);
    (void)requireWaiting(field);
    takeSeedOut(session, design.id);
  }
  Transaction transaction(session.connection());
  const DrawField field = readDrawField(session, cohortId);
  OpenDraw open = openDraw(session, field);
  const std::vector<Enrolment> waiting = requireWaiting(field);
  for (const Enrolment& enrolment : waiting) {
    draw(session, field, open, enrolment);
  }
  transaction.commit();
  return waiting.size();
}

AllocationEntry overrideAllocation(SessionContext& session, const CohortId& cohortId,
                                   const EnrolmentId& enrolmentId, const GroupId& groupId,
                                   const std::string& reason) {
  session.require(Operation::kAllocationRun);
  if (reason.empty()) {
    refuse(Text::tr("an override needs a reason"), enrolmentId, Text::tr("Say in a few words why"));
  }
  Transaction transaction(session.connection());
  const DrawField field = readDrawField(session, cohortId);
  StoredDraw open = readDraw(session, field);
  const auto last = std::find_if(open.records.rbegin(), open.records.rend(),
                                 [&](const AllocationEntry& r) { return r.enrolmentId == enrolmentId; });
  if (last == open.records.rend()) {
    refuse(Text::tr("was not allocated by this design"), enrolmentId, Text::tr("Draw the group first"));
  }
  const auto group = std::find_if(field.groups.begin(), field.groups.end(),
                                  [&](const StudyGroup& g) { return g.id == groupId; });
  if (group == field.groups.end()) {
    refuse(Text::tr("there is no such group"), groupId, Text::tr("Choose one of the cohort"));
  }
  if (last->groupId == groupId) {
    refuse(Text::tr("is in this group already"), group->code, Text::tr("Choose another group"));
  }
  StudyRepository study(session.connection());
  AllocationEntry record = *last;
  record.id = session.ids().newUuid();
  record.sequence = static_cast<std::int64_t>(open.records.size() + 1);
  record.groupId = groupId;
  record.numberInGroup = ++open.highestNumber[groupId];
  record.drawBefore = record.drawAfter;  // no random numbers were used
  record.allocatedBy = session.actor().userId;
  record.softwareVersion = softwareVersion();
  record.overrideReason = reason;
  record.allocatedUtc_us = session.now_us();
  record = study.allocate(std::span(&record, 1)).front();
  session.note(AuditAction::kAllocationOverride, AuditObject::kAllocation, record.id,
               {{"enrolment", enrolmentId}, {"record", record.recordHash}}, reason);
  transaction.commit();
  return record;
}

namespace {

LockedDesign requireDesign(StudyRepository& study, const DesignId& designId) {
  for (const Cohort& cohort : study.cohorts()) {
    for (LockedDesign& design : study.designs(cohort.id)) {
      if (design.id == designId) {
        return std::move(design);
      }
    }
  }
  refuse(Text::tr("there is no such design"), designId, Text::tr("Choose one from the list"));
}

}  // namespace

std::string revealSeed(SessionContext& session, const DesignId& designId, const std::string& reason) {
  session.require(Operation::kAllocationReveal);
  StudyRepository study(session.connection());
  const LockedDesign design = requireDesign(study, designId);
  if (reason.empty() && study.designs(design.cohortId).back().id == designId) {
    const DrawField field = readDrawField(session, design.cohortId);
    if (const std::size_t waiting = field.waiting().size(); waiting > 0) {
      refuse(
          Text::tr("%1 {person is|people are} not allocated yet: opening the seed would reveal their group",
                   waiting),
          field.cohort.name, Text::tr("Allocate them first, or give a reason"));
    }
  }
  if (!needsTwoPeople(session.connection())) {
    takeSeedOut(session, designId);
  }
  Transaction transaction(session.connection());
  if (!design.demonstration) {
    requireSecondPerson(session, DutyAct::kRevealAllocation, designId);
  }
  study.revealSeed(designId, session.now_us());
  std::string seed = study.sealedSeed(designId);
  session.note(AuditAction::kAllocationReveal, AuditObject::kAllocationDesign, designId, {}, reason);
  transaction.commit();
  return seed;
}

AllocationCheck checkAllocation(SessionContext& session, const DesignId& designId) {
  session.require(Operation::kAllocationView);
  StudyRepository study(session.connection());
  const LockedDesign stored = requireDesign(study, designId);
  const bool takesOut = stored.seed.empty() && session.may(Operation::kAllocationRun);
  if (takesOut) {
    takeSeedOut(session, designId);
  }
  const std::string seed = study.sealedSeed(designId);
  const std::string salt = study.sealedSalt(designId);
  if (takesOut) {  // nobody reads the seed behind this entry
    session.note(AuditAction::kAllocationCheck, AuditObject::kAllocationDesign, designId);
  }
  if (seed.empty()) {  // a server hides it
    throw Error(ErrorCode::kPermission, Text::tr("the seed of this allocation is sealed"),
                Text::tr("allocation"), Text::tr("Let an allocator check it, or open the seed first"));
  }
  return repeatedDraw(study, stored, seed, salt);
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
  session.note(AuditAction::kAllocationCards, AuditObject::kAllocationDesign, designs.back().id,
               {{"cards", cards.size()}});
  transaction.commit();
  return cards;
}

}  // namespace torsio
