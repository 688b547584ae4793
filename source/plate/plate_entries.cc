// The entries of the sections Plate and Ply.
#include <deal.II/base/utilities.h>

#include "plate_impact/base/entries.h"
#include "plate_impact/base/parameters.h"

#include <cmath>
#include <filesystem>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    Allowed<Outline>
    word_or_file()
    {
      const auto word = one_of<PlateOutline>();
      return {word.words + " | the name of a mesh of Gmsh, ending in .msh",
              [word](const std::string &text, Outline &outline) {
                if (std::filesystem::path(text).extension() != ".msh")
                  return word.read(text, outline.shape);
                outline = {PlateOutline::file, text};
                return true;
              }};
    }



    /// One or two words, or pairs of an edge of a file and a word.
    template <typename Support>
    Allowed<std::vector<OnEdge<Support>>>
    on_edges()
    {
      const auto word = one_of<Support>();
      return {list(word, 1, 2).words +
                "; or, for an outline from a file, pairs edge: word",
              [word](const std::string            &text,
                     std::vector<OnEdge<Support>> &supports) {
                supports.clear();
                const bool is_named = text.find(':') != std::string::npos;
                for (const std::string &item : split_list(text))
                  {
                    const std::size_t colon = item.rfind(':');
                    OnEdge<Support>  &one   = supports.emplace_back();
                    if (colon != std::string::npos)
                      one.edge = Utilities::trim(item.substr(0, colon));
                    if (one.edge.empty() == is_named ||
                        !word.read(Utilities::trim(item.substr(colon + 1)),
                                   one.support))
                      return false;
                  }
                return is_named || supports.size() <= 2;
              }};
    }



    const std::vector<Word<DeflectionTheory>> deflection_theories = {
      {DeflectionTheory::linear, "linear"},
      {DeflectionTheory::large, "large"}};



    /// Angles of "0/90_2/45s", with the bracket that may be around all but
    /// the s; or nothing.
    Allowed<Layup>
    angles_of_plies()
    {
      constexpr unsigned int most_plies = 1000;
      return {"angles of up to 1000 plies in degrees between slashes, with an "
              "s for the mirrored half, as 0/90/45/-45s or 0_2/90s, or nothing",
              [](const std::string &written, Layup &layup) {
                layup.text = written;
                if (written.empty())
                  return true;
                std::string text    = written;
                const bool  is_half = text.back() == 's' || text.back() == 'S';
                if (is_half)
                  text.pop_back();
                if (text.size() > 1 && text.front() == '[' &&
                    text.back() == ']')
                  text = text.substr(1, text.size() - 2);
                std::vector<double> &angles = layup.angles;
                for (const std::string &item : split_list(text, '/'))
                  {
                    const std::size_t underscore = item.find('_');
                    double            angle;
                    unsigned int      n_plies = 1;
                    if (!any_number().read(item.substr(0, underscore), angle) ||
                        std::abs(angle) > 180. ||
                        (underscore != std::string::npos &&
                         !whole_number(1, most_plies)
                            .read(item.substr(underscore + 1), n_plies)))
                      return false;
                    angles.insert(angles.end(), n_plies, angle);
                  }
                if (is_half)
                  for (std::size_t k = angles.size(); k-- > 0;)
                    angles.push_back(angles[k]);
                return angles.size() <= most_plies;
              }};
    }
  } // namespace



  void
  PlateParameters::declare_entries(Entries &entries)
  {
    const auto positive = number_above(0);

    const auto entry = entries.section("Plate");
    entry("Side lengths", "0.2, 0.2", pair_of(positive), side_lengths)
      .means("Of the whole plate, along x and y; the first is the diameter of "
             "a circle. [m]");
    entry("Thickness", "0.008", positive, thickness).means("[m]");
    entry("Young's modulus", "2.1e11", positive, youngs_modulus).means("[Pa]");
    entry("Poisson's ratio", "0.3", number_between(-1, 0.5), poissons_ratio)
      .means("[-]");
    entry("Density", "7800", positive, density).means("[kg/m^3]");
    entry("Yield strength", "0", number_from(0), yield_strength)
      .means("With one of plate or impactor above 0 the contact of a sphere "
             "yields where it is exceeded, the weaker body first, and leaves a "
             "dent. 0 where it is not given. [Pa]");
    entry("Loss factor", "0", number_from(0), loss_factor)
      .means("Of the damping of bending and shear by Kelvin and Voigt, at the "
             "first natural frequency of the motions that the impact can "
             "excite: twice the damping ratio there. It grows in proportion to "
             "the frequency. 0: none. [-]");
    entry("Shear correction factor",
          "0.8333333333333333",
          number_from(0),
          shear_correction_factor)
      .means("Factor of the transverse shear stiffness; 5/6 for a parabolic "
             "shear stress (Reissner). 0: the shear stiffness by equilibrium, "
             "which a laminate has where the factor is not given and the law "
             "is not Sun. [-]");
    entry("Support", "clamped", on_edges<EdgeSupport>(), supports)
      .means("One word for all four edges, or two: for the edges x = +-a/2 and "
             "for the edges y = +-b/2. 'simply supported' also stops the "
             "rotation along the edge (hard support), 'soft simply supported' "
             "the deflection only. Edges of a file may have each its own, as "
             "rim: clamped, hole: free.");
    entry("Deflection", "linear", one_of(deflection_theories), deflection)
      .means("large: a plate that deflects by more than a fifth of its "
             "thickness stretches, and its membrane forces stiffen it (von "
             "Karman). It has displacements in its plane beside the others "
             "and costs several solves a step.");
    entry("In-plane support",
          "held",
          on_edges<InPlaneSupport>(),
          in_plane_supports)
      .means("Of the middle surface, on edges that hold the deflection, for "
             "plates that stretch: under large deflections or with a lay-up "
             "that is not symmetric. 'held along' the edge leaves it free "
             "to slide across, as in Navier's solution of cross-plies; 'held "
             "across' the other way round. One word, two, or one by edge, as "
             "Support.");
    entry("Outline", "rectangle", word_or_file(), outline)
      .means("Of the plate. A circle has one edge and one support. A mesh of "
             "Gmsh, of quadrilaterals and in metres, brings its own lengths "
             "and cells, and its physical groups of curves name the edges; it "
             "is looked for beside the scene first.");
    entry("Impact point", "0, 0", pair_of(any_number()), impact_point)
      .means("Where the impactor strikes, from the centre of the plate, that "
             "of the rectangle around it. What is meshed follows: a quarter of "
             "the plate, a half where one of the two is not 0, or the whole "
             "plate. [m]");
    entry("Layup", "", angles_of_plies(), layup)
      .means("Angles of the fibres to x, from the struck face, of plies with "
             "equal shares of the thickness; an s at the end mirrors them. "
             "Empty: homogeneous and isotropic. [degrees]");

    const auto of_ply = entries.section("Ply");
    of_ply("Longitudinal modulus",
           "141.2e9",
           positive,
           ply.longitudinal_modulus)
      .means("E_1 of a ply of the lay-up, along its fibres; the defaults "
             "are those of T300/934. [Pa]");
    of_ply("Transverse modulus", "9.72e9", positive, ply.transverse_modulus)
      .means("E_2, across them. [Pa]");
    of_ply("Poisson's ratio", "0.3", any_number(), ply.poissons_ratio)
      .means("nu_12, below the root of E_1/E_2. [-]");
    of_ply("In-plane shear modulus",
           "5.53e9",
           positive,
           ply.in_plane_shear_modulus)
      .means("G_12. [Pa]");
    of_ply("Longitudinal shear modulus",
           "5.53e9",
           positive,
           ply.longitudinal_shear_modulus)
      .means("G_13. [Pa]");
    of_ply("Transverse shear modulus",
           "3.74e9",
           positive,
           ply.transverse_shear_modulus)
      .means("G_23. [Pa]");
    of_ply("Through-thickness modulus",
           "0",
           number_from(0),
           ply.through_thickness_modulus)
      .means("E_3; 0: that across the fibres. [Pa]");
    of_ply("Through-thickness Poisson's ratio",
           "0",
           any_number(),
           ply.through_thickness_poissons_ratio)
      .means("nu_13; 0: nu_12. [-]");
    of_ply("Transverse Poisson's ratio",
           "0",
           any_number(),
           ply.transverse_poissons_ratio)
      .means("nu_23; 0: E_2 / (2 G_23) - 1, that of a ply which is the same in "
             "all directions across its fibres. [-]");
    of_ply("Mode II toughness", "0", number_from(0), ply.mode_2_toughness)
      .means("G_IIc between plies: with it a run says how far the force stays "
             "below that from which a laminate delaminates. 0 where it is not "
             "given. [J/m^2]");
  }
} // namespace PlateImpact
