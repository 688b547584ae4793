#include <deal.II/base/exceptions.h>
#include <deal.II/base/multithread_info.h>

#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/text.h"
#include "plate_impact/base/version.h"
#include "plate_impact/command/commands.h"
#include "plate_impact/output/console.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>
#include <new>
#include <optional>
#include <sstream>
#include <unistd.h>

namespace
{
  using namespace PlateImpact;

  /// What the options of a command fill.
  struct Arguments
  {
    std::string                path;
    std::optional<std::string> output;
    std::vector<std::string>   overrides;
    std::string                marking;
    bool                       resume = false, quiet = false;
  };



  /// Of all commands that read a scene.
  void
  add_options(CLI::App &app, Arguments &arguments)
  {
    for (CLI::App *const command : app.get_subcommands({}))
      {
        const std::string name = command->get_name();
        if (name == "defaults")
          continue;
        command->add_option("scene", arguments.path, "Parameter file (.prm)")
          ->required();
        command
          ->add_option("-s,--set",
                       arguments.overrides,
                       "Entry to change: \"Section/Entry=value\"; may be "
                       "repeated")
          ->allow_extra_args(false);
        if (name == "check")
          continue;
        command->add_option("-o,--output",
                            arguments.output,
                            "Directory of the results, in place of the "
                            "scene's");
        command->add_flag("-q,--quiet",
                          arguments.quiet,
                          "Print warnings and errors only, and of a run one "
                          "line for scripts: peak_force=... bar=... "
                          "outcome=... trust=...");
        if (name == "sweep")
          command->add_flag("--resume",
                            arguments.resume,
                            "Continue an interrupted sweep: keep the points "
                            "that are in its directory");
        else
          command->add_option("--marking",
                              arguments.marking,
                              "Command that is given a JSON file with the "
                              "mesh and its errors, and prints which cells to "
                              "refine and to coarsen, or their sizes");
      }
  }



  Scene
  scene_of(const Arguments &arguments)
  {
    const Scene scene =
      read_scene(arguments.path, arguments.overrides, arguments.output);
    throw_if_interrupted(); // results of before stay
    return scene;
  }



  void
  sweep(const Arguments &arguments)
  {
    Processes processes;
    // one of them tells of mistakes that all find
    if (processes.rank != 0)
      std::cerr.setstate(std::ios::failbit);
    SweepScene scene(arguments.path, arguments.overrides, arguments.output);
    throw_if_interrupted();
    run_sweep(scene, arguments.resume, arguments.quiet, processes);
  }



  /// For commands whose result is what they print.
  void
  print(const std::string &text)
  {
    throw_if_interrupted();
    std::cout << text << std::flush;
    if (!std::cout)
      throw ComputationError("the standard output cannot be written");
  }



  void
  add_commands(CLI::App &app, Arguments &arguments)
  {
    app.add_subcommand("run", "Compute the impact that a scene describes")
      ->footer(
        "Writes report.html, summary.json, contact_history.csv, scene.prm and what "
        "the\nscene's section Output asks for. `plate-impact defaults` explains "
        "every entry.\n\n"
        "Example:\n"
        "  plate-impact run my.prm --set \"Impactor/Velocity=2\" --output fast")
      ->callback([&] {
        run_scene(scene_of(arguments), arguments.quiet, arguments.marking);
      });
    app
      .add_subcommand("compare",
                      "Compare strategies and elements: error against run time")
      ->footer(
        "Reads the scene's section Comparison; writes comparison.html, "
        "comparison.csv\nand comparison.json. Ctrl-C leaves what is done, in whole "
        "files.")
      ->callback([&] {
        compare_scene(scene_of(arguments), arguments.quiet, arguments.marking);
      });
    app
      .add_subcommand(
        "sweep",
        "Compute many impacts: the entries and values of the scene's Sweep "
        "section; under mpirun on all its processes")
      ->footer(
        "The section is, for example,\n"
        "  subsection Sweep\n"
        "    set Entry 1  = Impactor/Velocity\n"
        "    set Values 1 = 0.5:5:20          # first:last:number, or 1, 2, 5\n"
        "    set Entry 2  = Plate/Thickness\n"
        "    set Values 2 = 0.004, 0.006\n"
        "  end\n"
        "Writes sweep.html and sweep.csv. `plate-impact check` says what it costs.")
      ->callback([&] { sweep(arguments); });
    app.add_subcommand("check", "Check a scene and say what to expect of it")
      ->footer(
        "Takes a second or two and writes nothing. It takes longer under heavy "
        "impactors and where the plate stretches.")
      ->callback([&] { print(expectation_in_words(scene_of(arguments))); });
    app
      .add_subcommand(
        "defaults",
        "Print every entry with its meaning, unit and default, as a valid scene")
      ->footer("Example:\n  plate-impact defaults > my.prm")
      ->callback(
        [] { print(SceneReader().entries.text(/*with_meanings=*/true)); });
    add_options(app, arguments);
  }



  /// Parses the command line and does what it asks for.
  void
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
      "Exit status: 0 done, 1 the input is wrong, 2 the computation failed, "
      "130 Ctrl-C, 143 SIGTERM.\n"
      "Colours are left out in pipes and where NO_COLOR is set.");
    Arguments arguments;
    add_commands(app, arguments);
    try
      {
        app.parse(argc, argv); // calls the command
      }
    catch (const CLI::ParseError &error)
      {
        if (error.get_exit_code() == 0)
          return void(app.exit(error)); // prints what it asks for
        if (argc > 1 && argv[1][0] != '-' && app.get_subcommands().empty())
          throw InputError(
            {"there is no command '" + std::string(argv[1]) +
             "'; expected run, compare, sweep, check or defaults"});
        if (std::count(argv, argv + argc, std::string("=")) > 0)
          throw InputError({"'=' stands alone; write a change without blanks "
                            "around '=', as in --set 'Section/Entry=value'"});
        throw InputError(
          {error.what() + std::string("; see plate-impact --help")});
      }
  }



  /// The message with "plate-impact: " before every line.
  void
  print_error(const std::string &message)
  {
    std::istringstream lines(message);
    for (std::string line; std::getline(lines, line);)
      std::cerr << emphasized("plate-impact: ",
                              fg(fmt::terminal_color::red),
                              STDERR_FILENO)
                << printable(line) << '\n';
  }
} // namespace



int
PlateImpact::run_command_line(const int argc, const char *const *argv)
{
#ifdef __AVX2__
  if (!__builtin_cpu_supports("avx2"))
    {
      std::cerr << "plate-impact: this program was built for processors with "
                   "AVX2; build it on this machine\n";
      return 2;
    }
#endif
  // Nothing here gains from threads; not starting them saves time.
  dealii::MultithreadInfo::set_thread_limit(1);
  await_interrupt();
  try
    {
      execute(argc, argv);
      return 0;
    }
  catch (const InputError &error)
    {
      print_error(error.what());
      return 1;
    }
  catch (const ComputationError &error)
    {
      print_error(error.what());
    }
  catch (const Interruption &interruption)
    {
      print_error(interruption.what());
      return 128 + interruption.signal;
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
  return 2;
}
