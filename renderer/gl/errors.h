// What GL has to say about the calls made so far.
#pragma once

#include <string_view>

#include "renderer/core/error.h"
#include "renderer/gl/functions.h"

namespace glimt::gl {

// Forgets errors that earlier calls have left, so that checkErrors() speaks of later ones alone.
void clearErrors(const Functions& gl);

// `doing` is what the calls were for, as in "while making a texture". Errors: of that kind, when GL
// has noted an error, is out of memory, or has lost the context.
void checkErrors(const Functions& gl, std::string_view doing, ErrorKind kind = ErrorKind::failed);

}  // namespace glimt::gl
