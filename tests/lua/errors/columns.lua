-- Wrong calls and their messages: curves. Read by tests/lua/errors.lua.
-- fabric.columns
wrong("fabric.columns", "fabric.columns()",
  "deck.lua:1: columns: argument 'rows': expected a table, got nil (missing, or a misspelt variable)")
wrong("fabric.columns", "fabric.columns(5)",
  "deck.lua:1: columns: argument 'rows': expected a table, got 5")
wrong("fabric.columns", "local c = fabric.columns{ {E=1}, {S=2} }.E",
  "deck.lua:1: columns: expected a number E in each row, row 2 of 2 has none; the columns are E")

-- fabric.show
wrong("fabric.show", "fabric.show()",
  "deck.lua:1: show: argument 'rows': expected a table, got nil (missing, or a misspelt variable)")
wrong("fabric.show", "fabric.show('E')",
  "deck.lua:1: show: argument 'rows': expected a table, got 'E'")
wrong("fabric.show", "fabric.show({ {E=1} }, { rows=1 })",
  "deck.lua:1: show: field 'options.rows': expected an integer of at least 2, got 1")
wrong("fabric.show", "fabric.show({ {E=1} }, { rows='2' })",
  "deck.lua:1: show: field 'options.rows': expected an integer of at least 2, got '2'")
wrong("fabric.show", "fabric.show({ {E=1} }, { colums={'E'} })",
  "deck.lua:1: show: unknown field 'options.colums', did you mean 'options.columns'?")
wrong("fabric.show", "fabric.show({ {E=1} }, { columns='E' })",
  "deck.lua:1: show: field 'options.columns': expected a table, got 'E'")
wrong("fabric.show", "fabric.show({ {E=1} }, 5)",
  "deck.lua:1: show: argument 'options': expected a table {rows, columns}, got 5")
