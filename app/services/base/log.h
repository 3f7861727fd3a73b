// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace torsio {

/// Levels of the log, the gravest first; the numbers are those of syslog and the journal.
enum class LogLevel : std::uint8_t {
  kError = 3,    ///< something that people rely on does not work
  kWarning = 4,  ///< it works, but somebody should look
  kInfo = 6,     ///< what happened, each answer of the review desk included
  kDebug = 7,
};

/// A log file and those that it was before, which are named FILE.1 (the newest) to FILE.4.
inline constexpr std::uintmax_t kLogFile_bytes = 1024 * 1024;
inline constexpr int kLogFiles = 5;

/// Who writes to the log.
enum class LogWriter : std::uint8_t {
  kService,  ///< runs without a person: without a file, the log goes to standard error
  kPerson,   ///< somebody reads its output: only a file or the journal gets the log
};

/// Opens the log of this process as log.level and log.file of configuration() say. Without a file it goes to
/// standard error, each line with journalPriority(). Without this call nothing is logged; of several the
/// latest holds. Any thread.
void openLog(LogWriter writer);

/// Returns what tells the journal the level of a line, "<4>", if it reads the standard error of this process
/// ($JOURNAL_STREAM); else an empty text.
[[nodiscard]] std::string journalPriority(LogLevel level);

/// Returns whether the log is a file.
[[nodiscard]] bool logsToFile();

/// Writes one line, if its level is wanted. Nobody's name, mark or secret belongs in it: ids and patterns do.
/// A log that cannot be written stops nobody. Any thread.
void writeLog(LogLevel level, std::string_view line);

/// Returns what an exception may say in a log: of a database error the operation without values, of another
/// refusal its kind and its sentence without what varies in it.
[[nodiscard]] std::string causeForLog(const std::exception_ptr& thrown);

/// Returns the newest lines of the file of the configuration, in their order; empty without a file.
[[nodiscard]] std::vector<std::string> newestLogLines(std::size_t most);

}  // namespace torsio
