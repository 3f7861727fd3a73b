// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trainee/trainee_labels.h"

#include <optional>

#include <QStringList>

#include "app/gui/base/clock_time.h"
#include "app/gui/base/translated_text.h"
#include "app/services/recording/competence_text.h"
#include "app/services/training/debrief_labels.h"

namespace torsio::gui {

namespace {}  // namespace

QString StationLabels::metric(const std::string& id) {
  return toQString(metricName(id));
}

double StationLabels::inDisplayUnit(const std::string& metric, double value) {
  return value * metricScale(metric);
}

QString StationLabels::unitOf(const std::string& metric) {
  return toQString(Text(metricUnit(metric)));
}

QString StationLabels::without(const std::string& metric) {
  return metric == "detorse.time_to_flow" || metric == "detorse.dose_at_flow" ? tr("blood did not come back")
                                                                              : tr("not defined");
}

QString StationLabels::quantity(const std::string& metric, double value) {
  return toQString(quantityText(metric, value));
}

QString StationLabels::minutes(std::int64_t span_us) {
  if (span_us < 60'000'000) {
    return clockTimeLeft(span_us);
  }
  return tr("%1 min").arg((span_us + 59'999'999) / 60'000'000);
}

QString StationLabels::waited(std::int64_t span_us) {
  const std::int64_t minutes = span_us / 60'000'000;
  if (minutes < 1) {
    return tr("a moment");
  }
  if (minutes < 60) {
    return tr("%1 min").arg(minutes);
  }
  if (minutes < 48 * 60) {
    return tr("%1 h").arg(minutes / 60);
  }
  return tr("%n day(s)", nullptr, static_cast<int>(minutes / (24 * 60)));
}

QString StationLabels::state(StepState state) {
  switch (state) {
    case StepState::kLocked:
      return tr("Locked");
    case StepState::kOpen:
      return tr("Open");
    case StepState::kMastered:
      return tr("Mastered");
    case StepState::kUsedUp:
      return tr("No attempt left");
  }
  return {};
}

QString StationLabels::why(const ModuleStep& step) {
  if (step.state == StepState::kLocked) {
    QStringList titles;
    for (const std::string& title : step.missing) {
      titles << toQString(Text(title));
    }
    return tr("Master first: %1").arg(titles.join(tr(", ", "between titles")));
  }
  if (step.state == StepState::kUsedUp) {
    return tr("Ask an administrator for another attempt.");
  }
  QStringList parts;
  for (const RuleProgress& progress : step.rules) {
    parts << rule(progress);
  }
  if (step.competence) {
    parts << tr("Level: %1. %2").arg(level(*step.competence), competenceErrors(*step.competence));
  }
  return parts.join(QLatin1Char('\n'));
}

QString StationLabels::rule(const RuleProgress& progress) {
  const QString threshold = quantity(progress.rule.metric, progress.rule.threshold);
  const QString name = metric(progress.rule.metric);
  const bool atMost = progress.rule.comparison == "at_most";
  const QString goal = isAnswerMetric(progress.rule.metric)
                           ? tr("%1: %2", "quantity and value").arg(name, threshold)
                       : atMost && progress.rule.threshold == 0.0 ? tr("%1: none").arg(name)
                       : atMost                                   ? tr("%1: at most %2").arg(name, threshold)
                                : tr("%1: at least %2").arg(name, threshold);
  if (progress.rule.consecutive <= 1) {
    return goal;
  }
  if (progress.met) {
    return tr("%1, in %n run(s) in a row", nullptr, static_cast<int>(progress.rule.consecutive)).arg(goal);
  }
  return tr("%1, in %n run(s) in a row (%2 so far)", nullptr, static_cast<int>(progress.rule.consecutive))
      .arg(goal)
      .arg(progress.streak);
}

QString StationLabels::result(const Attempt& attempt) {
  const auto value = [&attempt](const char* metric) {
    const auto found = attempt.values.find(metric);
    return found == attempt.values.end() ? std::optional<double>() : found->second;
  };
  const std::optional<double> done = value(kDetorsionDoneMetric);
  if (!done) {
    return attempt.values.empty() ? tr("not measured")
                                  : tr("%1 of %2").arg(attempt.onTarget).arg(attempt.twists);
  }
  const QString dose = quantity("detorse.dose", value("detorse.dose").value_or(0.0));
  if (*done == 0.0) {
    return tr("not untwisted, ischaemic dose %1").arg(dose);
  }
  const std::optional<double> flow_s = value("detorse.time_to_flow");
  constexpr double kAtOnce_s = 0.05;  // it flowed as the organ came
  return flow_s && *flow_s >= kAtOnce_s ? tr("untwisted, blood after %1, ischaemic dose %2")
                                              .arg(quantity("detorse.time_to_flow", *flow_s), dose)
                                        : tr("untwisted, ischaemic dose %1").arg(dose);
}

QString StationLabels::lastResult(const ModuleStep& step) {
  if (!step.last) {
    return tr("Not tried yet");
  }
  const Attempt& last = *step.last;
  if (last.interrupted) {
    return tr("Last time: interrupted after %1").arg(clockTenths(last.duration_s));
  }
  if (isUntwisting(last)) {
    return tr("Last time: %1").arg(result(last));
  }
  return tr("Last time: %1 of %n twist(s) on target", nullptr, static_cast<int>(last.twists))
      .arg(last.onTarget);
}

QString StationLabels::unlocks(const ModuleStep& step) {
  if (step.unlocks.empty()) {
    return {};
  }
  QStringList titles;
  for (const std::string& title : step.unlocks) {
    titles << toQString(Text(title));
  }
  return tr("Unlocks: %1").arg(titles.join(tr(", ", "between titles")));
}

QString StationLabels::check(const TargetCheck& check, std::size_t twists) {
  return toQString(checkText(check, twists));
}

QString StationLabels::earlier(const EarlierMeasure& earlier) {
  const QString force = quantity(kPeakForceMetric, earlier.peakForce_N.value_or(0.0));
  return earlier.withinLimits ? tr("Measured before by version %1 of the definitions: peak force %2, within "
                                   "the limits. That is kept and no longer counts.")
                                    .arg(earlier.version)
                                    .arg(force)
                              : tr("Measured before by version %1 of the definitions: peak force %2, beyond "
                                   "the limits. That is kept and no longer counts.")
                                    .arg(earlier.version)
                                    .arg(force);
}

QString StationLabels::finding(const DebriefFinding& finding, bool strength) {
  return toQString(findingText(finding, strength));
}

QString StationLabels::advice(const std::string& id) {
  return toQString(adviceText(id));
}

QString StationLabels::level(const CompetenceVerdict& verdict) {
  switch (verdict.level) {
    case SkillLevel::kNotShown:
      return tr("%n more attempt(s) until a level is shown", nullptr,
                static_cast<int>(verdict.attemptsUntilLevel));
    case SkillLevel::kLearning:
      return tr("Learning");
    case SkillLevel::kSteady:
      return tr("Steady");
    case SkillLevel::kWatch:
      return tr("Watch");
    case SkillLevel::kRelapsed:
      return tr("Relapsed");
  }
  return {};
}

QString StationLabels::levelMeaning(const CompetenceVerdict& verdict) {
  switch (verdict.level) {
    case SkillLevel::kNotShown:
      return tr("Too few attempts to show competence.");
    case SkillLevel::kLearning:
      return tr("Competence not shown yet. %n successful attempt(s) in a row would show it.", nullptr,
                static_cast<int>(fewestForAble(verdict.design)));
    case SkillLevel::kSteady:
      return tr("Competent, and stable.");
    case SkillLevel::kWatch:
      return tr("Previously competent; the latest attempts raise doubts.");
    case SkillLevel::kRelapsed:
      return tr("Previously competent, but not now. Practise until your level is steady again.");
  }
  return {};
}

QString StationLabels::competenceDesign(const CompetenceVerdict& verdict) {
  return toQString(competenceDesignText(verdict.design, verdict.untwisting));
}

QString StationLabels::competenceErrors(const CompetenceVerdict& verdict) {
  return toQString(competenceErrorText(verdict.design, verdict.errors));
}

QString StationLabels::readiness(const ReadinessFinding& finding) {
  if (finding.code == "connected") {
    return tr("Connected");
  }
  if (finding.code == "docked") {
    return tr("Stylus docked");
  }
  if (finding.code == "calibrated") {
    return tr("Calibrated");
  }
  if (finding.code == "force") {
    return tr("Force");
  }
  if (finding.code == "rate") {
    return tr("Update rate");
  }
  if (finding.code == "seat") {
    return tr("Hand and seat");
  }
  return toQString(finding.code);
}

QString StationLabels::light(Light light) {
  switch (light) {
    case Light::kGreen:
      return tr("Ready");
    case Light::kAmber:
      return tr("Practice only");
    case Light::kRed:
      return tr("Not ready");
  }
  return {};
}

}  // namespace torsio::gui
