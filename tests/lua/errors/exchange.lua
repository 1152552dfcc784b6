-- Wrong calls and their messages: export and import. Read by tests/lua/errors.lua.
-- fabric.export.card
wrong("fabric.export.card", "fabric.export.card{ card=card, to='ls-dyna', cardx=1 }",
  "deck.lua:1: card: unknown field 'cardx', did you mean 'card'?")
wrong("fabric.export.card", "fabric.export.card{ to='ls-dyna' }",
  "deck.lua:1: card: field 'card': expected a card, got nil (missing, or a misspelt variable)")
wrong("fabric.export.card", "fabric.export.card{ to='ls-dyna', card=5 }",
  "deck.lua:1: card: field 'card': expected a card, got 5")
wrong("fabric.export.card", "fabric.export.card{ card=card, to='nonsense' }",
  "deck.lua:1: card: field 'to': expected 'ls-dyna' or 'openradioss' or 'abaqus', got 'nonsense'")
wrong("fabric.export.card", "fabric.export.card{ card=card, to='ls-dyna', material=7 }",
  "deck.lua:1: card: field 'material': expected a string, got 7")
wrong("fabric.export.card", "fabric.export.card{ card=card, to='ls-dyna', id=2.5 }",
  "deck.lua:1: card: field 'id': expected an integer from 1 to 9999, got 2.5")
wrong("fabric.export.card", "fabric.export.card{ card=card, to='ls-dyna', id=0 }",
  "deck.lua:1: card: field 'id': expected an integer from 1 to 9999, got 0")
wrong("fabric.export.card", "fabric.export.card{ card=card, to='ls-dyna', axis={1, 'two'} }",
  "deck.lua:1: card: field 'axis': expected a table of numbers, got 'two' at place 2")
wrong("fabric.export.card", "fabric.export.card{ card=card, to='openradioss', element=0 }",
  "deck.lua:1: card: field 'element': expected a positive number in m, got 0")
wrong("fabric.export.model", "fabric.export.model{ model=model, to='openradioss', warp=0, element='fine' }",
  "deck.lua:1: model: field 'element': expected a positive number in m, got 'fine'")

-- fabric.export.mesh
wrong("fabric.export.mesh", "fabric.export.mesh{ mesh=mesh, file='x', meshx=1 }",
  "deck.lua:1: mesh: unknown field 'meshx', did you mean 'mesh'?")
wrong("fabric.export.mesh", "fabric.export.mesh{ file='x' }",
  "deck.lua:1: mesh: field 'mesh': expected a mesh, got nil (missing, or a misspelt variable)")
wrong("fabric.export.mesh", "fabric.export.mesh{ file='x', mesh=5 }",
  "deck.lua:1: mesh: field 'mesh': expected a mesh, got 5")
wrong("fabric.export.mesh", "fabric.export.mesh{ mesh=mesh, file=7 }",
  "deck.lua:1: mesh: field 'file': expected a string, got 7")
wrong("fabric.export.mesh", "fabric.export.mesh{ mesh=mesh, file='x', run=5 }",
  "deck.lua:1: mesh: field 'run': expected an analysis, got 5")

-- fabric.export.gltf
wrong("fabric.export.gltf", "fabric.export.gltf{ file='x.glb', run=run, filed='uy' }",
  "deck.lua:1: gltf: unknown field 'filed', did you mean 'file'?")
wrong("fabric.export.gltf", "fabric.export.gltf{ run=run }",
  "deck.lua:1: gltf: field 'file': expected a string, got nil (missing, or a misspelt variable)")
wrong("fabric.export.gltf", "fabric.export.gltf{ file='x.glb', series=7 }",
  "deck.lua:1: gltf: field 'series': expected a string, got 7")
wrong("fabric.export.gltf", "fabric.export.gltf{ file='x.glb', run=5 }",
  "deck.lua:1: gltf: field 'run': expected an analysis, got 5")
wrong("fabric.export.gltf", "fabric.export.gltf{ file='x.glb', run=run, range={1, 'two'} }",
  "deck.lua:1: gltf: field 'range': expected a table of numbers, got 'two' at place 2")
wrong("fabric.export.gltf", "fabric.export.gltf{ file='x.glb', run=run, duration='1' }",
  "deck.lua:1: gltf: field 'duration': expected a positive number in s, got '1'")
wrong("fabric.export.gltf", "fabric.export.gltf{ file='x.glb', run=run, duration=-1 }",
  "deck.lua:1: gltf: field 'duration': expected a positive number in s, got -1")
wrong("fabric.export.gltf", "fabric.export.gltf{ file='x.glb', run=run, up='x' }",
  "deck.lua:1: gltf: field 'up': expected 'z' or 'y', got 'x'")
wrong("fabric.export.gltf", "fabric.export.gltf{ file='x.glb' }",
  "deck.lua:1: gltf: field 'series': expected either series or run, got neither")

-- fabric.export.model
wrong("fabric.export.model", "fabric.export.model{ model=model, warp=1, modelx=1 }",
  "deck.lua:1: model: unknown field 'modelx', did you mean 'model'?")
wrong("fabric.export.model", "fabric.export.model{ warp=1 }",
  "deck.lua:1: model: field 'model': expected a model, got nil (missing, or a misspelt variable)")
wrong("fabric.export.model", "fabric.export.model{ warp=1, model=5 }",
  "deck.lua:1: model: field 'model': expected a model, got 5")
wrong("fabric.export.model", "fabric.export.model{ model=model, warp='1' }",
  "deck.lua:1: model: field 'warp': expected a number in degrees or a table of numbers in degrees, got '1'")
wrong("fabric.export.model", "fabric.export.model{ model=model, warp=1, file=7 }",
  "deck.lua:1: model: field 'file': expected a string, got 7")
wrong("fabric.export.model", "fabric.export.model{ model=model, warp=1, to='nonsense' }",
  "deck.lua:1: model: field 'to': expected 'ls-dyna' or 'openradioss' or 'abaqus', got 'nonsense'")
wrong("fabric.export.model", "fabric.export.model{ model=model, warp=1, histories=5 }",
  "deck.lua:1: model: field 'histories': expected a table { ['top.y']={{t, v}, ...} }, got 5")
wrong("fabric.export.model", "fabric.export.model{ model=model, warp=1, duration='1' }",
  "deck.lua:1: model: field 'duration': expected a positive number in s, got '1'")
wrong("fabric.export.model", "fabric.export.model{ model=model, warp=1, duration=-1.0 }",
  "deck.lua:1: model: field 'duration': expected a positive number in s, got -1")

-- fabric.import.card
wrong("fabric.import.card", "fabric.import.card{ file='x', filex=1 }",
  "deck.lua:1: card: unknown field 'filex', did you mean 'file'?")
wrong("fabric.import.card", "fabric.import.card{  }",
  "deck.lua:1: card: field 'file': expected a string, got nil (missing, or a misspelt variable)")
wrong("fabric.import.card", "fabric.import.card{ file=7 }",
  "deck.lua:1: card: field 'file': expected a string, got 7")
wrong("fabric.import.card", "fabric.import.card{ file='x', from='nonsense' }",
  "deck.lua:1: card: field 'from': expected 'openradioss' or 'ls-dyna' or 'abaqus', got 'nonsense'")
wrong("fabric.import.card", "fabric.import.card{ file='x', thickness='1' }",
  "deck.lua:1: card: field 'thickness': expected a positive number in m, got '1'")
wrong("fabric.import.card", "fabric.import.card{ file='x', thickness=-1.0 }",
  "deck.lua:1: card: field 'thickness': expected a positive number in m, got -1")
wrong("fabric.import.card", "fabric.import.card{ file='x', poisson={1, 'two'} }",
  "deck.lua:1: card: field 'poisson': expected a table of numbers of at least 0, got 'two' at place 2")
wrong("fabric.import.card", "fabric.import.card{ file='x', tested=5 }",
  "deck.lua:1: card: field 'tested': expected a table {warp, weft, shear}, got 5")
wrong("fabric.export.model", "fabric.export.model{ model=model, error='fine' }",
  "deck.lua:1: model: field 'error': expected a number above 0 to 0.1, got 'fine'")
wrong("fabric.export.model", "fabric.export.model{ model=model, error=0 }",
  "deck.lua:1: model: field 'error': expected a number above 0 to 0.1, got 0")
