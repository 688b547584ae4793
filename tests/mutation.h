#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// Scenes that no one would write: those of a directory with bytes, words and
  /// lines changed, doubled, dropped and spliced at random; reproducible.
  class Mutation
  {
  public:
    Mutation(const std::string &corpus, const unsigned int seed)
      : generator(seed)
    {
      std::vector<std::filesystem::path> paths;
      for (const auto &entry : std::filesystem::directory_iterator(corpus))
        if (entry.path().extension() == ".prm")
          paths.push_back(entry.path());
      std::sort(paths.begin(), paths.end());
      for (const auto &path : paths)
        {
          std::ifstream      in(path, std::ios::binary);
          std::ostringstream text;
          text << in.rdbuf();
          scenes.push_back(text.str());
        }
    }

    std::string
    next()
    {
      std::string text = any(scenes);
      for (unsigned int n = 1 + below(6); n > 0; --n)
        mutate(text);
      return text;
    }

  private:
    std::size_t
    below(const std::size_t n)
    {
      return generator() % std::max<std::size_t>(n, 1);
    }

    const std::string &
    any(const std::vector<std::string> &list)
    {
      return list[below(list.size())];
    }

    void
    mutate(std::string &text)
    {
      const std::size_t at = below(text.size() + 1), length = 1 + below(20);
      switch (below(5))
        {
          case 0:
            text.insert(at, 1, static_cast<char>(below(256)));
            break;
          case 1:
            text.erase(at, length);
            break;
          case 2:
            text.insert(at, text.substr(at, length));
            break;
          case 3:
            {
              const std::string &other = any(scenes);
              text = text.substr(0, at) + other.substr(below(other.size() + 1));
              break;
            }
          default:
            text.insert(at, any(words));
        }
    }

    std::mt19937                   generator;
    std::vector<std::string>       scenes;
    const std::vector<std::string> words = {"subsection ",
                                            "end\n",
                                            "set ",
                                            " = ",
                                            "\n",
                                            "\r\n",
                                            "#",
                                            ",",
                                            "-1",
                                            "0",
                                            "1e400",
                                            "-1e-400",
                                            "nan",
                                            "inf",
                                            "Plate\n",
                                            "Thickness",
                                            "Time\n",
                                            "\t",
                                            "\\\n",
                                            std::string(1, '\0'),
                                            "\xEF\xBB\xBF",
                                            "99999999999999999999"};
  };
} // namespace PlateImpact
