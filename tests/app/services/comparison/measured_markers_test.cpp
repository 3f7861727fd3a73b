// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/comparison/measured_markers.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/comparison/organ_markers.h"
#include "sim/core/error.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;

const fs::path kSynthetic = fs::path(TORSIO_TEST_DATA) / "comparison" / "markers_synthetic.csv";

/// Ten markers: only numbers and names matter here.
std::vector<OrganMarker> tenMarkers() {
  std::vector<OrganMarker> markers(10);
  for (int k = 0; k < 10; ++k) {
    markers[static_cast<std::size_t>(k)].number = k + 1;
    markers[static_cast<std::size_t>(k)].name = "point " + std::to_string(k + 1);
  }
  return markers;
}

/// Returns where a table of these rows is rejected; "" if it is not.
std::string refusedAt(const std::string& rows) {
  const fs::path file = fs::temp_directory_path() / "torsio_measured_markers_test.csv";
  std::ofstream(file) << "marker,time,x,y,z,unit,subject\n" << rows;
  try {
    static_cast<void>(readMeasuredMarkers(file, tenMarkers()));
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadData);
    EXPECT_FALSE(error.remedy().empty());
    return fs::path(error.where()).filename().string();
  }
  return "";
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
  EXPECT_EQ(refusedAt("1,0,1,2,3,m,A\n1,1,1,2,3,cm,A\n"), "");
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

}  // namespace
}  // namespace torsio
