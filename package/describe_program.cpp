// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// describe_program man|bash|zsh|fish: prints the man page of the program surface-mesh-foliation, or
// the completion of its options for a shell, made from the options that the program has.

#include "main_program/Options.h"

#include <CLI/CLI.hpp>

#include <cstdlib>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

const std::string program = "surface-mesh-foliation";

// An option as a shell sees it.
struct Described_option
{
  std::string name;                 // with its hyphens; of the mesh it is MESH
  std::string value;                // what stands for its value; empty if it has none
  std::vector<std::string> choices; // the words that the value may be
  std::string description;
  bool is_positional, may_be_repeated;

  bool takes_file() const { return value == "FILE" || is_positional; }
  bool takes_folder() const { return value == "DIR"; }
};

// The words of the first {a,b,...} in the name of a type: CLI11 names the choices there.
std::vector<std::string> choices_of(const std::string& type_name)
{
  std::vector<std::string> choices;
  const auto begin = type_name.find('{');
  const auto end = type_name.find('}', begin);
  if (begin == std::string::npos || end == std::string::npos)
    return choices;
  std::istringstream list(type_name.substr(begin + 1, end - begin - 1));
  for (std::string choice; std::getline(list, choice, ',');)
    choices.push_back(choice);
  return choices;
}

std::string joined(const std::vector<std::string>& words, const std::string& separator)
{
  std::string text;
  for (const std::string& word : words)
    text += (text.empty() ? "" : separator) + word;
  return text;
}

std::string value_of(const CLI::Option& option, const std::vector<std::string>& choices)
{
  if (!option.get_option_text().empty())
    return option.get_option_text();
  if (option.get_expected_max() == 0)
    return ""; // a flag
  if (!choices.empty())
    return joined(choices, "|");
  return option.get_type_name().find("INT") == 0 ? "N" : "NUMBER";
}

std::vector<Described_option> options_of(const CLI::App& app)
{
  std::vector<Described_option> options;
  for (const CLI::Option* option : app.get_options())
  {
    Described_option described;
    described.is_positional = option->get_positional();
    described.name =
      described.is_positional ? option->get_name(true) : "--" + option->get_lnames().front();
    described.choices = choices_of(option->get_type_name());
    described.value = described.is_positional ? "" : value_of(*option, described.choices);
    described.description = option->get_description();
    described.may_be_repeated = described.description.find("may be repeated") != std::string::npos;
    options.push_back(described);
  }
  return options;
}

// text with a backslash before each of the characters
std::string escaped(const std::string& text, const std::string& characters)
{
  std::string result;
  for (const char c : text)
  {
    if (characters.find(c) != std::string::npos)
      result += '\\';
    result += c;
  }
  return result;
}

// ===  The man page

std::string roff(const std::string& text)
{
  return escaped(text, "\\-");
}

void print_man_page(const std::vector<Described_option>& options, const std::string& description)
{
  std::cout << ".TH SURFACE\\-MESH\\-FOLIATION 1 \"\" \"Surface_mesh_foliation "
            << CGAL_SURFACE_MESH_FOLIATION_VERSION << "\" \"User Commands\"\n"
            << ".SH NAME\n"
            << roff(program + " - " + description) << "\n.SH SYNOPSIS\n"
            << ".B " << roff(program) << "\n\\fIMESH\\fR [\\fIOPTION\\fR]...\n"
            << R"(.SH DESCRIPTION
Reads a triangle mesh, cuts it into one disk or cylinder for each pole and loop by a harmonic
measured foliation, and prints the graph of these components, which is embedded in space.
Poles and loops are given by options, or found: by default, both are.
With
.B \-\-output
files are written as well: the graph in GraphML and DOT, the segmented mesh in PLY, and the skeleton
in PLY and SWC; all of them in VTP, too.
.PP
Every result is checked.
A mesh that is no clean surface of triangles is refused, with a list of what
.B \-\-repair
would do.
.SH OPTIONS
)";
  for (const Described_option& option : options)
  {
    std::cout << ".TP\n" << (option.is_positional ? "\\fI" : "\\fB") << roff(option.name) << "\\fR";
    if (!option.value.empty())
      std::cout << " \\fI" << roff(option.value) << "\\fR";
    std::cout << '\n' << roff(option.description) << ".\n";
  }
  std::cout << R"(.SH EXIT STATUS
0 if the graph was computed, and 1 after an error in options or input, which one line on the
standard error stream describes.
.SH EXAMPLES
The graph of a mesh, with poles and loops that are found, and its files in the folder
.IR result :
.PP
.RS
.B surface\-mesh\-foliation mesh.off \-\-output result
.RE
.PP
The same for a scan, repaired, with at most six poles, as JSON:
.PP
.RS
.B surface\-mesh\-foliation scan.ply \-\-repair \-\-auto\-poles 6 \-\-json
.RE
.SH SEE ALSO
The manual, chapter
.IR "Files and the Main Program" .
)";
}

// ===  Completions

void print_bash_completion(const std::vector<Described_option>& options, const std::string&)
{
  std::vector<std::string> names, with_numbers;
  std::cout << "# bash completion for " << program << ", made from its options\n"
            << "_surface_mesh_foliation()\n{\n"
            << "  local word=${COMP_WORDS[COMP_CWORD]}\n"
            << "  COMPREPLY=()\n"
            << "  case ${COMP_WORDS[COMP_CWORD - 1]} in\n";
  for (const Described_option& option : options)
  {
    if (option.is_positional)
      continue; // names of files are what bash falls back to
    names.push_back(option.name);
    if (option.value.empty() || option.takes_file())
      continue;
    if (option.choices.empty() && !option.takes_folder())
    {
      with_numbers.push_back(option.name);
      continue;
    }
    std::cout << "    " << option.name << ")\n      mapfile -t COMPREPLY < <(compgen "
              << (option.takes_folder() ? "-d" : "-W '" + joined(option.choices, " ") + '\'')
              << " -- \"$word\")\n      return ;;\n";
  }
  std::cout << "    " << joined(with_numbers, " | ") << ")\n"
            << "      compopt +o default 2>/dev/null\n"
            << "      return ;;\n"
            << "  esac\n"
            << "  if [[ $word == -* ]]; then\n"
            << "    mapfile -t COMPREPLY < <(compgen -W '" << joined(names, " ")
            << "' -- \"$word\")\n"
            << "  fi\n}\n"
            << "complete -o default -F _surface_mesh_foliation " << program << "\n";
}

void print_zsh_completion(const std::vector<Described_option>& options, const std::string&)
{
  const auto quoted = [](const std::string& text) {
    std::string result; // in single quotes
    for (const char c : escaped(text, "[]:\\"))
      result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result;
  };
  std::cout << "#compdef " << program << "\n_arguments";
  for (const Described_option& option : options)
  {
    std::cout << " \\\n  '";
    if (option.is_positional)
    {
      std::cout << ":mesh:_files'";
      continue;
    }
    std::cout << (option.may_be_repeated ? "*" : "") << option.name << '['
              << quoted(option.description) << ']';
    if (!option.value.empty())
    {
      std::cout << ':' << quoted(option.value) << ':';
      if (option.takes_file())
        std::cout << "_files";
      else if (option.takes_folder())
        std::cout << "_files -/";
      else if (!option.choices.empty())
        std::cout << '(' << joined(option.choices, " ") << ')';
    }
    std::cout << '\'';
  }
  std::cout << '\n';
}

void print_fish_completion(const std::vector<Described_option>& options, const std::string&)
{
  for (const Described_option& option : options)
  {
    if (option.is_positional)
      continue; // names of files are what fish falls back to
    std::cout << "complete -c " << program << " -l " << option.name.substr(2);
    if (option.takes_file())
      std::cout << " -r";
    else if (option.takes_folder())
      std::cout << " -x -a '(__fish_complete_directories)'";
    else if (!option.value.empty())
      std::cout << " -x";
    if (!option.choices.empty())
      std::cout << " -a '" << joined(option.choices, " ") << '\'';
    std::cout << " -d '" << escaped(option.description, "'\\") << "'\n";
  }
}

} // namespace

int main(int argc, char* argv[])
{
  using Printer = void (*)(const std::vector<Described_option>&, const std::string&);
  const std::map<std::string, Printer> printers = {{"man", print_man_page},
                                                   {"bash", print_bash_completion},
                                                   {"zsh", print_zsh_completion},
                                                   {"fish", print_fish_completion}};
  const auto printer = printers.find(argc == 2 ? argv[1] : "");
  if (printer == printers.end())
  {
    std::cerr << "usage: describe_program man|bash|zsh|fish\n";
    return EXIT_FAILURE;
  }
  main_program::Options options;
  CLI::App app(main_program::description);
  main_program::set_up(app, options);
  printer->second(options_of(app), app.get_description());
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
}
