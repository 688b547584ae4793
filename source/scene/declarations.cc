// All entries of a scene: name, default, what is allowed, meaning and unit, in
// the order in which they are printed. A list, as long as there are entries.
#include "plate_impact/scene/declarations.h"

#include "plate_impact/scene/scene_schema.h"

#include <algorithm>

namespace PlateImpact
{
  namespace
  {
    void
    declare_bodies(SceneSchema &schema, Parameters &parameters)
    {
      const Allowed positive       = Allowed::number_above(0);
      const Allowed poissons_ratio = Allowed::number_between(-1, 0.5);

      PlateParameters &plate = parameters.plate;
      schema.begin_section("Plate");
      schema.declare("Side lengths",
                     "0.2, 0.2",
                     Allowed::list(positive, 2, 2),
                     plate.side_lengths,
                     "Of the whole plate, along x and y; the first is the "
                     "diameter of a circle. [m]");
      schema.declare("Thickness", "0.008", positive, plate.thickness, "[m]");
      schema.declare("Young's modulus",
                     "2.1e11",
                     positive,
                     plate.youngs_modulus,
                     "[Pa]");
      schema.declare("Poisson's ratio",
                     "0.3",
                     poissons_ratio,
                     plate.poissons_ratio,
                     "[-]");
      schema.declare("Density", "7800", positive, plate.density, "[kg/m^3]");
      schema.declare("Shear correction factor",
                     "0.8333333333333333",
                     positive,
                     plate.shear_correction_factor,
                     "Factor of the transverse shear stiffness; 5/6 for a "
                     "parabolic shear stress (Reissner). [-]");
      schema.declare(
        "Support",
        "clamped",
        Allowed::supports(),
        plate.supports,
        "One word for all four edges, or two: for the edges x = +-a/2 and for "
        "the edges y = +-b/2. 'simply supported' also stops the rotation along "
        "the edge (hard support), 'soft simply supported' the deflection only. Edges of a file may have "
        "each its own, as rim: clamped, hole: free.");
      schema.declare("Outline",
                     "rectangle",
                     Allowed::outline(),
                     plate.outline,
                     "Of the plate. A circle has one edge and one support. A "
                     "mesh of Gmsh, of quadrilaterals and in metres, brings "
                     "its own lengths and cells, and its physical groups of "
                     "curves name the edges; it is looked for beside the "
                     "scene first.");
      schema.declare(
        "Impact point",
        "0, 0",
        Allowed::list(Allowed::any_number(), 2, 2),
        plate.impact_point,
        "Where the impactor strikes, from the centre of the plate, that of the "
        "rectangle around it. "
        "What is meshed follows: a quarter of the plate, a half "
        "where one of the two is not 0, or the whole plate. [m]");
      schema.declare("Layup",
                     "",
                     Allowed::layup(),
                     plate.layup,
                     "Angles of the fibres to x, from the struck face, of "
                     "plies with equal shares of the thickness; an s at the "
                     "end mirrors them. Empty: homogeneous and isotropic. "
                     "[degrees]");

      PlyParameters &ply = plate.ply;
      schema.begin_section("Ply");
      schema.declare("Longitudinal modulus",
                     "120e9",
                     positive,
                     ply.longitudinal_modulus,
                     "E_1 of a ply of the lay-up, along its fibres. [Pa]");
      schema.declare("Transverse modulus",
                     "7.9e9",
                     positive,
                     ply.transverse_modulus,
                     "E_2, across them. [Pa]");
      schema.declare("Poisson's ratio",
                     "0.3",
                     Allowed::any_number(),
                     ply.poissons_ratio,
                     "nu_12, below the root of E_1/E_2. [-]");
      schema.declare("In-plane shear modulus",
                     "5.5e9",
                     positive,
                     ply.in_plane_shear_modulus,
                     "G_12. [Pa]");
      schema.declare("Longitudinal shear modulus",
                     "5.5e9",
                     positive,
                     ply.longitudinal_shear_modulus,
                     "G_13. [Pa]");
      schema.declare("Transverse shear modulus",
                     "5.5e9",
                     positive,
                     ply.transverse_shear_modulus,
                     "G_23. [Pa]");

      ImpactorParameters &impactor = parameters.impactor;
      schema.begin_section("Impactor");
      schema.declare("Shape",
                     "sphere",
                     Allowed::word_for<ImpactorShape>(),
                     impactor.shape,
                     "Cylinder: barrelled, with its axis along x.");
      schema.declare("Radius", "0.01", positive, impactor.radius, "[m]");
      schema.declare("Length",
                     "0.066667",
                     positive,
                     impactor.length,
                     "Contact length 2l of a cylinder. [m]");
      schema.declare("Mass",
                     "0",
                     Allowed::number_from(0),
                     impactor.mass,
                     "0: from the density and the volume of the shape. [kg]");
      schema.declare("Density", "7800", positive, impactor.density, "[kg/m^3]");
      schema.declare("Young's modulus",
                     "2.1e11",
                     positive,
                     impactor.youngs_modulus,
                     "[Pa]");
      schema.declare("Poisson's ratio",
                     "0.3",
                     poissons_ratio,
                     impactor.poissons_ratio,
                     "[-]");
      schema.declare("Velocity",
                     "1.0",
                     positive,
                     impactor.velocity,
                     "Towards the plate. [m/s]");

      ContactParameters &contact = parameters.contact;
      schema.begin_section("Contact");
      schema.declare(
        "Law",
        "Hertz",
        Allowed::word_for<ForceLaw>(),
        contact.law,
        "Hertz: F = k alpha^1.5 with the compliance (1 - nu^2)/E of both "
        "bodies. Sun: with 1/E for the plate, the paper's eq. 17. line: of a "
        "cylinder, and what one has where no law is given; on a half-space "
        "the paper's eq. 32.");
      schema.declare(
        "Local response",
        "layer",
        Allowed::word_for<LocalResponse>(),
        contact.local_response,
        "What the plate does under the contact besides bending and shear. "
        "layer: what an elastic layer of the plate's thickness does. "
        "half-space: what Hertz's law says, as usual and in the paper, which "
        "counts the shortest waves twice; where no response is given, that "
        "of the law Sun, of point and line loads, of laminates and of "
        "unloading by Yang-Sun.");
      schema.declare("Unloading",
                     "elastic",
                     Allowed::word_for<UnloadingLaw>(),
                     contact.unloading,
                     "elastic: along the curve of loading. Yang-Sun: steeper, "
                     "down to a dent, and back by another curve, as measured "
                     "on laminates; of spheres on a half-space.");
      schema.declare("Critical indentation",
                     "8e-5",
                     positive,
                     contact.critical_indentation,
                     "From which on Yang-Sun leaves a dent; 8e-5 for "
                     "graphite/epoxy, 1.65e-4 for glass/epoxy. [m]");
      schema.declare(
        "Load distribution",
        "Hertz disc",
        Allowed::word_for<LoadShape>(),
        contact.load_distribution,
        "How the contact force spreads over the plate; where it is not "
        "given, as a strip under a cylinder. The displacement of the plate in "
        "the contact law is averaged with the same weights. Under 'point' the peak force has no limit "
        "under refinement: it drops with every halving of the cells.");
      schema.declare(
        "Patch radius",
        "0",
        Allowed::number_from(0),
        contact.patch_radius,
        "Radius of the disc or half-width of the strip; 0: with a layer "
        "that with which plate theory and layer answer alike to long waves, "
        "with a half-space the Hertz contact radius at the peak force that "
        "Zener's equation predicts, to the nearest of 64 in an octave. [m]");
      schema.declare(
        "Integration",
        "energy conserving",
        Allowed::word_for<ForceIntegration>(),
        contact.integration,
        "energy conserving: the mean force of the law over the "
        "step. collocation: the force at the end of the step, as in "
        "the paper; it gains energy when the step is coarse.");
    }



    void
    declare_method(SceneSchema &schema, Parameters &parameters)
    {
      const Allowed positive = Allowed::number_above(0);

      DiscretizationParameters &discretization = parameters.discretization;
      schema.begin_section("Discretization");
      schema.declare(
        "Element",
        "MITC9",
        Allowed::word_for<ElementType>(),
        discretization.element,
        "Deflection and rotations with 8 nodes (serendipity, the "
        "paper's; serendipity full: with 3x3 points for the shear), "
        "with 8 and 9 (heterosis) or with 9 (Lagrange); "
        "with 9 and mixed interpolation of the shear (MITC9), which "
        "neither locks on thin plates nor has spurious modes.");
      schema.declare("Initial cells",
                     "3, 3",
                     Allowed::list(Allowed::whole_number(1, 10000), 2, 2),
                     discretization.initial_cells,
                     "On the part of the plate that is meshed, the quadrant "
                     "under an impact at the centre, along x and y.");
      schema.declare("Linear solver",
                     "CHOLMOD",
                     Allowed::word_for<SolverType>(),
                     discretization.linear_solver,
                     "Direct solver of the effective stiffness: CHOLMOD "
                     "(supernodal Cholesky) or KLU of Trilinos' Amesos.");

      TimeParameters &time = parameters.time;
      schema.begin_section("Time");
      schema.declare("End time",
                     "80e-6",
                     Allowed::number_from(0),
                     time.end_time,
                     "0: to the end of the first contact. [s]");
      schema.declare("Time step",
                     "1e-7",
                     Allowed::number_from(0),
                     time.time_step,
                     "Shortened where End time is not a multiple of it. 0: by "
                     "powers of two, the largest that meets Step tolerance in "
                     "Zener's equation. [s]");
      schema.declare("Step tolerance",
                     "1e-4",
                     Allowed::number_between(0, 1),
                     time.step_tolerance,
                     "Error of the peak force by the time step, relative to "
                     "it, with which the program chooses a step. [-]");
      schema.declare("Integrator",
                     "Ritz vectors",
                     Allowed::word_for<IntegratorType>(),
                     time.integrator,
                     "What Newmark's method integrates: the unknowns of the "
                     "mesh (Newmark), or their coordinates in load-dependent "
                     "Ritz vectors, as many as the force needs; on the mesh "
                     "nevertheless where that takes more of them than "
                     "steps.");
      schema.declare(
        "Ritz tolerance",
        "1e-5",
        Allowed::number_above(0),
        time.ritz_tolerance,
        "Estimated error of the force against that of the mesh, as "
        "a fraction of its peak, below which no further Ritz "
        "vectors are added: a root mean square over the contact. "
        "[-]");
      schema.declare("Newmark beta",
                     "0.25",
                     Allowed::number_up_to(0, 1),
                     time.newmark_beta,
                     "At least half of gamma: unconditionally stable. [-]");
      schema.declare("Newmark gamma",
                     "0.5",
                     Allowed::number_from(0.5),
                     time.newmark_gamma,
                     "Above 0.5 the scheme damps, to first order. [-]");

      AdaptivityParameters &adaptivity = parameters.adaptivity;
      schema.begin_section("Adaptivity");
      schema.declare("Strategy",
                     "hanging nodes",
                     Allowed::word_for<AdaptationStrategy>(),
                     adaptivity.strategy,
                     "How the mesh follows the error. hanging nodes, "
                     "remeshing: cells of the target sizes, by refinement and "
                     "coarsening or by a new mesh of quadrilaterals. fixed "
                     "fraction, fixed number: the cells with the largest "
                     "errors are halved, until they hold a share of the error "
                     "or of the cells. uniform: all cells are. graded: sizes "
                     "proportional to the distance from the contact, whatever "
                     "the error.");
      schema.declare("Goal",
                     "energy norm",
                     Allowed::word_for<AdaptationGoal>(),
                     adaptivity.goal,
                     "What the mesh is made for: the error in the energy norm "
                     "eta, the paper's, up to Target error, or that of the "
                     "peak force, up to Target peak force error. The first "
                     "mesh is then fine at the load.");
      schema.declare("Indicator",
                     "SPR",
                     Allowed::word_for<ErrorIndicator>(),
                     adaptivity.indicator,
                     "Where the error is: by the recovered field (SPR) or by "
                     "the jumps of slopes and curvatures across the sides of "
                     "cells (Kelly), which only rank cells; eta is that of "
                     "the recovered field in any case.");
      schema.declare("Recovery patches",
                     "mirrored",
                     Allowed::word_for<RecoveryPatches>(),
                     adaptivity.recovery_patches,
                     "Where the patches of the recovery lie: around every "
                     "vertex, continued across planes of symmetry by mirror "
                     "images (mirrored), or around vertices inside the "
                     "mesh only (interior), whose patches those on its "
                     "edges use.");
      schema.declare("Target error",
                     "0.05",
                     Allowed::number_between(0, 1),
                     adaptivity.target_error,
                     "Relative error in the energy norm eta, a fraction. [-]");
      schema.declare("Target peak force error",
                     "1e-3",
                     Allowed::number_between(0, 1),
                     adaptivity.target_peak_force_error,
                     "Of the error bar of the peak force, relative to it, for "
                     "the goal peak force. [-]");
      schema.declare("Verify",
                     "false",
                     Allowed::truth(),
                     adaptivity.verify,
                     "Compute the peak force again on the last mesh with every "
                     "cell halved, and say how far it is.");
      schema.declare("Maximum cycles",
                     "6",
                     Allowed::whole_number(1, 1000),
                     adaptivity.maximum_cycles,
                     "Meshes computed on, the initial one included.");
      schema.declare("Maximum cells",
                     "250000",
                     Allowed::whole_number(1, 100000000),
                     adaptivity.maximum_cells,
                     "No mesh with more is made; the run ends before it.");
      schema.declare("Size exponent",
                     "0.5",
                     Allowed::number_up_to(0, 4),
                     adaptivity.size_exponent,
                     "phi in h_new = h_old / xi'^phi: 1/p, or 1/lambda near a "
                     "singularity of strength lambda. [-]");
      schema.declare(
        "Minimum cell size",
        "0",
        Allowed::number_from(0),
        adaptivity.minimum_cell_size,
        "Of a cell's longer side; 0: a quarter of the patch radius, "
        "or of the thickness under a point or line load. [m]");
      schema.declare("Maximum cell size",
                     "0",
                     Allowed::number_from(0),
                     adaptivity.maximum_cell_size,
                     "Of a cell's longer side, in meshes that follow the "
                     "error; 0: that of the initial cells. [m]");
      const Allowed share = Allowed::number_between(0, 1);
      schema.declare("Refined share of error",
                     "0.7",
                     share,
                     adaptivity.refined_share_of_error,
                     "fixed fraction: the cells with the largest errors that "
                     "together hold at most this share of the squared error "
                     "are halved (Doerfler's marking). [-]");
      schema.declare("Coarsened share of error",
                     "0.01",
                     share,
                     adaptivity.coarsened_share_of_error,
                     "fixed fraction: the cells with the smallest errors that "
                     "together hold at most this share are doubled. [-]");
      schema.declare("Refined share of cells",
                     "0.3",
                     share,
                     adaptivity.refined_share_of_cells,
                     "fixed number: this share of the cells, those with the "
                     "largest errors, is halved. [-]");
      schema.declare("Coarsened share of cells",
                     "0.03",
                     share,
                     adaptivity.coarsened_share_of_cells,
                     "fixed number: this share of the cells, those with the "
                     "smallest errors, is doubled. [-]");
      schema.declare(
        "Sampling interval",
        "5",
        Allowed::whole_number(1, 1000000),
        adaptivity.sampling_interval,
        "Time steps between samples of the error estimator; fewer where "
        "the transient would have less than 20 samples.");
    }



    void
    declare_output(SceneSchema &schema, Parameters &parameters)
    {
      OutputParameters &output = parameters.output;
      schema.begin_section("Output");
      schema.declare("Directory",
                     "output",
                     {"the name of a directory, without '#' and line ends",
                      [](const std::string &text) {
                        return !text.empty() &&
                          text.find_first_of("#\n\r") == std::string::npos;
                      }},
                     output.directory,
                     "Created where it does not exist.");
      schema.declare("Write meshes",
                     "true",
                     Allowed::truth(),
                     output.write_meshes,
                     "SVG, one per cycle.");
      schema.declare("Write report",
                     "true",
                     Allowed::truth(),
                     output.write_report,
                     "report.html: the run on one page.");
      schema.declare("Field samples",
                     "0",
                     Allowed::whole_number(0, 100000),
                     output.field_samples,
                     "VTU snapshots over the last cycle; 0: none.");
      schema.declare("Natural frequencies",
                     "0",
                     Allowed::whole_number(0, 100),
                     output.natural_frequencies,
                     "How many of the lowest summary.json has, of the last "
                     "mesh: of motions with the symmetry of the part that is "
                     "meshed, which alone the impact excites.");
    }



    void
    declare_comparison(SceneSchema &schema, Parameters &parameters)
    {
      ComparisonParameters &comparison = parameters.comparison;
      schema.begin_section("Comparison");
      schema.declare("Strategies",
                     "uniform, hanging nodes, remeshing",
                     Allowed::list(Allowed::word_for<ComparedStrategy>(),
                                   1,
                                   choices<ComparedStrategy>().size()),
                     comparison.strategies,
                     "This section is read by `plate-impact compare` only. "
                     "What is compared, each with every element: meshes made "
                     "for the error in the energy norm, or, by force, for that "
                     "of the peak force (Adaptivity/Goal).");
      schema.declare("Elements",
                     "serendipity, heterosis, Lagrange, MITC9",
                     Allowed::list(Allowed::word_for<ElementType>(),
                                   1,
                                   choices<ElementType>().size()),
                     comparison.elements,
                     "As in Discretization/Element.");
      schema.declare("Maximum cycles",
                     "6",
                     Allowed::whole_number(1, 1000),
                     comparison.maximum_cycles,
                     "Meshes of a curve, the initial one included. Adaptivity/"
                     "Target error is halved whenever it is met.");
      schema.declare("Reference peak force",
                     "0",
                     Allowed::number_from(0),
                     comparison.reference_peak_force,
                     "What errors are relative to; 0: computed by a run much "
                     "finer than any in the comparison. [N]");
      schema.declare("Time budget",
                     "60",
                     Allowed::number_above(0),
                     comparison.time_budget,
                     "Of a curve: none is continued past it. The reference is "
                     "not counted. [s]");
    }



    void
    declare_sweep(SceneSchema &schema, SweepParameters &sweep)
    {
      const std::array<std::string, 3> reader = {
        {"Read by `plate-impact sweep` only, as the entries below. An entry of "
         "the scene that is given the values below one after another: "
         "Section/Entry, for example Impactor/Velocity; empty: none.",
         "",
         ""}};
      const std::array<std::string, 3> values = {
        {"Values separated by commas, 1, 2, 5, and ranges first:last:number of "
         "so many equidistant values, 0.5:5:20. Where values have commas "
         "themselves, as side lengths, semicolons separate them.",
         "",
         ""}};
      schema.begin_section("Sweep");
      for (unsigned int n = 0; n < 3; ++n)
        {
          schema.declare("Entry " + std::to_string(n + 1),
                         "",
                         Allowed::anything("Section/Entry"),
                         sweep.entries[n],
                         reader[n]);
          schema.declare("Values " + std::to_string(n + 1),
                         "",
                         Allowed::anything("a list or a range"),
                         sweep.values[n],
                         values[n]);
        }
      schema.declare("Combination",
                     "product",
                     Allowed::word_for<SweepCombination>(),
                     sweep.combination,
                     "product: every value with every other; zip: the first "
                     "values of all lists, the second ones, and so on.");
      schema.declare("Adapt",
                     "worst point",
                     Allowed::word_for<SweepAdaptation>(),
                     sweep.adapt,
                     "worst point: points that share plate and load are "
                     "computed on the last mesh of the one with the shortest "
                     "contact; each point: on a mesh of its own.");
      schema.declare("Estimate error",
                     "false",
                     Allowed::truth(),
                     sweep.estimate_error,
                     "Estimate the error in the energy norm of every point, "
                     "which then costs as much as the stepping of a run.");
      schema.declare("Write histories",
                     "false",
                     Allowed::truth(),
                     sweep.write_histories,
                     "contact_history_point_K.csv for every row K.");
    }
  } // namespace



  void
  declare_parameters(SceneSchema &schema, Parameters &parameters)
  {
    declare_bodies(schema, parameters);
    declare_method(schema, parameters);
    declare_output(schema, parameters);
    declare_comparison(schema, parameters);
    declare_sweep(schema, parameters.sweep);
  }
} // namespace PlateImpact
