// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <QTemporaryDir>

#include "app/connectors/xapi/lrs_delivery.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/learning_event.h"
#include "tests/app/support/training_centre.h"
#include "tests/support/test_lrs.h"

namespace torsio {

/// A small centre with a learning record store. T-01 consents to learning records, T-02 does not; the
/// account's settings are in a temporary folder.
class XapiCentre {
 public:
  XapiCentre();

  TrainingCentre& centre() { return centre_; }
  testing::TestLrs& store() { return store_; }
  Connection& connection() { return centre_.connection(); }
  /// Signs in as a user who may change settings.
  SessionContext& asAdministrator();
  /// Turns sending on and gives this station the key.
  void turnOn();
  /// Stores another decision of a trainee about learning records.
  void decide(const std::string& traineeCode, bool granted);
  [[nodiscard]] PersonId person(const std::string& traineeCode);
  /// Enrols a trainee in a new cohort. Returns the enrolment.
  std::string enrol(const std::string& traineeCode);
  /// Records and measures a run of T-01 at "first". Returns the trial.
  std::string run(double skill = 1.0);

  [[nodiscard]] std::vector<LearningEvent> outbox();
  [[nodiscard]] LearningEventCounts counts();
  /// Runs one round of sending.
  LrsDelivery deliver(std::chrono::milliseconds patience = std::chrono::seconds(30));
  /// Lets all retry intervals expire.
  void waitLong() { centre_.passTime_us(24 * 60 * kMinute_us + kMinute_us); }

 private:
  QTemporaryDir settings_;
  TrainingCentre centre_;
  testing::TestLrs store_;
  int cohorts_ = 0;
};

}  // namespace torsio
