#include "plate_impact/command/commands.h"

int
main(const int argc, const char *const *argv)
{
  return PlateImpact::run_command_line(argc, argv);
}
