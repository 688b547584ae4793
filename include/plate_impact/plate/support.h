#pragma once

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>

#include "plate_impact/base/parameters.h"

namespace PlateImpact
{
  /// Adds what supports and planes of symmetry hold to the constraints. On an
  /// edge that runs in any direction a rotation is held along its tangent, an
  /// arc's too, and a displacement along tangent or normal; where such edges
  /// hold two directions, both components.
  /// @return whether any edge has its deflection held
  bool
  hold_edges(const dealii::DoFHandler<2>       &dofs,
             const PlateParameters             &plate,
             dealii::AffineConstraints<double> &constraints);
} // namespace PlateImpact
