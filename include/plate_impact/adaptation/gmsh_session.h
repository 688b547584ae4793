#ifndef plate_impact_adaptation_gmsh_session_h
#define plate_impact_adaptation_gmsh_session_h

#include <gmsh.h>

namespace PlateImpact
{
  /// Gmsh is one for the whole program: started here and ended here. Silent.
  class GmshSession
  {
  public:
    GmshSession()
    {
      gmsh::initialize(0, nullptr, /*readConfigFiles=*/false);
      gmsh::option::setNumber("General.Terminal", 0);
      gmsh::option::setNumber("General.NumThreads", 1);
    }

    ~GmshSession()
    {
      gmsh::finalize();
    }

    GmshSession(const GmshSession &) = delete;
    GmshSession &
    operator=(const GmshSession &) = delete;
  };
} // namespace PlateImpact

#endif
