// The entries of the sections Output and Comparison, whose rooms come after
// this one: they read scenes.
#include "plate_impact/base/entries.h"
#include "plate_impact/base/parameters.h"

namespace PlateImpact
{
  void
  OutputParameters::declare_entries(Entries &entries)
  {
    const auto entry = entries.section("Output");
    entry("Directory",
          "output",
          any_text("the name of a directory, without '#' and line ends",
                   /*may_be_empty=*/false),
          directory)
      .means("Created where it does not exist.");
    entry("Write meshes", "true", truth(), write_meshes)
      .means("SVG, one per cycle.");
    entry("Write report", "true", truth(), write_report)
      .means("report.html: the run on one page.");
    entry("Field samples", "0", whole_number(0, 100000), field_samples)
      .means("VTU snapshots over the last cycle; 0: none.");
    entry("Natural frequencies", "0", whole_number(0, 100), natural_frequencies)
      .means("How many of the lowest natural frequencies of the last mesh are "
             "written to summary.json. Only modes with the symmetry of the "
             "impact are counted, since it excites no others.");
  }



  void
  ComparisonParameters::declare_entries(Entries &entries)
  {
    const auto entry = entries.section("Comparison");
    entry("Strategies",
          "uniform, hanging nodes, remeshing",
          list(one_of<ComparedStrategy>(),
               1,
               Choices<ComparedStrategy>::words.size()),
          strategies)
      .means("This section is read by `plate-impact compare` only. The "
             "strategies to compare, each with every element. They adapt the "
             "mesh for the error in the energy norm; those whose name ends in "
             "'by force' adapt it for the error of the peak force "
             "(Adaptivity/Goal).");
    entry("Elements",
          "serendipity, heterosis, Lagrange, MITC9",
          list(one_of<ElementType>(), 1, Choices<ElementType>::words.size()),
          elements)
      .means("As in Discretization/Element.");
    entry("Maximum cycles", "6", whole_number(1, 1000), maximum_cycles)
      .means("Meshes of a curve, the initial one included. Adaptivity/Target "
             "error is halved whenever it is met.");
    entry("Reference peak force", "0", number_from(0), reference_peak_force)
      .means("What errors are relative to; 0: computed by a run much finer "
             "than any in the comparison. [N]");
    entry("Time budget", "60", number_above(0), time_budget)
      .means("Computing time after which a curve is not continued. The time of "
             "the reference does not count. [s]");
  }
} // namespace PlateImpact
