#include "plate_impact/output/field_files.h"

#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/numerics/data_out.h>

#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/text.h"
#include "plate_impact/estimator/recovered_field.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_mesh.h"
#include "plate_impact/plate/plate_section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// A VTU file holds floats.
    void
    require_finite(const Vector<double> &fields, const double time)
    {
      // false for what is not a number, too
      const auto fits = [](const double value) {
        return std::abs(value) < std::numeric_limits<float>::max();
      };
      if (std::all_of(fields.begin(), fields.end(), fits))
        return;
      throw ComputationError("the fields at t = " + number(time, "s") +
                             " contain values that a VTU file cannot hold");
    }



    /// Fields on a mesh and on its mirror images in planes of symmetry.
    class MirroredFields : public DataOut<2>
    {
    public:
      /// Doubles the patches that were built.
      /// @param axis  across the plane, through the origin
      /// @param odd   names of the fields that change their sign
      void
      mirror(const unsigned int axis, const std::set<std::string> &odd)
      {
        const std::vector<std::string> names     = get_dataset_names();
        const std::size_t              n_patches = patches.size();
        for (std::size_t p = 0; p < n_patches; ++p)
          {
            const auto &patch = patches[p];
            auto        image = patch;
            image.patch_index = patches.size();
            image.neighbors.fill(image.no_neighbor);
            // the numbers of vertices and points turn round along the axis
            for (const unsigned int v : {0, 1, 2, 3})
              {
                image.vertices[v] = patch.vertices[v ^ (1u << axis)];
                image.vertices[v][axis] *= -1.;
              }
            const unsigned int n = patch.n_subdivisions + 1;
            for (unsigned int row = 0; row < patch.data.n_rows(); ++row)
              {
                // rows beyond the fields are coordinates
                const bool is_odd = row < names.size() ?
                  odd.count(names[row]) > 0 :
                  row - names.size() == axis;
                for (unsigned int j = 0; j < n; ++j)
                  for (unsigned int i = 0; i < n; ++i)
                    image.data(row, n * j + i) = (is_odd ? -1.f : 1.f) *
                      patch.data(row,
                                 axis == 0 ? n * j + (n - 1 - i) :
                                             n * (n - 1 - j) + i);
              }
            patches.push_back(image);
          }
      }
    };
  } // namespace



  void
  write_fields(const ResultDirectory &directory, const Cycle &cycle)
  {
    const CycleResult         &result        = cycle.result;
    const PlateDiscretization &plate         = cycle.discretization();
    const FESystem<2>         &plate_element = plate.element.finite_element;
    const unsigned int         n_unknowns    = plate_element.n_components();
    std::vector<std::string>   field_names   = {"deflection",
                                                "rotation_x",
                                                "rotation_y",
                                                "displacement_x",
                                                "displacement_y"};
    field_names.resize(n_unknowns);
    // across x = 0 and y = 0
    std::array<std::set<std::string>, 2> odd = {
      {{"rotation_x", "displacement_x"}, {"rotation_y", "displacement_y"}}};
    for (const SectionField &field :
         section_fields(plate.section(),
                        Eigen::MatrixXd::Zero(plate.section().n_resultants(),
                                              1)))
      {
        field_names.push_back(field.name_in_file);
        for (const unsigned int d : {0, 1})
          if (field.is_odd[d])
            odd[d].insert(field.name_in_file);
      }
    // values of every cell at its own nine nodes: what is recovered may differ
    // from cell to cell at hanging nodes
    const FE_DGQ<2>   nodal(2);
    const FESystem<2> fields_element(nodal, field_names.size());
    DoFHandler<2>     dof_handler(plate.mesh());
    dof_handler.distribute_dofs(fields_element);
    const std::vector<unsigned int> hierarchic =
      FETools::lexicographic_to_hierarchic_numbering<2>(2);

    std::vector<std::pair<double, std::string>> record;
    Vector<double>                              fields(dof_handler.n_dofs());
    Vector<float> element_errors(result.error_ratios->elements.begin(),
                                 result.error_ratios->elements.end());
    std::vector<types::global_dof_index> dofs(fields_element.n_dofs_per_cell());
    for (const Snapshot &snapshot : result.snapshots)
      {
        const std::vector<SectionField> of_section =
          section_fields(plate.section(),
                         recovered_resultants(plate,
                                              cycle.recovery(),
                                              snapshot.unknowns,
                                              nodal.get_unit_support_points())
                           .front());
        for (const auto &cell : dof_handler.active_cell_iterators())
          {
            const unsigned int    c = cell->active_cell_index();
            const Eigen::MatrixXd values =
              plate.free_unknowns().cell_values(c, snapshot.unknowns);
            cell->get_dof_indices(dofs);
            for (unsigned int node = 0; node < nodal.n_dofs_per_cell(); ++node)
              {
                const auto set = [&](const unsigned int field,
                                     const double       value) {
                  fields[dofs[fields_element.component_to_system_index(field,
                                                                       node)]] =
                    value;
                };
                for (unsigned int k = 0; k < n_unknowns; ++k)
                  set(k,
                      values(plate_element
                               .component_to_system_index(k, hierarchic[node]),
                             0));
                for (unsigned int k = 0; k < of_section.size(); ++k)
                  set(n_unknowns + k,
                      of_section[k].values[nodal.n_dofs_per_cell() * c + node]);
              }
          }
        require_finite(fields, snapshot.time);
        MirroredFields data_out;
        data_out.attach_dof_handler(dof_handler);
        data_out.add_data_vector(fields, field_names);
        data_out.add_data_vector(element_errors,
                                 "element_error",
                                 MirroredFields::type_cell_data);
        data_out.build_patches(curved_mapping(),
                               2,
                               DataOut<2>::CurvedCellRegion::curved_boundary);
        for (const unsigned int d : {0, 1})
          if (geometry_of(cycle.parameters.plate).is_symmetric[d])
            data_out.mirror(d, odd[d]);
        const std::string name =
          "fields_" + std::to_string(record.size()) + ".vtu";
        directory.write_file(name, [&](std::ostream &out) {
          data_out.write_vtu(out);
        });
        record.push_back({snapshot.time, name});
      }
    directory.write_file("fields.pvd", [&](std::ostream &out) {
      DataOutBase::write_pvd_record(out, record);
    });
  }
} // namespace PlateImpact
