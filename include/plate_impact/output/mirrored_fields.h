#ifndef plate_impact_output_mirrored_fields_h
#define plate_impact_output_mirrored_fields_h

#include <deal.II/numerics/data_out.h>

#include <set>
#include <string>

namespace PlateImpact
{
  /// Fields on a mesh and on its mirror images in planes of symmetry.
  class MirroredFields : public dealii::DataOut<2>
  {
  public:
    /// Doubles the patches that were built.
    /// @param axis  across the plane, through the origin
    /// @param odd   names of the fields that change their sign
    void
    mirror(unsigned int axis, const std::set<std::string> &odd);
  };
} // namespace PlateImpact

#endif
