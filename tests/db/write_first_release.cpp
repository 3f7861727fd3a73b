// SPDX-License-Identifier: GPL-3.0-or-later
// Writes what the first released version leaves behind, into the folder that is named: two trials as files
// and a record with a row in every table. tests/data holds what it wrote when that version was made; it is
// kept so that nobody has to guess how, and is not to be run over those files again.
//
//   ninja -C build/release write_first_release && build/release/tests/db/write_first_release tests/data
#include <filesystem>
#include <iostream>

#include <QCoreApplication>

#include "db/connection/connection.h"
#include "db/migrations/migrations.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"
#include "sim/record/trial_file.h"
#include "tests/db/sample_record.h"
#include "tests/sim/servo/recorded_trial.h"

namespace fs = std::filesystem;

namespace torsio {
namespace {

void writeTrial(const fs::path& file, TwistDrive drive) {
  const Trial trial = recordOnBar(file.stem().string(), "", drive);
  TrialFileSink sink(file);
  sink.begin(trial.header);
  for (const TrialChunk& chunk : trial.chunks) {
    sink.append(chunk);
  }
  sink.finish(trial.summary);
}

/// Small pages keep the file small: most tables hold one row.
void writeRecord(const fs::path& file) {
  Connection connection = openRecord(file.string(), OpenMode::kCreate, {.softwareVersion = "0.1.0"});
  const FullRecord record(connection, "first", false);
  TrialRepository(connection, {.station = "room"})
      .import(recordOnBar("first-release", "first-T", TwistDrive::kTangential));
  connection.executeVerbatim("PRAGMA journal_mode = DELETE");
  connection.executeVerbatim("PRAGMA page_size = 512");
  connection.executeVerbatim("VACUUM");
}

void write(const fs::path& folder) {
  fs::create_directories(folder / "trials");
  fs::create_directories(folder / "records");
  writeTrial(folder / "trials" / "first-release-tangential.trial", TwistDrive::kTangential);
  writeTrial(folder / "trials" / "first-release-roll.trial", TwistDrive::kRoll);
  writeRecord(folder / "records" / "schema_0001.sqlite");
}

}  // namespace
}  // namespace torsio

int main(int argc, char** argv) {
  const QCoreApplication application(argc, argv);
  if (argc != 2) {
    std::cerr << "usage: write_first_release FOLDER\n";
    return 2;
  }
  try {
    torsio::write(argv[1]);
  } catch (const torsio::Error& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
