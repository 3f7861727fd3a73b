// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/scoring/evaluation_resampling.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "assessment/scoring/evaluation_kernel.h"
#include "sim/base/error.h"
#include "sim/base/random.h"

namespace torsio {

namespace {

constexpr double kOutside = 0.025;  // on either side

/// Marks of all raters whose class counts, class after class.
struct Panel {
  std::vector<std::size_t> classes;  // of each rater
  std::vector<std::int64_t> steps;   // raters x indices
};

Panel panelOf(const EvaluationInstrument& instrument, const ModelRatings& ratings) {
  Panel panel;
  std::vector<std::size_t> raters(instrument.classes.size(), 0);
  for (const RaterSheet& sheet : ratings.sheets) {
    if (instrument.classes[sheet.raterClass].weight_milli == 0) {
      continue;
    }
    for (const std::optional<std::int64_t>& mark : sheet.steps) {
      if (!mark) {
        throw Error(ErrorCode::kBadData, "a mark is missing, so raters cannot be resampled",
                    Text("rater %1, model %2", sheet.rater, ratings.model), "Complete the marks");
      }
      panel.steps.push_back(*mark);
    }
    panel.classes.push_back(sheet.raterClass);
    ++raters[sheet.raterClass];
  }
  for (std::size_t c = 0; c < raters.size(); ++c) {
    if (raters[c] == 0 && instrument.classes[c].weight_milli > 0) {
      throw Error(ErrorCode::kBadData, "a class that counts has no rater, so raters cannot be resampled",
                  Text("class %1, model %2", instrument.classes[c].id, ratings.model), "Add its raters");
    }
  }
  return panel;
}

}  // namespace

ScoreRange resampledScore(const EvaluationInstrument& instrument, const ModelRatings& ratings,
                          const EvaluationResampling& resampling) {
  validateInstrument(instrument);
  if (resampling.resamples < 1) {
    throw Error(ErrorCode::kBadParameter, "at least one panel must be drawn",
                std::to_string(resampling.resamples), "Draw some thousands");
  }
  const Panel panel = panelOf(instrument, ratings);
  EvaluationKernel kernel(instrument, panel.classes);
  const std::size_t indices = instrument.indices.size();
  std::vector<std::int64_t> drawn(panel.steps.size());
  std::vector<double> means(indices);
  std::vector<double> variances(indices);
  std::vector<double> scores;
  Random random(resampling.seed);
  for (std::int64_t i = 0; i < resampling.resamples; ++i) {
    // Raters of one class stand together (ModelRatings::sheets), so each is replaced from its own stretch.
    for (std::size_t first = 0; first < panel.classes.size();) {
      std::size_t end = first;
      while (end < panel.classes.size() && panel.classes[end] == panel.classes[first]) {
        ++end;
      }
      for (std::size_t rater = first; rater < end; ++rater) {
        const std::size_t from = first + static_cast<std::size_t>(random.bounded(end - first));
        std::copy_n(panel.steps.data() + from * indices, indices, drawn.data() + rater * indices);
      }
      first = end;
    }
    scores.push_back(kernel.run(drawn, means, variances));
  }
  std::sort(scores.begin(), scores.end());
  const auto at = [&scores](double p) {
    const auto rank = static_cast<std::size_t>(std::ceil(p * static_cast<double>(scores.size())));
    return scores[std::max<std::size_t>(rank, 1) - 1];
  };
  return {at(kOutside), at(1.0 - kOutside)};
}

}  // namespace torsio
