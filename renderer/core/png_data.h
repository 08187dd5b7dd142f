// The packed data of a PNG, looked at before stb_image unpacks them.
#pragma once

#include <string_view>

namespace glimt {

// Throws Error input where the data unpack to much more than the header's pixels take. stb_image
// unpacks all of them first: a thousand bytes of memory for each byte of a hostile file.
// `bytes` is a PNG whose header stb_image has accepted, of a size that is sensible.
void demandBoundedPngData(std::string_view bytes);

}  // namespace glimt
