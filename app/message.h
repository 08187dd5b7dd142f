// One line on standard error, for people.
#pragma once

#include <string_view>

namespace glimt {

// "glimt: text". Line breaks and other control characters in it become spaces: file names and
// drivers' messages may hold any.
void say(std::string_view text);

// The same without a name in front.
void sayPlain(std::string_view text);

}  // namespace glimt
