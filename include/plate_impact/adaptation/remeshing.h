#ifndef plate_impact_adaptation_remeshing_h
#define plate_impact_adaptation_remeshing_h

#include "plate_impact/adaptation/mesh_adaptation.h"

#include <vector>

namespace PlateImpact
{
  /// Satisfies target sizes by a new mesh of quadrilaterals, as the paper does.
  /// The impact and the end of a line contact are vertices.
  ///
  /// Sizes are held at the vertices of the old mesh, the smallest that the
  /// cells there need, bilinear between them and limited in gradation.
  /// Gmsh's cells scatter around their size, and xi' with its square, so that
  /// without more half of the cells would exceed their limit for ever: cells to
  /// be refined get somewhat less than they need, and cells grow only when
  /// their target is well above them. For the same reason a mesh is kept when
  /// eta is met and no cell is off its target by more than the scatter.
  class Remeshing : public MeshAdaptation
  {
  public:
    using MeshAdaptation::MeshAdaptation;

    bool
    adapt(dealii::Triangulation<2> &mesh,
          const ErrorRatios        &error,
          std::vector<std::string> &warnings) const override;

  protected:
    std::vector<double>
    wanted_sizes(const dealii::Triangulation<2> &mesh,
                 const ErrorRatios              &error) const override;

  private:
    bool
    is_worth_it(const dealii::Triangulation<2> &mesh,
                const ErrorRatios              &error,
                const std::vector<double>      &sizes) const;
  };
} // namespace PlateImpact

#endif
