// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/recording/competence_text.h"

#include "assessment/catalogue/quantity.h"
#include "assessment/results/number_format.h"
#include "sim/core/angle.h"

namespace torsio {

std::string percentText(double share) {
  constexpr double kLeast = 0.0005;
  const std::string number = share < kLeast ? "<\u00A00.1" : formatFixed(100.0 * share, 1);
  return number + "\u00A0%";  // a no-break space before the sign
}

namespace {

/// Describes a success: "a twist released within 10.0 degrees (tolerance of the exercise), with a force of at
/// most 3.30 N, in a run that was finished".
Text successText(const CompetenceRule& rule) {
  const CompetenceDesign& design = rule.design;
  Text success = rule.untwisting
                     ? Text(Text::tr("an untwisting that passes"))
                     : Text::tr("a twist released within %1 {degree|degrees} (tolerance %2)",
                                formatFixed(degrees(design.tolerance_rad), 1), Text(labelOf(design.source)));
  if (rule.forceLimit_N) {
    success = Text::tr("%1, with a force of at most %2", success,
                       shownValue(Quantity::kPeakForce, *rule.forceLimit_N));
  }
  if (rule.torqueLimit_Nm) {
    success = Text::tr("%1, with a torque of at most %2", success,
                       shownValue(Quantity::kPeakTorque, *rule.torqueLimit_Nm));
  }
  return Text::tr("%1, in a run that was finished", success);
}

}  // namespace

Text competenceRuleText(const CompetenceRule& rule) {
  const CompetenceDesign& design = rule.design;
  const Text which =
      design.version > 0
          ? Text::tr("Competence design, version %1", design.version)
          : Text::tr(
                "Competence design shipped with the exercise (none was registered before the first attempt)");
  return Text::tr(
      "%1: success is %2; competent once the LC-CUSUM of failure rates %3 against %4 reaches %5, planned for "
      "%6 "
      "{attempt|attempts}.",
      which, successText(rule), percentText(design.adequate), percentText(design.inadequate),
      formatFixed(design.limit, 2), design.attempts);
}

Text competenceErrorText(const CompetenceDesign& design, const CompetenceErrors& errors) {
  return Text::tr(
      "Within %1 {attempt|attempts}, %2 of trainees who fail %3 of their attempts are judged competent "
      "(false "
      "pass), and %4 of those who fail only %5 are not (false fail); another %6 lose it through a false "
      "alarm.",
      errors.attempts, percentText(errors.falsePass), percentText(design.inadequate),
      percentText(errors.falseFail), percentText(design.adequate), percentText(errors.falseAlarm));
}

Text competenceLevelText(const CompetenceVerdict& verdict) {
  switch (verdict.level) {
    case SkillLevel::kNotShown:
      return Text::tr("not shown yet, %1 {attempt|attempts} missing", verdict.attemptsUntilLevel);
    case SkillLevel::kLearning:
      return Text::tr("learning");
    case SkillLevel::kSteady:
      return Text::tr("competent since attempt %1", verdict.ableAt.value_or(0));
    case SkillLevel::kWatch:
      return Text::tr("competent since attempt %1; the last attempts raise a doubt",
                      verdict.ableAt.value_or(0));
    case SkillLevel::kRelapsed:
      return Text::tr("competent at attempt %1, no longer so", verdict.ableAt.value_or(0));
  }
  return {};
}

}  // namespace torsio
