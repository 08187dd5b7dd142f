// The libraries that read files for glimt, compiled here so that the sanitizers see into them: in
// the shared libraries of the system they would notice only what happens to memory in libc.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image.h>
#include <stb_image_write.h>

#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#define TINYEXR_IMPLEMENTATION
#include <tinyexr.h>
