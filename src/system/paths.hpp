// The program's own files: Lua modules, cards, documents, sample meshes and decks.
#pragma once
#include <string>
#include <vector>

namespace fabricsh {

// Folders that hold lua/, share/cards/, share/doc/, scripts/ and meshes/, in order of
// preference: $FABRICSH_HOME, the installed share/fabricsh beside the program, the source
// tree (for a program in its build tree). Only existing folders, without a trailing slash.
std::vector<std::string> data_roots();

// The first existing <root>/<relative>, or empty: data_file("share/cards/denim.lua").
std::string data_file(const std::string& relative);

// The file of an optional part, installed or in the build tree; empty if there is none.
std::string module_file(const std::string& name);

// The running program, absolute; empty if the system does not provide it.
std::string program_path();

}  // namespace fabricsh
