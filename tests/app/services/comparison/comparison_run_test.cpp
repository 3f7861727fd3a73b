// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/comparison/comparison_run.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <optional>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/services/comparison/comparison_report.h"
#include "sim/core/error.h"

namespace torsio {
namespace {

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

  ASSERT_EQ(report.sections.size(), 3U);
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

}  // namespace
}  // namespace torsio
