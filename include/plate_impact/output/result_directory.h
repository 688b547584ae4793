#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>

namespace PlateImpact
{
  /// The directory that the results of a scene go to, ours alone as long as
  /// this object lives. All members throw ComputationError when it cannot be
  /// written.
  class ResultDirectory
  {
  public:
    /// Creates it where it does not exist.
    /// @throws InputError  where it is no directory, or another run writes to
    /// it
    explicit ResultDirectory(const std::string &path);

    ~ResultDirectory();

    ResultDirectory(const ResultDirectory &) = delete;

    /// Removes results of earlier runs: files that carry the names of results.
    void
    clear() const;

    /// Writes a file that appears under its name when it is complete.
    void
    write_file(const std::string                         &name,
               const std::function<void(std::ostream &)> &write) const;
    void
    write_file(const std::string &name, const std::string &text) const
    {
      write_file(name, [&text](std::ostream &out) { out << text; });
    }

    /// scene.prm: every value used.
    /// @param scene  its name
    void
    write_scene(const std::string &scene, const std::string &text) const;

    /// The files to look at first, for the user.
    std::string
    main_files() const;

    std::filesystem::path
    operator/(const std::string &name) const
    {
      return directory / name;
    }

  private:
    const std::filesystem::path directory;
    int descriptor; ///< of the directory; carries the lock
  };
} // namespace PlateImpact
