#include "renderer/shader/branches.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <vector>

#include "renderer/core/error.h"

namespace glimt {
namespace {

[[noreturn]] void fail(std::string_view condition, const std::string& what) {
  throw Error(ErrorKind::failed, fmt::format("shader text '#if{}': {}", condition, what));
}

// By recursive descent: any = all || ..., all = single && ..., single = !single | (any) | NAME.
class Condition {
 public:
  Condition(std::string_view text, const std::map<std::string, bool>& values)
      : text_(text), values_(values) {}

  bool value() {
    const bool result = any();
    skipBlanks();
    if (at_ != text_.size()) fail(text_, "it goes on where it should end");
    return result;
  }

 private:
  // Both sides are read, whatever the first is.
  bool any() {
    bool result = all();
    while (take("||")) result = all() || result;
    return result;
  }

  bool all() {
    bool result = single();
    while (take("&&")) result = single() && result;
    return result;
  }

  bool single() {
    if (take("!")) return !single();
    if (!take("(")) return named();
    const bool result = any();
    if (!take(")")) fail(text_, "a parenthesis is not closed");
    return result;
  }

  bool named() {
    skipBlanks();
    const std::size_t start = at_;
    const auto isPart = [](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
    };
    while (at_ < text_.size() && isPart(text_[at_])) ++at_;
    const std::string name(text_.substr(start, at_ - start));
    const auto found = values_.find(name);
    if (found == values_.end()) fail(text_, "there is no '" + name + "'");
    return found->second;
  }

  bool take(std::string_view token) {
    skipBlanks();
    if (!text_.substr(at_).starts_with(token)) return false;
    at_ += token.size();
    return true;
  }

  void skipBlanks() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }

  std::string_view text_;
  const std::map<std::string, bool>& values_;
  std::size_t at_ = 0;
};

// One `#if` that has not ended.
struct Branches {
  bool ours = true;    // false: `#ifdef` and the like, which stay
  bool outer = true;   // whether what is around it is taken
  bool taken = false;  // one of its branches
  bool now = false;    // the branch that is being read
};

bool startsWith(std::string_view line, std::string_view directive) {
  return line.starts_with(directive) &&
         (line.size() == directive.size() || line[directive.size()] == ' ');
}

class Reader {
 public:
  explicit Reader(const std::map<std::string, bool>& values) : values_(values) {}

  void read(std::string_view line) {
    if (startsWith(line, "#if")) {
      const bool outer = taking();
      const bool now = outer && conditionOf(line.substr(3));
      open_.push_back({true, outer, now, now});
    } else if (line.starts_with("#if")) {
      open_.push_back({false, taking(), true, taking()});
      keep(line);
    } else if (!open_.empty() && open_.back().ours && startsWith(line, "#elif")) {
      Branches& branches = open_.back();
      branches.now = branches.outer && !branches.taken && conditionOf(line.substr(5));
      branches.taken = branches.taken || branches.now;
    } else if (!open_.empty() && open_.back().ours && startsWith(line, "#else")) {
      open_.back().now = open_.back().outer && !open_.back().taken;
    } else if (!open_.empty() && startsWith(line, "#endif")) {
      if (!open_.back().ours) keep(line);
      open_.pop_back();
    } else {
      keep(line);
    }
  }

  std::string text() const {
    if (!open_.empty()) throw Error(ErrorKind::failed, "shader text: an #if does not end");
    return text_;
  }

 private:
  bool taking() const { return open_.empty() || open_.back().now; }
  bool conditionOf(std::string_view text) const { return Condition(text, values_).value(); }
  void keep(std::string_view line) {
    if (taking()) text_.append(line).push_back('\n');
  }

  const std::map<std::string, bool>& values_;
  std::vector<Branches> open_;
  std::string text_;
};

}  // namespace

std::string takeBranches(std::string_view text, const std::map<std::string, bool>& values) {
  Reader reader(values);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    reader.read(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return reader.text();
}

}  // namespace glimt
