#include "plate_impact/plate/large_deflection.h"

#include "plate_impact/plate/slope_squares.h"

#include <map>

namespace PlateImpact
{
  LargeDeflection::LargeDeflection(const PlateDiscretization &plate)
    : plate(plate)
    , membrane_stiffness(plate.section().membrane_stiffness)
  {
    const PlateSection   &section    = plate.section();
    const Eigen::MatrixXd of_strains = section.stiffness().bottomRows<3>();
    const auto           &element    = plate.element().finite_element();
    for (unsigned int i = 0; i < element.n_dofs_per_cell(); ++i)
      {
        const unsigned int component =
          element.system_to_component_index(i).first;
        if (component == deflection)
          deflections.push_back(i);
        else if (component >= displacement_x || section.is_unsymmetric())
          causes.push_back(i);
      }
    std::map<const CellShape *, unsigned int> known;
    for (unsigned int cell = 0; cell < plate.mesh().n_active_cells(); ++cell)
      {
        const CellShape &shape = plate.shape(cell);
        const auto [of_shape, is_new] =
          known.insert({&shape, static_cast<unsigned int>(shapes.size())});
        shape_of_cell.push_back(of_shape->second);
        if (!is_new)
          continue;
        OfShape &added = shapes.emplace_back();
        added.weights  = Eigen::Map<const Eigen::VectorXd>(shape.weights.data(),
                                                          shape.weights.size());
        added.forces_of_unknowns.resize(3 * shape.weights.size(),
                                        causes.size());
        const Eigen::MatrixXd strains =
          shape.at_quadrature.linear(Eigen::all, causes);
        for (std::size_t q = 0; q < shape.weights.size(); ++q)
          added.forces_of_unknowns.middleRows<3>(3 * q) = shape.weights[q] *
            of_strains *
            strains.middleRows(of_strains.cols() * q, of_strains.cols());
      }
  }



  Eigen::VectorXd
  LargeDeflection::forces_of(
    const OfShape                           &shape,
    const Eigen::Ref<const Eigen::VectorXd> &strains) const
  {
    Eigen::VectorXd result(strains.size());
    for (Eigen::Index q = 0; q < shape.weights.size(); ++q)
      result.segment<3>(3 * q).noalias() =
        shape.weights[q] * (membrane_stiffness * strains.segment<3>(3 * q));
    return result;
  }



  StretchedPlate
  LargeDeflection::stretched(const Eigen::VectorXd &unknowns) const
  {
    const Eigen::MatrixXd values =
                            plate.free_unknowns().values_of_cells(unknowns),
                          causing = values(causes, Eigen::all);
    StretchedPlate result;
    result.slopes = SlopeSquares::slopes() * values(deflections, Eigen::all);
    result.strains.resize(3 * plate.element().quadrature().size(),
                          values.cols());
    result.forces.resize(result.strains.rows(), values.cols());
    for (Eigen::Index cell = 0; cell < values.cols(); ++cell)
      {
        auto strains      = result.strains.col(cell),
             forces       = result.forces.col(cell);
        strains.noalias() = plate.shape(cell).at_quadrature.of_squares *
          SlopeSquares::squares(result.slopes.col(cell));
        forces.noalias() = shape(cell).forces_of_unknowns * causing.col(cell);
        result.energy +=
          strains.dot(forces + 0.5 * forces_of(shape(cell), strains));
      }
    result.energy *= plate.n_parts();
    return result;
  }



  Eigen::VectorXd
  LargeDeflection::mean_forces(const StretchedPlate &begin,
                               const StretchedPlate &end,
                               const double          damping) const
  {
    const Eigen::MatrixXd strains = (0.5 - damping) * begin.strains +
      (0.5 + damping) * end.strains,
                          forces = (0.5 - damping) * begin.forces +
      (0.5 + damping) * end.forces,
                          slopes = 0.5 * (begin.slopes + end.slopes);
    Eigen::MatrixXd of_cells =
      Eigen::MatrixXd::Zero(plate.element().finite_element().n_dofs_per_cell(),
                            strains.cols());
    Eigen::VectorXd on_causes, on_deflections;
    for (Eigen::Index cell = 0; cell < of_cells.cols(); ++cell)
      {
        on_causes.noalias() =
          shape(cell).forces_of_unknowns.transpose() * strains.col(cell);
        const Eigen::VectorXd of_squares =
          plate.shape(cell).at_quadrature.of_squares.transpose() *
          (forces.col(cell) + forces_of(shape(cell), strains.col(cell)));
        on_deflections.noalias() =
          SlopeSquares::derivative(slopes.col(cell)).transpose() * of_squares;
        of_cells(causes, cell)      = on_causes;
        of_cells(deflections, cell) = on_deflections;
      }
    return plate.n_parts() * plate.free_unknowns().forces(of_cells);
  }



  double
  LargeDeflection::dissipated(const StretchedPlate &begin,
                              const StretchedPlate &end,
                              const double          damping) const
  {
    const Eigen::MatrixXd strains = end.strains - begin.strains,
                          forces  = end.forces - begin.forces;
    double sum                    = 0.;
    for (Eigen::Index cell = 0; cell < strains.cols(); ++cell)
      sum += strains.col(cell).dot(2. * forces.col(cell) +
                                   forces_of(shape(cell), strains.col(cell)));
    return damping * plate.n_parts() * sum;
  }



  void
  LargeDeflection::add_tangent(const StretchedPlate &begin,
                               const StretchedPlate &end,
                               const double          damping,
                               const bool            with_stresses,
                               Epetra_CrsMatrix     &sum) const
  {
    plate.add_cells(
      [&](const unsigned int cell, CellMatrix &K) {
        const Eigen::MatrixXd &of_squares =
          plate.shape(cell).at_quadrature.of_squares;
        const Eigen::VectorXd slopes =
          0.5 * (begin.slopes.col(cell) + end.slopes.col(cell));
        const Eigen::MatrixXd strains =
          (1. + 2. * damping) * of_squares * SlopeSquares::derivative(slopes);
        Eigen::MatrixXd forces(strains.rows(), strains.cols());
        for (Eigen::Index node = 0; node < strains.cols(); ++node)
          forces.col(node) = forces_of(shape(cell), strains.col(node));
        const Eigen::MatrixXd of_causes =
          shape(cell).forces_of_unknowns.transpose() * strains;
        K.setZero(plate.element().finite_element().n_dofs_per_cell(),
                  plate.element().finite_element().n_dofs_per_cell());
        K(deflections, deflections) =
          strains.transpose() * forces / (1. + 2. * damping);
        K(causes, deflections) += of_causes;
        K(deflections, causes) += of_causes.transpose();
        if (!with_stresses)
          return;
        const Eigen::VectorXd halfway =
          0.5 * (begin.strains.col(cell) + end.strains.col(cell));
        const Eigen::VectorXd stresses =
          0.5 * (begin.forces.col(cell) + end.forces.col(cell)) +
          forces_of(shape(cell), halfway);
        K(deflections, deflections) +=
          SlopeSquares::second_derivative(of_squares.transpose() * stresses);
      },
      sum);
  }
} // namespace PlateImpact
