// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

#include "app/services/devices/device_readiness.h"
#include "app/services/training/debrief.h"
#include "app/services/training/next_steps.h"
#include "app/services/training/trend.h"

namespace torsio::gui {

/// Sentences of the station, in the present language. Values come in SI and leave in the units of a ward.
class StationLabels {
  Q_DECLARE_TR_FUNCTIONS(StationLabels)

 public:
  /// "12.4 s", "3.1°", "62 %"; "yes" and "no" of a metric that answers a question.
  [[nodiscard]] static QString quantity(const std::string& metric, double value);
  /// What stands in place of a value that an attempt does not have.
  [[nodiscard]] static QString without(const std::string& metric);
  /// Value of a metric without its unit, for an axis; unitOf() gives the unit.
  [[nodiscard]] static double inDisplayUnit(const std::string& metric, double value);
  [[nodiscard]] static QString unitOf(const std::string& metric);
  [[nodiscard]] static QString metric(const std::string& id);

  [[nodiscard]] static QString minutes(std::int64_t span_us);
  /// How long something has waited: "3 h".
  [[nodiscard]] static QString waited(std::int64_t span_us);

  [[nodiscard]] static QString state(StepState state);
  /// Why it is locked, or what is missing for mastery.
  [[nodiscard]] static QString why(const ModuleStep& step);
  [[nodiscard]] static QString rule(const RuleProgress& progress);
  /// What an attempt came to: "3 of 4" twists on target, or how an organ was undone.
  [[nodiscard]] static QString result(const Attempt& attempt);
  [[nodiscard]] static QString lastResult(const ModuleStep& step);
  [[nodiscard]] static QString unlocks(const ModuleStep& step);

  [[nodiscard]] static QString check(const TargetCheck& check, std::size_t twists);
  /// What an older version of the definitions had measured of the same run.
  [[nodiscard]] static QString earlier(const EarlierMeasure& earlier);
  /// What was good or bad, in one sentence.
  [[nodiscard]] static QString finding(const DebriefFinding& finding, bool strength);
  /// What to try next.
  [[nodiscard]] static QString advice(const std::string& metric);

  [[nodiscard]] static QString level(const CompetenceVerdict& verdict);
  [[nodiscard]] static QString levelMeaning(const CompetenceVerdict& verdict);
  /// What counts as able, and how often that is wrong.
  [[nodiscard]] static QString competenceDesign(const CompetenceVerdict& verdict);
  [[nodiscard]] static QString competenceErrors(const CompetenceVerdict& verdict);
  [[nodiscard]] static QString readiness(const ReadinessFinding& finding);
  [[nodiscard]] static QString light(Light light);
};

}  // namespace torsio::gui
