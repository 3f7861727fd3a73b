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

/// Ages that are believed; outside, a slip of the pen is assumed.
inline constexpr std::int64_t kYoungest_years = 14;
inline constexpr std::int64_t kOldest_years = 100;

/// One person as lists show it: under a code, never under a name.
struct PersonRow {
  Person person{};
  bool trainee = false;
  std::string handedness{};  ///< of a trainee; empty: not known
  bool rater = false;
  std::string raterClass{};             ///< code, of a rater
  std::vector<std::string> consents{};  ///< purposes whose newest decision grants them
};

/// A person of the roster with the identity behind the code.
struct NamedPersonRow {
  PersonRow row{};
  Identity identity{};  ///< empty texts when there is none
};

/// Everybody who was not erased, ordered by code. kPersonViewCoded.
[[nodiscard]] std::vector<PersonRow> people(SessionContext& session);
/// Everybody who was not erased, with names, ordered by code. kPersonViewIdentity.
[[nodiscard]] std::vector<NamedPersonRow> namedPeople(SessionContext& session);

/// One person to enter by hand. Empty texts mean "not known".
struct PersonEntry {
  std::string fullName{};    ///< required
  std::string externalId{};  ///< staff or student number: by it a person is recognised; unique
  std::string email{};
  std::string sex{};  ///< "female", "male", "other"
  std::string level{};
  std::string experience{};
  std::optional<std::int64_t> age_years{};
  bool trainee = true;
  std::string handedness{};  ///< "left", "right"
  std::string raterClass{};  ///< code; not empty: the person scores
};

/// Stores a new person under the next free code ("T-31", "R-11"). Returns the id. Audited under the code,
/// never with the name. kPersonEdit. Throws Error{kBadData} when the staff number is known already.
PersonId addPerson(SessionContext& session, const PersonEntry& entry);
/// What the dialog starts from. kPersonEdit and kPersonViewIdentity.
[[nodiscard]] PersonEntry personEntry(SessionContext& session, const PersonId& personId);
/// Replaces all fields; a part (trainee, rater) can be added, not taken away. kPersonEdit.
void changePerson(SessionContext& session, const PersonId& personId, const PersonEntry& entry,
                  const std::string& reason);
/// Active or left: who left keeps the record and is offered nowhere. kPersonEdit.
void setPersonState(SessionContext& session, const PersonId& personId, PersonState state,
                    const std::string& reason);

/// Interns, deputy chiefs and chiefs (paper section 5.3).
[[nodiscard]] std::vector<SeniorityClass> paperRaterClasses();
/// Classes of raters in their order; the three of the paper are made when there are none. kPersonEdit.
std::vector<SeniorityClass> ensureRaterClasses(SessionContext& session);

/// Writes the list as CSV (UTF-8 with byte order mark, so that spreadsheets read it right). Coded:
/// kReportExportCoded. With names: kReportExportNamed; that the names were taken out is audited, with the
/// hash of the file. Returns the number of people. Throws Error{kFileUnwritable}.
std::size_t exportPeople(SessionContext& session, const std::filesystem::path& file, bool withNames,
                         const CsvStyle& look = {});

/// Prefixes of pseudonyms.
inline constexpr const char* kTraineePrefix = "T";
inline constexpr const char* kRaterPrefix = "R";

/// Gives out pseudonyms "T-01", "T-02" ... above every number that was ever used with the prefix: a code is
/// never given twice.
class PersonCodes {
 public:
  explicit PersonCodes(std::set<std::string> used) : used_(std::move(used)) {}
  [[nodiscard]] std::string next(const std::string& prefix);

 private:
  std::set<std::string> used_;
};

}  // namespace torsio
