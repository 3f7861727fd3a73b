// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/domain/rating/instrument.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "sim/core/error.h"
#include "sim/core/plausible.h"
#include "sim/core/short_number.h"

namespace torsio {

namespace {

constexpr std::int64_t kMaxSteps = 1'000'000;
constexpr double kWeightTolerance = 1e-12;  // of the sum, when weights are given as doubles

std::string pointsText(std::int64_t steps, const ScoreScale& scale) {
  const bool negative = steps < 0;
  const std::int64_t magnitude = negative ? -steps : steps;
  std::string text = (negative ? "-" : "") + std::to_string(magnitude / scale.stepsPerPoint);
  const std::int64_t rest = magnitude % scale.stepsPerPoint;
  if (rest != 0) {
    text += "+" + std::to_string(rest) + "/" + std::to_string(scale.stepsPerPoint);
  }
  return text;
}

std::string rangeText(const ScoreScale& scale) {
  return pointsText(scale.lo, scale) + " to " + pointsText(scale.hi, scale) + " in steps of 1/" +
         std::to_string(scale.stepsPerPoint);
}

[[noreturn]] void refuseScore(const std::string& value, const Text& why, const ScoreScale& scale,
                              const std::string& where) {
  refuse(Text::verbatim("score \"%1\" %2", value, why), where,
         Text::verbatim("Give a score from %1.", rangeText(scale)));
}

std::int64_t checkedSteps(std::int64_t steps, const std::string& text, const ScoreScale& scale,
                          const std::string& where) {
  if (!isOnScale(steps, scale)) {
    refuseScore(text, Text::verbatim("is outside the scale"), scale, where);
  }
  return steps;
}

/// A value as numerator / 10^decimals; empty unless the text is [+-]digits[.digits].
struct Decimal {
  std::int64_t numerator = 0;
  std::int64_t denominator = 1;
};

std::optional<Decimal> parseDecimal(std::string_view text) {
  bool negative = false;
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) {
    negative = text.front() == '-';
    text.remove_prefix(1);
  }
  Decimal value;
  bool digits = false;
  bool point = false;
  for (const char c : text) {
    if (c == '.' && !point) {
      point = true;
      continue;
    }
    if (c < '0' || c > '9') {
      return std::nullopt;
    }
    digits = true;
    if (value.numerator > std::numeric_limits<std::int64_t>::max() / 100 ||
        value.denominator > 1'000'000'000'000) {
      return std::nullopt;
    }
    value.numerator = value.numerator * 10 + (c - '0');
    if (point) {
      value.denominator *= 10;
    }
  }
  if (!digits) {
    return std::nullopt;
  }
  if (negative) {
    value.numerator = -value.numerator;
  }
  return value;
}

void checkWeights(const std::vector<std::int64_t>& weights, const std::string& of) {
  std::int64_t sum = 0;
  for (const std::int64_t weight : weights) {
    if (weight < 0) {
      refuseParameter(Text::verbatim("a weight of the %1 is negative", of), of,
                      Text::verbatim("Give weights of 0 or more."));
    }
    sum += weight;
  }
  if (sum != kWeightSum_milli) {
    refuseParameter(Text::verbatim("the weights of the %1 sum to %2/1000 instead of 1", of, sum), of,
                    Text::verbatim("Correct the weights; they are never rescaled silently."));
  }
}

}  // namespace

void validateScale(const ScoreScale& scale) {
  const bool sound = scale.lo < scale.hi && scale.stepsPerPoint >= 1 && scale.stepsPerPoint <= 1000 &&
                     scale.lo >= -kMaxSteps && scale.hi <= kMaxSteps;
  if (!sound) {
    refuseParameter(Text::tr("the scale of the scores is not usable"), Text::tr("scale"),
                    Text::tr("Give a lowest mark below the highest, and 1 to 1000 steps a point"));
  }
}

std::int64_t stepsFromText(std::string_view text, const ScoreScale& scale, const std::string& where) {
  const std::string shown(text);
  const std::optional<Decimal> value = parseDecimal(text);
  if (!value) {
    refuseScore(shown, Text::verbatim("is not a decimal number with a point"), scale, where);
  }
  // Beyond any scale, and the multiplication below could overflow.
  if (value->numerator / value->denominator > kMaxSteps ||
      value->numerator / value->denominator < -kMaxSteps) {
    refuseScore(shown, Text::verbatim("is outside the scale"), scale, where);
  }
  const std::int64_t whole = value->numerator / value->denominator;
  const std::int64_t rest = value->numerator % value->denominator;
  if ((rest * scale.stepsPerPoint) % value->denominator != 0) {
    if (value->numerator > 0 && whole * scale.stepsPerPoint >= scale.hi) {
      refuseScore(shown, Text::verbatim("is outside the scale"), scale, where);
    }
    refuseScore(shown, Text::verbatim("lies between two steps of the scale"), scale, where);
  }
  const std::int64_t steps = whole * scale.stepsPerPoint + rest * scale.stepsPerPoint / value->denominator;
  return checkedSteps(steps, shown, scale, where);
}

std::int64_t stepsFromPoints(double points, const ScoreScale& scale, const std::string& where) {
  const std::string shown = std::to_string(points);
  if (!std::isfinite(points)) {
    refuseScore(shown, Text::verbatim("is not a finite number"), scale, where);
  }
  const double scaled = points * static_cast<double>(scale.stepsPerPoint);
  if (std::abs(scaled) > static_cast<double>(2 * kMaxSteps)) {
    refuseScore(shown, Text::verbatim("is outside the scale"), scale, where);
  }
  const std::int64_t steps = static_cast<std::int64_t>(std::llround(scaled));
  if (pointsFromSteps(steps, scale) != points) {
    refuseScore(shown, Text::verbatim("lies between two steps of the scale"), scale, where);
  }
  return checkedSteps(steps, shown, scale, where);
}

void requireScaleUsed(std::span<const std::int64_t> steps, const ScoreScale& scale, const std::string& where,
                      const Text& remedy) {
  constexpr std::size_t kFewest = 10;
  if (steps.size() < kFewest) {
    return;
  }
  const auto [least, most] = std::minmax_element(steps.begin(), steps.end());
  const double used = static_cast<double>(*most - scale.lo) / static_cast<double>(scale.hi - scale.lo);
  if (*least == *most || isPlausible(Stated::kScaleUsed, used)) {
    return;
  }
  const auto points = [&scale](std::int64_t step) {
    return shortNumber(static_cast<double>(step) / static_cast<double>(scale.stepsPerPoint));
  };
  refuse(
      Text::tr("the highest of %1 scores is %2 on a scale from %3 to %4: they seem to be on a smaller scale",
               steps.size(), points(*most), points(scale.lo), points(scale.hi)),
      where, remedy);
}

void validateInstrument(const EvaluationInstrument& instrument) {
  validateScale(instrument.scale);
  if (instrument.classes.empty() || instrument.indices.empty()) {
    refuseParameter(Text::verbatim("the instrument has no rater class or no index"),
                    Text::verbatim("instrument"), Text::verbatim("Define at least one of each."));
  }
  std::set<std::string> names;
  std::vector<std::int64_t> classWeights;
  for (const RaterClass& raterClass : instrument.classes) {
    if (!names.insert(raterClass.id).second) {
      refuseParameter(Text::verbatim("two rater classes are called \"%1\"", raterClass.id),
                      Text::verbatim("classes"), Text::verbatim("Give each class its own identifier."));
    }
    classWeights.push_back(raterClass.weight_milli);
  }
  names.clear();
  std::vector<std::int64_t> indexWeights;
  for (const EvaluationIndex& index : instrument.indices) {
    if (!names.insert(index.id).second) {
      refuseParameter(Text::verbatim("two indices are called \"%1\"", index.id), Text::verbatim("indices"),
                      Text::verbatim("Give each index its own identifier."));
    }
    indexWeights.push_back(index.weight_milli);
  }
  checkWeights(classWeights, "rater classes");
  checkWeights(indexWeights, "indices");
}

std::vector<std::int64_t> weightsInMilli(const std::vector<double>& weights) {
  std::vector<std::int64_t> milli;
  double sum = 0.0;
  for (const double weight : weights) {
    if (!std::isfinite(weight) || weight < 0.0 || weight > 1.0) {
      refuseParameter(Text::verbatim("weight %1 is not between 0 and 1", std::to_string(weight)),
                      Text::verbatim("weights"), Text::verbatim("Give weights from 0 to 1 that sum to 1."));
    }
    sum += weight;
    const std::int64_t rounded = static_cast<std::int64_t>(std::llround(weight * 1000.0));
    if (std::abs(weight - static_cast<double>(rounded) / 1000.0) > kWeightTolerance) {
      refuseParameter(Text::verbatim("weight %1 is not a multiple of 0.001", std::to_string(weight)),
                      Text::verbatim("weights"),
                      Text::verbatim("Round the weights to thousandths so that they sum to 1."));
    }
    milli.push_back(rounded);
  }
  if (std::abs(sum - 1.0) > kWeightTolerance) {
    refuseParameter(Text::verbatim("the weights sum to %1 instead of 1", std::to_string(sum)),
                    Text::verbatim("weights"),
                    Text::verbatim("Correct the weights; they are never rescaled silently."));
  }
  return milli;
}

EvaluationInstrument paperInstrument() {
  EvaluationInstrument instrument;
  instrument.classes = {
      {"A", "interns", 200}, {"B", "deputy chief physicians", 300}, {"C", "chief physicians", 500}};
  instrument.indices = {{"effectiveness", "Effectiveness", 150},
                        {"force_feedback", "Force feedback", 150},
                        {"real_time", "Real-time performance", 150},
                        {"stability", "System stability", 150},
                        {"deformation_efficiency", "Deformation efficiency", 100},
                        {"fidelity", "Fidelity", 100},
                        {"fluency", "Image fluency", 100},
                        {"telepresence", "Telepresence", 50},
                        {"texture", "Texture", 50}};
  return instrument;
}

std::optional<IndexMeaning> indexMeaning(std::string_view indexId) {
  if (indexId == "effectiveness") {
    return IndexMeaning{Text::tr("How well practising with this model prepares for twisting a real organ."),
                        Text::tr("teaches nothing or wrong habits"), Text::tr("useful beside other training"),
                        Text::tr("prepares as well as the real thing")};
  }
  if (indexId == "force_feedback") {
    return IndexMeaning{
        Text::tr("How far the force in the hand is what tissue would answer, in size and course."),
        Text::tr("no force, or one that misleads"), Text::tr("right in direction, not in size"),
        Text::tr("feels like tissue")};
  }
  if (indexId == "real_time") {
    return IndexMeaning{Text::tr("How promptly picture and force follow the hand."),
                        Text::tr("clearly behind the hand"), Text::tr("a delay that can be noticed"),
                        Text::tr("no delay to be noticed")};
  }
  if (indexId == "stability") {
    return IndexMeaning{Text::tr("Whether organ and force stay calm through grip, twist, hold and release."),
                        Text::tr("shakes, jumps or breaks off"), Text::tr("calm but for single moments"),
                        Text::tr("calm throughout")};
  }
  if (indexId == "deformation_efficiency") {
    return IndexMeaning{Text::tr("How quickly the shape of the organ follows a large or fast twist."),
                        Text::tr("the shape lags or stands still"), Text::tr("keeps up with slow twists"),
                        Text::tr("keeps up with every twist")};
  }
  if (indexId == "fidelity") {
    return IndexMeaning{Text::tr("How true the twisted shape is: where it turns, folds and gives way."),
                        Text::tr("no organ twists like that"), Text::tr("right as a whole, wrong in places"),
                        Text::tr("like the organ itself")};
  }
  if (indexId == "fluency") {
    return IndexMeaning{Text::tr("How evenly the picture moves."), Text::tr("stops and jumps"),
                        Text::tr("stutters now and then"), Text::tr("even throughout")};
  }
  if (indexId == "telepresence") {
    return IndexMeaning{Text::tr("How far one forgets the device and works on the organ itself."),
                        Text::tr("one steers a device"), Text::tr("at times one works on the organ"),
                        Text::tr("one works on the organ")};
  }
  if (indexId == "texture") {
    return IndexMeaning{
        Text::tr("How much the surface looks like living tissue: colour, gloss, grain, vessels."),
        Text::tr("like plastic"), Text::tr("tissue at a glance"), Text::tr("like living tissue")};
  }
  return std::nullopt;
}

}  // namespace torsio
