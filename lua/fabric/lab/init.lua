-- fabric.lab: virtual tests.
require "fabric.lab.uniaxial"
