// What the process does about signals, and about descriptors that it was started without.
#pragma once

#include <sys/types.h>

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
  explicit EndedWithUs(pid_t child);
  EndedWithUs(const EndedWithUs&) = delete;
  EndedWithUs& operator=(const EndedWithUs&) = delete;
  ~EndedWithUs();
};

}  // namespace apps
