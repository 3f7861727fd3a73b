// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/base/study_labels.h"

#include <span>
#include <utility>

#include <QCoreApplication>

#include "app/gui/base/translated_text.h"
#include "app/services/training/debrief_labels.h"
#include "assessment/domain/rating/sheet_state.h"
#include "assessment/metrics/metric_cards.h"

namespace torsio::gui {

namespace {

using Names = std::span<const std::pair<const char*, const char*>>;

QString translated(const char* text) {
  return QCoreApplication::translate("Study", text);
}

QString named(Names names, const std::string& code) {
  if (code.empty()) {
    return QStringLiteral("\u2013");
  }
  for (const auto& [known, name] : names) {
    if (code == known) {
      return translated(name);
    }
  }
  return toQString(code);
}

}  // namespace

QString occasionName(const Occasion& occasion) {
  static const std::pair<const char*, const char*> kNames[] = {
      {"pre", QT_TRANSLATE_NOOP("Study", "before training")},
      {"mid", QT_TRANSLATE_NOOP("Study", "half-way")},
      {"post", QT_TRANSLATE_NOOP("Study", "after training")}};
  for (const auto& [known, name] : kNames) {
    if (occasion.code == known) {
      return translated(name);
    }
  }
  return named({}, occasion.label);
}

QString factorName(const std::string& code) {
  static const std::pair<const char*, const char*> kNames[] = {
      {"sex", QT_TRANSLATE_NOOP("Study", "sex")},
      {"level", QT_TRANSLATE_NOOP("Study", "level of education")},
      {"experience", QT_TRANSLATE_NOOP("Study", "experience")},
      {"handedness", QT_TRANSLATE_NOOP("Study", "handedness")}};
  return named(kNames, code);
}

QString levelName(const std::string& code) {
  static const std::pair<const char*, const char*> kNames[] = {
      {"female", QT_TRANSLATE_NOOP("Study", "female")},
      {"male", QT_TRANSLATE_NOOP("Study", "male")},
      {"other", QT_TRANSLATE_NOOP("Study", "other")},
      {"left", QT_TRANSLATE_NOOP("Study", "left-handed")},
      {"right", QT_TRANSLATE_NOOP("Study", "right-handed")}};
  return code.empty() ? translated(QT_TRANSLATE_NOOP("Study", "not known")) : named(kNames, code);
}

QString raterClassName(const std::string& code) {
  static const std::pair<const char*, const char*> kNames[] = {
      {"intern", QT_TRANSLATE_NOOP("Study", "intern")},
      {"deputy_chief", QT_TRANSLATE_NOOP("Study", "deputy chief physician")},
      {"chief", QT_TRANSLATE_NOOP("Study", "chief physician")}};
  return named(kNames, code);
}

QString methodName(AllocationMethod method) {
  switch (method) {
    case AllocationMethod::kCompletePermutation:
      return translated(
          QT_TRANSLATE_NOOP("Study", "Simple randomisation into equal groups (as in the paper)"));
    case AllocationMethod::kPermutedBlocks:
      return translated(QT_TRANSLATE_NOOP("Study", "Shuffled blocks, one after another"));
    case AllocationMethod::kStratifiedBlocks:
      return translated(QT_TRANSLATE_NOOP("Study", "Shuffled blocks within strata"));
    case AllocationMethod::kMinimisation:
      return translated(QT_TRANSLATE_NOOP("Study", "Minimisation (Pocock and Simon)"));
  }
  return {};
}

QString sheetStateName(SheetState state) {
  switch (state) {
    case SheetState::kOpen:
      return translated(QT_TRANSLATE_NOOP("Study", "open"));
    case SheetState::kDraft:
      return translated(QT_TRANSLATE_NOOP("Study", "draft"));
    case SheetState::kSubmitted:
      return translated(QT_TRANSLATE_NOOP("Study", "submitted"));
    case SheetState::kWithdrawn:
      return translated(QT_TRANSLATE_NOOP("Study", "taken back"));
  }
  return {};
}

std::vector<std::pair<std::string, QString>> masteryMetrics() {
  static const char* const kMetrics[] = {kOnTargetMetric,
                                         kTargetsReachedMetric,
                                         "time.total",
                                         "twist.overshoot",
                                         "twist.settling",
                                         "twist.hold_steadiness",
                                         "twist.sparc",
                                         "force.peak",
                                         "force.violations",
                                         "torque.peak",
                                         "detorse.done",
                                         "detorse.time_to_flow",
                                         "detorse.dose",
                                         "detorse.residual",
                                         "detorse.relapse",
                                         "detorse.first_direction",
                                         "detorse.wrong_way",
                                         "detorse.regrips",
                                         "detorse.slip_back",
                                         "detorse.peak_jaw",
                                         "detorse.overload_time",
                                         "detorse.vented_first",
                                         "detorse.longest_stage",
                                         "detorse.in_stages"};
  std::vector<std::pair<std::string, QString>> out;
  for (const char* id : kMetrics) {
    const QString name = toQString(metricName(id));
    out.emplace_back(
        id, isAnswerMetric(id) ? QCoreApplication::translate("Study", "%1 (1 yes, 0 no)").arg(name) : name);
  }
  return out;
}

ShownMetric shownMetric(const std::string& id) {
  const std::string unit = metricUnit(id);
  const bool close = unit.empty() || unit == "\u00b0";
  return {.scale = metricScale(id),
          .decimals = metricDecimals(id),
          .suffix = close ? toQString(unit) : QLatin1Char(' ') + toQString(unit)};
}

std::string metricBetter(const std::string& id) {
  if (id == kOnTargetMetric || id == kTargetsReachedMetric) {
    return "at_least";
  }
  return metricCard(id).direction == Direction::kLowerIsBetter ? "at_most" : "at_least";
}

std::string storedUnit(const std::string& id) {
  if (id == kOnTargetMetric) {
    return "1";
  }
  if (id == kTargetsReachedMetric) {
    return "count";
  }
  return std::string(metricCard(id).unit);
}

}  // namespace torsio::gui
