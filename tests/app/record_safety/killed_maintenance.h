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

/// A server that many tests ask at once may let a connection wait for longer than the program would.
inline const ServerParameter kPatient{"connect_timeout", "60"};

/// A maintenance command, and what holds whenever it is cut off.
struct CutOff {
  std::vector<std::string> arguments;
  std::function<void()> before = [] {};  ///< puts everything as it was
  std::function<void()> after = [] {};   ///< looks at what was left
  /// Whether the work is done, so that doing it again may be refused.
  std::function<bool()> done = [] { return false; };
  const char* program = TORSIO_PROGRAM;
  long atMost = 1'000'000;  ///< instants at which it is killed
};

/// A record in a file, and on the other engine a schema of its own.
class CutOffMaintenance : public DatabaseTest {
 protected:
  void SetUp() override;

  [[nodiscard]] std::string file(const std::string& name) const { return (folder_ / name).string(); }
  void makeRecord(const std::string& name, const std::string& prefix) const;
  [[nodiscard]] test::ProgramRun run(const std::vector<std::string>& arguments,
                                     const char* program = TORSIO_PROGRAM) const;
  /// Kills the command at instants spread over all that it has, and looks each time; now and then the same
  /// command has to do its work right after.
  void killEverywhere(const CutOff& cut) const;
  /// The same for a command that takes long: it is stopped there, `look` sees what a kill would have left,
  /// and it goes on. As many instants as TORSIO_KILL_INSTANTS says; each is counted.
  void lookEverywhere(const CutOff& cut, const std::function<void()>& look) const;
  /// The disk is full from such an instant on: the command says so in one line, and leaves what it found.
  void fillDiskEverywhere(const CutOff& cut) const;

  /// Removes what is in the schema of the server, if anything is.
  void emptySchema(const std::string& address) const;
  /// The address of the server as it may stand on a command line; the password goes to a file of its own.
  [[nodiscard]] std::string addressWithoutPassword() const;
  /// `record.sqlite` is sound, and whose it was.
  void expectWholeRecord() const;
  /// What a killed program leaves is swept by the next one.
  void expectNothingHalf() const;

  std::filesystem::path folder_;

 private:
  /// `variable`: of the environment, says at how many instants.
  void cutOffEverywhere(const CutOff& cut, const char* fault, const char* variable,
                        const std::function<void(const test::FaultyRun&)>& judge) const;
};

[[nodiscard]] std::string personIn(Connection& connection);
[[nodiscard]] bool isSound(Connection& connection);

}  // namespace torsio
