#ifndef plate_impact_output_run_in_words_h
#define plate_impact_output_run_in_words_h

#include "plate_impact/base/parameters.h"
#include "plate_impact/page/page.h"
#include "plate_impact/plate/plate_section.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace PlateImpact
{
  /// The scene in a sentence.
  std::string
  scene_in_words(const Parameters &parameters);

  /// The local response under the contact, and why where it is the only one
  /// that fits. For scenes with an impactor.
  std::string
  local_response_in_words(const Parameters &parameters);

  /// The stresses of a section with what they are, as in its stress_names().
  std::vector<std::string>
  stresses_in_words(const PlateSection &section);

  /// What a reader looks for first: peak force, Zener's beside it, contact,
  /// rebound, error, outcome.
  /// @param summary  the content of summary.json
  std::vector<Fact>
  facts_of_run(const Parameters             &parameters,
               const nlohmann::ordered_json &summary);

  /// What the peak force depends on, and how much of it is known: mesh, time
  /// step, load. For scenes with an impactor.
  Table
  evidence_of_run(const Parameters             &parameters,
                  const nlohmann::ordered_json &summary);
} // namespace PlateImpact

#endif
