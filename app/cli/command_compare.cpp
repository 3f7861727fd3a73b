// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "app/cli/progress_line.h"
#include "app/outputs/pdf/pdf_report.h"
#include "app/services/base/build_info.h"
#include "app/services/comparison/comparison_files.h"
#include "app/services/comparison/comparison_order.h"
#include "app/services/comparison/comparison_report.h"
#include "app/services/comparison/comparison_run.h"
#include "assessment/results/number_format.h"
#include "sim/core/angle.h"
#include "sim/core/clock.h"
#include "sim/core/error.h"

namespace torsio::cli {

namespace {

struct OrganComparison {
  OrganArguments organ;
  ComparisonOptions options;
  std::string calibration = "equilibrium";
  std::string markers;
  std::string ends = "clamped-turned";
  std::string measured;
  std::string out;
  bool json = false;
};

void printComparison(const ComparisonResult& result, const std::string& out) {
  std::cout << result.organ << ", " << formatFixed(result.torque_Nm, 5) << " N m, "
            << result.machine.processor << ", " << result.machine.cores << " cores, load "
            << formatFixed(result.machine.loadAverage, 2) << "\n";
  for (const ModelResult& model : result.models) {
    std::cout << model.id << ": " << formatFixed(degrees(model.settled.angle_rad), 2) << " deg, frame "
              << formatFixed(1e3 * model.frameMedian_s, 4) << " ms, twist "
              << formatFixed(model.deformation_s, 4) << " s, set-up " << formatFixed(model.setUp_s, 3)
              << " s, RMSE " << formatFixed(1e3 * model.settled.rmse_m, 3) << " mm, roughness "
              << formatFixed(1e3 * model.settled.roughness_m, 4) << " mm\n";
  }
  for (const Text& sentence : comparisonOrder(result)) {
    std::cout << sentence.str() << "\n";
  }
  const double fem_s = result.model("fem").frameMedian_s;
  std::cout << "a frame of the finite elements takes " << formatFixed(fem_s / result.latticeUpdate_s, 0)
            << " updates of the twist model's lattice, "
            << formatFixed(fem_s / result.model("pm").frameMedian_s, 0) << " of its whole view\n"
            << "the report is " << out << "/" << kComparisonReportName << "\n";
}

void runCompare(OrganComparison arguments) {
  arguments.organ.ridges = arguments.organ.ridges.value_or(kComparedRidges);
  arguments.organ.sections = arguments.organ.sections.value_or(kComparedSections);
  arguments.options.springs.calibration =
      arguments.calibration == "affine" ? Calibration::kAffine : Calibration::kEquilibrium;
  if (arguments.options.grasp && arguments.ends == "clamped-turned") {
    refuseUsage("with --ends clamped-turned the upper face is turned, nothing is gripped", "--grasp",
                "Leave it out, or give --ends clamped-free");
  }
  const SceneRequest request = sceneRequest(arguments.organ);
  const Scene scene = loadScene(request);
  if (arguments.ends == "clamped-free") {
    arguments.options.grasp = arguments.options.grasp.value_or(scene.pattern.graspArc);
  }
  std::vector<OrganMarker> markers;
  if (!arguments.markers.empty()) {
    markers = readMarkers(arguments.markers, scene);
  } else if (!request.organFile) {
    markers = readOrganMarkers(request.assets, scene);
  }
  std::vector<MeasuredSubject> measured;
  if (!arguments.measured.empty()) {
    measured = readMeasuredMarkers(arguments.measured, markers, arguments.options.unitConfirmed);
  }
  ComparisonResult result;
  {
    ProgressLine line;
    result = runComparison(scene, markers, measured, arguments.options,
                           [&line](const Progress& progress) { line.show(progress); });
  }
  writeComparisonFiles(result, arguments.out);
  writePdfReport(comparisonReport(result, softwareVersion(), utcNow_us()),
                 std::filesystem::path(arguments.out) / kComparisonReportName);
  if (arguments.json) {
    std::cout << comparisonJson(result);
  } else {
    printComparison(result, arguments.out);
  }
}

}  // namespace

void addCompare(CLI::App& program) {
  auto arguments = std::make_shared<OrganComparison>();
  CLI::App* command = program.add_subcommand(
      "compare", "Twist an organ by the twist model, the rod, finite elements and springs under one torque");
  addOrganOptions(*command, arguments->organ);
  command->add_option(
      "--torque", arguments->options.torque_Nm,
      "At the turned end or jaw, N m; default: reaches the pattern's angle by the twist model");
  addDefaulted(*command, "--ends", arguments->ends,
               "clamped-turned (the upper face is turned in its place) or clamped-free (a jaw at --grasp "
               "turns the organ, all else is free)",
               CLI::IsMember({"clamped-turned", "clamped-free"}));
  command->add_option("--grasp", arguments->options.grasp,
                      "Middle of the jaw, fraction of the length; default: the pattern's");
  command->add_option("--out", arguments->out, "Folder for comparison.pdf, comparison.json and tables")
      ->required();
  command->add_option("--markers", arguments->markers,
                      "Markers on the organ, JSON as the window saves them; default: the organ's own");
  command->add_option("--measured", arguments->measured,
                      "Markers of real limbs, CSV: marker, time, x, y, z, unit, subject; or a camera marker "
                      "file (TRC)");
  command->add_flag("--unit-confirmed", arguments->options.unitConfirmed,
                    "The unit in --measured is right although the markers move as no skin does");
  addDefaulted(*command, "--nu", arguments->options.poissonRatio, "Poisson's ratio of the elements");
  addDefaulted(*command, "--ramp", arguments->options.ramp_s, "Seconds in which the torque grows");
  addDefaulted(*command, "--rings", arguments->options.rings, "Rings of elements and springs in a section");
  addDefaulted(*command, "--reference-rings", arguments->options.referenceRings, "Rings of the reference",
               CLI::Range(1, 12));
  addDefaulted(*command, "--substeps", arguments->options.springs.substeps,
               "Substeps of the springs per frame");
  addDefaulted(*command, "--calibration", arguments->calibration,
               "Calibration of the springs: equilibrium (the angle of a small torque) or affine (energy)",
               CLI::IsMember({"affine", "equilibrium"}));
  command->add_flag("--json", arguments->json, "Print comparison.json");
  command->callback([arguments] { runCompare(*arguments); });
}

}  // namespace torsio::cli
