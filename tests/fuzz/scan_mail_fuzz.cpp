// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as the answer of the scan reading process: the result must be an Error or an answer. The first
// byte selects the requested answer.
#include "sim/core/error.h"
#include "sim/imaging/apart/scan_mail.h"
#include "tests/fuzz/fuzz_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) {
    return 0;
  }
  const std::string_view text = torsio::fuzz::textOf(data + 1, size - 1);
  const std::span<const char> bytes(text.data(), text.size());
  try {
    switch (data[0] % 3) {
      case 0:
        static_cast<void>(torsio::scanOfMail(bytes, "fuzz"));
        break;
      case 1:
        static_cast<void>(torsio::previewOfMail(bytes, "fuzz"));
        break;
      default:
        static_cast<void>(torsio::toolOfMail(bytes, "fuzz"));
    }
  } catch (const torsio::Error&) {
  }
  return 0;
}
