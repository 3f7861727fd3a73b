// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/scoring/evaluation_resampling.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "assessment/scoring/evaluation.h"
#include "assessment/scoring/evaluation_kernel.h"
#include "sim/core/error.h"
#include "sim/core/random.h"

namespace torsio {

namespace {

constexpr double kOutside = 0.025;  // in each tail

/// Marks of all raters of weighted classes, class by class.
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
        throw Error(ErrorCode::kBadData, Text::verbatim("a mark is missing, so raters cannot be resampled"),
                    Text::verbatim("rater %1, model %2", sheet.rater, ratings.model),
                    Text::verbatim("Complete the marks"));
      }
      panel.steps.push_back(*mark);
    }
    panel.classes.push_back(sheet.raterClass);
    ++raters[sheet.raterClass];
  }
  for (std::size_t c = 0; c < raters.size(); ++c) {
    if (raters[c] == 0 && instrument.classes[c].weight_milli > 0) {
      throw Error(ErrorCode::kBadData,
                  Text::verbatim("a class that counts has no rater, so raters cannot be resampled"),
                  Text::verbatim("class %1, model %2", instrument.classes[c].id, ratings.model),
                  Text::verbatim("Add its raters"));
    }
  }
  return panel;
}

/// Computes N of a resampled panel: with the kernel, or in full where the class sizes do not fit it.
class DrawnScore {
 public:
  DrawnScore(const EvaluationInstrument& instrument, const ModelRatings& ratings, const Panel& panel)
      : instrument_(instrument), means_(instrument.indices.size()), variances_(instrument.indices.size()) {
    if (EvaluationKernel::fits(instrument, panel.classes)) {
      kernel_.emplace(instrument, panel.classes);
      return;
    }
    drawn_.model = ratings.model;
    for (std::size_t i = 0; i < panel.classes.size(); ++i) {
      drawn_.sheets.push_back({std::to_string(i), panel.classes[i], {}});
      drawn_.sheets.back().steps.resize(instrument.indices.size());
    }
  }

  double operator()(const std::vector<std::int64_t>& steps) {
    if (kernel_) {
      return kernel_->run(steps, means_, variances_);
    }
    const std::int64_t* mark = steps.data();
    for (RaterSheet& sheet : drawn_.sheets) {
      for (std::optional<std::int64_t>& place : sheet.steps) {
        place = *mark++;
      }
    }
    return evaluateModel(instrument_, drawn_).n27;
  }

 private:
  const EvaluationInstrument& instrument_;
  std::optional<EvaluationKernel> kernel_;
  ModelRatings drawn_;
  std::vector<double> means_;
  std::vector<double> variances_;
};

}  // namespace

ScoreRange resampledScore(const EvaluationInstrument& instrument, const ModelRatings& ratings,
                          const EvaluationResampling& resampling) {
  validateInstrument(instrument);
  if (resampling.resamples < 1) {
    throw Error(ErrorCode::kBadParameter, Text::verbatim("at least one panel must be drawn"),
                std::to_string(resampling.resamples), Text::verbatim("Draw some thousands"));
  }
  const Panel panel = panelOf(instrument, ratings);
  DrawnScore score(instrument, ratings, panel);
  const std::size_t indices = instrument.indices.size();
  std::vector<std::int64_t> drawn(panel.steps.size());
  std::vector<double> scores;
  Random random(resampling.seed);
  for (std::int64_t i = 0; i < resampling.resamples; ++i) {
    // Raters of one class are adjacent (ModelRatings::sheets), so each is replaced from its own range.
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
    scores.push_back(score(drawn));
  }
  std::sort(scores.begin(), scores.end());
  const auto at = [&scores](double p) {
    const auto rank = static_cast<std::size_t>(std::ceil(p * static_cast<double>(scores.size())));
    return scores[std::max<std::size_t>(rank, 1) - 1];
  };
  return {at(kOutside), at(1.0 - kOutside)};
}

}  // namespace torsio
