#pragma once

namespace PlateImpact
{
  /// From here on Ctrl-C (SIGINT) and the end that a batch system asks for
  /// (SIGTERM) are wishes, which throw_if_interrupted() grants where whole
  /// files can be left. A second one ends the program at once. A file that
  /// grows beyond its limit is a failed write.
  void
  await_interrupt();

  /// Both end the program at once again.
  void
  await_no_interrupt();

  /// @throws Interruption  "interrupted", after one of these signals
  void
  throw_if_interrupted();
} // namespace PlateImpact
