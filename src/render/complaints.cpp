#include "render/complaints.hpp"

#include <vtkLogger.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <algorithm>

namespace fabricsh::render {

namespace {

class MessageCollector : public vtkOutputWindow {
 public:
  static MessageCollector* New() {
    auto* made = new MessageCollector;
    made->InitializeObjectBase();
    return made;
  }
  MessageCollector(const MessageCollector&) = delete;
  MessageCollector& operator=(const MessageCollector&) = delete;
  void DisplayText(const char* text) override {
    if (said.empty() && text != nullptr) said = text;
  }
  std::string said;

 protected:
  MessageCollector() = default;
};

// "ERROR: In file.cxx, line 1\nvtkReader (0x1): the words\n\n" -> "the words"
std::string plain(const std::string& text) {
  const std::size_t address = text.find("(0x"),
                    start = address == std::string::npos ? address : text.find("): ", address);
  std::string words = start == std::string::npos ? text : text.substr(start + 3);
  words.erase(std::min(words.find('\n'), words.size()));
  return words;
}

}  // namespace

void collect_complaints() {
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkOutputWindow::SetInstance(vtkSmartPointer<MessageCollector>::New());
}

std::string take_complaint() {
  auto* collector = dynamic_cast<MessageCollector*>(vtkOutputWindow::GetInstance());
  if (collector == nullptr) return {};
  const std::string words = plain(collector->said);
  collector->said.clear();
  return words;
}

}  // namespace fabricsh::render
