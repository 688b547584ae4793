#include "test_plate.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/vector_tools_interpolate.h>

#include "plate_impact/adaptation/mesh_adaptation.h"
#include "plate_impact/contact/make_contact.h"
#include "plate_impact/transient/linear_solver.h"

#include <Epetra_Vector.h>
#include <gtest/gtest.h>

#include <fmt/format.h>
#include <fstream>
#include <limits>
#include <random>

namespace PlateImpact
{
  using namespace dealii;

  PlateParameters
  unit_plate(const EdgeSupport support, const double thickness)
  {
    PlateParameters plate;
    plate.side_lengths            = {{1., 1.}};
    plate.thickness               = thickness;
    plate.youngs_modulus          = 1.;
    plate.poissons_ratio          = 0.3;
    plate.density                 = 1.;
    plate.shear_correction_factor = 5. / 6.;
    plate.supports                = {{"", support}};
    return plate;
  }



  std::vector<ElementType>
  all_elements()
  {
    std::vector<ElementType> elements;
    for (const auto &[element, word] : Choices<ElementType>::words)
      elements.push_back(element);
    return elements;
  }



  std::ostream &
  operator<<(std::ostream &out, const ElementType element)
  {
    return out << word_for(element);
  }



  std::unique_ptr<Triangulation<2>>
  unit_square(const unsigned int n_cells)
  {
    auto mesh = std::make_unique<Triangulation<2>>(
      Triangulation<2>::limit_level_difference_at_vertices);
    GridGenerator::subdivided_hyper_cube(*mesh, n_cells);
    mesh->set_all_manifold_ids(numbers::flat_manifold_id);
    unset_symmetry(*mesh);
    return mesh;
  }



  void
  unset_symmetry(Triangulation<2> &mesh)
  {
    for (const auto &face : mesh.active_face_iterators())
      if (face->at_boundary())
        face->set_boundary_id(edge_x);
  }



  void
  remesh(Triangulation<2> &mesh, const double fine, const double growth)
  {
    AdaptivityParameters adaptivity{};
    adaptivity.strategy          = AdaptationStrategy::remeshing;
    adaptivity.target_error      = 0.05;
    adaptivity.size_exponent     = 1.;
    adaptivity.minimum_cell_size = 0.;
    adaptivity.maximum_cell_size = std::numeric_limits<double>::max();
    ErrorRatios error;
    error.overall = 20.;
    for (const auto &cell : mesh.active_cell_iterators())
      error.elements.push_back(cell_size(cell) /
                               (fine + growth * cell->center().norm()));
    std::vector<std::string> warnings;
    adapt_mesh({mesh, error, adaptivity, 0., warnings});
    EXPECT_TRUE(warnings.empty()) << warnings.front();
  }



  void
  distort(Triangulation<2> &mesh, const double fraction)
  {
    GridTools::distort_random(fraction, mesh, /*keep_boundary=*/true, 17);
  }



  void
  refine_randomly(Triangulation<2> &mesh, const unsigned int n_times)
  {
    std::mt19937 generator(4711);
    for (unsigned int i = 0; i < n_times; ++i)
      {
        for (const auto &cell : mesh.active_cell_iterators())
          if (generator() % 3 == 0)
            cell->set_refine_flag();
        mesh.execute_coarsening_and_refinement();
      }
  }



  std::vector<LoadPoint>
  pressure_load(const Triangulation<2>                        &mesh,
                const std::function<double(const Point<2> &)> &pressure)
  {
    const FE_Q<2>          element(1);
    const QGauss<2>        quadrature(4);
    FEValues<2>            values(element,
                       quadrature,
                       update_quadrature_points | update_JxW_values);
    std::vector<LoadPoint> points;
    for (const auto &cell : mesh.active_cell_iterators())
      {
        values.reinit(cell);
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          points.push_back(
            {values.quadrature_point(q),
             pressure(values.quadrature_point(q)) * values.JxW(q)});
      }
    return points;
  }



  Eigen::VectorXd
  interpolate(const PlateDiscretization &model, const Function<2> &field)
  {
    Vector<double> values(model.dof_handler().n_dofs());
    VectorTools::interpolate(mapping_of(model.mesh()),
                             model.dof_handler(),
                             field,
                             values);
    return model.unknowns_of_nodal_values(values);
  }



  Eigen::VectorXd
  solve_static(const PlateDiscretization &model, const Eigen::VectorXd &load)
  {
    const Epetra_CrsMatrix &K = model.stiffness();
    PlateWork               work;
    const auto solver = make_linear_solver(SolverType::CHOLMOD, work);
    solver->factorize(std::make_unique<Epetra_CrsMatrix>(K));
    Eigen::VectorXd z, correction, residual = load;
    solver->solve(load, z);

    // one step of refinement: on very thin plates the factorization loses two
    // digits more than K itself
    int    *rows, *columns;
    double *values;
    K.ExtractCrsDataPointers(rows, columns, values);
    for (Eigen::Index i = 0; i < load.size(); ++i)
      {
        long double sum = load[i];
        for (int k = rows[i]; k < rows[i + 1]; ++k)
          sum -= static_cast<long double>(values[k]) * z[columns[k]];
        residual[i] = sum;
      }
    solver->solve(residual, correction);
    return z + correction;
  }



  Eigen::VectorXd
  multiply(const Epetra_CrsMatrix &matrix, const Eigen::VectorXd &x)
  {
    Eigen::VectorXd     y(x.size());
    const Epetra_Vector x_view(View,
                               matrix.DomainMap(),
                               const_cast<double *>(x.data()));
    Epetra_Vector       y_view(View, matrix.RangeMap(), y.data());
    matrix.Multiply(false, x_view, y_view);
    return y;
  }



  Eigen::MatrixXd
  dense(const Epetra_CrsMatrix &matrix)
  {
    Eigen::MatrixXd result =
      Eigen::MatrixXd::Zero(matrix.NumMyRows(), matrix.NumMyRows());
    for (int row = 0; row < matrix.NumMyRows(); ++row)
      {
        int     n;
        double *values;
        int    *columns;
        matrix.ExtractMyRowView(row, n, values, columns);
        for (int k = 0; k < n; ++k)
          result(row, columns[k]) = values[k];
      }
    return result;
  }



  ContactHistory
  impact(const Parameters &parameters, SemidiscreteSystem &plate)
  {
    const Contact contact = make_contact(parameters);
    TimeStepper   stepper({parameters.time, parameters.contact.integration},
                        plate,
                        contact,
                        make_impactor(parameters.impactor));
    stepper.advance(stepper.scheme.n_steps);
    return stepper.impact().history;
  }



  ContactHistory
  impact(const Parameters             &parameters,
         const Triangulation<2>       &mesh,
         const std::vector<LoadPoint> &load,
         const double                  multiplicity)
  {
    const PlateElement  element(parameters.discretization.element,
                               Stretching::none,
                               parameters.discretization.mass);
    PlateDiscretization model(mesh, element, parameters.plate, multiplicity);
    model.assemble();
    FullSystem plate(std::make_shared<EffectiveStiffness>(
                       model,
                       parameters.discretization.linear_solver),
                     model.load(load));
    return impact(parameters, plate);
  }



  nlohmann::json
  reference(const std::string &name)
  {
    std::ifstream in(std::string(TEST_DATA) + "/reference/" + name);
    return nlohmann::json::parse(in);
  }



  void
  record(const std::string &name, const double value)
  {
    testing::Test::RecordProperty(name, fmt::format("{:.12g}", value));
  }



  std::string
  msh(const Triangulation<2>                          &mesh,
      const std::map<types::boundary_id, std::string> &names)
  {
    std::ostringstream file;
    file.precision(16);
    file << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n"
         << names.size() + 1 << "\n2 100 \"plate\"\n";
    for (const auto &[id, name] : names)
      file << "1 " << id + 1 << " \"" << name << "\"\n";
    file << "$EndPhysicalNames\n$Nodes\n" << mesh.n_vertices() << '\n';
    for (unsigned int v = 0; v < mesh.n_vertices(); ++v)
      file << v + 1 << ' ' << mesh.get_vertices()[v] << " 0\n";
    std::vector<std::string> elements;
    for (const auto &face : mesh.active_face_iterators())
      if (face->at_boundary() && names.count(face->boundary_id()) > 0)
        {
          const auto id = std::to_string(face->boundary_id() + 1);
          elements.push_back("1 2 " + id + ' ' + id + ' ' +
                             std::to_string(face->vertex_index(0) + 1) + ' ' +
                             std::to_string(face->vertex_index(1) + 1));
        }
    for (const auto &cell : mesh.active_cell_iterators())
      {
        std::string element = "3 2 100 100";
        for (const unsigned int v : {0, 1, 3, 2})
          element += ' ' + std::to_string(cell->vertex_index(v) + 1);
        elements.push_back(element);
      }
    file << "$EndNodes\n$Elements\n" << elements.size() << '\n';
    for (std::size_t e = 0; e < elements.size(); ++e)
      file << e + 1 << ' ' << elements[e] << '\n';
    file << "$EndElements\n";
    return file.str();
  }
} // namespace PlateImpact
