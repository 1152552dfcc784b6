-- model:tearable
wrong("model:tearable", "model:tearable()",
  "deck.lua:1: tearable: argument 'set': expected a string, got nil (missing, or a misspelt variable)")
wrong("model:tearable", "model:tearable(7)",
  "deck.lua:1: tearable: argument 'set': expected a string, got 7")
wrong("model:tearable", "model:tearable 'top'",
  "deck.lua:1: tearable: set 'top' holds no whole element")

-- analysis:cut
wrong("analysis:cut", "run:cut{ sett='all' }",
  "deck.lua:1: cut: unknown field 'sett', did you mean 'set'?")
wrong("analysis:cut", "run:cut{ set=7 }",
  "deck.lua:1: cut: field 'set': expected a string, got 7")
wrong("analysis:cut", "run:cut{ line=7 }",
  "deck.lua:1: cut: field 'line': expected a table, got 7")
wrong("analysis:cut", "run:cut{ line={ {0, 0, 0} } }",
  "deck.lua:1: cut: field 'line': expected two points {x, y, z} or more, got 1")
wrong("analysis:cut", "run:cut{ line={ {0, 0, 0}, {0, 'x', 0} } }",
  "deck.lua:1: cut: field 'line.2': expected a table of numbers in m, got 'x' at place 2")
wrong("analysis:cut", "run:cut{ set='all', line={ {0, 0, 0}, {1, 0, 0} } }",
  "deck.lua:1: cut: field 'set': expected the name of a set, or a line, got both")
wrong("analysis:cut", "run:cut{ set='all' }",
  "deck.lua:1: cut: the model has no tearable zone: expected m:tearable(set) before the run")

-- analysis:join
wrong("analysis:join", "run:join{ sett='all' }",
  "deck.lua:1: join: unknown field 'sett', did you mean 'set'?")
wrong("analysis:join", "run:join{ set=7 }",
  "deck.lua:1: join: field 'set': expected a string, got 7")
wrong("analysis:join", "run:join{ line='x' }",
  "deck.lua:1: join: field 'line': expected a table, got 'x'")
wrong("analysis:join", "run:join{ set='all', within='1' }",
  "deck.lua:1: join: field 'within': expected a number of at least 0 in m, got '1'")
wrong("analysis:join", "run:join{ set='all', within=-1 }",
  "deck.lua:1: join: field 'within': expected a number of at least 0 in m, got -1")
wrong("analysis:join", "run:join{ set='all' }",
  "deck.lua:1: join: the model has no tearable zone: expected m:tearable(set) before the run")

-- model:tearable, options
wrong("model:tearable", "model:tearable('all', { coarse='rough' })",
  "deck.lua:1: tearable: field 'options.coarse': expected 'lower' or 'refuse' or 'keep', got 'rough'")
wrong("model:tearable", "model:tearable('all', { seed=1.5 })",
  "deck.lua:1: tearable: field 'options.seed': expected an integer from 0 to 9.0072e+15, got 1.5")
wrong("model:tearable", "model:tearable('all', { path='nowhere' })",
  "deck.lua:1: tearable: unknown set 'nowhere'; known sets: all, bottom, boundary, corners, left, right, top")
wrong("model:tearable", "model:tearable('all', 7)",
  "deck.lua:1: tearable: argument 'options': expected a table {coarse, seed, path}, got 7")

-- model:strength
wrong("model:strength", "model:strength{ set=7 }",
  "deck.lua:1: strength: field 'set': expected a string, got 7")
wrong("model:strength", "model:strength{ factor='0.9' }",
  "deck.lua:1: strength: field 'factor': expected a positive number, got '0.9'")
wrong("model:strength", "model:strength{ modulus=-1 }",
  "deck.lua:1: strength: field 'modulus': expected a positive number, got -1")
wrong("model:strength", "model:strength{ seed=1.5 }",
  "deck.lua:1: strength: field 'seed': expected an integer from 0 to 9.0072e+15, got 1.5")
wrong("model:strength", "model:strength{ set='top' }",
  "deck.lua:1: strength: set 'top' holds no whole element")
wrong("model:strength", "model:strength{}",
  "deck.lua:1: strength: set 'all': expected elements of a card whose yarns soften (its field 'damage'), got none")
wrong("model:strength", "model:strength{ fctor=1 }",
  "deck.lua:1: strength: unknown field 'fctor', did you mean 'factor'?")
