-- fabric.lab: virtual tests.
require "fabric.lab.mesh_error"
require "fabric.lab.uniaxial"
require "fabric.lab.bias"
require "fabric.lab.shear"
require "fabric.lab.biaxial"
