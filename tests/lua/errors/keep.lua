-- Wrong calls and their messages: what outlives a run. Read by tests/lua/errors.lua.
-- analysis:checkpoint
wrong("analysis:checkpoint", "run:checkpoint()",
  "deck.lua:1: checkpoint: argument 'path': expected a string, got nil (missing, or a misspelt variable)")
wrong("analysis:checkpoint", "run:checkpoint(7)",
  "deck.lua:1: checkpoint: argument 'path': expected a string, got 7")
wrong("analysis:checkpoint", "run:checkpoint('x', 5)",
  "deck.lua:1: checkpoint: argument 'options': expected a table {every, minutes, keep}, got 5")
wrong("analysis:checkpoint", "run:checkpoint('x', { every='stpe' })",
  "deck.lua:1: checkpoint: field 'options.every': expected a positive number in s or 'step', got 'stpe', did you mean 'step'?")
wrong("analysis:checkpoint", "run:checkpoint('x', { minutes='1' })",
  "deck.lua:1: checkpoint: field 'options.minutes': expected a positive number in min, got '1'")
wrong("analysis:checkpoint", "run:checkpoint('x', { minutes=0 })",
  "deck.lua:1: checkpoint: field 'options.minutes': expected a positive number in min, got 0")
wrong("analysis:checkpoint", "run:checkpoint('x', { keep=5 })",
  "deck.lua:1: checkpoint: field 'options.keep': expected a table, got 5")
wrong("analysis:checkpoint", "run:checkpoint('x', { keep={ hits={ 1, { f=print } } } })",
  "deck.lua:1: checkpoint: field 'keep.hits[2].f': expected a number, text, boolean or table, which can be kept, got a function")

-- analysis:restart
wrong("analysis:restart", "run:restart()",
  "deck.lua:1: restart: argument 'path': expected a string, got nil (missing, or a misspelt variable)")
wrong("analysis:restart", "run:restart(7)",
  "deck.lua:1: restart: argument 'path': expected a string, got 7")
wrong("analysis:restart", "run:restart('no-such-file')",
  "deck.lua:1: restart: cannot read 'no-such-file': No such file or directory")

-- analysis:set
wrong("analysis:set", "run:set{ tolerence=1 }",
  "deck.lua:1: set: unknown field 'tolerence', did you mean 'tolerance'?")
wrong("analysis:set", "run:set{ tolerance='1' }",
  "deck.lua:1: set: field 'tolerance': expected a number above 0 to below 1, got '1'")
wrong("analysis:set", "run:set{ tolerance=2 }",
  "deck.lua:1: set: field 'tolerance': expected a number above 0 to below 1, got 2")
wrong("analysis:set", "run:set{ step='1' }",
  "deck.lua:1: set: field 'step': expected a positive number in s, got '1'")
wrong("analysis:set", "run:set{ max_iterations='1' }",
  "deck.lua:1: set: field 'max_iterations': expected an integer of at least 1, got '1'")

-- fabric.dynamic
wrong("fabric.dynamic", "fabric.dynamic{ model=held, duration=1, tolerance=1e-6 }",
  "deck.lua:1: dynamic: field 'tolerance': unknown for scheme=\"explicit\", which does not iterate")
wrong("fabric.dynamic", "fabric.dynamic{ model=held, duration=1, max_iterations=9 }",
  "deck.lua:1: dynamic: field 'max_iterations': unknown for scheme=\"explicit\", which does not iterate")
wrong("fabric.dynamic", "fabric.dynamic{ model=held, duration=1, line_search=true }",
  "deck.lua:1: dynamic: field 'line_search': unknown for scheme=\"explicit\", which does not iterate")
wrong("fabric.dynamic", "fabric.dynamic{ model=held, duration=1, scheme='implicit', line_search='yes' }",
  "deck.lua:1: dynamic: field 'line_search': expected true or false, got 'yes'")
