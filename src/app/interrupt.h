#pragma once

namespace drape::app {

// Thrown where work stops because of a signal; everything written is whole by then.
struct Interrupted {
  int signal;
};

// From now on SIGINT and SIGTERM are remembered, and work stops at the next whole frame. The same signal
// again ends the program at once.
void remember_stop_signals();

// The signal that arrived, or 0.
int stop_signal();

void throw_if_stopped();

}  // namespace drape::app
