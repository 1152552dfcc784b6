-- Wrong calls and their messages: rest. Read by tests/lua/errors.lua.
-- fabric.expect
wrong("fabric.expect", "fabric.expect()",
  "deck.lua:1: expect: argument 'rows': expected a table { {label, got, want, relative= or absolute=}, ... }, got nil (missing, or a misspelt variable)")
wrong("fabric.expect", "fabric.expect(5)",
  "deck.lua:1: expect: argument 'rows': expected a table { {label, got, want, relative= or absolute=}, ... }, got 5")

-- fabric.folder
wrong("fabric.folder", "fabric.folder()",
  "deck.lua:1: folder: argument 'path': expected a string, got nil (missing, or a misspelt variable)")
wrong("fabric.folder", "fabric.folder(7)",
  "deck.lua:1: folder: argument 'path': expected a string, got 7")

-- fabric.help

-- fabric.plot
wrong("fabric.plot", "fabric.plot{ curvse={} }",
  "deck.lua:1: plot: unknown field 'curvse', did you mean 'curves'?")
wrong("fabric.plot", "fabric.plot{ curves=curves_ }",
  "deck.lua:1: plot: field 'curves': expected a table { {x=, y=, label=, style=}, ... }, got nil (missing, or a misspelt variable)")
wrong("fabric.plot", "fabric.plot{ curves=5 }",
  "deck.lua:1: plot: field 'curves': expected a table { {x=, y=, label=, style=}, ... }, got 5")
wrong("fabric.plot", "fabric.plot({}, 'E')",
  "deck.lua:1: plot: field 'y': expected the name of a field of rows, or a list of names")
wrong("fabric.plot", "fabric.plot({}, 'E', 'S', 'out.svg')",
  "deck.lua:1: plot: argument 4: expected a table with named fields, got 'out.svg'")
wrong("fabric.plot", "fabric.plot({}, 'E', 'S', { x='T' })",
  "deck.lua:1: plot: field 'x': given twice, as argument 2 and by its name")
wrong("fabric.plot", "fabric.plot({}, 'E', 'S', {}, 5)",
  "deck.lua:1: plot: expected at most 4 arguments, got 5")
wrong("fabric.plot", "fabric.plot({}, 'E', 'S')",
  "deck.lua:1: plot: field 'rows': expected a list of tables with the field 'E', or a table with a list of that name")
wrong("fabric.plot", "fabric.plot({ {E=1} }, 'E', 'S')",
  "deck.lua:1: plot: field 'rows[1].S': expected a number, got nil")
wrong("fabric.plot", "fabric.plot({ {E=1} }, 'E', {'S', 7})",
  "deck.lua:1: plot: field 'y': expected names of fields of rows, got 7")
wrong("fabric.plot", "fabric.plot{ size={85, 60}, curves={ {x={1}, y={1}} } }",
  "deck.lua:1: plot: field 'size': expected {width, height} in m, each from 0.02 to 1, such as {85*mm, 60*mm}, got {85, 60}")
wrong("fabric.plot", "fabric.plot{ font_size=2, curves={ {x={1}, y={1}} } }",
  "deck.lua:1: plot: field 'font_size': expected a number from 4 to 40 in points, got 2")
wrong("fabric.plot", "fabric.plot{ font='Times,9', curves={ {x={1}, y={1}} } }",
  "deck.lua:1: plot: field 'font': expected the name of one family, got 'Times,9'")
wrong("fabric.plot", "fabric.plot{ dpi=5, curves={ {x={1}, y={1}} } }",
  "deck.lua:1: plot: field 'dpi': expected a number from 50 to 1200, got 5")
wrong("fabric.plot", "fabric.plot{ key='top', curves={ {x={1}, y={1}} } }",
  "deck.lua:1: plot: field 'key': expected 'best' or 'none' or 'top left' or 'top right' or 'bottom left' or 'bottom right' or 'below' or 'right', got 'top'")
wrong("fabric.plot", "fabric.plot{ layout={1, 1}, panels={ {curves={ {x={1}, y={1}} }}, {curves={ {x={1}, y={1}} }} } }",
  "deck.lua:1: plot: field 'layout': expected room for 2 panels, got 1 x 1")
wrong("fabric.plot", "fabric.plot{ layout={1, 0.5}, panels={ {curves={ {x={1}, y={1}} }} } }",
  "deck.lua:1: plot: field 'layout': expected {rows, columns}, whole numbers from 1 to 20")
wrong("fabric.plot", "fabric.plot{ panels={} }",
  "deck.lua:1: plot: field 'panels': expected a list of panels, got an empty table")
wrong("fabric.plot", "fabric.plot{ panels={ {titel='a'} } }",
  "deck.lua:1: plot: unknown field 'panels[1].titel', did you mean 'panels[1].title'?")
wrong("fabric.plot", "fabric.plot{ panels={ {curves={ {x={1}, y={1}} }} }, curves={} }",
  "deck.lua:1: plot: field 'curves': expected in each of the panels, where there are panels")
wrong("fabric.plot", "fabric.plot{ panels={ {title='a'} } }",
  "deck.lua:1: plot: field 'panels[1].curves': expected a table { {x=, y=, label=, style=}, ... }, got nil (missing, or a misspelt variable)")
wrong("fabric.plot", "fabric.plot{ curves={ {x={1}} } }",
  "deck.lua:1: plot: field 'curves[1].y': expected a table or a string, got nil (missing, or a misspelt variable)")
wrong("fabric.plot", "fabric.plot{ curves={ {x={1}, y={1}, band={low={1}}} } }",
  "deck.lua:1: plot: field 'curves[1].band.high': expected a table or a string, got nil (missing, or a misspelt variable)")
wrong("fabric.plot", "fabric.plot{ curves={ {x={1}, y={1}, band={low={2}, high={1}}} } }",
  "deck.lua:1: plot: figure: curve '': its band ends below where it begins at place 1: from 2 to 1")
wrong("fabric.plot", "fabric.plot{ curves={ {x={1}, y={1}, error={1, 2}} } }",
  "deck.lua:1: plot: field 'curves[1].error': expected as many as there are points, got 2 for 1")
wrong("fabric.plot", "fabric.plot{ curves={ {x={1}, y={1}, error=-1} } }",
  "deck.lua:1: plot: field 'curves[1].error': expected lengths of at least 0, got -1 at place 1")
wrong("fabric.plot", "fabric.plot{ curves={ {x={1}, y={1}, colour='bleu'} } }",
  "deck.lua:1: plot: field 'curves[1].colour': expected \"#rrggbb\" or a name; unknown colour 'bleu', did you mean 'blue'?")
wrong("fabric.plot", "fabric.plot{ curves={}, letters='no' }",
  "deck.lua:1: plot: field 'letters': expected true or false, got 'no'")
wrong("fabric.plot", "fabric.plot{ curves={}, file=7 }",
  "deck.lua:1: plot: field 'file': expected a string, got 7")
wrong("fabric.plot", "fabric.plot{ curves={}, xrange={1, 'two'} }",
  "deck.lua:1: plot: field 'xrange': expected a table of numbers, got 'two' at place 2")
wrong("fabric.plot", "fabric.plot{ curves={}, ynames='warp' }",
  "deck.lua:1: plot: field 'ynames': expected a table, got 'warp'")
wrong("fabric.plot", "fabric.plot{ curves={}, ynames={'warp', 5} }",
  "deck.lua:1: plot: field 'ynames': expected a list of names, got 5 at place 2")
wrong("fabric.plot", "fabric.plot{ curves={}, ynames={} }",
  "deck.lua:1: plot: field 'ynames': expected at least one name, got an empty table")
wrong("fabric.plot", "fabric.plot{ curves={}, ynames={'warp'}, log='y' }",
  "deck.lua:1: plot: field 'ynames': expected neither yunit nor a logarithmic y beside it")
wrong("fabric.plot", "fabric.plot{ curves={}, log='?' }",
  "deck.lua:1: plot: field 'log': expected '' or 'x' or 'y' or 'xy', got '?'")
wrong("fabric.plot", "fabric.plot{ curves={}, columns=2.5 }",
  "deck.lua:1: plot: field 'columns': expected an integer from 10 to 400, got 2.5")
wrong("fabric.plot", "fabric.plot{ curves={}, columns=9 }",
  "deck.lua:1: plot: field 'columns': expected an integer from 10 to 400, got 9")

-- fabric.poly
wrong("fabric.poly", "fabric.poly()",
  "deck.lua:1: poly: argument 'coefficients': expected a table of numbers, got nil (missing, or a misspelt variable)")
wrong("fabric.poly", "fabric.poly({1, 'two'})",
  "deck.lua:1: poly: argument 'coefficients': expected a table of numbers, got 'two' at place 2")
wrong("fabric.poly", "fabric.poly({0.01, 0.01}, '1')",
  "deck.lua:1: poly: argument 'unit': expected a number, got '1'")

-- fabric.render
wrong("fabric.render", "fabric.render{ fiel='x' }",
  "deck.lua:1: render: unknown field 'fiel', did you mean 'file'?")
wrong("fabric.render", "fabric.render{ file=file_ }",
  "deck.lua:1: render: field 'file': expected a string, got nil (missing, or a misspelt variable)")
wrong("fabric.render", "fabric.render{ file=7 }",
  "deck.lua:1: render: field 'file': expected a string, got 7")
wrong("fabric.render", "fabric.render{ file='x', vtu=7 }",
  "deck.lua:1: render: field 'vtu': expected a table or a string, got 7")
wrong("fabric.render", "fabric.render{ file='x', run=mesh }",
  "deck.lua:1: render: field 'run': expected a table or an analysis, got a mesh")
wrong("fabric.render", "fabric.render{ file='x.png', run={} }",
  "deck.lua:1: render: field 'run': expected an analysis or a list of them, got an empty list")
wrong("fabric.render", "fabric.render{ file='x.png', run={ 5 } }",
  "deck.lua:1: render: field 'run': expected an analysis at place 1, got 5")
wrong("fabric.render", "fabric.render{ file='x', field='noen' }",
  "deck.lua:1: render: field 'field': got 'noen', did you mean 'none'? Expected one of 63 names, 'none' to 'region' (help, or reference.md, lists them)")
wrong("fabric.render", "fabric.render{ file='x', factor='1' }",
  "deck.lua:1: render: field 'factor': expected a number, got '1'")
wrong("fabric.render", "fabric.render{ file='x', range={1, 'two'} }",
  "deck.lua:1: render: field 'range': expected a table of numbers, got 'two' at place 2")
wrong("fabric.render", "fabric.render{ file='x', view='aboev' }",
  "deck.lua:1: render: field 'view': expected a table of numbers or 'above' or 'front' or 'side' or 'oblique', got 'aboev', did you mean 'above'?")
wrong("fabric.render", "fabric.render{ file='x', views='front' }",
  "deck.lua:1: render: field 'views': expected a table { 'front', 'side', 'above', 'oblique', {30, 25}, ... }, got 'front'")
wrong("fabric.render", "fabric.render{ file='x', size={1, 'two'} }",
  "deck.lua:1: render: field 'size': expected a table of numbers in m, got 'two' at place 2")
wrong("fabric.render", "fabric.render{ file='x', font_size=1 }",
  "deck.lua:1: render: field 'font_size': expected a number from 4 to 40 in points, got 1")
wrong("fabric.render", "fabric.render{ file='x', smooth='yes' }",
  "deck.lua:1: render: field 'smooth': expected true or false, got 'yes'")
wrong("fabric.render", "fabric.render{ file='x', columns=2.5 }",
  "deck.lua:1: render: field 'columns': expected an integer of at least 1, got 2.5")
wrong("fabric.render", "fabric.render{ file='x', columns=0 }",
  "deck.lua:1: render: field 'columns': expected an integer of at least 1, got 0")
wrong("fabric.render", "fabric.render{ file='x', edges='yes' }",
  "deck.lua:1: render: field 'edges': expected true or false, got 'yes'")

-- fabric.table
wrong("fabric.table", "fabric.table{ file='x', lenient='yes' }",
  "deck.lua:1: table: field 'lenient': expected true or false, got 'yes'")
wrong("fabric.table", "fabric.table{ fiel='x' }",
  "deck.lua:1: table: unknown field 'fiel', did you mean 'file'?")
wrong("fabric.table", "fabric.table{ file=file_ }",
  "deck.lua:1: table: field 'file': expected a string, got nil (missing, or a misspelt variable)")
wrong("fabric.table", "fabric.table{ file=7 }",
  "deck.lua:1: table: field 'file': expected a string, got 7")
wrong("fabric.table", "fabric.table{ file='x', separator='auot' }",
  "deck.lua:1: table: field 'separator': expected 'auto' or ',' or ';' or 'tab' or 'blank', got 'auot', did you mean 'auto'?")

-- fabric.transcript
wrong("fabric.transcript", "fabric.transcript(7)",
  "deck.lua:1: transcript: argument 'file': expected a string or true or false, got 7")

-- fabric.warn
wrong("fabric.warn", "fabric.warn()",
  "deck.lua:1: warn: argument 'text': expected a string, got nil (missing, or a misspelt variable)")
wrong("fabric.warn", "fabric.warn(7)",
  "deck.lua:1: warn: argument 'text': expected a string, got 7")

-- the program's own names, checks, files
wrong("object", "fabric.crad 'blend'",
  "deck.lua:1: fabric: unknown field 'crad', did you mean 'card'?")
wrong("object", "fabric.lab.uniaxal{ card=card }",
  "deck.lua:1: fabric.lab: unknown field 'uniaxal', did you mean 'uniaxial'?")
wrong("fabric.expect", "fabric.expect{ {'x', nil, 2, relative=1e-3} }",
  "deck.lua:1: expect: row 'x': expected two numbers (got, want), got nil and 2")
wrong("fabric.expect", "fabric.expect{ {1, 2} }",
  "deck.lua:1: expect: row 1: expected a label first, got 1")
wrong("fabric.expect", "fabric.expect{ {'x', 1, 2} }",
  "deck.lua:1: expect: row 'x': expected relative= or absolute= (one of them)")
wrong("fabric.expect", "fabric.expect{ {'x', 1, 2, relative=1e-3} }",
  "deck.lua:1: expect: 1 of 1 missed: 'x'")
wrong("fabric.folder", "fabric.folder 'no-such-folder'",
  "deck.lua:1: folder: cannot read the folder 'no-such-folder': No such file or directory")
wrong("fabric.table", "fabric.table{ file='none.csv' }",
  "deck.lua:1: table: cannot read 'none.csv': No such file or directory")
wrong("fabric.plot", "fabric.plot{ file='x.svg', curves={ {x={1, 2}, y={1}} } }",
  "deck.lua:1: plot: field 'curves[1]': expected x and y of one length, got 2 and 1")
wrong("fabric.plot", "fabric.plot{ file='x.svg', curves={ 5 } }",
  "deck.lua:1: plot: field 'curves[1]': expected a table, got 5")
wrong("fabric.plot", "fabric.plot{ file='x.svg', curves={ {x={1}, y={1}, style='lines'} } }",
  "deck.lua:1: plot: field 'curves[1].style': expected 'line' or 'dashed' or 'points' or 'line_points', got 'lines', did you mean 'line'?")
wrong("fabric.plot", "fabric.plot{ file='x.doc', curves={ {x={1, 2}, y={1, 2}} } }",
  "deck.lua:1: plot: figure: expected a file name that ends in .svg, .pdf, .eps or .png, got 'x.doc'")
wrong("fabric.render", "fabric.render{ file='x.png' }",
  "deck.lua:1: render: field 'vtu': expected either vtu or run, got neither")
wrong("fabric.render", "fabric.render{ file='x.png', vtu='none.vtu', field='S1' }",
  "deck.lua:1: render: field 'field': got 'S1', did you mean 'S11'? Expected one of 63 names, 'none' to 'region' (help, or reference.md, lists them)")
wrong("lua", "error()",
  "nil")
wrong("lua", "error 'a text'",
  "deck.lua:1: a text")
wrong("lua", "local x = nil + 1",
  "deck.lua:1: attempt to perform arithmetic on a nil value")
wrong("lua", "undefined_name()",
  "deck.lua:1: attempt to call a nil value (global 'undefined_name')")

-- fabric.study
wrong("fabric.study", "fabric.study{ paramters={} }",
  "deck.lua:1: study: unknown field 'paramters', did you mean 'parameters'?")
wrong("fabric.study", "fabric.study{ parameters={a={1}}, run=run_ }",
  "deck.lua:1: study: field 'run': expected a function, got nil (missing, or a misspelt variable)")
wrong("fabric.study", "fabric.study{ parameters=7 }",
  "deck.lua:1: study: field 'parameters': expected a table { name={values}, ... }, got 7")
wrong("fabric.study", "fabric.study{ parameters={a={1}}, run='f' }",
  "deck.lua:1: study: field 'run': expected a function, got 'f'")
wrong("fabric.study", "fabric.study{ parameters={a={1}}, run=print, folder=7 }",
  "deck.lua:1: study: field 'folder': expected a string, got 7")
wrong("fabric.study", "fabric.study{ parameters={a={1}}, run=print, workers=2.5 }",
  "deck.lua:1: study: field 'workers': expected an integer from 1 to 4096, got 2.5")
wrong("fabric.study", "fabric.study{ parameters={a={1}}, run=print, workers=0 }",
  "deck.lua:1: study: field 'workers': expected an integer from 1 to 4096, got 0")
wrong("fabric.study", "fabric.study{ parameters={a={1}}, run=print, again='yes' }",
  "deck.lua:1: study: field 'again': expected true or false, got 'yes'")

-- fabric.budget, fabric.sobol, fabric.latin_hypercube and what they stand on
wrong("fabric.budget", "fabric.budget{}",
  "deck.lua:1: budget: field 'run': expected a function, got nil (missing, or a misspelt variable)")
wrong("fabric.budget", "fabric.budget{ run='f' }",
  "deck.lua:1: budget: field 'run': expected a function, got 'f'")
wrong("fabric.budget", "fabric.budget{ runn=print }",
  "deck.lua:1: budget: unknown field 'runn', did you mean 'run'?")
wrong("fabric.budget", "fabric.budget{ run=print, card=7 }",
  "deck.lua:1: budget: field 'card': expected a card, got 7")
wrong("fabric.budget", "fabric.budget{ run=print, mesh=4 }",
  "deck.lua:1: budget: field 'mesh': expected a table, got 4")
wrong("fabric.budget", "fabric.budget{ run=print, samples=2.5 }",
  "deck.lua:1: budget: field 'samples': expected an integer from 8 to 100000, got 2.5")
wrong("fabric.budget", "fabric.budget{ run=print, samples=4 }",
  "deck.lua:1: budget: field 'samples': expected an integer from 8 to 100000, got 4")
wrong("fabric.budget", "fabric.budget{ run=print, print='yes' }",
  "deck.lua:1: budget: field 'print': expected true or false, got 'yes'")
wrong("fabric.budget", "fabric.budget{ run=print, figure=7 }",
  "deck.lua:1: budget: field 'figure': expected a string, got 7")
wrong("fabric.budget", "fabric.budget{ run=print, card=mesh }",
  "deck.lua:1: budget: field 'card': expected a card, got a mesh")
wrong("fabric.lab.normal", "fabric.lab.normal()",
  "deck.lua:1: normal: argument 'probability': expected a number above 0 to below 1, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.normal", "fabric.lab.normal('x')",
  "deck.lua:1: normal: argument 'probability': expected a number above 0 to below 1, got 'x'")
wrong("fabric.lab.normal", "fabric.lab.normal(1)",
  "deck.lua:1: normal: argument 'probability': expected a number above 0 to below 1, got 1")
wrong("fabric.sobol", "fabric.sobol()",
  "deck.lua:1: sobol: argument 'inputs': expected a table { name={low, high} or {mean=, deviation=}, ..., n=cases, seed=1 }, got nil (missing, or a misspelt variable)")
wrong("fabric.sobol", "fabric.sobol(7)",
  "deck.lua:1: sobol: argument 'inputs': expected a table { name={low, high} or {mean=, deviation=}, ..., n=cases, seed=1 }, got 7")
wrong("fabric.latin_hypercube", "fabric.latin_hypercube()",
  "deck.lua:1: latin_hypercube: argument 'inputs': expected a table { name={low, high} or {mean=, deviation=}, ..., n=cases, seed=1 }, got nil (missing, or a misspelt variable)")
wrong("fabric.latin_hypercube", "fabric.latin_hypercube(7)",
  "deck.lua:1: latin_hypercube: argument 'inputs': expected a table { name={low, high} or {mean=, deviation=}, ..., n=cases, seed=1 }, got 7")
wrong("fabric.study", "fabric.study{ parameters={ a={1} }, sample={ { a=1 } }, run=print }",
  "deck.lua:1: study: expected either 'parameters' or 'sample'")
wrong("fabric.study", "fabric.study{ sample=7, run=print }",
  "deck.lua:1: study: field 'sample': expected a table, got 7")

-- fabric.write
wrong("fabric.write", "fabric.write()",
  "deck.lua:1: write: argument 'path': expected a string, got nil (missing, or a misspelt variable)")
wrong("fabric.write", "fabric.write('x', 7)",
  "deck.lua:1: write: argument 'content': expected a string, got 7")
wrong("fabric.write", "fabric.write('/dev/null', 'x')",
  "deck.lua:1: write: cannot write '/dev/null': it is not a regular file")
