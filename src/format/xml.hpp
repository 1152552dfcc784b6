// The tags of an XML file, one after the other, each closed by its own name. No document types, no entities
// but the five of the standard and numbers.
#pragma once
#include <map>
#include <vector>

#include "format/source.hpp"

namespace fabricsh::format {

struct XmlTag {
  std::string name;
  std::map<std::string, std::string, std::less<>> attributes;
  bool opens = true;       // <name ...>; false: </name>
  bool empty = false;      // <name ... />
  std::size_t behind = 0;  // place behind its >
};

class XmlTags {
 public:
  explicit XmlTags(Source& source) : source_(source) {}
  // The next tag; false at the end of the file. Error: what is not XML, a tag not closed.
  bool next(XmlTag& tag);
  // Names of the tags that are open, the outermost first; a tag that opens is its own last.
  const std::vector<std::string>& open() const { return open_; }

 private:
  bool find_tag();
  void read(XmlTag& tag, std::string_view text) const;
  void read_attribute(XmlTag& tag, std::string_view& text) const;
  void close(const std::string& name);

  Source& source_;
  std::vector<std::string> open_;
  bool pending_close_ = false;  // the last tag was empty
};

}  // namespace fabricsh::format
