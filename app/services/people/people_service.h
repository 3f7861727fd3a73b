// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/base/csv_style.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/person.h"

namespace torsio {

/// A person in lists: with a code, without a name.
struct PersonRow {
  Person person{};
  bool trainee = false;
  std::string handedness{};  ///< of a trainee; empty: unknown
  bool rater = false;
  std::string raterClass{};             ///< code; of a rater
  std::vector<std::string> consents{};  ///< purposes whose latest decision grants consent
};

/// A person with code and identity.
struct NamedPersonRow {
  PersonRow row{};
  Identity identity{};  ///< empty texts if there is none
};

/// Returns everybody who was not erased, ordered by code. kPersonViewCoded.
[[nodiscard]] std::vector<PersonRow> people(SessionContext& session);
/// Returns everybody who was not erased, with names, ordered by code. kPersonViewIdentity.
[[nodiscard]] std::vector<NamedPersonRow> namedPeople(SessionContext& session);

/// A person entered by hand. Empty texts mean "unknown".
struct PersonEntry {
  std::string fullName{};    ///< required
  std::string externalId{};  ///< staff or student number: unique, identifies the person
  std::string email{};
  std::string sex{};  ///< "female", "male", "other"
  std::string level{};
  std::string experience{};
  std::optional<std::int64_t> age_years{};
  bool trainee = true;
  std::string handedness{};  ///< "left", "right"
  std::string raterClass{};  ///< code; not empty: the person is a rater
};

/// Stores a new person under the next free code ("T-31", "R-11"). Returns the id. Audited under the code,
/// never with the name. kPersonEdit. Throws Error{kBadData} if the staff number exists already.
PersonId addPerson(SessionContext& session, const PersonEntry& entry);
/// Returns the fields of a person as somebody would enter them.
[[nodiscard]] PersonEntry entryOf(const NamedPersonRow& named);
/// Returns the initial values of the dialog. kPersonEdit and kPersonViewIdentity.
[[nodiscard]] PersonEntry personEntry(SessionContext& session, const PersonId& personId);
/// Replaces all fields; a role (trainee, rater) can be added but not removed. kPersonEdit.
void changePerson(SessionContext& session, const PersonId& personId, const PersonEntry& entry,
                  const std::string& reason);
/// Sets active or left: people who left keep their record but cannot be chosen. kPersonEdit.
void setPersonState(SessionContext& session, const PersonId& personId, PersonState state,
                    const std::string& reason);

/// Returns interns, deputy chiefs and chiefs (paper section 5.3).
[[nodiscard]] std::vector<SeniorityClass> paperRaterClasses();
/// Returns the classes of raters in order; creates the paper's three if there are none. kPersonEdit.
std::vector<SeniorityClass> ensureRaterClasses(SessionContext& session);

/// Writes the list as CSV (UTF-8 with byte order mark for spreadsheets). Coded: kReportExportCoded. With
/// names: kReportExportNamed, audited with the hash of the file. Returns the number of people. Throws
/// Error{kFileUnwritable}.
std::size_t exportPeople(SessionContext& session, const std::filesystem::path& file, bool withNames,
                         const CsvStyle& look = {});

/// Prefixes of pseudonyms.
inline constexpr const char* kTraineePrefix = "T";
inline constexpr const char* kRaterPrefix = "R";

/// Creates pseudonyms "T-01", "T-02" ... above every number ever used with the prefix: no code is used twice.
class PersonCodes {
 public:
  explicit PersonCodes(std::set<std::string> used) : used_(std::move(used)) {}
  [[nodiscard]] std::string next(const std::string& prefix);

 private:
  std::set<std::string> used_;
};

}  // namespace torsio
