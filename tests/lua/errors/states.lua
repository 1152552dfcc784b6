-- Wrong calls and their messages: states, modes, buckling. Read by tests/lua/errors.lua.
-- fabric.static and fabric.dynamic with from=
wrong("fabric.static", "fabric.static{ from=model, duration=1 }",
  "deck.lua:1: static: field 'from': expected an analysis, got a model")
wrong("fabric.dynamic", "fabric.dynamic{ from=model, duration=1 }",
  "deck.lua:1: dynamic: field 'from': expected an analysis, got a model")
wrong("fabric.static", "fabric.static{ duration=1 }",
  "deck.lua:1: static: field 'model': expected a model, or from= another run, got nil (missing, or a misspelt variable)")
wrong("fabric.dynamic", "fabric.dynamic{ duration=1 }",
  "deck.lua:1: dynamic: field 'model': expected a model, or from= another run, got nil (missing, or a misspelt variable)")
wrong("fabric.static", "fabric.static{ model=held, duration=1, release=0.5 }",
  "deck.lua:1: static: field 'release': expected from= beside it, whose supports let go")
wrong("fabric.dynamic", "fabric.dynamic{ from=run:solve(), duration=1, release=0 }",
  "deck.lua:1: dynamic: field 'release': expected a positive number in s, got 0")
wrong("fabric.dynamic", "fabric.dynamic{ from=run, duration=1 }",
  "deck.lua:1: dynamic: field 'from': expected a run that has made a step, got one that has not: solve() it before")
wrong("fabric.static", "fabric.static{ from=run:solve(), duration=1, release=0.5 }",
  "deck.lua:1: static: field 'release': nothing that held the cloth lets go here: expected a model without one of the "
  .. "supports or loads of the other run, or no release")
wrong("fabric.static", "local other = fabric.mesh.rectangle{ width=0.0254, height=0.0762, nx=1, ny=4 } "
  .. "fabric.static{ from=run:solve(), model=fabric.model{ mesh=other, card=card, warp=90 }, duration=1 }",
  "deck.lua:1: static: field 'from': expected a run of the same cloth; it differs in the mesh (8 nodes and 3 elements there, "
  .. "10 nodes and 4 elements here)")
wrong("fabric.dynamic", "fabric.dynamic{ from=run:solve(), model=fabric.model{ mesh=mesh, card=fabric.card 'denim', warp=90 }, "
  .. "duration=1 }",
  "deck.lua:1: dynamic: field 'from': expected a run of the same cloth; it differs in the thickness (0.00038 m with 3 points "
  .. "there, 0.00112 m with 3 points here) and the card (blend there, denim here)")
wrong("fabric.static", "fabric.static{ from=run:solve(), model=fabric.model{ mesh=mesh, card=card, warp=0 }, duration=1 }",
  "deck.lua:1: static: field 'from': expected a run of the same cloth; it differs in the warp direction")
wrong("fabric.static", "local m = run.model:copy{ without='move' } m:tie('equal', 'top', 'y') fabric.static{ from=run:solve(), model=m, duration=1 }",
  "deck.lua:1: static: field 'from': expected a run of the same cloth; it differs in the ties")

-- fabric.modes
wrong("fabric.modes", "fabric.modes{ from=run, model=held }",
  "deck.lua:1: modes: field 'from': expected an analysis, or in its place model=, got both")
wrong("fabric.modes", "fabric.modes{ count=3 }",
  "deck.lua:1: modes: field 'from': expected an analysis, or in its place model=, got neither")
wrong("fabric.modes", "fabric.modes{ from=held }",
  "deck.lua:1: modes: field 'from': expected an analysis, got a model")
wrong("fabric.modes", "fabric.modes{ model=mesh }",
  "deck.lua:1: modes: field 'model': expected a model, got a mesh")
wrong("fabric.modes", "fabric.modes{ model=held, count='3' }",
  "deck.lua:1: modes: field 'count': expected an integer from 1 to 400, got '3'")
wrong("fabric.modes", "fabric.modes{ model=held, count=0 }",
  "deck.lua:1: modes: field 'count': expected an integer from 1 to 400, got 0")
wrong("fabric.modes", "fabric.modes{ model=held, below='10' }",
  "deck.lua:1: modes: field 'below': expected a positive number in Hz, got '10'")
wrong("fabric.modes", "fabric.modes{ model=held, below=-1 }",
  "deck.lua:1: modes: field 'below': expected a positive number in Hz, got -1")
wrong("fabric.modes", "fabric.modes{ model=held, cuont=3 }",
  "deck.lua:1: modes: unknown field 'cuont', did you mean 'count'?")
wrong("fabric.modes", "fabric.modes{ model=held:fix('all', 'x y z rotation') }",
  "deck.lua:1: modes: every node of the model is held: nothing can move")

-- fabric.buckling
wrong("fabric.buckling", "fabric.buckling{}",
  "deck.lua:1: buckling: field 'from': expected an analysis, got nil (missing, or a misspelt variable)")
wrong("fabric.buckling", "fabric.buckling{ from=held }",
  "deck.lua:1: buckling: field 'from': expected an analysis, got a model")
wrong("fabric.buckling", "fabric.buckling{ from=run, count='1' }",
  "deck.lua:1: buckling: field 'count': expected an integer from 1 to 400, got '1'")
wrong("fabric.buckling", "fabric.buckling{ from=run, count=500 }",
  "deck.lua:1: buckling: field 'count': expected an integer from 1 to 400, got 500")
wrong("fabric.buckling", "fabric.buckling{ from=run, modes=2 }",
  "deck.lua:1: buckling: unknown field 'modes' (known: from load count)")
wrong("fabric.buckling", "fabric.buckling{ from=run }",
  "deck.lua:1: buckling: the state of this run has no stress: expected one under the loads whose factor is asked for")
wrong("fabric.buckling", "fabric.buckling{ from=run, load=-1 }",
  "deck.lua:1: buckling: field 'load': expected a model, got -1")
wrong("fabric.buckling", "fabric.buckling{ from=run:solve(), load=run.model:copy() }",
  "deck.lua:1: buckling: field 'load': expected a model with loads or motions beside those of the run at time 1 s, got none")
wrong("fabric.buckling", "fabric.buckling{ from=run:solve(), load=run.model:copy{ without='move' }:force('top', { y=1 }) }",
  "deck.lua:1: buckling: field 'load': expected the supports of the run, which hold or move the same; node 7 differs")
wrong("fabric.buckling", "fabric.buckling{ from=run:solve(), load=fabric.model{ mesh=mesh, card=card, warp=0 } }",
  "deck.lua:1: buckling: field 'load': expected a model of the same cloth; it differs in the warp direction")
wrong("fabric.buckling", "local m = run.model:copy() m:contact{ between={ fabric.rigid.plane{ point={0, 0, -1}, normal={0, 0, 1} }, 'all' } } "
  .. "fabric.buckling{ from=run:solve(), load=m }",
  "deck.lua:1: buckling: field 'load': expected the bodies and contacts of the run; it differs in the rigid body 'plane' (none "
  .. "there) and the contact of plane and 'all' (none there)")

-- shapes
wrong("shape:mesh", "fabric.modes{ model=held, count=1 }[1].shape:mesh()",
  "deck.lua:1: mesh: argument 'amplitude': expected a number in m, got nil (missing, or a misspelt variable)")
wrong("shape:mesh", "fabric.modes{ model=held, count=1 }[1].shape:mesh('1')",
  "deck.lua:1: mesh: argument 'amplitude': expected a number in m, got '1'")
wrong("shape:mesh", "fabric.modes{ model=held, count=1 }[1].shape:mesh(1, 'front')",
  "deck.lua:1: mesh: argument 'options': expected a table {body}, got 'front'")
wrong("shape:mesh", "fabric.modes{ model=held, count=1 }[1].shape:mesh(1, { body=2 })",
  "deck.lua:1: mesh: field 'options.body': expected a string, got 2")
wrong("shape:mesh", "fabric.modes{ model=held, count=1 }[1].shape:mesh(1, { body='front' })",
  "deck.lua:1: mesh: field 'body': unknown body 'front'")
wrong("shape:vtk", "fabric.modes{ model=held, count=1 }[1].shape:vtk()",
  "deck.lua:1: vtk: argument 'stem': expected a string, got nil (missing, or a misspelt variable)")
wrong("shape:vtk", "fabric.modes{ model=held, count=1 }[1].shape:vtk(1)",
  "deck.lua:1: vtk: argument 'stem': expected a string, got 1")
wrong("shape:vtk", "fabric.modes{ model=held, count=1 }[1].shape:vtk('mode', 3)",
  "deck.lua:1: vtk: argument 'options': expected a table {amplitude, frames}, got 3")
wrong("shape:vtk", "fabric.modes{ model=held, count=1 }[1].shape:vtk('mode', { amplitude='1' })",
  "deck.lua:1: vtk: field 'options.amplitude': expected a number in m, got '1'")
wrong("shape:vtk", "fabric.modes{ model=held, count=1 }[1].shape:vtk('mode', { frames='1' })",
  "deck.lua:1: vtk: field 'options.frames': expected an integer of at least 1, got '1'")
wrong("shape:vtk", "fabric.modes{ model=held, count=1 }[1].shape:vtk('mode', { frames=0 })",
  "deck.lua:1: vtk: field 'options.frames': expected an integer of at least 1, got 0")

-- model:copy
wrong("model:copy", "held:copy('fix')",
  "deck.lua:1: copy: argument 'changes': expected a table {without}, got 'fix'")
wrong("model:copy", "held:copy{ without=3 }",
  "deck.lua:1: copy: field 'changes.without': expected a table or a string, got 3")
wrong("model:copy", "held:copy{ without='fix botom' }",
  "deck.lua:1: copy: argument 'changes.without': unknown declaration 'fix botom', did you mean 'fix bottom'?")

-- fabric.lab.chain
local function chain(fields) return "fabric.lab.chain{ model=model, " .. fields .. " }" end
wrong("fabric.lab.chain", "fabric.lab.chain{ steps={} }",
  "deck.lua:1: chain: field 'model': expected a model, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.chain", "fabric.lab.chain{ model=mesh, steps={} }", "deck.lua:1: chain: field 'model': expected a model, got a mesh")
wrong("fabric.lab.chain", "fabric.lab.chain{ model=model }",
  "deck.lua:1: chain: field 'steps': expected a table { {name=, duration=, scheme=?, loads=?, release=?, options=?}, ... }, got nil (missing, or a "
  .. "misspelt variable)")
wrong("fabric.lab.chain", chain "steps={}",
  "deck.lua:1: chain: field 'steps': expected a list of steps { {name=, duration=, ...}, ... }, got no step")
wrong("fabric.lab.chain", chain "steps={ 'pull' }",
  "deck.lua:1: chain: field 'steps[1]': expected a table {name, scheme, duration, loads, release, options}, got 'pull'")
wrong("fabric.lab.chain", chain "steps={ nil, { name='pull', duration=1 } }",
  "deck.lua:1: chain: field 'steps[1]': expected a table {name, scheme, duration, loads, release, options}, got nil (missing, "
  .. "or a misspelt variable)")
wrong("fabric.lab.chain", chain "steps={ { name='pull', duration=1, load=1 } }",
  "deck.lua:1: chain: unknown field 'steps[1].load', did you mean 'steps[1].loads'?")
wrong("fabric.lab.chain", chain "steps={ { duration=1 } }",
  "deck.lua:1: chain: field 'steps[1].name': expected a string, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.chain", chain "steps={ { name='pull', duration=1 }, { name='go', duration=1, scheme='quick' } }",
  "deck.lua:1: chain: field 'steps[2].scheme': expected 'static' or 'explicit' or 'implicit', got 'quick'")
wrong("fabric.lab.chain", chain "steps={ { name='pull', duration=0 } }",
  "deck.lua:1: chain: field 'steps[1].duration': expected a positive number in s, got 0")
wrong("fabric.lab.chain", chain "steps={ { name='pull', duration=1, loads={} } }",
  "deck.lua:1: chain: field 'steps[1].loads': expected a function, got a table")
wrong("fabric.lab.chain", chain "steps={ { name='pull', duration=1, release=1 } }",
  "deck.lua:1: chain: field 'steps[1].release': expected none: nothing holds the cloth before the first step")
wrong("fabric.lab.chain", chain "steps={ { name='pull', duration=1 }, { name='go', duration=1, release=-1 } }",
  "deck.lua:1: chain: field 'steps[2].release': expected a positive number in s, got -1")
wrong("fabric.lab.chain", chain "steps={ { name='pull', duration=1, options=3 } }",
  "deck.lua:1: chain: field 'steps[1].options': expected a table, got 3")
wrong("fabric.lab.chain", chain "steps={ { name='pull', duration=1 } }, cycles=0",
  "deck.lua:1: chain: field 'cycles': expected an integer of at least 1, got 0")
wrong("fabric.lab.chain", chain "steps={ { name='pull', duration=1 } }, columns={ force=3 }",
  "deck.lua:1: chain: field 'columns': expected { name=function(analysis) ... end, ... }, got 3 for 'force'")
wrong("fabric.lab.chain", chain "steps={ { name='pull', duration=1 } }, watch=3", "deck.lua:1: chain: field 'watch': expected a function, got 3")
wrong("fabric.lab.chain", chain "steps={ { name='pull', duration=1 } }, checkpoint=3", "deck.lua:1: chain: field 'checkpoint': expected a string, got 3")
wrong("fabric.lab.chain", chain "steps={ { name='pull', duration=1 } }, cycle=3", "deck.lua:1: chain: unknown field 'cycle', did you mean 'cycles'?")
