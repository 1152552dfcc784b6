-- Wrong calls and their messages: run. Read by tests/lua/errors.lua.
-- analysis:advance
wrong("analysis:advance", "run:advance()",
  "deck.lua:1: advance: argument 'time': expected a number of at least 0 in s, got nil (missing, or a misspelt variable)")
wrong("analysis:advance", "run:advance('1')",
  "deck.lua:1: advance: argument 'time': expected a number of at least 0 in s, got '1'")
wrong("analysis:advance", "run:advance(-1)",
  "deck.lua:1: advance: argument 'time': expected a number of at least 0 in s, got -1")

-- analysis:element
wrong("analysis:element", "run:element()",
  "deck.lua:1: element: argument 'number': expected an integer of at least 1, got nil (missing, or a misspelt variable)")
wrong("analysis:element", "run:element(2.5)",
  "deck.lua:1: element: argument 'number': expected an integer of at least 1, got 2.5")
wrong("analysis:element", "run:element(0)",
  "deck.lua:1: element: argument 'number': expected an integer of at least 1, got 0")

-- analysis:event
wrong("analysis:event", "run:event{ valeu=print }",
  "deck.lua:1: event: unknown field 'valeu', did you mean 'value'?")
wrong("analysis:event", "run:event{ value=value_ }",
  "deck.lua:1: event: field 'value': expected a function, got nil (missing, or a misspelt variable)")
wrong("analysis:event", "run:event{ value='f' }",
  "deck.lua:1: event: field 'value': expected a function, got 'f'")
wrong("analysis:event", "run:event{ value=print, tolerance='1' }",
  "deck.lua:1: event: field 'tolerance': expected a positive number, got '1'")
wrong("analysis:event", "run:event{ value=print, tolerance=-1 }",
  "deck.lua:1: event: field 'tolerance': expected a positive number, got -1")

-- analysis:every
wrong("analysis:every", "run:every()",
  "deck.lua:1: every: argument 'interval': expected a positive number in s or 'step', got nil (missing, or a misspelt variable)")
wrong("analysis:every", "run:every('stpe')",
  "deck.lua:1: every: argument 'interval': expected a positive number in s or 'step', got 'stpe', did you mean 'step'?")
wrong("analysis:every", "run:every(-1)",
  "deck.lua:1: every: argument 'interval': expected a positive number in s or 'step', got -1")
wrong("analysis:every", "run:every(1, 'f')",
  "deck.lua:1: every: argument 'action': expected a function, got 'f'")

-- analysis:field
wrong("analysis:field", "run:field()",
  "deck.lua:1: field: argument 'name': expected one of 71 names, 'rupture_warp' to 'error' (help, or reference.md, lists them), got nil (missing, or a misspelt variable)")
wrong("analysis:field", "run:field('storde')",
  "deck.lua:1: field: argument 'name': got 'storde', did you mean 'stored'? Expected one of 71 names, 'rupture_warp' to 'error' (help, or reference.md, lists them)")

wrong("analysis:field", "run:field('S11', 5)",
  "deck.lua:1: field: argument 'options': expected a table {at, region}, got 5")
wrong("analysis:field", "run:field('S11', { at='node' })",
  "deck.lua:1: field: field 'options.at': expected 'nodes', got 'node', did you mean 'nodes'?")
wrong("analysis:field", "run:field('S11', { at='nodes', region='front' })",
  "deck.lua:1: field: field 'options.region': expected an integer of at least 1, got 'front'")
wrong("analysis:field", "run:field('S11', { at='nodes', region=0 })",
  "deck.lua:1: field: field 'options.region': expected an integer of at least 1, got 0")
wrong("analysis:field", "run:field('S11', { at='nodes', region=2 })",
  "deck.lua:1: field: field 'S': expected a region from 1 to 1, got 2")
wrong("analysis:field", "run:field('S11', { region=1 })",
  "deck.lua:1: field: field 'options.region': expected at=\"nodes\" with it")
wrong("analysis:field", "run:field('uz', { at='nodes' })",
  "deck.lua:1: field: field 'displacement': has its values at the nodes: expected it without 'at'")
wrong("analysis:field", "run:field('region', { at='nodes' })",
  "deck.lua:1: field: field 'region': jumps from element to element, and has no values at the nodes")

-- analysis:mean
wrong("analysis:mean", "run:mean()",
  "deck.lua:1: mean: argument 'name': expected one of 57 names, 'rupture_warp' to 'joint_open' (help, or reference.md, lists them), got nil (missing, or a misspelt variable)")
wrong("analysis:mean", "run:mean('storde')",
  "deck.lua:1: mean: argument 'name': got 'storde', did you mean 'stored'? Expected one of 57 names, 'rupture_warp' to 'joint_open' (help, or reference.md, lists them)")
wrong("analysis:mean", "run:mean('E11', 7)",
  "deck.lua:1: mean: argument 'set': expected a string, got 7")

-- analysis:node
wrong("analysis:node", "run:node()",
  "deck.lua:1: node: argument 'number': expected an integer of at least 1, got nil (missing, or a misspelt variable)")
wrong("analysis:node", "run:node(2.5)",
  "deck.lua:1: node: argument 'number': expected an integer of at least 1, got 2.5")
wrong("analysis:node", "run:node(0)",
  "deck.lua:1: node: argument 'number': expected an integer of at least 1, got 0")

-- analysis:reaction
wrong("analysis:reaction", "run:reaction()",
  "deck.lua:1: reaction: argument 'set': expected a string or a body, got nil (missing, or a misspelt variable)")
wrong("analysis:reaction", "run:reaction(7)",
  "deck.lua:1: reaction: argument 'set': expected a string or a body, got 7")
wrong("analysis:reaction", "run:reaction('top', 5)",
  "deck.lua:1: reaction: argument 'options': expected a table {window, support}, got 5")
wrong("analysis:reaction", "run:reaction('top', { support=5 })",
  "deck.lua:1: reaction: field 'options.support': expected true or false, got 5")
wrong("analysis:reaction", "run:reaction('top', { support=true })",
  "deck.lua:1: reaction: argument 'options.support': expected a rigid body, which m:fix holds, got the set 'top'")
wrong("analysis:reaction", "run:reaction('top', { window='x' })",
  "deck.lua:1: reaction: field 'options.window': expected a positive number in s, got 'x'")
wrong("analysis:reaction", "run:reaction('top', { window=0 })",
  "deck.lua:1: reaction: field 'options.window': expected a positive number in s, got 0")
wrong("analysis:reaction", "run:reaction('top', { windwo=1 })",
  "deck.lua:1: reaction: unknown field 'options.windwo', did you mean 'options.window'?")

-- analysis:record
wrong("analysis:record", "run:record()",
  "deck.lua:1: record: argument 'path': expected a string, got nil (missing, or a misspelt variable)")
wrong("analysis:record", "run:record(7)",
  "deck.lua:1: record: argument 'path': expected a string, got 7")
wrong("analysis:record", "run:record('x', 5)",
  "deck.lua:1: record: argument 'options': expected a table {every, columns, window, order, units}, got 5")
wrong("analysis:record", "run:record('x', { columns={ t=print }, window='x' })",
  "deck.lua:1: record: field 'options.window': expected a positive number in s, got 'x'")
wrong("analysis:record", "run:record('x', { columns={ t=print }, window=0 })",
  "deck.lua:1: record: field 'options.window': expected a positive number in s, got 0")
wrong("analysis:record", "run:record('x', { columns={ f={ 'S11', window=-1 } } })",
  "deck.lua:1: record: field 'options.columns.f': expected window = a positive time in s, got -1")
wrong("analysis:record", "run:record('x', { every='stpe' })",
  "deck.lua:1: record: field 'options.every': expected a positive number in s or 'step', got 'stpe', did you mean 'step'?")
wrong("analysis:record", "run:record('x', { every=-1 })",
  "deck.lua:1: record: field 'options.every': expected a positive number in s or 'step', got -1")
wrong("analysis:record", "run:record('x', { columns=5 })",
  "deck.lua:1: record: field 'options.columns': expected a table, got 5")

-- analysis:restore
wrong("analysis:restore", "run:restore()",
  "deck.lua:1: restore: argument 'snapshot': expected a snapshot, got nil (missing, or a misspelt variable)")
wrong("analysis:restore", "run:restore(mesh)",
  "deck.lua:1: restore: argument 'snapshot': expected a snapshot, got a mesh")

-- analysis:stop
wrong("analysis:stop", "run:stop(7)",
  "deck.lua:1: stop: argument 'reason': expected a string, got 7")

-- analysis:vtk
wrong("analysis:vtk", "run:vtk()",
  "deck.lua:1: vtk: argument 'stem': expected a string, got nil (missing, or a misspelt variable)")
wrong("analysis:vtk", "run:vtk(7)",
  "deck.lua:1: vtk: argument 'stem': expected a string, got 7")
wrong("analysis:vtk", "run:vtk('x', 5)",
  "deck.lua:1: vtk: argument 'options': expected a table {every, fields, points, averaged}, got 5")
wrong("analysis:vtk", "run:vtk('x', { every='stpe' })",
  "deck.lua:1: vtk: field 'options.every': expected a positive number in s or 'step', got 'stpe', did you mean 'step'?")
wrong("analysis:vtk", "run:vtk('x', { every=-1 })",
  "deck.lua:1: vtk: field 'options.every': expected a positive number in s or 'step', got -1")
wrong("analysis:vtk", "run:vtk('x', { fields=5 })",
  "deck.lua:1: vtk: field 'options.fields': expected a table, got 5")

wrong("analysis:vtk", "run:vtk('x', { points='undeformed' })",
  "deck.lua:1: vtk: field 'options.points': expected 'deformed' or 'reference', got 'undeformed', did you mean 'deformed'?")
wrong("analysis:vtk", "run:vtk('x', { averaged='yes' })",
  "deck.lua:1: vtk: field 'options.averaged': expected true or false, got 'yes'")

-- analysis:write
wrong("analysis:write", "run:write()",
  "deck.lua:1: write: argument 'file': expected a string, got nil (missing, or a misspelt variable)")
wrong("analysis:write", "run:write(7)",
  "deck.lua:1: write: argument 'file': expected a string, got 7")
wrong("analysis:write", "run:write('x.vtu', 5)",
  "deck.lua:1: write: argument 'options': expected a table {fields, points, averaged}, got 5")
wrong("analysis:write", "run:write('x.vtu', { fields=5 })",
  "deck.lua:1: write: field 'options.fields': expected a table, got 5")
wrong("analysis:write", "run:write('x.vtu', { points='undeformed' })",
  "deck.lua:1: write: field 'options.points': expected 'deformed' or 'reference', got 'undeformed', did you mean 'deformed'?")
wrong("analysis:write", "run:write('x.vtu', { averaged='yes' })",
  "deck.lua:1: write: field 'options.averaged': expected true or false, got 'yes'")
wrong("analysis:write", "run:write('x.stl', { averaged=true })",
  "deck.lua:1: write: field 'options.averaged': expected a file that ends in .vtu, which holds fields, got 'x.stl'")
wrong("analysis:write", "run:write('x.vtu', { fields={'S1'} })",
  "deck.lua:1: write: field 'fields': unknown field 'S1', did you mean 'S11'?")
wrong("analysis:write", "run:write 'x.step'",
  "deck.lua:1: write: cannot write 'x.step': expected a name that ends in .msh, .vtu, .obj, .stl, .ply, .inp, .k or .rad")

-- fabric.dynamic
wrong("fabric.dynamic", "fabric.dynamic{ modle=held }",
  "deck.lua:1: dynamic: unknown field 'modle', did you mean 'model'?")
wrong("fabric.dynamic", "fabric.dynamic{ model=model_, duration=1 }",
  "deck.lua:1: dynamic: field 'model': expected a model, or from= another run, got nil (missing, or a misspelt variable)")
wrong("fabric.dynamic", "fabric.dynamic{ model=mesh }",
  "deck.lua:1: dynamic: field 'model': expected a model, got a mesh")
wrong("fabric.dynamic", "fabric.dynamic{ model=held, duration='1' }",
  "deck.lua:1: dynamic: field 'duration': expected a positive number in s, got '1'")
wrong("fabric.dynamic", "fabric.dynamic{ model=held, duration=-1 }",
  "deck.lua:1: dynamic: field 'duration': expected a positive number in s, got -1")
wrong("fabric.dynamic", "fabric.dynamic{ model=held, duration=1, step='auot' }",
  "deck.lua:1: dynamic: field 'step': expected a positive number in s or 'auto', got 'auot', did you mean 'auto'?")
wrong("fabric.dynamic", "fabric.dynamic{ model=held, duration=1, scheme='explicti' }",
  "deck.lua:1: dynamic: field 'scheme': expected 'explicit' or 'implicit', got 'explicti', did you mean 'explicit'?")
wrong("fabric.dynamic", "fabric.dynamic{ model=held, duration=1, damping=5 }",
  "deck.lua:1: dynamic: field 'damping': expected a table {mass, stiffness}, got 5")
wrong("fabric.dynamic", "fabric.dynamic{ model=held, duration=1, until_rest=true }",
  "deck.lua:1: dynamic: field 'until_rest': expected a table {calm, window, still}, got true")
wrong("fabric.dynamic", "fabric.dynamic{ model=held, duration=1, until_rest={ calm=0 } }",
  "deck.lua:1: dynamic: field 'until_rest.calm': expected a number above 0 to below 1, got 0")
wrong("fabric.dynamic", "fabric.dynamic{ model=held, duration=1, until_rest={ calm=1e300 } }",
  "deck.lua:1: dynamic: field 'until_rest.calm': expected a number above 0 to below 1, got 1e+300")
wrong("fabric.dynamic", "fabric.dynamic{ model=held, duration=1, until_rest={ windows=0.1 } }",
  "deck.lua:1: dynamic: unknown field 'until_rest.windows', did you mean 'until_rest.window'?")
wrong("fabric.dynamic", "fabric.dynamic{ model=held, duration=1, until_rest={ window=1 } }",
  "deck.lua:1: dynamic: field 'until_rest.window': expected less than the duration, 1 s, got 1")
wrong("fabric.dynamic", "fabric.dynamic{ model=held, duration=1, scheme='implicit', error=0 }",
  "deck.lua:1: dynamic: field 'error': expected a number above 0 to below 1, got 0")
wrong("fabric.dynamic", "fabric.dynamic{ model=held, duration=1, error=1e-4 }",
  "deck.lua:1: dynamic: field 'error': unknown for scheme=\"explicit\", whose steps are as short as stability wants")
wrong("fabric.dynamic", "fabric.dynamic{ model=held, duration=1, force='yes' }",
  "deck.lua:1: dynamic: field 'force': expected true or false, got 'yes'")
wrong("fabric.dynamic", "fabric.dynamic{ model=held, duration=1, max_iterations=2.5 }",
  "deck.lua:1: dynamic: field 'max_iterations': expected an integer of at least 1, got 2.5")

-- fabric.static
wrong("fabric.static", "fabric.static{ modle=held }",
  "deck.lua:1: static: unknown field 'modle', did you mean 'model'?")
wrong("fabric.static", "fabric.static{ model=model_, duration=1 }",
  "deck.lua:1: static: field 'model': expected a model, or from= another run, got nil (missing, or a misspelt variable)")
wrong("fabric.static", "fabric.static{ model=mesh }",
  "deck.lua:1: static: field 'model': expected a model, got a mesh")
wrong("fabric.static", "fabric.static{ model=held, duration='1' }",
  "deck.lua:1: static: field 'duration': expected a positive number in s, got '1'")
wrong("fabric.static", "fabric.static{ model=held, duration=-1 }",
  "deck.lua:1: static: field 'duration': expected a positive number in s, got -1")
wrong("fabric.static", "fabric.static{ model=held, duration=1, max_iterations=2.5 }",
  "deck.lua:1: static: field 'max_iterations': expected an integer of at least 1, got 2.5")
wrong("fabric.static", "fabric.static{ model=held, duration=1, line_search='yes' }",
  "deck.lua:1: static: field 'line_search': expected true or false, got 'yes'")
wrong("fabric.static", "fabric.static{ model=held, duration=1, linear='auot' }",
  "deck.lua:1: static: field 'linear': expected 'auto' or 'symmetric' or 'unsymmetric', got 'auot', did you mean 'auto'?")
wrong("fabric.static", "fabric.static{ model=held, duration=1, stabilise='1' }",
  "deck.lua:1: static: field 'stabilise': expected a number from 0 to below 1 or true or false, got '1'")

-- runs that cannot be
wrong("fabric.static", "fabric.static{ model=mesh, duration=1 }",
  "deck.lua:1: static: field 'model': expected a model, got a mesh")
wrong("fabric.static", "fabric.static{ model=model }",
  "deck.lua:1: static: field 'duration': expected a positive number in s, got nil (missing, or a misspelt variable)")
wrong("fabric.static", "fabric.static{ model=model:fix('top', 'y'):move('top', {y=0.01}), duration=1 }",
  "deck.lua:1: static: model: node 7: y is fixed (set 'top') and moved (set 'top')")
wrong("fabric.dynamic", "fabric.dynamic{ model=held, duration=1, step=1 }",
  "deck.lua:1: dynamic: field 'step': expected at most 1.87594e-05 s, the stable step of this mesh and card, got 1 s (step=\"auto\" takes 1.31316e-05 s; force=true uses this step all the same)")
wrong("fabric.dynamic", "fabric.dynamic{ model=held, duration=1, inertia='scald' }",
  "deck.lua:1: dynamic: field 'inertia': expected 'scaled' or 'true', got 'scald', did you mean 'scaled'?")
wrong("object", "return run.tiem",
  "deck.lua:1: analysis: unknown field 'tiem', did you mean 'time'?")
wrong("object", "run.time = 3",
  "deck.lua:1: analysis: field 'time' cannot be assigned")

-- histories and hooks that fail under way
wrong("analysis:solve", "fabric.static{ duration=1, model=held:move('top', { y=function(t) return t > 0.42 and 0/0 or t*1e-3 end }) }:solve()",
  "deck.lua:1: solve: move 'top': field 'y': expected the history to return a finite number at t = 0.45 s, got nan")
wrong("analysis:solve", "fabric.static{ duration=1, model=held:move('top', { y=function(t) return t > 0.42 and 'x' or t*1e-3 end }) }:solve()",
  "deck.lua:1: solve: move 'top': field 'y': expected the history to return a finite number at t = 0.45 s, got 'x'")
wrong("fabric.static", "fabric.static{ duration=1, model=held:move('top', { y=function(t) error 'in the history' end }) }",
  "deck.lua:1: in the history")
wrong("fabric.static", "fabric.static{ duration=1, model=held:force('top', { y=function(t) return 1/0 end }) }",
  "deck.lua:1: static: force 'top': field 'y': expected the history to return a finite number at t = 0 s, got inf")
wrong("fabric.static", "fabric.static{ duration=1, model=held:pressure(function(t) return 'x' end) }",
  "deck.lua:1: static: pressure 'all': argument 'value': expected the history to return a finite number at t = 0 s, got 'x'")
wrong("analysis:every", "run:every('step', function() error 'in the hook' end) run:solve()",
  "deck.lua:1: in the hook")
wrong("analysis:every", "run:every('step', function() local x = nil + 1 end) run:solve()",
  "deck.lua:1: attempt to perform arithmetic on a nil value")
wrong("analysis:every", "run:every('steps', print)",
  "deck.lua:1: every: argument 'interval': expected a positive number in s or 'step', got 'steps', did you mean 'step'?")
wrong("analysis:event", "run:event{ value=function() return 'x' end } run:solve()",
  "deck.lua:1: solve: event: field 'value': expected the function to return a number, got 'x'")

-- reading and writing
wrong("analysis:advance", "run:advance(0.5):advance(0.25)",
  "deck.lua:1: advance: expected a time from 0.5 s, where the run is, got 0.25 s (restore(snapshot) goes back)")
wrong("analysis:mean", "run:mean 'S1'",
  "deck.lua:1: mean: argument 'name': got 'S1', did you mean 'S11'? Expected one of 57 names, 'rupture_warp' to 'joint_open' (help, or reference.md, lists them)")
wrong("analysis:mean", "run:mean('S11', 'bottom')",
  "deck.lua:1: mean: set 'bottom' holds no whole element")
wrong("analysis:node", "run:node(99)",
  "deck.lua:1: node: expected a number from 1 to 8, got 99")
wrong("analysis:element", "run:element(99)",
  "deck.lua:1: element: expected a number from 1 to 3, got 99")
wrong("analysis:reaction", "run:reaction 'tpo'",
  "deck.lua:1: reaction: unknown set 'tpo', did you mean 'top'? known sets: all, bottom, boundary, corners, left, right, top")
wrong("analysis:restore", "run:restore(fabric.static{ model=model, duration=1 }:snapshot())",
  "deck.lua:1: restore: this snapshot was taken of another analysis")
wrong("analysis:record", "run:record('x.csv', { columns={} })",
  "deck.lua:1: record: field 'options.columns': expected at least one column")
wrong("analysis:record", "run:record('x.csv', { columns={ t=1 } })",
  "deck.lua:1: record: field 'options.columns': expected name = function(a) or the name of a field, got 1")
wrong("analysis:record", "run:record('x.csv', { columns={ t=print }, order={'u'} })",
  "deck.lua:1: record: field 'options.order': no column 'u'")
wrong("analysis:record", "run:record('x.csv', { columns={ t=print }, units={ T='s' } })",
  "deck.lua:1: record: field 'options.units': no column 'T'")
wrong("analysis:record", "run:record('x.csv', { columns={ t=print }, units={ t=1 } })",
  "deck.lua:1: record: field 'options.units': expected name = 'unit' or '' for none, got 1 for 't'")
wrong("analysis:record", "run:record('x.csv', { columns={ t=print }, units={ t='(s)' } })",
  "deck.lua:1: record: field 'options.units': expected a unit without brackets, got '(s)' for 't'")
wrong("analysis:record", "run:record('/dev/null/x.csv', { columns={ t=function(a) return a.time end } })",
  "deck.lua:1: record: cannot make the folder '/dev/null': Not a directory")
wrong("analysis:vtk", "run:vtk '/dev/null/x'",
  "deck.lua:1: vtk: cannot make the folder '/dev/null': Not a directory")
wrong("analysis:vtk", "run:vtk('out/x', { fields={'S1'} })",
  "deck.lua:1: vtk: field 'fields': unknown field 'S1', did you mean 'S11'?")
wrong("analysis.stable_step", "return run.stable_step",
  "deck.lua:1: stable_step: a static analysis has no stable step")

-- analysis:reach
wrong("analysis:reach", "run:reach()",
  "deck.lua:1: reach: argument 'value': expected a string or a function, got nil (missing, or a misspelt variable)")
wrong("analysis:reach", "run:reach(5, 1)",
  "deck.lua:1: reach: argument 'value': expected a string or a function, got 5")
wrong("analysis:reach", "run:reach('E11')",
  "deck.lua:1: reach: argument 'target': expected a number, got nil (missing, or a misspelt variable)")
wrong("analysis:reach", "run:reach('E11', 'x')",
  "deck.lua:1: reach: argument 'target': expected a number, got 'x'")
wrong("analysis:reach", "run:reach('E11', 1, 7)",
  "deck.lua:1: reach: argument 'set': expected a string, got 7")
wrong("analysis:reach", "run:reach('E11', 1, 'all', -1)",
  "deck.lua:1: reach: argument 'tolerance': expected a positive number, got -1")

-- fields of plies
wrong("analysis:field", "run:field 'ply2.E11'",
  "deck.lua:1: field: field 'ply2.E11': unknown ply 'ply2', did you mean 'ply1'? (known: ply1)")
wrong("analysis:mean", "run:mean 'face.region'",
  "deck.lua:1: mean: field 'face.region': 'region' is not of single plies: expected it alone")
wrong("analysis:record", "run:record('x.csv', { columns={ q='top.E11' } })",
  "deck.lua:1: record: field 'options.columns.q': field 'top.E11': unknown ply 'top' (known: ply1)")
wrong("analysis:vtk", "run:vtk('x', { fields={ 'top.E11' } })",
  "deck.lua:1: vtk: field 'fields': field 'top.E11': unknown ply 'top' (known: ply1)")
