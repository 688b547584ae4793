#ifndef plate_impact_page_assets_h
#define plate_impact_page_assets_h

#include <string_view>

/// The files of source/page/ and Chart.js, which cmake/embed.cmake writes into
/// the program.
namespace PlateImpact::PageAssets
{
  extern const std::string_view page, style, page_js, plots_js, zoom_js,
    maps_js, film_js, run_js, comparison_js, sweep_js, chart_js;
}

#endif
