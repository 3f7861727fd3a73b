// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/scoring/demonstration_marks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/core/contracts.h"
#include "sim/core/random.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

constexpr std::size_t kGroups = 3;
constexpr std::size_t kOccasions = 3;

// The pattern that the paper describes in words: equal before training; groups 1 and 2 slightly above group 3
// after 20 min; group 2 clearly best after 40 min, group 1 slightly above group 3.
constexpr double kBaseline = 3.2;
constexpr std::array<std::array<double, kOccasions>, kGroups> kGain = {
    {{0.0, 1.7, 2.7}, {0.0, 1.7, 4.1}, {0.0, 1.3, 2.3}}};
constexpr double kTalentSpread = 0.8;
constexpr double kSeveritySpread = 0.4;
constexpr double kMarkSpread = 0.5;

constexpr std::size_t kIndices = 9;
// Rows PM, FEM, MSM; columns in the order of the paper's nine indices.
constexpr std::array<std::array<double, kIndices>, 3> kQuality = {
    {{8.6, 8.3, 8.8, 8.5, 8.2, 8.3, 8.4, 8.2, 8.0},
     {7.6, 7.4, 6.2, 7.2, 6.6, 7.9, 6.8, 7.3, 7.1},
     {6.6, 6.3, 7.5, 6.5, 7.0, 5.9, 7.2, 6.2, 6.1}}};
constexpr std::array<double, 3> kClassShift = {-0.3, 0.0, 0.2};
constexpr double kJudgeSpread = 0.5;
constexpr double kJudgementSpread = 0.7;

// Independent streams of one seed, so that changing the number of people does not change everybody's marks.
enum Stream : std::uint64_t { kTalent = 1, kSeverity, kNoise, kJudge, kJudgement };

std::vector<double> centredNormals(Random& random, std::size_t count, double spread) {
  std::vector<double> values;
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    values.push_back(spread * random.normal());
    sum += values.back();
  }
  for (double& value : values) {
    value -= sum / static_cast<double>(count);
  }
  return values;
}

/// Rounds to the nearest whole point within the scale; returns steps.
std::int64_t wholePoint(double points, const ScoreScale& scale) {
  const std::int64_t q = scale.stepsPerPoint;
  const auto nearest = static_cast<std::int64_t>(std::floor(points + 0.5));
  const std::int64_t low = (scale.lo + q - 1) / q;
  return std::clamp(nearest, low, scale.hi / q) * q;
}

std::string decimal(double value) {
  const auto tenths = static_cast<std::int64_t>(std::floor(value * 10.0 + 0.5));
  std::string text = std::to_string(tenths / 10);
  text += '.';
  text += std::to_string(tenths % 10);
  return text;
}

}  // namespace

std::vector<TrainingMark> demonstrationTrainingMarks(const ScoreScale& scale,
                                                     const DemonstrationPeople& people, std::uint64_t seed) {
  validateScale(scale);
  TORSIO_EXPECTS(people.groups.size() == kGroups);
  TORSIO_EXPECTS(!people.raters.empty());
  Random talents = Random::forStream(seed, kTalent);
  Random severities = Random::forStream(seed, kSeverity);
  Random noise = Random::forStream(seed, kNoise);
  std::vector<std::vector<double>> talent;
  for (const std::vector<std::string>& group : people.groups) {
    talent.push_back(centredNormals(talents, group.size(), kTalentSpread));
  }
  const std::vector<double> severity = centredNormals(severities, people.raters.size(), kSeveritySpread);
  std::vector<TrainingMark> marks;
  for (std::size_t t = 0; t < kOccasions; ++t) {
    for (std::size_t g = 0; g < kGroups; ++g) {
      for (std::size_t i = 0; i < people.groups[g].size(); ++i) {
        for (std::size_t r = 0; r < people.raters.size(); ++r) {
          const double points =
              kBaseline + kGain[g][t] + talent[g][i] - severity[r] + kMarkSpread * noise.normal();
          marks.push_back({people.groups[g][i], g, t, people.raters[r], wholePoint(points, scale)});
        }
      }
    }
  }
  return marks;
}

Text demonstrationTrainingRule() {
  std::vector<Text> gains;
  for (std::size_t g = 0; g < kGroups; ++g) {
    gains.push_back(Text::tr("group %1: %2 and %3", g + 1, decimal(kGain[g][1]), decimal(kGain[g][2])));
  }
  return Text::tr(
      "Each simulated mark is the whole point nearest to baseline + gain of the group + talent of the "
      "trainee - severity of the rater + chance, held on the scale. Baseline %1; gains after 20 and 40 "
      "minutes: %2; talent, severity and chance are normal with standard deviations %3, %4 and %5 points; "
      "talents are centred within each group and severities over the raters. The gains were chosen to show "
      "the pattern that the paper describes in words; they are not estimates, and no conclusion about "
      "training "
      "may be drawn from them.",
      decimal(kBaseline), listed(gains), decimal(kTalentSpread), decimal(kSeveritySpread),
      decimal(kMarkSpread));
}

std::vector<EvaluationRating> demonstrationEvaluationMarks(const EvaluationInstrument& instrument,
                                                           const DemonstrationPeople& people,
                                                           std::span<const std::string> models,
                                                           std::uint64_t seed) {
  validateInstrument(instrument);
  TORSIO_EXPECTS(people.raterClasses.size() == instrument.classes.size());
  Random judges = Random::forStream(seed, kJudge);
  Random judgement = Random::forStream(seed, kJudgement);
  std::vector<std::vector<double>> severity;
  for (const std::vector<std::string>& raters : people.raterClasses) {
    severity.push_back(centredNormals(judges, raters.size(), kJudgeSpread));
  }
  std::vector<EvaluationRating> ratings;
  for (const std::string& model : models) {
    const std::size_t row = model == "PM" ? 0 : model == "FEM" ? 1 : 2;
    for (std::size_t c = 0; c < people.raterClasses.size(); ++c) {
      for (std::size_t i = 0; i < people.raterClasses[c].size(); ++i) {
        for (std::size_t j = 0; j < instrument.indices.size(); ++j) {
          const double points = kQuality[row][j % kIndices] +
                                kClassShift[std::min(c, kClassShift.size() - 1)] - severity[c][i] +
                                kJudgementSpread * judgement.normal();
          ratings.push_back({model, people.raterClasses[c][i], c, j, wholePoint(points, instrument.scale)});
        }
      }
    }
  }
  return ratings;
}

Text demonstrationEvaluationRule() {
  constexpr std::array<const char*, 3> kNames = {"PM", "FEM", "MSM"};
  std::vector<Text> qualities;
  for (std::size_t row = 0; row < kQuality.size(); ++row) {
    std::string line = kNames[row];
    for (const double quality : kQuality[row]) {
      (line += ' ') += decimal(quality);
    }
    qualities.emplace_back(line);
  }
  return Text::tr(
      "Each simulated mark of a model is the whole point nearest to quality of the model on the index + "
      "shift "
      "of the rater class - severity of the rater + chance, held on the scale. Qualities for the nine "
      "indices "
      "in order: %1; class shifts -0.3, 0.0 and 0.2; severity and chance are normal with standard deviations "
      "%2 and %3 points. The qualities were chosen to give readable charts; they say nothing about any "
      "model.",
      listed(qualities, Text::tr("%1; %2")), decimal(kJudgeSpread), decimal(kJudgementSpread));
}

}  // namespace torsio
