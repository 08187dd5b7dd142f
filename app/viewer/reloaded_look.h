// What becomes of changes when the file under them changes.
#pragma once

#include "app/viewer/look.h"

namespace glimt {

// `look` was made by changing `before`, the file's own as it was; `now` is the file's own as it is.
// What was not changed follows the file. Changes of materials stay where there are as many as
// before.
Look reloadedLook(const Look& look, const Look& before, const Look& now);

}  // namespace glimt
