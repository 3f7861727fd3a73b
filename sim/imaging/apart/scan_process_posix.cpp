// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include "sim/base/error.h"
#include "sim/imaging/apart/scan_mail.h"
#include "sim/imaging/apart/scan_process.h"

namespace torsio {

namespace {

[[noreturn]] void refuseScan(const Text& what, const std::string& where, const Text& remedy) {
  throw Error(ErrorCode::kFileUnreadable, what, where, remedy);
}

/// Refuses a scan that the other process gave no answer to.
void requireScanEnded(const HelperEnd& end, const std::string& where, const std::string& program) {
  const Text again = Text::tr("Copy or export the scan again");
  switch (end.kind) {
    case HelperEnd::Kind::kEnded:
      return;
    case HelperEnd::Kind::kNotStarted:
      refuseScan(Text::tr("D04 the program that reads scans cannot be started: %1", program), where,
                 Text::tr("Install Torsio again"));
    case HelperEnd::Kind::kOutOfTime:
      refuseScan(Text::tr("D04 the reader did not come to an end with this scan within %1 s",
                          std::to_string(end.limit_s)),
                 where, Text::tr("Crop the scan to the organ"));
    case HelperEnd::Kind::kCrashed:
      break;
  }
  refuseScan(Text::tr("D04 the reader crashed on this scan (signal %1)", std::to_string(end.signal)), where,
             again);
}

}  // namespace

ScanApart scanApart(const ScanRequest& request, const ScanProgress& progress, const HelperLimits& limits) {
  requireScanRequest(request);
  const std::string where = request.source.string();
  std::error_code failed;
  if (!std::filesystem::exists(request.source, failed)) {
    throw Error(ErrorCode::kFileMissing, Text::tr("there is no such file"), where,
                Text::tr("Check the path"));
  }
  HelperAnswer answer;
  if (!answer.valid()) {
    refuseScan(Text::tr("D04 the system gives no memory to read the scan"), where,
               Text::tr("Close other programs and try again"));
  }
  const std::string program = helperProgram("TORSIO_SCAN_PROGRAM", "torsio-scan");
  std::vector<std::string> words{program, std::to_string(limits.memory_MB),
                                 std::to_string(limits.processor_s)};
  for (std::string& word : wordsOf(request)) {
    words.push_back(std::move(word));
  }
  std::string left;  // half a piece of news
  const auto news = [&progress, &left](std::span<const char> bytes) {
    left.append(bytes.begin(), bytes.end());
    while (left.size() >= 2) {
      const int step = static_cast<unsigned char>(left[0]);
      if (progress && step <= static_cast<int>(ScanStep::kMeasuring)) {
        progress(static_cast<ScanStep>(step), 0.01 * static_cast<unsigned char>(left[1]));
      }
      left.erase(0, 2);
    }
  };
  const HelperEnd end = runHelper(words, answer, limits, news);
  requireScanEnded(end, where, program);
  return {scanOfMail(answer.bytes(), where), end.processor_s, end.peak_MB};
}

}  // namespace torsio
