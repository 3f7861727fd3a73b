// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace torsio {

/// The one way in which text from outside - of a peer, a file, another program - reaches people. Text::str()
/// and worded() use it for every sentence, the command line for every byte that it prints; who keeps a name
/// from outside uses plainLine() where it arrives.

/// Returns valid UTF-8 without control characters other than tab and newline, and without those that turn the
/// direction of writing, end a line unseen or are never seen: U+FFFD stands for each, and for each byte that
/// is not UTF-8. Any thread.
[[nodiscard]] std::string plainText(std::string_view text);

/// As plainText(), for one line of at most `most` characters: blanks stand for tabs and ends of lines, and
/// "..." follows what was cut off.
[[nodiscard]] std::string plainLine(std::string_view text, std::size_t most = 200);

/// Returns the length without a character at the end of which bytes are still to come.
[[nodiscard]] std::size_t completeBytes(std::string_view text);

}  // namespace torsio
