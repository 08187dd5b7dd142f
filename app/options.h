// What each subcommand has on the command line.
#pragma once

namespace CLI {
class App;
}

namespace glimt {

struct RenderOptions;
struct MergeOptions;
struct BatchOptions;
struct ViewOptions;
struct InfoOptions;
struct CompareOptions;
struct BenchOptions;
struct AccuracyOptions;
struct DoctorOptions;

// What the options hold is valid once the command line has been parsed. Errors: usage.
void addRenderOptions(CLI::App& command, RenderOptions& options);
void addMergeOptions(CLI::App& command, MergeOptions& options);
void addBatchOptions(CLI::App& command, BatchOptions& options);
void addViewOptions(CLI::App& command, ViewOptions& options);
void addInfoOptions(CLI::App& command, InfoOptions& options);
void addCompareOptions(CLI::App& command, CompareOptions& options);
void addBenchOptions(CLI::App& command, BenchOptions& options);
void addAccuracyOptions(CLI::App& command, AccuracyOptions& options);
void addDoctorOptions(CLI::App& command, DoctorOptions& options);

}  // namespace glimt
