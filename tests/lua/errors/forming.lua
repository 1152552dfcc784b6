-- Wrong calls and their messages: tools and forming. Read by tests/lua/errors.lua.
local at = "deck.lua:1: "
local form = "local t = { card=fabric.card('blend', { bending='estimated' }), blank=0.2, punch={ radius=0.03 }, die={ radius=0.035, edge=0.006 }, holder={ force=100 }, stroke=0.02, cells=8 } "
local run = " fabric.lab.form(t)"

wrong("fabric.rigid.punch", "fabric.rigid.punch{ wrong=1 }",
  at .. "punch: unknown field 'wrong' (known: shape radius size corner length waist angle edge height at around mass name)")
wrong("fabric.rigid.punch", "fabric.rigid.punch{}", at .. "punch: field 'radius': expected a length in m for shape='hemisphere', got none")
wrong("fabric.rigid.punch", "fabric.rigid.punch{ shape='cone' }", at .. "punch: field 'shape': expected 'hemisphere' or 'box' or 'double dome' or 'L' or 'Z', got 'cone'")
wrong("fabric.rigid.punch", "fabric.rigid.punch{ radius=-1 }", at .. "punch: field 'radius': expected a number above 0 to 1000 in m, got -1")
wrong("fabric.rigid.punch", "fabric.rigid.punch{ shape='box', size={0.1}, corner=0.02, edge=0.01 }", at .. "punch: field 'size': expected {width, height}, got 1 number")
wrong("fabric.rigid.punch", "fabric.rigid.punch{ shape='box', size={0.1, 0.06}, corner=0.04, edge=0.01 }", at .. "punch: field 'corner': expected at most half of the shorter side, 0.03 m, got 0.04")
wrong("fabric.rigid.punch", "fabric.rigid.punch{ shape='box', size={0.1, 0.06}, corner=0.01, edge=0.02 }", at .. "punch: field 'edge': expected at most the corner, 0.01 m, got 0.02")
wrong("fabric.rigid.punch", "fabric.rigid.punch{ shape='double dome', radius=0.05, length=0.2, waist=0.04 }",
  at .. "punch: field 'waist': the arcs do not reach from dome to dome: expected more than 0.05 m, got 0.04")
wrong("fabric.rigid.punch", "fabric.rigid.punch{ radius=0.05, at={1} }", at .. "punch: field 'at': expected {x, y, z}, got 1 number")
wrong("fabric.rigid.dome", "fabric.rigid.dome{ radius=0.05, length=0.2 }",
  at .. "dome: field 'waist': the arcs do not reach from dome to dome: expected more than 0.05 m, got 0.05")
wrong("fabric.rigid.die", "fabric.rigid.die{ radius=0.05, edge=0.01, outer=0.055 }", at .. "die: field 'outer': expected more than the opening with its edge, 0.06 m, got 0.055")
wrong("fabric.rigid.die", "fabric.rigid.die{ radius=0.05, edge=0.01, outer=0.1, facing='left' }", at .. "die: field 'facing': expected 'up' or 'down', got 'left'")

wrong("fabric.lab.form", form .. "t.die.radius = 0.025" .. run,
  at .. "form: field 'die': the punch goes through the die: its outline is 0.005 m outside of the opening at 0 degrees from x")
wrong("fabric.lab.form", form .. "t.die.radius = 0.0302" .. run,
  at .. "form: field 'die': the nip of punch and die is thinner than the plies: expected an opening at least 0.00038 m wider on each side, got 0.0002 m at 0 degrees from x")
wrong("fabric.lab.form", form .. "t.holder = {}" .. run, at .. "form: field 'holder': expected one of force= (N), springs= (N/m) and gap= (m), got none")
wrong("fabric.lab.form", form .. "t.holder = { force=10, gap=1e-3 }" .. run, at .. "form: field 'holder': expected one of force= (N), springs= (N/m) and gap= (m), got several")
wrong("fabric.lab.form", form .. "t.holder = { gap=1e-4 }" .. run,
  at .. "form: field 'holder.gap': the plies, 0.00038 m thick, would be pressed to less than half: expected more than 0.00019 m, got 0.0001")
wrong("fabric.lab.form", form .. "t.blank = 0.08" .. run,
  at .. "form: field 'blank': it does not cover the opening of the die with its edge: expected more than {0.082, 0.082} m, got {0.08, 0.08}")
wrong("fabric.lab.form", form .. "t.punch.radius = 30" .. run, at .. "form: field 'punch.radius': expected lengths in m, got 30 m: is it in mm? (write 50*mm)")
wrong("fabric.lab.form", form .. "t.die.edge = 6" .. run, at .. "form: field 'die.edge': expected lengths in m, got 6 m: is it in mm? (write 50*mm)")
wrong("fabric.lab.form", form .. "t.stroke = 20" .. run, at .. "form: field 'stroke': expected lengths in m, got 20 m: is it in mm? (write 50*mm)")
wrong("fabric.lab.form", form .. "t.stroke = 0.07" .. run, at .. "form: field 'stroke': expected at most the height of the punch, 0.06 m, got 0.07")
wrong("fabric.lab.form", form .. "t.contact = 1e-4" .. run,
  at .. "form: field 'contact': the plies would start inside each other: expected at least their thickness, 0.00038 m, got 0.0001")
wrong("fabric.lab.form", form .. "t.blank = { 0.2, 0.2, 0.2 }" .. run, at .. "form: field 'blank': expected a side or {width, height} in m, got 3 numbers")
wrong("fabric.lab.form", form .. "t.stack = {}" .. run, at .. "form: field 'stack': expected a table of numbers in degrees, got an empty table")
wrong("fabric.lab.form", form .. "t.stack = { 45 } t.quarter = true" .. run,
  at .. "form: field 'quarter': a quarter stands for the whole where yarns run along x and y: expected angles of 0 and 90 degrees, got 45")
wrong("fabric.lab.form", form .. "t.die.edge = 0" .. run, at .. "form: field 'die.edge': expected a number from 1e-06 to 1000 in m, got 0")
wrong("fabric.lab.form", form .. "t.die.edge = 'x'" .. run, at .. "form: field 'die.edge': expected a number from 1e-06 to 1000 in m, got 'x'")
wrong("fabric.lab.form", form .. "t.punch.radius = false" .. run, at .. "form: field 'punch.radius': expected a number above 0 to 1000 in m, got false")
wrong("fabric.lab.form", form .. "t.punch.radius = nil" .. run, at .. "form: field 'punch.radius': expected a length in m for shape='hemisphere', got none")
wrong("fabric.lab.form", form .. "t.punch.shape = 'cone'" .. run, at .. "form: field 'punch.shape': expected 'hemisphere' or 'box' or 'double dome' or 'L' or 'Z', got 'cone'")
wrong("fabric.lab.form", form .. "t.punch = { shape='box', size={0.1}, corner=0.02, edge=0.01 }" .. run, at .. "form: field 'punch.size': expected {along x, along y}, got 1 number")
wrong("fabric.lab.form", form .. "t.punch = { shape='box', size={0.1, 0.06}, corner=0.04, edge=0.01 } t.die = nil" .. run,
  at .. "form: field 'punch.corner': expected at most half of the shorter side, 0.03 m, got 0.04")
wrong("fabric.lab.form", form .. "t.die.shape = 'box'" .. run, at .. "form: field 'die.size': expected a length in m for shape='box', got none")
wrong("fabric.lab.form", form .. "t.die.mass = 1" .. run, at .. "form: unknown field 'die.mass', did you mean 'die.waist'?")
wrong("fabric.lab.form", form .. "t.punch.radius = 1e-4 t.stroke = 1e-4" .. run, at .. "form: field 'punch.radius': expected more than 0.00041 m, by which contact is thicker than the plies, got 0.0001")
wrong("fabric.lab.form", form .. "t.holder = { force=1e300 }" .. run, at .. "form: field 'holder.force': expected a number above 0 to 1e+07 in N, got 1e+300")
wrong("fabric.lab.form", form .. "t.cells = 1000 t.stack = { 0, 90, 0, 90, 0 }" .. run, at .. "form: field 'cells': expected at most 4e+06 elements in all plies, got 5e+06: fewer cells along the longer side, or fewer plies")
wrong("fabric.lab.form", form .. "t.stack = {} for i = 1, 51 do t.stack[i] = 0 end" .. run, at .. "form: field 'stack': expected at most 50 plies, got 51")
wrong("fabric.rigid.die", "fabric.rigid.die{ shape='box', size={0.1}, corner=0.01, edge=0.01, outer=0.1 }", at .. "die: field 'size': expected {width, height}, got 1 number")
wrong("fabric.rigid.punch", "fabric.rigid.punch{ radius=0.05, at={0, 0, 1e300} }", at .. "punch: field 'at': expected at most 1000 m from the origin, got 1e+300 at place 3")
wrong("fabric.lab.form", form .. "t.punch = 5" .. run, at .. "form: field 'punch': expected a table {shape, radius, size, corner, length, waist, ...}, got 5")
wrong("fabric.lab.form", form .. "t.card = 5" .. run, at .. "form: field 'card': expected a card, got 5")
wrong("fabric.lab.form", form .. "t.friction = -1" .. run, at .. "form: field 'friction': expected a number of at least 0, got -1")
wrong("fabric.lab.form", form .. "t.holder = { force=-5 }" .. run, at .. "form: field 'holder.force': expected a number above 0 to 1e+07 in N, got -5")
wrong("fabric.lab.form", form .. "t.holder = { spring=5 }" .. run, at .. "form: unknown field 'holder.spring', did you mean 'holder.springs'?")
wrong("fabric.lab.form", form .. "t.quarter = 5" .. run, at .. "form: field 'quarter': expected true or false, got 5")
wrong("fabric.lab.form", form .. "t.prepare = 5" .. run, at .. "form: field 'prepare': expected a function, got 5")
wrong("fabric.lab.form", form .. "t.state = 5" .. run, at .. "form: field 'state': expected a table, got 5")
wrong("fabric.lab.form", form .. "t.out = 5" .. run, at .. "form: field 'out': expected a string, got 5")
wrong("fabric.lab.form", form .. "t.rows = 1.5" .. run, at .. "form: field 'rows': expected an integer from 2 to 10000, got 1.5")
wrong("fabric.lab.form", form .. "t.strok = 1" .. run, at .. "form: unknown field 'strok', did you mean 'stroke'?")
wrong("fabric.lab.form", form .. "t.stroke = nil" .. run, at .. "form: field 'stroke': expected a positive number in m, got nil (missing, or a misspelt variable)")
wrong("fabric.rigid.die", "fabric.rigid.die{ edge=0.01, outer=0.1, at=5 }", at .. "die: field 'at': expected a table of numbers, got 5")
wrong("fabric.rigid.die", "fabric.rigid.die{ edge=0.01, outer=0.1, name=5 }", at .. "die: field 'name': expected a string, got 5")
wrong("fabric.rigid.die", "fabric.rigid.die{ edge=0.01, outer=0.1, around=8.5 }", at .. "die: field 'around': expected an integer from 24 to 2000, got 8.5")
wrong("fabric.rigid.die", "fabric.rigid.die{ edge=0.01 }", at .. "die: field 'outer': expected a number above 0 to 1000 in m, got nil (missing, or a misspelt variable)")
wrong("fabric.rigid.die", "fabric.rigid.die{ outr=1 }", at .. "die: unknown field 'outr', did you mean 'outer'?")
wrong("fabric.rigid.dome", "fabric.rigid.dome{ radius=0.1, at=5 }", at .. "dome: field 'at': expected a table of numbers, got 5")
wrong("fabric.rigid.dome", "fabric.rigid.dome{ radius=0.1, name=5 }", at .. "dome: field 'name': expected a string, got 5")
wrong("fabric.rigid.dome", "fabric.rigid.dome{ radius=0.1, around=8.5 }", at .. "dome: field 'around': expected an integer from 24 to 2000, got 8.5")
wrong("fabric.rigid.dome", "fabric.rigid.dome{ radius=0.1, mass='1' }", at .. "dome: field 'mass': expected a number above 0 to 1e+06 in kg, got '1'")
wrong("fabric.rigid.dome", "fabric.rigid.dome{ radius=0.1, mass=-1 }", at .. "dome: field 'mass': expected a number above 0 to 1e+06 in kg, got -1")
wrong("fabric.rigid.dome", "fabric.rigid.dome{ radus=1 }", at .. "dome: unknown field 'radus', did you mean 'radius'?")
wrong("fabric.rigid.dome", "fabric.rigid.dome{}", at .. "dome: field 'radius': expected a number above 0 to 1000 in m, got nil (missing, or a misspelt variable)")
wrong("fabric.rigid.punch", "fabric.rigid.punch{ radius=0.1, name=5 }", at .. "punch: field 'name': expected a string, got 5")
wrong("fabric.rigid.punch", "fabric.rigid.punch{ radius=0.1, around=8.5 }", at .. "punch: field 'around': expected an integer from 24 to 2000, got 8.5")
wrong("fabric.lab.form", form .. "t.weft_friction = 0" .. run, at .. "form: field 'weft_friction': expected a positive number, got 0")
wrong("fabric.lab.form", form .. "t.weft_friction = 0.2 t.friction = 0" .. run, at .. "form: field 'weft_friction': expected with friction and ply_friction above 0, got 0 and 0")
wrong("fabric.lab.form", form .. "t.film = { viscosity=1 }" .. run, at .. "form: field 'film.thickness': expected a number above 0 to 1 in m, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.form", form .. "t.film = { viscosity=1, thickness=1e-4, speed=1, exponent=1.5 }" .. run, at .. "form: field 'film.exponent': expected a number above 0 to 1, got 1.5")
wrong("fabric.lab.form", form .. "t.film = { viscosity=1, thickness=1e-4, speed=-1, exponent=0.5 }" .. run, at .. "form: field 'film.speed': expected a positive number in m/s, got -1")
wrong("fabric.lab.form", form .. "t.film = { viscosity=1, thickness=1e-4, speed=1 }" .. run, at .. "contact: field 'film': expected speed and exponent, or none of them, got only speed")
wrong("fabric.lab.form", form .. "t.film = { viscosity=1e4, thickness=1e-4 }" .. run,
  at .. "dynamic: contact: field 'film': die on the cloth: explicit steps of 1.10784e-05 s carry a viscosity over thickness of at most 2023.76 Pa s/m, got 1e+08: "
    .. "a run that is faster than the process by a factor needs a viscosity that is smaller by it (or scheme=\"implicit\")")

-- Fields of another shape, and profiles.
wrong("fabric.rigid.punch", "fabric.rigid.punch{ radius=0.05, corner=0.01 }", at .. "punch: field 'corner': a punch of shape='hemisphere' has none")
wrong("fabric.rigid.die", "fabric.rigid.die{ radius=0.05, edge=0.01, outer=0.2, height=0.1 }", at .. "die: field 'height': a die of shape='hemisphere' has none")
wrong("fabric.rigid.punch", "fabric.rigid.punch{ shape='L', size={0.04, 0.1} }", at .. "punch: field 'edge': expected a length in m for shape='L', got none")
wrong("fabric.rigid.punch", "fabric.rigid.punch{ shape='Z', size={0.04, 0.1}, edge=0.005 }", at .. "punch: field 'height': expected a length in m for shape='Z', got none")
wrong("fabric.rigid.punch", "fabric.rigid.punch{ shape='L', size={0.04}, edge=0.005 }", at .. "punch: field 'size': expected {width, height}, got 1 number")
wrong("fabric.rigid.punch", "fabric.rigid.punch{ shape='L', size={0.008, 0.1}, edge=0.005 }", at .. "punch: field 'size': expected more than {0.01, ...} m, which the rounded edges take, got {0.008, ...}")
wrong("fabric.rigid.punch", "fabric.rigid.punch{ shape='L', size={0.04, 0.1}, edge=0.005, height=0.008 }", at .. "punch: field 'height': expected more than 0.01 m, which the rounded edge takes, got 0.008")
wrong("fabric.rigid.punch", "fabric.rigid.punch{ shape='L', size={0.04, 0.1}, edge=0.005, angle=30 }", at .. "punch: field 'angle': expected a number from 45 to 90 in degrees, got 30")
wrong("fabric.rigid.die", "fabric.rigid.die{ shape='L', size={0.04, 0.1}, edge=0.005, outer=0.01 }", at .. "die: field 'outer': expected more than 0.02 m, which the rounded edges take, got 0.01")
local profile = "local t = { card=fabric.card('blend', { bending='estimated' }), blank={0.08, 0.03}, punch={ shape='L', size={0.06, 0.05}, edge=0.006 }, stroke=0.02, cells=8 } "
wrong("fabric.lab.form", profile .. "t.die = { gap=1e-4 }" .. run, at .. "form: field 'die.gap': the nip of punch and die is thinner than the plies: expected at least 0.00038 m, got 0.0001")
wrong("fabric.lab.form", profile .. "t.die = { angle=60 }" .. run, at .. "form: field 'die.angle': of an L profile it is that of the punch: expected none")
wrong("fabric.lab.form", profile .. "t.die = { shape='Z' }" .. run, at .. "form: field 'die.shape': expected that of the punch, 'L', got 'Z'")
wrong("fabric.lab.form", profile .. "t.blank = {0.08, 0.06}" .. run, at .. "form: field 'punch.size': the blank is longer than the profile along y: expected more than {..., 0.06} m, got {..., 0.05}")
wrong("fabric.lab.form", profile .. "t.blank = {0.2, 0.03}" .. run,
  at .. "form: field 'punch.size': it does not cover the half of the blank that it presses: expected at least {0.1056, ...} m, got {0.06, ...}")
wrong("fabric.lab.form", profile .. "t.quarter = true" .. run, at .. "form: field 'quarter': an L profile is not symmetric about x = 0: expected the whole")
wrong("fabric.lab.form", profile .. "t.punch.shape = 'Z' t.punch.height = 0.03 t.holder = { force=10 }" .. run, at .. "form: field 'holder': the upper face of a Z punch presses where a holder would be: expected none")
wrong("fabric.lab.form", profile .. "t.stroke = 0.07" .. run, at .. "form: field 'stroke': expected at most the height of the punch, 0.06 m, got 0.07")
wrong("fabric.lab.form", form .. "t.die.gap = 0.001" .. run, at .. "form: field 'die.gap': a die of shape='hemisphere' has none")

-- Tools from files.
wrong("fabric.mesh.read", "fabric.mesh.read{ file='disc.msh', units='feet' }", at .. "read: argument 'units': expected 'm' or 'cm' or 'mm' or 'inch', got 'feet'")
wrong("fabric.lab.form", form .. "t.punch = { file='none.stl' }" .. run, at .. "form: field 'punch.units': expected 'm', 'cm', 'mm' or 'inch' beside file='none.stl', which says none")
wrong("fabric.lab.form", form .. "t.punch = { file='none.stl', units='ft' }" .. run, at .. "form: field 'punch.units': expected 'm' or 'cm' or 'mm' or 'inch', got 'ft'")
wrong("fabric.lab.form", form .. "t.punch = { file='none.stl', units='mm', radius=0.03 }" .. run, at .. "form: field 'punch.radius': expected none beside file=, whose shape it is")
wrong("fabric.lab.form", form .. "t.punch.units = 'mm'" .. run, at .. "form: field 'punch.units': expected with file= alone: other lengths are in m")
wrong("fabric.lab.form", form .. "t.die = { file='none.stl', units='mm' }" .. run, at .. "form: field 'holder.file': expected a file, as the die is one")
