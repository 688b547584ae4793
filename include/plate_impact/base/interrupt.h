#pragma once

namespace PlateImpact
{
  /// From here on Ctrl-C (SIGINT) and the end that a batch system asks for
  /// (SIGTERM) are wishes, which throw_if_interrupted() grants where whole
  /// files can be left. A second one ends the program at once. A file that
  /// grows beyond its limit is a failed write.
  /// @param ends_at_once  the first one does so again
  void
  await_interrupt(bool ends_at_once = false);

  /// @throws Interruption  "interrupted", after one of these signals
  void
  throw_if_interrupted();
} // namespace PlateImpact
