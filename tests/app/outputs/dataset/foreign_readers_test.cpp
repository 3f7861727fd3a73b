// SPDX-License-Identifier: GPL-3.0-or-later
// Exports can be opened by common programs.
#include "tests/app/outputs/dataset/foreign_readers.h"

#include <algorithm>
#include <charconv>
#include <csignal>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <sys/resource.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/outputs/tables/table_files.h"
#include "app/outputs/tables/workbook.h"
#include "app/services/base/csv_table.h"
#include "assessment/results/analysed_cohort.h"
#include "assessment/results/cohort_csv.h"
#include "sim/core/csv_cell.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/file_lock.h"
#include "tests/support/demonstration_cohort.h"

namespace torsio {
namespace {

using testing::awkwardCohort;
using testing::hasProgram;
using ::testing::HasSubstr;
using testing::outputOf;
using testing::OwnFolder;

const ExportWording kEnglish = [](const Text& text) { return text.str(); };

struct Written {
  CohortInputs inputs = awkwardCohort();
  ExportSet set = exportSet(analysedCohort(inputs), {});
  ReportModel report = cohortReport(inputs);
  OwnFolder folder;
  std::filesystem::path file = folder.path() / "cohort.xlsx";

  void workbook(const Text& title = Text::tr("Cohort report")) {
    WorkbookContents contents{title, {}, tablesOf(set), {}, {Text(std::string("=2+2"))}};
    for (const ReportSection& section : report.sections) {
      for (const ReportFigure& figure : section.figures) {
        contents.figures.push_back(&figure);
      }
    }
    writeWorkbook(contents, kEnglish, file);
  }
};

TEST(Workbook, IsWrittenByOneProgramAtATime) {
  Written written;
  const PartFile other(written.file);
  try {
    written.workbook();
    FAIL() << "both wrote the same temporary file";
  } catch (const Error& error) {
    EXPECT_EQ(error.happened(), "another program is writing this file now");
  }
  EXPECT_FALSE(std::filesystem::exists(written.file));
}

double numberIn(const std::string& text) {
  double value = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

TEST(ExportSet, HasEveryRowOfTheTableOfNumbersSortedByWhatARowIs) {
  const CohortInputs in = awkwardCohort();
  const std::vector<CohortCsvRow> rows = cohortCsvRows(in);
  const ExportSet set = exportSet(analysedCohort(in), {});

  ASSERT_EQ(set.numbers.rows.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(cellText(set.numbers.rows[i][8]), rows[i].value) << i;
  }
  const auto with = [&](const char* section, const char* statistic) {
    return static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), [&](const CohortCsvRow& row) {
      return row.section == section && row.statistic == statistic && row.item != "all";
    }));
  };
  EXPECT_EQ(set.scores.rows.size(), with("training", "score"));
  EXPECT_EQ(static_cast<std::size_t>(
                std::count_if(set.marks.rows.begin(), set.marks.rows.end(),
                              [](const auto& row) { return std::holds_alternative<double>(row[5]); })),
            with("training", "rater_mark"));
  EXPECT_EQ(set.trials.rows.size(), with("trial", "minutes"));
  EXPECT_EQ(set.twists.rows.size(), with("trial", "twist_error_deg"));
  EXPECT_EQ(set.deviations.rows.size(), 3U);
  for (const ExportTable* table : tablesOf(set)) {
    for (const auto& row : table->rows) {
      ASSERT_EQ(row.size(), table->columns.size()) << table->name;
    }
  }
}

TEST(ExportSet, EachNumberOfATableBelongsToAResult) {
  CohortInputs in = awkwardCohort();
  in.doses = {{in.trainees.front().code, 38.5, 0.0, 2.0}};
  in.groups.front().plannedVirtual_min = 40.0;
  const AnalysedCohort cohort = analysedCohort(in);
  std::set<std::string> known;
  cohort.ledger.eachLine([&](const Result& line) { known.insert(keyAddress(line.key)); });
  const std::set<std::string> namesARow = {"group_number", "occasion_number", "trial_number", "twist_number"};
  const ExportSet set = exportSet(cohort, {});
  for (const ExportTable* table : tablesOf(set)) {
    for (const auto& row : table->rows) {
      for (std::size_t c = 0; c < row.size(); ++c) {
        if (std::holds_alternative<double>(row[c]) && !namesARow.contains(table->columns[c].name)) {
          ASSERT_NE(row[c].key, nullptr) << table->name << " " << table->columns[c].name;
          EXPECT_TRUE(known.contains(keyAddress(*row[c].key)))
              << table->name << " " << table->columns[c].name;
        }
      }
    }
  }
}

TEST(ExportSet, DescribesEachGroupAndListsMissingMarks) {
  CohortInputs in = testing::demonstrationCohort();
  std::erase_if(in.trainingMarks, [](const TrainingMark& mark) {
    return mark.trainee == "x101" && mark.rater == "R103" && mark.occasion == 1;
  });
  in.groups[1].code = "G2";
  in.groups[1].arm = "Both";
  in.groups[1].plannedVirtual_min = 20.0;
  in.trainees[0].withdrew = true;
  in.trainees[0].withdrewUtc_us = 1;
  in.trainingMarks[0].way = MarkWay::kBlinded;
  in.trainingMarks[0].raterClass = "chief";
  in.trainingMarks[0].version = 2;
  const ExportSet set = exportSet(analysedCohort(in), {});

  ASSERT_EQ(set.groups.rows.size(), 3U);
  std::vector<std::string> second;
  for (const ExportCell& cell : set.groups.rows[1]) {
    second.push_back(cellText(cell));
  }
  EXPECT_EQ(second, (std::vector<std::string>{"2", "Group 2", "G2", "20 min virtual, 20 min real arm", "Both",
                                              "20", "", "10"}));
  EXPECT_EQ(set.scores.columns.back().labels.at(1).second, "Group 2: 20 min virtual, 20 min real arm");
  ASSERT_EQ(set.participants.rows.size(), 30U);
  EXPECT_EQ(cellText(set.participants.rows[0][6]), "1") << "withdrew";
  EXPECT_EQ(set.participants.rows[0][7], ExportCell(std::int64_t{1})) << "when that was noted";
  ASSERT_EQ(set.marks.rows.size(), 900U);
  EXPECT_EQ(cellText(set.marks.rows[0][7]), "chief");
  EXPECT_EQ(cellText(set.marks.rows[0][8]), "blinded");
  EXPECT_EQ(cellText(set.marks.rows[0][9]), "2");
  const std::vector<ExportCell>& missing = set.marks.rows.back();
  EXPECT_EQ(cellText(missing[0]) + cellText(missing[2]) + cellText(missing[5]) + cellText(missing[8]),
            "x101R103missing");

  in.singleMarks = false;
  EXPECT_TRUE(exportSet(analysedCohort(in), {}).marks.rows.empty()) << "not even which are missing";
}

TEST(CsvCell, KeepsNumbersAndNeutralisesFormulas) {
  EXPECT_EQ(csvCell("-0.5"), "-0.5");
  EXPECT_EQ(csvCell("-2.5e-07"), "-2.5e-07");
  EXPECT_EQ(csvCell("-2+3"), "'-2+3");
  EXPECT_EQ(csvCell("=1+1"), "'=1+1");
  EXPECT_EQ(csvCell("@SUM(A1)"), "'@SUM(A1)");
  EXPECT_EQ(csvCell("+4"), "'+4");
  EXPECT_EQ(csvCell("a;b"), "\"a;b\"");
  EXPECT_EQ(csvCell("-\"x\""), "\"'-\"\"x\"\"\"");
}

TEST(CohortCsv, ContainsNoFormula) {
  const std::string text = cohortCsvText(cohortCsvRows(awkwardCohort()));
  EXPECT_THAT(text, HasSubstr(",'=1+1,"));
  EXPECT_THAT(text, HasSubstr("'+cmd|"));
}

TEST(SheetNumber, HasFifteenDigits) {
  EXPECT_EQ(sheetNumber(0.1 + 0.2), 0.3);
  EXPECT_EQ(sheetNumber(1.0 / 3.0), 0.333333333333333);
  EXPECT_EQ(sheetNumber(-0.0), 0.0);
  EXPECT_EQ(sheetNumber(-1.7976931348623157e308), -1.79769313486231e308);
}

TEST(Workbook, PreservesEveryNumberAndTextIsNeverAFormula) {
  if (outputOf("/usr/bin/python3 -c 'import openpyxl'", OwnFolder().path()) != "") {
    GTEST_SKIP() << "python3-openpyxl is not installed";
  }
  Written written;
  written.workbook();
  const std::filesystem::path script = written.folder.path() / "read.py";
  writeFileAtomically(
      script,
      "import openpyxl, sys, json\n"
      "book = openpyxl.load_workbook(sys.argv[1])\n"
      "sheet = book['All numbers']\n"
      "for row in sheet.iter_rows(min_row=2, values_only=True):\n"
      "    print('N', repr(row[7]) if row[7] is not None else '-', json.dumps(row[8] or '', "
      "ensure_ascii=False), sep='\\t')\n"
      "for row in book['Protocol deviations'].iter_rows(min_row=2):\n"
      "    print('D', row[3].data_type, json.dumps(row[3].value, ensure_ascii=False), sep='\\t')\n"
      "for row in book['Addresses of figures'].iter_rows(min_row=2, values_only=True):\n"
      "    print('A', repr(row[3]), row[4], sep='\\t')\n"
      "print('M', book['Methods']['A1'].data_type)\n"
      "print('C', len(book['Figures']._charts), sheet.freeze_panes, sheet.auto_filter.ref)\n");
  const std::string said = outputOf(
      "/usr/bin/python3 '" + script.string() + "' '" + written.file.string() + "'", written.folder.path());
  const std::vector<CohortCsvRow> rows = cohortCsvRows(written.inputs);
  std::size_t at = 0;
  std::map<std::string, std::optional<double>> known;
  const AnalysedCohort cohort = analysedCohort(written.inputs);
  for (const Result& result : cohort.ledger.every()) {
    known[keyAddress(result.key)] = numberIn(result.value);
  }
  std::size_t addresses = 0;
  std::istringstream lines(said);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("A\t", 0) == 0) {
      ++addresses;
      const std::size_t tab = line.find('\t', 2);
      const auto result = known.find(line.substr(tab + 1));
      ASSERT_NE(result, known.end()) << line;
      ASSERT_TRUE(result->second) << line;
      EXPECT_NEAR(numberIn(line.substr(2, tab - 2)), *result->second, 1e-9) << "the value of the address";
    }
    if (line.rfind("N\t", 0) != 0) {
      continue;
    }
    ASSERT_LT(at, rows.size());
    const std::size_t second = line.find('\t', 2);
    const std::string number = line.substr(2, second - 2);
    const std::string text = line.substr(second + 1);
    const std::string& value = rows[at++].value;
    EXPECT_EQ(text, nlohmann::json(value).dump());
    if (number != "-") {
      EXPECT_EQ(numberIn(number), sheetNumber(numberIn(value))) << line;
    }
  }
  EXPECT_EQ(at, rows.size()) << said.substr(0, 2000);
  EXPECT_GT(addresses, 50U);
  EXPECT_THAT(said, HasSubstr("D\ts\t\"=1+1\""));
  EXPECT_THAT(said, HasSubstr("D\ts\t\"+cmd|' /C calc'!A0\""));
  EXPECT_THAT(said, HasSubstr("\xE8\xAE\xBE\xE5\xA4\x87, two\\nlines"));
  EXPECT_THAT(said, HasSubstr("M s"));
  EXPECT_THAT(said, HasSubstr(" B2 A1:K"));
}

TEST(Workbook, OpensInLibreOffice) {
  if (!hasProgram("soffice")) {
    GTEST_SKIP() << "libreoffice-calc-nogui is not installed";
  }
  Written written;
  written.workbook();
  const std::string folder = written.folder.path().string();
  const std::string said = outputOf("soffice --headless '-env:UserInstallation=file://" + folder +
                                        "/profile' --convert-to 'csv:Text - txt - csv "
                                        "(StarCalc):44,34,76,1,,0,false,false,false,false,false,-1'"
                                        " --outdir '" +
                                        folder + "' '" + written.file.string() + "'",
                                    written.folder.path());
  const std::filesystem::path table = written.folder.path() / "cohort-All numbers.csv";
  ASSERT_TRUE(std::filesystem::exists(table)) << said;
  const std::vector<CsvRecord> records = csvRecords(readFile(table), "numbers");
  const std::vector<CohortCsvRow> rows = cohortCsvRows(written.inputs);
  ASSERT_EQ(records.size(), rows.size() + 1);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_EQ(records[i + 1].values[8], rows[i].value) << i;
  }
}

TEST(Workbook, LeavesExistingFilesIfItCannotBeWritten) {
  Written written;
  written.file = written.folder.path() / "no such folder" / "cohort.xlsx";
  EXPECT_THROW(written.workbook(), Error);
  written.file = written.folder.path() / "cohort.xlsx";
  std::filesystem::create_directory(written.file);
  EXPECT_THROW(written.workbook(), Error);
  std::size_t entries = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(written.folder.path())) {
    ++entries;
  }
  EXPECT_EQ(entries, 1U);
}

/// A disk that is full after a number of bytes of a file.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit little{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &little);
  }
  ~FullDisk() { ::setrlimit(RLIMIT_FSIZE, &before_); }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
};

TEST(Exports, OnAFullDiskReportItAndLeaveNothing) {
  Written written;
  const auto codeOf = [&](const std::function<void()>& write) {
    const FullDisk full(2'000);
    try {
      write();
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::kInternal;
  };
  EXPECT_EQ(codeOf([&] { written.workbook(); }), ErrorCode::kFileUnwritable);
  for (const TableFormat format : {TableFormat::kCsv, TableFormat::kR, TableFormat::kSpss}) {
    EXPECT_EQ(codeOf([&] { writeTables(tablesOf(written.set), format, written.folder.path() / "tables"); }),
              ErrorCode::kFileUnwritable);
  }
  std::error_code none;
  const std::filesystem::path tables = written.folder.path() / "tables";
  EXPECT_TRUE(!std::filesystem::exists(tables) || std::filesystem::is_empty(tables, none));
  EXPECT_FALSE(std::filesystem::exists(written.file));
}

TEST(Tables, AreReadByPsppWithTheirLabels) {
  if (!hasProgram("pspp-convert")) {
    GTEST_SKIP() << "pspp is not installed";
  }
  Written written;
  const std::filesystem::path folder = written.folder.path() / "spss";
  const std::vector<std::filesystem::path> files =
      writeTables(tablesOf(written.set), TableFormat::kSpss, folder);
  EXPECT_EQ(files.size(), tablesOf(written.set).size() + 1);
  for (const ExportTable* table : tablesOf(written.set)) {
    const std::filesystem::path csv = written.folder.path() / (table->name + ".csv");
    const std::string said =
        outputOf("pspp-convert '" + (folder / (table->name + ".sav")).string() + "' '" + csv.string() + "'",
                 written.folder.path());
    ASSERT_EQ(said, "") << table->name;
    const std::vector<CsvRecord> records = csvRecords(readFile(csv), table->name);
    ASSERT_EQ(records.size(), table->rows.size() + 1) << table->name;
    for (std::size_t c = 0; c < table->columns.size(); ++c) {
      ASSERT_EQ(records[0].values[c], table->columns[c].name);
      for (std::size_t r = 0; r < table->rows.size(); ++r) {
        if (const auto* value = std::get_if<double>(&table->rows[r][c])) {
          ASSERT_NEAR(numberIn(records[r + 1].values[c]), *value, 1e-12 * std::abs(*value))
              << table->name << " " << table->columns[c].name;
        }
      }
    }
  }
  const std::filesystem::path syntax = written.folder.path() / "labels.sps";
  writeFileAtomically(syntax, "GET FILE='" + (folder / "scores.sav").string() + "'.\nDISPLAY DICTIONARY.\n");
  const std::string dictionary = outputOf("pspp -o - '" + syntax.string() + "'", written.folder.path());
  EXPECT_THAT(dictionary, HasSubstr("after 40 min"));
  EXPECT_THAT(dictionary, HasSubstr("40 min real arm"));
  EXPECT_THAT(dictionary, HasSubstr("|training_level |       4|Level of|Nominal"));
}

TEST(Tables, AreReadByRInFullPrecision) {
  if (!hasProgram("Rscript")) {
    GTEST_SKIP() << "r-base-core is not installed";
  }
  Written written;
  const std::filesystem::path folder = written.folder.path() / "r";
  writeTables(tablesOf(written.set), TableFormat::kR, folder);
  const std::string said = outputOf("cd / && LC_ALL=C.UTF-8 Rscript -e 'source(\"" + folder.string() +
                                        "/read_tables.R\"); cat(nrow(scores), class(scores$score), "
                                        "sprintf(\"%.17g\", sum(scores$score)), deviations$description[1], "
                                        "levels(scores$group_number), levels(scores$occasion))'",
                                    written.folder.path());
  double sum = 0.0;
  for (const auto& row : written.set.scores.rows) {
    sum += std::get<double>(row[6]);
  }
  std::istringstream words(said);
  std::size_t count = 0;
  std::string kind;
  double read = 0.0;
  ASSERT_TRUE(words >> count >> kind >> read) << said;
  EXPECT_EQ(count, written.set.scores.rows.size());
  EXPECT_EQ(kind, "numeric");
  EXPECT_NEAR(read, sum, 1e-9);
  EXPECT_THAT(said, HasSubstr("=1+1"));
  EXPECT_THAT(said, HasSubstr("Group 3: 40 min real arm"));
  EXPECT_THAT(said, HasSubstr("before after 20 min after 40 min")) << "in the order of time";
}

TEST(Tables, HaveACodebookThatNamesEveryColumn) {
  Written written;
  const std::filesystem::path folder = written.folder.path() / "csv";
  writeTables(tablesOf(written.set), TableFormat::kCsv, folder);
  const std::vector<CsvRecord> codebook = csvRecords(readFile(folder / "codebook.csv"), "codebook");
  std::size_t columns = 0;
  for (const ExportTable* table : tablesOf(written.set)) {
    columns += table->columns.size();
    const std::vector<CsvRecord> records = csvRecords(readFile(folder / (table->name + ".csv")), table->name);
    EXPECT_EQ(records.size(), table->rows.size() + 1);
    EXPECT_EQ(records[0].values.size(), table->columns.size());
  }
  EXPECT_EQ(codebook.size(), columns + 1);
  EXPECT_THROW((void)tableFormat("sas"), Error);
}

}  // namespace
}  // namespace torsio
