#pragma once

#include <string>
#include <string_view>

namespace glimt {

// A PNG's bytes as a URL that holds them, for pages that stand alone. Empty for none.
std::string pngUrl(std::string_view png);

}  // namespace glimt
