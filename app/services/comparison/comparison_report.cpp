// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/comparison/comparison_report.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/services/base/csv_table.h"
#include "assessment/results/number_format.h"
#include "sim/core/angle.h"
#include "sim/core/file_io.h"
#include "sim/core/load_decimals.h"

namespace torsio {

namespace {

constexpr double kMillimetres = 1e3;

/// Returns a model's name for tables and legends.
Text shortName(const ModelResult& model) {
  if (model.id == "reference") {
    return Text::tr("reference");
  }
  if (model.id == "paper") {
    return Text::tr("PM as printed");
  }
  if (model.id == "rod") {
    return Text::tr("rod");
  }
  return model.id == "pm"    ? Text::verbatim("PM")
         : model.id == "fem" ? Text::verbatim("FEM")
                             : Text::verbatim("MSM");
}

/// Formats times from microseconds to minutes in one column: three digits, or the whole integer part.
std::string readable(double value) {
  const int before = value > 0.0 ? static_cast<int>(std::floor(std::log10(value))) + 1 : 1;
  return formatFixed(value, std::clamp(3 - before, 0, 6));
}

/// Models with their errors, m, from the smallest; without those that have none, and without the reference.
using OrderedModels = std::vector<std::pair<const ModelResult*, double>>;

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

/// Whether the order has the twist model before the elements and these before the springs, as the paper's.
bool isThePapers(const OrderedModels& order) {
  std::vector<std::string> ids;
  for (const auto& [model, error_m] : order) {
    if (model->id == "pm" || model->id == "fem" || model->id == "msm") {
      ids.push_back(model->id);
    }
  }
  return ids == std::vector<std::string>{"pm", "fem", "msm"};
}

std::string listed(const OrderedModels& order) {
  std::string text;
  for (const auto& [model, error_m] : order) {
    text += (text.empty() ? "" : ", ") + shortName(*model).str() + " " +
            formatFixed(kMillimetres * error_m, 2) + " mm";
  }
  return text;
}

Text paperSentence(const OrderedModels& order) {
  return isThePapers(order)
             ? Text::tr("The paper's order (PM before FEM before MSM) holds in this run.")
             : Text::tr("The paper's order (PM before FEM before MSM) does not hold in this run.");
}

Provenance comparedFrom(const ComparisonResult& result, const Text& formula, std::int64_t n) {
  Provenance provenance;
  provenance.formula = formula;
  provenance.n = n;
  provenance.flags = {Text::tr("load average %1", formatFixed(result.machine.loadAverage, 2))};
  return provenance;
}

Facts machineLines(const ComparisonResult& result) {
  const MachineFacts& machine = result.machine;
  return {{Text::tr("Processor"), machine.processor},
          {Text::tr("Cores"), std::to_string(machine.cores)},
          {Text::tr("Load average at the start"), formatFixed(machine.loadAverage, 2)},
          {Text::tr("Compiler"), machine.compiler},
          {Text::tr("Flags"), machine.flags},
          {Text::tr("Instruction set of the view"), machine.instructionSet},
          {Text::tr("Lattice"),
           std::to_string(result.ridges) + " ridges, " + std::to_string(result.sections) + " sections"},
          {Text::tr("Mesh"), std::to_string(result.vertices) + " vertices"},
          {Text::tr("Torque at the free end"), formatFixed(result.torque_Nm, kModelTorqueDecimals) + " N m"},
          {Text::tr("Shear modulus"), formatFixed(result.shearModulus_Pa, 0) + " Pa"},
          {Text::tr("Poisson's ratio of the elements"), formatFixed(result.options.poissonRatio, 3)}};
}

ReportFigure timeFigure(const ComparisonResult& result) {
  ReportFigure figure;
  figure.id = "figure-10";
  figure.title = Text::tr("Deformation time (Fig. 10), powers of ten");
  figure.xLabel = Text::tr("model");
  figure.yLabel = Text::tr("processing, powers of ten of a second");
  figure.kind = FigureKind::kPoints;
  FigureSeries whole{Text::tr("whole twist"), {}, {}, {}, {}, {}, {}, false};
  FigureSeries frame{Text::tr("one frame"), {}, {}, {}, {}, {}, {}, false};
  FigureSeries setUp{Text::tr("set-up"), {}, {}, {}, {}, {}, {}, false};
  double category = 0.0;
  for (const ModelResult& model : result.models) {
    figure.categories.push_back(shortName(model));
    for (const auto& [series, value] :
         {std::pair{&whole, model.deformation_s}, {&frame, model.frameMedian_s}, {&setUp, model.setUp_s}}) {
      series->x.push_back(category);
      series->y.emplace_back(std::log10(std::max(value, 1e-9)));
    }
    category += 1.0;
  }
  figure.series = {whole, frame, setUp};
  figure.valuesInLabels = true;
  figure.notes = {Text::tr(
      "-3 is a millisecond, 0 a second; the table has the times themselves. The reference has no frames: its "
      "values are one step of the torque and all of them. Set-up is not part of the deformation time.")};
  figure.provenance =
      comparedFrom(result, Text::tr("processing time"), static_cast<std::int64_t>(result.models.size()));
  return figure;
}

ReportFigure markerFigure(const ComparisonResult& result) {
  ReportFigure figure;
  figure.id = "figure-13";
  figure.title = Text::tr("Displacement of the markers in equilibrium (Fig. 13)");
  figure.xLabel = Text::tr("marker");
  figure.yLabel = Text::tr("displacement (mm)");
  for (const OrganMarker& marker : result.markers) {
    figure.categories.emplace_back(std::to_string(marker.number));
  }
  for (const ModelResult& model : result.models) {
    FigureSeries series;
    series.name = shortName(model);
    for (const double d : model.settled.displacements_m) {
      series.y.push_back(model.noEquilibrium.empty() ? std::optional(kMillimetres * d) : std::nullopt);
    }
    figure.series.push_back(series);
  }
  if (!result.measured.empty()) {
    FigureSeries series;
    series.name = Text::tr("measured");
    for (const OrganMarker& marker : result.markers) {
      const MeasuredDisplacement found = finalDisplacement(result.measured, marker.number);
      series.y.push_back(found.subjects > 0 ? std::optional(kMillimetres * found.mean_m) : std::nullopt);
    }
    figure.series.push_back(series);
  }
  figure.provenance =
      comparedFrom(result, Text::tr("Eq. 24"), static_cast<std::int64_t>(result.markers.size()));
  return figure;
}

ReportFigure courseFigure(const ComparisonResult& result) {
  ReportFigure figure;
  figure.id = "figure-14";
  figure.title =
      Text::tr("Displacement of marker %1 during the twist (Fig. 14)", result.options.courseMarker);
  figure.xLabel = Text::tr("time (s)");
  figure.yLabel = Text::tr("displacement (mm)");
  figure.kind = FigureKind::kLines;
  for (const ModelResult& model : result.models) {
    FigureSeries series;
    series.name = shortName(model);
    for (const CoursePoint& point : model.course) {
      series.x.push_back(point.time_s);
      series.y.emplace_back(kMillimetres * point.displacement_m);
    }
    figure.series.push_back(series);
  }
  for (const MeasuredSubject& subject : result.measured) {
    const auto found = subject.markers.find(result.options.courseMarker);
    if (found == subject.markers.end()) {
      continue;
    }
    FigureSeries series;
    series.name = subject.name;
    for (const MarkerSample& sample : found->second) {
      series.x.push_back(sample.time_s);
      series.y.emplace_back(kMillimetres * norm(sample.place_m - found->second.front().place_m));
    }
    figure.series.push_back(series);
  }
  figure.notes = {Text::tr(
      "Finite elements and springs have mass and follow the torque late; the others are in equilibrium at "
      "once. What was measured goes by the name of the person.")};
  figure.valuesStand = Text::tr("They are in %1.", Text::verbatim("course.csv"));
  figure.provenance =
      comparedFrom(result, Text::tr("Eq. 24"), static_cast<std::int64_t>(result.models.size()));
  return figure;
}

ReportTable accuracyTable(const ComparisonResult& result) {
  ReportTable table;
  table.id = "table-accuracy";
  table.title = Text::tr("Accuracy in equilibrium, against the reference");
  table.columns = {Text::tr("Model"),        Text::tr("End angle (\u00b0)"), Text::tr("RMSE (mm)"),
                   Text::tr("Markers (mm)"), Text::tr("Course (mm)"),        Text::tr("Roughness (mm)"),
                   Text::tr("Radius (%)"),   Text::tr("Volume (%)"),         Text::tr("Energy (mJ)")};
  for (const ModelResult& model : result.models) {
    const ModelState& state = model.settled;
    if (!model.noEquilibrium.empty()) {
      table.notes.emplace_back(Text::tr("%1 has no row: %2.", shortName(model), model.noEquilibrium));
      continue;
    }
    table.rows.push_back(
        {shortName(model), formatFixed(degrees(state.angle_rad), 2),
         formatFixed(kMillimetres * state.rmse_m, 3), formatFixed(kMillimetres * state.markerRmse_m, 3),
         formatFixed(kMillimetres * model.courseRmse_m, 3), formatFixed(kMillimetres * state.roughness_m, 4),
         formatFixed(100.0 * state.radiusChange, 2), formatFixed(100.0 * (state.volumeRatio - 1.0), 3),
         formatFixed(1e3 * state.energy_J, 4)});
  }
  if (!byMeasured(result).empty()) {
    table.columns.push_back(Text::tr("Measured (mm)"));
    std::size_t row = 0;
    for (const ModelResult& model : result.models) {
      if (const auto error_m = measuredRmse_m(result, model)) {
        table.rows[row++].emplace_back(formatFixed(kMillimetres * *error_m, 3));
      }
    }
    table.notes.emplace_back(
        Text::tr("Measured: RMSE of the markers' displacements from the means of those measured."));
  }
  table.notes.emplace_back(Text::tr(
      "RMSE: over all key points of the lattice; markers and course: of their displacements. Radius: its "
      "largest change. Roughness: what the radius of a key point changes "
      "differently from its four neighbours."));
  table.provenance =
      comparedFrom(result, Text::tr("Eq. 24"), static_cast<std::int64_t>(result.models.size()));
  return table;
}

ReportTable timeTable(const ComparisonResult& result) {
  ReportTable table;
  table.id = "table-times";
  table.title = Text::tr("Processing times");
  table.columns = {Text::tr("Model"),      Text::tr("Unknowns"),     Text::tr("Set-up (s)"),
                   Text::tr("Frame (ms)"), Text::tr("Worst (ms)"),   Text::tr("Frames"),
                   Text::tr("Twist (s)"),  Text::tr("Settling (s)"), Text::tr("Last angle (\u00b0)")};
  for (const ModelResult& model : result.models) {
    table.rows.push_back({shortName(model), std::to_string(model.unknowns), formatFixed(model.setUp_s, 3),
                          readable(1e3 * model.frameMedian_s), readable(1e3 * model.frameWorst_s),
                          std::to_string(model.frames), readable(model.deformation_s),
                          formatFixed(model.settle_s, 2), formatFixed(degrees(model.moving.angle_rad), 2)});
  }
  table.notes = {
      Text::tr("Frame: the median. Settling: from the last frame to equilibrium, no part of the twist. Last "
               "angle: "
               "as the last frame showed it."),
      Text::tr("The twist model alone, without its mesh, updates all key points in %1 \u00b5s.",
               formatFixed(1e6 * result.latticeUpdate_s, 2))};
  table.provenance =
      comparedFrom(result, Text::tr("processing time"), static_cast<std::int64_t>(result.models.size()));
  return table;
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

std::vector<Text> comparisonLimits() {
  return {
      Text::tr(
          "The twist model computes in advance; finite elements of small strain could do so too (one answer "
          "to one newton metre, scaled), as fast, but would swell with the angle. The comparison is with "
          "elements that bear large rotations."),
      Text::tr(
          "Set-up counts when organ or tissue change: it is stated apart and not in the deformation time."),
      Text::tr("Linear tetrahedra lock: they are too stiff in torsion, the more so the coarser and the less "
               "compressible. More of them, or quadratic ones, would be more accurate and slower. Springs by "
               "position-based dynamics are as stiff as their substeps make them; their error is read in the "
               "equilibrium of the springs themselves."),
      Text::tr("The end is turned as a rigid body in its place; the twist model lets it warp and slide. The "
               "reference shares material, ends and lattice with the elements and not with a person: only "
               "measurements say which model is near to life, and bones are in none of them."),
      Text::tr("The torques of the twist model as printed in the paper come from a cone in place of the "
               "membrane, and its rotation is linear: both errors grow with the torque.")};
}

ReportModel comparisonReport(const ComparisonResult& result, const std::string& softwareVersion,
                             std::int64_t createdUtc_us) {
  ReportModel report;
  report.title = Text::tr("Comparison of twist models");
  report.subtitle = result.organ;
  report.softwareVersion = softwareVersion;
  report.createdUtc_us = createdUtc_us;
  report.facts = machineLines(result);
  ReportSection speed{"time", Text::tr("Time")};
  speed.figures = {timeFigure(result)};
  speed.tables = {timeTable(result)};
  ReportSection accuracy{"accuracy", Text::tr("Accuracy")};
  accuracy.paragraphs = comparisonOrder(result);
  accuracy.tables = {accuracyTable(result)};
  if (!result.markers.empty()) {
    accuracy.figures = {markerFigure(result), courseFigure(result)};
  }
  ReportSection honesty{"limits", Text::tr("What these figures do not say")};
  honesty.paragraphs = comparisonLimits();
  for (const OrganWarning& warning : result.organWarnings) {
    honesty.paragraphs.push_back(Text::tr("The organ was accepted with a warning: %1.", coded(warning)));
  }
  report.sections = {speed, accuracy, honesty};
  return report;
}

namespace {

using Json = nlohmann::ordered_json;

Json stateJson(const ModelState& state) {
  return {{"angle_rad", state.angle_rad},        {"energy_j", state.energy_J},
          {"volume_ratio", state.volumeRatio},   {"radius_change", state.radiusChange},
          {"roughness_m", state.roughness_m},    {"rmse_m", state.rmse_m},
          {"marker_rmse_m", state.markerRmse_m}, {"marker_displacements_m", state.displacements_m}};
}

/// Returns whether the organ has the marker whose course is reported.
bool tellsCourse(const ComparisonResult& result) {
  return result.options.courseMarker <= static_cast<int>(result.markers.size());
}

const Json& noMarker() {
  static const Json kNone{{"undefined", "the organ has no such marker"}};
  return kNone;
}

Json modelJson(const ModelResult& model, std::optional<double> measured_m, bool hasMarker) {
  Json course = Json::array();
  for (const CoursePoint& point : model.course) {
    course.push_back({{"time_s", point.time_s},
                      {"torque_nm", point.torque_Nm},
                      {"angle_rad", point.angle_rad},
                      {"displacement_m", hasMarker ? Json(point.displacement_m) : noMarker()}});
  }
  return {{"id", model.id},
          {"title", model.title.str()},
          {"unknowns", model.unknowns},
          {"set_up_s", model.setUp_s},
          {"frames", model.frames},
          {"frame_median_s", model.frameMedian_s},
          {"frame_worst_s", model.frameWorst_s},
          {"deformation_s", model.deformation_s},
          {"settle_s", model.settle_s},
          {"moving", stateJson(model.moving)},
          {"settled", model.noEquilibrium.empty() ? stateJson(model.settled)
                                                  : Json{{"undefined", model.noEquilibrium.str()}}},
          {"measured_rmse_m", measured_m ? Json(*measured_m) : Json{{"undefined", "nothing was measured"}}},
          {"course_rmse_m", hasMarker ? Json(model.courseRmse_m) : noMarker()},
          {"course", course}};
}

Json measuredJson(const ComparisonResult& result) {
  if (result.measured.empty()) {
    return {{"undefined", "no measurements were given (--measured FILE)"}};
  }
  Json markers = Json::array();
  for (const OrganMarker& marker : result.markers) {
    const MeasuredDisplacement found = finalDisplacement(result.measured, marker.number);
    Json entry{{"marker", marker.number}, {"subjects", found.subjects}};
    if (found.subjects > 0) {
      entry["displacement_m"] = found.mean_m;
    } else {
      entry["displacement_m"] = {{"undefined", "nobody was measured there"}};
    }
    markers.push_back(entry);
  }
  return markers;
}

/// Returns a CSV line of names without commas and numbers, possibly negative.
std::string plainLine(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) {
    line += (line.empty() ? "" : ",") + cell;
  }
  return line + "\r\n";
}

std::string modelsCsv(const ComparisonResult& result) {
  std::string text =
      plainLine({"model", "unknowns", "set_up_s", "frames", "frame_median_s", "frame_worst_s",
                 "deformation_s", "settle_s", "angle_rad", "energy_j", "volume_ratio", "radius_change",
                 "roughness_m", "rmse_m", "marker_rmse_m", "measured_rmse_m", "course_rmse_m"});
  for (const ModelResult& m : result.models) {
    const std::optional<double> measured_m = measuredRmse_m(result, m);
    const auto settled = [&m](double value) { return m.noEquilibrium.empty() ? formatExact(value) : ""; };
    text += plainLine(
        {m.id, std::to_string(m.unknowns), formatExact(m.setUp_s), std::to_string(m.frames),
         formatExact(m.frameMedian_s), formatExact(m.frameWorst_s), formatExact(m.deformation_s),
         formatExact(m.settle_s), settled(m.settled.angle_rad), settled(m.settled.energy_J),
         settled(m.settled.volumeRatio), settled(m.settled.radiusChange), settled(m.settled.roughness_m),
         settled(m.settled.rmse_m), settled(m.settled.markerRmse_m),
         measured_m ? formatExact(*measured_m) : "", tellsCourse(result) ? formatExact(m.courseRmse_m) : ""});
  }
  return text;
}

std::string markersCsv(const ComparisonResult& result) {
  std::vector<std::string> header{"marker", "name"};
  for (const ModelResult& model : result.models) {
    header.push_back(model.id + "_m");
  }
  header.emplace_back("measured_m");
  header.emplace_back("subjects");
  std::string text = csvLine(header);
  for (std::size_t i = 0; i < result.markers.size(); ++i) {
    const OrganMarker& marker = result.markers[i];
    std::vector<std::string> line{std::to_string(marker.number), marker.name};
    for (const ModelResult& model : result.models) {
      line.push_back(model.noEquilibrium.empty() ? formatExact(model.settled.displacements_m[i]) : "");
    }
    const MeasuredDisplacement found = finalDisplacement(result.measured, marker.number);
    line.push_back(found.subjects > 0 ? formatExact(found.mean_m) : "");
    line.push_back(std::to_string(found.subjects));
    text += csvLine(line);
  }
  return text;
}

std::string courseCsv(const ComparisonResult& result) {
  std::string text = plainLine({"model", "time_s", "torque_nm", "angle_rad", "displacement_m"});
  for (const ModelResult& model : result.models) {
    for (const CoursePoint& point : model.course) {
      text += plainLine({model.id, formatExact(point.time_s), formatExact(point.torque_Nm),
                         formatExact(point.angle_rad),
                         tellsCourse(result) ? formatExact(point.displacement_m) : ""});
    }
  }
  return text;
}

}  // namespace

std::string comparisonJson(const ComparisonResult& result) {
  Json json;
  json["organ"] = result.organ;
  json["organ_warnings"] = Json::array();
  for (const OrganWarning& warning : result.organWarnings) {
    json["organ_warnings"].push_back(coded(warning).str());
  }
  json["ridges"] = result.ridges;
  json["sections"] = result.sections;
  json["mesh_vertices"] = result.vertices;
  json["length_m"] = result.length_m;
  json["shear_modulus_pa"] = result.shearModulus_Pa;
  json["poisson_ratio_of_elements"] = result.options.poissonRatio;
  json["torque_nm"] = result.torque_Nm;
  json["ends"] = result.options.grasp ? "clamped-free" : "clamped-turned";
  json["grasp"] = result.options.grasp.value_or(1.0);
  json["ramp_s"] = result.options.ramp_s;
  json["rings"] = result.options.rings;
  json["reference_rings"] = result.options.referenceRings;
  json["substeps_of_springs"] = result.options.springs.substeps;
  json["calibration_of_springs"] =
      result.options.springs.calibration == Calibration::kAffine ? "affine" : "equilibrium";
  json["paper_order_holds"] = isThePapers(byReference(result));
  json["course_marker"] = result.options.courseMarker;
  json["machine"] = {{"processor", result.machine.processor},
                     {"cores", result.machine.cores},
                     {"load_average", result.machine.loadAverage},
                     {"instruction_set_of_views", result.machine.instructionSet},
                     {"compiler", result.machine.compiler},
                     {"flags", result.machine.flags}};
  const double fem_s = result.model("fem").frameMedian_s;
  json["speed"] = {
      {"pm_lattice_update_s", result.latticeUpdate_s},
      {"pm_view_frame_s", result.model("pm").frameMedian_s},
      {"fem_frame_over_pm_lattice_update", fem_s / result.latticeUpdate_s},
      {"fem_frame_over_pm_view_frame", fem_s / result.model("pm").frameMedian_s},
      {"msm_frame_over_pm_view_frame", result.model("msm").frameMedian_s / result.model("pm").frameMedian_s}};
  json["models"] = Json::array();
  for (const ModelResult& model : result.models) {
    json["models"].push_back(modelJson(model, measuredRmse_m(result, model), tellsCourse(result)));
  }
  json["measured"] = measuredJson(result);
  return json.dump(2) + "\n";
}

std::vector<std::string> writeComparisonFiles(const ComparisonResult& result,
                                              const std::filesystem::path& folder) {
  ensureFolder(folder);
  writeFileAtomically(folder / "comparison.json", comparisonJson(result));
  writeFileAtomically(folder / "models.csv", modelsCsv(result));
  writeFileAtomically(folder / "course.csv", courseCsv(result));
  writeFileAtomically(folder / "markers.csv", markersCsv(result));
  return {"comparison.json", "models.csv", "markers.csv", "course.csv"};
}

}  // namespace torsio
