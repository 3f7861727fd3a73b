// SPDX-License-Identifier: GPL-3.0-or-later
// Invalid input as users type it: one line on standard error, the documented exit code, no output files.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/geometry/mesh/mesh_export.h"
#include "sim/geometry/mesh/mesh_import.h"
#include "tests/app/cli/program.h"
#include "tests/support/procedural_mesh.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& text) {
  std::ofstream(file) << text;
}

/// A closed box with this side, 12 triangles, as OBJ.
std::string boxObj(const std::string& side) {
  std::string text;
  for (const char* corner : {"0 0 0", "s 0 0", "s s 0", "0 s 0", "0 0 s", "s 0 s", "s s s", "0 s s"}) {
    std::string line = "v " + std::string(corner);
    for (std::size_t at = line.find('s'); at != std::string::npos; at = line.find('s')) {
      line.replace(at, 1, side);
    }
    text += line + "\n";
  }
  return text +
         "f 1 3 2\nf 1 4 3\nf 5 6 7\nf 5 7 8\nf 1 2 6\nf 1 6 5\nf 2 3 7\nf 2 7 6\nf 3 4 8\nf 3 8 7\nf 4 1 "
         "5\nf 4 5 8\n";
}

/// Expects one line with the error code, and an empty output folder.
void expectRefused(const std::string& arguments, ErrorCode code, const std::string& mentions) {
  SCOPED_TRACE(arguments);
  const fs::path scratch = emptyFolder("refused-run");
  const ProgramRun run = runTorsio(arguments, scratch);
  EXPECT_EQ(run.code, static_cast<int>(code)) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_NE(run.err.find(mentions), std::string::npos) << run.err;
  const std::string last =
      run.err.substr(run.err.rfind("torsio: ") == std::string::npos ? 0 : run.err.rfind("torsio: "));
  EXPECT_EQ(std::count(last.begin(), last.end(), '\n'), 1) << run.err;
}

class BadInput : public ::testing::Test {
 protected:
  fs::path folder_ = emptyFolder("bad-input");
  [[nodiscard]] std::string demoWith(const std::string& organ) const {
    return "demo --out " + (folder_ / "out").string() + " --organ " + (folder_ / organ).string();
  }
  void expectNothingWritten() const {
    EXPECT_TRUE(!fs::exists(folder_ / "out") || fs::is_empty(folder_ / "out"));
  }
};

TEST_F(BadInput, UnknownCommandsAndOptionsAreNamed) {
  expectRefused("dmeo", ErrorCode::kUsage, "dmeo");
  expectRefused("demo --out /tmp --sed 3", ErrorCode::kUsage, "--sed");
  expectRefused("demo", ErrorCode::kUsage, "--out");
  expectRefused("twist --organ liver", ErrorCode::kUsage, "liver");
}

TEST_F(BadInput, AMisspeltWordIsAnsweredByTheOneThatWasMeant) {
  struct Slip {
    const char* words;
    const char* said;
  };
  for (const Slip& one :
       {Slip{"dmeo", "Did you mean 'demo'? Commands: "},
        {"export workbok",
         "workbok: no such command. Did you mean 'workbook'? Commands of "
         "'torsio export': workbook, tables, gradebook"},
        {"device chek", "Did you mean 'check'?"},
        {"export", "torsio export: one of its commands is missing. Commands of 'torsio export'"},
        {"export --language en", "--language: no such command"},
        {"twist --patern pronation",
         "--patern: 'torsio twist' has no option of this name. Did you mean '--pattern'?"},
        {"twist --patern=pronation", "Did you mean '--pattern'?"},
        {"organ --patern x", "no such command: options come after one. Commands of 'torsio organ': "},
        {"record --patern x", "Did you mean '--pattern'?"},
        {"--them dark", "Did you mean '--theme'?"},
        {"twist --organ forarm", "no such organ. Did you mean 'forearm'?"},
        {"twist --angle", "--angle: the value is missing"},
        {"twist --zzz", "'torsio twist' has no option of this name. Run 'torsio twist --help'"},
        {"twist --angle sixty", "--angle: 'sixty' is not a number"},
        {"learning a b", "'torsio learning' takes no further words"}}) {
    expectRefused(one.words, ErrorCode::kUsage, one.said);
  }
}

TEST_F(BadInput, HelpIsACommandToo) {
  for (const char* words : {"help", "help export", "help export workbook", "export --help"}) {
    const ProgramRun run = runTorsio(words, folder_);
    EXPECT_EQ(run.code, 0) << words << run.err;
    EXPECT_NE(run.out.find("--help"), std::string::npos) << words;
  }
  EXPECT_EQ(runTorsio("help twist", folder_).out, runTorsio("twist --help", folder_).out);
}

TEST_F(BadInput, AMissingOrganFileIsNamed) {
  expectRefused(demoWith("missing.obj"), ErrorCode::kFileMissing, "missing.obj");
  expectNothingWritten();
}

TEST_F(BadInput, AnEmptyMeshIsRefused) {
  write(folder_ / "empty.obj", "");
  expectRefused(demoWith("empty.obj"), ErrorCode::kFileUnreadable, "empty.obj");
  expectNothingWritten();
}

TEST_F(BadInput, AnOpenMeshIsRefused) {
  std::string box = boxObj("100");
  box.erase(box.rfind("f 4 5 8"));
  write(folder_ / "open.obj", box);
  expectRefused(demoWith("open.obj"), ErrorCode::kBadMesh, "open.obj");
  expectNothingWritten();
}

TEST_F(BadInput, ANonManifoldMeshIsRefused) {
  write(folder_ / "fin.obj", boxObj("100") + "v 50 50 200\nf 5 6 9\nf 6 5 9\n");
  expectRefused(demoWith("fin.obj"), ErrorCode::kBadMesh, "fin.obj");
  expectNothingWritten();
}

TEST_F(BadInput, NaNIsRejected) {
  write(folder_ / "nan.obj", boxObj("nan"));
  expectRefused(demoWith("nan.obj"), ErrorCode::kBadMesh, "nan.obj");
  expectNothingWritten();
}

TEST_F(BadInput, NonFiniteOptionsAreRejected) {
  for (const char* option :
       {"power --test t --effect 0.5 --n", "power --test t --n 10 --effect",
        "power --test t --effect 0.5 --power", "power --test t --n 10 --effect 0.5 --alpha",
        "power --test icc --raters 3 --width 0.2 --icc", "power --test icc --raters 3 --icc 0.5 --width",
        "competence plan --adequate", "competence plan --tolerance",
        "learning t.csv --target 1 --sigma 1 --cusum-limit", "learning t.csv --target 1 --sigma",
        "learning t.csv --threshold", "compare-groups t.csv --margin",
        "compare-groups t.csv --highest 5 --lowest",
        "agreement --ratings t.csv --method kappa --categories 1,2,", "twist --organ forearm --angle"}) {
    const char* gap = std::string(option).back() == ',' ? "" : " ";
    expectRefused(std::string(option) + gap + "nan", ErrorCode::kUsage, "nan is not a finite number");
  }
  for (const char* option : {"twist --organ forearm --angle", "twist --organ forearm --shear-modulus",
                             "twist --organ forearm --sections", "organ import none.obj --scale"}) {
    expectRefused(std::string(option) + " ''", ErrorCode::kUsage, "an empty word is not a number");
  }
  for (const char* option : {"twist --organ forearm --material", "twist --organ forearm --pattern",
                             "twist --organ", "organ import none.obj --anatomy", "compare --out"}) {
    expectRefused(std::string(option) + " ''", ErrorCode::kUsage, "an empty word is not a name");
  }
  for (const char* none : {"-nan", "inf", "-inf", "1e999"}) {
    expectRefused(std::string("power --test t --n 10 --effect ") + none, ErrorCode::kUsage, "--effect");
  }
}

TEST_F(BadInput, MetresInsteadOfMillimetresAreRecognised) {
  write(folder_ / "metres.obj", boxObj("0.2"));
  expectRefused(demoWith("metres.obj"), ErrorCode::kBadMesh, "organ-unit m");
  expectNothingWritten();
}

TEST_F(BadInput, AnUnwritableFolderIsNamed) {
  // Root may write anywhere, so the folder is impossible instead of read-only: it would be inside a file.
  write(folder_ / "file", "");
  expectRefused("demo --out " + (folder_ / "file" / "out").string(), ErrorCode::kFileUnwritable, "file");
}

TEST_F(BadInput, AFileThatIsNotADatabaseIsRejected) {
  write(folder_ / "text.sqlite", "This is not a database, but it is longer than a header of one would be.\n");
  const fs::path file = folder_ / "text.sqlite";
  expectRefused("replay 0 --database " + file.string(), ErrorCode::kFileUnreadable, "text.sqlite");
  expectRefused("replay 0 --database " + (folder_ / "none.sqlite").string(), ErrorCode::kFileMissing,
                "none.sqlite");
  EXPECT_FALSE(fs::exists(folder_ / "none.sqlite"));
}

TEST_F(BadInput, InvalidSectionsAreRejected) {
  write(folder_ / "bow.csv", "0,0\n1,1\n1,0\n0,1\n");
  expectRefused("section " + (folder_ / "bow.csv").string(), ErrorCode::kBadParameter, "cross");
  write(folder_ / "words.csv", "0,0\n1,0\nhello,1\n");
  expectRefused("section " + (folder_ / "words.csv").string(), ErrorCode::kBadData, "3");
  expectRefused("section " + (folder_ / "none.csv").string(), ErrorCode::kFileMissing, "none.csv");
}

TEST_F(BadInput, SectionsBeyondTheRangeOfNumbersAreRejected) {
  write(folder_ / "huge.csv", "0,0\n1e200,0\n1e200,1e200\n0,1e200\n");
  write(folder_ / "tiny.csv", "0,0\n1e-200,0\n1e-200,1e-200\n0,1e-200\n");
  for (const char* wall : {"", " --wall 1"}) {
    expectRefused("section " + (folder_ / "huge.csv").string() + wall, ErrorCode::kBadParameter, "unit");
    expectRefused("section " + (folder_ / "tiny.csv").string() + wall, ErrorCode::kBadParameter, "unit");
  }
}

TEST_F(BadInput, InvalidWallsAreRejected) {
  write(folder_ / "square.csv", "0,0\n10,0\n10,10\n0,10\n");
  write(folder_ / "flat.csv", "0,0\n100,0\n100,2\n0,2\n");
  write(folder_ / "bow.csv", "0,0\n10,10\n10,0\n0,10\n");
  write(folder_ / "words.csv", "0,0\nnan,1\n1,1\n0,1\n");
  const auto sectionOf = [this](const std::string& rest) { return "section " + (folder_ / rest).string(); };
  for (const char* wall : {"0", "-1"}) {
    expectRefused(sectionOf("square.csv --json --wall ") + wall, ErrorCode::kBadParameter, "thicker than 0");
  }
  for (const char* wall : {"nan", "inf", "1e400"}) {
    expectRefused(sectionOf("square.csv --json --wall ") + wall, ErrorCode::kUsage, "is not a finite number");
  }
  expectRefused(sectionOf("square.csv --wall thick"), ErrorCode::kUsage, "thick");
  expectRefused(sectionOf("square.csv --wall 5"), ErrorCode::kBadParameter, "(2.34 here");
  expectRefused(sectionOf("square.csv --wall 1,2"), ErrorCode::kBadParameter, "2 thicknesses for 4");
  expectRefused(sectionOf("square.csv --wall 1 --method fem"), ErrorCode::kUsage, "closed form");
  expectRefused(sectionOf("flat.csv --json --wall 1.5"), ErrorCode::kBadParameter, "half of the narrowest");
  expectRefused(sectionOf("bow.csv --wall 1"), ErrorCode::kBadParameter, "cross");
  expectRefused(sectionOf("words.csv --wall 1"), ErrorCode::kBadData, "line 2");
}

TEST_F(BadInput, ParametersOutOfRangeNameTheLimit) {
  expectRefused("twist --organ forearm --ridges 2", ErrorCode::kBadParameter, "3");
  expectRefused("twist --organ forearm --sections 361", ErrorCode::kBadParameter, "360");
  expectRefused("twist --organ forearm --grasp 1.5", ErrorCode::kBadParameter, "1.5");
}

TEST(CommandLine, PrintsVersionAndHelpToStandardOutput) {
  const fs::path scratch = emptyFolder("version");
  const ProgramRun version = runTorsio("--version", scratch);
  EXPECT_EQ(version.code, 0);
  EXPECT_EQ(version.out.rfind("torsio ", 0), 0U) << version.out;
  const ProgramRun help = runTorsio("--help", scratch);
  EXPECT_EQ(help.code, 0);
  EXPECT_NE(help.out.find("demo"), std::string::npos);
}

TEST(CommandLine, ASquareSectionHasItsTabledTorsionConstant) {
  // Saint-Venant: J = 0.1405770150 a^4, membrane height 0.07367135 a^2 for the unit square.
  const fs::path scratch = emptyFolder("square");
  write(scratch / "square.csv", "0,0\n1,0\n1,1\n0,1\n");
  const ProgramRun run = runTorsio("section " + (scratch / "square.csv").string() + " --json", scratch);
  ASSERT_EQ(run.code, 0) << run.err;
  const std::size_t at = run.out.find("\"J\":");
  ASSERT_NE(at, std::string::npos) << run.out;
  EXPECT_NEAR(std::stod(run.out.substr(at + 4)), 0.140577014955, 1e-4 * 0.140577014955);
}

TEST(CommandLine, ASectionWithAWallHasBredtsTorsionConstant) {
  // Square of 10, wall 1: the middle line by Steiner has A = 100 - 20 + pi / 4 and s = 40 - pi.
  const fs::path scratch = emptyFolder("wall");
  write(scratch / "square.csv", "0,0\n10,0\n10,10\n0,10\n");
  write(scratch / "round.csv", "0,0\n10,0\n10,9.5\n9.9,9.8\n9.8,9.9\n9.5,10\n0,10\n");

  const ProgramRun run =
      runTorsio("section " + (scratch / "square.csv").string() + " --wall 1 --json", scratch);

  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  const nlohmann::json result = nlohmann::json::parse(run.out);
  EXPECT_EQ(result["method"], "wall");
  const double area = 80.0 + 0.25 * kPi;
  const double length = 40.0 - kPi;
  EXPECT_NEAR(result["area_mid"].get<double>(), area, 1e-9);
  EXPECT_NEAR(result["perimeter_mid"].get<double>(), length, 1e-9);
  EXPECT_NEAR(result["J"].get<double>(), 4.0 * area * area / length + length / 3.0, 1e-9);
  EXPECT_NEAR(result["volume"].get<double>(), 0.25 * result["J"].get<double>(), 1e-9);

  const ProgramRun crossing =
      runTorsio("section " + (scratch / "round.csv").string() + " --wall 1 --json", scratch);
  EXPECT_EQ(crossing.code, 0) << crossing.err;
  EXPECT_NE(crossing.err.find("crosses itself"), std::string::npos) << crossing.err;
}

TEST(CommandLine, ASectionReportsMembraneAndStressAtAPoint) {
  // Saint-Venant, unit square: membrane 0.07367135 at the centre, no stress there; 0.675 G theta a at the
  // middle of a side.
  const fs::path scratch = emptyFolder("point");
  write(scratch / "square.csv", "0,0\n1,0\n1,1\n0,1\n");
  const std::string call = "section " + (scratch / "square.csv").string() + " --json";

  const ProgramRun run = runTorsio(call + " --at 0.5,0.5 --at 0.5,0", scratch);

  ASSERT_EQ(run.code, 0) << run.err;
  const nlohmann::json points = nlohmann::json::parse(run.out)["points"];
  ASSERT_EQ(points.size(), 2U);
  EXPECT_NEAR(points[0]["membrane"].get<double>(), 0.07367135, 1e-5);
  EXPECT_NEAR(points[0]["tau_xz"].get<double>(), 0.0, 1e-6);
  EXPECT_NEAR(points[1]["tau_xz"].get<double>(), 0.675, 0.01);
  EXPECT_EQ(runTorsio(call + " --at 2,2", scratch).code, static_cast<int>(ErrorCode::kBadParameter));
}

TEST(CommandLine, ASectionNamesItsMethodAndWhetherItsBracketIsABound) {
  const fs::path scratch = emptyFolder("section-method");
  write(scratch / "square.csv", "0,0\n1,0\n1,1\n0,1\n");
  const std::string call = "section " + (scratch / "square.csv").string() + " --json --method ";

  const nlohmann::json elements = nlohmann::json::parse(runTorsio(call + "auto", scratch).out);
  const nlohmann::json boundary = nlohmann::json::parse(runTorsio(call + "bem", scratch).out);

  EXPECT_EQ(elements["method"], "fem");
  EXPECT_EQ(elements["bracket"], "bounds");
  EXPECT_LE(elements["J_lower"].get<double>(),
            0.140577014955);  // Timoshenko and Goodier: J of the unit square
  EXPECT_GE(elements["J_upper"].get<double>(), 0.140577014955);
  EXPECT_EQ(boundary["method"], "bem");
  EXPECT_EQ(boundary["bracket"], "estimate");
}

TEST(CommandLine, ATaskThatFoldsTheOrganIsRejectedUnlessRequested) {
  const fs::path scratch = emptyFolder("pattern-fold");
  const std::string call = "twist --organ stomach --pattern combined --angle -170 --json";

  const ProgramRun refused = runTorsio(call, scratch);

  EXPECT_EQ(refused.code, static_cast<int>(ErrorCode::kFolded)) << refused.err;
  EXPECT_EQ(refused.out, "");
  EXPECT_NE(refused.err.find("folds"), std::string::npos) << refused.err;
  const ProgramRun shown = runTorsio(call + " --allow-fold", scratch);
  ASSERT_EQ(shown.code, 0) << shown.err;
  EXPECT_GT(nlohmann::json::parse(shown.out)["sharpest_bend"].get<double>(), 0.55);
}

TEST(CommandLine, ATwistOfAMeshReportsItsRepairsAndWritesAnObj) {
  // A tube of 12 corners with a duplicate first face.
  const fs::path scratch = emptyFolder("obj");
  const TriangleMesh bar = testing::prism(testing::circleOutline(0.03, 12), 0.2, 8);
  std::string text = objText(bar);
  text += text.substr(text.find("f "), text.find('\n', text.find("f ")) - text.find("f ") + 1);
  write(scratch / "bar.obj", text);

  const ProgramRun run = runTorsio("twist --organ " + (scratch / "bar.obj").string() + " --angle 30 --out " +
                                       (scratch / "out.obj").string() + " --json",
                                   scratch);

  ASSERT_EQ(run.code, 0) << run.err;
  const nlohmann::json result = nlohmann::json::parse(run.out);
  EXPECT_EQ(result["repairs"], "1 repeated face removed");
  // Linear tissue: torque x compliance is the angle; the clamp rotates at the rate of everything after it.
  EXPECT_NEAR(result["torque_nm"].get<double>() * result["compliance_rad_per_nm"].get<double>(),
              radians(30.0), 1e-9);
  EXPECT_GT(result["profile"][1]["rate_rad_per_m"].get<double>(), 0.0);
  const TriangleMesh twisted = importMesh(scratch / "out.obj");
  EXPECT_EQ(twisted.triangles.size(), bar.triangles.size());
}

class ModelOptions : public ::testing::Test {
 protected:
  nlohmann::json twist(const std::string& options) {
    const ProgramRun run = runTorsio("twist --organ arm --angle 30 --json " + options, scratch_);
    EXPECT_EQ(run.code, 0) << options << '\n' << run.err;
    return nlohmann::json::parse(run.out);
  }
  double torque_Nm(const std::string& options) { return twist(options)["torque_nm"]; }

  fs::path scratch_ = emptyFolder("model-options");
};

TEST_F(ModelOptions, ChangeTheTorqueAccordingToTheirEquations) {
  const double plain_Nm = torque_Nm("");
  const double peak = twist("")["peak_shear_pa"].get<double>() / 4000.0;  // strain; G of the arm is 4 kPa

  // Linear in G; each correction stiffens or softens in its own direction.
  EXPECT_NEAR(torque_Nm("--shear-modulus 8000") / plain_Nm, 2.0, 1e-12);
  EXPECT_GT(torque_Nm("--restrained-ends"), plain_Nm);
  EXPECT_LT(torque_Nm("--taper"), plain_Nm);
  EXPECT_GT(torque_Nm("--foundation 0.5"), plain_Nm);
  // T = (phi / C)(1 + (gamma / strain)^2), gamma at most the peak strain.
  const double stiffened = torque_Nm("--stiffening " + std::to_string(peak)) / plain_Nm;
  EXPECT_GT(stiffened, 1.0);
  EXPECT_LE(stiffened, 2.0 + 1e-6);
}

TEST_F(ModelOptions, ChangeThePapersFormulationAccordingToItsEquations) {
  const std::string paper = "--formulation paper --allow-fold ";
  const nlohmann::json plain = twist(paper);

  // Eq. 18: kappa grows by e^((M - 1) / beta) from the free end to the clamp: the clamp rotates faster.
  const nlohmann::json graded = twist(paper + "--beta 72");
  EXPECT_GT(graded["profile"][1]["rate_rad_per_m"].get<double>(),
            plain["profile"][1]["rate_rad_per_m"].get<double>());
  // Component kriging (Eq. 15) meets the same angle at the grasp and moves the points between differently.
  const nlohmann::json components = twist(paper + "--interpolation components --drift constant");
  EXPECT_NEAR(components["torque_nm"].get<double>() / plain["torque_nm"].get<double>(), 1.0, 1e-4);
  EXPECT_NE(components["volume_ratio"], plain["volume_ratio"]);
  // Eq. 23 also lifts the clamped face, and with it the surface at that end.
  EXPECT_NE(twist(paper + "--clamp-lift")["volume_ratio"], plain["volume_ratio"]);
}

TEST_F(ModelOptions, OfTheOtherFormulationOrOfTheRodAreRejected) {
  for (const std::string options : {"--beta 10", "--clamp-lift", "--interpolation angle",
                                    "--formulation paper --poynting", "--formulation paper --foundation 1",
                                    "--formulation paper --taper", "--ends clamped-turned --poynting"}) {
    const ProgramRun run = runTorsio("twist --organ arm --angle 30 " + options, scratch_);
    EXPECT_EQ(run.code, static_cast<int>(ErrorCode::kUsage)) << options << '\n' << run.err;
  }
  const ProgramRun zero = runTorsio("twist --organ arm --formulation paper --beta 0", scratch_);
  EXPECT_EQ(zero.code, static_cast<int>(ErrorCode::kBadParameter)) << zero.err;
}

}  // namespace
}  // namespace torsio
