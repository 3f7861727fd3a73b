// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "db/connection/locator.h"
#include "tests/app/cli/program.h"
#include "tests/app/record_safety/killed_program.h"
#include "tests/db/test_database.h"

namespace torsio {

/// A server used by many tests in parallel may need longer to connect than the program would wait.
inline const ServerParameter kPatient{"connect_timeout", "60"};

/// A maintenance command, and what must hold whenever it is interrupted.
struct CutOff {
  std::vector<std::string> arguments;
  std::function<void()> before = [] {};  ///< restores the initial state
  std::function<void()> after = [] {};   ///< checks the result
  /// Returns whether the work is complete, so that repeating it may be refused.
  std::function<bool()> done = [] { return false; };
  const char* program = TORSIO_PROGRAM;
  long atMost = 1'000'000;  ///< maximum instants of killing
};

/// A record in a file, and on PostgreSQL a separate schema.
class CutOffMaintenance : public DatabaseTest {
 protected:
  void SetUp() override;

  [[nodiscard]] std::string file(const std::string& name) const { return (folder_ / name).string(); }
  void makeRecord(const std::string& name, const std::string& prefix) const;
  [[nodiscard]] ProgramRun run(const std::vector<std::string>& arguments,
                               const char* program = TORSIO_PROGRAM) const;
  /// Kills the command at instants spread over its whole run and checks each time; now and then the command
  /// must then succeed when repeated.
  void killEverywhere(const CutOff& cut) const;
  /// Like killEverywhere() for slow commands: stops the command, lets `look` check what a kill would leave,
  /// and continues. TORSIO_KILL_INSTANTS sets the number of instants; each is counted.
  void lookEverywhere(const CutOff& cut, const std::function<void()>& look) const;
  /// Simulates a full disk from an instant on: the command must report it in one line and leave everything as
  /// before.
  void fillDiskEverywhere(const CutOff& cut) const;

  /// Removes everything from the server's schema.
  void emptySchema(const std::string& address) const;
  /// Returns the server's address for a command line; the password is in a separate file.
  [[nodiscard]] std::string addressWithoutPassword() const;
  /// Checks that `record.sqlite` is sound and still belongs to the same centre.
  void expectWholeRecord() const;
  /// Checks that the next program removes what a killed one left.
  void expectNothingHalf() const;

  std::filesystem::path folder_;

 private:
  /// `variable`: environment variable with the number of instants.
  void cutOffEverywhere(const CutOff& cut, const char* fault, const char* variable,
                        const std::function<void(const FaultyRun&)>& judge) const;
};

[[nodiscard]] std::string personIn(Connection& connection);
[[nodiscard]] bool isSound(Connection& connection);

}  // namespace torsio
