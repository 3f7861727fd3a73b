// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/manual.h"

#include <algorithm>
#include <functional>
#include <sstream>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

namespace torsio::cli {

namespace {

std::vector<const CLI::App*> partsOf(const CLI::App& command) {
  return command.get_subcommands([](const CLI::App*) { return true; });
}

/// A group of options is a part without a name.
std::vector<const CLI::Option*> allOptionsOf(const CLI::App& command) {
  const std::vector<const CLI::Option*> own = command.get_options();
  std::vector<const CLI::Option*> all(own.begin(), own.end());
  for (const CLI::App* part : partsOf(command)) {
    if (part->get_name().empty()) {
      for (const CLI::Option* option : allOptionsOf(*part)) {
        if (option != part->get_help_ptr()) {
          all.push_back(option);
        }
      }
    }
  }
  return all;
}

/// Calls `visit` with "torsio export workbook" and its command, for each command, the program first.
void visitCommands(const CLI::App& command, const std::string& path,
                   const std::function<void(const std::string&, const CLI::App&)>& visit) {
  visit(path, command);
  for (const CLI::App* part : partsOf(command)) {
    if (!part->get_name().empty()) {
      visitCommands(*part, path + " " + part->get_name(), visit);
    }
  }
}

/// "--name", "-h": the names of an option; none of a positional one.
std::vector<std::string> namesOf(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) {
    names.push_back("-" + name);
  }
  for (const std::string& name : option.get_lnames()) {
    names.push_back("--" + name);
  }
  return names;
}

std::string joinedBy(const std::vector<std::string>& words, const std::string& between) {
  std::string all;
  for (const std::string& word : words) {
    all.append(all.empty() ? "" : between).append(word);
  }
  return all;
}

/// "light dark" of an option whose type says TEXT:{light,dark}; "" of any other.
std::string choicesOf(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t begin = type.find('{');
  const std::size_t end = type.find('}', begin);
  if (begin == std::string::npos || end == std::string::npos) {
    return {};
  }
  std::string choices = type.substr(begin + 1, end - begin - 1);
  std::replace(choices.begin(), choices.end(), ',', ' ');
  return choices;
}

bool takesValue(const CLI::Option& option) {
  return option.get_items_expected_max() > 0;
}

/// A line of roff: what would be a request or an escape is neither, and a hyphen is a minus.
std::string roff(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else {
      out += c == '\n' ? ' ' : c;
    }
  }
  return !out.empty() && (out[0] == '.' || out[0] == '\'') ? "\\&" + out : out;
}

void writeOption(std::ostream& out, const CLI::Option& option) {
  const std::vector<std::string> names = namesOf(option);
  const std::string type = takesValue(option) ? option.get_type_name() : std::string();
  const std::string preset = option.get_default_str();
  out << ".TP\n";
  if (names.empty()) {
    out << "\\fI" << roff(option.get_name(true)) << "\\fR\n";
  } else {
    out << "\\fB" << roff(joinedBy(names, ", ")) << "\\fR"
        << (type.empty() ? "" : " \\fI" + roff(type) + "\\fR") << (preset.empty() ? "" : roff("=" + preset))
        << "\n";
  }
  out << roff(option.get_description()) << "\n";
}

}  // namespace

std::string manualPage(const CLI::App& program, const std::string& version) {
  std::ostringstream out;
  const std::string& name = program.get_name();
  out << ".\\\" SPDX-License-Identifier: GPL-3.0-or-later\n.TH TORSIO 1 \"\" \"" << roff(version)
      << "\" \"Torsio\"\n.SH NAME\n"
      << name << " \\- " << roff(program.get_description()) << "\n.SH SYNOPSIS\n\\fB" << name
      << "\\fR [\\fIoptions\\fR]\n.br\n\\fB" << name
      << "\\fR \\fIcommand\\fR [\\fIoptions\\fR]\n.SH DESCRIPTION\n"
      << roff(
             "Without a command Torsio opens its window. Commands need no display. They print results to "
             "standard output, messages and progress to standard error.")
      << "\n.SH OPTIONS\n";
  bool begun = false;
  visitCommands(program, name, [&](const std::string& path, const CLI::App& command) {
    if (&command != &program) {
      out << (std::exchange(begun, true) ? "" : ".SH COMMANDS\n") << ".SS " << roff(path) << "\n"
          << roff(command.get_description()) << "\n";
    }
    for (const CLI::Option* option : allOptionsOf(command)) {
      if (&command == &program || option != command.get_help_ptr()) {
        writeOption(out, *option);
      }
    }
  });
  out << ".SH EXIT STATUS\n"
      << roff(
             "0 done, 2 usage, 3 file missing, 4 file unreadable, 5 cannot write, 6 bad mesh, 7 bad "
             "parameter, "
             "8 bad data, 9 database, 10 newer schema, 11 permission, 12 device, 13 verification failed, "
             "14 folded, 70 internal error.")
      << "\n.SH SEE ALSO\n"
      << roff("docs/cli.md of the installed documentation, for the keys of JSON and worked examples.")
      << "\n";
  return out.str();
}

std::string bashCompletion(const CLI::App& program) {
  std::ostringstream paths;
  std::ostringstream words;
  std::ostringstream values;
  visitCommands(program, program.get_name(), [&](const std::string& path, const CLI::App& command) {
    std::vector<std::string> here;
    for (const CLI::App* part : partsOf(command)) {
      if (!part->get_name().empty()) {
        here.push_back(part->get_name());
        paths << (paths.tellp() > 0 ? " | \\\n      " : "      ") << '"' << path << ' ' << part->get_name()
              << '"';
      }
    }
    for (const CLI::Option* option : allOptionsOf(command)) {
      const std::vector<std::string> names = namesOf(*option);
      here.insert(here.end(), names.begin(), names.end());
      if (!names.empty() && takesValue(*option)) {
        values << "    \"" << path << ' ' << joinedBy(names, "\" | \"" + path + " ") << "\") words=\""
               << choicesOf(*option) << "\" ;;\n";
      }
    }
    words << "      \"" << path << "\") words=\"" << joinedBy(here, " ") << "\" ;;\n";
  });
  return "# SPDX-License-Identifier: GPL-3.0-or-later\n"
         "# Bash completion of torsio, made by 'torsio manual completion'. Where nothing fits: names of "
         "files.\n"
         "_torsio() {\n"
         "  local path=torsio current=\"${COMP_WORDS[COMP_CWORD]}\" words= i\n"
         "  for ((i = 1; i < COMP_CWORD; i++)); do\n"
         "    case \"$path ${COMP_WORDS[i]}\" in\n" +
         paths.str() +
         ")\n        path=\"$path ${COMP_WORDS[i]}\" ;;\n    esac\n  done\n"
         "  case \"$path ${COMP_WORDS[COMP_CWORD - 1]}\" in\n" +
         values.str() + "    *) case \"$path\" in\n" + words.str() +
         "    esac ;;\n  esac\n"
         "  COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n"
         "}\n"
         "complete -o default -F _torsio torsio\n";
}

}  // namespace torsio::cli
