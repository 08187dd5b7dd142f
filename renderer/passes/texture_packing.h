// Where pictures are put in one texture.
#pragma once

#include <cstdint>
#include <vector>

namespace glimt {

// In texels, from the upper left corner.
struct AtlasRectangle {
  int x = 0;
  int y = 0;
  int width = 0;  // 0: the picture is not in the atlas
  int height = 0;
};

struct AtlasPlan {
  int width = 0;  // of the atlas; 0 without pictures
  int height = 0;
  std::vector<AtlasRectangle> rectangles;  // for each picture
  std::vector<int> halvings;               // how often each picture has to be halved before
};

// Places for pictures of those sizes; x and y are ignored, and so are pictures of width 0. The
// atlas has at most `most_side` texels a side, and takes `most_bytes`: where that is too little,
// the largest picture is halved until it is enough.
AtlasPlan planAtlas(const std::vector<AtlasRectangle>& sizes, int most_side,
                    std::uint64_t most_bytes);

}  // namespace glimt
