#include "app/commands.h"
#include "renderer/core/error.h"

namespace glimt {

int runView(const ViewOptions&) {
  throw Error(ErrorKind::usage, "this build has no viewer");
}

}  // namespace glimt
