// What was typed, taken apart and handed to the subcommand.
#pragma once

#include <string>
#include <vector>

namespace glimt {

// `arguments` is without the program's name. Returns the exit status. Errors: usage, and those of
// the subcommands.
int runCommandLine(std::vector<std::string> arguments);

}  // namespace glimt
