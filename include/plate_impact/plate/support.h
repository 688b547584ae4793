#ifndef plate_impact_plate_support_h
#define plate_impact_plate_support_h

#include <deal.II/base/types.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>

#include "plate_impact/base/choices.h"

#include <map>

namespace PlateImpact
{
  /// What holds each edge of a mesh, by its boundary id.
  using SupportOfEdge = std::map<dealii::types::boundary_id, EdgeSupport>;

  /// Whether any of them holds the deflection.
  bool
  hold_deflection(const SupportOfEdge &supports);

  /// Holds what supports and planes of symmetry hold of deflection and
  /// rotations. Along an edge that runs in any direction a rotation is held
  /// along its tangent, an arc's too; where such edges meet at an angle, both
  /// rotations.
  /// @param constraints  are added to, and not closed
  void
  hold_edges(const dealii::DoFHandler<2>       &dof_handler,
             const SupportOfEdge               &supports,
             dealii::AffineConstraints<double> &constraints);
} // namespace PlateImpact

#endif
