// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/services/maintenance/maintenance_desk.h"
#include "assessment/domain/study/curriculum.h"
#include "sim/core/error.h"
#include "sim/core/text.h"
#include "sim/scene/model_choice.h"
#include "sim/scene/scene.h"

namespace torsio::cli {

/// Adds an option whose help shows the default. `valid`: what is permitted.
template <class Value>
CLI::Option* addDefaulted(CLI::App& command, const std::string& name, Value& value, const std::string& what,
                          const CLI::Validator& valid = {}) {
  return command.add_option(name, value, what)->check(valid)->capture_default_str();
}

/// Throws Error{kUsage}.
[[noreturn]] inline void refuseUsage(const std::string& what, const std::string& where,
                                     const std::string& remedy) {
  throw Error(ErrorCode::kUsage, what, where, remedy);
}

/// Adds the numbers of a competence design; identical in all commands.
void addDesignOptions(CLI::App& command, CompetenceDesign& design);

/// Options that identify the maintainer of a record.
struct MaintenanceOptions {
  std::string login{};
  int passwordDescriptor = -1;  ///< -1: ask at the terminal
  std::string secondLogin{};
  int secondDescriptor = -1;
  bool asSystem = false;

  [[nodiscard]] Maintainer maintainer() const;
  /// Returns the user who signs in; without a login, the owner of the record's file.
  [[nodiscard]] Maintainer ownerOrMaintainer() const;
};

/// Prints a line to standard error.
void say(const Text& sentence);

/// Where --as names nothing else, it signs in like --login.
inline constexpr const char* kLoginOrAs = "--login,--as";
/// Adds the sign-in option `login` ("--login" or kLoginOrAs), and --password-fd.
CLI::Option* addSignIn(CLI::App& command, MaintenanceOptions& options, const char* login);
/// Adds --as, --password-fd and --as-system and, for acts that need two people, --with and
/// --with-password-fd.
void addMaintenanceOptions(CLI::App& command, MaintenanceOptions& options);
void addSecondPerson(CLI::App& command, MaintenanceOptions& options);

/// The --database option as typed.
struct DatabaseOption {
  std::string address{};  ///< empty: not given
  bool askPassword = false;

  /// Returns the locator, without an address that of stationRecord(); asks for the server's password at the
  /// terminal, once, if requested by the option.
  [[nodiscard]] std::string locator() const;

 private:
  mutable std::string asked_;  // with the typed password
};

/// Adds --database and --ask-server-password. Rejects a password in the address, since every user of the
/// machine can read the command line.
CLI::Option* addDatabaseOption(CLI::App& command, DatabaseOption& option);

/// Adds an argument that is such an address.
CLI::Option* addDatabaseArgument(CLI::App& command, const std::string& name, std::string& address,
                                 const std::string& description);

/// Options that choose an organ and its model; identical in all commands.
struct OrganArguments {
  std::string organ = "forearm";  ///< a scene's name, or a mesh file
  std::string unit;               ///< unit of the mesh file; empty: not given
  std::vector<double> fixedEnd;   ///< fixed end of the mesh file, in its unit; empty: found from the shape
  std::vector<double> freeEnd;    ///< free end of the mesh file, in its unit; empty: found from the shape
  std::string material;           ///< material by name; empty: the scene's
  std::string pattern;            ///< twist pattern by name; empty: the scene's first
  std::string formulation;        ///< formulation of the twist model; empty: the scene's
  std::optional<int> ridges;      ///< ridges of the lattice (N); empty: the scene's
  std::optional<int> sections;    ///< sections of the lattice (M); empty: the scene's
};

/// Adds --organ-unit, the unit of a mesh file.
CLI::Option* addUnitOption(CLI::App& command, std::string& unit);

/// Returns the metres in one unit of a mesh file, as it says itself or as --organ-unit does. Throws
/// Error{kBadParameter} where the two differ.
[[nodiscard]] double unitOf_m(const std::string& file, const std::string& unit);

/// Adds these options; `arguments` must outlive the command.
void addOrganOptions(CLI::App& command, OrganArguments& arguments);

/// Converts the options to a scene request. Throws Error{kUsage} for a name that is neither a scene nor a
/// file.
[[nodiscard]] SceneRequest sceneRequest(const OrganArguments& arguments);

/// Options that modify the twist model of a pattern.
struct ModelArguments {
  std::string interpolation;  ///< of the paper: "angle", "components" (Eq. 15); empty: not given
  std::string drift;          ///< of kriging: "constant" (Eq. 16), "linear"; empty: not given
  ModelChoice choice;         ///< other options
};

/// Adds these options, except for G; `arguments` must outlive the command.
void addModelOptions(CLI::App& command, ModelArguments& arguments);

/// Returns the resulting choice.
[[nodiscard]] ModelChoice modelChoice(const ModelArguments& arguments);

}  // namespace torsio::cli
