// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/base/log.h"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <mutex>
#include <optional>
#include <sstream>
#include <sys/stat.h>
#include <system_error>
#include <typeinfo>

#include <QByteArray>
#include <QDateTime>
#include <QFile>
#include <QtGlobal>

#include "app/services/base/configuration.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/file_lock.h"
#include "sim/core/plain_text.h"

namespace torsio {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestLogLine = 1000;

struct OpenedLog {
  std::mutex mutex;
  fs::path file;  // empty: standard error
  bool standardError = false;
  std::optional<LogLevel> least;  // empty: not open
};

OpenedLog& theLog() {
  static OpenedLog one;
  return one;
}

LogLevel levelNamed(const std::string& name) {
  return name == "error"     ? LogLevel::kError
         : name == "warning" ? LogLevel::kWarning
         : name == "debug"   ? LogLevel::kDebug
                             : LogLevel::kInfo;
}

const char* nameOf(LogLevel level) {
  switch (level) {
    case LogLevel::kError:
      return "error";
    case LogLevel::kWarning:
      return "warning";
    case LogLevel::kInfo:
      return "info";
    case LogLevel::kDebug:
      break;
  }
  return "debug";
}

/// Returns whether standard error is the stream that the journal names as its own, "device:inode".
bool isJournal() {
#ifdef _WIN32
  return false;
#else
  struct stat own {};
  return fstat(2, &own) == 0 && qgetenv("JOURNAL_STREAM") == QByteArray::number(qulonglong(own.st_dev)) +
                                                                 ":" +
                                                                 QByteArray::number(qulonglong(own.st_ino));
#endif
}

fs::path olderFile(const fs::path& file, int age) {
  return age == 0 ? file : fs::path(file.string() + "." + std::to_string(age));
}

/// Makes room for a new file. Of several programs that write to it one does so.
void rotate(const fs::path& file) {
  const FileLock lock(lockNameOf(file));
  std::error_code ignored;
  if (!lock.held() || fs::file_size(file, ignored) < kLogFile_bytes || ignored) {
    return;
  }
  for (int age = kLogFiles - 1; age > 0; --age) {
    fs::rename(olderFile(file, age - 1), olderFile(file, age), ignored);
  }
}

/// Returns false if the file cannot be written.
bool appendTo(const fs::path& file, const std::string& line) {
  std::error_code ignored;
  if (fs::file_size(file, ignored) >= kLogFile_bytes && !ignored) {
    rotate(file);
  }
  QFile out(QString::fromStdString(file.string()));
  return out.open(QIODevice::WriteOnly | QIODevice::Append | QIODevice::Unbuffered) &&
         out.write(line.data(), static_cast<qint64>(line.size())) == static_cast<qint64>(line.size());
}

}  // namespace

void openLog(LogWriter writer) {
  OpenedLog& log = theLog();
  const std::lock_guard lock(log.mutex);
  log.file = configured(kConfiguredLogFile).value_or("");
  log.least = levelNamed(configured(kConfiguredLogLevel).value_or("info"));
  log.standardError = writer == LogWriter::kService || isJournal();
}

std::string journalPriority(LogLevel level) {
  return isJournal() ? "<" + std::to_string(static_cast<int>(level)) + ">" : "";
}

bool logsToFile() {
  OpenedLog& log = theLog();
  const std::lock_guard lock(log.mutex);
  return !log.file.empty();
}

void writeLog(LogLevel level, std::string_view line) {
  OpenedLog& log = theLog();
  const std::lock_guard lock(log.mutex);
  if (!log.least || level > *log.least) {
    return;
  }
  const std::string plain = plainLine(line, kLongestLogLine);
  if (!log.file.empty()) {
    const std::string utc =
        QDateTime::currentDateTimeUtc().toString(QStringLiteral("yyyy-MM-ddTHH:mm:ss.zzzZ")).toStdString();
    if (appendTo(log.file, utc + " " + nameOf(level) + ": " + plain + "\n")) {
      return;
    }
  }
  if (log.standardError) {
    std::cerr << journalPriority(level) << plain << "\n";
  }
}

std::string causeForLog(const std::exception_ptr& thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const Error& error) {
    // A text without arguments may be a name: only a literal has places for what varies.
    const Text& happened = error.happenedText();
    return error.code() == ErrorCode::kDatabase
               ? error.happened()
               : "error of kind " + std::to_string(static_cast<int>(error.code())) +
                     (happened.arguments().empty() ? "" : ": " + happened.pattern());
  } catch (const std::exception& error) {
    return typeid(error).name();
  } catch (...) {
    return "unknown error";
  }
}

std::vector<std::string> newestLogLines(std::size_t most) {
  std::vector<std::string> lines;
  const fs::path file = configured(kConfiguredLogFile).value_or("");
  for (int age = kLogFiles - 1; age >= 0 && !file.empty(); --age) {
    const fs::path part = olderFile(file, age);
    std::error_code ignored;
    if (!fs::is_regular_file(part, ignored)) {
      continue;
    }
    std::istringstream text(readFile(part));
    for (std::string line; std::getline(text, line);) {
      lines.push_back(plainLine(line, 2 * kLongestLogLine));
    }
  }
  lines.erase(lines.begin(),
              lines.begin() + static_cast<std::ptrdiff_t>(lines.size() - std::min(most, lines.size())));
  return lines;
}

}  // namespace torsio
