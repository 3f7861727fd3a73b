// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/study/day_plan.h"

#include <algorithm>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include "assessment/domain/study/cohort.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/study/occasion_repository.h"
#include "db/repository/study/study_repository.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace {

void checkRequest(const DayPlanRequest& request) {
  const Text where = Text::tr("plan of the day");
  if (request.enrolmentIds.empty()) {
    refuseParameter(Text::tr("nobody is chosen"), where, Text::tr("Choose at least one trainee"));
  }
  if (request.places.empty() || std::any_of(request.places.begin(), request.places.end(),
                                            [](const std::string& place) { return place.empty(); })) {
    refuseParameter(Text::tr("a slot needs a place"), where, Text::tr("Name at least one station or room"));
  }
  if (std::set<std::string>(request.places.begin(), request.places.end()).size() != request.places.size()) {
    refuseParameter(Text::tr("a place is listed twice"), where, Text::tr("Name each station or room once"));
  }
  if (request.duration_us <= 0 || request.pause_us < 0) {
    refuseParameter(Text::tr("the duration of a slot must be above zero"), where,
                    Text::tr("Give minutes above zero"));
  }
}

/// Returns the codes of active enrolments.
std::map<EnrolmentId, std::string> takingPart(SessionContext& session, const CohortId& cohortId) {
  std::map<EnrolmentId, std::string> codes;
  for (const Enrolment& enrolment : StudyRepository(session.connection()).enrolments(cohortId)) {
    if (enrolment.state != EnrolmentState::kWithdrawn) {
      codes[enrolment.id] = enrolment.traineeCode;
    }
  }
  return codes;
}

void refuseClash(const DaySlot& wanted, const std::vector<DaySlot>& present) {
  for (const DaySlot& other : present) {
    if (other.startsUtc_us >= wanted.endsUtc_us() || other.endsUtc_us() <= wanted.startsUtc_us) {
      continue;
    }
    if (other.place == wanted.place) {
      refuse(Text::tr("%1 is taken at that time, by %2", wanted.place, other.traineeCode), wanted.traineeCode,
             Text::tr("Choose another time or place, or take that slot out of the plan"));
    }
    if (other.enrolmentId == wanted.enrolmentId) {
      refuse(Text::tr("has another slot at that time, at %1", other.place), wanted.traineeCode,
             Text::tr("Choose another time, or take that slot out of the plan"));
    }
  }
}

}  // namespace

nlohmann::json slotJson(const DaySlot& slot) {
  return {{"place", slot.place},
          {"starts_utc_us", slot.startsUtc_us},
          {"minutes", slot.duration_us / kMinute_us}};
}

std::vector<DaySlot> planDay(SessionContext& session, const DayPlanRequest& request) {
  session.require(Operation::kStudySetup);
  checkRequest(request);
  Transaction transaction(session.connection());
  const std::map<EnrolmentId, std::string> codes = takingPart(session, request.cohortId);
  std::vector<DaySlot> slots;
  for (std::size_t i = 0; i < request.enrolmentIds.size(); ++i) {
    const auto code = codes.find(request.enrolmentIds[i]);
    if (code == codes.end()) {
      refuse(Text::tr("this trainee takes no part in the cohort"), request.enrolmentIds[i],
             Text::tr("Choose one from the list"));
    }
    const auto round = static_cast<std::int64_t>(i / request.places.size());
    slots.push_back({session.ids().newUuid(), request.enrolmentIds[i],
                     request.places[i % request.places.size()],
                     request.firstUtc_us + round * (request.duration_us + request.pause_us),
                     request.duration_us, code->second});
  }
  SlotRepository repository(session.connection());
  std::vector<DaySlot> present =
      repository.between({}, slots.front().startsUtc_us, slots.back().endsUtc_us());
  for (const DaySlot& slot : slots) {
    refuseClash(slot, present);
    present.push_back(slot);
  }
  repository.add(slots);
  for (const DaySlot& slot : slots) {
    session.note(AuditAction::kSlotPlan, AuditObject::kEnrolment, slot.enrolmentId, slotJson(slot));
  }
  transaction.commit();
  return slots;
}

std::vector<DaySlot> daySlots(SessionContext& session, const CohortId& cohortId, std::int64_t fromUtc_us,
                              std::int64_t toUtc_us) {
  session.require(Operation::kStudySetup);
  return SlotRepository(session.connection()).between(cohortId, fromUtc_us, toUtc_us);
}

void removeSlots(SessionContext& session, const CohortId& cohortId, std::span<const DaySlotId> slotIds) {
  session.require(Operation::kStudySetup);
  Transaction transaction(session.connection());
  SlotRepository repository(session.connection());
  const std::vector<DaySlot> all = repository.between(cohortId, 0, INT64_MAX);
  for (const DaySlotId& id : slotIds) {
    const auto slot = std::find_if(all.begin(), all.end(), [&](const DaySlot& one) { return one.id == id; });
    if (slot == all.end()) {
      refuse(Text::tr("this slot is no longer in the plan"), id, Text::tr("Read the plan again"));
    }
    repository.remove(id);
    session.noteChange(AuditAction::kSlotRemove, AuditObject::kEnrolment, slot->enrolmentId, slotJson(*slot),
                       {});
  }
  transaction.commit();
}

const DaySlot* slotAt(std::span<const DaySlot> slots, const EnrolmentId& enrolmentId, std::int64_t utc_us) {
  const DaySlot* found = nullptr;
  for (const DaySlot& slot : slots) {
    if (slot.enrolmentId == enrolmentId && (found == nullptr || slot.startsUtc_us <= utc_us)) {
      found = &slot;
    }
  }
  return found;
}

}  // namespace torsio
