// Any bytes as a picture. GLIMT_FUZZ_DECODE names the decoder.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "renderer/core/image_codecs.h"
#include "tests/fuzz/refusal.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace glimt;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  demandLoadedOrRefused([&] {
    const Image image = GLIMT_FUZZ_DECODE(bytes);
    const std::size_t pixels =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    if (image.pixels.size() != pixels) std::abort();
  });
  return 0;
}
