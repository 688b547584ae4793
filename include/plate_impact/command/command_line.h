#pragma once

namespace PlateImpact
{
  /// Does what the command line asks for; errors are printed. The whole
  /// program, apart from main().
  /// @return the exit status: 0 done, 1 the input is wrong, 2 the computation
  ///         failed, 128 and the signal that interrupted it
  int
  run_command_line(int argc, const char *const *argv);
} // namespace PlateImpact
