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
      const auto word =
        one_of<Word<PlateOutline>>({{PlateOutline::rectangle, "rectangle"},
                                    {PlateOutline::circle, "circle"}});
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
      .means("If it is given for the plate or the impactor, the contact of a "
             "sphere can yield, the weaker body first, and leave a dent. 0: "
             "not given. [Pa]");
    entry("Loss factor", "0", number_from(0), loss_factor)
      .means("Loss factor of the Kelvin-Voigt damping of bending and shear at "
             "the lowest natural frequency that the impact can excite: twice "
             "the damping ratio there. It grows in proportion to the "
             "frequency. 0: no damping. [-]");
    entry("Shear correction factor",
          "0.8333333333333333",
          number_from(0),
          shear_correction_factor)
      .means("Factor of the transverse shear stiffness; 5/6 for a parabolic "
             "shear stress (Reissner). 0: the shear stiffness follows from "
             "equilibrium; this is the default for a laminate, except with the "
             "law Sun. [-]");
    entry("Support", "clamped", on_edges<EdgeSupport>(), supports)
      .means("One word for all four edges, or two: for the edges x = +-a/2 and "
             "for the edges y = +-b/2. 'simply supported' fixes the deflection "
             "and the tangential rotation (hard support), 'soft simply "
             "supported' the deflection only. The edges of an outline from a "
             "file can differ, for example rim: clamped, hole: free.");
    entry("Deflection",
          "linear",
          second_of("linear", "large"),
          has_large_deflection)
      .means("linear: small deflections. large: von Karman's theory, for "
             "deflections of more than a fifth of the thickness: the plate "
             "stretches, and membrane forces stiffen it. It adds in-plane "
             "displacements as unknowns and costs several solves per step.");
    entry("In-plane support",
          "held",
          on_edges<InPlaneSupport>(),
          in_plane_supports)
      .means("In-plane displacements of the middle surface on edges that hold "
             "the deflection. It matters for large deflections and for "
             "unsymmetric lay-ups only. 'held along' fixes the displacement "
             "along the edge and leaves that across it free, as in Navier's "
             "solution for cross-ply laminates; 'held across' is the reverse. "
             "One word, two, or one for each edge, as for Support.");
    entry("Outline", "rectangle", word_or_file(), outline)
      .means("rectangle, circle, or the file of a Gmsh mesh of quadrilaterals, "
             "in metres. A circle has one edge and one support. A mesh "
             "replaces Side lengths and Initial cells, and its physical groups "
             "of curves name the edges; its file is looked for in the "
             "directory of the scene first.");
    entry("Impact point", "0, 0", pair_of(any_number()), impact_point)
      .means("Where the impactor strikes: x and y from the centre of the plate "
             "or, for an outline from a file, of its bounding rectangle. Where "
             "the plate is symmetric, only a quarter of it is meshed if both "
             "are 0, and half of it if one is. [m]");
    entry("Layup", "", angles_of_plies(), layup)
      .means("Angles of the fibres to the x axis, ply by ply from the struck "
             "face; all plies are equally thick. An s at the end mirrors the "
             "list. Empty: an isotropic plate. [degrees]");

    auto &[E_1, E_2, nu_12, G_12, G_13, G_23, E_3, nu_13, nu_23, G_IIc] = ply;
    const auto of_ply = entries.section("Ply");
    of_ply("Longitudinal modulus", "141.2e9", positive, E_1)
      .means("E_1 of a ply of the lay-up, along its fibres; the defaults "
             "are those of T300/934. [Pa]");
    of_ply("Transverse modulus", "9.72e9", positive, E_2)
      .means("E_2, across them. [Pa]");
    of_ply("Poisson's ratio", "0.3", any_number(), nu_12)
      .means("nu_12, below the root of E_1/E_2. [-]");
    of_ply("In-plane shear modulus", "5.53e9", positive, G_12)
      .means("G_12. [Pa]");
    of_ply("Longitudinal shear modulus", "5.53e9", positive, G_13)
      .means("G_13. [Pa]");
    of_ply("Transverse shear modulus", "3.74e9", positive, G_23)
      .means("G_23. [Pa]");
    of_ply("Through-thickness modulus", "0", number_from(0), E_3)
      .means("E_3; 0: that across the fibres. [Pa]");
    of_ply("Through-thickness Poisson's ratio", "0", any_number(), nu_13)
      .means("nu_13; 0: nu_12. [-]");
    of_ply("Transverse Poisson's ratio", "0", any_number(), nu_23)
      .means("nu_23; 0: E_2 / (2 G_23) - 1, as for a transversely isotropic "
             "ply. [-]");
    of_ply("Mode II toughness", "0", number_from(0), G_IIc)
      .means("G_IIc between plies. If it is given, a run compares the peak "
             "force with the delamination threshold. 0: not given. [J/m^2]");
  }
} // namespace PlateImpact
