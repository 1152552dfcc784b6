-- model:gas
wrong("model:gas", "model:gas{ sett='all' }",
  "deck.lua:1: gas: unknown field 'sett', did you mean 'set'?")
wrong("model:gas", "model:gas{ set=7 }",
  "deck.lua:1: gas: field 'set': expected a table or a string, got 7")
wrong("model:gas", "model:gas{ set={} }",
  "deck.lua:1: gas: field 'set': expected the name of a set, or a list, got an empty one")
wrong("model:gas", "model:gas{ set={ 'all', 7 } }",
  "deck.lua:1: gas: field 'set': expected names of sets, got 7 at place 2")
wrong("model:gas", "model:gas{ set={ 'all', fabric.rigid.plane{ point={0, 0, 1}, normal={0, 0, -1} } } }",
  "deck.lua:1: gas: field 'set': expected names of sets, got a body at place 2: a body closes a hole as one of lids=")
wrong("model:gas", "model:gas{ lids={ 'boundary', 7 } }",
  "deck.lua:1: gas: field 'lids': expected names of sets or rigid bodies, got 7 at place 2")
wrong("model:gas", "model:gas{ lids=fabric.rigid.plane{ point={0, 0, 0.02}, normal={0, 0, -1} } }; fabric.static{ model=model, duration=1 }",
  "deck.lua:1: static: gas of set 'all': the surface has a hole, 0.2032 m round, at (0.0127, 0.0381, 0) m, along the nodes 1, 2, 4, 6, 8, 7, ... of set 'boundary'; "
  .. "the plane is 0.02 m away from its node 1, at (0, 0, 0) m, expected at most 0.00254 m: "
  .. "expected a surface that closes, a seam along the hole, or something that closes it, lids='boundary'")
wrong("model:gas", "model:gas{ set='top' }",
  "deck.lua:1: gas: field 'set': set 'top' holds no whole element")
wrong("model:gas", "model:gas{ lids=7 }",
  "deck.lua:1: gas: field 'lids': expected a table or a string or a body, got 7")
wrong("model:gas", "model:gas{ lids='rim' }",
  "deck.lua:1: gas: unknown set 'rim'; known sets: all, bottom, boundary, corners, left, right, top")
wrong("model:gas", "model:gas{ initial='1' }",
  "deck.lua:1: gas: field 'initial': expected a number in Pa, got '1'")
wrong("model:gas", "model:gas{ initial=-2e5 }",
  "deck.lua:1: gas: field 'initial': expected a pressure above that of a vacuum, Pa, from -outside on, got -200000")
wrong("model:gas", "model:gas{ mass=0 }",
  "deck.lua:1: gas: field 'mass': expected a positive number in kg, got 0")
wrong("model:gas", "model:gas{ mass=0.1, initial=100 }",
  "deck.lua:1: gas: field 'mass': the mass determines the pressure: expected mass= or initial=, got both")
wrong("model:gas", "model:gas{ temperature=-20 }",
  "deck.lua:1: gas: field 'temperature': expected a positive number in K, got -20")
wrong("model:gas", "model:gas{ gas='helum' }",
  "deck.lua:1: gas: field 'gas': expected a table {molar, cp} or 'air', got 'helum'")
wrong("model:gas", "model:gas{ gas={ molar=0.004 } }",
  "deck.lua:1: gas: field 'gas.cp': expected a positive number in J/(kg K), got nil (missing, or a misspelt variable)")
wrong("model:gas", "model:gas{ gas={ molar=0.004, cp=900 } }",
  "deck.lua:1: gas: field 'gas.cp': expected more than the gas constant over the molar mass, J/(kg K), got 900")
wrong("model:gas", "model:gas{ gas=7 }",
  "deck.lua:1: gas: field 'gas': expected a table {molar, cp} or 'air', got 7")
wrong("model:gas", "model:gas{ exponent=0.9 }",
  "deck.lua:1: gas: field 'exponent': expected a number from 1 to 1.66667, got 0.9")
wrong("model:gas", "model:gas{ outside=0 }",
  "deck.lua:1: gas: field 'outside': expected a positive number in Pa, got 0")
wrong("model:gas", "model:gas{ inflow='all' }",
  "deck.lua:1: gas: field 'inflow': expected a number in kg/s or a table { {time, kg/s}, ... } or a function or a history, got 'all'")
wrong("model:gas", "model:gas{ inflow={ {0, 0}, {1} } }",
  "deck.lua:1: gas: field 'inflow[2]': expected {time, value}, got 1 numbers")
wrong("model:gas", "model:gas{ inflow=card }",
  "deck.lua:1: gas: field 'inflow': expected a number in kg/s or a table { {time, kg/s}, ... } or a function or a history, got a card")
wrong("model:gas", "model:gas{ vents=7 }",
  "deck.lua:1: gas: field 'vents': expected a table { {set=|area=, coefficient=0.6, to=?, opens=?}, ... }, got 7")
wrong("model:gas", "model:gas{ vents={} }",
  "deck.lua:1: gas: field 'vents': expected a list { {set=|area=, coefficient=?, to=?, opens=?}, ... }, got no entry")
wrong("model:gas", "model:gas{ vents={ 'all' } }",
  "deck.lua:1: gas: field 'vents': expected a list { {set=|area=, coefficient=?, to=?, opens=?}, ... }, got 'all' at place 1")
wrong("model:gas", "model:gas{ vents={ { sett='all' } } }",
  "deck.lua:1: gas: unknown field 'vents[1].sett', did you mean 'vents[1].set'?")
wrong("model:gas", "model:gas{ vents={ { coefficient=0.5 } } }",
  "deck.lua:1: gas: field 'vents': expected either a set or an area of each, got neither")
wrong("model:gas", "model:gas{ vents={ { set='all', area=1 } } }",
  "deck.lua:1: gas: field 'vents': expected either a set or an area of each, got both")
wrong("model:gas", "model:gas{ vents={ { area=-1 } } }",
  "deck.lua:1: gas: field 'vents[1].area': expected a positive number in m2, got -1")
wrong("model:gas", "model:gas{ vents={ { area=1, to='outside' } } }",
  "deck.lua:1: gas: field 'vents[1].to': expected a gas, got 'outside'")
wrong("model:gas", "model:gas{ vents={ { set='top' } } }",
  "deck.lua:1: gas: field 'vents': set 'top' holds no whole element")
wrong("model:gas", "model:gas{ leakage='air' }",
  "deck.lua:1: gas: field 'leakage': expected a number or a table of numbers or a function, got 'air'")
wrong("model:gas", "model:gas{ leakage=-1 }",
  "deck.lua:1: gas: field 'leakage': expected 0 or more, m/s, got -1")
wrong("model:gas", "model:gas{ leakage={ 0.1 } }",
  "deck.lua:1: gas: field 'leakage': expected {m/s, Pa}: a speed of 0 or more and the positive pressure at which it is, got 1 number")
wrong("model:gas", "model:gas{}; fabric.static{ model=model, duration=1 }",
  "deck.lua:1: static: gas of set 'all': the surface has a hole, 0.2032 m round, at (0.0127, 0.0381, 0) m, along the nodes 1, 2, 4, 6, 8, 7, ... of set 'boundary': expected a surface that closes, a seam along the hole, or something that closes it, lids='boundary'")
wrong("model:gas", "model:gas{ lids='boundary' }; fabric.static{ model=model, duration=1 }",
  "deck.lua:1: static: gas of set 'all': the surface encloses nothing, 0 m3 with 0.00387096 m2: expected a volume at the start, as between sheets that lie apart")
wrong("model:gas", "model:gas{ lids='boundary' }; model:tearable 'all'; fabric.static{ model=model, duration=1 }",
  "deck.lua:1: static: gas of set 'all': element 1 is in the tearable zone 'all': expected a surface that stays closed")
wrong("model:gas", "model:gas{ exponent='adiabatic' }",
  "deck.lua:1: gas: field 'exponent': expected a number from 1 to 1.66667, got 'adiabatic'")
wrong("model:gas", "model:gas{ vents={ { area=1, opens=0 } } }",
  "deck.lua:1: gas: field 'vents[1].opens': expected a positive number in Pa, got 0")
wrong("model:gas", "model:gas{ leakage=card }",
  "deck.lua:1: gas: field 'leakage': expected a number or a table of numbers or a function, got a card")

-- analysis:gas
wrong("analysis:gas", "run:gas()",
  "deck.lua:1: gas: argument 'gas': expected a gas, got nil (missing, or a misspelt variable)")
wrong("analysis:gas", "run:gas 'all'",
  "deck.lua:1: gas: argument 'gas': expected a gas, got 'all'")
wrong("analysis:gas", "run:gas(card)",
  "deck.lua:1: gas: argument 'gas': expected a gas, got a card")
wrong("analysis:gas", "local other = fabric.model{ mesh=mesh, card=card, warp=90 }; run:gas(other:gas{ lids='boundary' })",
  "deck.lua:1: gas: the model of this run has no gas volume: expected one declared with m:gas")
