#include "plate_impact/output/mirrored_fields.h"

namespace PlateImpact
{
  void
  MirroredFields::mirror(const unsigned int           axis,
                         const std::set<std::string> &odd)
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
            const bool is_odd = row < names.size() ? odd.count(names[row]) > 0 :
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
} // namespace PlateImpact
