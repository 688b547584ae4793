#ifndef plate_impact_plate_edge_constraints_h
#define plate_impact_plate_edge_constraints_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>

#include "plate_impact/plate/support.h"

#include <map>

namespace PlateImpact
{
  /// Holds what supports and planes of symmetry hold of deflection and
  /// rotations. Along an edge that runs in any direction a rotation is held
  /// along its tangent, an arc's too; where such edges meet at an angle, both
  /// rotations.
  /// @param supports     by the edge's boundary id
  /// @param constraints  are added to, and not closed
  void
  hold_edges(const dealii::DoFHandler<2>                         &dofs,
             const std::map<dealii::types::boundary_id, Support> &supports,
             dealii::AffineConstraints<double>                   &constraints);
} // namespace PlateImpact

#endif
