-- fabric.rigid.limb
wrong("fabric.rigid.limb", "fabric.rigid.limb{ wrong=1 }",
  "deck.lua:1: limb: unknown field 'wrong' (known: upper lower radii bend duration every joint from axis towards around size name)")
wrong("fabric.rigid.limb", "fabric.rigid.limb{}",
  "deck.lua:1: limb: field 'upper': expected a positive number in m, got nil (missing, or a misspelt variable)")
wrong("fabric.rigid.limb", "fabric.rigid.limb{ upper=-1, lower=0.2, radii={0.04, 0.04, 0.04} }",
  "deck.lua:1: limb: field 'upper': expected a positive number in m, got -1")
wrong("fabric.rigid.limb", "fabric.rigid.limb{ upper='long', lower=0.2, radii={0.04, 0.04, 0.04} }",
  "deck.lua:1: limb: field 'upper': expected a positive number in m, got 'long'")
wrong("fabric.rigid.limb", "fabric.rigid.limb{ upper=0.3, lower=0.2, radii=0.04 }",
  "deck.lua:1: limb: field 'radii': expected a table of numbers above 0 in m, got 0.04")
wrong("fabric.rigid.limb", "fabric.rigid.limb{ upper=0.3, lower=0.2, radii={0.04, -0.04, 0.04} }",
  "deck.lua:1: limb: field 'radii': expected a table of numbers above 0 in m, got -0.04 at place 2")
wrong("fabric.rigid.limb", "fabric.rigid.limb{ upper=0.3, lower=0.2, radii={0.04, 0.04, 0.04}, bend='much' }",
  "deck.lua:1: limb: field 'bend': expected a number in degrees or a function or a history, got 'much'")
wrong("fabric.rigid.limb", "fabric.rigid.limb{ upper=0.3, lower=0.2, radii={0.04, 0.04, 0.04}, duration=true }",
  "deck.lua:1: limb: field 'duration': expected a positive number in s, got true")
wrong("fabric.rigid.limb", "fabric.rigid.limb{ upper=0.3, lower=0.2, radii={0.04, 0.04, 0.04}, axis=5 }",
  "deck.lua:1: limb: field 'axis': expected a table of numbers, got 5")
wrong("fabric.rigid.limb", "fabric.rigid.limb{ upper=0.3, lower=0.2, radii={0.04, 0.04, 0.04}, around=1.5 }",
  "deck.lua:1: limb: field 'around': expected an integer of at least 8, got 1.5")
wrong("fabric.rigid.limb", "fabric.rigid.limb{ upper=0.3, lower=0.2, radii={0.04, 0.04, 0.04}, around=4 }",
  "deck.lua:1: limb: field 'around': expected an integer of at least 8, got 4")
wrong("fabric.rigid.limb", "fabric.rigid.limb{ upper=0.3, lower=0.2, radii={0.04, 0.04, 0.04}, name=5 }",
  "deck.lua:1: limb: field 'name': expected a string, got 5")

-- fabric.rigid.torso
wrong("fabric.rigid.torso", "fabric.rigid.torso{ wrong=1 }",
  "deck.lua:1: torso: unknown field 'wrong' (known: sections from axis towards around size name)")
wrong("fabric.rigid.torso", "fabric.rigid.torso{}",
  "deck.lua:1: torso: field 'sections': expected a table { {height, half width, half depth}, ... }, got nil (missing, or a misspelt variable)")
wrong("fabric.rigid.torso", "fabric.rigid.torso{ sections=5 }",
  "deck.lua:1: torso: field 'sections': expected a table { {height, half width, half depth}, ... }, got 5")
wrong("fabric.rigid.torso", "fabric.rigid.torso{ sections={ {0, 1, 1}, {1, 1, 1} }, from=5 }",
  "deck.lua:1: torso: field 'from': expected a table of numbers, got 5")
wrong("fabric.rigid.torso", "fabric.rigid.torso{ sections={ {0, 1, 1}, {1, 1, 1} }, around=2.5 }",
  "deck.lua:1: torso: field 'around': expected an integer of at least 8, got 2.5")
wrong("fabric.rigid.torso", "fabric.rigid.torso{ sections={ {0, 1, 1}, {1, 1, 1} }, around=3 }",
  "deck.lua:1: torso: field 'around': expected an integer of at least 8, got 3")
wrong("fabric.rigid.torso", "fabric.rigid.torso{ sections={ {0, 1, 1}, {1, 1, 1} }, size='fine' }",
  "deck.lua:1: torso: field 'size': expected a positive number in m, got 'fine'")
wrong("fabric.rigid.torso", "fabric.rigid.torso{ sections={ {0, 1, 1}, {1, 1, 1} }, name=5 }",
  "deck.lua:1: torso: field 'name': expected a string, got 5")

-- fabric.lab.dress
wrong("fabric.lab.dress", "fabric.lab.dress{ wrong=1 }",
  "deck.lua:1: dress: unknown field 'wrong' (known: analysis at window still calm state)")
wrong("fabric.lab.dress", "fabric.lab.dress{ analysis=5, at=1 }",
  "deck.lua:1: dress: field 'analysis': expected an analysis, got 5")
wrong("fabric.lab.dress", "fabric.lab.dress{ analysis=run }",
  "deck.lua:1: dress: field 'at': expected a positive number in s, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.dress", "fabric.lab.dress{ analysis=run, at='late' }",
  "deck.lua:1: dress: field 'at': expected a positive number in s, got 'late'")
wrong("fabric.lab.dress", "fabric.lab.dress{ analysis=run, at=-1 }",
  "deck.lua:1: dress: field 'at': expected a positive number in s, got -1")
wrong("fabric.lab.dress", "fabric.lab.dress{ analysis=run, at=2 }",
  "deck.lua:1: dress: field 'at': expected at most the duration of the run, 1 s, got 2 s")
wrong("fabric.lab.dress", "fabric.lab.dress{ analysis=run, at=0.5, window=0.6 }",
  "deck.lua:1: dress: field 'window': expected less than at= (0.5 s), got 0.6 s")
wrong("fabric.lab.dress", "fabric.lab.dress{ analysis=run, at=0.5, state='kept' }",
  "deck.lua:1: dress: field 'state': expected a table, got 'kept'")
wrong("fabric.lab.dress", "fabric.lab.dress{ analysis=run, at=0.5 }",
  "deck.lua:1: dress: the model has no contact: expected m:contact{ between={body, \"all\"} }")

-- fabric.lab.wear
local wear_body = "body=fabric.rigid.sphere{ radius=1, centre={0, 0, 0} }"
local function wear(rest, message) wrong("fabric.lab.wear", "fabric.lab.wear{ " .. rest .. " }", "deck.lua:1: wear: " .. message) end
wear("wrong=1", "unknown field 'wrong' (known: analysis body mesh times regions window samples patch state out)")
wear("analysis=5", "field 'analysis': expected an analysis, got 5")
wear("analysis=run", "field 'body': expected a body, got nil (missing, or a misspelt variable)")
wear("analysis=run, body=5", "field 'body': expected a body, got 5")
wear("analysis=run, " .. wear_body .. ", mesh=5", "field 'mesh': expected a mesh, got 5")
wear("analysis=run, " .. wear_body .. ", mesh=mesh, times=5", "field 'times': expected a table of numbers in s, got 5")
wear("analysis=run, " .. wear_body .. ", mesh=mesh, times={0.1, 0.2}, regions=5", "field 'regions': expected a table, got 5")
wear("analysis=run, " .. wear_body .. ", mesh=mesh, times={0.1, 0.2}, window='x'", "field 'window': expected a positive number in s, got 'x'")
wear("analysis=run, " .. wear_body .. ", mesh=mesh, times={0.1, 0.2}, window=-1", "field 'window': expected a positive number in s, got -1")
wear("analysis=run, " .. wear_body .. ", mesh=mesh, times={0.1, 0.2}, samples=1.5", "field 'samples': expected an integer of at least 1, got 1.5")
wear("analysis=run, " .. wear_body .. ", mesh=mesh, times={0.1, 0.2}, samples=0", "field 'samples': expected an integer of at least 1, got 0")
wear("analysis=run, " .. wear_body .. ", mesh=mesh, times={0.1, 0.2}, out=5", "field 'out': expected a string, got 5")
wear("analysis=run, " .. wear_body .. ", mesh=mesh, times={0.1}", "field 'times': expected where it begins and ends, two or more times, got 1")
wear("analysis=run, " .. wear_body .. ", mesh=mesh, times={0.1, 2}", "field 'times': expected at most the duration of the run, 1 s, got 2 s")

-- analysis:on_body
wrong("analysis:on_body", "run:on_body()",
  "deck.lua:1: on_body: argument 'body': expected a body, got nil (missing, or a misspelt variable)")
wrong("analysis:on_body", "run:on_body(5)",
  "deck.lua:1: on_body: argument 'body': expected a body, got 5")

-- fabric.lab.seam_strength
local function strength(rest, message) wrong("fabric.lab.seam_strength", "fabric.lab.seam_strength{ " .. rest .. " }", "deck.lua:1: seam_strength: " .. message) end
strength("crad=card", "unknown field 'crad', did you mean 'card'?")
strength("card=5", "field 'card': expected a card, got 5")
strength("card=card, energy=1", "field 'strength': expected a positive number in N/m, got nil (missing, or a misspelt variable)")
strength("card=card, strength='1', energy=1", "field 'strength': expected a positive number in N/m, got '1'")
strength("card=card, strength=-1, energy=1", "field 'strength': expected a positive number in N/m, got -1")
strength("card=card, strength=1, energy=1, method='grub'", "field 'method': expected 'strip' or 'grab', got 'grub', did you mean 'grab'?")
strength("card=card, strength=1, energy=1, rows=1.5", "field 'rows': expected an integer of at least 10, got 1.5")
strength("card=card, strength=1, energy=1, out=5", "field 'out': expected a string, got 5")
strength("card=card, strength=1, energy=1, prepare=5", "field 'prepare': expected a function, got 5")
strength("card=card, strength=1, energy=1, state=5", "field 'state': expected a table, got 5")
strength("card=card, strength=1, energy=1, method='grab', jaw=0.2", "field 'jaw': expected jaws narrower than the specimen of 0.1 m, got 0.2 m")

-- fabric.lab.seam_slippage
local function slippage(rest, message) wrong("fabric.lab.seam_slippage", "fabric.lab.seam_slippage{ " .. rest .. " }", "deck.lua:1: seam_slippage: " .. message) end
slippage("crad=card", "unknown field 'crad', did you mean 'card'?")
slippage("card=5", "field 'card': expected a card, got 5")
slippage("card=card", "field 'stiffness': expected a positive number in N/m^2, got nil (missing, or a misspelt variable)")
slippage("card=card, stiffness='1'", "field 'stiffness': expected a positive number in N/m^2, got '1'")
slippage("card=card, stiffness=-1", "field 'stiffness': expected a positive number in N/m^2, got -1")
slippage("card=card, stiffness=1, yarn='wrap'", "field 'yarn': expected 'warp' or 'weft', got 'wrap', did you mean 'warp'?")
slippage("card=card, stiffness=1, rows=1.5", "field 'rows': expected an integer of at least 10, got 1.5")
slippage("card=card, stiffness=1, prepare=5", "field 'prepare': expected a function, got 5")
slippage("card=card, stiffness=1, jaw=0.2", "field 'jaw': expected jaws narrower than the specimen of 0.1 m, got 0.2 m")

-- fabric.lab.tension_field
wrong("fabric.lab.tension_field", "fabric.lab.tension_field{ wrong=1 }",
  "deck.lua:1: tension_field: unknown field 'wrong' (known: card)")
wrong("fabric.lab.tension_field", "fabric.lab.tension_field{ card=5 }",
  "deck.lua:1: tension_field: field 'card': expected a card, got 5")
wrong("fabric.lab.tension_field", "fabric.lab.tension_field{}",
  "deck.lua:1: tension_field: field 'card': expected a card, got nil (missing, or a misspelt variable)")
