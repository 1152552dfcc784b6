-- model:seam
wrong("model:seam", "model:seam()",
  "deck.lua:1: seam: argument 'seam': expected a table { first, second, ... }, got nil (missing, or a misspelt variable)")
wrong("model:seam", "model:seam 'top'",
  "deck.lua:1: seam: argument 'seam': expected a table { first, second, ... }, got 'top'")
wrong("model:seam", "model:seam{ over=1 }",
  "deck.lua:1: seam: argument 'seam': expected the names of two sets first, { \"front.left\", \"back.left\" }, got nil at 1")
wrong("model:seam", "model:seam{ 'left', 'right', 'top' }",
  "deck.lua:1: seam: argument 'seam': expected two names of sets and then named fields, got a further entry")
wrong("model:seam", "model:seam{ 'left', 'right', ove=1 }",
  "deck.lua:1: seam: unknown field 'seam.ove', did you mean 'seam.over'?")
wrong("model:seam", "model:seam{ 'left', 'right', over='1' }",
  "deck.lua:1: seam: field 'seam.over': expected a positive number in s, got '1'")
wrong("model:seam", "model:seam{ 'left', 'right', over=0 }",
  "deck.lua:1: seam: field 'seam.over': expected a positive number in s, got 0")
wrong("model:seam", "model:seam{ 'left', 'right', ease=0.7 }",
  "deck.lua:1: seam: field 'seam.ease': expected a number from 0 to below 0.5, got 0.7")
wrong("model:seam", "model:seam{ 'left', 'right', hinge='yes' }",
  "deck.lua:1: seam: field 'seam.hinge': expected true or false, got 'yes'")
wrong("model:seam", "model:seam{ 'left', 'rihgt' }",
  "deck.lua:1: seam: unknown set 'rihgt', did you mean 'right'? known sets: all, bottom, boundary, corners, left, right, top")
wrong("model:seam", "model:seam{ 'left', 'right', strength=100 }",
  "deck.lua:1: seam: field 'energy': expected strength (N/m) and energy (J/m) together, got one alone")
wrong("model:seam", "model:seam{ 'left', 'right', strength=100, energy=1, stiffness=1000 }",
  "deck.lua:1: seam: field 'energy': expected more than 5 J/m, which a seam of this stiffness stores at its strength, got 1")
wrong("model:seam", "fabric.static{ model=held:seam{ 'left', 'left' }, duration=1 }",
  "deck.lua:1: static: seam of 'left' and 'left': an edge cannot be sewn to itself: expected two edges")
wrong("model:seam", "fabric.static{ model=held:seam{ 'left', 'bottom', over=1 }, duration=1 }",
  "deck.lua:1: static: seam of 'left' and 'bottom': the edges are 0.0762 m and 0.0254 m long: expected lengths that differ by at most 1 % (field 'ease')")
wrong("model:seam", "fabric.static{ model=held:seam{ 'left', 'right' }, duration=1 }",
  "deck.lua:1: static: seam of 'left' and 'right': node 1 is 0.0254 m from where it belongs on the other edge: expected edges that lie on each other, or a time in which they are drawn together (field 'over', s)")
wrong("model:seam", "fabric.static{ model=held:seam{ 'left', 'right', over=1, reverse=true }, duration=1 }",
  "deck.lua:1: static: seam of 'left' and 'right': it is sewn the wrong way round, the lines between the ends cross: they are 0.0803219 m apart, and 0.0254 m with reverse=false\n"
  .. "         1 o-----------o 7    'left'\n            \\         /\n              \\     /\n                 X\n              /     \\\n            /         \\\n         2 o-----------o 8    'right'")
wrong("model:seam", "fabric.static{ model=held:seam{ 'left', 'all', over=1 }, duration=1 }",
  "deck.lua:1: static: seam of 'left' and 'all': set 'all' is a ring and the other is not: expected two lines or two rings")
wrong("model:seam", "fabric.static{ model=held:seam{ 'left', 'right', over=1 }:tie('equal', 'top', 'y'), duration=1 }",
  "deck.lua:1: static: seam of 'left' and 'right': node 7 is tied (set 'top'): expected edges of nodes that are not")
wrong("model:seam", "fabric.static{ model=held:seam{ 'left', 'right', over=1 }:tearable 'all', duration=1 }",
  "deck.lua:1: static: seam of 'left' and 'right': node 1 is in a tearable zone (set 'all'): expected edges of nodes that are not")

-- model:band
wrong("model:band", "model:band{ sett='left' }",
  "deck.lua:1: band: unknown field 'sett', did you mean 'set'?")
wrong("model:band", "model:band{ stiffness=10 }",
  "deck.lua:1: band: field 'set': expected a string, got nil (missing, or a misspelt variable)")
wrong("model:band", "model:band{ set=7, stiffness=10 }",
  "deck.lua:1: band: field 'set': expected a string, got 7")
wrong("model:band", "model:band{ set='left', stiffness='10' }",
  "deck.lua:1: band: field 'stiffness': expected a positive number in N, got '10'")
wrong("model:band", "model:band{ set='left', stiffness=0 }",
  "deck.lua:1: band: field 'stiffness': expected a positive number in N, got 0")
wrong("model:band", "model:band{ set='left', stiffness=10, ease=1 }",
  "deck.lua:1: band: field 'ease': expected a number from 0 to below 1, got 1")
