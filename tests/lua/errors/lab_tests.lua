-- Wrong calls and their messages: lab tests. Read by tests/lua/errors.lua.
-- fabric.lab.bias
wrong("fabric.lab.bias", "fabric.lab.bias{ cadr=card }",
  "deck.lua:1: bias: unknown field 'cadr', did you mean 'card'?")
wrong("fabric.lab.bias", "fabric.lab.bias{ card=card_ }",
  "deck.lua:1: bias: field 'card': expected a card, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.bias", "fabric.lab.bias{ card='blend' }",
  "deck.lua:1: bias: field 'card': expected a card, got 'blend'")
wrong("fabric.lab.bias", "fabric.lab.bias{ card=card, angle='1' }",
  "deck.lua:1: bias: field 'angle': expected a number from 0 to 90 in degrees, got '1'")
wrong("fabric.lab.bias", "fabric.lab.bias{ card=card, angle=-1 }",
  "deck.lua:1: bias: field 'angle': expected a number from 0 to 90 in degrees, got -1")
wrong("fabric.lab.bias", "fabric.lab.bias{ card=card, grips='clampde' }",
  "deck.lua:1: bias: field 'grips': expected a table {lateral} or 'clamped' or 'free', got 'clampde', did you mean 'clamped'?")
wrong("fabric.lab.bias", "fabric.lab.bias{ card=card, path={1, 'two'} }",
  "deck.lua:1: bias: field 'path': expected a table of numbers, got 'two' at place 2")
wrong("fabric.lab.bias", "fabric.lab.bias{ card=card, unload='yes' }",
  "deck.lua:1: bias: field 'unload': expected true or false, got 'yes'")
wrong("fabric.lab.bias", "fabric.lab.bias{ card=card, out_of_plane='hedl' }",
  "deck.lua:1: bias: field 'out_of_plane': expected 'held' or 'free', got 'hedl', did you mean 'held'?")
wrong("fabric.lab.bias", "fabric.lab.bias{ card=card, stabilise='1' }",
  "deck.lua:1: bias: field 'stabilise': expected a number or true or false, got '1'")
wrong("fabric.lab.bias", "fabric.lab.bias{ card=card, steps=2.5 }",
  "deck.lua:1: bias: field 'steps': expected an integer of at least 2, got 2.5")
wrong("fabric.lab.bias", "fabric.lab.bias{ card=card, out=7 }",
  "deck.lua:1: bias: field 'out': expected a string, got 7")

-- fabric.lab.bias_extension
wrong("fabric.lab.bias_extension", "fabric.lab.bias_extension{ cadr=card }",
  "deck.lua:1: bias_extension: unknown field 'cadr', did you mean 'card'?")
wrong("fabric.lab.bias_extension", "fabric.lab.bias_extension{ card=card_ }",
  "deck.lua:1: bias_extension: field 'card': expected a card, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.bias_extension", "fabric.lab.bias_extension{ card='blend' }",
  "deck.lua:1: bias_extension: field 'card': expected a card, got 'blend'")
wrong("fabric.lab.bias_extension", "fabric.lab.bias_extension{ card=card, width='1' }",
  "deck.lua:1: bias_extension: field 'width': expected a positive number in m, got '1'")
wrong("fabric.lab.bias_extension", "fabric.lab.bias_extension{ card=card, width=-1 }",
  "deck.lua:1: bias_extension: field 'width': expected a positive number in m, got -1")
wrong("fabric.lab.bias_extension", "fabric.lab.bias_extension{ card=card, width=0.01, length=0.01, displacement=0.01, cells=2.5 }",
  "deck.lua:1: bias_extension: field 'cells': expected an integer of at least 1, got 2.5")

-- fabric.lab.biaxial
wrong("fabric.lab.biaxial", "fabric.lab.biaxial{ cadr=card }",
  "deck.lua:1: biaxial: unknown field 'cadr', did you mean 'card'?")
wrong("fabric.lab.biaxial", "fabric.lab.biaxial{ card=card_ }",
  "deck.lua:1: biaxial: field 'card': expected a card, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.biaxial", "fabric.lab.biaxial{ card='blend' }",
  "deck.lua:1: biaxial: field 'card': expected a card, got 'blend'")
wrong("fabric.lab.biaxial", "fabric.lab.biaxial{ card=card, displacement='1' }",
  "deck.lua:1: biaxial: field 'displacement': expected a positive number in m, got '1'")
wrong("fabric.lab.biaxial", "fabric.lab.biaxial{ card=card, displacement=-1 }",
  "deck.lua:1: biaxial: field 'displacement': expected a positive number in m, got -1")
wrong("fabric.lab.biaxial", "fabric.lab.biaxial{ card=card, path={1, 'two'} }",
  "deck.lua:1: biaxial: field 'path': expected a table of numbers, got 'two' at place 2")
wrong("fabric.lab.biaxial", "fabric.lab.biaxial{ card=card, cells=2.5 }",
  "deck.lua:1: biaxial: field 'cells': expected an integer of at least 1, got 2.5")
wrong("fabric.lab.biaxial", "fabric.lab.biaxial{ card=card, out=7 }",
  "deck.lua:1: biaxial: field 'out': expected a string, got 7")

-- fabric.lab.cantilever
wrong("fabric.lab.cantilever", "fabric.lab.cantilever{ cadr=card }",
  "deck.lua:1: cantilever: unknown field 'cadr', did you mean 'card'?")
wrong("fabric.lab.cantilever", "fabric.lab.cantilever{ card=card_ }",
  "deck.lua:1: cantilever: field 'card': expected a card, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.cantilever", "fabric.lab.cantilever{ card='blend' }",
  "deck.lua:1: cantilever: field 'card': expected a card, got 'blend'")
wrong("fabric.lab.cantilever", "fabric.lab.cantilever{ card=card, direction='wapr' }",
  "deck.lua:1: cantilever: field 'direction': expected a number in degrees or 'warp' or 'weft', got 'wapr', did you mean 'warp'?")
wrong("fabric.lab.cantilever", "fabric.lab.cantilever{ card=card, cells=2.5 }",
  "deck.lua:1: cantilever: field 'cells': expected an integer of at least 4, got 2.5")
wrong("fabric.lab.cantilever", "fabric.lab.cantilever{ card=card, cells=3 }",
  "deck.lua:1: cantilever: field 'cells': expected an integer of at least 4, got 3")
wrong("fabric.lab.cantilever", "fabric.lab.cantilever{ card=card, width='1' }",
  "deck.lua:1: cantilever: field 'width': expected a positive number in m, got '1'")
wrong("fabric.lab.cantilever", "fabric.lab.cantilever{ card=card, width=-1 }",
  "deck.lua:1: cantilever: field 'width': expected a positive number in m, got -1")

-- fabric.lab.drape
wrong("fabric.lab.drape", "fabric.lab.drape{ cadr=card }",
  "deck.lua:1: drape: unknown field 'cadr', did you mean 'card'?")
wrong("fabric.lab.drape", "fabric.lab.drape{ card=card_ }",
  "deck.lua:1: drape: field 'card': expected a card, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.drape", "fabric.lab.drape{ card='blend' }",
  "deck.lua:1: drape: field 'card': expected a card, got 'blend'")
wrong("fabric.lab.drape", "fabric.lab.drape{ card=card, cells=2.5 }",
  "deck.lua:1: drape: field 'cells': expected an integer of at least 4, got 2.5")
wrong("fabric.lab.drape", "fabric.lab.drape{ card=card, cells=3 }",
  "deck.lua:1: drape: field 'cells': expected an integer of at least 4, got 3")
wrong("fabric.lab.drape", "fabric.lab.drape{ card=card, size='1' }",
  "deck.lua:1: drape: field 'size': expected a positive number in m, got '1'")
wrong("fabric.lab.drape", "fabric.lab.drape{ card=card, scheme='explicti' }",
  "deck.lua:1: drape: field 'scheme': expected 'explicit' or 'implicit', got 'explicti', did you mean 'explicit'?")
wrong("fabric.lab.drape", "fabric.lab.drape{ card=card, force='yes' }",
  "deck.lua:1: drape: field 'force': expected true or false, got 'yes'")
wrong("fabric.lab.drape", "fabric.lab.drape{ card=card, out=7 }",
  "deck.lua:1: drape: field 'out': expected a string, got 7")

-- fabric.lab.mesh_error
wrong("fabric.lab.mesh_error", "fabric.lab.mesh_error{ rnu=print }",
  "deck.lua:1: mesh_error: unknown field 'rnu', did you mean 'run'?")
wrong("fabric.lab.mesh_error", "fabric.lab.mesh_error{ run=run_ }",
  "deck.lua:1: mesh_error: field 'run': expected a function, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.mesh_error", "fabric.lab.mesh_error{ run='f' }",
  "deck.lua:1: mesh_error: field 'run': expected a function, got 'f'")
wrong("fabric.lab.mesh_error", "fabric.lab.mesh_error{ run=print, print='yes' }",
  "deck.lua:1: mesh_error: field 'print': expected true or false, got 'yes'")

-- fabric.lab.picture_frame
wrong("fabric.lab.picture_frame", "fabric.lab.picture_frame{ displacemetn={0.01, 0.01} }",
  "deck.lua:1: picture_frame: unknown field 'displacemetn', did you mean 'displacement'?")
wrong("fabric.lab.picture_frame", "fabric.lab.picture_frame{ displacement=displacement_ }",
  "deck.lua:1: picture_frame: field 'displacement': expected a table of numbers in m, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.picture_frame", "fabric.lab.picture_frame{ displacement={1, 'two'} }",
  "deck.lua:1: picture_frame: field 'displacement': expected a table of numbers in m, got 'two' at place 2")
wrong("fabric.lab.picture_frame", "fabric.lab.picture_frame{ displacement={0.01, 0.01}, card='blend' }",
  "deck.lua:1: picture_frame: field 'card': expected a card, got 'blend'")
wrong("fabric.lab.picture_frame", "fabric.lab.picture_frame{ displacement={0.01, 0.01}, thickness='1' }",
  "deck.lua:1: picture_frame: field 'thickness': expected a positive number in m, got '1'")
wrong("fabric.lab.picture_frame", "fabric.lab.picture_frame{ displacement={0.01, 0.01}, thickness=-1 }",
  "deck.lua:1: picture_frame: field 'thickness': expected a positive number in m, got -1")

-- fabric.lab.poke
wrong("fabric.lab.poke", "fabric.lab.poke{ heigth=0.01 }",
  "deck.lua:1: poke: unknown field 'heigth', did you mean 'height'?")
wrong("fabric.lab.poke", "fabric.lab.poke{ height='1' }",
  "deck.lua:1: poke: field 'height': expected a number in m, got '1'")
wrong("fabric.lab.poke", "fabric.lab.poke{ stroke=-1 }",
  "deck.lua:1: poke: field 'stroke': expected a positive number in s, got -1")
wrong("fabric.lab.poke", "fabric.lab.poke{ card=card_ }",
  "deck.lua:1: poke: field 'card': expected a card, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.poke", "fabric.lab.poke{ card='blend' }",
  "deck.lua:1: poke: field 'card': expected a card, got 'blend'")
wrong("fabric.lab.poke", "fabric.lab.poke{ card=card, cells=2.5 }",
  "deck.lua:1: poke: field 'cells': expected an integer of at least 4, got 2.5")
wrong("fabric.lab.poke", "fabric.lab.poke{ card=card, scheme='explicti' }",
  "deck.lua:1: poke: field 'scheme': expected 'explicit' or 'implicit', got 'explicti', did you mean 'explicit'?")
wrong("fabric.lab.poke", "fabric.lab.poke{ card=card, force='yes' }",
  "deck.lua:1: poke: field 'force': expected true or false, got 'yes'")
wrong("fabric.lab.poke", "fabric.lab.poke{ card=card, out=7 }",
  "deck.lua:1: poke: field 'out': expected a string, got 7")

-- fabric.lab.shear
wrong("fabric.lab.shear", "fabric.lab.shear{ cadr=card }",
  "deck.lua:1: shear: unknown field 'cadr', did you mean 'card'?")
wrong("fabric.lab.shear", "fabric.lab.shear{ card=card_ }",
  "deck.lua:1: shear: field 'card': expected a card, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.shear", "fabric.lab.shear{ card='blend' }",
  "deck.lua:1: shear: field 'card': expected a card, got 'blend'")
wrong("fabric.lab.shear", "fabric.lab.shear{ card=card, E12='1' }",
  "deck.lua:1: shear: field 'E12': expected a positive number, got '1'")
wrong("fabric.lab.shear", "fabric.lab.shear{ card=card, E12=-1 }",
  "deck.lua:1: shear: field 'E12': expected a positive number, got -1")
wrong("fabric.lab.shear", "fabric.lab.shear{ card=card, path={1, 'two'} }",
  "deck.lua:1: shear: field 'path': expected a table of numbers, got 'two' at place 2")
wrong("fabric.lab.shear", "fabric.lab.shear{ card=card, sides='drivne' }",
  "deck.lua:1: shear: field 'sides': expected 'driven' or 'free', got 'drivne', did you mean 'driven'?")
wrong("fabric.lab.shear", "fabric.lab.shear{ card=card, cells=2.5 }",
  "deck.lua:1: shear: field 'cells': expected an integer of at least 1, got 2.5")
wrong("fabric.lab.shear", "fabric.lab.shear{ card=card, out=7 }",
  "deck.lua:1: shear: field 'out': expected a string, got 7")

-- fabric.lab.heart_loop
wrong("fabric.lab.heart_loop", "fabric.lab.heart_loop{ cadr=card }",
  "deck.lua:1: heart_loop: unknown field 'cadr', did you mean 'card'?")
wrong("fabric.lab.heart_loop", "fabric.lab.heart_loop{ card=card_ }",
  "deck.lua:1: heart_loop: field 'card': expected a card, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.heart_loop", "fabric.lab.heart_loop{ card='blend' }",
  "deck.lua:1: heart_loop: field 'card': expected a card, got 'blend'")
wrong("fabric.lab.heart_loop", "fabric.lab.heart_loop{ card=card, direction='wapr' }",
  "deck.lua:1: heart_loop: field 'direction': expected a number in degrees or 'warp' or 'weft', got 'wapr', did you mean 'warp'?")
wrong("fabric.lab.heart_loop", "fabric.lab.heart_loop{ card=card, cells=2.5 }",
  "deck.lua:1: heart_loop: field 'cells': expected an integer of at least 4, got 2.5")
wrong("fabric.lab.heart_loop", "fabric.lab.heart_loop{ card=card, cells=3 }",
  "deck.lua:1: heart_loop: field 'cells': expected an integer of at least 4, got 3")
wrong("fabric.lab.heart_loop", "fabric.lab.heart_loop{ card=card, width='1' }",
  "deck.lua:1: heart_loop: field 'width': expected a positive number in m, got '1'")
wrong("fabric.lab.heart_loop", "fabric.lab.heart_loop{ card=card, width=-1 }",
  "deck.lua:1: heart_loop: field 'width': expected a positive number in m, got -1")
wrong("fabric.lab.heart_loop", "fabric.lab.heart_loop{ card=card, direction=45 }",
  "deck.lua:1: heart_loop: field 'direction': expected warp or weft (0 or 90 degrees): off the yarns a loop twists out of its plane")

-- fabric.lab.twist
wrong("fabric.lab.twist", "fabric.lab.twist{ wrap=1e-5 }",
  "deck.lua:1: twist: unknown field 'wrap', did you mean 'warp'?")
wrong("fabric.lab.twist", "fabric.lab.twist{ warp=warp_, weft=1e-5, bias=1e-5 }",
  "deck.lua:1: twist: field 'warp': expected a positive number in N.m or a table of numbers above 0 in N.m, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.twist", "fabric.lab.twist{ warp='1', weft=1e-5, bias=1e-5 }",
  "deck.lua:1: twist: field 'warp': expected a positive number in N.m or a table of numbers above 0 in N.m, got '1'")
wrong("fabric.lab.twist", "fabric.lab.twist{ warp=-1, weft=1e-5, bias=1e-5 }",
  "deck.lua:1: twist: field 'warp': expected a positive number in N.m or a table of numbers above 0 in N.m, got -1")
wrong("fabric.lab.twist", "fabric.lab.twist{ warp=1e-5, weft=1e-5, bias=1e-5, simulate='yes' }",
  "deck.lua:1: twist: field 'simulate': expected true or false, got 'yes'")
wrong("fabric.lab.twist", "fabric.lab.twist{ warp={1e-5, -1}, weft=1e-5, bias=1e-5 }",
  "deck.lua:1: twist: field 'warp': expected a positive number in N.m or a table of numbers above 0 in N.m, got -1 at place 2")
wrong("fabric.lab.twist", "fabric.lab.twist{ warp=1e-5, weft={}, bias=1e-5 }",
  "deck.lua:1: twist: field 'weft': expected a positive number in N.m or a table of numbers above 0 in N.m, got an empty table")
wrong("fabric.lab.twist", "fabric.lab.twist{ warp=1e-5, weft=1e-5, bias=1e-5, common=-1 }",
  "deck.lua:1: twist: field 'common': expected a number of at least 0, got -1")
wrong("fabric.lab.twist", "fabric.lab.twist{ warp=1e-5, weft=1e-5, bias=1e-5, level=2 }",
  "deck.lua:1: twist: field 'level': expected a number above 0 to 1, got 2")
wrong("fabric.lab.twist", "fabric.lab.twist{ warp=1e-5, weft=1e-5, simulate=true }",
  "deck.lua:1: twist: field 'bias': expected a strip at 45 degrees, which simulate=true fits the twist to, got nil")

-- fabric.lab.uniaxial
wrong("fabric.lab.uniaxial", "fabric.lab.uniaxial{ cadr=card }",
  "deck.lua:1: uniaxial: unknown field 'cadr', did you mean 'card'?")
wrong("fabric.lab.uniaxial", "fabric.lab.uniaxial{ card=card_ }",
  "deck.lua:1: uniaxial: field 'card': expected a card, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.uniaxial", "fabric.lab.uniaxial{ card='blend' }",
  "deck.lua:1: uniaxial: field 'card': expected a card, got 'blend'")
wrong("fabric.lab.uniaxial", "fabric.lab.uniaxial{ card=card, direction='wapr' }",
  "deck.lua:1: uniaxial: field 'direction': expected a number in degrees or 'warp' or 'weft', got 'wapr', did you mean 'warp'?")
wrong("fabric.lab.uniaxial", "fabric.lab.uniaxial{ card=card, displacement='1' }",
  "deck.lua:1: uniaxial: field 'displacement': expected a positive number in m, got '1'")
wrong("fabric.lab.uniaxial", "fabric.lab.uniaxial{ card=card, displacement=-1 }",
  "deck.lua:1: uniaxial: field 'displacement': expected a positive number in m, got -1")
wrong("fabric.lab.uniaxial", "fabric.lab.uniaxial{ card=card, grips='clampde' }",
  "deck.lua:1: uniaxial: field 'grips': expected a table {lateral} or 'clamped' or 'free', got 'clampde', did you mean 'clamped'?")
wrong("fabric.lab.uniaxial", "fabric.lab.uniaxial{ card=card, path={1, 'two'} }",
  "deck.lua:1: uniaxial: field 'path': expected a table of numbers, got 'two' at place 2")
wrong("fabric.lab.uniaxial", "fabric.lab.uniaxial{ card=card, unload='yes' }",
  "deck.lua:1: uniaxial: field 'unload': expected true or false, got 'yes'")
wrong("fabric.lab.uniaxial", "fabric.lab.uniaxial{ card=card, out_of_plane='hedl' }",
  "deck.lua:1: uniaxial: field 'out_of_plane': expected 'held' or 'free', got 'hedl', did you mean 'held'?")
wrong("fabric.lab.uniaxial", "fabric.lab.uniaxial{ card=card, stabilise='1' }",
  "deck.lua:1: uniaxial: field 'stabilise': expected a number or true or false, got '1'")
wrong("fabric.lab.uniaxial", "fabric.lab.uniaxial{ card=card, steps=2.5 }",
  "deck.lua:1: uniaxial: field 'steps': expected an integer of at least 2, got 2.5")
wrong("fabric.lab.uniaxial", "fabric.lab.uniaxial{ card=card, out=7 }",
  "deck.lua:1: uniaxial: field 'out': expected a string, got 7")

-- tests that cannot be
wrong("fabric.lab.uniaxial", "fabric.lab.uniaxial{ card=card, grips='glued' }",
  "deck.lua:1: uniaxial: field 'grips': expected a table {lateral} or 'clamped' or 'free', got 'glued'")
wrong("fabric.lab.uniaxial", "fabric.lab.uniaxial{ card=card, direction=30 }",
  "deck.lua:1: uniaxial: field 'displacement': expected a positive number in m (the card states no tested strain here), got nil")
wrong("fabric.lab.bias", "fabric.lab.bias{ card=card, angle=90 }",
  "deck.lua:1: bias: field 'angle': expected degrees between 0 and 90 (fabric.lab.uniaxial pulls along yarns), got 90")
wrong("fabric.lab.shear", "fabric.lab.shear{ card=card:with{ tested={shear=0} } }",
  "deck.lua:1: shear: field 'E12': expected a positive number (the card states no tested shear), got 0.0")
