// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "db/connection/connection.h"

namespace torsio {

/// The coded record of a person: a pseudonym and what groups are balanced by. Never a name. The code and the
/// demonstration flag are frozen once stored. Empty texts mean "not known".
struct StoredPerson {
  std::string id{};    ///< UUID
  std::string code{};  ///< pseudonym, unique: "T-07"
  std::string sex{};   ///< "female", "male", "other" or empty
  std::string level{};
  std::string experience{};
  std::optional<std::int64_t> age_years{};
  std::string state = "active";  ///< "active", "left", "erased"
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
};

/// The link from code to name, kept in a table of its own.
struct StoredIdentity {
  std::string personId{};
  std::string fullName{};
  std::string email{};
  std::string externalId{};  ///< staff or student number; unique
};

struct StoredTrainee {
  StoredPerson person{};
  std::string handedness{};  ///< "left", "right" or empty
};

struct StoredRaterClass {
  std::string code{};  ///< "intern", "deputy_chief", "chief"
  std::string label{};
  std::int64_t position = 0;
};

struct StoredRater {
  StoredPerson person{};
  std::string classCode{};
};

/// A person's decision about one purpose. Append-only: the newest one counts.
struct StoredConsent {
  std::string personId{};
  std::string purpose{};  ///< "training_record", "video", "research", "xapi_export", "teaching"
  bool granted = false;
  std::string textVersion{};  ///< of the text that was shown
  std::int64_t decidedUtc_us = 0;
  std::string recordedBy{};
  bool demonstration = false;
};

/// People. All writes of one call are one transaction; every call throws DbError when the database refuses.
class PeopleRepository {
 public:
  explicit PeopleRepository(Connection& connection) : connection_(connection) {}

  void addRaterClasses(std::span<const StoredRaterClass> classes);
  [[nodiscard]] std::vector<StoredRaterClass> raterClasses() const;

  void addTrainees(std::span<const StoredTrainee> trainees);
  void addRaters(std::span<const StoredRater> raters);
  /// Gives a person who is stored already (an intern, say) the second part of a rater.
  void makeRater(const std::string& personId, const std::string& classCode);

  /// Gives a person who is stored already (a physician, say) the second part of a trainee.
  void makeTrainee(const std::string& personId, const std::string& handedness);

  /// Sex, level, experience, age and state; code and demonstration flag are frozen.
  void updatePerson(const StoredPerson& person);
  void setHandedness(const std::string& personId, const std::string& handedness);
  void setRaterClass(const std::string& personId, const std::string& classCode);
  /// Whatever parts the person has; erased ones too.
  [[nodiscard]] std::optional<StoredPerson> find(const std::string& personId) const;
  /// Codes of all people, erased ones included: a code is never given twice.
  [[nodiscard]] std::vector<std::string> codes() const;

  /// Ordered by code.
  [[nodiscard]] std::vector<StoredTrainee> trainees() const;
  /// Ordered by class position, then code.
  [[nodiscard]] std::vector<StoredRater> raters() const;
  [[nodiscard]] std::optional<StoredTrainee> findTrainee(const std::string& code) const;
  [[nodiscard]] std::optional<StoredRater> findRater(const std::string& code) const;

  [[nodiscard]] std::optional<StoredIdentity> identity(const std::string& personId) const;

  /// Adds the identity, or replaces the one that is there.
  void setIdentity(const StoredIdentity& identity);
  /// Whose staff or student number this is.
  [[nodiscard]] std::optional<StoredIdentity> identityByExternalId(const std::string& externalId) const;
  /// Of everybody who has one, in no order.
  [[nodiscard]] std::vector<StoredIdentity> identities() const;

  void recordConsent(const StoredConsent& consent);
  /// Every decision, oldest first.
  [[nodiscard]] std::vector<StoredConsent> consents(const std::string& personId) const;
  /// The newest decision of every person about every purpose, by person and purpose.
  [[nodiscard]] std::vector<StoredConsent> newestConsents() const;
  /// Whether the newest decision grants it; without one: false.
  [[nodiscard]] bool hasConsent(const std::string& personId, const std::string& purpose) const;

 private:
  Connection& connection_;
};

}  // namespace torsio
