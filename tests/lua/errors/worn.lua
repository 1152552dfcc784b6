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
  "deck.lua:1: dress: unknown field 'wrong' (known: analysis at window still calm)")
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
wrong("fabric.lab.dress", "fabric.lab.dress{ analysis=run, at=0.5 }",
  "deck.lua:1: dress: the model has no contact: expected m:contact{ between={body, \"all\"} }")
