// SPDX-License-Identifier: GPL-3.0-or-later
// Users' meshes through the program: which become organs, and the results.
#include <algorithm>
#include <cctype>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/geometry/mesh/mesh_export.h"
#include "sim/geometry/mesh/triangle_mesh.h"
#include "tests/app/cli/program.h"
#include "tests/support/dicom_files.h"
#include "tests/support/mesh_formats.h"
#include "tests/support/procedural_mesh.h"
#include "tests/support/scan_files.h"

namespace torsio::test {

namespace {

nlohmann::json importOf(const std::string& words, const std::filesystem::path& folder, int code) {
  const ProgramRun run = runTorsio("organ import --json " + words, folder);
  EXPECT_EQ(run.code, code) << run.err;
  return nlohmann::json::parse(run.out, nullptr, false);
}

TEST(OrganCommand, RejectsABallWithReasonsAndWritesNothing) {
  const auto folder = emptyFolder("organ-ball");
  const auto mesh = folder / "ball.ply";
  writePly(mesh, testing::capsule(0.05, 0.005, 48, 8));
  const auto organ = folder / "ball.organ";

  const auto import = importOf(mesh.string() + " --out " + organ.string(), folder, 6);

  EXPECT_FALSE(import.at("accepted").get<bool>());
  ASSERT_FALSE(import.at("findings").empty());
  for (const auto& finding : import.at("findings")) {
    for (const char* key : {"code", "where", "value", "remedy"}) {
      EXPECT_TRUE(finding.contains(key)) << key;
    }
  }
  EXPECT_EQ(import.at("findings")[0].at("code"), "M20");
  EXPECT_GT(import.at("volume_ml").get<double>(), 500.0);
  EXPECT_FALSE(std::filesystem::exists(organ));
  EXPECT_EQ(runTorsio("twist --organ " + mesh.string() + " --angle 20", folder).code, 6);
}

TEST(OrganCommand, MakesAnOrganFileThatTwistsLikeItsMesh) {
  const auto folder = emptyFolder("organ-bar");
  const auto mesh = folder / "bar.ply";
  writePly(mesh, testing::prism(testing::circleOutline(0.03, 36), 0.2, 12));
  const auto organ = folder / "bar.organ";

  const auto import = importOf(mesh.string() + " --wall 3 --out " + organ.string(), folder, 0);
  EXPECT_TRUE(import.at("accepted").get<bool>());
  EXPECT_TRUE(import.at("warnings").empty());
  EXPECT_TRUE(import.at("repairs").empty());
  EXPECT_NEAR(import.at("det_f_min_60").get<double>(), 1.0, 1e-6);

  const ProgramRun asMesh = runTorsio("twist --json --angle 30 --organ " + mesh.string(), folder);
  const ProgramRun asOrgan = runTorsio("twist --json --angle 30 --organ " + organ.string(), folder);
  ASSERT_EQ(asOrgan.code, 0) << asOrgan.err;
  const auto first = nlohmann::json::parse(asMesh.out);
  const auto second = nlohmann::json::parse(asOrgan.out);
  EXPECT_EQ(second.at("pattern"), "own-axis");
  EXPECT_EQ(first.at("torque_nm"), second.at("torque_nm"));
  EXPECT_EQ(first.at("profile"), second.at("profile"));
  // Its wall is used when it is twisted between its ends.
  const ProgramRun wrung =
      runTorsio("twist --json --angle 10 --ends clamped-turned --organ " + organ.string(), folder);
  ASSERT_EQ(wrung.code, 0) << wrung.err;
  EXPECT_EQ(nlohmann::json::parse(wrung.out).at("model"), "hollow");
  EXPECT_EQ(runTorsio("twist --angle 30 --pattern pronation --organ " + organ.string(), folder).code,
            static_cast<int>(ErrorCode::kBadParameter));
}

TEST(OrganCommand, PrintsWhatEachPatternDoesAndOffersOnlyThoseThatLeaveItWhole) {
  const auto folder = emptyFolder("organ-patterns");
  const auto mesh = folder / "arch.ply";
  writePly(mesh, testing::bentTube(0.03, 0.045, 2.6, 40, 60));
  const auto organ = folder / "arch.organ";

  const auto refused = importOf(mesh.string() + " --anatomy intestine", folder, 6);
  ASSERT_EQ(refused.at("patterns").size(), 1U);
  const auto& loop = refused.at("patterns")[0];
  EXPECT_EQ(loop.at("id"), "loop");
  EXPECT_FALSE(loop.at("accepted").get<bool>());
  EXPECT_FALSE(loop.at("reason").get<std::string>().empty());
  EXPECT_GT(loop.at("angle_deg").get<double>(), 90.0);
  EXPECT_LT(loop.at("angle_deg").get<double>(), 180.0);

  const auto accepted = importOf(mesh.string() + " --anatomy stomach --out " + organ.string(), folder, 0);
  int offered = 0;
  for (const auto& pattern : accepted.at("patterns")) {
    const std::string id = pattern.at("id").get<std::string>();
    if (!pattern.at("accepted").get<bool>()) {
      continue;
    }
    ++offered;
    EXPECT_GE(pattern.at("det_f_min").get<double>(), 0.2) << id;
    EXPECT_EQ(pattern.at("crossings"), 0) << id;
    EXPECT_NEAR(pattern.at("volume_ratio").get<double>(), 1.0, 0.02) << id;
    EXPECT_FALSE(pattern.contains("reason")) << id;
    // To the target, and by the smallest turn.
    for (const char* angle : {"", " --angle=-0.01"}) {
      const ProgramRun twisted =
          runTorsio("twist --json --pattern " + id + angle + " --organ " + organ.string(), folder);
      EXPECT_EQ(twisted.code, 0) << id << angle << ": " << twisted.err;
    }
  }
  EXPECT_GE(offered, 2);
}

TEST(OrganCommand, SaysWhetherATwistIsValidAndWhichLimitItIsBeyond) {
  const auto folder = emptyFolder("organ-valid");
  const auto twist = [&folder](const std::string& words) {
    const ProgramRun run = runTorsio("twist --json " + words, folder);
    EXPECT_EQ(run.code, 0) << run.err;
    return nlohmann::json::parse(run.out);
  };

  const auto good = twist("--organ stomach --pattern partial");
  EXPECT_TRUE(good.at("valid").get<bool>());
  EXPECT_FALSE(good.contains("beyond"));
  const auto folded = twist("--organ stomach --ends clamped-turned --angle 310 --allow-fold");
  EXPECT_FALSE(folded.at("valid").get<bool>());
  EXPECT_EQ(folded.at("beyond"), folded.at("fold"));
  const auto packed = twist("--organ intestine --ends clamped-turned --wall 2 --angle 720");
  EXPECT_FALSE(packed.at("valid").get<bool>());
  EXPECT_NE(packed.at("beyond").get<std::string>().find("packed with wall"), std::string::npos);
  const auto blown = twist("--organ intestine --ends clamped-turned --wall 1 --angle 5 --pressure-mmhg 12");
  EXPECT_FALSE(blown.at("valid").get<bool>());
  EXPECT_NE(blown.at("beyond").get<std::string>().find("checked up to 2.1"), std::string::npos);
  const auto closed = twist("--organ small-bowel-loop --angle 360");
  EXPECT_FALSE(closed.at("valid").get<bool>());
  // Until they fold, all are as checked; folded under their gas, or shut, they are not.
  for (const char* taut :
       {"small-bowel-loop --angle 180", "small-bowel-loop --angle=-210", "gastric-organo-axial --angle=-210",
        "gastric-mesentero-axial --angle 90", "sigmoid --angle 80"}) {
    const auto checked = twist(std::string("--organ ") + taut);
    EXPECT_TRUE(checked.at("valid").get<bool>()) << taut;
    EXPECT_EQ(checked.at("torque_error_range").size(), 2U) << taut;
    EXPECT_LT(checked.at("torque_error_range").at(1), 0.1) << taut;
  }
  const auto folds = twist("--organ gastric-mesentero-axial --angle 130");
  EXPECT_NE(folds.at("beyond").get<std::string>().find("folds are checked up to 0.5"), std::string::npos);
  EXPECT_FALSE(folds.contains("torque_error_range"));
  EXPECT_TRUE(twist("--organ testis --angle 30").at("valid").get<bool>());
  // Each angle beyond closing says so, however far.
  for (const char* angle : {"180", "250", "720"}) {
    const auto rope = twist(std::string("--organ intestine --ends clamped-turned --wall 2 --angle ") + angle);
    EXPECT_NE(rope.at("beyond").get<std::string>().find("order of size only"), std::string::npos) << angle;
  }

  const ProgramRun text = runTorsio("twist --organ small-bowel-loop --angle 360", folder);
  EXPECT_NE(text.out.find("valid = false"), std::string::npos);
  EXPECT_NE(text.out.find("beyond = "), std::string::npos);
}

TEST(OrganCommand, MakesAnArmWithAPersonsMeasurementsThatTwists) {
  const auto folder = emptyFolder("organ-arm");
  const auto organ = folder / "arm.organ";

  const ProgramRun made = runTorsio(
      "organ make arm --wrist-width 56 --wrist-thickness 40 --fingers 50 64 71 66 "
      "53 --json --out " +
          organ.string(),
      folder);

  ASSERT_EQ(made.code, 0) << made.err;
  const auto arm = nlohmann::json::parse(made.out);
  EXPECT_TRUE(arm.at("accepted").get<bool>());
  EXPECT_GT(arm.at("volume_ml").get<double>(), 900.0);  // a man's 1 523 ml, girths scaled by 0.86
  EXPECT_LT(arm.at("volume_ml").get<double>(), 1300.0);
  // Its landmarks are data, like those of the shipped arm.
  const auto landmarks = nlohmann::json::parse(readFile(folder / "arm_markers.json"));
  EXPECT_EQ(landmarks.at("organ"), "arm.organ");
  EXPECT_GT(landmarks.at("zero_line_mm").size(), 20U);
  ASSERT_EQ(landmarks.at("markers").size(), 10U);
  for (const auto& marker : landmarks.at("markers")) {
    EXPECT_GT(marker.at("arc_mm").get<double>(), 100.0);
    EXPECT_TRUE(marker.contains("angle_deg"));
  }
  const ProgramRun twisted = runTorsio("twist --json --pattern pronation --organ " + organ.string(), folder);
  ASSERT_EQ(twisted.code, 0) << twisted.err;
  EXPECT_FALSE(nlohmann::json::parse(twisted.out).at("folded").get<bool>());
  EXPECT_EQ(runTorsio("organ make arm --wrist-width 20", folder).code, static_cast<int>(ErrorCode::kUsage));
  EXPECT_EQ(runTorsio("organ make arm --fingers 50 64", folder).code, static_cast<int>(ErrorCode::kUsage));
}

TEST(OrganCommand, StoresAWarningWithRecordings) {
  const auto folder = emptyFolder("organ-short");
  const auto mesh = folder / "short.ply";
  writePly(mesh, testing::prism(testing::circleOutline(0.05, 48), 0.2, 24));
  const std::string database = " --database " + (folder / "torsio.sqlite").string();
  const std::string organ = " --organ " + mesh.string();

  const ProgramRun recorded = runTorsio("record --json --duration 2" + organ + database, folder);
  ASSERT_EQ(recorded.code, 0) << recorded.err;
  const auto trial = nlohmann::json::parse(recorded.out);
  ASSERT_EQ(trial.at("organ_warnings").size(), 1U);
  EXPECT_TRUE(trial.at("organ_warnings")[0].get<std::string>().starts_with("M20"));
  EXPECT_EQ(trial.at("pattern"), "own-axis");

  const ProgramRun replayed = runTorsio(
      "replay " + trial.at("trial").get<std::string>() + " --verify --json" + organ + database, folder);
  ASSERT_EQ(replayed.code, 0) << replayed.err;
  EXPECT_TRUE(nlohmann::json::parse(replayed.out).at("identical").get<bool>());
}

// Each recording of an organ that comes twisted says how far the law of its wall was checked; a replay needs
// none of it.
TEST(OrganCommand, RecordingsSayHowFarTheirWallWasChecked) {
  const auto folder = emptyFolder("wall-recorded");
  const std::string database = " --database " + (folder / "torsio.sqlite").string();
  for (const bool valid : {true, false}) {
    const std::string organ = valid ? "small-bowel-loop" : "sigmoid";
    const ProgramRun recorded = runTorsio("record --json --duration 2 --organ " + organ + database, folder);
    ASSERT_EQ(recorded.code, 0) << recorded.err;
    const std::string trial = nlohmann::json::parse(recorded.out).at("trial").get<std::string>();

    const ProgramRun measured = runTorsio("metrics " + trial + database, folder);
    const ProgramRun replayed = runTorsio("replay " + trial + " --verify --json" + database, folder);

    ASSERT_EQ(measured.code, 0) << measured.err;
    const auto detorsion = nlohmann::json::parse(measured.out).at("detorsion");
    EXPECT_EQ(detorsion.at("valid"), valid) << organ;
    EXPECT_EQ(detorsion.contains("beyond"), !valid) << organ;
    EXPECT_NEAR(detorsion.at("valid_to_rad").get<double>(), valid ? 3.875 : 1.815, 0.02) << organ;
    ASSERT_EQ(replayed.code, 0) << replayed.err;
    EXPECT_TRUE(nlohmann::json::parse(replayed.out).at("identical").get<bool>());
  }
}

TEST(OrganCommand, AcceptsItsUnitAsAFactor) {
  const auto folder = emptyFolder("organ-unit");
  const auto mesh = folder / "bar.ply";
  TriangleMesh bar = testing::prism(testing::circleOutline(0.03, 36), 0.2, 12);
  for (Vec3& v : bar.vertices_m) {
    v *= 0.001;  // in metres
  }
  writePly(mesh, bar);

  const auto wrong = importOf(mesh.string(), folder, 6);
  const auto right = importOf(mesh.string() + " --scale 1000", folder, 0);

  EXPECT_EQ(wrong.at("findings")[0].at("code"), "M09");
  EXPECT_NEAR(right.at("length_mm").get<double>(), 200.0, 0.01);
}

TEST(OrganCommand, TakesTheUnitThatAFileStatesAndRefusesAnother) {
  const auto folder = emptyFolder("organ-stated");
  const TriangleMesh bar = testing::prism(testing::circleOutline(0.03, 36), 0.2, 12);
  const auto dae = folder / "bar.dae";
  writeFileAtomically(dae, testing::daeText(bar));

  for (const char* unit : {"", " --organ-unit mm", " --scale 1"}) {
    EXPECT_NEAR(importOf(dae.string() + unit, folder, 0).at("length_mm").get<double>(), 200.0, 0.01) << unit;
  }
  for (const std::string command : {"organ import ", "instrument import --out a.json ", "twist --organ "}) {
    const ProgramRun refused = runTorsio(command + dae.string() + " --organ-unit cm", folder);
    EXPECT_EQ(refused.code, static_cast<int>(ErrorCode::kBadParameter)) << command;
    EXPECT_NE(refused.err.find("one of its units is 1 mm, not 10 mm"), std::string::npos) << refused.err;
  }
  // The ends are in the file's own axes.
  const std::string said = "3D Slicer output. SPACE=RAS";
  std::string stl = testing::binaryStl(bar);
  stl.replace(0, said.size(), said);
  const auto ras = folder / "bar.stl";
  writeFileAtomically(ras, stl);
  const auto ends = importOf(ras.string() + " --fixed-end 5 3 0 --free-end 5 3 200", folder, 0);
  EXPECT_NEAR(ends.at("length_mm").get<double>(), 200.0, 0.5);
}

TEST(OrganCommand, EveryUnitThatIsAdvisedIsTaken) {
  const auto folder = emptyFolder("organ-advice");
  const TriangleMesh bar = testing::prism(testing::circleOutline(0.03, 36), 0.2, 12);
  for (const auto& [unit, factor] : {std::pair("um", 1e3), {"m", 1e-3}, {"cm", 0.1}}) {
    TriangleMesh other = bar;
    for (Vec3& v : other.vertices_m) {
      v *= factor;
    }
    const auto mesh = folder / (std::string("bar-") + unit + ".ply");
    writePly(mesh, other);
    const std::string command = "twist --angle 5 --organ " + mesh.string();
    const ProgramRun advised = runTorsio(command, folder);
    ASSERT_NE(advised.err.find(std::string("Add --organ-unit ") + unit), std::string::npos) << advised.err;
    const ProgramRun followed = runTorsio(command + " --organ-unit " + unit, folder);
    EXPECT_EQ(followed.code, 0) << followed.err;
  }
}

TEST(InstrumentCommand, MakesAnInstrumentFromAMeshOrReportsWhyNot) {
  const auto folder = emptyFolder("instrument-mesh");
  writeObj(folder / "tool.obj", testing::capsule(0.004, 0.16, 32, 40));

  const ProgramRun made =
      runTorsio("instrument import --json --title \"Our grasper\" --out " + (folder / "mine.json").string() +
                    ' ' + (folder / "tool.obj").string(),
                folder);
  ASSERT_EQ(made.code, 0) << made.err;
  const auto told = nlohmann::json::parse(made.out);
  EXPECT_NEAR(told.at("length_mm").get<double>(), 168.0, 0.5);
  for (const char* key : {"shaft_radius_mm", "tip_radius_mm", "pivot_mm", "tip_in_file_mm", "shaft_in_file",
                          "jaw_axis_in_file", "triangles", "findings", "out"}) {
    EXPECT_TRUE(told.contains(key)) << key;
  }
  const auto file = nlohmann::json::parse(readFile(folder / "mine.json"));
  EXPECT_EQ(file.at("title"), "Our grasper");
  EXPECT_EQ(file.at("provenance"), "from a mesh, by torsio instrument import");
  for (const auto& mesh : file.at("meshes")) {
    EXPECT_TRUE(std::filesystem::exists(folder / mesh.get<std::string>())) << mesh;
  }

  // In metres it would be far too long.
  const ProgramRun refused =
      runTorsio("instrument import --organ-unit m --out " + (folder / "no.json").string() + ' ' +
                    (folder / "tool.obj").string(),
                folder);
  EXPECT_EQ(refused.code, 6);
  EXPECT_NE(refused.err.find("M09"), std::string::npos) << refused.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "no.json"));
}

// A CT through the program: the organ, its report, and the patient's anonymity.

using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::int16_t kSoft_HU = 40;

/// A bar as thick as a forearm.
TriangleMesh bar() {
  return testing::capsule(0.03, 0.16, 36, 16);
}

nlohmann::json reconstructionOf(const std::string& words, const std::filesystem::path& folder, int code,
                                std::string* said = nullptr) {
  const ProgramRun run = runTorsio("organ reconstruct --json " + words, folder);
  EXPECT_EQ(run.code, code) << run.err;
  if (said != nullptr) {
    *said = run.out + run.err;
  }
  return nlohmann::json::parse(run.out, nullptr, false);
}

/// Expects nothing of the patient in writeDicomSeries(), in any spelling.
void expectNobody(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  for (const char* word : {"doe^jane", "doe", "jane", "pid4711", "4711", "19670401"}) {
    EXPECT_THAT(text, Not(HasSubstr(word)));
  }
}

TEST(ReconstructCommand, MakesAnOrganFromACtThatTwistsAndNamesNobody) {
  const auto folder = emptyFolder("reconstruct");
  ScanVolume scan = testing::blankScanAround(bar(), {3, 3, 4});
  testing::fillWith(scan, bar(), kSoft_HU);
  testing::writeDicomSeries(folder / "ct", scan, {.syntax = "rle", .names = "Doe_Jane_"});
  const auto organ = folder / "bar.organ";

  std::string said;
  const auto made =
      reconstructionOf((folder / "ct").string() + " --tissue skin --out " + organ.string(), folder, 0, &said);
  EXPECT_TRUE(made.at("accepted").get<bool>());
  EXPECT_LE(made.at("triangles").get<int>(), 20'000);
  EXPECT_GT(made.at("triangles").get<int>(), 5'000);
  EXPECT_NEAR(made.at("volume_ml").get<double>(), 1e6 * signedVolume_m3(bar()),
              0.01 * 1e6 * signedVolume_m3(bar()));
  EXPECT_EQ(made.at("euler").get<int>(), 2);
  EXPECT_GT(made.at("seconds").get<double>(), 0.0);
  EXPECT_LT(made.at("peak_mb").get<double>(), 3000.0);
  EXPECT_EQ(made.at("scan"), "CT, " + std::to_string(scan.count[2]) + " slices, skin");
  EXPECT_NEAR(made.at("level_hu").get<double>(), -480.0, 10.0);
  EXPECT_THAT(said, HasSubstr("Reading the scan"));
  expectNobody(said);
  expectNobody(readFile(organ));

  const ProgramRun twisted = runTorsio("twist --json --angle 30 --organ " + organ.string(), folder);
  EXPECT_EQ(twisted.code, 0) << twisted.err;

  // The same with a missing slice, reported by number because a file name might identify the patient.
  std::filesystem::remove(folder / "ct" / "Doe_Jane_45.dcm");
  const auto refused = reconstructionOf((folder / "ct").string() + " --tissue skin", folder, 6, &said);
  EXPECT_FALSE(refused.at("accepted").get<bool>());
  EXPECT_EQ(refused.at("findings")[0].at("code"), "D09");
  EXPECT_FALSE(refused.at("findings")[0].at("remedy").get<std::string>().empty());
  expectNobody(said);
  const auto mended = reconstructionOf((folder / "ct").string() + " --tissue skin --resample", folder, 0);
  EXPECT_THAT(mended.at("warnings").dump(), HasSubstr("D09"));
}

TEST(ReconstructCommand, FailsWithItsExitCodes) {
  const auto folder = emptyFolder("reconstruct-refused");
  const TriangleMesh ball = testing::capsule(0.04, 0.002, 36, 6);
  ScanVolume scan = testing::blankScanAround(ball, {4, 4, 4});
  testing::fillWith(scan, ball, kSoft_HU);
  const auto nifti = folder / "ball.nii.gz";
  writeFileAtomically(nifti, testing::gzipped(testing::niftiBytes(scan)));

  const auto judged =
      reconstructionOf(nifti.string() + " --tissue skin --out " + (folder / "b.organ").string(), folder, 6);
  EXPECT_EQ(judged.at("findings")[0].at("code"), "M20");
  EXPECT_EQ(judged.at("euler"), 2);
  EXPECT_FALSE(std::filesystem::exists(folder / "b.organ"));
  EXPECT_EQ(reconstructionOf(nifti.string() + " --tissue skin --seed -900,0,0", folder, 6)
                .at("findings")[0]
                .at("code"),
            "D16");
  EXPECT_EQ(reconstructionOf(nifti.string() + " --tissue label 3", folder, 6).at("findings")[0].at("code"),
            "N07");
  EXPECT_EQ(reconstructionOf(folder.string() + " --tissue skin", folder, 6).at("findings")[0].at("code"),
            "D01");
  EXPECT_EQ(runTorsio("organ reconstruct " + nifti.string() + " --tissue bone", folder).code, 2);
  EXPECT_EQ(runTorsio("organ reconstruct " + nifti.string() + " --tissue label 3x", folder).code, 2);
  EXPECT_EQ(runTorsio("organ reconstruct " + nifti.string() + " --tissue label 0", folder).code, 7);
  EXPECT_EQ(runTorsio("organ reconstruct " + (folder / "none").string() + " --tissue skin", folder).code, 3);
}

}  // namespace

}  // namespace torsio::test
