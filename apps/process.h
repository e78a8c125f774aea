// What the process does about signals, and about descriptors that it was started without.
#pragma once

#include <sys/types.h>

#include <functional>

namespace apps {

/// To be called first.
///
/// SIGINT, SIGTERM and SIGHUP remove temporary names, end a running child and then the process, by
/// that signal, as a shell expects. A limit on file sizes makes writing fail instead of killing.
/// Standard descriptors that are closed are opened on nothing, the wrong way round: a file of ours
/// does not become standard output, and writing there fails.
void prepare_process();

/// A child that a signal ends with us.
class EndedWithUs {
 public:
  /// start: gives its number, or throws. No signal comes between the two.
  explicit EndedWithUs(const std::function<pid_t()>& start);
  EndedWithUs(const EndedWithUs&) = delete;
  EndedWithUs& operator=(const EndedWithUs&) = delete;
  ~EndedWithUs();
  pid_t child() const { return child_; }

 private:
  pid_t child_;
};

}  // namespace apps
