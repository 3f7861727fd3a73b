// SPDX-License-Identifier: GPL-3.0-or-later
// Random tables for every statistics command: it prints numbers and reasons or fails with one line; it never
// ends with an internal error, hangs, or prints an invalid number. TORSIO_FUZZ_TABLES: number of tables,
// TORSIO_FUZZ_FIRST: number of the first (1).
#include <array>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <random>
#include <sstream>
#include <string>
#include <string_view>
#include <sys/time.h>
#include <unistd.h>
#include <vector>

#include <QCoreApplication>
#include <gtest/gtest.h>

#include "app/cli/cli.h"
#include "tests/app/cli/table_commands.h"

namespace torsio {
namespace {

constexpr int kDefaultTables = 600;
constexpr int kInternalError = 70;
constexpr int kPatience_s = 30;  // processor time per table

struct Command {
  std::string arguments;  ///< with a %1 for the table
  std::string columns;
};

std::vector<Command> commands() {
  std::vector<Command> all;
  for (const char* method : {"overview", "icc", "krippendorff --resamples 99", "kappa", "bland-altman",
                             "rasch", "generalizability"}) {
    all.push_back({std::string("agreement --ratings %1 --method ") + method, "target,rater,score"});
  }
  for (const char* options : {"", "--bootstrap mean --resamples 99", "--bootstrap median --resamples 99"}) {
    all.push_back({std::string("compare-groups %1 ") + options, "subject,group,score"});
  }
  for (const char* options :
       {"", "--paired t", "--paired signed-rank", "--paired permutation", "--paired friedman"}) {
    all.push_back({std::string("compare-groups %1 ") + options, "subject,group,occasion,score"});
  }
  for (const char* options : {"", "--lowest 1 --highest 10 --margin 2", "--paired t"}) {
    all.push_back({std::string("compare-groups %1 ") + options, "subject,group,occasion,rater,score"});
  }
  for (const char* options : {"", "--threshold 5 --target 4 --sigma 1"}) {
    all.push_back({std::string("learning %1 ") + options, "subject,attempt,value"});
  }
  all.push_back({"standard-setting %1 --method contrasting-groups", "subject,group,score"});
  all.push_back({"standard-setting %1 --method angoff", "judge,item,percent"});
  all.push_back(
      {"standard-setting %1 --method borderline-regression --borderline 3", "subject,global,score"});
  all.push_back({"standard-setting %1 --method proficiency", "expert,value"});
  all.push_back({"standard-setting %1 --method proficiency --log --drop-outliers", "expert,value"});
  all.push_back({"evaluate --ratings %1 --resamples 20", "index,rater,class,model,score"});
  return all;
}

/// A random table, determined by its seed on every machine.
class RandomTable {
 public:
  RandomTable(unsigned seed, Command command) : draw_(seed), command_(std::move(command)) {
    groups_ = 1 + below(4);
    passFail_ = below(2) == 0;
    style_ = below(10);
  }

  std::string text() {
    const std::string separator = below(5) == 0 ? ";" : ",";
    std::string table = row(names(), separator);
    const int targets = below(10);
    const int raters = below(7);
    for (int i = 0; i < targets; ++i) {
      for (int j = 0; j < raters; ++j) {
        if (below(20) != 0) {
          table += row(cells(i, j), separator);
        }
      }
    }
    for (int harm = below(30) == 0 ? 1 + below(4) : 0; harm > 0; --harm) {
      table[static_cast<std::size_t>(below(static_cast<int>(table.size())))] = static_cast<char>(below(256));
    }
    return below(40) == 0 ? "\xef\xbb\xbf" + table : table;
  }

 private:
  int below(int n) { return static_cast<int>(draw_() % static_cast<unsigned>(n)); }
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> all{""};
    for (const char c : command_.columns) {
      if (c == ',') {
        all.emplace_back();
      } else {
        all.back().push_back(c);
      }
    }
    return all;
  }
  static std::string row(const std::vector<std::string>& cells, const std::string& separator) {
    std::string line;
    for (const std::string& cell : cells) {
      line += (line.empty() ? "" : separator) + cell;
    }
    return line + "\n";
  }
  std::vector<std::string> cells(int i, int j) {
    std::vector<std::string> all;
    for (const std::string& name : names()) {
      all.push_back(cell(name, i, j));
    }
    return all;
  }
  std::string cell(const std::string& name, int i, int j) {
    if (name == "target" || name == "subject" || name == "judge") {
      return "s" + std::to_string(i);
    }
    if (name == "expert") {
      return "e" + std::to_string(i) + "-" + std::to_string(j);
    }
    const bool rated = command_.columns.find("occasion,rater") != std::string::npos;
    if (name == "rater" || name == "item" || name == "occasion") {
      return name.substr(0, 1) + std::to_string(!rated ? j : name == "rater" ? j / 2 : j % 2);
    }
    if (name == "group") {
      const bool named = command_.arguments.find("contrasting") != std::string::npos;
      return named ? (i % 2 == 0 ? "novice" : "master") : "g" + std::to_string(i % groups_);
    }
    if (name == "attempt" || name == "index") {
      return std::to_string((name == "attempt" ? j : i) + 1);
    }
    if (name == "class" || name == "model") {
      return std::string(1, static_cast<char>((name == "class" ? 'A' : 'm') + j % 3));
    }
    return name == "value" && passFail_ ? (below(3) == 0 ? "fail" : "pass") : number(j);
  }
  std::string number(int j) {
    static const std::array kStrange{"1e200",
                                     "-1e200",
                                     "1e308",
                                     "-1e308",
                                     "1e-308",
                                     "5e-324",
                                     "1e75",
                                     "1e15",
                                     "-0",
                                     "nan",
                                     "inf",
                                     "",
                                     "abc",
                                     "1,5",
                                     "1e999",
                                     "--1",
                                     " 4 ",
                                     "0x10",
                                     "4.0000000000000009"};
    if (style_ == 0) {
      return "5";
    }
    if (style_ == 1) {
      return kStrange.at(static_cast<std::size_t>(below(6)));
    }
    if (style_ == 2) {  // groups that hardly vary and are far apart
      return std::to_string(10 * j) + "." + std::to_string(below(3));
    }
    if (style_ < 6 && below(12) == 0) {
      return kStrange.at(static_cast<std::size_t>(below(static_cast<int>(kStrange.size()))));
    }
    return style_ < 8 ? std::to_string(below(11))
                      : std::to_string(below(11)) + "." + std::to_string(below(1000));
  }

  std::mt19937 draw_;
  Command command_;
  int groups_ = 1;
  bool passFail_ = false;
  int style_ = 0;
};

/// Captures what the process writes to a stream while this lives.
class Written {
 public:
  explicit Written(std::ostream& stream) : stream_(stream), before_(stream.rdbuf(text_.rdbuf())) {}
  ~Written() { stream_.rdbuf(before_); }
  Written(const Written&) = delete;
  Written& operator=(const Written&) = delete;
  [[nodiscard]] std::string text() const { return text_.str(); }

 private:
  std::ostringstream text_;
  std::ostream& stream_;
  std::streambuf* before_;
};

/// Ends the process, reporting the table's number, if a command takes too much processor time.
class HangWatch {
 public:
  explicit HangWatch(int table) {
    table_ = table;
    (void)std::signal(SIGPROF, [](int) {
      std::array<char, 16> digits{};
      std::size_t at = digits.size();
      digits[--at] = '\n';
      for (int rest = table_; rest > 0; rest /= 10) {
        digits[--at] = static_cast<char>('0' + rest % 10);
      }
      constexpr std::string_view kWhat = "hangs at table ";
      (void)!write(STDERR_FILENO, kWhat.data(), kWhat.size());
      (void)!write(STDERR_FILENO, digits.data() + at, digits.size() - at);
      _exit(1);
    });
    setPatience(kPatience_s);
  }
  ~HangWatch() { setPatience(0); }
  HangWatch(const HangWatch&) = delete;
  HangWatch& operator=(const HangWatch&) = delete;

 private:
  static void setPatience(int seconds) {
    const itimerval patience{{}, {seconds, 0}};
    (void)setitimer(ITIMER_PROF, &patience, nullptr);
  }
  static inline volatile std::sig_atomic_t table_ = 0;
};

/// Runs a command in this process: starting the program takes a hundred times longer than a small table.
ProgramRun runHere(const std::string& arguments) {
  static int count = 1;
  static std::array<char, 7> name{"torsio"};
  static std::array<char*, 2> names{name.data(), nullptr};
  static const QCoreApplication application(count, names.data());  // for all commands of this process
  std::istringstream words("torsio " + arguments);
  std::vector<std::string> given;
  for (std::string word; words >> word;) {
    given.push_back(word);
  }
  std::vector<char*> argv;
  for (std::string& word : given) {
    argv.push_back(word.data());
  }
  const Written out(std::cout);
  const Written err(std::cerr);
  const int code = cli::runCommandLine(static_cast<int>(argv.size()), argv.data(), {});
  return {code, out.text(), err.text()};
}

/// Number of lines that are not notes on how the table is read.
int refusals(const std::string& said) {
  std::istringstream lines(said);
  int count = 0;
  for (std::string line; std::getline(lines, line);) {
    const bool note = line.find("\" is not used") != std::string::npos ||
                      line.find("--covariate names another") != std::string::npos;
    count += note ? 0 : 1;
  }
  return count;
}

int numberFrom(const char* variable, int otherwise) {
  const char* given = std::getenv(variable);
  return given == nullptr ? otherwise : std::atoi(given);
}

using TableFuzz = TableCommands;

TEST_F(TableFuzz, EveryTableGivesNumbersAndReasonsOrOneErrorLine) {
  const int tables = numberFrom("TORSIO_FUZZ_TABLES", kDefaultTables);
  const int first = numberFrom("TORSIO_FUZZ_FIRST", 1);
  const std::vector<Command> all = commands();
  int answered = 0;
  for (int seed = first; seed < first + tables; ++seed) {
    Command command = all[static_cast<std::size_t>(seed) % all.size()];
    const std::string table = RandomTable(static_cast<unsigned>(seed), command).text();
    command.arguments.replace(command.arguments.find("%1"), 2, write("table.csv", table));
    SCOPED_TRACE("table " + std::to_string(seed) + ", torsio " + command.arguments + "\n" + table);
    const HangWatch watch(seed);
    const ProgramRun run = runHere(command.arguments);
    EXPECT_NE(run.code, kInternalError) << run.err;
    if (run.code == 0) {
      ++answered;
      // dump() rejects invalid UTF-8; the parser has rejected nan and inf.
      EXPECT_NO_THROW((void)nlohmann::json::parse(run.out).dump()) << run.out;
      EXPECT_EQ(run.out.find(": null"), std::string::npos) << run.out;
    } else {
      EXPECT_LE(run.code, kInternalError) << run.err;
      EXPECT_EQ(refusals(run.err), 1) << run.err;
    }
  }
  EXPECT_GT(answered, tables / 10) << "too many tables are refused for the rest to show anything";
}

}  // namespace
}  // namespace torsio
