#ifndef plate_impact_base_interrupt_h
#define plate_impact_base_interrupt_h

namespace PlateImpact
{
  /// From here on Ctrl-C is a wish, which throw_if_interrupted() grants where
  /// whole files can be left. A second one ends the program at once.
  void
  await_interrupt();

  /// @throws Interruption  "interrupted", where Ctrl-C has been pressed
  void
  throw_if_interrupted();
} // namespace PlateImpact

#endif
