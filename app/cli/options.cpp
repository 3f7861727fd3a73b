// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/options.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>

#include <CLI/CLI.hpp>

#include "app/cli/terminal.h"
#include "app/services/access/first_run.h"
#include "app/services/access/station_record.h"
#include "app/services/base/assets.h"
#include "app/services/base/nearest_name.h"
#include "db/connection/locator.h"
#include "sim/core/error.h"
#include "sim/geometry/mesh/mesh_import.h"
#include "sim/geometry/mesh/mesh_space.h"

namespace torsio::cli {

namespace {

constexpr int kLastDescriptor = 1 << 16;

std::function<std::string()> secretOf(int descriptor, const std::string& login) {
  return [descriptor, login] {
    return descriptor >= 0 ? secretFrom(descriptor) : typedSecret("Password of " + login + ": ");
  };
}

/// The code follows the password: in the next line of the descriptor, or at the terminal.
std::function<std::string()> codeOf(int descriptor, const std::string& login) {
  return [descriptor, login] {
    return descriptor >= 0 ? secretFrom(descriptor)
                           : typedSecret("Code of " + login + " (six digits, or a recovery code): ");
  };
}

}  // namespace

void say(const Text& sentence) {
  std::cerr << "torsio: " << sentence.str() << "\n";
}

CLI::Option* addSignIn(CLI::App& command, MaintenanceOptions& options, const char* loginOption) {
  CLI::Option* login = command.add_option(loginOption, options.login, "Signs in to the record as this user");
  command
      .add_option(
          "--password-fd", options.passwordDescriptor,
          "Reads the password from this file descriptor instead of asking for it; the code of a second "
          "factor from its next line")
      ->check(CLI::Range(0, kLastDescriptor))
      ->needs(login);
  return login;
}

void addMaintenanceOptions(CLI::App& command, MaintenanceOptions& options) {
  CLI::Option* login = addSignIn(command, options, kLoginOrAs);
  command.add_flag("--as-system", options.asSystem, "Without signing in, as the owner of the record's file")
      ->excludes(login);
}

void addSecondPerson(CLI::App& command, MaintenanceOptions& options) {
  CLI::Option* login =
      command.add_option("--with", options.secondLogin, "The second person, if the centre requires two")
          ->needs("--login");
  command
      .add_option("--with-password-fd", options.secondDescriptor,
                  "Reads that person's password from this file descriptor")
      ->check(CLI::Range(0, kLastDescriptor))
      ->needs(login);
}

Maintainer MaintenanceOptions::maintainer() const {
  return {.login = login,
          .password = secretOf(passwordDescriptor, login),
          .code = codeOf(passwordDescriptor, login),
          .secondLogin = secondLogin,
          .secondPassword = secretOf(secondDescriptor, secondLogin),
          .secondCode = codeOf(secondDescriptor, secondLogin),
          .systemAccount = asSystem ? systemAccount() : "",
          .ownsFile = ownsFile,
          .tell = say};
}

Maintainer MaintenanceOptions::ownerOrMaintainer() const {
  MaintenanceOptions options = *this;
  options.asSystem = login.empty();
  return options.maintainer();
}

namespace {

constexpr const char* kWhat =
    "SQLite file or postgresql://user@host:port/database?sslmode=verify-full; default: the record of this "
    "station";

/// Empty: an address without a password. The command reports other faults of the address.
std::string withoutPassword(const std::string& address) {
  if (address.empty()) {
    return "an empty word is not an address";
  }
  try {
    if (!saysPassword(address)) {
      return {};
    }
  } catch (const Error&) {
    return {};
  }
  return "a password in an address is seen by every user of this machine: leave it out, and write it to "
         "~/.pgpass or a service file, or give --ask-server-password";
}

CLI::Option* checked(CLI::Option* option) {
  return option->check(CLI::Validator(withoutPassword, "", "address"));
}

}  // namespace

std::string DatabaseOption::locator() const {
  const std::string own = address.empty() ? stationRecord().locator : address;
  if (!askPassword) {
    return own;
  }
  if (!asked_.empty()) {
    return asked_;
  }
  Locator server = parseLocator(own);
  if (server.engine != Engine::kPostgresql) {
    refuseUsage("a file has no password of a server", own, "Leave --ask-server-password out");
  }
  server.password = typedSecret("Password of the server at " + server.shown() + ": ");
  asked_ = addressOf(server);
  return asked_;
}

CLI::Option* addDatabaseOption(CLI::App& command, DatabaseOption& option) {
  command.add_flag("--ask-server-password", option.askPassword,
                   "Asks at the terminal for the password of the server");
  return checked(command.add_option("--database", option.address, kWhat));
}

CLI::Option* addDatabaseArgument(CLI::App& command, const std::string& name, std::string& address,
                                 const std::string& description) {
  return checked(command.add_option(name, address, description));
}

CLI::Option* addUnitOption(CLI::App& command, std::string& unit) {
  return command
      .add_option("--organ-unit", unit,
                  "Unit of the mesh file: m, cm, mm or um; default: what the file says, else mm")
      ->check(CLI::IsMember({"m", "cm", "mm", "um"}));
}

double unitOf_m(const std::string& file, const std::string& unit) {
  return meshUnit_m(file, unit.empty() ? std::nullopt : std::optional(lengthUnit_m(unit)));
}

void addOrganOptions(CLI::App& command, OrganArguments& arguments) {
  addDefaulted(command, "--organ", arguments.organ, "Scene (arm, stomach, intestine) or mesh file");
  addUnitOption(command, arguments.unit);
  CLI::Option* fixedEnd =
      command
          .add_option("--fixed-end", arguments.fixedEnd,
                      "x y z of the mesh file's held end, in its unit; default: found from the shape")
          ->expected(3);
  command.add_option("--free-end", arguments.freeEnd, "x y z of its other end")->expected(3)->needs(fixedEnd);
  command.add_option("--material", arguments.material,
                     "Tissue of assets/scenes/materials.json; default: the scene's");
  command.add_option("--pattern", arguments.pattern, "Twist pattern of the scene; default: its first");
  command.add_option("--formulation", arguments.formulation, "saint-venant or paper")
      ->check(CLI::IsMember({"saint-venant", "paper"}));
  command.add_option("--ridges", arguments.ridges, "N, 3 to 360");
  command.add_option("--sections", arguments.sections, "M, 2 to 360");
}

SceneRequest sceneRequest(const OrganArguments& arguments) {
  SceneRequest request;
  request.assets = assetsFolder();
  const std::vector<std::string> known = sceneIds(request.assets);
  // Other names of scenes in use.
  static const std::map<std::string, std::string> kOtherNames{{"arm", "forearm"}, {"wrist", "forearm"}};
  const auto other = kOtherNames.find(arguments.organ);
  const std::string organ = other == kOtherNames.end() ? arguments.organ : other->second;
  if (std::find(known.begin(), known.end(), organ) != known.end()) {
    request.id = organ;
  } else if (arguments.organ.find_first_of("./\\") != std::string::npos) {
    request.organFile = std::filesystem::path(arguments.organ);
    request.organScale_m = unitOf_m(arguments.organ, arguments.unit);
  } else {
    const std::string nearest = nearestOf(known, arguments.organ);
    refuseUsage("no such organ", "--organ " + arguments.organ,
                (nearest.empty() ? "" : "Did you mean '" + nearest + "'? ") + "Choose one of " +
                    joined(known) + ", or give a mesh file with its ending");
  }
  const MeshSpace space = request.organFile ? meshSpaceOf(*request.organFile) : MeshSpace{};
  const auto point_m = [&request, &space](const std::vector<double>& xyz) {
    return space.toLps(Vec3{xyz[0], xyz[1], xyz[2]} * request.organScale_m);
  };
  if (!arguments.fixedEnd.empty() && !arguments.freeEnd.empty()) {
    request.fixedEnd_m = point_m(arguments.fixedEnd);
    request.freeEnd_m = point_m(arguments.freeEnd);
  } else if (!arguments.fixedEnd.empty()) {
    refuseUsage("one end alone is not enough", "--fixed-end", "Give --free-end too");
  }
  request.material = arguments.material;
  request.pattern = arguments.pattern;
  if (!arguments.formulation.empty()) {
    request.formulation = arguments.formulation == "paper" ? Formulation::kPaper : Formulation::kSaintVenant;
  }
  request.ridges = arguments.ridges;
  request.sections = arguments.sections;
  return request;
}

void addModelOptions(CLI::App& command, ModelArguments& arguments) {
  command
      .add_option("--interpolation", arguments.interpolation,
                  "With --formulation paper: angle, or components (dX, dY, dZ along each ridge, Eq. 15)")
      ->check(CLI::IsMember({"angle", "components"}));
  command.add_option("--drift", arguments.drift, "Drift of kriging: constant (Eq. 16 as printed) or linear")
      ->check(CLI::IsMember({"constant", "linear"}));
  command.add_option("--beta", arguments.choice.beta,
                     "With --formulation paper: beta of Eq. 18, in sections; default: infinite");
  command.add_flag("--clamp-lift", arguments.choice.clampLift,
                   "With --formulation paper: dZ of Eq. 23 at the clamp too, as printed");
  command.add_flag("--poynting", arguments.choice.poynting, "A twisted bar with a free end grows longer");
  command.add_flag("--restrained-ends", arguments.choice.restrainedEnds,
                   "Clamped ends keep their sections flat; always with --ends");
  command.add_flag("--taper", arguments.choice.taper,
                   "Correct the compliance of a tapering organ; always with --ends");
  command.add_flag("--shear-centre", arguments.choice.shearCentre, "Sections turn about their shear centres");
  command.add_option("--foundation", arguments.choice.foundationLengths,
                     "Elastic foundation: sqrt(G J / k) in organ lengths, such as 0.5");
  command.add_option("--stiffening", arguments.choice.stiffeningStrain,
                     "Shear strain at which the torque has doubled against the linear law");
}

void addDesignOptions(CLI::App& command, CompetenceDesign& design) {
  addDefaulted(command, "--adequate", design.adequate, "Failure rate of a trainee who is competent");
  addDefaulted(command, "--inadequate", design.inadequate, "Failure rate of a trainee who is not competent");
  addDefaulted(command, "--false-pass", design.falsePassMost,
               "Largest share of inadequate trainees that pass");
  addDefaulted(command, "--false-fail", design.falseFailMost,
               "Largest share of adequate trainees that do not pass");
  addDefaulted(command, "--session-correlation", design.sessionCorrelation,
               "Correlation among the runs of a session; 0: sessions are alike");
  addDefaulted(command, "--lag-correlation", design.lagCorrelation,
               "Correlation between successive runs; 0: a run does not depend on the one before");
  addDefaulted(command, "--runs-per-session", design.runsPerSession, "Runs of a session");
}

ModelChoice modelChoice(const ModelArguments& arguments) {
  ModelChoice choice = arguments.choice;
  if (!arguments.interpolation.empty()) {
    choice.interpolation = arguments.interpolation == "components" ? PaperInterpolation::kComponents
                                                                   : PaperInterpolation::kAngle;
  }
  if (!arguments.drift.empty()) {
    choice.drift = arguments.drift == "constant" ? Drift::kConstant : Drift::kLinear;
  }
  return choice;
}

}  // namespace torsio::cli
