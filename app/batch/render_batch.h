// A batch that glimt render is asked for.
#pragma once

#include "app/batch/batch_job.h"
#include "app/commands.h"

namespace glimt {

// Of options with isBatch(). Errors: usage, where the output is not one folder.
BatchJob batchJobOf(const RenderOptions& options);

}  // namespace glimt
