#include "app/console.h"

#include <fmt/color.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace drape::app {

static bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

static bool is_terminal() {
  const char* kind = std::getenv("TERM");
  return isatty(STDERR_FILENO) != 0 && kind != nullptr && std::string_view(kind) != "dumb";
}

static bool wants_color(UseColor choice) {
  if (choice != UseColor::automatic) return choice == UseColor::always;
  return is_terminal() && !is_set("NO_COLOR");
}

static ProgressStyle settled_style(const Options& options) {
  if (options.verbosity < 0) return ProgressStyle::none;
  if (options.progress != ProgressStyle::automatic) return options.progress;
  return is_terminal() ? ProgressStyle::bar : ProgressStyle::lines;
}

Console make_console(const Options& options) {
  return {options.verbosity, wants_color(options.color), settled_style(options)};
}

// The line with `word`, where it has it, in bold colour.
static void print_line(const Console& console, fmt::terminal_color color, std::string_view word,
                       const std::string& line) {
  const std::size_t at = line.find(word);
  if (!console.color || at == std::string::npos) return fmt::print(stderr, "{}\n", line);
  const std::string shown = fmt::format(fmt::emphasis::bold | fg(color), "{}", word);
  fmt::print(stderr, "{}{}{}\n", line.substr(0, at), shown, line.substr(at + word.size()));
}

void note(const Console& console, const std::string& text) {
  if (console.verbosity >= 0) fmt::print(stderr, "{}\n", text);
}

void detail(const Console& console, const std::string& text) {
  if (console.verbosity > 0) fmt::print(stderr, "{}\n", text);
}

void warn(const Console& console, const std::string& text) {
  if (console.verbosity >= 0)
    print_line(console, fmt::terminal_color::yellow, "warning:", "drape: warning: " + text);
}

void complain(const Console& console, const std::string& line) {
  print_line(console, fmt::terminal_color::red, "error:", line);
}

void print_result(const std::string& text) {
  fmt::print("{}\n", text);
  std::fflush(stdout);
}

}  // namespace drape::app
