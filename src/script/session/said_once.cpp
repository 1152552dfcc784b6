#include "script/session/said_once.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>
#include <string>

#include "base/hash.hpp"

namespace fabricsh::script {

namespace {

// Hashes of the texts that were shown, in memory shared by a process and its copies: initially zeros, only
// ever filled. Without that memory, or if it is full, a text counts as not shown yet.
class Said {
 public:
  Said() {
    void* pages = mmap(nullptr, sizeof(Slots), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (pages != MAP_FAILED) slots_ = static_cast<Slots*>(pages);
  }
  ~Said() {
    if (slots_ != nullptr) munmap(slots_, sizeof(Slots));
  }
  Said(const Said&) = delete;
  Said& operator=(const Said&) = delete;

  bool holds(const std::string& text) const { return find(text, false); }
  // Adds the text; true if it was present already.
  bool held(const std::string& text) { return find(text, true); }

 private:
  static constexpr std::size_t kSlots = 4096;
  using Slots = std::array<std::atomic<std::uint64_t>, kSlots>;

  bool find(const std::string& text, bool add) const {
    const std::uint64_t wanted = std::max<std::uint64_t>(hash(text), 1);
    for (std::size_t i = 0; slots_ != nullptr && i < kSlots; ++i) {
      auto& slot = (*slots_)[(wanted + i) % kSlots];
      std::uint64_t there = slot.load();
      if (there == 0 && (!add || slot.compare_exchange_strong(there, wanted))) return false;
      if (there == wanted) return true;
    }
    return false;
  }

  Slots* slots_ = nullptr;
};

}  // namespace

Notices::Sink said_once_by_copies(Notices::Sink sink) {
  if (!sink) return sink;
  return
      [sink = std::move(sink), said = std::make_shared<Said>(), process = getpid()](const std::string& text) {
        const bool warning = text.starts_with("warning: ");
        const bool known = warning && (getpid() == process ? said->holds(text) : said->held(text));
        if (!known) sink(text);
      };
}

}  // namespace fabricsh::script
