// A formula in plain text: numbers, names, + - * / ^, sqrt, ln, tan, min(a, b), brackets.
#pragma once

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <stdexcept>
#include <string>

namespace contactlaws::test {

class Formula {
 public:
  /// `read` gains the names that the formula reads.
  Formula(const std::string& text, const std::map<std::string, double>& known, std::set<std::string>& read)
      : text_(text), known_(known), read_(read) {}

  /// @throws std::invalid_argument where it is not a formula, or reads a name that is not known
  double value() {
    const double result = sum();
    if (peek() != '\0') fail("unexpected");
    return result;
  }

 private:
  double sum() {
    double result = peek() == '-' ? (take(), -product()) : product();
    for (char c = peek(); c == '+' || c == '-'; c = peek()) {
      take();
      result += c == '+' ? product() : -product();
    }
    return result;
  }
  double product() {
    double result = power();
    for (char c = peek(); c == '*' || c == '/'; c = peek()) {
      take();
      const double other = power();
      result = c == '*' ? result * other : result / other;
    }
    return result;
  }
  double power() {
    const double base = operand();
    if (peek() != '^') return base;
    take();
    return std::pow(base, operand());
  }
  double operand() {
    const char c = peek();
    if (c == '(') return in_brackets();
    if (std::isdigit(static_cast<unsigned char>(c)) != 0) {
      char* end = nullptr;
      const double number = std::strtod(text_.c_str() + at_, &end);
      at_ = static_cast<std::size_t>(end - text_.c_str());
      return number;
    }
    std::string name;
    while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '_'))
      name += text_[at_++];
    if (name == "sqrt") return std::sqrt(in_brackets());
    if (name == "ln") return std::log(in_brackets());
    if (name == "tan") return std::tan(in_brackets());
    if (name == "min") {
      expect('(');
      const double first = sum();
      expect(',');
      const double second = sum();
      expect(')');
      return std::min(first, second);
    }
    const auto found = known_.find(name);
    if (found == known_.end()) fail("no value for '" + name + "'");
    read_.insert(name);
    return found->second;
  }
  double in_brackets() {
    expect('(');
    const double result = sum();
    expect(')');
    return result;
  }

  char peek() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  void take() { ++at_; }
  void expect(char c) {
    if (peek() != c) fail(std::string("expected ") + c);
    take();
  }
  [[noreturn]] void fail(const std::string& why) const {
    throw std::invalid_argument(why + " in the formula '" + text_ + "', character " + std::to_string(at_));
  }

  const std::string text_;
  const std::map<std::string, double>& known_;
  std::set<std::string>& read_;
  std::size_t at_ = 0;
};

}  // namespace contactlaws::test
