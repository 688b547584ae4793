#include "plate_impact/output/result_directory.h"

#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/version.h"

#include <cerrno>
#include <fcntl.h>
#include <fstream>
#include <regex>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>

namespace PlateImpact
{
  namespace fs = std::filesystem;

  namespace
  {
    const std::regex result_name(
      "(summary\\.json|scene\\.prm|report\\.html|fields\\.pvd|"
      "fields_[0-9]+\\.vtu|contact_history(_(cycle|point)_[0-9]+)?\\.csv|"
      "element_errors_cycle_[0-9]+\\.csv|mesh_cycle_[0-9]+\\.svg|"
      "marking_cycle_[0-9]+\\.json|"
      "comparison\\.(csv|json|html)|sweep\\.(csv|html))"
      "(\\.incomplete)?");
  } // namespace



  ResultDirectory::ResultDirectory(const std::string &path)
    : directory(path)
  {
    std::error_code error;
    fs::create_directories(directory, error);
    if (error == std::errc::not_a_directory || error == std::errc::file_exists)
      throw InputError({"the output directory " + path +
                        " is a file, or within one; expected a directory"});
    if (error)
      throw ComputationError("the output directory " + path +
                             " cannot be created: " + error.message());
    descriptor = open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    // The lock goes with the process, however that ends. A file system that
    // has no locks is no reason not to compute.
    if (flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK)
      return;
    close(descriptor);
    throw InputError({"another run writes to the output directory " + path +
                      "; choose another one by --output, or wait"});
  }



  ResultDirectory::~ResultDirectory()
  {
    close(descriptor);
  }



  void
  ResultDirectory::clear() const
  {
    try
      {
        for (const auto &entry : fs::directory_iterator(directory))
          if (std::regex_match(entry.path().filename().string(), result_name))
            fs::remove(entry);
      }
    catch (const fs::filesystem_error &error)
      {
        throw ComputationError("earlier results in " + directory.string() +
                               " cannot be removed: " + error.code().message());
      }
  }



  void
  ResultDirectory::write_file(
    const std::string                         &name,
    const std::function<void(std::ostream &)> &write) const
  {
    const fs::path path       = directory / name,
                   incomplete = path.string() + ".incomplete";
    try
      {
        // the first write that fails ends the writing, with its reason
        std::ofstream out;
        out.exceptions(std::ios::badbit | std::ios::failbit);
        errno = 0;
        out.open(incomplete);
        write(out);
        out.close();
        fs::rename(incomplete, path);
      }
    catch (const std::system_error &)
      {
        const std::string why =
          errno != 0 ? ": " + std::generic_category().message(errno) : "";
        std::error_code ignored;
        fs::remove(incomplete, ignored);
        throw ComputationError(path.string() + " cannot be written" + why);
      }
  }



  void
  ResultDirectory::write_scene(const std::string &scene,
                               const std::string &text) const
  {
    write_file("scene.prm",
               "# Every value used by plate-impact " PLATE_IMPACT_VERSION
               " for " +
                 scene + "\n\n" + text);
  }



  std::string
  ResultDirectory::main_files() const
  {
    std::string text;
    for (const std::string name : {"report.html",
                                   "comparison.html",
                                   "comparison.csv",
                                   "comparison.json",
                                   "sweep.html",
                                   "sweep.csv",
                                   "summary.json",
                                   "contact_history.csv",
                                   "fields.pvd"})
      if (fs::exists(directory / name))
        text += (text.empty() ? "" : ", ") + (directory / name).string();
    return text;
  }
} // namespace PlateImpact
