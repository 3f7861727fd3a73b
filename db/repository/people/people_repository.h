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

/// People. All writes of one call are one transaction; every call throws DbError when the database refuses.
class PeopleRepository {
 public:
  explicit PeopleRepository(Connection& connection) : connection_(connection) {}

  void addRaterClasses(std::span<const SeniorityClass> classes);
  [[nodiscard]] std::vector<SeniorityClass> raterClasses() const;

  void addTrainees(std::span<const Trainee> trainees);
  void addRaters(std::span<const Rater> raters);
  /// Gives a person who is stored already (an intern, say) the second part of a rater.
  void makeRater(const PersonId& personId, const std::string& classCode);

  /// Gives a person who is stored already (a physician, say) the second part of a trainee.
  void makeTrainee(const PersonId& personId, const std::string& handedness);

  /// Sex, level, experience, age and state; code and demonstration flag are frozen.
  void updatePerson(const Person& person);
  void setHandedness(const PersonId& personId, const std::string& handedness);
  void setRaterClass(const PersonId& personId, const std::string& classCode);
  /// Whatever parts the person has; erased ones too.
  [[nodiscard]] std::optional<Person> find(const PersonId& personId) const;
  /// Codes of all people, erased ones included: a code is never given twice.
  [[nodiscard]] std::vector<std::string> codes() const;

  /// Ordered by code.
  [[nodiscard]] std::vector<Trainee> trainees() const;
  /// Ordered by class position, then code.
  [[nodiscard]] std::vector<Rater> raters() const;
  [[nodiscard]] std::optional<Trainee> findTrainee(const std::string& code) const;
  [[nodiscard]] std::optional<Rater> findRater(const std::string& code) const;

  [[nodiscard]] std::optional<Identity> identity(const PersonId& personId) const;

  /// Adds the identity, or replaces the one that is there.
  void setIdentity(const Identity& identity);
  /// Whose staff or student number this is.
  [[nodiscard]] std::optional<Identity> identityByExternalId(const std::string& externalId) const;
  /// Of everybody who has one, in no order.
  [[nodiscard]] std::vector<Identity> identities() const;

  void recordConsent(const ConsentDecision& consent);
  /// Every decision, oldest first.
  [[nodiscard]] std::vector<ConsentDecision> consents(const PersonId& personId) const;
  /// The newest decision of every person about every purpose, by person and purpose.
  [[nodiscard]] std::vector<ConsentDecision> newestConsents() const;
  /// Whether the newest decision grants it; without one: false.
  [[nodiscard]] bool hasConsent(const PersonId& personId, const std::string& purpose) const;

 private:
  Connection& connection_;
};

}  // namespace torsio
