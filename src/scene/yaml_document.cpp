#include "scene/yaml_document.h"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <istream>
#include <map>
#include <sstream>
#include <utility>

#include "scene/bare_color.h"
#include "scene/text_encoding.h"

namespace drape {
namespace {

// Stops the parser from within.
struct Refusal {
  Place place;
  std::string message;
};

// Builds the tree from the parser's events, which come before any expansion: an alias is one event, and what
// it stands for is counted here before it is copied.
class TreeBuilder : public YAML::EventHandler {
 public:
  TreeBuilder(std::shared_ptr<const std::string> file, DocumentBudget& budget, ProblemList& problems)
      : file_(std::move(file)), budget_(budget), problems_(problems) {}

  Node take_root() { return std::move(root_); }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (std::exchange(started_, true))
      throw Refusal{place(mark), "a second document starts here; a scene is one document"};
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    Node node = make_node(mark, Node::Kind::null);
    add_value(std::move(node), anchor);
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& text) override {
    refuse_tag(mark, tag);
    refuse_escaped(mark, text);
    Node node = make_node(mark, Node::Kind::scalar, text);
    if (awaits_key()) return take_key(node);
    add_value(std::move(node), anchor);
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto found = anchors_.find(anchor);
    if (found == anchors_.end()) throw Refusal{place(mark), "an alias stands inside of what it stands for"};
    if (static_cast<int>(open_.size()) + depth_of(found->second) > largest_node_depth)
      throw Refusal{place(mark), too_deep()};
    take_budget(place(mark), found->second);
    add_value(found->second, 0);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, Node::Kind::sequence);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, Node::Kind::map);
  }
  void OnMapEnd() override { close(); }

 private:
  // A map or sequence whose end has not come yet.
  struct OpenNode {
    Node node;
    YAML::anchor_t anchor;
    std::optional<MapEntry> entry;      // of a map: the key whose value comes next
    std::map<std::string, Place> keys;  // of a map: where each key came first
  };

  Place place(const YAML::Mark& mark) const { return {file_, mark.line + 1, mark.column + 1}; }

  static std::string too_deep() { return fmt::format("nested deeper than {} levels", largest_node_depth); }

  bool awaits_key() const {
    return !open_.empty() && open_.back().node.kind == Node::Kind::map && !open_.back().entry;
  }

  void refuse_tag(const YAML::Mark& mark, const std::string& tag) const {
    if (tag.empty() || tag == "?" || tag == "!") return;
    throw Refusal{place(mark), "the tag " + quote(tag) + " has no meaning in a scene"};
  }

  // Escapes in quotes bring back what the text as a whole was checked for.
  void refuse_escaped(const YAML::Mark& mark, const std::string& text) const {
    if (const auto fault = find_encoding_fault(text)) throw Refusal{place(mark), fault->message};
    if (awaits_key() && text.find('\n') != std::string::npos)
      throw Refusal{place(mark), "a key must be one line"};
  }

  void take_budget(const Place& at, const Node& node) {
    const std::size_t nodes = count_nodes(node), text = count_text(node);
    if (nodes > budget_.nodes)
      throw Refusal{at, fmt::format("more than {} values, with aliases expanded", largest_node_count)};
    if (text > budget_.text)
      throw Refusal{at, fmt::format("more than {} bytes of text, with aliases expanded", largest_document)};
    budget_.nodes -= nodes;
    budget_.text -= text;
  }

  Node make_node(const YAML::Mark& mark, Node::Kind kind, const std::string& text = {}) {
    Node node{kind, place(mark), text, {}, {}};
    take_budget(node.place, node);
    return node;
  }

  void take_key(const Node& node) { open_.back().entry = MapEntry{node.text, node.place, {}}; }

  void open(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, Node::Kind kind) {
    refuse_tag(mark, tag);
    if (awaits_key()) throw Refusal{place(mark), "a key must be text"};
    if (static_cast<int>(open_.size()) + 1 > largest_node_depth) throw Refusal{place(mark), too_deep()};
    open_.push_back({make_node(mark, kind), anchor, std::nullopt, {}});
  }

  void close() {
    OpenNode closed = std::move(open_.back());
    open_.pop_back();
    add_value(std::move(closed.node), closed.anchor);
  }

  void add_value(Node node, YAML::anchor_t anchor) {
    if (awaits_key()) throw Refusal{node.place, "a key must be text"};
    if (anchor != 0) {
      // The copy is paid for too: anchors nested in anchors would hold the square of the text.
      take_budget(node.place, node);
      anchors_.insert_or_assign(anchor, node);
    }
    if (open_.empty()) {
      root_ = std::move(node);
    } else if (OpenNode& parent = open_.back(); parent.entry) {
      add_entry(parent, std::move(node));
    } else {
      parent.node.items.push_back(std::move(node));
    }
  }

  void add_entry(OpenNode& map, Node node) {
    MapEntry entry = std::move(*map.entry);
    map.entry.reset();
    // The parser places a value that is not there at the next token.
    if (node.kind == Node::Kind::null) node.place = entry.place;
    const auto [first, is_new] = map.keys.emplace(entry.key, entry.place);
    if (!is_new) {
      problems_.add(entry.place, fmt::format("key {} is given twice; the first is at line {}, column {}",
                                             quote(entry.key), first->second.line, first->second.column));
      return;
    }
    entry.value = std::move(node);
    map.node.entries.push_back(std::move(entry));
  }

  std::shared_ptr<const std::string> file_;
  DocumentBudget& budget_;
  ProblemList& problems_;
  std::vector<OpenNode> open_;
  std::map<YAML::anchor_t, Node> anchors_;
  Node root_;
  bool started_ = false;
};

// The parser calls a tab in the indentation many things, depending on what comes before it.
bool tab_indents(std::string_view text, int line) {
  std::size_t begin = 0;
  for (; line > 1 && begin != std::string_view::npos; --line) {
    begin = text.find('\n', begin);
    if (begin != std::string_view::npos) ++begin;
  }
  if (begin == std::string_view::npos) return false;
  const std::size_t content = text.find_first_not_of(" \t", begin);
  return text.substr(begin, content - begin).find('\t') != std::string_view::npos;
}

// The parser takes the end of the text for the end of a quote; an end of the document in a quote is an error.
constexpr std::string_view document_end = "\n...\n";

// The parser's words for the commonest mistakes name what it looked for, not what is wrong.
std::string in_plain_words(const std::string& message) {
  if (message == "end of map flow not found") return "a `{` is not closed, or a comma is missing before this";
  if (message == "end of sequence flow not found")
    return "a `[` is not closed, or a comma is missing before this";
  if (message == "end of map not found" || message == "end of sequence not found")
    return "this does not fit the indentation of the lines above";
  if (message == "illegal map value") return "a `:` does not fit here; text with `: ` in it needs quotes";
  return message;
}

bool is_at_end(std::string_view text, const YAML::Exception& error) {
  return error.mark.pos > static_cast<int>(text.size());
}

std::string syntax_message(std::string_view text, const YAML::Exception& error) {
  if (is_at_end(text, error)) return "not YAML: a quote or a bracket is not closed";
  if (tab_indents(text, error.mark.line + 1))
    return "not YAML: a tab indents this line; YAML takes spaces only";
  return "not YAML: " + in_plain_words(error.msg);
}

bool leaves_bracket_open(std::string_view text, const YAML::Exception& error) {
  return error.msg == "end of map flow not found" || error.msg == "end of sequence flow not found" ||
         error.msg == "illegal flow end" || is_at_end(text, error);
}

// The parser finds on a later line that a colour without quotes took a bracket's end into its comment.
std::optional<BareColor> color_at_fault(std::string_view text, const YAML::Exception& error) {
  if (!leaves_bracket_open(text, error)) return std::nullopt;
  return open_bare_color(text.substr(0, static_cast<std::size_t>(error.mark.pos)));
}

void add_syntax_problem(std::string_view text, const std::shared_ptr<const std::string>& file,
                        const YAML::Exception& error, ProblemList& problems) {
  if (const auto color = color_at_fault(text, error))
    return problems.add({file, color->line, color->column},
                        fmt::format("not YAML: # without quotes starts a comment, so that the rest of this "
                                    "line is not read; a colour needs them: \"{}\"",
                                    color->text));
  problems.add({file, error.mark.line + 1, error.mark.column + 1}, syntax_message(text, error));
}

}  // namespace

static bool check_text(std::string_view text, const std::shared_ptr<const std::string>& file,
                       ProblemList& problems) {
  if (text.size() > largest_document) {
    problems.add({file}, fmt::format("{} bytes; a scene has at most {}", text.size(), largest_document));
    return false;
  }
  if (const auto fault = find_encoding_fault(text)) {
    problems.add({file, fault->line, fault->column}, fault->message);
    return false;
  }
  return true;
}

std::optional<Node> parse_yaml(std::string_view text, const std::shared_ptr<const std::string>& file,
                               DocumentBudget& budget, ProblemList& problems) {
  if (!check_text(text, file, problems)) return std::nullopt;
  TreeBuilder builder(file, budget, problems);
  try {
    std::istringstream stream{std::string(text).append(document_end)};
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(builder)) {
    }
    return builder.take_root();
  } catch (const Refusal& refusal) {
    problems.add(refusal.place, refusal.message);
  } catch (const YAML::Exception& error) {
    add_syntax_problem(text, file, error, problems);
  }
  return std::nullopt;
}

}  // namespace drape
