#ifndef plate_impact_adaptation_remeshing_h
#define plate_impact_adaptation_remeshing_h

#include "plate_impact/adaptation/mesh_adaptation.h"
#include "plate_impact/adaptation/quad_mesher.h"

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
    /// @param contact_half_length  as in make_mesh_adaptation() [m]
    Remeshing(const AdaptivityParameters &adaptivity,
              double                      contact_half_length,
              const QuadMesher           &mesher = QuadMesher());

    bool
    adapt(dealii::Triangulation<2> &mesh,
          const ErrorOverLimit     &error,
          std::vector<std::string> &warnings) const override;

    double
    n_wanted_cells(const dealii::Triangulation<2> &mesh,
                   const ErrorOverLimit           &error) const override;

  private:
    std::vector<double>
    wanted_sizes(const dealii::Triangulation<2> &mesh,
                 const ErrorOverLimit           &error) const;
    bool
    is_worth_it(const dealii::Triangulation<2> &mesh,
                const ErrorOverLimit           &error,
                const std::vector<double>      &sizes) const;

    /// Corners of the domain, and vertices within it.
    struct Outline
    {
      std::vector<PlanePoint> corners, inside;
    };
    Outline
    outline(const dealii::Triangulation<2> &mesh) const;

    const AdaptivityParameters adaptivity;
    const double               contact_half_length;
    const QuadMesher           mesher;
  };
} // namespace PlateImpact

#endif
