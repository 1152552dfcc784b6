-- Wrong calls and their messages: stress-free shapes, prestress, creases. Read by tests/lua/errors.lua.
-- fabric.model
wrong("fabric.model", "fabric.model{ mesh=mesh, card=card, reference=card }",
  "deck.lua:1: model: field 'reference': expected a mesh, got a card")
wrong("fabric.model", "fabric.model{ mesh=mesh, card=card, reference=fabric.mesh.rectangle{ width=0.0254, height=0.0762, nx=1, ny=4 } }",
  "deck.lua:1: model: field 'reference': expected the elements of the mesh, 3 on 8 nodes, in another shape; got 4 on 10")
wrong("fabric.model", "fabric.model{ mesh=mesh, card=card, reference=fabric.mesh{ nodes={ {0,0}, {1,0}, {0,1}, {1,1}, {0,2}, {1,2}, {0,3}, {1,3} }, elements={ {1, 2, 4, 3}, {4, 6, 5, 3}, {5, 6, 8, 7} } } }",
  "deck.lua:1: model: field 'reference': expected the elements of the mesh, 3 on 8 nodes, in another shape; got element 2 on other nodes")
wrong("fabric.model", "fabric.model{ mesh=mesh, card=card, rest='curved' }",
  "deck.lua:1: model: field 'rest': expected 'own' or 'flat' or 'as placed', got 'curved'")
wrong("fabric.model", "fabric.model{ mesh=mesh, card=card, prestress=100 }",
  "deck.lua:1: model: field 'prestress': expected a table {warp, weft}, got 100")
wrong("fabric.model", "fabric.model{ mesh=mesh, card=card, prestress={ warp=-100 } }",
  "deck.lua:1: model: field 'prestress.warp': expected a number of at least 0 in N/m, got -100")
wrong("fabric.model", "fabric.model{ mesh=mesh, card=card, prestress={ weft='100' } }",
  "deck.lua:1: model: field 'prestress.weft': expected a number of at least 0 in N/m, got '100'")
wrong("fabric.model", "fabric.model{ mesh=mesh, card=card, prestress={ wrap=100 } }",
  "deck.lua:1: model: unknown field 'prestress.wrap', did you mean 'prestress.warp'?")
wrong("fabric.model", "fabric.model{ mesh=mesh, card=card, prestress={} }",
  "deck.lua:1: model: field 'prestress': expected a tension along warp or weft, got none")
wrong("fabric.model", "fabric.model{ mesh=mesh, layers={ { card=card }, { card=card } }, prestress={ warp=100 } }",
  "deck.lua:1: model: field 'prestress': expected a card without layers, which share a tension")
wrong("fabric.model", "fabric.model{ bodies={ { name='a', mesh=mesh, card=card } }, prestress={ warp=100 } }",
  "deck.lua:1: model: field 'prestress': expected inside each of the bodies, where 'bodies' is given")
wrong("fabric.model", "local flat = fabric.mesh.rectangle{ width=0.0254, height=0.0762, nx=1, ny=3 } flat:map(function(x, y) return x, y, 0 end) "
  .. "fabric.model{ mesh=mesh, card=card, reference=flat }",
  "deck.lua:1: model: field 'warp': expected a direction {x,y,z}, an angle in degrees or a function, got nil: this mesh is "
  .. "not a flat generated one, so the warp has no default")
wrong("fabric.static", "local m = fabric.model{ mesh=mesh, card=card, prestress={ warp=1e9 } } fabric.static{ model=m, duration=1 }",
  "deck.lua:1: static: model: field 'prestress': no strain below 100 % gives 1e+09 N/m in warp and 0 N/m in weft to this cloth")

-- A run goes on from one of the same stress-free shape alone.
wrong("fabric.static", "local function sheet(p) return fabric.model{ mesh=mesh, card=card, prestress=p }:fix('boundary', 'x y z rotation') end "
  .. "local one = fabric.static{ model=sheet{ warp=100 }, duration=1, step=1 }:solve() "
  .. "fabric.static{ from=one, model=sheet{ warp=200 }, duration=1 }",
  "deck.lua:1: static: field 'from': expected a run of the same cloth; it differs in the reference (prestress 100 N/m in warp, 0 N/m in weft "
  .. "there, prestress 200 N/m in warp, 0 N/m in weft here)")

-- model:crease
wrong("model:crease", "model:crease{ angle=90 }",
  "deck.lua:1: crease: field 'set': expected the name of a set, or a line, got neither")
wrong("model:crease", "model:crease{ set='left', line={ {0, 0}, {0, 1} }, angle=90 }",
  "deck.lua:1: crease: field 'set': expected the name of a set, or a line, got both")
wrong("model:crease", "model:crease{ set='left', angel=90 }",
  "deck.lua:1: crease: unknown field 'angel', did you mean 'angle'?")
wrong("model:crease", "model:crease{ set='left' }",
  "deck.lua:1: crease: field 'angle': expected a number from -180 to 180 in degrees, got nil (missing, or a misspelt variable)")
wrong("model:crease", "model:crease{ set='left', angle=200 }",
  "deck.lua:1: crease: field 'angle': expected a number from -180 to 180 in degrees, got 200")
wrong("model:crease", "model:crease{ set='left', angle='flat' }",
  "deck.lua:1: crease: field 'angle': expected a number from -180 to 180 in degrees, got 'flat'")
wrong("model:crease", "model:crease{ set=7, angle=90 }",
  "deck.lua:1: crease: field 'set': expected a string, got 7")
wrong("model:crease", "model:crease{ line=7, angle=90 }",
  "deck.lua:1: crease: field 'line': expected a table { {x, y, z}, ... }, got 7")
wrong("model:crease", "model:crease{ line={ {0, 0, 0} }, angle=90 }",
  "deck.lua:1: crease: field 'line': expected two points {x, y, z} or more, got 1")
wrong("model:crease", "model:crease{ line={ {0, 0.01, 0}, {0.02, 0.01, 0} }, angle=90 }",
  "deck.lua:1: crease: no edge of the mesh lies on the line from (0, 0.01, 0) m to (0.02, 0.01, 0) m: expected a line along edges of the stress-free shape")
wrong("model:crease", "local m = fabric.mesh.rectangle{ width=0.04, height=0.04, nx=4, ny=4 } m:set('plus', { 8, 12, 13, 14, 18 }) "
  .. "fabric.model{ mesh=m, card=card }:crease{ set='plus', angle=90 }",
  "deck.lua:1: crease: set 'plus': expected edges in one line, got three at node 13 at (0.02, 0.02, 0) m")
wrong("model:crease", "model:crease{ set='corners', angle=90 }",
  "deck.lua:1: crease: the edge between nodes 1 and 2 is one of the boundary: expected edges with cloth on both sides")
wrong("fabric.static", "model:crease{ line={ {0, 0.0254, 0}, {0.0254, 0.0254, 0} }, angle=90 }:crease{ line={ {0, 0.0254, 0}, {0.0254, 0.0254, 0} }, angle=-90 } "
  .. "fabric.static{ model=model, duration=1 }",
  "deck.lua:1: static: crease: the edge between nodes 3 and 4 is in two creases: expected one angle")
wrong("fabric.static", "local m = fabric.mesh.rectangle{ width=0.04, height=0.04, nx=2, ny=2 } "
  .. "local both = fabric.model{ mesh=m, card=card }:crease{ line={ {0.02, 0, 0}, {0.02, 0.04, 0} }, angle=90 }:crease{ line={ {0, 0.02, 0}, {0.04, 0.02, 0} }, angle=90 } "
  .. "fabric.static{ model=both, duration=1 }",
  "deck.lua:1: static: crease: creases meet at node 5 at (0.02, 0.02, 0) m: expected creases that do not cross, or that all have a 'stiffness', since without it a node has one director")

-- Creases that are hinges.
wrong("model:crease", "model:crease{ set='left', angle=90, stiffness=-1 }",
  "deck.lua:1: crease: field 'stiffness': expected a number from 0 to 1e+06 in N/rad, got -1")
wrong("model:crease", "model:crease{ set='left', angle=90, stiffness='soft' }",
  "deck.lua:1: crease: field 'stiffness': expected a number from 0 to 1e+06 in N/rad, got 'soft'")
local hinge = ":crease{ line={ {0, 0.0254, 0}, {0.0254, 0.0254, 0} }, angle=90, stiffness=1e-3 } "
wrong("fabric.static", "local m = fabric.model{ mesh=mesh, card=card, membrane=true }" .. hinge .. "fabric.static{ model=m, duration=1 }",
  "deck.lua:1: static: crease: field 'stiffness': expected a model whose cloth bends, got a membrane")
wrong("fabric.static", "local m = fabric.model{ mesh=mesh, card=card }" .. hinge .. "m:tearable 'all' fabric.static{ model=m, duration=1 }",
  "deck.lua:1: static: crease: field 'stiffness': expected a model without tearable zones")
wrong("fabric.static", "local m = fabric.model{ mesh=mesh, card=card }" .. hinge
  .. "m:tie('periodic', 'left', 'right', 'x') fabric.static{ model=m, duration=1 }",
  "deck.lua:1: static: crease: field 'stiffness': expected a model whose hinges stay away from periodic ties, got node 3 at (0, 0.0254, 0) m of set 'left'")
wrong("fabric.static", "local m = fabric.model{ bodies={ { name='a', mesh=mesh, card=card }, "
  .. "{ name='b', mesh=fabric.mesh.rectangle{ width=0.0254, height=0.0762, nx=1, ny=3, origin={0.0254, 0} }, card=card } } }" .. hinge
  .. "m:seam{ 'a.right', 'b.left', over=1 } fabric.static{ model=m, duration=1 }",
  "deck.lua:1: static: crease: field 'stiffness': expected a model whose hinges stay away from seams, got node 4 at (0.0254, 0.0254, 0) m of set 'a.right'")
wrong("fabric.static", "local m = fabric.mesh.rectangle{ width=0.04, height=0.04, nx=2, ny=2 } "
  .. "local both = fabric.model{ mesh=m, card=card }:crease{ line={ {0.02, 0, 0}, {0.02, 0.04, 0} }, angle=90 }:crease{ line={ {0, 0.02, 0}, {0.04, 0.02, 0} }, angle=90, stiffness=1 } "
  .. "fabric.static{ model=both, duration=1 }",
  "deck.lua:1: static: crease: creases meet at node 5 at (0.02, 0.02, 0) m: expected creases that do not cross, or that all have a 'stiffness', since without it a node has one director")

-- fabric.lab.form_finding
wrong("fabric.lab.form_finding", "fabric.lab.form_finding{ mseh=mesh }",
  "deck.lua:1: form_finding: unknown field 'mseh', did you mean 'mesh'?")
wrong("fabric.lab.form_finding", "fabric.lab.form_finding{ mesh=5 }",
  "deck.lua:1: form_finding: field 'mesh': expected a mesh, got 5")
wrong("fabric.lab.form_finding", "fabric.lab.form_finding{ mesh=mesh, prestress=5 }",
  "deck.lua:1: form_finding: field 'prestress': expected a table {warp, weft}, got 5")
wrong("fabric.lab.form_finding", "fabric.lab.form_finding{ mesh=mesh, prestress={ warp=5, weft=5 } }",
  "deck.lua:1: form_finding: field 'hold': expected a function, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.form_finding", "fabric.lab.form_finding{ mesh=mesh, prestress={ warp=5, weft=5 }, hold=5 }",
  "deck.lua:1: form_finding: field 'hold': expected a function, got 5")
wrong("fabric.lab.form_finding", "fabric.lab.form_finding{ mesh=mesh, prestress={ warp=5 }, hold=print }",
  "deck.lua:1: form_finding: field 'prestress.weft': expected a positive number in N/m, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.form_finding", "fabric.lab.form_finding{ mesh=mesh, prestress={ warp=5, weft=5, wrap=3 }, hold=print }",
  "deck.lua:1: form_finding: unknown field 'prestress.wrap', did you mean 'prestress.warp'?")
wrong("fabric.lab.form_finding", "fabric.lab.form_finding{ mesh=mesh, prestress={ warp=0, weft=5 }, hold=print }",
  "deck.lua:1: form_finding: field 'prestress.warp': expected a positive number in N/m, got 0")
wrong("fabric.lab.form_finding", "fabric.lab.form_finding{ mesh=mesh, prestress={ warp=5, weft=5 }, hold=print, tolerance='fine' }",
  "deck.lua:1: form_finding: field 'tolerance': expected a positive number, got 'fine'")
wrong("fabric.lab.form_finding", "fabric.lab.form_finding{ mesh=mesh, prestress={ warp=5, weft=5 }, hold=print, rounds=0 }",
  "deck.lua:1: form_finding: field 'rounds': expected an integer of at least 1, got 0")
wrong("fabric.lab.form_finding", "fabric.lab.form_finding{ mesh=mesh, prestress={ warp=5, weft=5 }, hold=print, rounds=1.5 }",
  "deck.lua:1: form_finding: field 'rounds': expected an integer of at least 1, got 1.5")

-- fabric.mesh.read
wrong("fabric.mesh.read", "fabric.mesh.read('disc.msh', false, 3)",
  "deck.lua:1: read: argument 'reference': expected true or false, got 3")
wrong("fabric.mesh.read", "fabric.mesh.read{ file='none.msh', reference=true }",
  "deck.lua:1: read: cannot read a stress-free shape of 'none.msh': expected a name that ends in .inp, .k, .key or .rad")
