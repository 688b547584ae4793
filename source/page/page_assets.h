#pragma once

#include <string_view>

/// The files of source/page/, its scripts as one, and Chart.js, which
/// cmake/embed.cmake writes into the program.
namespace PlateImpact::PageAssets
{
  extern const std::string_view page, style, script, library;
}
