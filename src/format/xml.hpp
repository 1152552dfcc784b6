// Reads the tags of an XML file in order and checks that each is closed by its own name.
// Document types are not supported; entities are the five predefined ones and numbers.
#pragma once
#include <map>
#include <vector>

#include "format/source.hpp"

namespace fabricsh::format {

// With the entities of the characters that mean something in attributes.
std::string escaped(const std::string& text);

struct XmlTag {
  std::string name;
  std::map<std::string, std::string, std::less<>> attributes;
  bool opens = true;       // <name ...>; false: </name>
  bool empty = false;      // <name ... />
  std::size_t behind = 0;  // position after its >
};

class XmlTags {
 public:
  explicit XmlTags(Source& source) : source_(source) {}
  // The next tag; false at the end of the file. Error: invalid XML, or a tag that is not closed.
  bool next(XmlTag& tag);
  // Names of the open tags, the outermost first; an opening tag is itself the last one.
  const std::vector<std::string>& open() const { return open_; }

 private:
  bool find_tag();
  void read(XmlTag& tag, std::string_view text) const;
  void read_attribute(XmlTag& tag, std::string_view& text) const;
  void close(const std::string& name);

  Source& source_;
  std::vector<std::string> open_;
  bool pending_close_ = false;  // the last tag was empty, so its closing is still to be reported
};

}  // namespace fabricsh::format
