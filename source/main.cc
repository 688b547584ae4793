#include <deal.II/base/exceptions.h>
#include <deal.II/base/multithread_info.h>

#include "plate_impact/compare.h"
#include "plate_impact/console.h"
#include "plate_impact/exceptions.h"
#include "plate_impact/expectation.h"
#include "plate_impact/run.h"
#include "plate_impact/scene.h"
#include "plate_impact/sweep.h"
#include "plate_impact/terminal.h"
#include "plate_impact/version.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <iostream>
#include <new>
#include <optional>
#include <sstream>
#include <unistd.h>

namespace
{
  using namespace PlateImpact;

  enum ExitStatus
  {
    success          = 0,
    wrong_input      = 1,
    failed_computing = 2
  };



  /// Reads a scene and computes what a command asks for.
  /// @param command  run_scene() or compare_scene()
  void
  compute(const std::function<void(const Scene &, Console &)> &command,
          const std::string                                   &path,
          const std::optional<std::string>                    &output,
          const std::vector<std::string>                      &overrides,
          const bool                                           quiet)
  {
    const Scene scene = read_scene(path, overrides, output);
    Console     console(quiet);
    command(scene, console);
  }



  void
  sweep(const std::string                &path,
        const std::optional<std::string> &output,
        const std::vector<std::string>   &overrides,
        const SweepOptions               &options)
  {
    Processes processes;
    // one of them tells of mistakes that all find
    if (!processes.is_first())
      std::cerr.setstate(std::ios::failbit);
    SweepScene scene(path, overrides, output);
    run_sweep(scene, options, processes);
  }



  void
  add_run_options(CLI::App                   &command,
                  std::string                &path,
                  std::optional<std::string> &output,
                  std::vector<std::string>   &overrides,
                  bool                       &quiet)
  {
    command.add_option("scene", path, "Parameter file (.prm)")->required();
    command.add_option("-o,--output",
                       output,
                       "Directory of the results, in place of the scene's");
    command
      .add_option("-s,--set",
                  overrides,
                  "Entry to change: \"Section/Entry=value\"; may be repeated")
      ->allow_extra_args(false);
    command.add_flag("-q,--quiet", quiet, "Print warnings and errors only");
  }



  /// Parses the command line and does what it asks for.
  int
  execute(const int argc, const char *const *argv)
  {
    CLI::App app(
      "Contact force between a sphere or a cylinder and a plate struck at low "
      "velocity, on a mesh that adapts itself until a prescribed "
      "discretization error is met.",
      "plate-impact");
    app.set_version_flag("--version", "plate-impact " PLATE_IMPACT_VERSION);
    app.require_subcommand(1);
    app.footer(
      "Examples:\n"
      "  plate-impact run prm/sphere-on-steel-plate.prm\n"
      "  plate-impact run my.prm --set \"Impactor/Velocity=2\" --output fast\n"
      "  plate-impact check my.prm\n"
      "  plate-impact defaults > my.prm\n\n"
      "`plate-impact COMMAND --help` lists the options of a command.\n"
      "Exit status: 0 done, 1 the input is wrong, 2 the computation failed.\n"
      "Colours are left out in pipes and where NO_COLOR is set.");

    std::string                path;
    std::optional<std::string> output;
    std::vector<std::string>   overrides;
    bool                       quiet = false;
    CLI::App                  *run_command =
      app.add_subcommand("run", "Compute the impact that a scene describes");
    add_run_options(*run_command, path, output, overrides, quiet);
    CLI::App *compare_command = app.add_subcommand(
      "compare",
      "Compare strategies and elements: error against run time");
    add_run_options(*compare_command, path, output, overrides, quiet);
    CLI::App *defaults_command = app.add_subcommand(
      "defaults",
      "Print every entry with its meaning, unit and default, as a valid scene");

    CLI::App *check_command =
      app.add_subcommand("check", "Check a scene and say what to expect of it");
    check_command->add_option("scene", path, "Parameter file (.prm)")
      ->required();
    check_command
      ->add_option("-s,--set",
                   overrides,
                   "Entry to change: \"Section/Entry=value\"; may be repeated")
      ->allow_extra_args(false);
    SweepOptions sweep_options;
    CLI::App    *sweep_command = app.add_subcommand(
      "sweep",
      "Compute many impacts: the entries and values of the scene's Sweep "
         "section; under mpirun on all its processes");
    add_run_options(*sweep_command, path, output, overrides, quiet);
    sweep_command->add_flag("--resume",
                            sweep_options.resume,
                            "Continue an interrupted sweep: keep the points "
                            "that are in its directory");

    try
      {
        app.parse(argc, argv);
      }
    catch (const CLI::ParseError &error)
      {
        if (error.get_exit_code() == 0)
          return app.exit(error);
        throw InputError(
          {error.what() + std::string("; see plate-impact --help")});
      }

    // of these the files count
    if (run_command->parsed())
      compute(run_scene, path, output, overrides, quiet);
    if (compare_command->parsed())
      compute(compare_scene, path, output, overrides, quiet);
    if (sweep_command->parsed())
      {
        sweep_options.quiet = quiet;
        sweep(path, output, overrides, sweep_options);
      }
    if (run_command->parsed() || compare_command->parsed() ||
        sweep_command->parsed())
      return success;

    // of these what they print
    if (check_command->parsed())
      print_expectation(std::cout, read_scene(path, overrides));
    else if (defaults_command->parsed())
      print_defaults(std::cout);
    std::cout.flush();
    if (!std::cout)
      throw ComputationError("the standard output cannot be written");
    return success;
  }



  /// The message with "plate-impact: " before every line.
  void
  print_error(const std::string &message)
  {
    const Terminal     terminal(STDERR_FILENO);
    std::istringstream lines(message);
    for (std::string line; std::getline(lines, line);)
      std::cerr << terminal.emphasized("plate-impact: ", Emphasis::error)
                << line << '\n';
  }
} // namespace



int
main(const int argc, const char *const *argv)
{
#ifdef __AVX2__
  if (!__builtin_cpu_supports("avx2"))
    {
      std::cerr << "plate-impact: this program was built for processors with "
                   "AVX2; build it on this machine\n";
      return failed_computing;
    }
#endif
  // Nothing here gains from threads; not starting them saves time.
  dealii::MultithreadInfo::set_thread_limit(1);
  try
    {
      return execute(argc, argv);
    }
  catch (const InputError &error)
    {
      print_error(error.what());
      return wrong_input;
    }
  catch (const ComputationError &error)
    {
      print_error(error.what());
    }
  catch (const std::bad_alloc &)
    {
      print_error("not enough memory; try fewer cells, a larger Adaptivity/"
                  "Minimum cell size or Target error");
    }
  catch (const dealii::ExceptionBase &error)
    {
      std::ostringstream text;
      error.print_info(text);
      print_error("an internal error (please report it with the scene): " +
                  std::string(error.get_exc_name()) + text.str());
    }
  catch (const std::exception &error)
    {
      print_error("an internal error (please report it with the scene): " +
                  std::string(error.what()));
    }
  return failed_computing;
}
