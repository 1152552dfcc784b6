-- Wrong calls and their messages: point. Read by tests/lua/errors.lua.
-- fabric.history
wrong("fabric.history", "fabric.history()",
  "deck.lua:1: history: argument 'points': expected a table { {t, v}, ... }, got nil (missing, or a misspelt variable)")
wrong("fabric.history", "fabric.history(5)",
  "deck.lua:1: history: argument 'points': expected a table { {t, v}, ... }, got 5")

-- fabric.point
wrong("fabric.point", "fabric.point()",
  "deck.lua:1: point: argument 'card': expected a card, got nil (missing, or a misspelt variable)")
wrong("fabric.point", "fabric.point('blend')",
  "deck.lua:1: point: argument 'card': expected a card, got 'blend'")

wrong("fabric.point", "fabric.point(card, -1)",
  "deck.lua:1: point: argument 'size': expected a positive number in m, got -1")

-- fabric.ramp
wrong("fabric.ramp", "fabric.ramp()",
  "deck.lua:1: ramp: argument 'value': expected a number, got nil (missing, or a misspelt variable)")
wrong("fabric.ramp", "fabric.ramp('1')",
  "deck.lua:1: ramp: argument 'value': expected a number, got '1'")
wrong("fabric.ramp", "fabric.ramp(0.01, -1)",
  "deck.lua:1: ramp: argument 'duration': expected a positive number in s, got -1")

-- history:value
wrong("history:value", "history:value()",
  "deck.lua:1: value: argument 'time': expected a number in s, got nil (missing, or a misspelt variable)")
wrong("history:value", "history:value('1')",
  "deck.lua:1: value: argument 'time': expected a number in s, got '1'")

-- point:bend
wrong("point:bend", "point:bend{ k1=5 }",
  "deck.lua:1: bend: unknown field 'k1', did you mean 'k11'?")
wrong("point:bend", "point:bend{ k11='1' }",
  "deck.lua:1: bend: field 'k11': expected a number in 1/m, got '1'")
wrong("point:bend", "point:bend{ k11=5 }",
  "deck.lua:1: bend: card 'blend': field 'bending': expected the card's own bending, {warp=, weft=, twist=} in N.m, got nil")

-- point:biaxial
wrong("point:biaxial", "point:biaxial()",
  "deck.lua:1: biaxial: argument 'ratio': expected a number, got nil (missing, or a misspelt variable)")
wrong("point:biaxial", "point:biaxial('1')",
  "deck.lua:1: biaxial: argument 'ratio': expected a number, got '1'")
wrong("point:biaxial", "point:biaxial(0.01, {1, 'two'})",
  "deck.lua:1: biaxial: argument 'E': expected a table of numbers, got 'two' at place 2")
wrong("point:biaxial", "point:biaxial(0.01, {0.01, 0.01}, 5)",
  "deck.lua:1: biaxial: argument 'columns': expected a table, got 5")

-- point:path
wrong("point:path", "point:path()",
  "deck.lua:1: path: argument 'strains': expected a table { {E11, E22, E12}, ... }, got nil (missing, or a misspelt variable)")
wrong("point:path", "point:path(5)",
  "deck.lua:1: path: argument 'strains': expected a table { {E11, E22, E12}, ... }, got 5")

-- point:strain
wrong("point:strain", "point:strain{ E11='1' }",
  "deck.lua:1: strain: field 'E11': expected a number above -0.5, got '1'")

-- strains that no deformation has
wrong("point:strain", "point:strain{ E11=-0.6 }",
  "deck.lua:1: strain: field 'E11': expected a number above -0.5, got -0.6")
wrong("point:strain", "point:strain{ E22=-0.5 }",
  "deck.lua:1: strain: field 'E22': expected a number above -0.5, got -0.5")
wrong("point:strain", "point:strain{ E11=0.1, E12=0.6 }",
  "deck.lua:1: strain: there is no such strain: E11 = 0.1, E22 = 0, E12 = 0.6 would make a length zero or less; expected E11 and E22 above -0.5 and (2 E12)^2 below (1 + 2 E11) (1 + 2 E22)")
wrong("point:path", "point:path{ {0.1, 0, 0}, {0, -0.7, 0} }",
  "deck.lua:1: path: argument 'strains.2': there is no such strain: E11 = 0, E22 = -0.7, E12 = 0 would make a length zero or less; expected E11 and E22 above -0.5 and (2 E12)^2 below (1 + 2 E11) (1 + 2 E22)")
wrong("point:biaxial", "point:biaxial(-7, {0.1})",
  "deck.lua:1: biaxial: there is no such strain: E11 = 0.1, E22 = -0.7000000000000001, E12 = 0 would make a length zero or less; expected E11 and E22 above -0.5 and (2 E12)^2 below (1 + 2 E11) (1 + 2 E22)")
wrong("point:uniaxial", "point:uniaxial('warp', -0.5)",
  "deck.lua:1: uniaxial: argument 'E': expected a number above -0.5 or a table of numbers above -0.5, got -0.5")

-- point:uniaxial
wrong("point:uniaxial", "point:uniaxial()",
  "deck.lua:1: uniaxial: argument 'direction': expected a number in degrees from the warp or 'warp' or 'weft', got nil (missing, or a misspelt variable)")
wrong("point:uniaxial", "point:uniaxial('wapr')",
  "deck.lua:1: uniaxial: argument 'direction': expected a number in degrees from the warp or 'warp' or 'weft', got 'wapr', did you mean 'warp'?")
wrong("point:uniaxial", "point:uniaxial(0.01, '1')",
  "deck.lua:1: uniaxial: argument 'E': expected a number above -0.5 or a table of numbers above -0.5, got '1'")
wrong("point:uniaxial", "point:uniaxial(0.01, 0.01, 5)",
  "deck.lua:1: uniaxial: argument 'columns': expected a table, got 5")

-- histories and points
wrong("fabric.history", "fabric.history{}",
  "deck.lua:1: history: expected at least one row {time, value}, got an empty table")
wrong("fabric.history", "fabric.history{ {0, 1}, {0, 2} }",
  "deck.lua:1: history: row 2: expected a time later than 0, got 0")
wrong("fabric.history", "fabric.history{ {0, 1, 2} }",
  "deck.lua:1: history: argument 'points[1]': expected {time, value}, got 3 numbers")
wrong("fabric.history", "fabric.history{ {0, 'x'} }",
  "deck.lua:1: history: argument 'points[1]': expected a table of numbers, got 'x' at place 2")
wrong("fabric.ramp", "fabric.ramp(1)",
  "deck.lua:1: ramp: argument 'duration': expected a positive number in s, got nil (missing, or a misspelt variable)")
wrong("fabric.ramp", "fabric.ramp(1, 2, 3)",
  "deck.lua:1: ramp: expected at most 2 arguments, got 3")
wrong("point:strain", "point:strain{ E1=0.1 }",
  "deck.lua:1: strain: unknown field 'E1', did you mean 'E11'?")
wrong("point:strain", "point:strain(0.1)",
  "deck.lua:1: strain: expected a table with named fields, got 0.1")
wrong("point:uniaxial", "point:uniaxial('warp', {0.1}, {'S13'})",
  "deck.lua:1: uniaxial: argument 'columns': unknown column 'S13', did you mean 'S11'?")
wrong("point:uniaxial", "point:uniaxial('warp', {0.1}, {})",
  "deck.lua:1: uniaxial: argument 'columns': expected at least one name, such as {\"S11\"}")
wrong("point:path", "point:path{ {0.1} }",
  "deck.lua:1: path: argument 'strains.1': expected {E11, E22, E12}, got 1 numbers")
wrong("point:path", "point:path{ E11={0.1, 0.2}, E22={0.1} }",
  "deck.lua:1: path: field 'strains.E22': expected as many strains as in the other components (2), got 1")
wrong("point:path", "point:path{ E13={0.1} }",
  "deck.lua:1: path: unknown field 'strains.E13', did you mean 'strains.E11'?")
wrong("point:strain", "point:strain{ E12=0.1, over=-1 }",
  "deck.lua:1: strain: field 'over': expected a number of at least 0 in s, got -1")
wrong("point:uniaxial", "point:uniaxial('warp', 0.1, nil, -1)",
  "deck.lua:1: uniaxial: argument 'over': expected a number of at least 0 in s, got -1")
wrong("point:path", "point:path{ {0, 0, 0.1, -1} }",
  "deck.lua:1: path: argument 'strains.1.4': expected 0 s or more for an increment, got -1")
wrong("point:path", "point:path{ E12={0.1}, over={-1} }",
  "deck.lua:1: path: argument 'strains.over.1': expected 0 s or more for an increment, got -1")
