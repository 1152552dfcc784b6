-- Wrong calls and their messages: tests in which cloth breaks. Read by tests/lua/errors.lua.

-- fabric.lab.strip_rupture
wrong("fabric.lab.strip_rupture", "fabric.lab.strip_rupture{ card=card, state=7 }", "deck.lua:1: strip_rupture: field 'state': expected a table, got 7")
wrong("fabric.lab.strip_rupture", "fabric.lab.strip_rupture{ card=card, prepare=7 }",
  "deck.lua:1: strip_rupture: field 'prepare': expected a function, got 7")
wrong("fabric.lab.strip_rupture", "fabric.lab.strip_rupture{ card='blend' }",
  "deck.lua:1: strip_rupture: field 'card': expected a card, got 'blend'")
wrong("fabric.lab.strip_rupture", "fabric.lab.strip_rupture{  }",
  "deck.lua:1: strip_rupture: field 'card': expected a card, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.strip_rupture", "fabric.lab.strip_rupture{ frictoin=1 }",
  "deck.lua:1: strip_rupture: unknown field 'frictoin' (known: card yarn width length h ledger_limit speed damping coarse seed rows out prepare state)")
wrong("fabric.lab.strip_rupture", "fabric.lab.strip_rupture{ card=card, h='1' }",
  "deck.lua:1: strip_rupture: field 'h': expected a positive number in m, got '1'")
wrong("fabric.lab.strip_rupture", "fabric.lab.strip_rupture{ card=card, h=-1 }",
  "deck.lua:1: strip_rupture: field 'h': expected a positive number in m, got -1")
wrong("fabric.lab.strip_rupture", "fabric.lab.strip_rupture{ card=card, seed=1.5 }",
  "deck.lua:1: strip_rupture: field 'seed': expected an integer of at least 0, got 1.5")
wrong("fabric.lab.strip_rupture", "fabric.lab.strip_rupture{ card=card, coarse='rough' }",
  "deck.lua:1: strip_rupture: field 'coarse': expected 'lower' or 'refuse' or 'keep', got 'rough'")
wrong("fabric.lab.strip_rupture", "fabric.lab.strip_rupture{ card=card, out=7 }",
  "deck.lua:1: strip_rupture: field 'out': expected a string, got 7")
wrong("fabric.lab.strip_rupture", "fabric.lab.strip_rupture{ card=card }",
  "deck.lua:1: strip_rupture: field 'card': the card 'blend' does not say when its warp breaks: expected rupture.warp, as in card:with{ rupture={ warp={ strength=15e3, energy=20 } } }, with the force per width in N/m and the energy per metre of tear in J/m, measured or from the literature")

-- fabric.lab.grab
wrong("fabric.lab.grab", "fabric.lab.grab{ card=card, state=7 }", "deck.lua:1: grab: field 'state': expected a table, got 7")
wrong("fabric.lab.grab", "fabric.lab.grab{ card=card, prepare=7 }",
  "deck.lua:1: grab: field 'prepare': expected a function, got 7")
wrong("fabric.lab.grab", "fabric.lab.grab{ card='blend' }",
  "deck.lua:1: grab: field 'card': expected a card, got 'blend'")
wrong("fabric.lab.grab", "fabric.lab.grab{  }",
  "deck.lua:1: grab: field 'card': expected a card, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.grab", "fabric.lab.grab{ frictoin=1 }",
  "deck.lua:1: grab: unknown field 'frictoin' (known: card yarn width length jaw h ledger_limit speed damping coarse seed rows out prepare state)")
wrong("fabric.lab.grab", "fabric.lab.grab{ card=card, h='1' }",
  "deck.lua:1: grab: field 'h': expected a positive number in m, got '1'")
wrong("fabric.lab.grab", "fabric.lab.grab{ card=card, h=-1 }",
  "deck.lua:1: grab: field 'h': expected a positive number in m, got -1")
wrong("fabric.lab.grab", "fabric.lab.grab{ card=card, seed=1.5 }",
  "deck.lua:1: grab: field 'seed': expected an integer of at least 0, got 1.5")
wrong("fabric.lab.grab", "fabric.lab.grab{ card=card, coarse='rough' }",
  "deck.lua:1: grab: field 'coarse': expected 'lower' or 'refuse' or 'keep', got 'rough'")
wrong("fabric.lab.grab", "fabric.lab.grab{ card=card, out=7 }",
  "deck.lua:1: grab: field 'out': expected a string, got 7")
wrong("fabric.lab.grab", "fabric.lab.grab{ card=card }",
  "deck.lua:1: grab: field 'card': the card 'blend' does not say when its warp breaks: expected rupture.warp, as in card:with{ rupture={ warp={ strength=15e3, energy=20 } } }, with the force per width in N/m and the energy per metre of tear in J/m, measured or from the literature")
wrong("fabric.lab.grab", "fabric.lab.grab{ card=card:with{ rupture={ warp={ strength=1e4, energy=10 } } }, jaw=0.2 }",
  "deck.lua:1: grab: field 'jaw': expected jaws narrower than the specimen of 0.1 m, got 0.2 m")

-- fabric.lab.tear
wrong("fabric.lab.tear", "fabric.lab.tear{ card=card, state=7 }", "deck.lua:1: tear: field 'state': expected a table, got 7")
wrong("fabric.lab.tear", "fabric.lab.tear{ card=card, prepare=7 }",
  "deck.lua:1: tear: field 'prepare': expected a function, got 7")
wrong("fabric.lab.tear", "fabric.lab.tear{ card='blend' }",
  "deck.lua:1: tear: field 'card': expected a card, got 'blend'")
wrong("fabric.lab.tear", "fabric.lab.tear{  }",
  "deck.lua:1: tear: field 'card': expected a card, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.tear", "fabric.lab.tear{ frictoin=1 }",
  "deck.lua:1: tear: unknown field 'frictoin' (known: card method along h width leg short long cut tear ledger_limit speed damping coarse seed rows out prepare state)")
wrong("fabric.lab.tear", "fabric.lab.tear{ card=card, h='1' }",
  "deck.lua:1: tear: field 'h': expected a positive number in m, got '1'")
wrong("fabric.lab.tear", "fabric.lab.tear{ card=card, h=-1 }",
  "deck.lua:1: tear: field 'h': expected a positive number in m, got -1")
wrong("fabric.lab.tear", "fabric.lab.tear{ card=card, seed=1.5 }",
  "deck.lua:1: tear: field 'seed': expected an integer of at least 0, got 1.5")
wrong("fabric.lab.tear", "fabric.lab.tear{ card=card, coarse='rough' }",
  "deck.lua:1: tear: field 'coarse': expected 'lower' or 'refuse' or 'keep', got 'rough'")
wrong("fabric.lab.tear", "fabric.lab.tear{ card=card, out=7 }",
  "deck.lua:1: tear: field 'out': expected a string, got 7")
wrong("fabric.lab.tear", "fabric.lab.tear{ card=card }",
  "deck.lua:1: tear: field 'card': the card 'blend' does not say when its weft breaks: expected rupture.weft, as in card:with{ rupture={ weft={ strength=15e3, energy=20 } } }, with the force per width in N/m and the energy per metre of tear in J/m, measured or from the literature")

-- fabric.lab.ball_burst
wrong("fabric.lab.ball_burst", "fabric.lab.ball_burst{ card=card, state=7 }", "deck.lua:1: ball_burst: field 'state': expected a table, got 7")
wrong("fabric.lab.ball_burst", "fabric.lab.ball_burst{ card=card, prepare=7 }",
  "deck.lua:1: ball_burst: field 'prepare': expected a function, got 7")
wrong("fabric.lab.ball_burst", "fabric.lab.ball_burst{ card='blend' }",
  "deck.lua:1: ball_burst: field 'card': expected a card, got 'blend'")
wrong("fabric.lab.ball_burst", "fabric.lab.ball_burst{  }",
  "deck.lua:1: ball_burst: field 'card': expected a card, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.ball_burst", "fabric.lab.ball_burst{ frictoin=1 }",
  "deck.lua:1: ball_burst: unknown field 'frictoin', did you mean 'friction'?")
wrong("fabric.lab.ball_burst", "fabric.lab.ball_burst{ card=card, h='1' }",
  "deck.lua:1: ball_burst: field 'h': expected a positive number in m, got '1'")
wrong("fabric.lab.ball_burst", "fabric.lab.ball_burst{ card=card, h=-1 }",
  "deck.lua:1: ball_burst: field 'h': expected a positive number in m, got -1")
wrong("fabric.lab.ball_burst", "fabric.lab.ball_burst{ card=card, seed=1.5 }",
  "deck.lua:1: ball_burst: field 'seed': expected an integer of at least 0, got 1.5")
wrong("fabric.lab.ball_burst", "fabric.lab.ball_burst{ card=card, coarse='rough' }",
  "deck.lua:1: ball_burst: field 'coarse': expected 'lower' or 'refuse' or 'keep', got 'rough'")
wrong("fabric.lab.ball_burst", "fabric.lab.ball_burst{ card=card, out=7 }",
  "deck.lua:1: ball_burst: field 'out': expected a string, got 7")
wrong("fabric.lab.ball_burst", "fabric.lab.ball_burst{ card=card }",
  "deck.lua:1: ball_burst: field 'card': the card 'blend' does not say when its warp breaks: expected rupture.warp, as in card:with{ rupture={ warp={ strength=15e3, energy=20 } } }, with the force per width in N/m and the energy per metre of tear in J/m, measured or from the literature")

-- fabric.lab.impact
wrong("fabric.lab.impact", "fabric.lab.impact{ card=card, speed=1, state=7 }", "deck.lua:1: impact: field 'state': expected a table, got 7")
wrong("fabric.lab.impact", "fabric.lab.impact{ card=card, speed=1, prepare=7 }",
  "deck.lua:1: impact: field 'prepare': expected a function, got 7")
wrong("fabric.lab.impact", "fabric.lab.impact{ card='blend' }",
  "deck.lua:1: impact: field 'card': expected a card, got 'blend'")
wrong("fabric.lab.impact", "fabric.lab.impact{  }",
  "deck.lua:1: impact: field 'card': expected a card, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.impact", "fabric.lab.impact{ frictoin=1 }",
  "deck.lua:1: impact: unknown field 'frictoin', did you mean 'friction'?")
wrong("fabric.lab.impact", "fabric.lab.impact{ card=card, h='1' }",
  "deck.lua:1: impact: field 'h': expected a positive number in m, got '1'")
wrong("fabric.lab.impact", "fabric.lab.impact{ card=card, h=-1 }",
  "deck.lua:1: impact: field 'h': expected a positive number in m, got -1")
wrong("fabric.lab.impact", "fabric.lab.impact{ card=card, speed=1, seed=1.5 }",
  "deck.lua:1: impact: field 'seed': expected an integer of at least 0, got 1.5")
wrong("fabric.lab.impact", "fabric.lab.impact{ card=card, speed=1, coarse='rough' }",
  "deck.lua:1: impact: field 'coarse': expected 'lower' or 'refuse' or 'keep', got 'rough'")
wrong("fabric.lab.impact", "fabric.lab.impact{ card=card, speed=1, out=7 }",
  "deck.lua:1: impact: field 'out': expected a string, got 7")
wrong("fabric.lab.impact", "fabric.lab.impact{ card=card, speed=1 }",
  "deck.lua:1: impact: field 'card': the card 'blend' does not say when its warp breaks: expected rupture.warp, as in card:with{ rupture={ warp={ strength=15e3, energy=20 } } }, with the force per width in N/m and the energy per metre of tear in J/m, measured or from the literature")

-- fabric.lab.rupture
wrong("fabric.lab.rupture", "fabric.lab.rupture{  }",
  "deck.lua:1: rupture: field 'card': expected a card, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.rupture", "fabric.lab.rupture{ card=7 }",
  "deck.lua:1: rupture: field 'card': expected a card, got 7")
wrong("fabric.lab.rupture", "fabric.lab.rupture{ card=card, wrap={} }",
  "deck.lua:1: rupture: unknown field 'wrap', did you mean 'warp'?")
wrong("fabric.lab.rupture", "fabric.lab.rupture{ card=card }",
  "deck.lua:1: rupture: field 'warp': expected warp, weft or both, got neither")
wrong("fabric.lab.rupture", "fabric.lab.rupture{ card=card, warp=7 }",
  "deck.lua:1: rupture: field 'warp': expected a table {strips, width, tears, energy}, got 7")
wrong("fabric.lab.rupture", "fabric.lab.rupture{ card=card, warp={} }",
  "deck.lua:1: rupture: field 'warp.strips': expected a table, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.rupture", "fabric.lab.rupture{ card=card, warp={ strips={1}, width=-1, energy=2 } }",
  "deck.lua:1: rupture: field 'warp.width': expected a positive number in m, got -1")
wrong("fabric.lab.rupture", "fabric.lab.rupture{ card=card, warp={ strips={1}, width=0.05, energy='x' } }",
  "deck.lua:1: rupture: field 'warp.energy': expected a positive number in J/m, got 'x'")
wrong("fabric.lab.rupture", "fabric.lab.rupture{ card=card, warp={ strips={}, width=0.05, energy=1 } }",
  "deck.lua:1: rupture: field 'warp.strips': expected at least one strip, got none")
wrong("fabric.lab.rupture", "fabric.lab.rupture{ card=card, warp={ strips={-1}, width=0.05, energy=2 } }",
  "deck.lua:1: rupture: field 'warp.strips[1]': expected a positive force in N, got -1")
wrong("fabric.lab.rupture", "fabric.lab.rupture{ card=card, warp={ strips={1}, width=0.05 } }",
  "deck.lua:1: rupture: field 'warp': expected either tears (records or mean forces) or energy in J/m, got neither")
wrong("fabric.lab.rupture", "fabric.lab.rupture{ card=card, warp={ strips={ { force={1, 2} } }, width=1, energy=2 } }",
  "deck.lua:1: rupture: field 'warp.strips[1]': the force ends at 2 N of at most 2 N: expected a strip that was pulled until it broke")
wrong("fabric.lab.rupture", "fabric.lab.rupture{ card=card, warp={ strips={1}, width=0.05, tears={'x'} } }",
  "deck.lua:1: rupture: field 'warp.tears[1]': expected a mean force in N or a record { displacement=, force= }, got string")
wrong("fabric.lab.rupture", "fabric.lab.rupture{ card=card, warp={ strips={1}, width=0.05, tears={0} } }",
  "deck.lua:1: rupture: field 'warp.tears[1]': expected a positive force in N, got 0")
wrong("fabric.lab.rupture", "fabric.lab.rupture{ card=card, warp={ strips={1}, width=0.05, energy=1 }, source=7 }",
  "deck.lua:1: rupture: field 'source': expected a string, got 7")
wrong("fabric.lab.rupture", "fabric.lab.rupture{ card=card, warp={ strips={1}, width=0.05, energy=1 }, legs='no' }",
  "deck.lua:1: rupture: field 'legs': expected true or false, got 'no'")
