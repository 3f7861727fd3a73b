# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by the checks of .ci: the compile commands of the release build as another compiler can follow them.
source app/setup.sh

lint="$root/build/lint"

# plain_commands: writes $lint/compile_commands.json, the commands of build/release without precompiled headers, which
# only GCC reads, and with each source by itself. A source that compiles so includes what it uses.
plain_commands() {
  [ -f "$build/compile_commands.json" ] || fail "nothing is configured yet: run tests/run first"
  mkdir -p "$lint/passed"
  sed -E 's# -Winvalid-pch -include [^ ]*cmake_pch\.hxx##' "$build/compile_commands.json" | awk '
    function tell(entry) { printf "%s%s", told++ ? ",\n" : "[\n", entry }
    /^[{]/ { entry = ""; together = "" }
    { entry = entry $0 "\n" }
    /"file": .*\/unity_[0-9]+_cxx[.]cxx"/ { together = $0; sub(/^[^:]*: "/, "", together); sub(/".*/, "", together) }
    !/^[}]/ { next }
    { sub(/[}],?\n$/, "}", entry) }
    together == "" { tell(entry); next }
    {
      while ((getline line < together) > 0) {
        if (line !~ /^#include "/) continue
        sub(/^#include "/, "", line); sub(/".*/, "", line)
        one = entry
        gsub(together, line, one)
        tell(one)
      }
      close(together)
    }
    END { print "\n]" }' >"$lint/compile_commands.json"
}

# command_of FOLDER: compiler and flags of the first source in FOLDER or below it, without input and output.
command_of() {
  sed -nE 's#^ *"command": "(.*)",?$#\1#p' "$lint/compile_commands.json" | grep -m 1 -F -- "-c $root/$1/" |
    sed -E 's#^[^ ]*ccache ##; s# -o [^ ]* -c .*$##; s#\\"#"#g; s#\\\\#\\#g'
}
