// Leaves out of a shader's text what its `#if`s leave out, so that what is composed reads as it
// runs.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace glimt {

// The text without `#if`, `#elif`, `#else` and `#endif` lines and without the branches that are not
// taken. Conditions are made of names, `!`, `&&`, `||` and parentheses. `#ifdef` and other
// directives stay as they are. Errors: failed, for a name that has no value, for a condition that
// is made otherwise, and for branches that do not end.
std::string takeBranches(std::string_view text, const std::map<std::string, bool>& values);

}  // namespace glimt
