# Who answers for this program and where it lives. The owner fills these in; the packages, the citation and
# the Python module take them from here, a release (scripts/release) writes the repository into README's clone line and CITATION.cff.
set(FABRICSH_MAINTAINER "the fabricsh authors <fabricsh@localhost>")  # Name <address>
set(FABRICSH_HOMEPAGE "")                                             # https://...; empty: none is stated
set(FABRICSH_REPOSITORY "")                                           # where the sources are; empty: likewise
