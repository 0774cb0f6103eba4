#include "app/interrupt.h"

#include <atomic>
#include <csignal>

namespace drape::app {

// A signal handler can reach nothing but a global; this is the program's only one.
static std::atomic<int> received_signal = 0;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)
static_assert(std::atomic<int>::is_always_lock_free);

static void remember(int signal) { received_signal = signal; }

void remember_stop_signals() {
  struct sigaction action = {};
  action.sa_handler = remember;
  action.sa_flags = static_cast<int>(SA_RESETHAND);  // the second time, the signal does what it always does
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

int stop_signal() { return received_signal; }

void throw_if_stopped() {
  if (stop_signal() != 0) throw Interrupted{stop_signal()};
}

}  // namespace drape::app
