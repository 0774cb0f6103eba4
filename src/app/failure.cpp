#include "app/failure.h"

#include <fmt/format.h>

#include <filesystem>
#include <new>

#include "app/exit_status.h"
#include "app/interrupt.h"
#include "core/error.h"
#include "render/render_error.h"

namespace drape::app {

static Failure failure(ExitStatus status, const std::string& message) {
  return {static_cast<int>(status), {"drape: error: " + message}};
}

// Places come first, as compilers write them, so that editors find them.
static Failure failure(const InputError& error) {
  Failure result{error.exit_status(), {}};
  for (const Problem& problem : error.problems()) {
    result.lines.push_back(problem.file.empty() ? "drape: " + to_string(problem) : to_string(problem));
  }
  return result;
}

static Failure failure(const Interrupted& stop) {
  return {static_cast<int>(ExitStatus::stopped_by_signal) + stop.signal,
          {"drape: stopped. What is written is whole; the same command goes on from there."}};
}

Failure describe_current_exception() {
  try {
    throw;
  } catch (const InputError& error) {
    return failure(error);
  } catch (const Interrupted& stop) {
    return failure(stop);
  } catch (const FileError& error) {
    return failure(ExitStatus::file, error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    return failure(ExitStatus::file, error.path1().string() + ": " + error.code().message());
  } catch (const SimulationError& error) {
    return failure(ExitStatus::simulation, error.what());
  } catch (const EncoderError& error) {
    return failure(ExitStatus::encoder, error.what());
  } catch (const render::RenderError& error) {
    return failure(ExitStatus::limit, error.what());
  } catch (const std::bad_alloc&) {
    return failure(ExitStatus::limit, "out of memory: lower the resolution, the points of the cloths or -j");
  } catch (const std::exception& error) {
    return failure(ExitStatus::internal, fmt::format("a fault in drape itself: {}", error.what()));
  }
}

}  // namespace drape::app
