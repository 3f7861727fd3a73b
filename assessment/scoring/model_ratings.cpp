// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/scoring/model_ratings.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "sim/core/error.h"

namespace torsio {

std::vector<ModelRatings> groupRatings(const EvaluationInstrument& instrument,
                                       std::span<const EvaluationRating> ratings) {
  validateInstrument(instrument);
  std::vector<ModelRatings> models;
  std::map<std::string, std::size_t> modelAt;
  std::map<std::string, std::size_t> classOf;
  std::map<std::pair<std::size_t, std::string>, std::size_t> sheetAt;
  std::set<std::tuple<std::string, std::string, std::size_t>> seen;
  for (const EvaluationRating& rating : ratings) {
    if (rating.raterClass >= instrument.classes.size() || rating.index >= instrument.indices.size()) {
      throw Error(ErrorCode::kBadData,
                  Text::verbatim("a rating names a class or an index that the instrument does not have"),
                  Text::verbatim("rater %1, model %2", rating.rater, rating.model),
                  Text::verbatim("Use the classes and indices of the instrument."));
    }
    const std::string where = "rater " + rating.rater + ", index " + instrument.indices[rating.index].id +
                              ", model " + rating.model;
    if (!seen.insert({rating.model, rating.rater, rating.index}).second) {
      throw Error(ErrorCode::kBadData, Text::verbatim("the same mark appears twice"), where,
                  Text::verbatim("Keep one; a correction supersedes the earlier mark."));
    }
    if (rating.steps && !isOnScale(*rating.steps, instrument.scale)) {
      throw Error(ErrorCode::kBadData,
                  Text::verbatim("score %1 is outside the scale",
                                 std::to_string(pointsFromSteps(*rating.steps, instrument.scale))),
                  where, Text::verbatim("Correct the mark; marks are never clamped."));
    }
    const auto [knownClass, isNew] = classOf.emplace(rating.rater, rating.raterClass);
    if (!isNew && knownClass->second != rating.raterClass) {
      throw Error(ErrorCode::kBadData, Text::verbatim("a rater appears in two classes"), where,
                  Text::verbatim("Give each rater one class."));
    }
    const auto [model, modelIsNew] = modelAt.emplace(rating.model, models.size());
    if (modelIsNew) {
      models.push_back({rating.model, {}});
    }
    ModelRatings& of = models[model->second];
    const auto [sheet, sheetIsNew] =
        sheetAt.emplace(std::pair{model->second, rating.rater}, of.sheets.size());
    if (sheetIsNew) {
      const std::size_t indices = instrument.indices.size();
      of.sheets.push_back({rating.rater, rating.raterClass, std::vector<std::optional<std::int64_t>>(indices),
                           std::vector<EvaluationMarkId>(indices)});
    }
    of.sheets[sheet->second].steps[rating.index] = rating.steps;
    of.sheets[sheet->second].marks[rating.index] = rating.id;
  }
  for (ModelRatings& model : models) {
    std::sort(model.sheets.begin(), model.sheets.end(), [](const RaterSheet& a, const RaterSheet& b) {
      return std::tie(a.raterClass, a.rater) < std::tie(b.raterClass, b.rater);
    });
  }
  return models;
}

}  // namespace torsio
