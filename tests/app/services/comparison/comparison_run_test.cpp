// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/services/comparison/comparison_run.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/services/comparison/comparison_files.h"
#include "app/services/comparison/comparison_order.h"
#include "app/services/comparison/comparison_report.h"
#include "app/services/comparison/measured_markers.h"
#include "app/services/comparison/organ_markers.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/scene/organ_file.h"

namespace torsio {

namespace {

using ::testing::HasSubstr;
using ::testing::Not;

namespace fs = std::filesystem;

const fs::path kAssets = fs::path(TORSIO_SOURCE_DIR) / "assets";

Scene coarseForearm() {
  SceneRequest request;
  request.assets = kAssets;
  request.ridges = 12;
  request.sections = 9;
  return loadScene(request);
}

ComparisonOptions quick() {
  ComparisonOptions options;
  options.torque_Nm = -0.01;
  options.ramp_s = 0.2;
  options.rings = 2;
  options.springs.substeps = 4;
  return options;
}

class ComparisonOfTheForearm : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    const Scene scene = coarseForearm();
    const std::vector<OrganMarker> markers = readOrganMarkers(kAssets, scene);
    ComparisonOptions options = quick();
    options.poseEvery_s = 0.05;
    result_ = runComparison(
        scene, markers,
        readMeasuredMarkers(fs::path(TORSIO_TEST_DATA) / "comparison" / "markers_synthetic.csv", markers),
        options, [](const Progress& progress) { EXPECT_LE(progress.fraction, 1.0); });
  }
  static void TearDownTestSuite() { result_.reset(); }
  static std::optional<ComparisonResult> result_;
};
std::optional<ComparisonResult> ComparisonOfTheForearm::result_;

TEST_F(ComparisonOfTheForearm, TwistsEveryModelWithTheSameTorque) {
  ASSERT_EQ(result_->models.size(), 6U);
  for (const ModelResult& model : result_->models) {
    EXPECT_LT(model.settled.angle_rad, -0.05) << model.id;
    EXPECT_EQ(model.course.back().torque_Nm, -0.01) << model.id;
    EXPECT_EQ(model.settled.displacements_m.size(), 10U) << model.id;
    EXPECT_GT(model.deformation_s, 0.0) << model.id;
    EXPECT_GE(model.frames, 12) << model.id;
  }
}

TEST_F(ComparisonOfTheForearm, KeepsThePosesForDisplayWithTheirProcessingTimes) {
  for (const char* id : {"pm", "fem", "msm"}) {
    const ModelResult& model = result_->model(id);

    ASSERT_GE(model.poses.size(), 5U) << id;  // at least 0, 0.05, 0.1, 0.15 and 0.2 s
    EXPECT_EQ(model.poses.front().angle_rad, 0.0) << id;
    EXPECT_EQ(model.poses.front().processing_s, 0.0) << id;
    EXPECT_EQ(model.poses.back().angle_rad, model.moving.angle_rad) << id;
    EXPECT_NEAR(model.poses.back().processing_s, model.deformation_s, 1e-9) << id;
    EXPECT_EQ(model.poses.back().places.places_m.size(), 12U * 9U) << id;
  }
}

TEST_F(ComparisonOfTheForearm, MeasuresErrorsAgainstTheReference) {
  const ModelResult& reference = result_->model("reference");
  const ModelResult& twist = result_->model("pm");

  EXPECT_EQ(reference.settled.rmse_m, 0.0);
  // Saint-Venant compared with three dimensions: 2 % of the angle and 4 % of the stiffness for slender
  // organs.
  EXPECT_NEAR(twist.settled.angle_rad / reference.settled.angle_rad, 1.0, 0.06);
  // The paper's cone turns about 1.5 times as far, its rule for tapers even further.
  EXPECT_GT(result_->model("paper").settled.angle_rad / twist.settled.angle_rad, 1.4);
  // Such a coarse mesh of linear tetrahedra locks.
  EXPECT_LT(result_->model("fem").settled.angle_rad / reference.settled.angle_rad, 0.9);
  EXPECT_LT(twist.settled.rmse_m, result_->model("fem").settled.rmse_m);
}

TEST_F(ComparisonOfTheForearm, HasRowsOfCoarserMeshesForEachModelOfElementsOrSprings) {
  std::vector<std::string> rows;
  for (const ComparedMesh& mesh : result_->meshes) {
    rows.push_back(mesh.model + ' ' + std::to_string(mesh.ridges) + 'x' + std::to_string(mesh.sections) +
                   'x' + std::to_string(mesh.rings));
    EXPECT_GT(mesh.unknowns, 0) << rows.back();
    EXPECT_TRUE(!mesh.noEquilibrium.empty() || mesh.angle_rad < -0.005) << rows.back();
  }
  EXPECT_THAT(rows,
              ::testing::ElementsAre("reference 6x5x2", "reference 8x7x2", "reference 12x9x2", "fem 6x5x1",
                                     "fem 8x7x1", "fem 12x9x2", "msm 6x5x1", "msm 8x7x1", "msm 12x9x2"));
  const auto angleOf = [&](std::size_t row) { return std::abs(result_->meshes[row].angle_rad); };
  EXPECT_LT(angleOf(3), angleOf(5)) << "coarse tetrahedra lock";
  EXPECT_EQ(result_->meshes[5].angle_rad, result_->model("fem").settled.angle_rad);
  const auto json = nlohmann::json::parse(comparisonJson(*result_));
  EXPECT_EQ(json["meshes"].size(), 9U);
  EXPECT_GT(json["meshes"][3]["marker_rmse_m"], json["meshes"][5]["marker_rmse_m"]);
}

TEST_F(ComparisonOfTheForearm, TellsTheInstructionSetOfEveryTime) {
  const auto json = nlohmann::json::parse(comparisonJson(*result_));
  EXPECT_EQ(json["machine"]["instruction_set_of_models"], "portable");
  EXPECT_EQ(json["as_simulator_draws"]["instruction_set"], result_->widest.instructionSet);
  EXPECT_GT(json["as_simulator_draws"]["pm_view_frame_s"], 0.0);
  const ReportModel report = comparisonReport(*result_, "1.0", 0);
  EXPECT_THAT(report.sections[0].tables[0].notes.back().str(), HasSubstr("(portable)"));
  EXPECT_THAT(report.sections[0].tables[0].notes.back().str(), HasSubstr(result_->widest.instructionSet));
}

TEST_F(ComparisonOfTheForearm, DrawsItsTimesOnAnAxisOfMilliseconds) {
  const ReportFigure figure = comparisonReport(*result_, "1.0", 0).sections[0].figures[0];
  EXPECT_TRUE(figure.logarithmic);
  EXPECT_THAT(figure.yLabel.str(), HasSubstr("(ms)"));
  ASSERT_EQ(figure.series[0].y.size(), 6U);
  EXPECT_DOUBLE_EQ(*figure.series[0].y[1], 1e3 * result_->model("pm").deformation_s);
}

TEST_F(ComparisonOfTheForearm, HasPicturesOfEveryModelAtTheEndAndOnTheWay) {
  const ReportSection pictures = comparisonReport(*result_, "1.0", 0).sections[2];
  ASSERT_EQ(pictures.figures.size(), 3U);
  EXPECT_EQ(pictures.figures[0].series[0].reliefs[0].marks.size(), 10U);
  std::vector<std::string> captions;
  for (const FigureSeries& row : pictures.figures[1].series) {
    for (const ReportRelief& relief : row.reliefs) {
      captions.push_back(relief.caption.str());
      EXPECT_EQ(relief.places.size(), result_->body->mesh.vertices_m.size());
    }
  }
  ASSERT_EQ(captions.size(), 6U);
  EXPECT_THAT(captions[1], HasSubstr("PM, -"));
  ASSERT_EQ(pictures.figures[2].series.size(), 6U);
  for (const FigureSeries& row : pictures.figures[2].series) {
    ASSERT_EQ(row.reliefs.size(), 5U) << row.name.str();
    EXPECT_EQ(row.reliefs[0].caption.str(), "0.0\u00b0");
    EXPECT_NE(row.reliefs[0].places, row.reliefs[4].places) << row.name.str();
  }
}

TEST_F(ComparisonOfTheForearm, SaysTheOrderThatThisRunFinds) {
  ComparisonResult other = *result_;
  const auto modelOf = [&other](const std::string& id) -> ModelResult& {
    return *std::find_if(other.models.begin(), other.models.end(),
                         [&](const ModelResult& m) { return m.id == id; });
  };
  modelOf("pm").settled.markerRmse_m = 0.0009;
  modelOf("fem").settled.markerRmse_m = 0.00308;
  modelOf("msm").settled.markerRmse_m = 0.0151;
  const auto said = [](const ComparisonResult& result) {
    std::string all;
    for (const Text& sentence : comparisonOrder(result)) {
      all += sentence.str() + '\n';
    }
    return all;
  };
  EXPECT_THAT(said(other), HasSubstr("PM 0.90 mm, FEM 3.08 mm, MSM 15.10 mm"));
  EXPECT_THAT(said(other), HasSubstr("(PM before FEM before MSM) holds in this run"));
  EXPECT_THAT(said(other), HasSubstr("against the measured ones")) << "this run has measurements";
  EXPECT_EQ(nlohmann::json::parse(comparisonJson(other))["paper_order_holds"], true);

  modelOf("msm").settled.markerRmse_m = 0.00253;
  other.options.springs.calibration = Calibration::kEquilibrium;
  EXPECT_THAT(said(other), HasSubstr("PM 0.90 mm, MSM 2.53 mm, FEM 3.08 mm"));
  EXPECT_THAT(said(other), HasSubstr("does not hold in this run"));
  EXPECT_THAT(said(other), HasSubstr("springs calibrated by the angle of a small torque"));
  EXPECT_EQ(nlohmann::json::parse(comparisonJson(other))["paper_order_holds"], false);

  other.measured.clear();
  EXPECT_THAT(said(other), Not(HasSubstr("measured")));
}

TEST_F(ComparisonOfTheForearm, MeasuresEveryModelAgainstTheMeasuredMarkers) {
  const ModelResult& twist = result_->model("pm");
  double sum_m2 = 0.0;
  int markers = 0;
  for (std::size_t i = 0; i < result_->markers.size(); ++i) {
    const MeasuredDisplacement found = finalDisplacement(result_->measured, result_->markers[i].number);
    if (found.subjects > 0) {
      sum_m2 += std::pow(twist.settled.displacements_m[i] - found.mean_m, 2.0);
      ++markers;
    }
  }
  ASSERT_GT(markers, 0);
  EXPECT_NEAR(measuredRmse_m(*result_, twist).value(), std::sqrt(sum_m2 / markers), 1e-12);
  const ReportTable table = comparisonReport(*result_, "0", 0).sections[1].tables[0];
  EXPECT_EQ(table.columns.back().str(), "Measured (mm)");
  ComparisonResult unmeasured = *result_;
  unmeasured.measured.clear();
  EXPECT_FALSE(measuredRmse_m(unmeasured, twist));
}

TEST_F(ComparisonOfTheForearm, WritesJsonAndTables) {
  const fs::path folder = fs::temp_directory_path() / "torsio_comparison_test";
  fs::remove_all(folder);

  const std::vector<std::string> names = writeComparisonFiles(*result_, folder);

  for (const std::string& name : names) {
    EXPECT_GT(fs::file_size(folder / name), 100U) << name;
  }
  const auto json = nlohmann::json::parse(comparisonJson(*result_));
  EXPECT_EQ(json["models"].size(), 6U);
  EXPECT_EQ(json["models"][1]["id"], "pm");
  EXPECT_EQ(json["measured"].size(), 10U);
  EXPECT_GT(json["speed"]["fem_frame_over_pm_lattice_update"].get<double>(), 10.0);
  EXPECT_FALSE(json["machine"]["processor"].get<std::string>().empty());
  fs::remove_all(folder);
}

TEST_F(ComparisonOfTheForearm, ReportDrawsTheThreeFiguresOfThePaper) {
  const ReportModel report = comparisonReport(*result_, "0", 0);

  ASSERT_EQ(report.sections.size(), 4U);
  EXPECT_EQ(report.sections[0].figures[0].id, "figure-10");
  ASSERT_EQ(report.sections[1].figures.size(), 2U);
  EXPECT_EQ(report.sections[1].figures[0].series.size(), 7U);  // six models and the measurements
  EXPECT_EQ(report.sections[1].figures[1].series.size(), 8U);  // both subjects
  for (const std::vector<ReportCell>& row : report.sections[1].tables[0].rows) {
    EXPECT_EQ(row.size(), report.sections[1].tables[0].columns.size());
  }
  for (const ReportTable* table : {&report.sections[0].tables[0], &report.sections[1].tables[0]}) {
    for (const Text& column : table->columns) {
      EXPECT_TRUE(std::isupper(static_cast<unsigned char>(column.str().front()))) << column;
    }
  }
  for (const std::vector<ReportCell>& row : report.sections[0].tables[0].rows) {
    for (const std::size_t c : {3U, 4U}) {  // milliseconds, from the twist model's to those of finite
                                            // elements
      const std::string cell = row[c].str();
      EXPECT_LE(std::count_if(cell.begin(), cell.end(), [](char sign) { return sign >= '1' && sign <= '9'; }),
                5)
          << cell;
      EXPECT_TRUE(cell.size() < 5 || cell.find('.') == std::string::npos || cell.starts_with("0.")) << cell;
    }
  }
  std::set<std::string> names;
  for (const Text& name : report.sections[0].figures[0].categories) {
    EXPECT_TRUE(names.insert(name.str()).second) << "two models are called " << name;
  }
  EXPECT_TRUE(names.contains("rod"));
}

TEST(ComparisonRun, EndsWithinASecondAfterTheListenerCancels) {
  const Scene scene = coarseForearm();
  // A second of its own work, not counting how long a busy machine lets it wait.
  using SteadyClock = std::chrono::steady_clock;
  constexpr std::chrono::seconds kNeverSoLong{30};
  struct GivenUp {};
  // Cancelled at each stage: the reference, elements, springs, equilibrium.
  for (const double at : {0.05, 0.2, 0.5, 0.6}) {
    SteadyClock::time_point told;
    std::clock_t worked = 0;
    const auto progress = [&](const Progress& now) {
      if (now.fraction >= at) {
        told = SteadyClock::now();
        worked = std::clock();
        throw GivenUp{};
      }
    };

    EXPECT_THROW(static_cast<void>(runComparison(scene, {}, {}, quick(), progress)), GivenUp) << at;

    EXPECT_LT(static_cast<double>(std::clock() - worked) / CLOCKS_PER_SEC, 1.0) << at;
    EXPECT_LT(SteadyClock::now() - told, kNeverSoLong) << at;
  }
}

TEST(ComparisonRun, RejectsOptionsOutOfRange) {
  const Scene scene = coarseForearm();
  const auto refused = [&](ComparisonOptions options) {
    EXPECT_THROW(static_cast<void>(runComparison(scene, {}, {}, options, {})), Error);
  };
  ComparisonOptions torque = quick();
  torque.torque_Nm = 0.0;
  ComparisonOptions ramp = quick();
  ramp.ramp_s = 0.0;
  ComparisonOptions rings = quick();
  rings.rings = 0;
  ComparisonOptions substeps = quick();
  substeps.springs.substeps = 0;
  ComparisonOptions poisson = quick();
  poisson.poissonRatio = 0.5;

  refused(torque);
  refused(ramp);
  refused(rings);
  refused(substeps);
  refused(poisson);
}

const Scene& forearm() {
  static const Scene kScene = coarseForearm();
  return kScene;
}

fs::path markerFile() {
  return fs::temp_directory_path() / "torsio_organ_markers_test.json";
}

/// Returns where a file of these bytes is rejected, without its folder; "" if it is not.
std::string markersRefusedAt(const std::string& bytes) {
  std::ofstream(markerFile()) << bytes;
  try {
    static_cast<void>(readMarkers(markerFile(), forearm()));
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadData) << bytes;
    EXPECT_FALSE(error.remedy().empty()) << bytes;
    return fs::path(error.where()).filename().string();
  }
  return "";
}

std::string oneMarker(const std::string& fields) {
  return R"({"markers": [{)" + fields + "}]}";
}

TEST(OrganMarkers, OfTheForearmAreTenPointsOfItsSurface) {
  const std::vector<OrganMarker> markers = readOrganMarkers(kAssets, forearm());

  ASSERT_EQ(markers.size(), 10U);
  EXPECT_EQ(markers[7].number, 8);
  EXPECT_EQ(markers[7].name, "second knuckle (index metacarpal head)");
  // assets/organs/forearm_markers.json has hundredths of a millimetre.
  EXPECT_NEAR(norm(markers[7].position_m - Vec3{0.03626, 0.01493, 0.35160}), 0.0, 1e-4);
}

TEST(OrganMarkers, AreSharedOnlyByTheScenesOfOneOrgan) {
  SceneRequest request;
  request.assets = kAssets;
  request.id = "small-bowel-loop";
  const Scene loop = loadScene(request);
  EXPECT_EQ(readOrganMarkers(kAssets, loop).size(), 10U);
  request.former = true;
  EXPECT_TRUE(readOrganMarkers(kAssets, loadScene(request)).empty());

  // A user's organ with the forearm's patterns is not the forearm.
  OrganFile organ;
  organ.source = "arm.ply";
  organ.mesh = forearm().mesh;
  organ.anatomy = "forearm";
  organ.ends = {.fixedEnd_m = Vec3{}, .freeEnd_m = Vec3{0, 0, 0.262}, .fixedCut = {}, .freeCut = {0, 0, 1}};
  const fs::path file = fs::temp_directory_path() / "torsio_organ_markers_test.organ";
  writeOrganFile(file, organ);
  SceneRequest own;
  own.assets = kAssets;
  own.organFile = file;
  EXPECT_TRUE(readOrganMarkers(kAssets, loadScene(own)).empty());
}

TEST(OrganMarkers, AreReadAsTheyWereWritten) {
  const std::vector<OrganMarker> before = spreadMarkers(forearm());

  writeMarkers(markerFile(), before, forearm());
  const std::vector<OrganMarker> after = readMarkers(markerFile(), forearm());

  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(after[i].name, before[i].name);
    EXPECT_EQ(after[i].face, before[i].face);
    EXPECT_EQ(after[i].barycentric, before[i].barycentric);
    EXPECT_EQ(norm(after[i].position_m - before[i].position_m), 0.0);
  }
}

TEST(OrganMarkers, OfAnOrganWithoutAnyAreTenDifferentPoints) {
  const std::vector<OrganMarker> markers = spreadMarkers(forearm());

  ASSERT_EQ(markers.size(), 10U);
  std::set<std::string> names;
  for (const OrganMarker& marker : markers) {
    names.insert(marker.name);
  }
  EXPECT_EQ(names.size(), 10U);
  // At 0.1, 0.3 ... of about 262 mm between elbow and wrist; the two ridges are on opposite sides.
  EXPECT_NEAR(markers[0].position_m.z, 0.1 * 0.262, 1e-3);
  EXPECT_GT(markers[0].position_m.x, 0.02);
  EXPECT_LT(markers[1].position_m.x, -0.02);
}

TEST(OrganMarkers, ReportInvalidFilesWithTheirPlace) {
  const std::string file = "torsio_organ_markers_test.json";
  const std::string place = R"("face": 0, "barycentric": [0.2, 0.3, 0.5])";

  EXPECT_EQ(markersRefusedAt(oneMarker(R"("number": 1, "name": "a", )" + place)), "");
  EXPECT_EQ(markersRefusedAt("{"), file);
  EXPECT_EQ(markersRefusedAt("[1]"), file);
  EXPECT_EQ(markersRefusedAt(R"({"markers": []})"), file);
  EXPECT_EQ(markersRefusedAt(R"({"organ_hash": "another", "markers": []})"), file);
  EXPECT_EQ(markersRefusedAt(oneMarker(R"("number": 2, "name": "a", )" + place)),
            file + ", marker 1, field \"number\"");
  EXPECT_EQ(markersRefusedAt(oneMarker(R"("number": 1, "name": " ", )" + place)),
            file + ", marker 1, field \"name\"");
  EXPECT_EQ(markersRefusedAt(oneMarker(R"("number": 1, "name": "a", "face": -1, "barycentric": [1, 0, 0])")),
            file + ", marker 1, field \"face\"");
  EXPECT_EQ(markersRefusedAt(oneMarker(R"("number": 1, "name": "a", "face": 0)")),
            file + ", marker 1, field \"barycentric\"");
  EXPECT_EQ(markersRefusedAt(oneMarker(R"("number": 1, "name": "a", "face": 0, "barycentric": [1, 0.1, 0])")),
            file + ", marker 1, field \"barycentric\"");
  EXPECT_EQ(markersRefusedAt(oneMarker(R"("number": 1, "name": "a", "face": 0, "barycentric": [1, "b", 0])")),
            file + ", marker 1, field \"barycentric\"");
  EXPECT_EQ(markersRefusedAt(oneMarker(R"("number": 1, "name": "a", "position_mm": [0, 0, 100])")),
            file + ", marker 1, field \"position_mm\"")
      << "on the axis";
  EXPECT_EQ(markersRefusedAt(oneMarker(R"("number": 1, "name": "a")")),
            file + ", marker 1, field \"position_mm\"");
  EXPECT_EQ(markersRefusedAt(R"({"markers": [{"number": 1, "name": "a", )" + place +
                             R"(}, {"number": 2, "name": "a", )" + place + "}]}"),
            file + ", marker 2, field \"name\"");
}

const fs::path kSynthetic = fs::path(TORSIO_TEST_DATA) / "comparison" / "markers_synthetic.csv";

/// Ten markers: only numbers and names matter here.
std::vector<OrganMarker> tenMarkers() {
  std::vector<OrganMarker> markers(10);
  for (int k = 0; k < 10; ++k) {
    markers[static_cast<std::size_t>(k)].number = k + 1;
    markers[static_cast<std::size_t>(k)].name = k == 2 ? "radial styloid" : "point " + std::to_string(k + 1);
  }
  return markers;
}

/// Returns where a file of this name and text is rejected; "" if it is not.
std::string refusedIn(const std::string& name, const std::string& text) {
  const fs::path file = fs::temp_directory_path() / name;
  std::ofstream(file) << text;
  try {
    static_cast<void>(readMeasuredMarkers(file, tenMarkers()));
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadData);
    EXPECT_FALSE(error.remedy().empty());
    return fs::path(error.where()).filename().string();
  }
  return "";
}

/// Returns where a table of these rows is rejected; "" if it is not.
std::string refusedAt(const std::string& rows) {
  return refusedIn("torsio_measured_markers_test.csv", "marker,time,x,y,z,unit,subject\n" + rows);
}

TEST(MeasuredMarkers, AreReadInMetresWithTheirSubjects) {
  const std::vector<MeasuredSubject> subjects = readMeasuredMarkers(kSynthetic, tenMarkers());

  ASSERT_EQ(subjects.size(), 2U);
  EXPECT_EQ(subjects[0].name, "SYNTHETIC-A");
  ASSERT_EQ(subjects[0].markers.size(), 10U);
  ASSERT_EQ(subjects[0].markers.at(8).size(), 6U);
  EXPECT_NEAR(norm(subjects[0].markers.at(8)[0].place_m - Vec3{0.03626, 0.01493, 0.35160}), 0.0, 1e-9);
}

TEST(MeasuredMarkers, DisplacementIsTheMeanOverTheSubjects) {
  const std::vector<MeasuredSubject> subjects = readMeasuredMarkers(kSynthetic, tenMarkers());

  const MeasuredDisplacement found = finalDisplacement(subjects, 8);

  // Marker 8 is beyond the wrist, 39.21 mm off the axis, rotated by 60 and 54 degrees: chords 2 r sin(a / 2)
  // of 39.21 and 35.60 mm.
  EXPECT_EQ(found.subjects, 2);
  EXPECT_NEAR(found.mean_m, 0.5 * (39.21e-3 + 35.60e-3), 2e-5);
  EXPECT_EQ(finalDisplacement({}, 8).subjects, 0);
}

TEST(MeasuredMarkers, AcceptMetresAndCentimetres) {
  EXPECT_EQ(refusedAt("1,0,0.1,0.2,0.3,m,A\n1,1,10,20,35,cm,A\n"), "");
}

TEST(MeasuredMarkers, AWayThatNoSkinMakesNamesTheUnitThatFits) {
  const std::string metres = "marker,time,x,y,z,unit,subject\n1,0,0,0,350,m,A\n1,1,20,0,340,m,A\n";
  EXPECT_EQ(refusedIn("torsio_measured_unit_test.csv", metres), "torsio_measured_unit_test.csv");
  const fs::path file = fs::temp_directory_path() / "torsio_measured_unit_test.csv";
  try {
    static_cast<void>(readMeasuredMarkers(file, tenMarkers()));
  } catch (const Error& error) {
    EXPECT_EQ(error.happened(),
              "the markers of 'A' would have moved 2.236e+04 mm at most: 0.5 to 1500 mm is plausible");
    EXPECT_NE(error.remedy().find("(\"cm\", \"mm\" would fit)"), std::string::npos) << error.remedy();
  }
  EXPECT_EQ(readMeasuredMarkers(file, tenMarkers(), true).size(), 1U) << "confirmed";
}

TEST(MeasuredMarkers, ReportInvalidTablesWithTheirPlace) {
  EXPECT_EQ(refusedAt("11,0,1,2,3,mm,A\n"), "torsio_measured_markers_test.csv, line 2");
  EXPECT_EQ(refusedAt("1,0,1,2,3,mm,A\n1,0,1,2,3,mm,A\n"), "torsio_measured_markers_test.csv, line 3");
  EXPECT_EQ(refusedAt("1,-1,1,2,3,mm,A\n"), "torsio_measured_markers_test.csv, line 2");
  EXPECT_EQ(refusedAt("1,0,1,2,3,inch,A\n"), "torsio_measured_markers_test.csv, line 2");
  EXPECT_EQ(refusedAt("1,0,1,nan,3,mm,A\n"), "torsio_measured_markers_test.csv, line 2");
  EXPECT_EQ(refusedAt("1,0,1,2,3,mm,\n"), "torsio_measured_markers_test.csv, line 2");
  EXPECT_NE(refusedAt("1,0,1,2,3,mm,A\n"), "");
  EXPECT_NE(refusedAt(""), "");
  EXPECT_THROW(static_cast<void>(readMeasuredMarkers(kSynthetic, {})), Error);
}

const fs::path kTracks = fs::path(TORSIO_TEST_DATA) / "comparison" / "markers_synthetic.trc";

/// Returns where the synthetic file is rejected after replacing `from` by `to`; "" if it is not.
std::string refusedWith(const std::string& from, const std::string& to) {
  std::string text = readFile(kTracks);
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  return refusedIn("torsio_camera_markers_test.trc", text);
}

TEST(CameraMarkers, AreReadInMetresByNumberAndByName) {
  const std::vector<MeasuredSubject> subjects = readMeasuredMarkers(kTracks, tenMarkers());

  ASSERT_EQ(subjects.size(), 1U);
  EXPECT_EQ(subjects[0].name, "markers_synthetic");
  ASSERT_EQ(subjects[0].markers.size(), 3U);
  EXPECT_EQ(subjects[0].markers.at(1).size(), 5U);
  EXPECT_EQ(subjects[0].markers.at(3).size(), 4U) << "lost in one frame";
  EXPECT_NEAR(norm(subjects[0].markers.at(8)[0].place_m - Vec3{0.03626, 0.01493, 0.35160}), 0.0, 1e-9);
  EXPECT_DOUBLE_EQ(subjects[0].markers.at(8)[4].time_s, 0.04);
  // 39.21 mm off the axis, rotated by 60 degrees: the chord equals the radius.
  EXPECT_NEAR(finalDisplacement(subjects, 8).mean_m, 39.21e-3, 2e-5);
  EXPECT_EQ(finalDisplacement(subjects, 1).mean_m, 0.0);
}

TEST(CameraMarkers, ReportInvalidFilesWithLineAndField) {
  const std::string file = "torsio_camera_markers_test.trc, line ";
  const auto at = [&](int line, const std::string& field) {
    return file + std::to_string(line) + ", field \"" + field + "\"";
  };

  EXPECT_EQ(refusedWith("(X/Y/Z)", "(X/Y)"), at(1, "PathFileType"));
  EXPECT_EQ(refusedWith("NumMarkers", "Markers"), at(2, "NumMarkers"));
  EXPECT_EQ(refusedWith("\tmm\t", "\tinch\t"), at(3, "Units"));
  EXPECT_EQ(refusedWith("100.00\t100.00\t5", "0\t100.00\t5"), at(3, "DataRate"));
  EXPECT_EQ(refusedWith("100.00\t100.00\t5", "100.00\t100.00\t6"), at(3, "NumFrames"));
  EXPECT_EQ(refusedWith("100.00\t100.00\t5\t3", "100.00\t100.00\t5\t2"), at(4, "NumMarkers"));
  EXPECT_EQ(refusedWith("M1", "LASI"), at(4, "LASI"));
  EXPECT_EQ(refusedWith("Marker8", "marker1"), at(4, "marker1"));
  EXPECT_EQ(refusedWith("Y2", "Y3"), at(5, "Y2"));
  EXPECT_EQ(refusedWith("24.590", "nan"), at(7, "Y1"));
  EXPECT_EQ(refusedWith("\n2\t0.010\t", "\n2\t0.000\t"), at(8, "Time"));
  EXPECT_EQ(refusedWith("\n2\t0.010\t", "\n2\tnow\t"), at(8, "Time"));
  EXPECT_EQ(refusedWith("PathFileType\t4\t(X/Y/Z)\t", "PathFileType\t4\t(X/Y/Z)\tother "), "");
}

}  // namespace

}  // namespace torsio
