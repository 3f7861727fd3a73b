// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/dataset/replication.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>

#include "app/services/base/assets.h"
#include "app/services/base/build_info.h"
#include "app/services/base/csv_table.h"
#include "assessment/results/cohort_csv.h"
#include "assessment/results/record_sentences.h"
#include "assessment/results/validity_argument.h"
#include "sim/core/csv_cell.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio {

namespace {

namespace fs = std::filesystem;

constexpr const char* kScript = "analysis.R";
constexpr const char* kExpected = "expected.csv";
constexpr const char* kRecomputed = "recomputed.csv";
constexpr const char* kManifest = "manifest.csv";
constexpr int kPatience_ms = 600'000;
constexpr std::size_t kShownDifferences = 20;
constexpr std::uintmax_t kLargestFile = 1'000'000'000;  // bytes
constexpr std::string_view kAgrees = "TRUE";            // as R writes it

/// Files that the script reads. What is not in one of them is computed.
enum class PackageFile { kMarks, kEvaluationMarks, kMeasures, kGiven, kComputed };

/// Statistics by section that are facts of the plan, of people or of the record, not computed from marks and
/// measures.
using StatisticsOfSections = std::map<std::string_view, std::set<std::string_view>>;
const StatisticsOfSections kGiven = {
    {"evaluation", {"index_weight", "class_weight"}},
    {"training", {"sheets_asked", "sheets_present"}},
    {"comparison", {"planned_analysis", "equivalence_margin"}},
    {"competence",
     {"level", "failed", "able", "able_at_attempt", "planned_attempts", "design_version", "excused_runs"}},
    {"participants",
     {"withdrew", "deviations", "deviations_by_kind", "seed", "not_allocated", "moved_by_hand",
      "allocated_before_commitment", "enrolled_before_commitment", "by_sex", "by_level", "runs",
      "runs_interrupted", "planned_virtual_min", "planned_real_min", "noted_virtual_min", "noted_real_min",
      "noted_rest_min"}},
    {"record",
     {"blake2b", "samples", "late_ticks", "force_cuts", "runs_with_force_cuts", "runs_without_hash",
      "scale_lowest", "scale_highest", "given_in_all", "given_blinded", "given_live", "entered_without_sheet",
      "not_assessable", "signed", "not_signed", "models_hidden", "raters_who_are_trainees", "head",
      "file_blake2b"}},
};
constexpr std::string_view kDeviations = "deviation";  // a section of notes

PackageFile fileOf(const CohortCsvRow& row) {
  if (row.section == "training" && row.statistic == "rater_mark") {
    return PackageFile::kMarks;
  }
  if (row.section == "evaluation" && row.statistic == "mark") {
    return PackageFile::kEvaluationMarks;
  }
  if (row.section == "trial" && row.item != "all") {
    return PackageFile::kMeasures;
  }
  const auto section = kGiven.find(row.section);
  const bool given =
      row.section == kDeviations || (section != kGiven.end() && section->second.contains(row.statistic));
  return given ? PackageFile::kGiven : PackageFile::kComputed;
}

struct Codeword {
  const char* file;
  const char* column;
  const char* meaning;
};
constexpr auto kCodebook = std::to_array<Codeword>({
    {"marks.csv", "trainee", "code of the trainee"},
    {"marks.csv", "group", "group as allocated"},
    {"marks.csv", "rater", "code of the physician"},
    {"marks.csv", "occasion", "when the trainee was marked; rows are in order of time"},
    {"marks.csv", "mark", "points on the scale of the study; a missing mark has no row"},
    {"evaluation_marks.csv", "rater", "code of the rater"},
    {"evaluation_marks.csv", "class", "class of the rater, whose weight is in given.csv"},
    {"evaluation_marks.csv", "model", "tissue model"},
    {"evaluation_marks.csv", "index", "one of the nine indices"},
    {"evaluation_marks.csv", "mark", "points"},
    {"measures.csv", "statistic", "measure of a run; its unit is the end of its name (deg, Nm, N)"},
    {"measures.csv", "number", "of a twist in the run, from 1"},
    {"measures.csv", "when", "phase of the curriculum"},
    {"measures.csv", "value", "computed by Torsio from the recording whose content_hash stands beside it"},
    {"given.csv", "statistic", "facts of plan and record that are not computed"},
    {"expected.csv", "value", "every number of report and annex, as Torsio computed it"},
    {"expected.csv", "n", "values used"},
    {"validity.csv", "cell", "row of expected.csv that the claim rests on: its first seven columns"},
    {"validity.csv", "verdict", "whether the interval, or the count, keeps to the threshold"},
    {"recomputed.csv", "agrees", "whether R found the same within 1e-9"},
});

std::string packageReadme(const CohortInputs& inputs) {
  std::string text =
      "How to compute the numbers of this study again\n\n"
      "  Rscript analysis.R\n\n"
      "in this folder, with R alone (Debian: r-base-core). The script reads marks.csv, "
      "evaluation_marks.csv,\n"
      "measures.csv and given.csv, computes what follows from them, writes recomputed.csv and compares it\n"
      "with expected.csv, which holds every number of the report. It ends with an error if one differs by\n"
      "more than 1e-9. codebook.csv explains the columns. manifest.csv holds the BLAKE2b-256 hash of each\n"
      "file; torsio report replicate --check FOLDER compares them and runs the script.\n\n"
      "Measures of runs (measures.csv) come from recordings, which are not in this folder. The hash of each\n"
      "recording stands beside its measures.\n\n"
      "Written by Torsio " +
      softwareVersion() + ".\n";
  for (const Text& sentence : originSentences(inputs)) {
    text += sentence.str() + "\n";
  }
  return text;
}

std::map<std::string, std::string> packageContents(const CohortInputs& inputs,
                                                   const AnalysedCohort& analysed) {
  const std::vector<CohortCsvRow> rows = cohortCsvRows(analysed.ledger);
  std::map<std::string, std::string> files;
  std::string& marks = files["marks.csv"] = csvLine({"trainee", "group", "rater", "occasion", "mark"});
  std::string& evaluation = files["evaluation_marks.csv"] =
      csvLine({"rater", "class", "model", "index", "mark"});
  std::string& measures = files["measures.csv"] =
      csvLine({"trainee", "group", "model", "number", "when", "statistic", "value"});
  std::string& given = files["given.csv"] =
      csvLine({"section", "item", "group", "model", "index", "occasion", "statistic", "value"});
  for (const CohortCsvRow& row : rows) {
    switch (fileOf(row)) {
      case PackageFile::kMarks:
        marks += csvLine({row.item, row.group, row.index, row.occasion, row.value});
        break;
      case PackageFile::kEvaluationMarks:
        evaluation += csvLine({row.item, row.group, row.model, row.index, row.value});
        break;
      case PackageFile::kMeasures:
        measures +=
            csvLine({row.item, row.group, row.model, row.index, row.occasion, row.statistic, row.value});
        break;
      case PackageFile::kGiven:
        given += csvLine(
            {row.section, row.item, row.group, row.model, row.index, row.occasion, row.statistic, row.value});
        break;
      case PackageFile::kComputed:
        break;
    }
  }
  files[kExpected] = cohortCsvText(rows);
  files["validity.csv"] = validityCsvText(validityArgument(analysed));
  files["codebook.csv"] = csvLine({"file", "column", "meaning"});
  for (const Codeword& word : kCodebook) {
    files["codebook.csv"] += csvLine({word.file, word.column, word.meaning});
  }
  files["README.txt"] = packageReadme(inputs);
  files[kScript] = readFile(assetsFolder() / "replication" / kScript);
  return files;
}

std::string fileHash(const std::string& content) {
  Digest digest;
  digest.update(content);
  return digest.hex();
}

/// Names of the files of a package besides its manifest.
constexpr std::array<const char*, 9> kFiles = {kScript,     "README.txt",           "codebook.csv",
                                               kExpected,   "evaluation_marks.csv", "given.csv",
                                               "marks.csv", "measures.csv",         "validity.csv"};

/// Returns a file of a package. Throws Error{kFileUnreadable} for a link, a folder, a pipe or a huge file.
std::string packageFile(const fs::path& file) {
  if (!fs::is_regular_file(fs::symlink_status(file)) || fs::file_size(file) > kLargestFile) {
    throw Error(ErrorCode::kFileUnreadable, Text::tr("not a plain file of a replication package"),
                file.string(), Text::tr("Get a fresh copy of the package"));
  }
  return readFile(file);
}

/// Adds the files that are not as the manifest says; copies the others to `place`.
void compareFiles(const fs::path& folder, const fs::path& place, ReplicationCheck& check) {
  const CsvTable manifest = CsvTable::parse(packageFile(folder / kManifest), kManifest, {"file", "blake2b"});
  std::map<std::string, std::string> hashes;
  for (std::size_t r = 0; r < manifest.rows(); ++r) {
    if (!hashes.emplace(manifest.text(r, "file"), manifest.cell(r, "blake2b")).second) {
      refuse(Text::tr("the manifest names a file twice"), manifest.where(r),
             Text::tr("Get a fresh copy of the package"));
    }
  }
  for (const char* name : kFiles) {
    if (!fs::exists(fs::symlink_status(folder / name))) {
      check.differences.push_back(Text::tr("%1 is missing", std::string(name)));
      continue;
    }
    const std::string content = packageFile(folder / name);
    if (fileHash(content) != hashes[name]) {
      check.differences.push_back(Text::tr("%1 was changed after it was written", std::string(name)));
    }
    writeFileAtomically(place / name, content);
  }
}

/// Counts the expected numbers that can be computed from marks and measures.
std::int64_t computedIn(const fs::path& expected) {
  const CsvTable table = CsvTable::read(expected, {"section", "item", "statistic"});
  std::int64_t count = 0;
  for (std::size_t r = 0; r < table.rows(); ++r) {
    CohortCsvRow row;
    row.section = table.cell(r, "section");
    row.item = table.cell(r, "item");
    row.statistic = table.cell(r, "statistic");
    count += fileOf(row) == PackageFile::kComputed ? 1 : 0;
  }
  return count;
}

/// Adds the numbers that R found to differ, and counts all.
void compareNumbers(const fs::path& recomputed, ReplicationCheck& check) {
  const CsvTable table = CsvTable::read(recomputed, {"section", "item", "group", "model", "index", "occasion",
                                                     "statistic", "value", "expected", "agrees"});
  check.recomputed = static_cast<std::int64_t>(table.rows());
  for (std::size_t r = 0; r < table.rows() && check.differences.size() < kShownDifferences; ++r) {
    if (table.cell(r, "agrees") == kAgrees) {
      continue;
    }
    std::string key;
    for (const char* column : {"section", "item", "group", "model", "index", "occasion", "statistic"}) {
      key += (key.empty() ? "" : ",") + csvCell(table.cell(r, column));
    }
    check.differences.push_back(
        Text::tr("%1: %2 expected, R found %3", key, table.cell(r, "expected"), table.cell(r, "value")));
  }
}

/// Runs the script in `folder`; returns its last words if it ends with an error, else nothing.
std::string complaintOfScript(const fs::path& folder) {
  const QString program = QStandardPaths::findExecutable(QStringLiteral("Rscript"));
  if (program.isEmpty()) {
    throw Error(ErrorCode::kFileMissing, Text::tr("R is not installed"), std::string("Rscript"),
                Text::tr("Install it (Debian: apt install r-base-core), then check again"));
  }
  QProcess process;
  process.setWorkingDirectory(QString::fromStdString(folder.string()));
  process.setProcessChannelMode(QProcess::MergedChannels);
  process.start(program, {QStringLiteral("--vanilla"), QString::fromLatin1(kScript)});
  if (!process.waitForFinished(kPatience_ms)) {
    process.kill();
    process.waitForFinished();
    throw Error(ErrorCode::kFileUnreadable, Text::tr("R did not finish"), std::string(kScript),
                Text::tr("Run it in the folder by hand: Rscript analysis.R"));
  }
  constexpr qsizetype kMaxSaid = 400;  // letters, from the start of a line
  const QByteArray all = process.readAll();
  const qsizetype from = all.size() > kMaxSaid ? all.indexOf('\n', all.size() - kMaxSaid) + 1 : 0;
  const std::string said = all.mid(from).trimmed().toStdString();
  if (!fs::exists(folder / kRecomputed)) {
    throw Error(ErrorCode::kFileUnreadable, Text::tr("R produced no results"), said,
                Text::tr("Run it in the folder by hand: Rscript analysis.R"));
  }
  return process.exitCode() == 0 ? std::string() : said;
}

}  // namespace

std::vector<fs::path> writeReplication(const CohortInputs& inputs, const AnalysedCohort& analysed,
                                       const fs::path& named) {
  if (!inputs.singleMarks) {
    refuseParameter(Text::tr("single marks may not be seen yet"), std::string("replicate"),
                    Text::tr("Freeze the data when every sheet is in, or export as the owner of the file"));
  }
  const fs::path folder = named.has_filename() ? named : named.parent_path();  // "rep/" is "rep"
  const auto refuseExisting = [&folder] {
    throw Error(ErrorCode::kFileUnwritable, Text::tr("the folder exists already"), folder.string(),
                Text::tr("Name a new folder"));
  };
  if (fs::exists(fs::symlink_status(folder))) {
    refuseExisting();
  }
  const fs::path parent = fs::absolute(folder).parent_path();
  QTemporaryDir making(QString::fromStdString((parent / ".torsio-replication-XXXXXX").string()));
  if (!making.isValid()) {
    throw Error(ErrorCode::kFileUnwritable, Text::tr("the folder cannot be written"), parent.string(),
                Text::tr("Check the path and its permissions"));
  }
  const fs::path made = making.path().toStdString();
  std::string manifest = csvLine({"file", "blake2b"});
  std::vector<fs::path> files;
  for (const auto& [name, content] : packageContents(inputs, analysed)) {
    writeFileAtomically(made / name, content);
    manifest += csvLine({name, fileHash(content)});
    files.push_back(folder / name);
  }
  writeFileAtomically(made / kManifest, manifest);
  files.push_back(folder / kManifest);
  std::error_code failed;
  fs::rename(made, folder, failed);
  if (failed) {  // somebody else was faster
    refuseExisting();
  }
  making.setAutoRemove(false);
  return files;
}

ReplicationCheck checkReplication(const fs::path& folder) {
  if (!fs::exists(folder / kManifest) || !fs::exists(folder / kScript)) {
    throw Error(ErrorCode::kFileMissing, Text::tr("not a replication package"), folder.string(),
                Text::tr("Name the folder that torsio report replicate --out wrote"));
  }
  const QTemporaryDir copy;
  if (!copy.isValid()) {
    throw Error(ErrorCode::kFileUnwritable, Text::tr("there is no folder for temporary files"), "",
                Text::tr("Check the free space of /tmp, or set TMPDIR to a folder that can be written"));
  }
  const fs::path place = copy.path().toStdString();
  ReplicationCheck check;
  compareFiles(folder, place, check);
  const std::string script = readFile(assetsFolder() / "replication" / kScript);
  check.ownScript = fs::exists(place / kScript) && readFile(place / kScript) == script;
  for (const char* name : kFiles) {
    if (!fs::exists(place / name) && std::string_view(name) != kScript) {
      return check;  // nothing to compute from
    }
  }
  writeFileAtomically(place / kScript, script);  // never a script that came with the folder
  const std::string complaint = complaintOfScript(place);
  compareNumbers(place / kRecomputed, check);
  check.computed = computedIn(place / kExpected);
  if (check.same() && !complaint.empty()) {
    check.differences.push_back(Text::tr("R ends with an error: %1", complaint));
  }
  return check;
}

}  // namespace torsio
