#ifndef plate_impact_sweep_sweep_page_h
#define plate_impact_sweep_sweep_page_h

#include "plate_impact/contact/contact_history.h"
#include "plate_impact/scene/sweep_scene.h"
#include "plate_impact/sweep/sweep_computation.h"
#include "plate_impact/sweep/sweep_table.h"

#include <cstddef>
#include <iosfwd>
#include <map>
#include <optional>
#include <vector>

namespace PlateImpact
{
  /// sweep.html: the range of the force, the figures of the points over the
  /// swept values, histories and the table.
  /// @param rows       of all points
  /// @param histories  of some points
  void
  write_sweep_page(std::ostream                                &out,
                   const SweepScene                            &scene,
                   const std::vector<std::optional<SweepRow>>  &rows,
                   const std::map<std::size_t, ContactHistory> &histories,
                   const SweepWork                             &work);
} // namespace PlateImpact

#endif
