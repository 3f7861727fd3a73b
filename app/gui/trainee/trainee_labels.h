// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

#include "app/services/devices/device_readiness.h"
#include "app/services/training/debrief.h"
#include "app/services/training/next_steps.h"
#include "app/services/training/trend.h"

namespace torsio::gui {

/// Sentences of the station, in the present language. Names, values and verdicts print themselves.
class StationLabels {
  Q_DECLARE_TR_FUNCTIONS(StationLabels)

 public:
  [[nodiscard]] static QString minutes(std::int64_t span_us);
  /// How long something has waited: "3 h".
  [[nodiscard]] static QString waited(std::int64_t span_us);

  [[nodiscard]] static QString state(StepState state);
  /// Why it is locked, or what is missing for mastery.
  [[nodiscard]] static QString why(const ModuleStep& step);
  [[nodiscard]] static QString lastResult(const ModuleStep& step);
  [[nodiscard]] static QString unlocks(const ModuleStep& step);

  /// What an older version of the definitions had measured of the same run.
  [[nodiscard]] static QString earlier(const EarlierMeasure& earlier);

  [[nodiscard]] static QString level(const CompetenceVerdict& verdict);
  [[nodiscard]] static QString levelMeaning(const CompetenceVerdict& verdict);
  /// What counts as competent, and how often that is wrong.
  [[nodiscard]] static QString competenceRule(const CompetenceVerdict& verdict);
  [[nodiscard]] static QString competenceErrors(const CompetenceVerdict& verdict);
  [[nodiscard]] static QString readiness(const ReadinessFinding& finding);
  [[nodiscard]] static QString light(Light light);
};

}  // namespace torsio::gui
