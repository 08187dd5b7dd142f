#include "app/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <functional>
#include <memory>
#include <system_error>

#include "app/commands.h"
#include "app/options.h"
#include "renderer/core/error.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

constexpr const char* kDescription =
    "glimt, a path tracer over OpenGL ES 2.0. `glimt SCENE` is the same as `glimt view SCENE`.\n";
constexpr const char* kFooter =
    "\nExit status: 0 done, 1 failed while running, 2 wrong usage, 3 the input cannot be used, "
    "4 no usable GL.";

// CLI11's own would add what excludes what, which makes the lines too long to read.
class HelpFormat : public CLI::Formatter {
 public:
  std::string make_option_opts(const CLI::Option* option) const override {
    return " " + option->get_type_name();
  }
};

bool looksLikeScene(const std::string& argument) {
  constexpr std::array kExtensions{".obj", ".json", ".gltf", ".glb"};
  std::string extension = std::filesystem::path(argument).extension();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  std::error_code ignored;
  return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end() ||
         std::filesystem::exists(argument, ignored);
}

std::string wordsOf(const CLI::ParseError& error) {
  std::string words = error.what();
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
    return words.substr(0, words.find(':')) + " takes one value, and is given once";
  }
  if (words.starts_with("The ")) words[0] = 't';
  return words;
}

class CommandLine {
 public:
  CommandLine();

  int run(std::vector<std::string> arguments);

 private:
  struct Command {
    CLI::App* app;
    std::function<int()> run;
  };

  // Null where there is none.
  CLI::App* commandNamed(const std::string& name) const;
  void expandShortForms(std::vector<std::string>& arguments) const;
  std::string unknown(const std::string& name) const;
  // False when the arguments asked for help or the version, which is then printed.
  bool parse(const std::vector<std::string>& arguments);

  CLI::App app_{kDescription, "glimt"};
  RenderOptions render_;
  MergeOptions merge_;
  BatchOptions batch_;
  ViewOptions view_;
  InfoOptions info_;
  CompareOptions compare_;
  BenchOptions bench_;
  AccuracyOptions accuracy_;
  DoctorOptions doctor_;
  std::vector<Command> commands_;
};

CommandLine::CommandLine() {
  app_.set_version_flag("--version", "glimt " GLIMT_VERSION, "Print the version and exit");
  app_.require_subcommand(1);
  app_.formatter(std::make_shared<HelpFormat>());
  app_.footer(kFooter);

  CLI::App* const render = app_.add_subcommand("render", "Scene in, pictures out");
  addRenderOptions(*render, render_);
  commands_.push_back(
      {render, [this] { return render_.isBatch() ? runBatch(render_) : runRender(render_); }});

  CLI::App* const merge = app_.add_subcommand("merge", "Shares of a picture's samples into one");
  addMergeOptions(*merge, merge_);
  commands_.push_back({merge, [this] { return runMerge(merge_); }});

  CLI::App* const batch =
      app_.add_subcommand("batch", "Many pictures of a scene: variants, angles, sizes");
  addBatchOptions(*batch, batch_);
  commands_.push_back({batch, [this] { return runBatch(batch_); }});

  CLI::App* const view = app_.add_subcommand("view", "A window to look around in");
  addViewOptions(*view, view_);
  commands_.push_back({view, [this] { return runView(view_); }});

  CLI::App* const info = app_.add_subcommand("info", "What a scene holds and what it calls for");
  addInfoOptions(*info, info_);
  commands_.push_back({info, [this] { return runInfo(info_); }});

  CLI::App* const compare = app_.add_subcommand("compare", "How far picture A is from picture B");
  addCompareOptions(*compare, compare_);
  commands_.push_back({compare, [this] { return runCompare(compare_); }});

  CLI::App* const bench = app_.add_subcommand("bench", "How fast the renderer's parts are here");
  addBenchOptions(*bench, bench_);
  commands_.push_back({bench, [this] { return runBench(bench_); }});

  CLI::App* const accuracy =
      app_.add_subcommand("accuracy", "What accuracy costs in time, as a report");
  addAccuracyOptions(*accuracy, accuracy_);
  commands_.push_back({accuracy, [this] { return runAccuracy(accuracy_); }});

  CLI::App* const doctor = app_.add_subcommand("doctor", "Whether pictures come out right here");
  addDoctorOptions(*doctor, doctor_);
  commands_.push_back({doctor, [this] { return runDoctor(doctor_); }});
}

CLI::App* CommandLine::commandNamed(const std::string& name) const {
  const auto found = std::find_if(commands_.begin(), commands_.end(), [&](const Command& command) {
    return command.app->get_name() == name;
  });
  return found == commands_.end() ? nullptr : found->app;
}

void CommandLine::expandShortForms(std::vector<std::string>& arguments) const {
  if (arguments.empty()) arguments = {"--help"};
  const std::string& first = arguments.front();
  if (first.starts_with('-') || commandNamed(first) != nullptr) return;
  if (!looksLikeScene(first)) {
    throw Error(ErrorKind::usage, unknown(first));
  }
  arguments.insert(arguments.begin(), "view");
}

std::string CommandLine::unknown(const std::string& name) const {
  std::vector<std::string> names;
  for (const Command& command : commands_) names.push_back(command.app->get_name());
  const std::string guess = nearest(name, names);
  const std::string hint = guess.empty() ? "" : fmt::format("did you mean {}? ", guess);
  return fmt::format("there is no command or file '{}'; {}see glimt --help", name, hint);
}

bool CommandLine::parse(const std::vector<std::string>& arguments) {
  const CLI::App* const command = commandNamed(arguments.front());
  const auto wrongUsage = [&](const std::string& what) {
    const std::string name = command == nullptr ? "" : command->get_name() + " ";
    return Error(ErrorKind::usage, fmt::format("{}; see glimt {}--help", what, name));
  };
  try {
    app_.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    return true;
  } catch (const CLI::Success& asked) {
    app_.exit(asked);
    return false;
  } catch (const CLI::ParseError& error) {
    throw wrongUsage(wordsOf(error));
  } catch (const Error& error) {
    throw wrongUsage(error.what());
  }
}

int CommandLine::run(std::vector<std::string> arguments) {
  expandShortForms(arguments);
  if (!parse(arguments)) return 0;
  for (const Command& command : commands_) {
    if (command.app->parsed()) return command.run();
  }
  return 0;
}

}  // namespace

int runCommandLine(std::vector<std::string> arguments) {
  return CommandLine().run(std::move(arguments));
}

}  // namespace glimt
