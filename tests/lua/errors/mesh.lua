-- Wrong calls and their messages: mesh. Read by tests/lua/errors.lua.
-- fabric.mesh.annulus
wrong("fabric.mesh.annulus", "fabric.mesh.annulus{ innre=0.01 }",
  "deck.lua:1: annulus: unknown field 'innre', did you mean 'inner'?")
wrong("fabric.mesh.annulus", "fabric.mesh.annulus{ inner=inner_ }",
  "deck.lua:1: annulus: field 'inner': expected a positive number in m, got nil (missing, or a misspelt variable)")
wrong("fabric.mesh.annulus", "fabric.mesh.annulus{ inner='1' }",
  "deck.lua:1: annulus: field 'inner': expected a positive number in m, got '1'")
wrong("fabric.mesh.annulus", "fabric.mesh.annulus{ inner=-1 }",
  "deck.lua:1: annulus: field 'inner': expected a positive number in m, got -1")
wrong("fabric.mesh.annulus", "fabric.mesh.annulus{ inner=0.01, outer=0.01, around=2.5 }",
  "deck.lua:1: annulus: field 'around': expected an integer of at least 1, got 2.5")
wrong("fabric.mesh.annulus", "fabric.mesh.annulus{ inner=0.01, outer=0.01, around=2, across=2, slit='yes' }",
  "deck.lua:1: annulus: field 'slit': expected true or false, got 'yes'")

-- fabric.mesh.cylinder
wrong("fabric.mesh.cylinder", "fabric.mesh.cylinder{ radisu=0.01 }",
  "deck.lua:1: cylinder: unknown field 'radisu', did you mean 'radius'?")
wrong("fabric.mesh.cylinder", "fabric.mesh.cylinder{ radius=radius_ }",
  "deck.lua:1: cylinder: field 'radius': expected a positive number in m, got nil (missing, or a misspelt variable)")
wrong("fabric.mesh.cylinder", "fabric.mesh.cylinder{ radius='1' }",
  "deck.lua:1: cylinder: field 'radius': expected a positive number in m, got '1'")
wrong("fabric.mesh.cylinder", "fabric.mesh.cylinder{ radius=-1 }",
  "deck.lua:1: cylinder: field 'radius': expected a positive number in m, got -1")
wrong("fabric.mesh.cylinder", "fabric.mesh.cylinder{ radius=0.01, length=0.01, around=2.5 }",
  "deck.lua:1: cylinder: field 'around': expected an integer of at least 1, got 2.5")

-- fabric.mesh.disk
wrong("fabric.mesh.disk", "fabric.mesh.disk{ radisu=0.01 }",
  "deck.lua:1: disk: unknown field 'radisu', did you mean 'radius'?")
wrong("fabric.mesh.disk", "fabric.mesh.disk{ radius=radius_ }",
  "deck.lua:1: disk: field 'radius': expected a positive number in m, got nil (missing, or a misspelt variable)")
wrong("fabric.mesh.disk", "fabric.mesh.disk{ radius='1' }",
  "deck.lua:1: disk: field 'radius': expected a positive number in m, got '1'")
wrong("fabric.mesh.disk", "fabric.mesh.disk{ radius=-1 }",
  "deck.lua:1: disk: field 'radius': expected a positive number in m, got -1")
wrong("fabric.mesh.disk", "fabric.mesh.disk{ radius=0.01, cells=2.5 }",
  "deck.lua:1: disk: field 'cells': expected an integer of at least 1, got 2.5")

-- fabric.mesh.hemisphere
wrong("fabric.mesh.hemisphere", "fabric.mesh.hemisphere{ radisu=0.01 }",
  "deck.lua:1: hemisphere: unknown field 'radisu', did you mean 'radius'?")
wrong("fabric.mesh.hemisphere", "fabric.mesh.hemisphere{ radius=radius_ }",
  "deck.lua:1: hemisphere: field 'radius': expected a positive number in m, got nil (missing, or a misspelt variable)")
wrong("fabric.mesh.hemisphere", "fabric.mesh.hemisphere{ radius='1' }",
  "deck.lua:1: hemisphere: field 'radius': expected a positive number in m, got '1'")
wrong("fabric.mesh.hemisphere", "fabric.mesh.hemisphere{ radius=-1 }",
  "deck.lua:1: hemisphere: field 'radius': expected a positive number in m, got -1")
wrong("fabric.mesh.hemisphere", "fabric.mesh.hemisphere{ radius=0.01, around=2.5 }",
  "deck.lua:1: hemisphere: field 'around': expected an integer of at least 1, got 2.5")

-- fabric.mesh.read
wrong("fabric.mesh.read", "fabric.mesh.read()",
  "deck.lua:1: read: argument 'file': expected a string, got nil (missing, or a misspelt variable)")
wrong("fabric.mesh.read", "fabric.mesh.read(7)",
  "deck.lua:1: read: argument 'file': expected a string, got 7")
wrong("fabric.mesh.read", "fabric.mesh.read('disc.msh', 3)",
  "deck.lua:1: read: argument 'join': expected true or false, got 3")

-- fabric.mesh.rectangle
wrong("fabric.mesh.rectangle", "fabric.mesh.rectangle{ widht=0.01 }",
  "deck.lua:1: rectangle: unknown field 'widht', did you mean 'width'?")
wrong("fabric.mesh.rectangle", "fabric.mesh.rectangle{ width=width_ }",
  "deck.lua:1: rectangle: field 'width': expected a positive number in m, got nil (missing, or a misspelt variable)")
wrong("fabric.mesh.rectangle", "fabric.mesh.rectangle{ width='1' }",
  "deck.lua:1: rectangle: field 'width': expected a positive number in m, got '1'")
wrong("fabric.mesh.rectangle", "fabric.mesh.rectangle{ width=-1 }",
  "deck.lua:1: rectangle: field 'width': expected a positive number in m, got -1")
wrong("fabric.mesh.rectangle", "fabric.mesh.rectangle{ width=0.01, height=0.01, nx=2.5 }",
  "deck.lua:1: rectangle: field 'nx': expected an integer of at least 1, got 2.5")
wrong("fabric.mesh.rectangle", "fabric.mesh.rectangle{ width=0.01, height=0.01, nx=2, ny=2, origin={1, 'two'} }",
  "deck.lua:1: rectangle: field 'origin': expected a table of numbers in m, got 'two' at place 2")
wrong("fabric.mesh.rectangle", "fabric.mesh.rectangle{ width=0.01, height=0.01, nx=2, ny=2, triangles='yes' }",
  "deck.lua:1: rectangle: field 'triangles': expected true or false, got 'yes'")
wrong("fabric.mesh.rectangle", "fabric.mesh.rectangle{ width=0.01, height=0.01, nx=2, ny=2, grading=7 }",
  "deck.lua:1: rectangle: field 'grading': expected a table {x, y}, got 7")

-- mesh:hole
wrong("mesh:hole", "mesh:hole()",
  "deck.lua:1: hole: argument 'inside': expected a function, got nil (missing, or a misspelt variable)")
wrong("mesh:hole", "mesh:hole(7)",
  "deck.lua:1: hole: argument 'inside': expected a function, got 7")
wrong("mesh:hole", "mesh:hole(function() return true end)",
  "deck.lua:1: hole: every element has its middle inside")
wrong("mesh:hole", "mesh:hole(function() return false end)",
  "deck.lua:1: hole: no element has its middle inside")
wrong("mesh:hole", "mesh:hole(function() return false end, 7)",
  "deck.lua:1: hole: argument 'rim': expected a string, got 7")

-- mesh:slit
wrong("mesh:slit", "mesh:slit{ form={0, 0} }",
  "deck.lua:1: slit: unknown field 'form', did you mean 'from'?")
wrong("mesh:slit", "mesh:slit{ from={0, 0} }",
  "deck.lua:1: slit: field 'to': expected a table of numbers in m, got nil (missing, or a misspelt variable)")
wrong("mesh:slit", "mesh:slit{ from={0, 'x'}, to={0, 1} }",
  "deck.lua:1: slit: field 'from': expected a table of numbers in m, got 'x' at place 2")
wrong("mesh:slit", "mesh:slit{ from={0, 0}, to={0, 1}, left=7 }",
  "deck.lua:1: slit: field 'left': expected a string, got 7")


-- mesh:elements
wrong("mesh:elements", "mesh:elements()",
  "deck.lua:1: elements: argument 'set': expected a string, got nil (missing, or a misspelt variable)")
wrong("mesh:elements", "mesh:elements(7)",
  "deck.lua:1: elements: argument 'set': expected a string, got 7")

-- mesh:map
wrong("mesh:map", "mesh:map()",
  "deck.lua:1: map: argument 'f': expected a function, got nil (missing, or a misspelt variable)")
wrong("mesh:map", "mesh:map('f')",
  "deck.lua:1: map: argument 'f': expected a function, got 'f'")

-- mesh:check
wrong("mesh:check", "mesh:check(7)",
  "deck.lua:1: check: argument 'card': expected a card, got 7")
wrong("mesh:check", "mesh:check(mesh)",
  "deck.lua:1: check: argument 'card': expected a card, got a mesh")
wrong("mesh:check", "mesh:check(card, 'x')",
  "deck.lua:1: check: argument 'warp': expected a number in degrees or a table of numbers in degrees, got 'x'")
wrong("mesh:check", "mesh:check(card, {1, 2})",
  "deck.lua:1: check: field 'warp': expected {x, y, z}, got 2 numbers")
wrong("mesh:check", "mesh:check(card, 0, 'soft')",
  "deck.lua:1: check: argument 'flesh': expected a positive number in Pa/m, got 'soft'")
wrong("mesh:check", "mesh:check(card, 0, 0)",
  "deck.lua:1: check: argument 'flesh': expected a positive number in Pa/m, got 0")

-- mesh:orient
wrong("mesh:orient", "mesh:orient({1, 'two'})",
  "deck.lua:1: orient: argument 'direction': expected a table of numbers, got 'two' at place 2")

-- mesh:set
wrong("mesh:set", "mesh:set()",
  "deck.lua:1: set: argument 'name': expected a string, got nil (missing, or a misspelt variable)")
wrong("mesh:set", "mesh:set(7)",
  "deck.lua:1: set: argument 'name': expected a string, got 7")
wrong("mesh:set", "mesh:set('x', {1, 'two'})",
  "deck.lua:1: set: argument 'nodes': expected a table of numbers or a function, got 'two' at place 2")

-- mesh:write
wrong("mesh:write", "mesh:write()",
  "deck.lua:1: write: argument 'file': expected a string, got nil (missing, or a misspelt variable)")
wrong("mesh:write", "mesh:write(7)",
  "deck.lua:1: write: argument 'file': expected a string, got 7")

-- numbers that mean nothing
wrong("fabric.mesh.rectangle", "fabric.mesh.rectangle{ width=0/0, height=1, nx=3, ny=9 }",
  "deck.lua:1: rectangle: field 'width': expected a positive number in m, got nan")
wrong("fabric.mesh.rectangle", "fabric.mesh.rectangle{ width=1/0, height=1, nx=3, ny=9 }",
  "deck.lua:1: rectangle: field 'width': expected a positive number in m, got inf")
wrong("fabric.mesh.rectangle", "fabric.mesh.rectangle{ width=1, height=1, nx=1e9, ny=1e9 }",
  "deck.lua:1: rectangle: nx * ny: expected at most 1000000000 cells, got 1000000000 x 1000000000")
wrong("fabric.mesh.rectangle", "fabric.mesh.rectangle{ width=1, height=hieght, nx=3, ny=9 }",
  "deck.lua:1: rectangle: field 'height': expected a positive number in m, got nil (missing, or a misspelt variable)")
wrong("fabric.mesh.rectangle", "fabric.mesh.rectangle{ width=1, height=1, nx=3, ny=9, origin={1} }",
  "deck.lua:1: rectangle: field 'origin': expected {x, y} or {x, y, z}, got 1 number")
wrong("fabric.mesh.annulus", "fabric.mesh.annulus{ inner=0.1, outer=0.06, around=30, across=6 }",
  "deck.lua:1: annulus: field 'outer': expected a radius larger than 'inner'")

-- the shape of a call
wrong("fabric.mesh.rectangle", "fabric.mesh.rectangle(1, 1, 3, 9)",
  "deck.lua:1: rectangle: expected one table with named fields, got 4 values")
wrong("fabric.mesh.rectangle", "fabric.mesh.rectangle()",
  "deck.lua:1: rectangle: expected a table with named fields, got nil")
wrong("fabric.mesh.rectangle", "fabric.mesh.rectangle{ 1, 1 }",
  "deck.lua:1: rectangle: expected named fields, got an entry without a name at 1")
wrong("object", "fabric.mesh.rectangel{}",
  "deck.lua:1: fabric.mesh: unknown field 'rectangel', did you mean 'rectangle'?")
wrong("mesh:set", "mesh.set('x')",
  "deck.lua:1: set: called without its mesh (write x:set(...), with a colon), got 'x'")
wrong("mesh:set", "mesh:set('x', {1}, 2)",
  "deck.lua:1: set: expected at most 2 arguments, got 3")
wrong("object", "mesh.nods = 3",
  "deck.lua:1: mesh: field 'nods' cannot be assigned")
wrong("object", "return mesh.nods",
  "deck.lua:1: mesh: unknown field 'nods', did you mean 'nodes'?")

-- sets and files
wrong("mesh:set", "mesh:set 'lft'",
  "deck.lua:1: set: unknown set 'lft', did you mean 'left'? known sets: all, bottom, boundary, corners, left, right, top")
wrong("mesh:set", "mesh:set('s', {0})",
  "deck.lua:1: set: argument 'nodes': expected node numbers from 1 to 8, got 0")
wrong("mesh:set", "mesh:set('s', function() error 'inside' end)",
  "deck.lua:1: inside")
wrong("mesh:elements", "mesh:elements 'topp'",
  "deck.lua:1: elements: unknown set 'topp', did you mean 'top'? known sets: all, bottom, boundary, corners, left, right, top")
wrong("mesh:map", "mesh:map(function(x, y) return x, y end)",
  "deck.lua:1: map: argument 'f': expected the function to return x, y, z in m, got nil in place 3")
wrong("mesh:orient", "mesh:orient{0, 0, 0}",
  "deck.lua:1: orient: argument 'direction': expected a direction, got {0, 0, 0}")
wrong("mesh:orient", "mesh:orient{1, 0}",
  "deck.lua:1: orient: argument 'direction': expected {x, y, z}, got 2 numbers")
wrong("fabric.mesh.read", "fabric.mesh.read 'none.msh'",
  "deck.lua:1: read: cannot read 'none.msh': No such file or directory")
wrong("fabric.mesh.read", "fabric.mesh.read 'none.igs'",
  "deck.lua:1: read: cannot read 'none.igs': expected a name that ends in .msh, .vtu, .vtk, .obj, .stl, .ply, .inp, .k, .key or .rad")
wrong("mesh:write", "mesh:write 'mesh.step'",
  "deck.lua:1: write: cannot write 'mesh.step': expected a name that ends in .msh, .vtu, .obj, .stl, .ply, .inp, .k or .rad")

-- fabric.mesh.of, fabric.mesh.merge
wrong("fabric.mesh.of", "fabric.mesh.of{ nodse={} }",
  "deck.lua:1: of: unknown field 'nodse', did you mean 'nodes'?")
wrong("fabric.mesh.of", "fabric.mesh{ nodes=3 }",
  "deck.lua:1: of: field 'nodes': expected a table { {x, y, z}, ... }, got 3")
wrong("fabric.mesh.of", "fabric.mesh{ nodes={ {0, 0}, {1} }, elements={ {1, 2, 3} } }",
  "deck.lua:1: of: field 'nodes': expected 2 or 3 numbers at place 2, got 1")
wrong("fabric.mesh.of", "fabric.mesh{ nodes={ {0, 0}, {1, 0}, {0, 1} }, elements={ {1, 2, 'a'} } }",
  "deck.lua:1: of: field 'elements': expected numbers at place 1, got 'a'")
wrong("fabric.mesh.of", "fabric.mesh{ nodes={ {0, 0}, {1, 0}, {0, 1} }, elements={ {1, 2, 4} } }",
  "deck.lua:1: of: element 1: expected node numbers from 1 to 3, got 4")
wrong("fabric.mesh.merge", "fabric.mesh.merge{ meshes=fabric.mesh.disk{ radius=0.1, cells=2 } }",
  "deck.lua:1: merge: field 'meshes': expected a table { a, b, ... }, got a mesh")
wrong("fabric.mesh.of", "fabric.mesh{ nodes={ {0, 0}, {1, 0}, {0, 1} }, elements={ {1, 2, 3} }, join='yes' }",
  "deck.lua:1: of: field 'join': expected true or false, got 'yes'")
wrong("fabric.mesh.of", "fabric.mesh{ nodes={ {0, 0}, {1, 0}, {0, 1} } }",
  "deck.lua:1: of: field 'elements': expected a table { {1, 2, 5, 4}, ... }, got nil (missing, or a misspelt variable)")
wrong("fabric.mesh.merge", "fabric.mesh.merge{}",
  "deck.lua:1: merge: field 'meshes': expected a table { a, b, ... }, got nil (missing, or a misspelt variable)")
wrong("fabric.mesh.merge", "fabric.mesh.merge{ mehses={} }",
  "deck.lua:1: merge: unknown field 'mehses', did you mean 'meshes'?")
wrong("fabric.mesh.merge", "fabric.mesh.merge{ meshes={ 1, 2 } }",
  "deck.lua:1: merge: field 'meshes': expected a mesh at place 1, got 1")
wrong("fabric.mesh.merge", "fabric.mesh.merge{ meshes={}, distance=-1 }",
  "deck.lua:1: merge: field 'distance': expected a number of at least 0 in m, got -1")

-- fabric.mesh.panel
local square = "outline={ {0, 0}, {0.1, 0, name='a'}, {0.1, 0.1}, {0, 0.1} }"
local function panel(rest, message) wrong("fabric.mesh.panel", "fabric.mesh.panel{ " .. rest .. " }", "deck.lua:1: panel: " .. message) end
panel("otline={}", "unknown field 'otline', did you mean 'outline'?")
panel(square, "field 'size': expected a positive number in m, got nil (missing, or a misspelt variable)")
panel("size=0.01", "field 'outline': expected either an outline or file=, got neither")
panel("size='1'", "field 'size': expected a positive number in m, got '1'")
panel("size=-1", "field 'size': expected a positive number in m, got -1")
panel("size=0.01, outline=5", "field 'outline': expected a table { {x, y}, {x, y, name=}, {arc=, name=}, {spline=, name=}, ... }, got 5")
panel("size=0.01, triangles='yes', " .. square, "field 'triangles': expected true or false, got 'yes'")
panel("size=0.01, file=7", "field 'file': expected a string, got 7")
panel("size=0.01, file='a.pdf'", "field 'file': expected a file that ends in .dxf or .svg, got 'a.pdf'")
panel("size=0.01, file='a.dxf', " .. square, "field 'outline': expected either file= or an outline, got both")
panel("size=0.01, unit=0.001, " .. square, "field 'unit': expected with file= only")
panel("size=0.2, " .. square, "field 'size': expected at most the smaller extent of the panel, 0.1 m, got 0.2")
panel("size=0.02, outline={ {0, 0}, {0.1, 0.1}, {0.1, 0}, {0, 0.15} }", "field 'outline': piece 1 crosses or touches piece 3 near (0.06, 0.06)")
panel("size=0.02, outline={ {0, 0}, {0.1, 0}, {0.1, 0.1}, {0, 0.002} }",
  "field 'outline': open: it ends at (0, 0.002), 0.002 m from its start (0, 0) (end it there, or close it with {name='...'})")
panel("size=0.02, outline={ {0, 0}, {0.1, 0, nmae='a'} }", "unknown field 'outline[2].nmae', did you mean 'outline[2].name'?")
panel("size=0.02, outline={ {0, 0}, {0.1, 0, 0} }", "field 'outline[2]': expected a point {x, y}, m, got 3 numbers")
panel("size=0.02, outline={ {0, 0}, 7 }",
  "field 'outline[2]': expected {x, y}, {arc=}, {spline=}, {bezier=}, {circle=} or {name=}, got 7")
panel("size=0.02, outline={ {0, 0}, {arc={to={0.1, 0}}} }", "field 'outline[2].arc': expected either through={x, y} or centre={x, y}")
panel("size=0.02, outline={ {0, 0}, {arc={to={0.1, 0}, through={0.05, 0}}} }",
  "field 'outline[2]': arc: expected three points that do not lie on a line")
panel("size=0.02, holes={ {circle={0.2, 0.2}, radius=0.01} }, " .. square,
  "field 'holes': hole 1 lies outside of the outline, at (0.21, 0.2)")
panel("size=0.02, darts={ {from={0.02, 0}, tip={0.03, 0.2}, to={0.04, 0}} }, " .. square,
  "field 'darts': dart 'dart1': its tip (0.03, 0.2) is not inside the outline")
panel("size=0.02, notches={ {name='n', edge='a', at=0.2} }, " .. square,
  "field 'notches': notch 'n': expected a place from 0 to 0.1 m along edge 'a', got 0.2")
panel("size=0.02, notches={ {name='n', edge='b', at=0.2} }, " .. square, "field 'notches': notch 'n': no edge has the name 'b'")

-- mesh:wrap
local function wrap(rest, message) wrong("mesh:wrap", "mesh:wrap{ " .. rest .. " }", "deck.lua:1: wrap: " .. message) end
wrap("cilinder={}", "unknown field 'cilinder', did you mean 'cylinder'?")
wrap("", "field 'cylinder': expected either a cylinder or a cone")
wrap("cylinder=5", "field 'cylinder': expected a table {radius, from, axis, towards, at}, got 5")
wrap("cylinder={ radius=-1 }", "field 'cylinder.radius': expected a positive number in m, got -1")
wrap("cylinder={}", "field 'cylinder.radius': expected a positive number in m, got nil (missing, or a misspelt variable)")
wrap("cone={ radius=1, angle=90 }", "field 'cone.angle': expected a number above -90 to below 90 in degrees, got 90")
wrap("cylinder={ radius=1 }, overlap='yes'", "field 'overlap': expected true or false, got 'yes'")
wrap("cylinder={ radius=1, at={1, 'x'} }", "field 'cylinder.at': expected a table of numbers in m, got 'x' at place 2")
wrap("cylinder={ radius=1, at={1} }", "field 'cylinder.at': expected {x, y}, got 1 number")
wrap("cylinder={ radius=1, axis={0, 0, 0} }", "field 'axis': expected a direction, got one without length")
wrap("cylinder={ radius=0.004 }", "element 1 spans 364 degrees: expected at most 60 (smaller elements, or a larger radius)")
