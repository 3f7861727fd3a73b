// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trainee/trainee_labels.h"

#include <array>
#include <cmath>
#include <optional>

#include <QDateTime>
#include <QLocale>
#include <QStringList>

#include "app/gui/base/clock_time.h"
#include "app/gui/base/translated_text.h"
#include "app/recording/competence_text.h"
#include "assessment/metrics/metric_cards.h"
#include "sim/base/angle.h"

namespace torsio::gui {

namespace {

constexpr double kClearlyBetter = 0.15;  // of the logarithm: about a sixth

struct MetricLabels {
  const char* id;
  const char* name;
  const char* unit;  ///< shown; empty: a mere number
  double scale;      ///< SI to shown
  int decimals;
};
constexpr std::array<MetricLabels, 39> kMetrics{{
    {"twist.on_target", QT_TRANSLATE_NOOP("StationLabels", "Twists on target"), "%", 100.0, 0},
    {"twist.targets_reached", QT_TRANSLATE_NOOP("StationLabels", "Targets reached"), "", 1.0, 0},
    {"time.total", QT_TRANSLATE_NOOP("StationLabels", "Time of a twist"), "s", 1.0, 1},
    {"twist.time_to_target", QT_TRANSLATE_NOOP("StationLabels", "Time to target"), "s", 1.0, 1},
    {"twist.settling", QT_TRANSLATE_NOOP("StationLabels", "Settling time"), "s", 1.0, 1},
    {"twist.overshoot", QT_TRANSLATE_NOOP("StationLabels", "Overshoot"), "\u00b0", kDegreesPerRadian, 1},
    {"twist.hold_steadiness", QT_TRANSLATE_NOOP("StationLabels", "Steadiness of the hold"), "\u00b0",
     kDegreesPerRadian, 2},
    {"twist.sparc", QT_TRANSLATE_NOOP("StationLabels", "Smoothness"), "", 1.0, 2},
    {"twist.ldlj", QT_TRANSLATE_NOOP("StationLabels", "Smoothness (jerk)"), "", 1.0, 1},
    {"twist.economy", QT_TRANSLATE_NOOP("StationLabels", "Economy of turning"), "%", 100.0, 0},
    {"twist.peaks", QT_TRANSLATE_NOOP("StationLabels", "Sub-movements"), "", 1.0, 0},
    {"twist.path", QT_TRANSLATE_NOOP("StationLabels", "Angular path"), "\u00b0", kDegreesPerRadian, 0},
    {"twist.rmse", QT_TRANSLATE_NOOP("StationLabels", "Tracking error"), "\u00b0", kDegreesPerRadian, 1},
    {"twist.excursions", QT_TRANSLATE_NOOP("StationLabels", "Excursions"), "", 1.0, 0},
    {"tip.path", QT_TRANSLATE_NOOP("StationLabels", "Path of the tip"), "mm", 1000.0, 0},
    {"force.peak", QT_TRANSLATE_NOOP("StationLabels", "Peak force"), "N", 1.0, 2},
    {"force.device_peak", QT_TRANSLATE_NOOP("StationLabels", "Peak force of the device"), "N", 1.0, 2},
    {"force.mean", QT_TRANSLATE_NOOP("StationLabels", "Mean force"), "N", 1.0, 2},
    {"force.violations", QT_TRANSLATE_NOOP("StationLabels", "Force violations"), "", 1.0, 0},
    {"torque.peak", QT_TRANSLATE_NOOP("StationLabels", "Peak torque"), "N m", 1.0, 3},
    {"torque.release_rate", QT_TRANSLATE_NOOP("StationLabels", "Abruptness of release"), "N m/s", 1.0, 2},
    {"detorse.done", QT_TRANSLATE_NOOP("StationLabels", "Undone"), "", 1.0, 0},
    {"detorse.time_to_flow", QT_TRANSLATE_NOOP("StationLabels", "Time until blood flows"), "s", 1.0, 1},
    {"detorse.dose", QT_TRANSLATE_NOOP("StationLabels", "Ischaemic dose"), "", 1.0, 2},
    {"detorse.dose_at_flow", QT_TRANSLATE_NOOP("StationLabels", "Ischaemic dose when blood flows"), "", 1.0,
     2},
    {"detorse.residual", QT_TRANSLATE_NOOP("StationLabels", "Twist that remains"), "\u00b0",
     kDegreesPerRadian, 0},
    {"detorse.relapse", QT_TRANSLATE_NOOP("StationLabels", "Relapse"), "", 1.0, 0},
    {"detorse.first_direction", QT_TRANSLATE_NOOP("StationLabels", "First turn the right way"), "", 1.0, 0},
    {"detorse.wrong_way", QT_TRANSLATE_NOOP("StationLabels", "Turned the wrong way"), "\u00b0",
     kDegreesPerRadian, 0},
    {"detorse.regrips", QT_TRANSLATE_NOOP("StationLabels", "Re-grips"), "", 1.0, 0},
    {"detorse.least_regrips", QT_TRANSLATE_NOOP("StationLabels", "Least number of re-grips"), "", 1.0, 0},
    {"detorse.slip_back", QT_TRANSLATE_NOOP("StationLabels", "Slipped back"), "\u00b0", kDegreesPerRadian, 0},
    {"detorse.peak_jaw", QT_TRANSLATE_NOOP("StationLabels", "Peak pressure of the jaw"), "kPa", 1e-3, 0},
    {"detorse.peak_shear", QT_TRANSLATE_NOOP("StationLabels", "Peak shear of the wall"), "kPa", 1e-3, 1},
    {"detorse.overload_time", QT_TRANSLATE_NOOP("StationLabels", "Time of overload"), "s", 1.0, 1},
    {"detorse.min_patency", QT_TRANSLATE_NOOP("StationLabels", "Least patency"), "%", 100.0, 0},
    {"detorse.vented_first", QT_TRANSLATE_NOOP("StationLabels", "Let out first"), "", 1.0, 0},
    {"detorse.longest_stage", QT_TRANSLATE_NOOP("StationLabels", "Longest turn without a rest"), "\u00b0",
     kDegreesPerRadian, 0},
    {"detorse.in_stages", QT_TRANSLATE_NOOP("StationLabels", "Undone in stages"), "", 1.0, 0},
}};

const MetricLabels* wordsOf(const std::string& id) {
  for (const MetricLabels& words : kMetrics) {
    if (id == words.id) {
      return &words;
    }
  }
  return nullptr;
}

QString number(double value, int decimals) {
  QString text = QLocale().toString(value, 'f', decimals);
  return text.replace(QLatin1Char('-'), QChar(0x2212));
}

/// The value of a limit: with further digits where it would look like the limit that it misses.
QString beside(const TargetCheck& check, int decimals) {
  constexpr int kMostDecimals = 6;
  const double value = check.value.value_or(0.0);
  while (!check.passed && decimals < kMostDecimals &&
         number(value, decimals) == number(check.wanted, decimals)) {
    ++decimals;
  }
  return number(value, decimals);
}

}  // namespace

QString StationLabels::metric(const std::string& id) {
  const MetricLabels* words = wordsOf(id);
  return words != nullptr ? tr(words->name) : toQString(metricTitle(id));
}

double StationLabels::inDisplayUnit(const std::string& metric, double value) {
  const MetricLabels* words = wordsOf(metric);
  return words != nullptr ? value * words->scale : value;
}

QString StationLabels::unitOf(const std::string& metric) {
  const MetricLabels* words = wordsOf(metric);
  return words != nullptr ? QString::fromUtf8(words->unit) : QString();
}

QString StationLabels::without(const std::string& metric) {
  return metric == "detorse.time_to_flow" || metric == "detorse.dose_at_flow" ? tr("blood did not come back")
                                                                              : tr("not defined");
}

QString StationLabels::quantity(const std::string& metric, double value) {
  if (isAnswerMetric(metric)) {
    return value > 0.5 ? tr("yes") : tr("no");
  }
  const MetricLabels* words = wordsOf(metric);
  if (words == nullptr) {
    return number(value, 2);
  }
  const QString figure = number(value * words->scale, words->decimals);
  const QString unit = QString::fromUtf8(words->unit);
  if (unit.isEmpty()) {
    return figure;
  }
  return unit == QStringLiteral("\u00b0") ? figure + unit : tr("%1 %2", "value and unit").arg(figure, unit);
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

QString StationLabels::when(std::int64_t utc_us) {
  return QLocale().toString(QDateTime::fromMSecsSinceEpoch(utc_us / 1000), QLocale::ShortFormat);
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
    return tr("First master: %1").arg(titles.join(tr(", ", "between titles")));
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
    return tr("not undone, ischaemic dose %1").arg(dose);
  }
  const std::optional<double> flow_s = value("detorse.time_to_flow");
  constexpr double kAtOnce_s = 0.05;  // it flowed as the organ came
  return flow_s && *flow_s >= kAtOnce_s ? tr("undone, blood after %1, ischaemic dose %2")
                                              .arg(quantity("detorse.time_to_flow", *flow_s), dose)
                                        : tr("undone, ischaemic dose %1").arg(dose);
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
  switch (check.kind) {
    case TargetCheck::Kind::kUndone:
      return !check.value   ? tr("Undone, open and supplied with hands off: not measured")
             : check.passed ? tr("Undone, open and supplied with hands off: yes")
                            : tr("Undone, open and supplied with hands off: no");
    case TargetCheck::Kind::kTwists:
      return (check.value.value_or(0.0) > check.wanted ? tr("Twists completed: %1, at least %2 wanted")
                                                       : tr("Twists completed: %1 of %2"))
          .arg(check.value.value_or(0.0), 0, 'f', 0)
          .arg(check.wanted, 0, 'f', 0);
    case TargetCheck::Kind::kAngle:
      return tr("Twists released on target: %1 of %2, wanted %3")
          .arg(check.value.value_or(0.0), 0, 'f', 0)
          .arg(twists)
          .arg(check.wanted, 0, 'f', 0);
    case TargetCheck::Kind::kHold:
      return check.value ? tr("Shortest hold on target: %1 s, wanted %2 s")
                               .arg(*check.value, 0, 'f', 1)
                               .arg(check.wanted, 0, 'f', 1)
                         : tr("Hold on target: none, wanted %1 s").arg(check.wanted, 0, 'f', 1);
    case TargetCheck::Kind::kForce:
      return check.value ? tr("Peak force on the tissue: %1 N, limit %2 N")
                               .arg(beside(check, 2), number(check.wanted, 2))
                         : tr("Peak force: not measured, limit %1 N").arg(check.wanted, 0, 'f', 2);
    case TargetCheck::Kind::kTorque:
      return check.value
                 ? tr("Peak torque: %1 N m, limit %2 N m").arg(beside(check, 3), number(check.wanted, 3))
                 : tr("Peak torque: not measured, limit %1 N m").arg(check.wanted, 0, 'f', 3);
    case TargetCheck::Kind::kMastery:
      break;
  }
  const QString name = metric(check.metric);
  const QString wanted = quantity(check.metric, check.wanted);
  const QString value = check.value ? quantity(check.metric, *check.value) : tr("not measured");
  const QString sentence = isAnswerMetric(check.metric) ? tr("%1: %2, wanted %3").arg(name, value, wanted)
                           : check.atLeast              ? tr("%1: %2, at least %3").arg(name, value, wanted)
                                                        : tr("%1: %2, at most %3").arg(name, value, wanted);
  if (check.consecutive <= 1) {
    return sentence;
  }
  return tr("%1 (%2 in a row, %3 needed)").arg(sentence).arg(check.streak).arg(check.consecutive);
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
  // The peak of the run stands in its check; there is one of that name on the page.
  const QString name =
      finding.metric == kPeakForceMetric ? tr("Peak force of one twist") : metric(finding.metric);
  const QString own = quantity(finding.metric, finding.value);
  const QString expert = quantity(finding.metric, finding.expert);
  if (strength && finding.merit > kClearlyBetter) {
    return tr("%1: %2, better than the expert (%3)").arg(name, own, expert);
  }
  if (strength && finding.merit >= 0.0) {
    return tr("%1: %2, as good as the expert (%3)").arg(name, own, expert);
  }
  if (strength) {
    return tr("%1: %2, close to the expert (%3)").arg(name, own, expert);
  }
  return tr("%1: %2, the expert had %3").arg(name, own, expert);
}

QString StationLabels::advice(const std::string& id) {
  if (id == "twist.time_to_target") {
    return tr("Turn in one decided movement instead of feeling your way.");
  }
  if (id == "twist.settling") {
    return tr("Slow down before the target, then stay.");
  }
  if (id == "twist.overshoot") {
    return tr("Begin to slow down ten degrees before the target.");
  }
  if (id == "twist.hold_steadiness") {
    return tr("Rest your forearm while you hold.");
  }
  if (id == "twist.sparc") {
    return tr("Let speed rise and fall once, without stops.");
  }
  if (id == "twist.economy") {
    return tr("Avoid turning back and forth.");
  }
  if (id == "twist.peaks") {
    return tr("One push instead of many small ones.");
  }
  if (id == "force.peak") {
    return tr("Press less while you turn; the grip holds the tissue.");
  }
  if (id == "torque.release_rate") {
    return tr("Turn back a little before you open the jaw.");
  }
  return {};
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
      return tr("So few attempts can show nobody to be able.");
    case SkillLevel::kLearning:
      return tr("Not yet shown to be able. %n good attempt(s) in a row show it.", nullptr,
                static_cast<int>(fewestForAble(verdict.design)));
    case SkillLevel::kSteady:
      return tr("Able, and staying so.");
    case SkillLevel::kWatch:
      return tr("Able before; the last attempts raise a doubt.");
    case SkillLevel::kRelapsed:
      return tr("Able before, not now. Practise until the level is steady again.");
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
