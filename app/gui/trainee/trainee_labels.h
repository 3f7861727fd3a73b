// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

#include "app/services/devices/device_readiness.h"
#include "app/services/training/debrief.h"
#include "app/services/training/next_steps.h"
#include "app/services/training/trend.h"

namespace torsio::gui {

/// Sentences of the station, in the present language. Names, values and verdicts format themselves.
class StationLabels {
  Q_DECLARE_TR_FUNCTIONS(StationLabels)

 public:
  [[nodiscard]] static QString minutes(std::int64_t span_us);
  /// Formats a waiting time: "3 h".
  [[nodiscard]] static QString waited(std::int64_t span_us);

  [[nodiscard]] static QString state(StepState state);
  /// Explains why a module is locked, or what mastery still needs.
  [[nodiscard]] static QString why(const ModuleStep& step);
  [[nodiscard]] static QString lastResult(const ModuleStep& step);
  [[nodiscard]] static QString unlocks(const ModuleStep& step);

  /// Describes a result of the same run under an older version of the definitions.
  [[nodiscard]] static QString earlier(const EarlierMeasure& earlier);

  [[nodiscard]] static QString level(const CompetenceVerdict& verdict);
  [[nodiscard]] static QString levelMeaning(const CompetenceVerdict& verdict);
  /// Explains the rule of competence, and its error rates.
  [[nodiscard]] static QString competenceRule(const CompetenceVerdict& verdict);
  [[nodiscard]] static QString competenceErrors(const CompetenceVerdict& verdict);
  [[nodiscard]] static QString readiness(const ReadinessFinding& finding);
  [[nodiscard]] static QString light(Light light);
};

}  // namespace torsio::gui
