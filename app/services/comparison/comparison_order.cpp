// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/comparison/comparison_order.h"

#include <algorithm>
#include <optional>
#include <string>

#include "assessment/results/number_format.h"

namespace torsio {

Text shortName(const std::string& id) {
  if (id == "reference") {
    return Text::tr("reference");
  }
  if (id == "paper") {
    return Text::tr("PM as printed");
  }
  if (id == "rod") {
    return Text::tr("rod");
  }
  return id == "pm" ? Text::verbatim("PM") : id == "fem" ? Text::verbatim("FEM") : Text::verbatim("MSM");
}

OrderedModels byMeasured(const ComparisonResult& result) {
  OrderedModels order;
  for (const ModelResult& model : result.models) {
    if (const auto error_m = measuredRmse_m(result, model)) {
      order.emplace_back(&model, *error_m);
    }
  }
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.second < b.second; });
  return order;
}

OrderedModels byReference(const ComparisonResult& result) {
  OrderedModels order;
  for (const ModelResult& model : result.models) {
    if (model.id != "reference" && model.noEquilibrium.empty()) {
      order.emplace_back(&model, result.markers.empty() ? model.settled.rmse_m : model.settled.markerRmse_m);
    }
  }
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.second < b.second; });
  return order;
}

bool isThePapers(const OrderedModels& order) {
  std::vector<std::string> ids;
  for (const auto& [model, error_m] : order) {
    if (model->id == "pm" || model->id == "fem" || model->id == "msm") {
      ids.push_back(model->id);
    }
  }
  return ids == std::vector<std::string>{"pm", "fem", "msm"};
}

namespace {

std::string listed(const OrderedModels& order) {
  std::string text;
  for (const auto& [model, error_m] : order) {
    text +=
        (text.empty() ? "" : ", ") + shortName(model->id).str() + " " + formatFixed(1e3 * error_m, 2) + " mm";
  }
  return text;
}

Text paperSentence(const OrderedModels& order) {
  return isThePapers(order)
             ? Text::tr("The paper's order (PM before FEM before MSM) holds in this run.")
             : Text::tr("The paper's order (PM before FEM before MSM) does not hold in this run.");
}

}  // namespace

std::vector<Text> comparisonOrder(const ComparisonResult& result) {
  const OrderedModels order = byReference(result);
  std::vector<Text> sentences{
      result.markers.empty()
          ? Text::tr("Errors of the key points against the reference, from the smallest: %1.", listed(order))
          : Text::tr("Errors of the markers against the reference, from the smallest: %1.", listed(order)),
      paperSentence(order)};
  if (const OrderedModels measured = byMeasured(result); !measured.empty()) {
    sentences.push_back(Text::tr("Errors of the markers against the measured ones, from the smallest: %1.",
                                 listed(measured)));
    sentences.push_back(paperSentence(measured));
  }
  sentences.push_back(Text::tr(
      "The order belongs to this organ and these settings: %1 {ring|rings} of elements, Poisson's ratio %2, "
      "springs calibrated by %3. With other ones it can change.",
      result.options.rings, formatFixed(result.options.poissonRatio, 2),
      result.options.springs.calibration == Calibration::kAffine ? Text::tr("energy")
                                                                 : Text::tr("the angle of a small torque")));
  return sentences;
}

}  // namespace torsio
