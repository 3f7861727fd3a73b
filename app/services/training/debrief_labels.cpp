// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/training/debrief_labels.h"

#include <array>
#include <cstdio>

#include "assessment/metrics/metric_cards.h"
#include "sim/core/angle.h"
#include "sim/core/load_decimals.h"

namespace torsio {

namespace {

constexpr double kClearlyBetter = 0.15;  // of the logarithm: about a sixth

struct MetricLabels {
  const char* id;
  Phrase name;
  const char* unit;  ///< shown; empty: a mere number
  double scale;      ///< SI to shown
  int decimals;
};
constexpr std::array<MetricLabels, 39> kMetrics{{
    {"twist.on_target", Text::tr("Twists on target"), "%", 100.0, 0},
    {"twist.targets_reached", Text::tr("Targets reached"), "", 1.0, 0},
    {"time.total", Text::tr("Time of a twist"), "s", 1.0, 1},
    {"twist.time_to_target", Text::tr("Time to target"), "s", 1.0, 1},
    {"twist.settling", Text::tr("Settling time"), "s", 1.0, 1},
    {"twist.overshoot", Text::tr("Overshoot"), "\u00b0", kDegreesPerRadian, 1},
    {"twist.hold_steadiness", Text::tr("Steadiness of the hold"), "\u00b0", kDegreesPerRadian, 2},
    {"twist.sparc", Text::tr("Smoothness"), "", 1.0, 2},
    {"twist.ldlj", Text::tr("Smoothness (jerk)"), "", 1.0, 1},
    {"twist.economy", Text::tr("Economy of turning"), "%", 100.0, 0},
    {"twist.peaks", Text::tr("Sub-movements"), "", 1.0, 0},
    {"twist.path", Text::tr("Angular path"), "\u00b0", kDegreesPerRadian, 0},
    {"twist.rmse", Text::tr("Tracking error"), "\u00b0", kDegreesPerRadian, 1},
    {"twist.excursions", Text::tr("Excursions"), "", 1.0, 0},
    {"tip.path", Text::tr("Path of the tip"), "mm", 1000.0, 0},
    {"force.peak", Text::tr("Peak force"), "N", 1.0, kForceDecimals},
    {"force.device_peak", Text::tr("Peak force of the device"), "N", 1.0, kForceDecimals},
    {"force.mean", Text::tr("Mean force"), "N", 1.0, kForceDecimals},
    {"force.violations", Text::tr("Force violations"), "", 1.0, 0},
    {"torque.peak", Text::tr("Peak torque"), "N m", 1.0, kTorqueDecimals},
    {"torque.release_rate", Text::tr("Abruptness of release"), "N m/s", 1.0, kTorqueDecimals},
    {"detorse.done", Text::tr("Untwisted"), "", 1.0, 0},
    {"detorse.time_to_flow", Text::tr("Time until blood flows"), "s", 1.0, 1},
    {"detorse.dose", Text::tr("Ischaemic dose"), "", 1.0, 2},
    {"detorse.dose_at_flow", Text::tr("Ischaemic dose when blood flows"), "", 1.0, 2},
    {"detorse.residual", Text::tr("Twist that remains"), "\u00b0", kDegreesPerRadian, 0},
    {"detorse.relapse", Text::tr("Relapse"), "", 1.0, 0},
    {"detorse.first_direction", Text::tr("First turn the right way"), "", 1.0, 0},
    {"detorse.wrong_way", Text::tr("Turned the wrong way"), "\u00b0", kDegreesPerRadian, 0},
    {"detorse.regrips", Text::tr("Re-grips"), "", 1.0, 0},
    {"detorse.least_regrips", Text::tr("Least number of re-grips"), "", 1.0, 0},
    {"detorse.slip_back", Text::tr("Slipped back"), "\u00b0", kDegreesPerRadian, 0},
    {"detorse.peak_jaw", Text::tr("Peak pressure of the jaw"), "kPa", 1e-3, 0},
    {"detorse.peak_shear", Text::tr("Peak shear of the wall"), "kPa", 1e-3, 1},
    {"detorse.overload_time", Text::tr("Time of overload"), "s", 1.0, 1},
    {"detorse.min_patency", Text::tr("Least patency"), "%", 100.0, 0},
    {"detorse.vented_first", Text::tr("Let out first"), "", 1.0, 0},
    {"detorse.longest_stage", Text::tr("Longest turn without a rest"), "\u00b0", kDegreesPerRadian, 0},
    {"detorse.in_stages", Text::tr("Untwisted in stages"), "", 1.0, 0},
}};

const MetricLabels* wordsOf(const std::string& id) {
  for (const MetricLabels& words : kMetrics) {
    if (id == words.id) {
      return &words;
    }
  }
  return nullptr;
}

/// With the minus sign of print.
std::string figure(double value, int decimals) {
  std::array<char, 64> digits{};
  std::snprintf(digits.data(), digits.size(), "%.*f", decimals, value);
  const std::string text(digits.data());
  return text.front() == '-' ? "\u2212" + text.substr(1) : text;
}

/// The value of a limit: with further digits where it would look like the limit that it misses.
std::string beside(const TargetCheck& check, int decimals) {
  constexpr int kMaxDecimals = 6;
  const double value = check.value.value_or(0.0);
  while (!check.passed && decimals < kMaxDecimals &&
         figure(value, decimals) == figure(check.wanted, decimals)) {
    ++decimals;
  }
  return figure(value, decimals);
}

}  // namespace

Text metricName(const std::string& id) {
  const MetricLabels* words = wordsOf(id);
  return words != nullptr ? Text(words->name) : Text(metricTitle(id));
}

double metricScale(const std::string& id) {
  const MetricLabels* words = wordsOf(id);
  return words != nullptr ? words->scale : 1.0;
}

std::string metricUnit(const std::string& id) {
  const MetricLabels* words = wordsOf(id);
  return words != nullptr ? words->unit : "";
}

int metricDecimals(const std::string& id) {
  constexpr int kOfOthers = 2;
  const MetricLabels* words = wordsOf(id);
  return words != nullptr ? words->decimals : kOfOthers;
}

Text quantityText(const std::string& metric, double value) {
  if (isAnswerMetric(metric)) {
    return value > 0.5 ? Text::tr("yes") : Text::tr("no");
  }
  const MetricLabels* words = wordsOf(metric);
  if (words == nullptr) {
    return figure(value, metricDecimals(metric));
  }
  const std::string number = figure(value * words->scale, words->decimals);
  const std::string unit = words->unit;
  if (unit.empty() || unit == "\u00b0") {
    return number + unit;
  }
  return Text::tr("%1 %2", number, unit);
}

Text checkText(const TargetCheck& check, std::size_t twists) {
  switch (check.kind) {
    case TargetCheck::Kind::kUndone:
      return !check.value   ? Text::tr("Untwisted, open and supplied with hands off: not measured")
             : check.passed ? Text::tr("Untwisted, open and supplied with hands off: yes")
                            : Text::tr("Untwisted, open and supplied with hands off: no");
    case TargetCheck::Kind::kTwists:
      return check.value.value_or(0.0) > check.wanted
                 ? Text::tr("Twists completed: %1, at least %2 wanted", figure(check.value.value_or(0.0), 0),
                            figure(check.wanted, 0))
                 : Text::tr("Twists completed: %1 of %2", figure(check.value.value_or(0.0), 0),
                            figure(check.wanted, 0));
    case TargetCheck::Kind::kAngle:
      return Text::tr("Twists released on target: %1 of %2, wanted %3", figure(check.value.value_or(0.0), 0),
                      twists, figure(check.wanted, 0));
    case TargetCheck::Kind::kHold:
      return check.value ? Text::tr("Shortest hold on target: %1 s, wanted %2 s", figure(*check.value, 1),
                                    figure(check.wanted, 1))
                         : Text::tr("Hold on target: none, wanted %1 s", figure(check.wanted, 1));
    case TargetCheck::Kind::kForce:
      return check.value
                 ? Text::tr("Peak force on the tissue: %1 N, limit %2 N", beside(check, kForceDecimals),
                            figure(check.wanted, kForceDecimals))
                 : Text::tr("Peak force: not measured, limit %1 N", figure(check.wanted, kForceDecimals));
    case TargetCheck::Kind::kTorque:
      return check.value
                 ? Text::tr("Peak torque: %1 N m, limit %2 N m", beside(check, kTorqueDecimals),
                            figure(check.wanted, kTorqueDecimals))
                 : Text::tr("Peak torque: not measured, limit %1 N m", figure(check.wanted, kTorqueDecimals));
    case TargetCheck::Kind::kMastery:
      break;
  }
  const Text name = metricName(check.metric);
  const Text wanted = quantityText(check.metric, check.wanted);
  const Text value = check.value ? quantityText(check.metric, *check.value) : Text(Text::tr("not measured"));
  const Text sentence = isAnswerMetric(check.metric) ? Text::tr("%1: %2, wanted %3", name, value, wanted)
                        : check.atLeast              ? Text::tr("%1: %2, at least %3", name, value, wanted)
                                                     : Text::tr("%1: %2, at most %3", name, value, wanted);
  if (check.consecutive <= 1) {
    return sentence;
  }
  return Text::tr("%1 (%2 in a row, %3 needed)", sentence, check.streak, check.consecutive);
}

Text findingText(const DebriefFinding& finding, bool strength) {
  // The peak of the run stands in its check; there is one of that name on the page.
  const Text name = finding.metric == kPeakForceMetric ? Text(Text::tr("Peak force of one twist"))
                                                       : metricName(finding.metric);
  const Text own = quantityText(finding.metric, finding.value);
  const Text expert = quantityText(finding.metric, finding.expert);
  if (strength && finding.merit > kClearlyBetter) {
    return Text::tr("%1: %2, better than the expert (%3)", name, own, expert);
  }
  if (strength && finding.merit >= 0.0) {
    return Text::tr("%1: %2, as good as the expert (%3)", name, own, expert);
  }
  if (strength && finding.merit >= -kClearlyBetter) {
    return Text::tr("%1: %2, close to the expert (%3)", name, own, expert);
  }
  if (strength) {
    return Text::tr("%1: %2, what came nearest to the expert (%3)", name, own, expert);
  }
  return Text::tr("%1: %2, the expert had %3", name, own, expert);
}

Text adviceText(const std::string& id) {
  if (id == "twist.time_to_target") {
    return Text::tr("Turn in one decided movement instead of feeling your way.");
  }
  if (id == "twist.settling") {
    return Text::tr("Slow down before the target, then stay.");
  }
  if (id == "twist.overshoot") {
    return Text::tr("Begin to slow down ten degrees before the target.");
  }
  if (id == "twist.hold_steadiness") {
    return Text::tr("Rest your forearm while you hold.");
  }
  if (id == "twist.sparc") {
    return Text::tr("Let speed rise and fall once, without stops.");
  }
  if (id == "twist.economy") {
    return Text::tr("Avoid turning back and forth.");
  }
  if (id == "twist.peaks") {
    return Text::tr("One push instead of many small ones.");
  }
  if (id == "force.peak") {
    return Text::tr("Press less while you turn; the grip holds the tissue.");
  }
  if (id == "torque.release_rate") {
    return Text::tr("Turn back a little before you open the jaw.");
  }
  return {};
}

}  // namespace torsio
