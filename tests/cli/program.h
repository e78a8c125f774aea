// Runs the program under test, or any other, without a shell.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.h"

using Words = std::vector<std::string>;

/// The words of a command, at blanks: "sweep g.gsf -o R.csv".
Words words(const std::string& command);
/// A command and one more argument, which may hold anything.
Words operator+(Words command, const std::string& argument);

struct Outcome {
  int exit_code;  ///< 128 + signal where the program was killed
  std::string out, err;
  double seconds = 0;  ///< of processors
  long peak_kib = 0;   ///< most memory that was resident, this test's own at its start included
};

/// Variables to set, or with an empty value to remove.
using Environment = std::map<std::string, std::optional<std::string>>;

/// A program that runs while the test goes on; killed where nobody waits for it.
class Running {
 public:
  /// out_file: takes standard output; empty to catch it.
  Running(Words command, const std::filesystem::path& folder, const Environment& changes,
          const std::string& out_file);
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;
  ~Running();
  void signal(int number) const;
  /// To its end. Once.
  Outcome wait();

 private:
  struct Streams;
  std::unique_ptr<Streams> streams_;
  pid_t process_ = 0;
};

/// A folder in which commands run.
class Scratch : public TemporaryFolder {
 public:
  /// The bytes of a file. Throws std::runtime_error where there is none.
  std::string read(const std::string& name) const;
  bool holds(const std::string& name) const;
  /// All names below the folder with the bytes of files and the targets of links.
  std::map<std::string, std::string> contents() const;

  /// Runs `shedlight` in the folder: input from /dev/null, standard output and error caught.
  Outcome shedlight(const Words& arguments, const Environment& changes = {}) const;
  Outcome shedlight(const std::string& arguments, const Environment& changes = {}) const {
    return shedlight(words(arguments), changes);
  }
  /// The same, without waiting for its end.
  Running start(const Words& arguments, const Environment& changes = {}) const;
  /// The same with standard output into a file that exists, for instance /dev/full.
  Outcome shedlight_into(const std::string& file, const std::string& arguments) const;
  /// Runs another program, found on the PATH.
  Outcome run(const Words& command) const;

  /// Runs `shedlight` for what later commands need; throws with its message where it fails.
  void prepare(const std::string& arguments) const;
};
