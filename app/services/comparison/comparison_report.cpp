// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/comparison/comparison_report.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/services/comparison/compared_pictures.h"
#include "app/services/comparison/comparison_order.h"
#include "assessment/results/number_format.h"
#include "sim/core/angle.h"
#include "sim/core/load_decimals.h"

namespace torsio {

namespace {

constexpr double kMillimetres = 1e3;
constexpr double kMilliseconds = 1e3;

/// Formats times from microseconds to minutes in one column: three digits, or the whole integer part.
std::string readable(double value) {
  const int before = value > 0.0 ? static_cast<int>(std::floor(std::log10(value))) + 1 : 1;
  return formatFixed(value, std::clamp(3 - before, 0, 6));
}

Provenance comparedFrom(const ComparisonResult& result, const Text& formula, std::int64_t n) {
  Provenance provenance;
  provenance.formula = formula;
  provenance.n = std::to_string(n);
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
          {Text::tr("Instruction set of all models"), std::string(kComparedInstructions)},
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
  figure.title = Text::tr("Deformation time (Fig. 10)");
  figure.xLabel = Text::tr("model");
  figure.yLabel = Text::tr("processing (ms)");
  figure.kind = FigureKind::kPoints;
  figure.logarithmic = true;
  FigureSeries whole{Text::tr("whole twist"), {}, {}, {}, {}, {}, {}, false};
  FigureSeries frame{Text::tr("one frame"), {}, {}, {}, {}, {}, {}, false};
  FigureSeries setUp{Text::tr("set-up"), {}, {}, {}, {}, {}, {}, false};
  double category = 0.0;
  for (const ModelResult& model : result.models) {
    figure.categories.push_back(shortName(model.id));
    for (const auto& [series, value] :
         {std::pair{&whole, model.deformation_s}, {&frame, model.frameMedian_s}, {&setUp, model.setUp_s}}) {
      series->x.push_back(category);
      series->y.emplace_back(kMilliseconds * std::max(value, 1e-9));
    }
    category += 1.0;
  }
  figure.series = {whole, frame, setUp};
  figure.valuesInLabels = true;
  figure.notes = {Text::tr(
      "Each line is ten times the one below. The reference has no frames: its values are one step of the "
      "torque and all of them. Set-up is not part of the deformation time.")};
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
    series.name = shortName(model.id);
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
    if (result.options.unitConfirmed) {
      figure.notes.emplace_back(Text::tr(
          "The unit of the measured markers was confirmed by whoever compared: it was not checked."));
    }
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
    series.name = shortName(model.id);
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
      table.notes.emplace_back(Text::tr("%1 has no row: %2.", shortName(model.id), model.noEquilibrium));
      continue;
    }
    table.rows.push_back(
        {shortName(model.id), formatFixed(degrees(state.angle_rad), 2),
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
    table.rows.push_back({shortName(model.id), std::to_string(model.unknowns), formatFixed(model.setUp_s, 3),
                          readable(1e3 * model.frameMedian_s), readable(1e3 * model.frameWorst_s),
                          std::to_string(model.frames), readable(model.deformation_s),
                          formatFixed(model.settle_s, 2), formatFixed(degrees(model.moving.angle_rad), 2)});
  }
  table.notes = {
      Text::tr("Frame: the median. Settling: from the last frame to equilibrium, no part of the twist. Last "
               "angle: "
               "as the last frame showed it."),
      Text::tr("The twist model alone, without its mesh, updates all key points in %1 \u00b5s.",
               formatFixed(1e6 * result.latticeUpdate_s, 2)),
      Text::tr("All models run on the same instruction set (%1). As the simulator draws, with %2, a frame of "
               "PM takes %3 ms and all key points %4 \u00b5s.",
               std::string(kComparedInstructions), result.widest.instructionSet,
               readable(1e3 * result.widest.pmFrame_s), formatFixed(1e6 * result.widest.latticeUpdate_s, 2))};
  table.provenance =
      comparedFrom(result, Text::tr("processing time"), static_cast<std::int64_t>(result.models.size()));
  return table;
}

ReportTable meshTable(const ComparisonResult& result) {
  ReportTable table;
  table.id = "table-meshes";
  table.title = Text::tr("Coarser meshes of each model");
  table.columns = {Text::tr("Model"),        Text::tr("Ridges"),         Text::tr("Sections"),
                   Text::tr("Rings"),        Text::tr("Unknowns"),       Text::tr("End angle (\u00b0)"),
                   Text::tr("Markers (mm)"), Text::tr("Equilibrium (s)")};
  for (const ComparedMesh& mesh : result.meshes) {
    const bool found = mesh.noEquilibrium.empty();
    table.rows.push_back({shortName(mesh.model), std::to_string(mesh.ridges), std::to_string(mesh.sections),
                          std::to_string(mesh.rings), std::to_string(mesh.unknowns),
                          found ? formatFixed(degrees(mesh.angle_rad), 2) : "",
                          found && mesh.markerRmse_m ? formatFixed(kMillimetres * *mesh.markerRmse_m, 3) : "",
                          formatFixed(mesh.settle_s, 2)});
    if (!found) {
      table.notes.emplace_back(
          Text::tr("%1 with %2 {ring|rings}: %3.", shortName(mesh.model), mesh.rings, mesh.noEquilibrium));
    }
  }
  table.notes.emplace_back(
      Text::tr("The last row of a model is the mesh that is compared above. Markers: RMSE of their "
               "displacements from the reference that is compared. A model whose angle still changes from "
               "row to row has not come to its own limit."));
  table.provenance =
      comparedFrom(result, Text::tr("Eq. 24"), static_cast<std::int64_t>(result.meshes.size()));
  return table;
}

}  // namespace

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
  const std::vector<Text> order = comparisonOrder(result);
  accuracy.paragraphs.assign(order.begin(), order.end());
  accuracy.tables = {accuracyTable(result), meshTable(result)};
  if (!result.markers.empty()) {
    accuracy.figures = {markerFigure(result), courseFigure(result)};
  }
  ReportSection pictures{"pictures", Text::tr("Pictures")};
  pictures.figures = comparedPictures(result);
  ReportSection honesty{"limits", Text::tr("What these figures do not say")};
  const std::vector<Text> limits = comparisonLimits();
  honesty.paragraphs.assign(limits.begin(), limits.end());
  for (const OrganWarning& warning : result.organWarnings) {
    honesty.paragraphs.push_back(Text::tr("The organ was accepted with a warning: %1.", coded(warning)));
  }
  report.sections = {speed, accuracy, pictures, honesty};
  return report;
}

}  // namespace torsio
