// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/people/roster_import.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/services/base/identifiers.h"
#include "app/services/people/people_service.h"
#include "app/services/people/roster_rows.h"
#include "app/services/people/roster_undo.h"
#include "assessment/domain/people/account.h"
#include "assessment/domain/people/person.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/people/roster_import_repository.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr std::size_t kLinesBetweenSigns = 200;

/// Reports occasionally how many lines are done.
class LineCount {
 public:
  LineCount(const ProgressCallback& progress, Text step, std::size_t total, double from, double to)
      : progress_(progress),
        step_(std::move(step)),
        total_(std::max<std::size_t>(1, total)),
        from_(from),
        to_(to) {
    say();
  }
  void next() {
    if (++done_ % kLinesBetweenSigns == 0) {
      say();
    }
  }

 private:
  void say() const {
    const double share = static_cast<double>(done_) / static_cast<double>(total_);
    if (progress_) {
      progress_({step_, from_ + (to_ - from_) * share, -1.0});
    }
  }
  const ProgressCallback& progress_;
  Text step_;
  std::size_t total_;
  double from_;
  double to_;
  std::size_t done_ = 0;
};

std::string fingerprintOf(const RosterPreview& preview) {
  Digest digest;
  const auto add = [&](const std::string& text) {
    digest.update(static_cast<std::int64_t>(text.size()));
    digest.update(text);
  };
  for (const RosterRow& row : preview.rows) {
    digest.update(static_cast<std::int64_t>(row.line));
    digest.update(static_cast<std::int64_t>(row.status));
    for (const std::string& value : row.values) {
      add(value);
    }
    add(row.personId);
    for (const RosterChange& change : row.changes) {
      digest.update(static_cast<std::int64_t>(change.field));
      add(change.from);
    }
  }
  return digest.hex();
}

RosterPreview preview(SessionContext& session, const RosterFile& file, RosterKind kind,
                      const RosterColumns& columns, const ProgressCallback& progress, double share) {
  checkColumns(file, kind, columns);
  const KnownPeople known = readKnown(session);
  RosterPreview preview;
  preview.kind = kind;
  std::map<std::string, std::size_t> firstOf;  // number -> place in the preview
  std::map<std::string, std::size_t> alike;    // keyed by likenessOf() the number
  std::map<std::string, std::size_t> emails;   // keyed by likenessOf() the address
  LineCount count(progress, Text::tr("Comparing with the record"), file.rows.size(), 0.0, share);
  for (const CsvRecord& record : file.rows) {
    count.next();
    RosterRow row;
    row.line = record.line;
    if (record.values.size() != file.header.size()) {
      refuseRow(
          row,
          Text::tr("the line has %1 {value|values}, the header %2", record.values.size(), file.header.size()),
          Text::tr("Give one value a column; put a value that holds the separator in quotes"));
    } else {
      for (const RosterField field : rosterFields(kind)) {
        if (columns[rosterIndex(field)]) {
          row.values[rosterIndex(field)] = record.values[*columns[rosterIndex(field)]];
        }
      }
      understand(row, kind, known);
      const std::string& number = row.values[rosterIndex(RosterField::kExternalId)];
      const auto [first, fresh] = firstOf.emplace(number, preview.rows.size());
      if (!number.empty() && !fresh) {
        const RosterRow& before = preview.rows[first->second];
        if (row.problem.empty() && row.values == before.values) {
          row.status = RosterStatus::kSame;
          row.hint = Text::tr("the same as line %1: taken once", before.line);
          ++preview.same;
          preview.rows.push_back(std::move(row));
          continue;
        }
        refuseRow(row, Text::tr("the number %1 is already on line %2", number, before.line),
                  Text::tr("Remove one of the two lines, or correct the number"));
      }
      const auto [twin, alone] = alike.emplace(likenessOf(number), row.line);
      if (!number.empty() && !alone) {
        refuseRow(row,
                  Text::tr("the number %1 looks like that of line %2, but is another", number, twin->second),
                  Text::tr("Write both in the same way, or change one of the two"));
      }
      if (row.problem.empty()) {
        compareWithKnown(row, kind, known);
      }
      const std::string& email = row.values[rosterIndex(RosterField::kEmail)];
      if (const auto [other, only] = emails.emplace(likenessOf(email), row.line); !email.empty() && !only) {
        addHint(row, Text::tr("line %1 has the same e-mail address", other->second));
      }
      if (isSpreadsheetNumber(number)) {
        addHint(row, Text::tr("the number looks like one that a spreadsheet has shortened: compare it with "
                              "the original list"));
      }
    }
    preview.added += row.status == RosterStatus::kNew ? 1 : 0;
    preview.same += row.status == RosterStatus::kSame ? 1 : 0;
    preview.changed += row.status == RosterStatus::kChanges ? 1 : 0;
    preview.errors += row.status == RosterStatus::kError ? 1 : 0;
    preview.rows.push_back(std::move(row));
  }
  preview.fingerprint = fingerprintOf(preview);
  return preview;
}

void requireRosterRights(const SessionContext& session) {
  session.require(Operation::kPersonEdit);
  session.require(Operation::kPersonViewIdentity);
}

nlohmann::json addedJson(const Person& person, const std::string& part) {
  return {{"code", person.code},
          {"part", part},
          {"sex", person.sex},
          {"level", person.level},
          {"experience", person.experience}};
}

/// Adds the new people. Codes are given in the order of the random ids, which hides the order of the roster.
std::vector<std::string> addNew(SessionContext& session, const RosterPreview& preview, LineCount& count,
                                std::vector<StoredRosterPerson>& done) {
  PeopleRepository repository(session.connection());
  const std::vector<std::string> used = repository.codes();
  PersonCodes codes({used.begin(), used.end()});
  std::map<std::string, const RosterRow*> byId;
  for (const RosterRow& row : preview.rows) {
    if (row.status == RosterStatus::kNew) {
      byId[session.ids().newUuid()] = &row;
    }
  }
  const bool trainees = preview.kind == RosterKind::kTrainees;
  std::vector<std::string> newCodes;
  for (const auto& [id, row] : byId) {
    count.next();
    PersonEntry entry{.trainee = trainees};
    for (const RosterField field : rosterFields(preview.kind)) {
      if (!row->values[rosterIndex(field)].empty()) {
        setValue(entry, field, row->values[rosterIndex(field)]);
      }
    }
    Person person{.id = id,
                  .code = codes.next(trainees ? kTraineePrefix : kRaterPrefix),
                  .sex = entry.sex,
                  .level = entry.level,
                  .experience = entry.experience,
                  .age_years = entry.age_years,
                  .createdUtc_us = session.now_us()};
    if (trainees) {
      repository.addTrainees(std::vector<Trainee>{{person, entry.handedness}});
    }
    if (!trainees) {
      repository.addRaters(std::vector<Rater>{{person, entry.raterClass}});
    }
    repository.setIdentity({id, entry.fullName, entry.email, entry.externalId});
    session.note(AuditAction::kPersonAdd, AuditObject::kPerson, id,
                 addedJson(person, trainees ? "trainee" : entry.raterClass));
    newCodes.push_back(person.code);
    done.push_back({.personId = id, .afterJson = rosterJson(entry)});
  }
  return newCodes;
}

void applyChanges(SessionContext& session, const RosterPreview& preview, LineCount& count,
                  std::vector<StoredRosterPerson>& done) {
  for (const RosterRow& row : preview.rows) {
    if (row.status != RosterStatus::kChanges) {
      continue;
    }
    count.next();
    PersonEntry entry = personEntry(session, row.personId);
    const std::string before = rosterJson(entry);
    for (const RosterChange& change : row.changes) {
      setValue(entry, change.field, change.to);
    }
    if (preview.kind == RosterKind::kTrainees) {
      entry.trainee = true;
    }
    changePerson(session, row.personId, entry, "roster import");
    done.push_back({row.personId, before, rosterJson(entry)});
  }
}

}  // namespace

RosterPreview previewRoster(SessionContext& session, const RosterFile& file, RosterKind kind,
                            const RosterColumns& columns, const ProgressCallback& progress) {
  requireRosterRights(session);
  return preview(session, file, kind, columns, progress, 1.0);
}

RosterOutcome importRoster(SessionContext& session, const RosterFile& file, RosterKind kind,
                           const RosterColumns& columns, const std::string& fingerprint, RosterMode mode,
                           const ProgressCallback& progress) {
  constexpr double kComparing = 0.2;  // share of the total progress
  requireRosterRights(session);
  Transaction transaction(session.connection());
  const RosterPreview now = preview(session, file, kind, columns, progress, kComparing);
  for (const RosterRow& row : now.rows) {
    if (row.status != RosterStatus::kError) {
      continue;
    }
    refuse(row.problem, Text::tr("%1, line %2", file.name, row.line), row.remedy);
  }
  if (now.fingerprint != fingerprint) {
    refuse(Text::tr("the record has changed since the preview"), file.name,
           Text::tr("Check the preview again"));
  }
  if (kind == RosterKind::kRaters) {
    ensureRaterClasses(session);
  }
  RosterOutcome outcome;
  LineCount count(progress, mode == RosterMode::kDryRun ? Text::tr("Trying it out") : Text::tr("Importing"),
                  now.added + now.changed, kComparing, 1.0);
  std::vector<StoredRosterPerson> done;
  outcome.newCodes = addNew(session, now, count, done);
  applyChanges(session, now, count, done);
  keepImport(session, kind, done);
  outcome.added = now.added;
  outcome.changed = now.changed;
  session.note(
      AuditAction::kRosterImport, AuditObject::kPerson, {},
      {{"added", now.added}, {"changed", now.changed}, {"same", now.same}, {"blake2b", file.contentHash}});
  if (mode == RosterMode::kCommit) {
    transaction.commit();
  }
  return outcome;
}

}  // namespace torsio
