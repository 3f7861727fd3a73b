// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

namespace torsio::cli {

// Each function adds one command with its options. The command runs during parsing, prints to standard output
// and throws torsio::Error on failure. One source per command: command_<name>.cpp.

void addAgreement(CLI::App& program);
void addAllocate(CLI::App& program);
void addAudit(CLI::App& program);
void addBench(CLI::App& program);
void addCompare(CLI::App& program);
void addCompareGroups(CLI::App& program);
void addCompetence(CLI::App& program);
void addConfig(CLI::App& program);
void addDb(CLI::App& program);
void addDemo(CLI::App& program);
void addDevice(CLI::App& program);
void addDoctor(CLI::App& program);
void addEvaluate(CLI::App& program);
void addExport(CLI::App& program);
void addDataset(CLI::App& program);
void addDatasetImport(CLI::App& dataset);
void addInstrument(CLI::App& program);
void addInvite(CLI::App& program);
void addRoster(CLI::App& program);
void addLearning(CLI::App& program);
void addManual(CLI::App& program);
void addMetrics(CLI::App& program);
void addOrgan(CLI::App& program);
void addPower(CLI::App& program);
void addRecord(CLI::App& program);
void addReplay(CLI::App& program);
void addReport(CLI::App& program);
void addSection(CLI::App& program);
void addSettings(CLI::App& program);
void addServe(CLI::App& program);
void addSetup(CLI::App& program);
void addStandardSetting(CLI::App& program);
void addStation(CLI::App& program);
void addStudy(CLI::App& program);
void addSupport(CLI::App& program);
void addTracker(CLI::App& program);
void addTwist(CLI::App& program);
void addXapi(CLI::App& program);

}  // namespace torsio::cli
