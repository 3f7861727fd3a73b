// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/people/consent.h"
#include "assessment/domain/people/person.h"
#include "db/connection/connection.h"

namespace torsio {

/// People. All writes of a call are one transaction; every call throws DbError.
class PeopleRepository {
 public:
  explicit PeopleRepository(Connection& connection) : connection_(connection) {}

  void addRaterClasses(std::span<const SeniorityClass> classes);
  [[nodiscard]] std::vector<SeniorityClass> raterClasses() const;

  void addTrainees(std::span<const Trainee> trainees);
  void addRaters(std::span<const Rater> raters);
  /// Makes a stored person (an intern, say) a rater as well.
  void makeRater(const PersonId& personId, const std::string& classCode);

  /// Makes a stored person (a physician, say) a trainee as well.
  void makeTrainee(const PersonId& personId, const std::string& handedness);

  /// Updates sex, level, experience, age and state; code and demonstration flag are frozen.
  void updatePerson(const Person& person);
  void setHandedness(const PersonId& personId, const std::string& handedness);
  void setRaterClass(const PersonId& personId, const std::string& classCode);
  /// Finds any person, including erased ones.
  [[nodiscard]] std::optional<Person> find(const PersonId& personId) const;
  /// Returns the codes of all people, including erased ones: codes are never reused.
  [[nodiscard]] std::vector<std::string> codes() const;

  /// Ordered by code.
  [[nodiscard]] std::vector<Trainee> trainees() const;
  /// Ordered by class position, then code.
  [[nodiscard]] std::vector<Rater> raters() const;
  [[nodiscard]] std::optional<Trainee> findTrainee(const std::string& code) const;
  [[nodiscard]] std::optional<Rater> findRater(const std::string& code) const;

  [[nodiscard]] std::optional<Identity> identity(const PersonId& personId) const;

  void setIdentity(const Identity& identity);
  /// Finds a person by staff or student number.
  [[nodiscard]] std::optional<Identity> identityByExternalId(const std::string& externalId) const;
  /// All identities, unordered.
  [[nodiscard]] std::vector<Identity> identities() const;

  void recordConsent(const ConsentDecision& consent);
  /// All decisions of a person, oldest first.
  [[nodiscard]] std::vector<ConsentDecision> consents(const PersonId& personId) const;
  /// The newest decision of every person about every purpose, by person and purpose.
  [[nodiscard]] std::vector<ConsentDecision> newestConsents() const;
  /// True if the newest decision grants consent; false without one.
  [[nodiscard]] bool hasConsent(const PersonId& personId, const std::string& purpose) const;

 private:
  Connection& connection_;
};

/// The centre's own consent texts, by version. Each call is one transaction.
class ConsentRepository {
 public:
  explicit ConsentRepository(Connection& connection) : connection_(connection) {}

  /// Returns the codes of the purposes in the order in which they are asked.
  [[nodiscard]] std::vector<std::string> purposes() const;
  /// Adds a purpose as the last one. Throws DbError{kUnique} if the code is taken.
  void addPurpose(const std::string& code);

  /// Oldest first; empty: the centre uses the texts as shipped.
  [[nodiscard]] std::vector<ConsentVersion> versions() const;
  /// Throws DbError{kUnique} if another station published this number first.
  void add(const ConsentVersion& version);

 private:
  Connection& connection_;
};

}  // namespace torsio
