#include "plate_impact/output/result_directory.h"

#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/version.h"

#include <fstream>
#include <regex>

namespace PlateImpact
{
  namespace fs = std::filesystem;

  namespace
  {
    const std::regex result_name(
      "(summary\\.json|scene\\.prm|report\\.html|fields\\.pvd|"
      "fields_[0-9]+\\.vtu|contact_history(_(cycle|point)_[0-9]+)?\\.csv|"
      "element_errors_cycle_[0-9]+\\.csv|mesh_cycle_[0-9]+\\.svg|"
      "comparison\\.(csv|json|html)|sweep\\.(csv|html))"
      "(\\.incomplete)?");
  } // namespace



  ResultDirectory::ResultDirectory(const std::string &path)
    : directory(path)
  {
    std::error_code error;
    fs::create_directories(directory, error);
    if (error)
      throw ComputationError("the output directory " + directory.string() +
                             " cannot be created: " + error.message());
  }



  void
  ResultDirectory::clear() const
  {
    std::error_code error;
    for (fs::directory_iterator entry(directory, error), end;
         !error && entry != end;
         entry.increment(error))
      if (std::regex_match(entry->path().filename().string(), result_name))
        {
          fs::remove(entry->path(), error);
          if (error)
            break;
        }
    if (error)
      throw ComputationError("earlier results in " + directory.string() +
                             " cannot be removed: " + error.message());
  }



  void
  ResultDirectory::write_file(
    const std::string                         &name,
    const std::function<void(std::ostream &)> &write) const
  {
    const fs::path path       = directory / name,
                   incomplete = path.string() + ".incomplete";
    std::error_code error;
    {
      std::ofstream out(incomplete);
      write(out);
      out.close();
      if (!out)
        {
          fs::remove(incomplete, error);
          throw ComputationError(path.string() + " cannot be written");
        }
    }
    fs::rename(incomplete, path, error);
    if (error)
      throw ComputationError(path.string() +
                             " cannot be written: " + error.message());
  }



  void
  ResultDirectory::write_scene(const std::string &scene,
                               const std::string &text) const
  {
    write_file("scene.prm", [&](std::ostream &out) {
      out << "# Every value used by plate-impact " << PLATE_IMPACT_VERSION
          << " for " << scene << "\n\n"
          << text;
    });
  }



  fs::path
  ResultDirectory::operator/(const std::string &name) const
  {
    return directory / name;
  }
} // namespace PlateImpact
