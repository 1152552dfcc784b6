#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vtkLogger.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cstdlib>

#include "base/error.hpp"
#include "render/draw.hpp"
#include "system/child.hpp"

namespace fabricsh::render {

namespace {

constexpr int kPatience = 30'000;  // ms to wait for the server to start

// The display number that the server writes to the pipe, or empty.
std::string answer(int pipe) {
  std::string text;
  pollfd wait{pipe, POLLIN, 0};
  char c = 0;
  while (poll(&wait, 1, kPatience) > 0 && read(pipe, &c, 1) == 1 && c != '\n') text += c;
  return text;
}

// Starts Xvfb, which chooses a free number and writes it to the pipe; it ends with this program. 0: Xvfb is
// not installed.
pid_t start(int pipe) {
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  pid_t child = 0;
  const int reason = system::spawn_bound(
      {{"Xvfb", "-displayfd", std::to_string(pipe), "-screen", "0", "1280x1024x24", "-nolisten", "tcp"},
       -1,
       nowhere,
       nowhere,
       false,
       SIGTERM},
      child);
  close(nowhere);
  return reason == 0 ? child : 0;
}

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

Display::Display() {
  int ends[2];
  if (pipe(ends) != 0) throw Error("render: no pipe to Xvfb");
  fcntl(ends[0], F_SETFD, FD_CLOEXEC);
  server_ = start(ends[1]);
  close(ends[1]);
  const std::string number = server_ > 0 ? answer(ends[0]) : "";
  close(ends[0]);
  if (!number.empty()) {
    setenv("DISPLAY", (":" + number).c_str(), 1);
    return;
  }
  if (server_ > 0) throw Error("render: the virtual display Xvfb is installed and does not come up");
  const char* given = std::getenv("DISPLAY");
  if (given == nullptr || *given == '\0')
    throw Error("render: no display to draw on: install Xvfb (apt-get install xvfb), or set DISPLAY");
}

Display::~Display() {
  if (server_ <= 0) return;
  kill(server_, SIGTERM);
  waitpid(server_, nullptr, 0);
}

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
