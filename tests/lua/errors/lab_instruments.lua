-- Wrong calls and their messages: lab instruments. Read by tests/lua/errors.lua.
-- fabric.lab.bias_shear
wrong("fabric.lab.bias_shear", "fabric.lab.bias_shear{ displacemetn={0.01, 0.01} }",
  "deck.lua:1: bias_shear: unknown field 'displacemetn', did you mean 'displacement'?")
wrong("fabric.lab.bias_shear", "fabric.lab.bias_shear{ displacement=displacement_ }",
  "deck.lua:1: bias_shear: field 'displacement': expected a table of numbers in m, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.bias_shear", "fabric.lab.bias_shear{ displacement={1, 'two'} }",
  "deck.lua:1: bias_shear: field 'displacement': expected a table of numbers in m, got 'two' at place 2")
wrong("fabric.lab.bias_shear", "fabric.lab.bias_shear{ displacement={-1, 0, 0.01}, force={0, 0, 1}, width=0.1, length=0.3, thickness=1e-3 }",
  "deck.lua:1: bias_shear: field 'displacement': expected numbers of at least 0 in m (noise of 1 % of the largest apart), got -1 at place 1")
wrong("fabric.lab.bias_shear", "fabric.lab.bias_shear{ displacement={0, 0.01}, force={0, 1}, width=0.1, length=0.3, thickness=1e-3, weft=5 }",
  "deck.lua:1: bias_shear: field 'weft': expected a table, got 5")
wrong("fabric.lab.bias_shear", "fabric.lab.bias_shear{ displacement={0.01, 0.01}, force={0.01, 0.01}, width='1' }",
  "deck.lua:1: bias_shear: field 'width': expected a positive number in m, got '1'")
wrong("fabric.lab.bias_shear", "fabric.lab.bias_shear{ displacement={10, 20}, force={1, 2}, width=0.1, length=0.3, thickness=1e-3 }",
  "deck.lua:1: bias_shear: field 'displacement': expected less than 0.08284 m, where the yarns lie along the pull, got 10 at place 1; is it in m?")
wrong("fabric.lab.bias_shear", "fabric.lab.bias_shear{ displacement={0.01}, force={1, 2}, width=0.1, length=0.3, thickness=1e-3 }",
  "deck.lua:1: bias_shear: field 'force': expected 1 numbers, one per displacement, got 2")

wrong("fabric.lab.bias_shear", "fabric.lab.bias_shear{ displacement={0.01, 0.02, 0.015}, force={1, 2, 1}, width=0.1, length=0.3, thickness=1e-3 }",
  "deck.lua:1: bias_shear: field 'displacement': expected rising values, got 0.015 m at place 3 after 0.02: end the record at the reversal, or give cut=true")
wrong("fabric.lab.bias_shear", "fabric.lab.bias_shear{ displacement={0.01}, force={1}, width=0.1, length=0.3, thickness=1e-3, limit=91 }",
  "deck.lua:1: bias_shear: field 'limit': expected a number above 0 to 90 in degrees, got 91")
wrong("fabric.lab.bias_shear", "fabric.lab.bias_shear{ displacement={0.01}, force={1}, width=0.1, length=0.3, thickness=1e-3, cut=1 }",
  "deck.lua:1: bias_shear: field 'cut': expected true or false, got 1")

wrong("fabric.lab.bias_shear", "fabric.lab.bias_shear{ displacement={0.01}, card='denim', width=0.1, length=0.3 }",
  "deck.lua:1: bias_shear: field 'card': expected a card, got 'denim'")
wrong("fabric.lab.bias_shear", "fabric.lab.bias_shear{ displacement={0.01}, width=0.1, length=0.3 }",
  "deck.lua:1: bias_shear: field 'force': expected either force or card")
wrong("fabric.lab.bias_shear", "fabric.lab.bias_shear{ displacement={0.01}, force={1}, width=0.1, length=0.3 }",
  "deck.lua:1: bias_shear: field 'thickness': expected a positive number in m, got nil")

-- fabric.lab.fast
wrong("fabric.lab.fast", "fabric.lab.fast{ alogn={} }",
  "deck.lua:1: fast: unknown field 'alogn', did you mean 'along'?")
wrong("fabric.lab.fast", "fabric.lab.fast{ along=along_ }",
  "deck.lua:1: fast: field 'along': expected a table {stretch, force}, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.fast", "fabric.lab.fast{ along=5 }",
  "deck.lua:1: fast: field 'along': expected a table {stretch, force}, got 5")
wrong("fabric.lab.fast", "fabric.lab.fast{ along={stretch={0, 0.1}, force={0, 100}}, bending_length='1' }",
  "deck.lua:1: fast: field 'bending_length': expected a positive number in m, got '1'")
wrong("fabric.lab.fast", "fabric.lab.fast{ along={stretch={0, 0.1}, force={0, 100}}, bending_length=-1 }",
  "deck.lua:1: fast: field 'bending_length': expected a positive number in m, got -1")
wrong("fabric.lab.fast", "fabric.lab.fast{ along={stretch={0, 0.1}} }",
  "deck.lua:1: fast: field 'along.force': expected a table of numbers in N/m, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.fast", "fabric.lab.fast{ along={stretch={0, 'two'}, force={0, 1}} }",
  "deck.lua:1: fast: field 'along.stretch': expected a table of numbers, got 'two' at place 2")
wrong("fabric.lab.fast", "fabric.lab.fast{ along={stretch={0, 0.1}, force={0, 50}} }",
  "deck.lua:1: fast: field 'along': expected a curve that passes 98.07 N/m")
wrong("fabric.lab.fast", "fabric.lab.fast{ along={stretch={0, 0.1}, force={0}} }",
  "deck.lua:1: fast: field 'along.force': expected 2 numbers, one per stretch, got 1")

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
  "deck.lua:1: fast_card: field 'warp': expected a table {E20, E100, B}, got 5")
wrong("fabric.lab.fast_card", "fabric.lab.fast_card{ name='x', thickness=4e-4, density=400, warp={E20=1, B=8}, weft={E20=1, E100=3, B=8}, EB5=4, poisson={warp=0.2, weft=0.2} }",
  "deck.lua:1: fast_card: field 'warp.E100': expected a positive number in per cent, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.fast_card", "fabric.lab.fast_card{ name='x', thickness=4e-4, density=400, warp={E20=1, E100=0.5, B=8}, weft={E20=1, E100=3, B=8}, EB5=4, poisson={warp=0.2, weft=0.2} }",
  "deck.lua:1: fast_card: field 'warp.E20': expected less than E100 (0.5), got 1")
wrong("fabric.lab.fast_card", "fabric.lab.fast_card{ name='x', thickness=4e-4, density=400, warp={E20=1, E100=3, B=8}, weft={E20=1, E100=3, B=8}, EB5=0.05, poisson={warp=0.2, weft=0.2} }",
  "deck.lua:1: fast_card: field 'EB5': expected more: the yarns alone stretch a bias strip further than 0.05 per cent")

-- fabric.lab.kes_bending
wrong("fabric.lab.kes_bending", "fabric.lab.kes_bending{ curvatuer={0.01, 0.01} }",
  "deck.lua:1: kes_bending: unknown field 'curvatuer', did you mean 'curvature'?")
wrong("fabric.lab.kes_bending", "fabric.lab.kes_bending{ curvature=curvature_ }",
  "deck.lua:1: kes_bending: field 'curvature': expected measured rows, or a card in their place, got neither")
wrong("fabric.lab.kes_bending", "fabric.lab.kes_bending{ curvature={1, 'two'} }",
  "deck.lua:1: kes_bending: field 'curvature': expected a table of numbers in 1/m, got 'two' at place 2")
wrong("fabric.lab.kes_bending", "fabric.lab.kes_bending{ curvature={0.01, 0.01}, moment={0.01, 0.01}, at='1' }",
  "deck.lua:1: kes_bending: field 'at': expected a positive number in 1/m, got '1'")
wrong("fabric.lab.kes_bending", "fabric.lab.kes_bending{ curvature={0.01, 0.01}, moment={0.01, 0.01}, at=-1 }",
  "deck.lua:1: kes_bending: field 'at': expected a positive number in 1/m, got -1")
wrong("fabric.lab.kes_bending", "fabric.lab.kes_bending{ curvature={0, 200, -200, 0}, moment={0, 1, -1, 0}, at=210 }",
  "deck.lua:1: kes_bending: field 'curvature': expected a cycle from 0 beyond 210 to the other side and back, got rows from -200 to 200")

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
  "deck.lua:1: kes_card: field 'warp': expected a table {EMT, WT, LT, RT}, got 5")
wrong("fabric.lab.kes_card", "fabric.lab.kes_card{ name='x', thickness=4e-4, density=400, warp={WT=9, RT=55}, weft={EMT=6, WT=13, RT=50}, shear={G=0.8}, poisson={warp=0.2, weft=0.2} }",
  "deck.lua:1: kes_card: field 'warp.EMT': expected a positive number in per cent, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.kes_card", "fabric.lab.kes_card{ name='x', thickness=4e-4, density=400, warp={EMT=4, WT=9}, weft={EMT=6, WT=13, RT=50}, shear={G=0.8}, poisson={warp=0.2, weft=0.2} }",
  "deck.lua:1: kes_card: field 'warp.RT': expected a number above 0 to 100 in per cent, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.kes_card", "fabric.lab.kes_card{ name='x', thickness=4e-4, density=400, warp={EMT=4, WT=9, RT=55}, weft={EMT=6, WT=13, RT=50}, shear={G=0.8}, poisson={warp=0.2, weft=0.2} }",
  "deck.lua:1: kes_card: field 'shear.2HG': expected a positive number in gf/cm, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.kes_card", "fabric.lab.kes_card{ name='x', thickness=4e-4, density=400, warp={EMT=4, WT=9, RT=55}, weft={EMT=6, WT=13, RT=50}, shear={G=0.8, ['2HG']=7}, poisson={warp=0.2, weft=0.2} }",
  "deck.lua:1: kes_card: field 'shear.2HG': expected below G times 8 degrees (6.4), got 7")
wrong("fabric.lab.kes_card", "fabric.lab.kes_card{ name='x', thickness=4e-4, density=400, warp={EMT=4, WT=9, RT=155}, weft={EMT=6, WT=13, RT=50}, shear={G=0.8}, poisson={warp=0.2, weft=0.2} }",
  "deck.lua:1: kes_card: field 'warp.RT': expected a number above 0 to 100 in per cent, got 155")

wrong("fabric.lab.kes_card", "fabric.lab.kes_card{ name='x', density=400, warp={EMT=4, WT=9, RT=55}, weft={EMT=6, WT=13, RT=50}, shear={G=0.8, ['2HG']=1}, poisson={warp=0.2, weft=0.2} }",
  "deck.lua:1: kes_card: field 'thickness': expected a positive number in m, or field 'T', got neither")
wrong("fabric.lab.kes_card", "fabric.lab.kes_card{ name='x', T=0.4, W=16, warp={EMT=4, RT=55}, weft={EMT=6, WT=13, RT=50}, shear={G=0.8, ['2HG']=1}, poisson={warp=0.2, weft=0.2} }",
  "deck.lua:1: kes_card: field 'warp.WT': expected WT in gf cm/cm^2, or LT, got neither")
wrong("fabric.lab.kes_card", "fabric.lab.kes_card{ name='x', T=0.4, W=16, warp={EMT=4, WT=9, LT=0.5, RT=55}, weft={EMT=6, WT=13, RT=50}, shear={G=0.8, ['2HG']=1}, poisson={warp=0.2, weft=0.2} }",
  "deck.lua:1: kes_card: field 'warp.LT': expected 0.9, as WT 9 and EMT 4 make it, got 0.5")
wrong("fabric.lab.kes_card", "fabric.lab.kes_card{ name='x', T=0.4, W=16, warp={EMT=4, LT=1.5, RT=90}, weft={EMT=6, WT=13, RT=50}, shear={G=0.8, ['2HG']=1}, poisson={warp=0.2, weft=0.2} }",
  "deck.lua:1: kes_card: field 'warp': no curve has the work of LT 1.5 and gives back RT of it: unloading would be softer than loading")

wrong("fabric.lab.kes_bending", "fabric.lab.kes_bending{ card='blend' }",
  "deck.lua:1: kes_bending: field 'card': expected a card, got 'blend'")
wrong("fabric.lab.kes_bending", "fabric.lab.kes_bending{ card=card, direction='wapr' }",
  "deck.lua:1: kes_bending: field 'direction': expected 'warp' or 'weft', got 'wapr', did you mean 'warp'?")
wrong("fabric.lab.kes_shear", "fabric.lab.kes_shear{ card='blend' }",
  "deck.lua:1: kes_shear: field 'card': expected a card, got 'blend'")
wrong("fabric.lab.kes_tensile", "fabric.lab.kes_tensile{ card='blend' }",
  "deck.lua:1: kes_tensile: field 'card': expected a card, got 'blend'")
wrong("fabric.lab.kes_tensile", "fabric.lab.kes_tensile{ card=card, direction='wapr' }",
  "deck.lua:1: kes_tensile: field 'direction': expected 'warp' or 'weft', got 'wapr', did you mean 'warp'?")
wrong("fabric.lab.kes_sheet", "fabric.lab.kes_sheet{ card=card_ }",
  "deck.lua:1: kes_sheet: field 'card': expected a card, got nil (missing, or a misspelt variable)")

-- fabric.lab.kes_sheet
wrong("fabric.lab.kes_sheet", "fabric.lab.kes_sheet{ crad=5 }",
  "deck.lua:1: kes_sheet: unknown field 'crad', did you mean 'card'?")
wrong("fabric.lab.kes_sheet", "fabric.lab.kes_sheet{ card=5 }",
  "deck.lua:1: kes_sheet: field 'card': expected a card, got 5")

-- fabric.lab.kes_shear
wrong("fabric.lab.kes_shear", "fabric.lab.kes_shear{ angel={0.01, 0.01} }",
  "deck.lua:1: kes_shear: unknown field 'angel', did you mean 'angle'?")
wrong("fabric.lab.kes_shear", "fabric.lab.kes_shear{ angle=angle_ }",
  "deck.lua:1: kes_shear: field 'angle': expected measured rows, or a card in their place, got neither")
wrong("fabric.lab.kes_shear", "fabric.lab.kes_shear{ angle={1, 'two'} }",
  "deck.lua:1: kes_shear: field 'angle': expected a table of numbers in degrees, got 'two' at place 2")
wrong("fabric.lab.kes_shear", "fabric.lab.kes_shear{ angle={0, 4, -4, 0}, force={0, 1, -1, 0} }",
  "deck.lua:1: kes_shear: field 'angle': expected a cycle from 0 beyond 5 to the other side and back, got rows from -4 to 4")
wrong("fabric.lab.kes_shear", "fabric.lab.kes_shear{ angle={0, 8, -8}, force={0, 1} }",
  "deck.lua:1: kes_shear: field 'force': expected 3 numbers, one per angle, got 2")

-- fabric.lab.kes_tensile
wrong("fabric.lab.kes_tensile", "fabric.lab.kes_tensile{ strethc={0.01, 0.01} }",
  "deck.lua:1: kes_tensile: unknown field 'strethc', did you mean 'stretch'?")
wrong("fabric.lab.kes_tensile", "fabric.lab.kes_tensile{ stretch=stretch_ }",
  "deck.lua:1: kes_tensile: field 'stretch': expected measured rows, or a card in their place, got neither")
wrong("fabric.lab.kes_tensile", "fabric.lab.kes_tensile{ stretch={1, 'two'} }",
  "deck.lua:1: kes_tensile: field 'stretch': expected a table of numbers, got 'two' at place 2")
wrong("fabric.lab.kes_tensile", "fabric.lab.kes_tensile{ stretch={0, 0.1}, force={0} }",
  "deck.lua:1: kes_tensile: field 'force': expected 2 numbers, one per stretch, got 1")
wrong("fabric.lab.kes_tensile", "fabric.lab.kes_tensile{ stretch={0, 0}, force={0, 0} }",
  "deck.lua:1: kes_tensile: field 'stretch': expected a pull up to a largest load and back")

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
wrong("fabric.lab.kilby", "fabric.lab.kilby{ warp=8e6, weft=8e6, nu12=0.2, nu21=0.2, bias=30e6 }",
  "deck.lua:1: kilby: field 'bias': expected less than 2e+07 Pa, where the yarns alone would hold the strip, got 3e+07")

-- fabric.lab.picture_frame
wrong("fabric.lab.picture_frame", "fabric.lab.picture_frame{ displacement={10, 20}, force={1, 2}, frame=0.2, cloth=0.15, thickness=1e-3 }",
  "deck.lua:1: picture_frame: field 'displacement': expected less than 0.1172 m, where the yarns lie along the pull, got 10 at place 1; is it in m?")
wrong("fabric.lab.picture_frame", "fabric.lab.picture_frame{ displacement={0.01, 0.02}, force={1}, frame=0.2, cloth=0.15, thickness=1e-3 }",
  "deck.lua:1: picture_frame: field 'force': expected 2 numbers, one per displacement, got 1")
