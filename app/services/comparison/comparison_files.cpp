// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/comparison/comparison_files.h"

#include <algorithm>
#include <optional>

#include <nlohmann/json.hpp>

#include "app/services/base/csv_table.h"
#include "app/services/comparison/comparison_order.h"
#include "assessment/results/number_format.h"
#include "sim/core/file_io.h"

namespace torsio {

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

Json meshJson(const ComparedMesh& mesh) {
  const Json none{{"undefined", mesh.noEquilibrium.str()}};
  return {{"model", mesh.model},
          {"ridges", mesh.ridges},
          {"sections", mesh.sections},
          {"rings", mesh.rings},
          {"unknowns", mesh.unknowns},
          {"angle_rad", mesh.noEquilibrium.empty() ? Json(mesh.angle_rad) : none},
          {"marker_rmse_m", !mesh.noEquilibrium.empty() ? none
                            : mesh.markerRmse_m         ? Json(*mesh.markerRmse_m)
                                                        : noMarker()},
          {"settle_s", mesh.settle_s}};
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

std::string meshesCsv(const ComparisonResult& result) {
  std::string text = plainLine(
      {"model", "ridges", "sections", "rings", "unknowns", "angle_rad", "marker_rmse_m", "settle_s"});
  for (const ComparedMesh& mesh : result.meshes) {
    const bool found = mesh.noEquilibrium.empty();
    text += plainLine(
        {mesh.model, std::to_string(mesh.ridges), std::to_string(mesh.sections), std::to_string(mesh.rings),
         std::to_string(mesh.unknowns), found ? formatExact(mesh.angle_rad) : "",
         found && mesh.markerRmse_m ? formatExact(*mesh.markerRmse_m) : "", formatExact(mesh.settle_s)});
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
  json["machine"] = {
      {"processor", result.machine.processor},      {"cores", result.machine.cores},
      {"load_average", result.machine.loadAverage}, {"instruction_set_of_models", kComparedInstructions},
      {"compiler", result.machine.compiler},        {"flags", result.machine.flags}};
  const double fem_s = result.model("fem").frameMedian_s;
  json["speed"] = {
      {"pm_lattice_update_s", result.latticeUpdate_s},
      {"pm_view_frame_s", result.model("pm").frameMedian_s},
      {"fem_frame_over_pm_lattice_update", fem_s / result.latticeUpdate_s},
      {"fem_frame_over_pm_view_frame", fem_s / result.model("pm").frameMedian_s},
      {"msm_frame_over_pm_view_frame", result.model("msm").frameMedian_s / result.model("pm").frameMedian_s}};
  json["as_simulator_draws"] = {{"instruction_set", result.widest.instructionSet},
                                {"pm_view_frame_s", result.widest.pmFrame_s},
                                {"pm_lattice_update_s", result.widest.latticeUpdate_s}};
  json["models"] = Json::array();
  for (const ModelResult& model : result.models) {
    json["models"].push_back(modelJson(model, measuredRmse_m(result, model), tellsCourse(result)));
  }
  json["meshes"] = Json::array();
  for (const ComparedMesh& mesh : result.meshes) {
    json["meshes"].push_back(meshJson(mesh));
  }
  json["measured"] = measuredJson(result);
  if (result.options.unitConfirmed) {
    json["unit_confirmed"] = true;
  }
  return json.dump(2) + "\n";
}

std::vector<std::string> writeComparisonFiles(const ComparisonResult& result,
                                              const std::filesystem::path& folder) {
  ensureFolder(folder);
  writeFileAtomically(folder / "comparison.json", comparisonJson(result));
  writeFileAtomically(folder / "models.csv", modelsCsv(result));
  writeFileAtomically(folder / "meshes.csv", meshesCsv(result));
  writeFileAtomically(folder / "course.csv", courseCsv(result));
  writeFileAtomically(folder / "markers.csv", markersCsv(result));
  return {"comparison.json", "models.csv", "meshes.csv", "markers.csv", "course.csv"};
}

}  // namespace torsio
