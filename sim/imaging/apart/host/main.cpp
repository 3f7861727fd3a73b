// SPDX-License-Identifier: GPL-3.0-or-later
// torsio-scan MEMORY_MB PROCESSOR_S ANSWER REQUEST...: reads a scan for Torsio within limits and leaves the
// surface of the organ, a preview (ScanAnswer says which), or the refusal, in the file that it was given.
// Started by Torsio, never by hand.
#include <array>
#include <cstdlib>
#include <exception>
#include <new>
#include <span>
#include <string>

#include "sim/core/error.h"
#include "sim/geometry/apart/helper_process.h"
#include "sim/geometry/apart/mesh_mail.h"
#include "sim/imaging/apart/scan_mail.h"
#include "sim/imaging/surface/scan_surface.h"

namespace torsio {
namespace {

void tellStep(ScanStep step, double fraction) {
  const std::array<char, 2> news{static_cast<char>(step), static_cast<char>(100.0 * fraction)};
  tellParent(news);
}

/// The answer to a request, or its refusal; empty if the words are not a request.
std::string answerTo(ScanAnswer wanted, std::span<const char* const> words, const std::string& memory_MB) {
  const std::string where = words.empty() ? "" : words.front();
  try {
    if (wanted == ScanAnswer::kTool) {
      const auto tool = toolRequestOfWords(words);
      return tool ? mailOf(toolOfScan(*tool, &tellStep)) : "";
    }
    const auto request = requestOfWords(words);
    if (!request) {
      return "";
    }
    if (wanted == ScanAnswer::kSurface) {
      return mailOf(surfaceOfScan(*request, &tellStep));
    }
    return mailOf(previewOfScan(*request, wanted == ScanAnswer::kOrgan, &tellStep));
  } catch (const Error& error) {
    return mailOf(error);
  } catch (const std::bad_alloc&) {
    return mailOf(Error(ErrorCode::kFileUnreadable,
                        Text::tr("D15 the scan needs more than %1 MB of memory", memory_MB), where,
                        Text::tr("Crop the scan, or export it with larger voxels")));
  } catch (const std::exception&) {  // its words may come from the file
    return mailOf(Error(ErrorCode::kFileUnreadable, Text::tr("D04 the reader failed on this scan"), where,
                        Text::tr("Copy or export the scan again")));
  }
}

}  // namespace
}  // namespace torsio

int main(int argc, char** argv) {
  constexpr int kFirstWord = 4;
  if (argc < kFirstWord ||
      !torsio::bindHelper(std::strtoull(argv[1], nullptr, 10), std::strtoull(argv[2], nullptr, 10))) {
    return EXIT_FAILURE;
  }
  const long wanted = std::strtol(argv[3], nullptr, 10);
  if (wanted < 0 || wanted > static_cast<long>(torsio::ScanAnswer::kTool)) {
    return EXIT_FAILURE;
  }
  const std::string answer =
      torsio::answerTo(static_cast<torsio::ScanAnswer>(wanted),
                       {argv + kFirstWord, static_cast<std::size_t>(argc - kFirstWord)}, argv[1]);
  return !answer.empty() && torsio::leaveAnswer(answer) ? EXIT_SUCCESS : EXIT_FAILURE;
}
