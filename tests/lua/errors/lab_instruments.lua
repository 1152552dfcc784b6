-- Wrong calls and their messages: lab instruments. Read by tests/lua/errors.lua.
-- fabric.lab.bias_shear
wrong("fabric.lab.bias_shear", "fabric.lab.bias_shear{ displacemetn={0.01, 0.01} }",
  "deck.lua:1: bias_shear: unknown field 'displacemetn', did you mean 'displacement'?")
wrong("fabric.lab.bias_shear", "fabric.lab.bias_shear{ displacement=displacement_ }",
  "deck.lua:1: bias_shear: field 'displacement': expected a table of numbers of at least 0 in m, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.bias_shear", "fabric.lab.bias_shear{ displacement={1, 'two'} }",
  "deck.lua:1: bias_shear: field 'displacement': expected a table of numbers of at least 0 in m, got 'two' at place 2")
wrong("fabric.lab.bias_shear", "fabric.lab.bias_shear{ displacement={-1} }",
  "deck.lua:1: bias_shear: field 'displacement': expected a table of numbers of at least 0 in m, got -1 at place 1")
wrong("fabric.lab.bias_shear", "fabric.lab.bias_shear{ displacement={0.01, 0.01}, force={0.01, 0.01}, width='1' }",
  "deck.lua:1: bias_shear: field 'width': expected a positive number in m, got '1'")

-- fabric.lab.fast
wrong("fabric.lab.fast", "fabric.lab.fast{ alogn={} }",
  "deck.lua:1: fast: unknown field 'alogn', did you mean 'along'?")
wrong("fabric.lab.fast", "fabric.lab.fast{ along=along_ }",
  "deck.lua:1: fast: field 'along': expected a table {stretch=, force=}, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.fast", "fabric.lab.fast{ along=5 }",
  "deck.lua:1: fast: field 'along': expected a table {stretch=, force=}, got 5")
wrong("fabric.lab.fast", "fabric.lab.fast{ along={}, bending_length='1' }",
  "deck.lua:1: fast: field 'bending_length': expected a positive number in m, got '1'")
wrong("fabric.lab.fast", "fabric.lab.fast{ along={}, bending_length=-1 }",
  "deck.lua:1: fast: field 'bending_length': expected a positive number in m, got -1")

-- fabric.lab.fast_card
wrong("fabric.lab.fast_card", "fabric.lab.fast_card{ naem='x' }",
  "deck.lua:1: fast_card: unknown field 'naem', did you mean 'name'?")
wrong("fabric.lab.fast_card", "fabric.lab.fast_card{ name=name_ }",
  "deck.lua:1: fast_card: field 'name': expected a string, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.fast_card", "fabric.lab.fast_card{ name=7 }",
  "deck.lua:1: fast_card: field 'name': expected a string, got 7")
wrong("fabric.lab.fast_card", "fabric.lab.fast_card{ name='x', thickness='1' }",
  "deck.lua:1: fast_card: field 'thickness': expected a positive number in m, got '1'")
wrong("fabric.lab.fast_card", "fabric.lab.fast_card{ name='x', thickness=-1 }",
  "deck.lua:1: fast_card: field 'thickness': expected a positive number in m, got -1")
wrong("fabric.lab.fast_card", "fabric.lab.fast_card{ name='x', thickness=0.01, density=500, warp=5 }",
  "deck.lua:1: fast_card: field 'warp': expected a table {E20=, E100=, B=}, got 5")

-- fabric.lab.kes_bending
wrong("fabric.lab.kes_bending", "fabric.lab.kes_bending{ curvatuer={0.01, 0.01} }",
  "deck.lua:1: kes_bending: unknown field 'curvatuer', did you mean 'curvature'?")
wrong("fabric.lab.kes_bending", "fabric.lab.kes_bending{ curvature=curvature_ }",
  "deck.lua:1: kes_bending: field 'curvature': expected a table of numbers in 1/m, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.kes_bending", "fabric.lab.kes_bending{ curvature={1, 'two'} }",
  "deck.lua:1: kes_bending: field 'curvature': expected a table of numbers in 1/m, got 'two' at place 2")
wrong("fabric.lab.kes_bending", "fabric.lab.kes_bending{ curvature={0.01, 0.01}, moment={0.01, 0.01}, at='1' }",
  "deck.lua:1: kes_bending: field 'at': expected a positive number in 1/m, got '1'")
wrong("fabric.lab.kes_bending", "fabric.lab.kes_bending{ curvature={0.01, 0.01}, moment={0.01, 0.01}, at=-1 }",
  "deck.lua:1: kes_bending: field 'at': expected a positive number in 1/m, got -1")

-- fabric.lab.kes_card
wrong("fabric.lab.kes_card", "fabric.lab.kes_card{ naem='x' }",
  "deck.lua:1: kes_card: unknown field 'naem', did you mean 'name'?")
wrong("fabric.lab.kes_card", "fabric.lab.kes_card{ name=name_ }",
  "deck.lua:1: kes_card: field 'name': expected a string, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.kes_card", "fabric.lab.kes_card{ name=7 }",
  "deck.lua:1: kes_card: field 'name': expected a string, got 7")
wrong("fabric.lab.kes_card", "fabric.lab.kes_card{ name='x', thickness='1' }",
  "deck.lua:1: kes_card: field 'thickness': expected a positive number in m, got '1'")
wrong("fabric.lab.kes_card", "fabric.lab.kes_card{ name='x', thickness=-1 }",
  "deck.lua:1: kes_card: field 'thickness': expected a positive number in m, got -1")
wrong("fabric.lab.kes_card", "fabric.lab.kes_card{ name='x', thickness=0.01, density=500, warp=5 }",
  "deck.lua:1: kes_card: field 'warp': expected a table {EMT=, WT=, RT=}, got 5")

-- fabric.lab.kes_shear
wrong("fabric.lab.kes_shear", "fabric.lab.kes_shear{ angel={0.01, 0.01} }",
  "deck.lua:1: kes_shear: unknown field 'angel', did you mean 'angle'?")
wrong("fabric.lab.kes_shear", "fabric.lab.kes_shear{ angle=angle_ }",
  "deck.lua:1: kes_shear: field 'angle': expected a table of numbers in degrees, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.kes_shear", "fabric.lab.kes_shear{ angle={1, 'two'} }",
  "deck.lua:1: kes_shear: field 'angle': expected a table of numbers in degrees, got 'two' at place 2")

-- fabric.lab.kes_tensile
wrong("fabric.lab.kes_tensile", "fabric.lab.kes_tensile{ strethc={0.01, 0.01} }",
  "deck.lua:1: kes_tensile: unknown field 'strethc', did you mean 'stretch'?")
wrong("fabric.lab.kes_tensile", "fabric.lab.kes_tensile{ stretch=stretch_ }",
  "deck.lua:1: kes_tensile: field 'stretch': expected a table of numbers, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.kes_tensile", "fabric.lab.kes_tensile{ stretch={1, 'two'} }",
  "deck.lua:1: kes_tensile: field 'stretch': expected a table of numbers, got 'two' at place 2")

-- fabric.lab.kilby
wrong("fabric.lab.kilby", "fabric.lab.kilby{ wapr=1000000 }",
  "deck.lua:1: kilby: unknown field 'wapr', did you mean 'warp'?")
wrong("fabric.lab.kilby", "fabric.lab.kilby{ warp=warp_ }",
  "deck.lua:1: kilby: field 'warp': expected a positive number in Pa, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.kilby", "fabric.lab.kilby{ warp='1' }",
  "deck.lua:1: kilby: field 'warp': expected a positive number in Pa, got '1'")
wrong("fabric.lab.kilby", "fabric.lab.kilby{ warp=-1 }",
  "deck.lua:1: kilby: field 'warp': expected a positive number in Pa, got -1")
wrong("fabric.lab.kilby", "fabric.lab.kilby{ warp=1000000, weft=1000000, nu12=0.01, nu21=0.01, reading='definitino' }",
  "deck.lua:1: kilby: field 'reading': expected 'definition' or 'printed', got 'definitino', did you mean 'definition'?")
