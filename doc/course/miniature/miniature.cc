/* Impact of a ball on a plate, on a mesh that adapts itself: after P. Mahajan and A. Dutta,
 * "Adaptive computation of impact force under low velocity impact". One file, to be read. It is
 * a part of plate-impact, which computes the same force on the same mesh, and much more. */

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_out.h>
#include <deal.II/grid/grid_refinement.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/householder.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/vector_tools.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
using namespace dealii;

// @sect3{The scene}
// A steel ball strikes the middle of a clamped steel plate. All numbers are in SI units. The
// force is spread over a disc with the pressure of Hertz, because under a point force a plate
// with shear deflects without limit.
constexpr double E = 2.1e11, nu = 0.3, density = 7800;      // of both bodies
constexpr double side = 0.2, thickness = 0.008;             // of the plate
constexpr double radius = 0.01, velocity = 1, disc = 0.003; // of the ball, its contact
constexpr double end_time = 80e-6, time_step = 2e-7, target_error = 0.05;

// Reissner and Mindlin: moments are D times curvatures, shear forces S times shear strains.
constexpr double pi        = numbers::PI;
constexpr double D         = E * thickness * thickness * thickness / (12 * (1 - nu * nu));
constexpr double S         = 5. / 6. * E / (2 * (1 + nu)) * thickness;
constexpr double rotary    = density * thickness * thickness * thickness / 12;
constexpr double inertia[] = {density * thickness, rotary, rotary};

// Five resultants at a point: M_x, M_y, M_xy, Q_x, Q_y.
using Resultants = Tensor<1, 5>;
Resultants resultants_of(const Tensor<1, 5> &e)
{
  return Resultants(
    {D * (e[0] + nu * e[1]), D * (e[1] + nu * e[0]), D * (1 - nu) / 2 * e[2], S * e[3], S * e[4]});
}

// Twice the energy per unit area that resultants store.
double squared_norm(const Resultants &r)
{
  const double bending = r[0] * r[0] + r[1] * r[1] - 2 * nu * r[0] * r[1], twist = r[2] * r[2];
  return (bending + 2 * (1 + nu) * twist) / (D * (1 - nu * nu)) + (r[3] * r[3] + r[4] * r[4]) / S;
}

// @sect3{The plate on one mesh}
// By symmetry a quarter of the plate is enough. A node has the deflection w and two rotations,
// all of second degree. The shear is integrated with the 2 x 2 Gauss points of a cell: with
// more points the element locks when the plate is thin. The recovery takes its samples at
// the same points, because the resultants are most accurate there.
using Cell = DoFHandler<2>::active_cell_iterator;

struct Plate
{
  explicit Plate(const Triangulation<2> &mesh);
  void                    constrain(), assemble(), spread_load();
  Tensor<1, 5>            strains(const FEValues<2> &values, unsigned int i, unsigned int q) const;
  std::vector<Resultants> samples(const Cell &cell, const Vector<double> &state);

  FESystem<2>               fe;
  DoFHandler<2>             dofs;
  FEValues<2>               at_samples, at_points;
  AffineConstraints<double> constraints;
  SparsityPattern           pattern;
  SparseMatrix<double>      K, M;
  Vector<double>            load; // of a unit force
};

Plate::Plate(const Triangulation<2> &mesh)
  : fe(FE_Q<2>(2), 3)
  , dofs(mesh)
  , at_samples(fe, QGauss<2>(2),
               update_values | update_gradients | update_JxW_values | update_quadrature_points)
  , at_points(fe, QGauss<2>(3), update_values | update_gradients | update_JxW_values)
{
  dofs.distribute_dofs(fe);
  constrain();
  DynamicSparsityPattern sparsity(dofs.n_dofs());
  DoFTools::make_sparsity_pattern(dofs, sparsity, constraints, false);
  pattern.copy_from(sparsity);
  K.reinit(pattern);
  M.reinit(pattern);
  assemble();
  spread_load();
}

// GridGenerator numbers the sides of a square. 0 and 2 are the planes of symmetry x = 0 and
// y = 0, where the rotation normal to the plane is zero; 1 and 3 are clamped.
void Plate::constrain()
{
  DoFTools::make_hanging_node_constraints(dofs, constraints);
  for (const types::boundary_id id : {0, 1, 2, 3})
    {
      std::vector<bool> held(3, id % 2 == 1);
      held[1 + id / 2] = true;
      VectorTools::interpolate_boundary_values(dofs, id, Functions::ZeroFunction<2>(3), constraints,
                                               ComponentMask(held));
    }
  constraints.close();
}

// Curvatures and shear strains (grad w - theta) of the shape function i.
Tensor<1, 5> Plate::strains(const FEValues<2> &values, unsigned int i, unsigned int q) const
{
  const unsigned int component = fe.system_to_component_index(i).first;
  const double       N         = values.shape_value(i, q);
  const Tensor<1, 2> dN        = values.shape_grad(i, q);
  if (component == 0)
    return Tensor<1, 5>({0, 0, 0, dN[0], dN[1]});
  if (component == 1)
    return Tensor<1, 5>({dN[0], 0, dN[1], -N, 0});
  return Tensor<1, 5>({0, dN[1], dN[0], 0, -N});
}

// Integrates bending and inertia with 3 x 3 points, shear with the samples.
void Plate::assemble()
{
  const unsigned int                   n = fe.n_dofs_per_cell();
  FullMatrix<double>                   k(n), m(n);
  std::vector<types::global_dof_index> indices(n);
  for (const auto &cell : dofs.active_cell_iterators())
    {
      k = m = 0;
      for (FEValues<2> *values : {&at_points, &at_samples})
        {
          const bool is_bending = values == &at_points;
          values->reinit(cell);
          for (const unsigned int q : values->quadrature_point_indices())
            for (unsigned int i = 0; i < n; ++i)
              {
                Resultants r = values->JxW(q) * resultants_of(strains(*values, i, q));
                for (unsigned int part = 0; part < 5; ++part)
                  r[part] *= is_bending == (part < 3);
                const unsigned int component = fe.system_to_component_index(i).first;
                for (unsigned int j = 0; j < n; ++j)
                  {
                    k(i, j) += r * strains(*values, j, q);
                    if (is_bending && fe.system_to_component_index(j).first == component)
                      m(i, j) += inertia[component] * values->JxW(q) * values->shape_value(i, q) *
                        values->shape_value(j, q);
                  }
              }
        }
      cell->get_dof_indices(indices);
      constraints.distribute_local_to_global(k, indices, K);
      constraints.distribute_local_to_global(m, indices, M);
    }
}

// With r = c sqrt(1 - s^2) on a disc of radius c, the pressure of Hertz has the weight 3 s^2 ds.
// The points are Gauss points in s, at equal angles. The weights of a quadrant sum to one.
void Plate::spread_load()
{
  constexpr unsigned int               n = 40;
  const QGauss<1>                      radial(n);
  std::vector<types::global_dof_index> indices(fe.n_dofs_per_cell());
  Vector<double>                       of_cell(indices.size());
  load.reinit(dofs.n_dofs());
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      {
        const double s = radial.point(i)[0], angle = (j + 0.5) / n * pi / 2;
        const double r          = disc * std::sqrt(1 - s * s);
        const auto [cell, unit] = GridTools::find_active_cell_around_point(
          StaticMappingQ1<2>::mapping, dofs, Point<2>(r * std::cos(angle), r * std::sin(angle)));
        for (unsigned int k = 0; k < of_cell.size(); ++k)
          of_cell[k] = radial.weight(i) * 3 * s * s / n * fe.shape_value_component(k, unit, 0);
        cell->get_dof_indices(indices);
        constraints.distribute_local_to_global(of_cell, indices, load);
      }
}

// The resultants at the samples of a cell, for a state of the plate.
std::vector<Resultants> Plate::samples(const Cell &cell, const Vector<double> &state)
{
  Vector<double> unknowns(fe.n_dofs_per_cell());
  cell->get_dof_values(state, unknowns);
  at_samples.reinit(cell);
  std::vector<Resultants> result;
  for (const unsigned int q : at_samples.quadrature_point_indices())
    {
      Tensor<1, 5> strain;
      for (unsigned int i = 0; i < unknowns.size(); ++i)
        strain += unknowns[i] * strains(at_samples, i, q);
      result.push_back(resultants_of(strain));
    }
  return result;
}

// @sect3{The error estimated over time}
// xi' of a cell is the mean over time of its error over e_m, its share of the permitted error;
// eta is the relative error of all cells (Table 1 of the paper). A patch is the four cells around
// a vertex. Vertices on edges, on planes of symmetry and at hanging nodes have no patch; their
// cells use the patches of their other vertices.
struct Estimator
{
  explicit Estimator(Plate &plate);
  void                        add(const Vector<double> &state, double dt);
  std::vector<Vector<double>> fitted(const Point<2> &centre, const std::vector<Cell> &cells,
                                     const Vector<double> &state);

  Plate                                              &plate;
  Vector<double>                                      xi;
  std::vector<std::pair<Point<2>, std::vector<Cell>>> patches;
  std::vector<std::vector<unsigned int>>              patches_of_cell;
  double                                              error = 0, norm = 0, time = 0;
};

Estimator::Estimator(Plate &plate)
  : plate(plate)
  , xi(plate.dofs.get_triangulation().n_active_cells())
  , patches_of_cell(xi.size())
{
  std::map<unsigned int, std::pair<Point<2>, std::vector<Cell>>> by_vertex;
  for (const auto &cell : plate.dofs.active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
      {
        auto &[centre, cells] = by_vertex[cell->vertex_index(v)];
        centre                = cell->vertex(v);
        cells.push_back(cell);
      }
  for (const auto &[vertex, patch] : by_vertex)
    if (patch.second.size() == 4)
      {
        for (const auto &cell : patch.second)
          patches_of_cell[cell->active_cell_index()].push_back(patches.size());
        patches.push_back(patch);
      }
}

// Superconvergent patch recovery (Zienkiewicz & Zhu 1992) fits a polynomial of eight terms to
// the sixteen samples of a patch, for each of the five resultants.
Vector<double> terms(const Tensor<1, 2> &x)
{
  const double u = x[0], v = x[1], values[] = {1, u, v, u * u, u * v, v * v, u * u * v, u * v * v};
  return Vector<double>(std::begin(values), std::end(values));
}

std::vector<Vector<double>>
Estimator::fitted(const Point<2> &centre, const std::vector<Cell> &cells, const Vector<double> &z)
{
  FullMatrix<double>          A(16, 8);
  std::vector<Vector<double>> b(5, Vector<double>(16)), a(5, Vector<double>(8));
  for (unsigned int row = 0; row < 16; ++row)
    {
      const std::vector<Resultants> samples = plate.samples(cells[row / 4], z);
      const Point<2>                x       = plate.at_samples.quadrature_point(row % 4);
      const Vector<double>          P       = terms((x - centre) / cells[0]->diameter());
      for (unsigned int term = 0; term < 8; ++term)
        A(row, term) = P[term];
      for (unsigned int k = 0; k < 5; ++k)
        b[k][row] = samples[row % 4][k];
    }
  const Householder<double> fit(A);
  for (unsigned int k = 0; k < 5; ++k)
    fit.least_squares(a[k], b[k]);
  return a;
}

// Compares the recovered resultants with those of the elements, which are the bilinear
// function through the samples.
void Estimator::add(const Vector<double> &state, const double dt)
{
  std::vector<std::vector<Vector<double>>> a;
  for (const auto &[centre, cells] : patches)
    a.push_back(fitted(centre, cells, state));
  const QGauss<2> points(3), sample_points(2);
  FEValues<2>     values(plate.fe, points, update_quadrature_points | update_JxW_values);
  Vector<double>  e2(xi.size());
  double          u2 = 0;
  for (const auto &cell : plate.dofs.active_cell_iterators())
    {
      const std::vector<unsigned int> &own     = patches_of_cell[cell->active_cell_index()];
      const std::vector<Resultants>    samples = plate.samples(cell, state);
      values.reinit(cell);
      for (const unsigned int q : values.quadrature_point_indices())
        {
          Resultants raw, recovered;
          for (unsigned int s = 0; s < 4; ++s)
            {
              const Point<2> x = points.point(q), at = sample_points.point(s);
              raw += (x[0] + at[0] - 1) / (2 * at[0] - 1) * (x[1] + at[1] - 1) / (2 * at[1] - 1) *
                samples[s];
            }
          for (const unsigned int p : own)
            {
              const Tensor<1, 2> x = values.quadrature_point(q) - patches[p].first;
              for (unsigned int k = 0; k < 5; ++k)
                recovered[k] += terms(x / patches[p].second[0]->diameter()) * a[p][k] / own.size();
            }
          u2 += values.JxW(q) * squared_norm(raw);
          if (!own.empty())
            e2[cell->active_cell_index()] += values.JxW(q) * squared_norm(recovered - raw);
        }
    }
  const double all = u2 + e2.l1_norm(), e_m = target_error * std::sqrt(all / xi.size());
  for (unsigned int c = 0; c < xi.size() && all > 0; ++c)
    xi[c] = (xi[c] * time + std::sqrt(e2[c]) / e_m * dt) / (time + dt);
  time += dt;
  error += dt * std::sqrt(e2.l1_norm());
  norm += dt * std::sqrt(all);
}

// @sect3{The impact on one mesh}
// Newmark's method with average acceleration for plate and ball. A quarter of the plate takes
// a quarter of the force. The displacements at the end of a step are linear in the force F at
// that time. So Newton's method solves one equation per step, for the indentation alpha:
//   alpha = alpha_free - compliance F(alpha),  F = k alpha^{3/2} (Hertz).
double strike(Plate &plate, Estimator &estimator, Vector<double> &state)
{
  const double         k    = 4. / 3. * E / (2 * (1 - nu * nu)) * std::sqrt(radius);
  const double         mass = 4. / 3. * pi * radius * radius * radius * density;
  const double         h = time_step, c = h * h / 4;
  SparseMatrix<double> effective(plate.pattern);
  effective.copy_from(plate.M);
  effective.add(c, plate.K);
  SparseDirectUMFPACK inverse;
  inverse.initialize(effective);
  Vector<double> unit = plate.load;
  inverse.solve(unit);
  const double   compliance = c / 4 * (plate.load * unit) + c / mass;
  Vector<double> z(plate.load.size()), v(z), a(z), a_new(z), Kz(z);
  double         y = 0, y_v = velocity, F = 0, peak = 0;
  for (int step = 1; step <= std::lround(end_time / h); ++step)
    {
      z.add(h, v, c, a);
      plate.K.vmult(Kz, z);
      a_new.equ(-1, Kz);
      inverse.solve(a_new);
      const double y_free     = y + h * y_v - c * F / mass;
      const double alpha_free = y_free - plate.load * z - c * (plate.load * a_new);
      double       alpha = std::max(0., alpha_free), change = alpha;
      for (unsigned int i = 0; i < 100 && std::abs(change) > 1e-14 * radius; ++i)
        {
          const double left = alpha - alpha_free + compliance * k * std::pow(alpha, 1.5);
          change            = alpha > 0 ? left / (1 + 1.5 * compliance * k * std::sqrt(alpha)) : 0;
          alpha             = std::max(0., alpha - change);
        }
      const double F_new = k * std::pow(alpha, 1.5);
      a_new.add(F_new / 4, unit);
      z.add(c, a_new);
      v.add(h / 2, a, h / 2, a_new);
      a = a_new;
      y = y_free - c * F_new / mass;
      y_v -= h / 2 * (F + F_new) / mass;
      F    = F_new;
      peak = std::max(peak, F);
      if (step % 10 == 0)
        {
          state = z;
          plate.constraints.distribute(state);
          estimator.add(state, 10 * h);
        }
    }
  return peak;
}

// @sect3{The loop}
// In each cycle cells with xi' above 1 are refined, and cells with xi' below 0.1 are coarsened,
// until all xi' are below 1, for at most 8 cycles or as many as the command line says.
int main(const int argc, const char *const argv[])
{
  const unsigned int most_cycles = argc > 1 ? std::stoi(argv[1]) : 8;
  Triangulation<2>   mesh(Triangulation<2>::limit_level_difference_at_vertices);
  GridGenerator::subdivided_hyper_cube(mesh, 3, 0, side / 2, true);
  std::printf("cycle  cells  eta [%%]  largest xi'  peak force [N]\n");
  for (unsigned int cycle = 1;; ++cycle)
    {
      Plate          plate(mesh);
      Estimator      estimator(plate);
      Vector<double> state;
      const double   peak = strike(plate, estimator, state);
      std::printf("%5u%7u%9.2f%13.2f%16.6f\n", cycle, mesh.n_active_cells(),
                  100 * estimator.error / estimator.norm, estimator.xi.linfty_norm(), peak);
      if (estimator.xi.linfty_norm() < 1 || cycle == most_cycles)
        {
          DataOut<2> out;
          out.attach_dof_handler(plate.dofs);
          out.add_data_vector(state, {"deflection", "rotation_x", "rotation_y"});
          out.add_data_vector(estimator.xi, "xi");
          out.build_patches(2);
          std::ofstream fields("fields.vtu"), picture("mesh.svg");
          out.write_vtu(fields);
          GridOut().write_svg(mesh, picture);
          return 0;
        }
      GridRefinement::refine(mesh, estimator.xi, 1);
      GridRefinement::coarsen(mesh, estimator.xi, 0.1);
      mesh.execute_coarsening_and_refinement();
    }
}
