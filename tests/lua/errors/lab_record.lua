-- Wrong calls and their messages: lab record. Read by tests/lua/errors.lua.

-- fabric.lab.branches
wrong("fabric.lab.branches", "fabric.lab.branches{ displacemetn={0.01, 0.01} }",
  "deck.lua:1: branches: unknown field 'displacemetn', did you mean 'displacement'?")
wrong("fabric.lab.branches", "fabric.lab.branches{ displacement=displacement_ }",
  "deck.lua:1: branches: field 'displacement': expected a table of numbers in m, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.branches", "fabric.lab.branches{ displacement={1, 'two'} }",
  "deck.lua:1: branches: field 'displacement': expected a table of numbers in m, got 'two' at place 2")
wrong("fabric.lab.branches", "fabric.lab.branches{ displacement={0.01, 0.01}, tolerance='1' }",
  "deck.lua:1: branches: field 'tolerance': expected a positive number in m, got '1'")
wrong("fabric.lab.branches", "fabric.lab.branches{ displacement={0.01, 0.01}, tolerance=-1 }",
  "deck.lua:1: branches: field 'tolerance': expected a positive number in m, got -1")

-- fabric.lab.breaking_strength
wrong("fabric.lab.breaking_strength", "fabric.lab.breaking_strength{ foldr='x' }",
  "deck.lua:1: breaking_strength: unknown field 'foldr', did you mean 'folder'?")
wrong("fabric.lab.breaking_strength", "fabric.lab.breaking_strength{}",
  "deck.lua:1: breaking_strength: field 'folder': expected a string, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.breaking_strength", "fabric.lab.breaking_strength{ folder='x', standard='ISO' }",
  "deck.lua:1: breaking_strength: field 'standard': expected 'ISO 13934-1' or 'ASTM D5035', got 'ISO'")
wrong("fabric.lab.breaking_strength", "fabric.lab.breaking_strength{ folder='x', gauge_length='1' }",
  "deck.lua:1: breaking_strength: field 'gauge_length': expected a positive number in m, got '1'")
wrong("fabric.lab.breaking_strength", "fabric.lab.breaking_strength{ folder='x', gauge_length=0.2, width=-1 }",
  "deck.lua:1: breaking_strength: field 'width': expected a positive number in m, got -1")
wrong("fabric.lab.breaking_strength", "fabric.lab.breaking_strength{ folder='x', gauge_length=0.2, width=0.05, breaks=5 }",
  "deck.lua:1: breaking_strength: field 'breaks': expected a table { ['warp-2']=3e-3, ['warp-4']='jaw' } or a string, got 5")
wrong("fabric.lab.breaking_strength", "fabric.lab.breaking_strength{ folder='x', gauge_length=0.2, width=0.05, faulty=5 }",
  "deck.lua:1: breaking_strength: field 'faulty': expected a table { ['warp-3']='slipped' }, got 5")
wrong("fabric.lab.breaking_strength", "fabric.lab.breaking_strength{ folder='x', gauge_length=0.2, width=0.05, cut_at_break=1 }",
  "deck.lua:1: breaking_strength: field 'cut_at_break': expected true or false, got 1")
wrong("fabric.lab.breaking_strength", "fabric.lab.breaking_strength{ folder='x', gauge_length=0.2, width=0.05, file=5 }",
  "deck.lua:1: breaking_strength: field 'file': expected a string, got 5")
wrong("fabric.lab.breaking_strength", "fabric.lab.breaking_strength{ folder='no-such-folder', gauge_length=0.2, width=0.05 }",
  "deck.lua:1: folder: cannot read the folder 'no-such-folder': No such file or directory")

-- fabric.lab.compare
wrong("fabric.lab.compare", "fabric.lab.compare{ E={0, 1}, S={0, 1} }",
  "deck.lua:1: compare: argument 'test': expected a table, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.compare", "fabric.lab.compare({}, 5)",
  "deck.lua:1: compare: argument 'test': expected a table, got 5")
wrong("fabric.lab.compare", "fabric.lab.compare({}, {}, 5)",
  "deck.lua:1: compare: argument 'options': expected a table {x, y, slack, spread, all, file, ...}, got 5")
wrong("fabric.lab.compare", "fabric.lab.compare({}, {}, { slack='much' })",
  "deck.lua:1: compare: field 'options.slack': expected a number or 'find', got 'much'")
wrong("fabric.lab.compare", "fabric.lab.compare({}, {}, { all=1 })",
  "deck.lua:1: compare: field 'options.all': expected true or false, got 1")
wrong("fabric.lab.compare", "fabric.lab.compare({}, {}, { title=1 })",
  "deck.lua:1: compare: field 'options.title': expected a string, got 1")
wrong("fabric.lab.compare", "fabric.lab.compare({}, {})",
  "deck.lua:1: compare: field 'measured': expected lists E and S, or displacement and force, as the test has them")
wrong("fabric.lab.compare", "fabric.lab.compare({ E={2, 3}, S={0, 1} }, { E={0, 1}, S={0, 1} })",
  "deck.lua:1: compare: expected measured points within the test's E, 0 to 1; they lie at 2 to 3")

-- fabric.lab.density
wrong("fabric.lab.density", "fabric.lab.density{ mass={0.01, 0.01} }",
  "deck.lua:1: density: field 'area': expected a positive number in m^2, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.density", "fabric.lab.density{ mass=mass_ }",
  "deck.lua:1: density: field 'mass': expected a table of numbers above 0 in kg, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.density", "fabric.lab.density{ mass={1, 'two'} }",
  "deck.lua:1: density: field 'mass': expected a table of numbers above 0 in kg, got 'two' at place 2")
wrong("fabric.lab.density", "fabric.lab.density{ mass={0} }",
  "deck.lua:1: density: field 'mass': expected a table of numbers above 0 in kg, got 0 at place 1")
wrong("fabric.lab.density", "fabric.lab.density{ mass={0.01, 0.01}, area='1' }",
  "deck.lua:1: density: field 'area': expected a positive number in m^2, got '1'")

-- fabric.lab.photograph
wrong("fabric.lab.photograph", "fabric.lab.photograph{ fiel='x' }",
  "deck.lua:1: photograph: unknown field 'fiel', did you mean 'file'?")
wrong("fabric.lab.photograph", "fabric.lab.photograph{ file=file_ }",
  "deck.lua:1: photograph: field 'file': expected a string, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.photograph", "fabric.lab.photograph{ file=7 }",
  "deck.lua:1: photograph: field 'file': expected a string, got 7")
wrong("fabric.lab.photograph", "fabric.lab.photograph{ file='x', rows=2.5 }",
  "deck.lua:1: photograph: field 'rows': expected an integer from 2 to 10000, got 2.5")
wrong("fabric.lab.photograph", "fabric.lab.photograph{ file='x', rows=1 }",
  "deck.lua:1: photograph: field 'rows': expected an integer from 2 to 10000, got 1")
wrong("fabric.lab.photograph", "fabric.lab.photograph{ file='x', rows=2, columns=2, pitch='1' }",
  "deck.lua:1: photograph: field 'pitch': expected a positive number in pixels, got '1'")
wrong("fabric.lab.photograph", "fabric.lab.photograph{ file='x', rows=2, columns=2, pitch=0.01, radius=0.01, width=2, height=2, F={1, 'two'} }",
  "deck.lua:1: photograph: field 'F': expected a table of numbers, got 'two' at place 2")

wrong("fabric.lab.photograph", "fabric.lab.photograph{ file='x.foo', rows=2, columns=2, pitch=10, radius=4, width=100, height=100 }",
  "deck.lua:1: photograph: field 'file': expected a name ending in .png, got 'x.foo'")

-- fabric.lab.poisson
wrong("fabric.lab.poisson", "fabric.lab.poisson{ specimesn={} }",
  "deck.lua:1: poisson: unknown field 'specimesn', did you mean 'specimens'?")
wrong("fabric.lab.poisson", "fabric.lab.poisson{ specimens=specimens_ }",
  "deck.lua:1: poisson: field 'specimens': expected a table, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.poisson", "fabric.lab.poisson{ specimens=5 }",
  "deck.lua:1: poisson: field 'specimens': expected a table, got 5")
wrong("fabric.lab.poisson", "fabric.lab.poisson{ specimens={}, noise='1' }",
  "deck.lua:1: poisson: field 'noise': expected a number of at least 0, got '1'")
wrong("fabric.lab.poisson", "fabric.lab.poisson{ specimens={}, noise=-1 }",
  "deck.lua:1: poisson: field 'noise': expected a number of at least 0, got -1")
wrong("fabric.lab.poisson", "fabric.lab.poisson{ specimens={}, seed=2.5 }",
  "deck.lua:1: poisson: field 'seed': expected an integer of at least 0, got 2.5")

-- fabric.lab.ratio
wrong("fabric.lab.ratio", "fabric.lab.ratio{ rosw=2 }",
  "deck.lua:1: ratio: unknown field 'rosw', did you mean 'rows'?")
wrong("fabric.lab.ratio", "fabric.lab.ratio{ rows=rows_ }",
  "deck.lua:1: ratio: field 'rows': expected an integer of at least 2, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.ratio", "fabric.lab.ratio{ rows=2.5 }",
  "deck.lua:1: ratio: field 'rows': expected an integer of at least 2, got 2.5")
wrong("fabric.lab.ratio", "fabric.lab.ratio{ rows=1 }",
  "deck.lua:1: ratio: field 'rows': expected an integer of at least 2, got 1")
wrong("fabric.lab.ratio", "fabric.lab.ratio{ rows=2, columns=2, x=5 }",
  "deck.lua:1: ratio: field 'x': expected a table, got 5")
wrong("fabric.lab.ratio", "fabric.lab.ratio{ rows=2, columns=2, x={}, y={}, noise='1' }",
  "deck.lua:1: ratio: field 'noise': expected a number of at least 0, got '1'")

-- fabric.lab.read
wrong("fabric.lab.read", "fabric.lab.read{ fiel='x' }",
  "deck.lua:1: read: unknown field 'fiel', did you mean 'file'?")
wrong("fabric.lab.read", "fabric.lab.read{ file=file_ }",
  "deck.lua:1: read: field 'file': expected a string, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.read", "fabric.lab.read{ file=7 }",
  "deck.lua:1: read: field 'file': expected a string, got 7")
wrong("fabric.lab.read", "fabric.lab.read{ file='x', columns=5 }",
  "deck.lua:1: read: field 'columns': expected a table {displacement=, force=, time=, strain=}, got 5")
wrong("fabric.lab.read", "fabric.lab.read{ file='x', separator='auot' }",
  "deck.lua:1: read: field 'separator': expected 'auto' or ',' or ';' or 'tab' or 'blank', got 'auot', did you mean 'auto'?")

wrong("fabric.lab.read", "fabric.lab.read{ file='x', width='1' }",
  "deck.lua:1: read: field 'width': expected a positive number in m, got '1'")
wrong("fabric.lab.read", "fabric.lab.read{ file='x', width=0 }",
  "deck.lua:1: read: field 'width': expected a positive number in m, got 0")
wrong("fabric.lab.read", "fabric.lab.read{ file='x', vocabulary=5 }",
  "deck.lua:1: read: field 'vocabulary': expected a table or a string, got 5")
wrong("fabric.lab.read", "fabric.lab.read{ file='x', vocabulary={ force={ 5 } } }",
  "deck.lua:1: read: field 'vocabulary': field 'force': expected words, got 5 at place 1")
wrong("fabric.lab.read", "fabric.lab.read{ file='x', columns={ force=true } }",
  "deck.lua:1: read: field 'columns.force': expected a heading or a place, got true")
wrong("fabric.lab.read", "fabric.lab.read{ file='x', units={ load='N' } }",
  "deck.lua:1: read: field 'units': expected displacement, force, time or strain, got 'load'")

-- fabric.lab.reduce
wrong("fabric.lab.reduce", "fabric.lab.reduce{ displacemetn={0.01, 0.01} }",
  "deck.lua:1: reduce: unknown field 'displacemetn', did you mean 'displacement'?")
wrong("fabric.lab.reduce", "fabric.lab.reduce{ displacement=displacement_ }",
  "deck.lua:1: reduce: field 'displacement': expected a table of numbers in m, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.reduce", "fabric.lab.reduce{ displacement={1, 'two'} }",
  "deck.lua:1: reduce: field 'displacement': expected a table of numbers in m, got 'two' at place 2")
wrong("fabric.lab.reduce", "fabric.lab.reduce{ displacement={0.01, 0.01}, force={0.01, 0.01}, gauge_length='1' }",
  "deck.lua:1: reduce: field 'gauge_length': expected a positive number in m, got '1'")
wrong("fabric.lab.reduce", "fabric.lab.reduce{ displacement={0.01, 0.01}, force={0.01, 0.01}, gauge_length=-1 }",
  "deck.lua:1: reduce: field 'gauge_length': expected a positive number in m, got -1")
wrong("fabric.lab.reduce", "fabric.lab.reduce{ displacement={0.01, 0.01}, force={0.01, 0.01}, gauge_length=0.01, width=0.01, thickness=0.01, plies=2.5 }",
  "deck.lua:1: reduce: field 'plies': expected an integer of at least 1, got 2.5")

-- fabric.lab.shear_from_bias
wrong("fabric.lab.shear_from_bias", "fabric.lab.shear_from_bias{ markesr={} }",
  "deck.lua:1: shear_from_bias: unknown field 'markesr', did you mean 'markers'?")
wrong("fabric.lab.shear_from_bias", "fabric.lab.shear_from_bias{ markers=markers_ }",
  "deck.lua:1: shear_from_bias: field 'markers': expected a table, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.shear_from_bias", "fabric.lab.shear_from_bias{ markers=5 }",
  "deck.lua:1: shear_from_bias: field 'markers': expected a table, got 5")
wrong("fabric.lab.shear_from_bias", "fabric.lab.shear_from_bias{ markers={}, warp='1' }",
  "deck.lua:1: shear_from_bias: field 'warp': expected a number in degrees, got '1'")
wrong("fabric.lab.shear_from_bias", "fabric.lab.shear_from_bias{ markers={}, force={1, 'two'} }",
  "deck.lua:1: shear_from_bias: field 'force': expected a table of numbers in N, got 'two' at place 2")
wrong("fabric.lab.shear_from_bias", "fabric.lab.shear_from_bias{ markers={}, force={0.01, 0.01}, displacement={0.01, 0.01}, gauge_length=-1 }",
  "deck.lua:1: shear_from_bias: field 'gauge_length': expected a positive number in m, got -1")
wrong("fabric.lab.shear_from_bias", "fabric.lab.shear_from_bias{ markers={}, force={0.01, 0.01}, displacement={0.01, 0.01}, gauge_length=0.01, width=0.01, thickness=0.01, plies=2.5 }",
  "deck.lua:1: shear_from_bias: field 'plies': expected an integer of at least 1, got 2.5")

-- fabric.lab.synthetic
wrong("fabric.lab.synthetic", "fabric.lab.synthetic{ cadr=card }",
  "deck.lua:1: synthetic: unknown field 'cadr', did you mean 'card'?")
wrong("fabric.lab.synthetic", "fabric.lab.synthetic{ card=card_ }",
  "deck.lua:1: synthetic: field 'card': expected a card, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.synthetic", "fabric.lab.synthetic{ card='blend' }",
  "deck.lua:1: synthetic: field 'card': expected a card, got 'blend'")
wrong("fabric.lab.synthetic", "fabric.lab.synthetic{ card=card, direction='wapr' }",
  "deck.lua:1: synthetic: field 'direction': expected 'warp' or 'weft' or 'bias', got 'wapr', did you mean 'warp'?")
wrong("fabric.lab.synthetic", "fabric.lab.synthetic{ card=card, specimens=2.5 }",
  "deck.lua:1: synthetic: field 'specimens': expected an integer from 1 to 10000, got 2.5")
wrong("fabric.lab.synthetic", "fabric.lab.synthetic{ card=card, specimens=0 }",
  "deck.lua:1: synthetic: field 'specimens': expected an integer from 1 to 10000, got 0")
wrong("fabric.lab.synthetic", "fabric.lab.synthetic{ card=card, reach='1' }",
  "deck.lua:1: synthetic: field 'reach': expected a positive number, got '1'")
wrong("fabric.lab.synthetic", "fabric.lab.synthetic{ card=card, markers={1, 'two'} }",
  "deck.lua:1: synthetic: field 'markers': expected a table of numbers of at least 2, got 1 at place 1")

-- fabric.lab.tensile
wrong("fabric.lab.tensile", "fabric.lab.tensile{ record={ displacement={0, 1}, force={0, 1} }, gauge_length=1, width=1, thickness=1, plies=1, from_jaw='near' }",
  "deck.lua:1: tensile: field 'from_jaw': expected a number of at least 0 in m or a table of numbers of at least 0 in m, got 'near'")
wrong("fabric.lab.tensile", "fabric.lab.tensile{ record={ displacement={0, 1}, force={0, 1} }, gauge_length=1, width=1, thickness=1, plies=1, from_jaw={1, 2} }",
  "deck.lua:1: tensile: field 'from_jaw': expected a distance for each specimen, 1, got 2")
wrong("fabric.lab.tensile", "fabric.lab.tensile{ record={ displacement={0, 1}, force={0, 1} }, gauge_length=1, width=1, thickness=1, plies=1, from_jaw=1 }",
  "deck.lua:1: tensile: field 'from_jaw': expected a record that shows a break, this one does not fall below `kept` of its largest force and stay there")
wrong("fabric.lab.tensile", "fabric.lab.tensile{ fiel='x' }",
  "deck.lua:1: tensile: unknown field 'fiel', did you mean 'file'?")
wrong("fabric.lab.tensile", "fabric.lab.tensile{ file=7 }",
  "deck.lua:1: tensile: field 'file': expected a string, got 7")
wrong("fabric.lab.tensile", "fabric.lab.tensile{ record=5 }",
  "deck.lua:1: tensile: field 'record': expected a table {displacement=, force=}, got 5")
wrong("fabric.lab.tensile", "fabric.lab.tensile{ gauge_length=gauge_length_ }",
  "deck.lua:1: tensile: field 'gauge_length': expected a positive number in m, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.tensile", "fabric.lab.tensile{ gauge_length='1' }",
  "deck.lua:1: tensile: field 'gauge_length': expected a positive number in m, got '1'")
wrong("fabric.lab.tensile", "fabric.lab.tensile{ gauge_length=-1 }",
  "deck.lua:1: tensile: field 'gauge_length': expected a positive number in m, got -1")
wrong("fabric.lab.tensile", "fabric.lab.tensile{ gauge_length=0.01, width=0.01, thickness=0.01, plies=2.5 }",
  "deck.lua:1: tensile: field 'plies': expected an integer of at least 1, got 2.5")
wrong("fabric.lab.tensile", "fabric.lab.tensile{ gauge_length=0.01, width=0.01, thickness=0.01, plies=2, slack='noen' }",
  "deck.lua:1: tensile: field 'slack': expected a number in m or 'none' or 'contact', got 'noen', did you mean 'none'?")

wrong("fabric.lab.tensile", "fabric.lab.tensile{ vocabulary=5, gauge_length=0.1, width=0.01, thickness=0.001, plies=1 }",
  "deck.lua:1: tensile: field 'vocabulary': expected a table or a string, got 5")
wrong("fabric.lab.tensile", "fabric.lab.tensile{ gauge_length=0.1, width=0.01, thickness=0.001, plies=1, outliers='dorp' }",
  "deck.lua:1: tensile: field 'outliers': expected 'tell' or 'drop' or 'keep', got 'dorp', did you mean 'drop'?")

-- fabric.lab.track
wrong("fabric.lab.track", "fabric.lab.track{ filse={} }",
  "deck.lua:1: track: unknown field 'filse', did you mean 'files'?")
wrong("fabric.lab.track", "fabric.lab.track{ files=files_ }",
  "deck.lua:1: track: field 'files': expected a table, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.track", "fabric.lab.track{ files=5 }",
  "deck.lua:1: track: field 'files': expected a table, got 5")
wrong("fabric.lab.track", "fabric.lab.track{ files={}, rows=2.5 }",
  "deck.lua:1: track: field 'rows': expected an integer from 2 to 10000, got 2.5")
wrong("fabric.lab.track", "fabric.lab.track{ files={}, rows=1 }",
  "deck.lua:1: track: field 'rows': expected an integer from 2 to 10000, got 1")
wrong("fabric.lab.track", "fabric.lab.track{ files={}, rows=2, columns=2, scale='1' }",
  "deck.lua:1: track: field 'scale': expected a positive number in m, got '1'")
wrong("fabric.lab.track", "fabric.lab.track{ files={}, rows=2, columns=2, known=5 }",
  "deck.lua:1: track: field 'known': expected a table {from, to, distance}, got 5")
wrong("fabric.lab.track", "fabric.lab.track{ files={}, rows=2, columns=2, dark='yes' }",
  "deck.lua:1: track: field 'dark': expected true or false, got 'yes'")

-- fabric.lab.tracks
wrong("fabric.lab.tracks", "fabric.lab.tracks{ fiel='x' }",
  "deck.lua:1: tracks: unknown field 'fiel', did you mean 'file'?")
wrong("fabric.lab.tracks", "fabric.lab.tracks{ file=file_ }",
  "deck.lua:1: tracks: field 'file': expected a string, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.tracks", "fabric.lab.tracks{ file=7 }",
  "deck.lua:1: tracks: field 'file': expected a string, got 7")
wrong("fabric.lab.tracks", "fabric.lab.tracks{ file='x', rows=2.5 }",
  "deck.lua:1: tracks: field 'rows': expected an integer of at least 2, got 2.5")
wrong("fabric.lab.tracks", "fabric.lab.tracks{ file='x', rows=1 }",
  "deck.lua:1: tracks: field 'rows': expected an integer of at least 2, got 1")

-- records that cannot be
wrong("fabric.lab.density", "fabric.lab.density{ mas={1}, area=1, thickness={1} }",
  "deck.lua:1: density: unknown field 'mas', did you mean 'mass'?")
wrong("fabric.lab.tensile", "fabric.lab.tensile{ gauge_length=0.1, width=0.01, thickness=0.001, plies=1, zero='yes' }",
  "deck.lua:1: tensile: field 'zero': expected true or false, got 'yes'")
wrong("fabric.lab.tensile", "fabric.lab.tensile{ record={ displacement={0, 1e-3, 2e-3}, force={0, -1, -2} }, gauge_length=0.1, width=0.01, thickness=0.001, plies=1 }",
  "deck.lua:1: tensile: force runs from -2 to 0 N: a pull counts positive; change the sign of the record (reverse='force')")
wrong("fabric.lab.tensile", "fabric.lab.tensile{ gauge_length=0.1, width=0.01, thickness=0.001, plies=1 }",
  "deck.lua:1: tensile: field 'file': expected a file (or record: a table of displacement and force), got nil")
wrong("fabric.lab.tensile", "fabric.lab.tensile{ file='none.csv', gauge_length=0.1, width=0.01, thickness=0.001, plies=1 }",
  "deck.lua:1: table: cannot read 'none.csv': No such file or directory")
wrong("fabric.lab.reduce", "fabric.lab.reduce{ displacement={0, 1}, force={0}, gauge_length=0.1, width=0.01, thickness=0.001, plies=1 }",
  "deck.lua:1: reduce: field 'force': expected as many numbers as in 'displacement' (2), got 1")
wrong("fabric.lab.reduce", "fabric.lab.reduce{ displacement={0, 1}, force={0, 1}, gauge_length=0.1, width=0.01, thickness=0.001, plies=1, contact=5 }",
  "deck.lua:1: reduce: field 'contact': the force never rises above it")
wrong("fabric.lab.ratio", "fabric.lab.ratio{ rows=2, columns=2, x={1, 2}, y={1, 2} }",
  "deck.lua:1: ratio: field 'x': expected at least two frames of 4 markers, and as many y, got 2 and 2")
wrong("fabric.lab.photograph", "fabric.lab.photograph{ file='x.png', rows=2, columns=2, pitch=10, radius=6, width=100, height=100 }",
  "deck.lua:1: photograph: field 'radius': expected less than half of the pitch")

-- fabric.lab.correlate
wrong("fabric.lab.correlate", "fabric.lab.correlate{ filse={} }",
  "deck.lua:1: correlate: unknown field 'filse', did you mean 'files'?")
wrong("fabric.lab.correlate", "fabric.lab.correlate{ files=files_ }",
  "deck.lua:1: correlate: field 'files': expected a table, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.correlate", "fabric.lab.correlate{ files=5 }",
  "deck.lua:1: correlate: field 'files': expected a table, got 5")
wrong("fabric.lab.correlate", "fabric.lab.correlate{ files={ 'a.png' } }",
  "deck.lua:1: correlate: field 'files': expected at least two photographs")
wrong("fabric.lab.correlate", "fabric.lab.correlate{ files={}, region=5 }",
  "deck.lua:1: correlate: field 'region': expected a table {left, top, right, bottom}, got 5")
wrong("fabric.lab.correlate", "fabric.lab.correlate{ files={}, gauge=2.5 }",
  "deck.lua:1: correlate: field 'gauge': expected an integer from 3 to 99, got 2.5")
wrong("fabric.lab.correlate", "fabric.lab.correlate{ files={}, subset=3 }",
  "deck.lua:1: correlate: field 'subset': expected an integer from 9 to 301, got 3")
wrong("fabric.lab.correlate", "fabric.lab.correlate{ files={}, scale='1' }",
  "deck.lua:1: correlate: field 'scale': expected a positive number in m, got '1'")
wrong("fabric.lab.correlate", "fabric.lab.correlate{ files={}, scale=0 }",
  "deck.lua:1: correlate: field 'scale': expected a positive number in m, got 0")

-- fabric.lab.speckles
wrong("fabric.lab.speckles", "fabric.lab.speckles{ fiel='x' }",
  "deck.lua:1: speckles: unknown field 'fiel', did you mean 'file'?")
wrong("fabric.lab.speckles", "fabric.lab.speckles{ file=5 }",
  "deck.lua:1: speckles: field 'file': expected a string, got 5")
wrong("fabric.lab.speckles", "fabric.lab.speckles{ file='x.png', width=10 }",
  "deck.lua:1: speckles: field 'height': expected an integer from 1 to 30000, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.speckles", "fabric.lab.speckles{ file='x.png', width=10, height=10, seed=2.5 }",
  "deck.lua:1: speckles: field 'seed': expected an integer of at least 0, got 2.5")
wrong("fabric.lab.speckles", "fabric.lab.speckles{ file='x.png', width=10, height=10, seed=-1 }",
  "deck.lua:1: speckles: field 'seed': expected an integer of at least 0, got -1")
wrong("fabric.lab.speckles", "fabric.lab.speckles{ file='x.png', width=10, height=10, noise='1' }",
  "deck.lua:1: speckles: field 'noise': expected a number from 0 to 1, got '1'")
wrong("fabric.lab.speckles", "fabric.lab.speckles{ file='x.png', width=10, height=10, shift={1, 'two'} }",
  "deck.lua:1: speckles: field 'shift': expected a table of numbers in pixels, got 'two' at place 2")
wrong("fabric.lab.compare", "fabric.lab.compare({}, {}, { window='wide' })",
  "deck.lua:1: compare: field 'options.window': expected a positive number in s, got 'wide'")
wrong("fabric.lab.compare", "fabric.lab.compare({}, {}, { window=0 })",
  "deck.lua:1: compare: field 'options.window': expected a positive number in s, got 0")
