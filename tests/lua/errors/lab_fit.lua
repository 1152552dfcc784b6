-- Wrong calls and their messages: lab fit. Read by tests/lua/errors.lua.

-- fabric.lab.backbone
wrong("fabric.lab.backbone", "fabric.lab.backbone{ curvse={} }",
  "deck.lua:1: backbone: unknown field 'curvse', did you mean 'curves'?")
wrong("fabric.lab.backbone", "fabric.lab.backbone{ curves=curves_ }",
  "deck.lua:1: backbone: field 'curves': expected a table { {E=, S=}, ... }, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.backbone", "fabric.lab.backbone{ curves=5 }",
  "deck.lua:1: backbone: field 'curves': expected a table { {E=, S=}, ... }, got 5")
wrong("fabric.lab.backbone", "fabric.lab.backbone{ curves={}, degrees={1, 'two'} }",
  "deck.lua:1: backbone: field 'degrees': expected a table of numbers, got 'two' at place 2")
wrong("fabric.lab.backbone", "fabric.lab.backbone{ curves={}, find_slack='yes' }",
  "deck.lua:1: backbone: field 'find_slack': expected true or false, got 'yes'")

-- fabric.lab.band
wrong("fabric.lab.band", "fabric.lab.band{ specimesn={} }",
  "deck.lua:1: band: unknown field 'specimesn', did you mean 'specimens'?")
wrong("fabric.lab.band", "fabric.lab.band{ specimens=specimens_ }",
  "deck.lua:1: band: field 'specimens': expected a table, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.band", "fabric.lab.band{ specimens=5 }",
  "deck.lua:1: band: field 'specimens': expected a table, got 5")
wrong("fabric.lab.band", "fabric.lab.band{ specimens={}, level='1' }",
  "deck.lua:1: band: field 'level': expected a number above 0 to below 1, got '1'")
wrong("fabric.lab.band", "fabric.lab.band{ specimens={}, level=0 }",
  "deck.lua:1: band: field 'level': expected a number above 0 to below 1, got 0")
wrong("fabric.lab.band", "fabric.lab.band{ specimens={}, draws=2.5 }",
  "deck.lua:1: band: field 'draws': expected an integer from 100 to 1e+06, got 2.5")
wrong("fabric.lab.band", "fabric.lab.band{ specimens={}, common={1, 'two'} }",
  "deck.lua:1: band: field 'common': expected a table of numbers, got 'two' at place 2")

-- fabric.lab.card
wrong("fabric.lab.card", "fabric.lab.card{ naem='x' }",
  "deck.lua:1: card: unknown field 'naem', did you mean 'name'?")
wrong("fabric.lab.card", "fabric.lab.card{ name=name_ }",
  "deck.lua:1: card: field 'name': expected a string, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.card", "fabric.lab.card{ name=7 }",
  "deck.lua:1: card: field 'name': expected a string, got 7")
wrong("fabric.lab.card", "fabric.lab.card{ name='x', density='1' }",
  "deck.lua:1: card: field 'density': expected a positive number in kg/m^3, got '1'")
wrong("fabric.lab.card", "fabric.lab.card{ name='x', density=-1 }",
  "deck.lua:1: card: field 'density': expected a positive number in kg/m^3, got -1")
wrong("fabric.lab.card", "fabric.lab.card{ name='x', density=500, thickness=0.01, warp=5 }",
  "deck.lua:1: card: field 'warp': expected a table, got 5")

wrong("fabric.lab.card", "fabric.lab.card{ name='x', density=500, thickness=0.01, assume='yes' }",
  "deck.lua:1: card: field 'assume': expected a table or true or false, got 'yes'")
wrong("fabric.lab.card", "fabric.lab.card{ name='x', density=500, thickness=0.01, assume={ ['warp.loadign']={1e6} } }",
  "deck.lua:1: card: field 'assume': expected warp, weft or shear with .loading, .unloading or (yarns) .poisson, thickness or density, got 'warp.loadign'")
wrong("fabric.lab.card", "fabric.lab.card{ name='x', density=500, thickness=0.01, warp={ loading={1e6} }, weft={ loading={1e6} }, shear={ loading={1e5} } }",
  "deck.lua:1: card: field 'warp': expected a ratio in poisson={ warp=, weft= }; give assume=true to take it by rule (share/doc/laboratory.md), or assume={ ['warp.poisson']=... }")
wrong("fabric.lab.card", "fabric.lab.card{ name='x', density=500, thickness=0.01, weft={ loading={1e6} } }",
  "deck.lua:1: card: field 'warp': there is no test of it; give assume=true to take it by rule (share/doc/laboratory.md), or assume={ ['warp.loading']=... }")
wrong("fabric.lab.card", "fabric.lab.card{ name='x', density=500, thickness=0.01, assume=true }",
  "deck.lua:1: card: field 'warp': expected a result of fabric.lab.fit for one direction, or of shear, at least")

-- fabric.lab.fit
wrong("fabric.lab.fit", "fabric.lab.fit{ tesst={} }",
  "deck.lua:1: fit: unknown field 'tesst', did you mean 'tests'?")
wrong("fabric.lab.fit", "fabric.lab.fit{ tests=tests_ }",
  "deck.lua:1: fit: field 'tests': expected a table, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.fit", "fabric.lab.fit{ tests=5 }",
  "deck.lua:1: fit: field 'tests': expected a table, got 5")
wrong("fabric.lab.fit", "fabric.lab.fit{ tests={}, degree='auot' }",
  "deck.lua:1: fit: field 'degree': expected an integer from 1 to 8 or 'auto' or 'monotone', got 'auot', did you mean 'auto'?")
wrong("fabric.lab.fit", "fabric.lab.fit{ tests={}, degree=0 }",
  "deck.lua:1: fit: field 'degree': expected an integer from 1 to 8 or 'auto' or 'monotone', got 0")
wrong("fabric.lab.fit", "fabric.lab.fit{ tests={}, find_slack='yes' }",
  "deck.lua:1: fit: field 'find_slack': expected 'either' or true or false, got 'yes'")
wrong("fabric.lab.fit", "fabric.lab.fit{ tests={}, upto='failuer' }",
  "deck.lua:1: fit: field 'upto': expected 'failure' or 'yield', got 'failuer', did you mean 'failure'?")
wrong("fabric.lab.fit", "fabric.lab.fit{ tests={}, count=2.5 }",
  "deck.lua:1: fit: field 'count': expected an integer of at least 2, got 2.5")
wrong("fabric.lab.fit", "fabric.lab.fit{ tests={}, kept='1' }",
  "deck.lua:1: fit: field 'kept': expected a number above 0 to 1, got '1'")


-- fabric.lab.identify
wrong("fabric.lab.identify", "fabric.lab.identify{ parametesr={} }",
  "deck.lua:1: identify: unknown field 'parametesr', did you mean 'parameters'?")
wrong("fabric.lab.identify", "fabric.lab.identify{ parameters=parameters_ }",
  "deck.lua:1: identify: field 'parameters': expected a table { {name=, start=, low=, high=}, ... }, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.identify", "fabric.lab.identify{ parameters=5 }",
  "deck.lua:1: identify: field 'parameters': expected a table { {name=, start=, low=, high=}, ... }, got 5")
wrong("fabric.lab.identify", "fabric.lab.identify{ parameters={}, tests={}, processes=2.5 }",
  "deck.lua:1: identify: field 'processes': expected an integer of at least 1, got 2.5")
wrong("fabric.lab.identify", "fabric.lab.identify{ parameters={}, tests={}, processes=0 }",
  "deck.lua:1: identify: field 'processes': expected an integer of at least 1, got 0")
wrong("fabric.lab.identify", "fabric.lab.identify{ parameters={}, tests={}, checkpoint=7 }",
  "deck.lua:1: identify: field 'checkpoint': expected a string, got 7")
wrong("fabric.lab.identify", "fabric.lab.identify{ parameters={}, tests={}, key={} }",
  "deck.lua:1: identify: field 'key': expected a number or a string, got a table")
wrong("fabric.lab.identify", "fabric.lab.identify{ parameters={ {name='a', start=1, low=0, high=2} }, tests={ {name='t', mesured={1}} } }",
  "deck.lua:1: identify: unknown field 'tests[1].mesured', did you mean 'tests[1].measured'?")
wrong("fabric.lab.identify", "fabric.lab.identify{ parameters={ {name='a', start=3, low=0, high=2} }, tests={} }",
  "deck.lua:1: identify: field 'parameters[1].start': expected 0 to 2, got 3")
wrong("fabric.lab.identify", "fabric.lab.identify{ parameters={}, tests={}, tolerance='1' }",
  "deck.lua:1: identify: field 'tolerance': expected a positive number, got '1'")
wrong("fabric.lab.identify", "fabric.lab.identify{ parameters={}, tests={}, progress='yes' }",
  "deck.lua:1: identify: field 'progress': expected true or false, got 'yes'")




-- fabric.lab.parallel
wrong("fabric.lab.parallel", "fabric.lab.parallel{ coutn=2 }",
  "deck.lua:1: parallel: unknown field 'coutn', did you mean 'count'?")
wrong("fabric.lab.parallel", "fabric.lab.parallel{ count=count_ }",
  "deck.lua:1: parallel: field 'count': expected an integer from 1 to 1e+07, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.parallel", "fabric.lab.parallel{ count=2.5 }",
  "deck.lua:1: parallel: field 'count': expected an integer from 1 to 1e+07, got 2.5")
wrong("fabric.lab.parallel", "fabric.lab.parallel{ count=0 }",
  "deck.lua:1: parallel: field 'count': expected an integer from 1 to 1e+07, got 0")
wrong("fabric.lab.parallel", "fabric.lab.parallel{ count=2, work='f' }",
  "deck.lua:1: parallel: field 'work': expected a function, got 'f'")
wrong("fabric.lab.parallel", "fabric.lab.parallel{ count=2, work=print, processes=0 }",
  "deck.lua:1: parallel: field 'processes': expected an integer from 1 to 4096, got 0")
wrong("fabric.lab.parallel", "fabric.lab.parallel{ count=2, work=print, isolated='yes' }",
  "deck.lua:1: parallel: field 'isolated': expected true or false, got 'yes'")
wrong("fabric.lab.parallel", "fabric.lab.parallel{ count=2, work=print, progress=7 }",
  "deck.lua:1: parallel: field 'progress': expected a string, got 7")

-- fabric.lab.unloading
wrong("fabric.lab.unloading", "fabric.lab.unloading{ Ex={0.01, 0.01} }",
  "deck.lua:1: unloading: unknown field 'Ex', did you mean 'E'?")
wrong("fabric.lab.unloading", "fabric.lab.unloading{ E=E_ }",
  "deck.lua:1: unloading: field 'E': expected a table of numbers, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.unloading", "fabric.lab.unloading{ E={1, 'two'} }",
  "deck.lua:1: unloading: field 'E': expected a table of numbers, got 'two' at place 2")
wrong("fabric.lab.unloading", "fabric.lab.unloading{ E={0.01, 0.01}, S={1000000, 1000000}, rule='firts' }",
  "deck.lua:1: unloading: field 'rule': expected 'first' or 'robust', got 'firts', did you mean 'first'?")
wrong("fabric.lab.unloading", "fabric.lab.unloading{ E={0.01, 0.01}, S={1000000, 1000000}, count=2.5 }",
  "deck.lua:1: unloading: field 'count': expected an integer of at least 2, got 2.5")
wrong("fabric.lab.unloading", "fabric.lab.unloading{ E={0.01, 0.01}, S={1000000, 1000000}, count=1 }",
  "deck.lua:1: unloading: field 'count': expected an integer of at least 2, got 1")
wrong("fabric.lab.unloading", "fabric.lab.unloading{ E={0.01, 0.01}, S={1000000, 1000000}, kept='1' }",
  "deck.lua:1: unloading: field 'kept': expected a number above 0 to below 1, got '1'")

-- fits that cannot be
wrong("fabric.lab.backbone", "fabric.lab.backbone{ curves={} }",
  "deck.lua:1: backbone: field 'curves': expected at least one curve {E=, S=}")
wrong("fabric.lab.backbone", "fabric.lab.backbone{ curves={ {E={1}, S={1, 2}} } }",
  "deck.lua:1: backbone: field 'curves[1]': expected E and S of one length")
wrong("fabric.lab.band", "fabric.lab.band{ specimens={ {1, 'x'} } }",
  "deck.lua:1: band: field 'specimens[1]': expected a table of numbers, got 'x' at place 2")

-- fabric.lab.spread
wrong("fabric.lab.spread", "fabric.lab.spread{ tesst={} }",
  "deck.lua:1: spread: unknown field 'tesst', did you mean 'tests'?")
wrong("fabric.lab.spread", "fabric.lab.spread{ tests=tests_ }",
  "deck.lua:1: spread: field 'tests': expected a table, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.spread", "fabric.lab.spread{ tests=5 }",
  "deck.lua:1: spread: field 'tests': expected a table, got 5")
wrong("fabric.lab.spread", "fabric.lab.spread{ tests={ {}, {} } }",
  "deck.lua:1: spread: field 'tests': expected at least 3 specimens, got 2")
wrong("fabric.lab.spread", "fabric.lab.spread{ tests={}, level='1' }",
  "deck.lua:1: spread: field 'level': expected a number above 0 to 0.999, got '1'")
wrong("fabric.lab.spread", "fabric.lab.spread{ tests={}, points=2.5 }",
  "deck.lua:1: spread: field 'points': expected an integer from 5 to 1000, got 2.5")
wrong("fabric.lab.spread", "fabric.lab.spread{ tests={}, points=2 }",
  "deck.lua:1: spread: field 'points': expected an integer from 5 to 1000, got 2")
wrong("fabric.lab.fit", "fabric.lab.fit{ tests={ 5 } }",
  "deck.lua:1: fit: field 'tests[1]': expected a result of fabric.lab.tensile or shear_from_bias, got 5")
wrong("fabric.lab.fit", "fabric.lab.fit{ tests={ { E={0, 0.1}, S={0} } } }",
  "deck.lua:1: fit: field 'tests[1]': expected E and S of one length, got 2 and 1 numbers")
wrong("fabric.lab.backbone", "fabric.lab.backbone{ curves={ {E={0, 0.1}, S={0, 1}} }, degrees={0} }",
  "deck.lua:1: backbone: field 'degrees': expected whole numbers from 1 to 20, got 0")

-- fabric.lab.student
wrong("fabric.lab.student", "fabric.lab.student()",
  "deck.lua:1: student: argument 'probability': expected a number above 0 to below 1, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.student", "fabric.lab.student('x', 4)",
  "deck.lua:1: student: argument 'probability': expected a number above 0 to below 1, got 'x'")
wrong("fabric.lab.student", "fabric.lab.student(1, 4)",
  "deck.lua:1: student: argument 'probability': expected a number above 0 to below 1, got 1")

-- fabric.lab.bias_sizes
wrong("fabric.lab.bias_sizes", "fabric.lab.bias_sizes{ specimens={}, thickness=1, specimensx=1 }",
  "deck.lua:1: bias_sizes: unknown field 'specimensx', did you mean 'specimens'?")
wrong("fabric.lab.bias_sizes", "fabric.lab.bias_sizes{ thickness=1 }",
  "deck.lua:1: bias_sizes: field 'specimens': expected a table, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.bias_sizes", "fabric.lab.bias_sizes{ thickness=1, specimens=5 }",
  "deck.lua:1: bias_sizes: field 'specimens': expected a table, got 5")
wrong("fabric.lab.bias_sizes", "fabric.lab.bias_sizes{ specimens={}, thickness='1' }",
  "deck.lua:1: bias_sizes: field 'thickness': expected a positive number in m, got '1'")
wrong("fabric.lab.bias_sizes", "fabric.lab.bias_sizes{ specimens={}, thickness=-1.0 }",
  "deck.lua:1: bias_sizes: field 'thickness': expected a positive number in m, got -1")
wrong("fabric.lab.bias_sizes", "fabric.lab.bias_sizes{ specimens={}, thickness=1, knots=2.5 }",
  "deck.lua:1: bias_sizes: field 'knots': expected an integer from 3 to 40, got 2.5")
wrong("fabric.lab.bias_sizes", "fabric.lab.bias_sizes{ specimens={}, thickness=1, edges='yes' }",
  "deck.lua:1: bias_sizes: field 'edges': expected true or false, got 'yes'")

-- fabric.lab.ensemble
wrong("fabric.lab.ensemble", "fabric.lab.ensemble{ parameters={}, parametersx=1 }",
  "deck.lua:1: ensemble: unknown field 'parametersx', did you mean 'parameters'?")
wrong("fabric.lab.ensemble", "fabric.lab.ensemble{  }",
  "deck.lua:1: ensemble: field 'parameters': expected a table { {name=, start=, low=, high=}, ... }, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.ensemble", "fabric.lab.ensemble{ parameters=5 }",
  "deck.lua:1: ensemble: field 'parameters': expected a table { {name=, start=, low=, high=}, ... }, got 5")
wrong("fabric.lab.ensemble", "fabric.lab.ensemble{ parameters={}, log=5 }",
  "deck.lua:1: ensemble: field 'log': expected a function, got 5")
wrong("fabric.lab.ensemble", "fabric.lab.ensemble{ parameters={}, walkers=2.5 }",
  "deck.lua:1: ensemble: field 'walkers': expected an integer of at least 4, got 2.5")
wrong("fabric.lab.ensemble", "fabric.lab.ensemble{ parameters={}, walkers=3 }",
  "deck.lua:1: ensemble: field 'walkers': expected an integer of at least 4, got 3")
wrong("fabric.lab.ensemble", "fabric.lab.ensemble{ parameters={}, level='1' }",
  "deck.lua:1: ensemble: field 'level': expected a number above 0 to 0.999, got '1'")

-- fabric.lab.pool
wrong("fabric.lab.pool", "fabric.lab.pool{ parameters={}, tests={}, parametersx=1 }",
  "deck.lua:1: pool: unknown field 'parametersx', did you mean 'parameters'?")
wrong("fabric.lab.pool", "fabric.lab.pool{ tests={} }",
  "deck.lua:1: pool: field 'parameters': expected a table { {name=, start=, low=, high=}, ... }, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.pool", "fabric.lab.pool{ tests={}, parameters=5 }",
  "deck.lua:1: pool: field 'parameters': expected a table { {name=, start=, low=, high=}, ... }, got 5")
wrong("fabric.lab.pool", "fabric.lab.pool{ parameters={}, tests={}, rate=5 }",
  "deck.lua:1: pool: field 'rate': expected a table {reference, most}, got 5")
wrong("fabric.lab.pool", "fabric.lab.pool{ parameters={}, tests={}, rate={ reference='1' } }",
  "deck.lua:1: pool: field 'rate.reference': expected a positive number, got '1'")
wrong("fabric.lab.pool", "fabric.lab.pool{ parameters={}, tests={}, rate={ reference=-1.0 } }",
  "deck.lua:1: pool: field 'rate.reference': expected a positive number, got -1")
wrong("fabric.lab.pool", "fabric.lab.pool{ parameters={}, tests={}, processes=2.5 }",
  "deck.lua:1: pool: field 'processes': expected an integer of at least 1, got 2.5")
wrong("fabric.lab.pool", "fabric.lab.pool{ parameters={}, tests={}, model='f' }",
  "deck.lua:1: pool: field 'model': expected a function, got 'f'")
wrong("fabric.lab.pool", "fabric.lab.pool{ parameters={}, tests={}, progress='yes' }",
  "deck.lua:1: pool: field 'progress': expected true or false, got 'yes'")

-- fabric.lab.loops
wrong("fabric.lab.loops", "fabric.lab.loops{ tesst={} }",
  "deck.lua:1: loops: unknown field 'tesst', did you mean 'tests'?")
wrong("fabric.lab.loops", "fabric.lab.loops{ tests=tests_ }",
  "deck.lua:1: loops: field 'tests': expected a table, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.loops", "fabric.lab.loops{ tests={} }",
  "deck.lua:1: loops: field 'tests': expected at least one test, got none")
wrong("fabric.lab.loops", "fabric.lab.loops{ tests={}, enough='1' }",
  "deck.lua:1: loops: field 'enough': expected a number from 0 to 1, got '1'")
wrong("fabric.lab.loops", "fabric.lab.loops{ tests={}, fit=5 }",
  "deck.lua:1: loops: field 'fit': expected a table, got 5")
wrong("fabric.lab.loops", "fabric.lab.loops{ tests={}, seed=1.5 }",
  "deck.lua:1: loops: field 'seed': expected an integer of at least 0, got 1.5")

-- fabric.lab.viscous
wrong("fabric.lab.viscous", "fabric.lab.viscous{ tesst={} }",
  "deck.lua:1: viscous: unknown field 'tesst', did you mean 'tests'?")
wrong("fabric.lab.viscous", "fabric.lab.viscous{ tests=tests_ }",
  "deck.lua:1: viscous: field 'tests': expected a table, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.viscous", "fabric.lab.viscous{ tests=5 }",
  "deck.lua:1: viscous: field 'tests': expected a table, got 5")
wrong("fabric.lab.viscous", "fabric.lab.viscous{ tests={}, knots=2.5 }",
  "deck.lua:1: viscous: field 'knots': expected an integer from 3 to 40, got 2.5")
wrong("fabric.lab.viscous", "fabric.lab.viscous{ tests={}, knots=2 }",
  "deck.lua:1: viscous: field 'knots': expected an integer from 3 to 40, got 2")
wrong("fabric.lab.viscous", "fabric.lab.viscous{ tests={}, level='1' }",
  "deck.lua:1: viscous: field 'level': expected a number above 0 to 0.999, got '1'")
wrong("fabric.lab.viscous", "fabric.lab.viscous{ tests={ { E={0, 1, 2}, S={0, 1, 2} } } }",
  "deck.lua:1: viscous: field 'tests[1].time': expected the seconds of each row (or speed= in m/s of the crosshead, with displacement)")
