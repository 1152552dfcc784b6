-- Wrong calls and their messages: model. Read by tests/lua/errors.lua.
-- fabric.model
wrong("fabric.model", "fabric.model{ mehs=mesh }",
  "deck.lua:1: model: unknown field 'mehs', did you mean 'mesh'?")
wrong("fabric.model", "fabric.model{ mesh=mesh_ }",
  "deck.lua:1: model: field 'mesh': expected a mesh, got nil (missing, or a misspelt variable)")
wrong("fabric.model", "fabric.model{ mesh=card }",
  "deck.lua:1: model: field 'mesh': expected a mesh, got a card")
wrong("fabric.model", "fabric.model{ mesh=mesh, card='blend' }",
  "deck.lua:1: model: field 'card': expected a card, got 'blend'")
wrong("fabric.model", "fabric.model{ mesh=mesh, layers=5 }",
  "deck.lua:1: model: field 'layers': expected a table { {card=, warp=, thickness=, name=}, ... }, got 5")
wrong("fabric.model", "fabric.model{ mesh=mesh, thickness='1' }",
  "deck.lua:1: model: field 'thickness': expected a positive number in m, got '1'")
wrong("fabric.model", "fabric.model{ mesh=mesh, thickness=-1 }",
  "deck.lua:1: model: field 'thickness': expected a positive number in m, got -1")
wrong("fabric.model", "fabric.model{ mesh=mesh, warp='1' }",
  "deck.lua:1: model: field 'warp': expected a number in degrees or a table of numbers in degrees or a function, got '1'")
wrong("fabric.model", "fabric.model{ mesh=mesh, points=2.5 }",
  "deck.lua:1: model: field 'points': expected an integer from 1 to 9, got 2.5")
wrong("fabric.model", "local m = fabric.mesh{ nodes={ {0, 0}, {1, 0}, {1, 1} }, elements={ {1, 2, 3}, {2, 3, 1} } } fabric.model{ mesh=m, card=card, warp=0 }",
  "deck.lua:1: model: element 2 of the mesh is on the same nodes as an element before: expected each piece of cloth once (plies are a field of the model)")

-- model:fix
wrong("model:fix", "model:fix()",
  "deck.lua:1: fix: argument 'set': expected a string or a body, got nil (missing, or a misspelt variable)")
wrong("model:fix", "model:fix(7)",
  "deck.lua:1: fix: argument 'set': expected a string or a body, got 7")
wrong("model:fix", "model:fix('top', 'x', 5)",
  "deck.lua:1: fix: argument 'options': expected a table {frame}, got 5")
wrong("model:fix", "model:fix('top', 'x', { frame=5 })",
  "deck.lua:1: fix: field 'options.frame': expected a table {e1, e2}, got 5")

-- model:force
wrong("model:force", "model:force()",
  "deck.lua:1: force: argument 'set': expected a string or a body, got nil (missing, or a misspelt variable)")
wrong("model:force", "model:force(7)",
  "deck.lua:1: force: argument 'set': expected a string or a body, got 7")
wrong("model:force", "model:force('top', 5)",
  "deck.lua:1: force: argument 'components': expected a table {x, y, z}, got 5")
wrong("model:force", "model:force('top', { x='1' })",
  "deck.lua:1: force: field 'components.x': expected a number in N or a function or a history, got '1'")
wrong("model:force", "model:force('top', {  }, { frame=5 })",
  "deck.lua:1: force: field 'options.frame': expected a table {e1, e2}, got 5")

-- model:gravity
wrong("model:gravity", "model:gravity()",
  "deck.lua:1: gravity: argument 'acceleration': expected a table {gx, gy, gz}, got nil (missing, or a misspelt variable)")
wrong("model:gravity", "model:gravity(5)",
  "deck.lua:1: gravity: argument 'acceleration': expected a table {gx, gy, gz}, got 5")

-- model:moment
wrong("model:moment", "model:moment()",
  "deck.lua:1: moment: argument 'set': expected a string or a body, got nil (missing, or a misspelt variable)")
wrong("model:moment", "model:moment(7)",
  "deck.lua:1: moment: argument 'set': expected a string or a body, got 7")
wrong("model:moment", "model:moment('top', 5)",
  "deck.lua:1: moment: argument 'components': expected a table {x, y, z}, got 5")
wrong("model:moment", "model:moment('top', { x='1' })",
  "deck.lua:1: moment: field 'components.x': expected a number in N m or a function or a history, got '1'")
wrong("model:moment", "model:moment('top', {  }, { frame=5 })",
  "deck.lua:1: moment: field 'options.frame': expected a table {e1, e2}, got 5")

-- model:move
wrong("model:move", "model:move()",
  "deck.lua:1: move: argument 'set': expected a string or a body, got nil (missing, or a misspelt variable)")
wrong("model:move", "model:move(7)",
  "deck.lua:1: move: argument 'set': expected a string or a body, got 7")
wrong("model:move", "model:move('top', 5)",
  "deck.lua:1: move: argument 'components': expected a table {x, y, z, turn}, got 5")
wrong("model:move", "model:move('top', { x='1' })",
  "deck.lua:1: move: field 'components.x': expected a number in m or a function or a history, got '1'")
wrong("model:move", "model:move('top', {  }, { frame=5 })",
  "deck.lua:1: move: field 'options.frame': expected a table {e1, e2}, got 5")

-- model:pressure
wrong("model:pressure", "model:pressure('1')",
  "deck.lua:1: pressure: argument 'value': expected a number in Pa or a function or a history, got '1'")
wrong("model:pressure", "model:pressure()",
  "deck.lua:1: pressure: argument 'value': expected a number in Pa or a function or a history, got nil (missing, or a misspelt variable)")
wrong("model:pressure", "model:pressure(5, 7)",
  "deck.lua:1: pressure: argument 'set': expected a string, got 7")

-- model:spring
wrong("model:spring", "model:spring()",
  "deck.lua:1: spring: argument 'set': expected a string or a body, got nil (missing, or a misspelt variable)")
wrong("model:spring", "model:spring(7)",
  "deck.lua:1: spring: argument 'set': expected a string or a body, got 7")
wrong("model:spring", "model:spring('top', 5)",
  "deck.lua:1: spring: argument 'stiffness': expected a table {x, y, z}, got 5")
wrong("model:spring", "model:spring('top', { x='1' })",
  "deck.lua:1: spring: field 'stiffness.x': expected a number of at least 0 in N/m, got '1'")
wrong("model:spring", "model:spring('top', { x=-1 })",
  "deck.lua:1: spring: field 'stiffness.x': expected a number of at least 0 in N/m, got -1")
wrong("model:spring", "model:spring('top', {  }, { frame=5 })",
  "deck.lua:1: spring: field 'options.frame': expected a table {e1, e2}, got 5")

-- model:symmetry
wrong("model:symmetry", "model:symmetry()",
  "deck.lua:1: symmetry: argument 'set': expected a string, got nil (missing, or a misspelt variable)")
wrong("model:symmetry", "model:symmetry(7)",
  "deck.lua:1: symmetry: argument 'set': expected a string, got 7")

-- model:tie
wrong("model:tie", "model:tie()",
  "deck.lua:1: tie: argument 'kind': expected a string, got nil (missing, or a misspelt variable)")
wrong("model:tie", "model:tie(7)",
  "deck.lua:1: tie: argument 'kind': expected a string, got 7")

-- model:traction
wrong("model:traction", "model:traction()",
  "deck.lua:1: traction: argument 'set': expected a string, got nil (missing, or a misspelt variable)")
wrong("model:traction", "model:traction(7)",
  "deck.lua:1: traction: argument 'set': expected a string, got 7")
wrong("model:traction", "model:traction('top', 5)",
  "deck.lua:1: traction: argument 'components': expected a table {x, y, z}, got 5")
wrong("model:traction", "model:traction('top', { x='1' })",
  "deck.lua:1: traction: field 'components.x': expected a number in N/m^2 or N/m or a function or a history, got '1'")
wrong("model:traction", "model:traction('top', {  }, { frame=5 })",
  "deck.lua:1: traction: field 'options.frame': expected a table {e1, e2}, got 5")

-- model:turn
wrong("model:turn", "model:turn()",
  "deck.lua:1: turn: argument 'set': expected a string, got nil (missing, or a misspelt variable)")
wrong("model:turn", "model:turn(7)",
  "deck.lua:1: turn: argument 'set': expected a string, got 7")
wrong("model:turn", "model:turn('top', 5)",
  "deck.lua:1: turn: argument 'motion': expected a table {axis, angle, centre}, got 5")
wrong("model:turn", "model:turn('top', { axis={1, 'two'} })",
  "deck.lua:1: turn: field 'motion.axis': expected a table of numbers, got 'two' at place 2")
wrong("model:turn", "model:turn('top', { axis={0.01, 0.01}, angle='1' })",
  "deck.lua:1: turn: field 'motion.angle': expected a number in degrees or a function or a history, got '1'")

-- model:velocity
wrong("model:velocity", "model:velocity()",
  "deck.lua:1: velocity: argument 'set': expected a string or a body, got nil (missing, or a misspelt variable)")
wrong("model:velocity", "model:velocity(7)",
  "deck.lua:1: velocity: argument 'set': expected a string or a body, got 7")
wrong("model:velocity", "model:velocity('top', 5)",
  "deck.lua:1: velocity: argument 'velocity': expected a table {x, y, z, spin, centre} or a function, got 5")
wrong("model:velocity", "model:velocity('top', { x='1' })",
  "deck.lua:1: velocity: field 'velocity.x': expected a number in m/s, got '1'")
wrong("model:velocity", "model:velocity('top', { spin={1, 'two'} })",
  "deck.lua:1: velocity: field 'velocity.spin': expected a table of numbers, got 'two' at place 2")
wrong("model:velocity", "model:velocity('top', {})",
  "deck.lua:1: velocity: expected at least one of x, y, z, spin, got none")
wrong("model:velocity", "model:velocity('top', { x=1, centre={0, 0, 0} })",
  "deck.lua:1: velocity: field 'velocity.centre': expected a spin about it too, got none")

-- impossible models
wrong("fabric.model", "fabric.model{ mesh=mesh, card='blend' }",
  "deck.lua:1: model: field 'card': expected a card, got 'blend'")
wrong("fabric.model", "fabric.model{ mesh=mesh }",
  "deck.lua:1: model: field 'card': expected either a card or layers={ {card=}, ... }, got neither")
wrong("fabric.model", "fabric.model{ mesh=mesh, layers={} }",
  "deck.lua:1: model: field 'layers': expected at least one layer, got an empty table")
wrong("fabric.model", "fabric.model{ mesh=mesh, layers={ {card='blend'} } }",
  "deck.lua:1: model: field 'layers[1].card': expected a card, got 'blend'")
wrong("fabric.model", "fabric.model{ mesh=mesh, layers={ 'blend' } }",
  "deck.lua:1: model: field 'layers': expected a list of tables {card=, warp=, thickness=, name=}, got 'blend'")
wrong("fabric.model", "fabric.model{ mesh=mesh, card=card, warp={1, 0} }",
  "deck.lua:1: model: field 'warp': expected {x, y, z}, got 2 numbers")
wrong("fabric.model", "fabric.model{ mesh=fabric.mesh.cylinder{ radius=0.1, length=0.1, around=8, along=2 }, card=card }",
  "deck.lua:1: model: field 'warp': expected a direction {x,y,z}, an angle in degrees or a function, got nil: this mesh is not a flat generated one, so the warp has no default")
wrong("model:fix", "model:fix('botom', 'x')",
  "deck.lua:1: fix: unknown set 'botom', did you mean 'bottom'? known sets: all, bottom, boundary, corners, left, right, top")
wrong("model:fix", "model:fix('bottom', 'x w')",
  "deck.lua:1: fix: unknown freedom 'w', expected some of x y z rx ry rz rotation")
wrong("model:fix", "model:fix('bottom', 'x', { frame={ {1, 0}, {0, 1} } })",
  "deck.lua:1: fix: argument 'options.frame': expected {x, y, z}, got 2 numbers")
wrong("model:move", "model:move('top', {})",
  "deck.lua:1: move: expected at least one of x, y, z, got none")
wrong("model:move", "model:move('top', {w=1})",
  "deck.lua:1: move: unknown field 'components.w', did you mean 'components.x'?")
wrong("model:move", "model:move('tpo', {x=1})",
  "deck.lua:1: move: unknown set 'tpo', did you mean 'top'? known sets: all, bottom, boundary, corners, left, right, top")
wrong("model:force", "model:force('tpo', {x=1})",
  "deck.lua:1: force: unknown set 'tpo', did you mean 'top'? known sets: all, bottom, boundary, corners, left, right, top")
wrong("model:gravity", "model:gravity{0, 0}",
  "deck.lua:1: gravity: argument 'acceleration': expected {gx, gy, gz}, got 2 values")
wrong("model:gravity", "model:gravity{0, 0, 'g'}",
  "deck.lua:1: gravity: argument 'acceleration[3]': expected a number, a function or a history, got 'g'")
wrong("model:symmetry", "model:symmetry('left', 'w')",
  "deck.lua:1: symmetry: argument 'normal': expected \"x\", \"y\" or \"z\", got \"w\"")
wrong("model:turn", "model:turn('top', { axis={1, 0}, angle=90 })",
  "deck.lua:1: turn: field 'axis': expected {x, y, z}, got 2 numbers")
wrong("model:velocity", "model:velocity('top', { spin={1} })",
  "deck.lua:1: velocity: field 'spin': expected {x, y, z}, got 1 number")
wrong("model:tie", "model:tie('rigid', 'top', 7)",
  "deck.lua:1: tie: argument 'second': expected a string or a body, got 7")
wrong("model:tie", "model:tie('rigid', 'top', nil)",
  "deck.lua:1: tie: argument 'second': expected a string or a body, or no value, got nil (a misspelt variable?)")
wrong("model:tie", "model:tie('rigid', 'top', card)",
  "deck.lua:1: tie: argument 'second': expected a string or a body, got a card")
wrong("model:tie", "model:tie('equal', 'top', fabric.rigid.sphere{ radius=0.1, centre={0, 0, 1}, name='ball' })",
  "deck.lua:1: tie: argument 'second': expected a text: a body is tied to by kind 'rigid' alone")
wrong("model:tie", "model:tie('rigid', 'top', fabric.rigid.sphere{ radius=0.1, centre={0, 0, 1} })",
  "deck.lua:1: tie: argument 'second': expected a body with a name, as fabric.rigid.disc{ name='plate', ... }")
wrong("model:tie", "model:tie('rigid', 'top', fabric.rigid.sphere{ radius=0.1, centre={0, 0, 1}, name='ball' }); fabric.static{ model=model, duration=1 }",
  "deck.lua:1: static: tie: the body 'ball' neither touches anything nor closes gas: expected m:contact{between={it, ...}} or lids= of m:gas")
wrong("model:tie", "model:tie('equl', 'top')",
  "deck.lua:1: tie: argument 'kind': expected \"equal\", \"straight\", \"rigid\" or \"periodic\", got \"equl\"")
wrong("model:spring", "model:spring('top', {})",
  "deck.lua:1: spring: expected at least one of x, y, z above 0, got none")
wrong("object", "return model.thicknes",
  "deck.lua:1: model: unknown field 'thicknes', did you mean 'thickness'?")
wrong("model:fix", "local _ = run; model:fix('top', 'y')",
  "deck.lua:1: fix: the model is in use by an analysis and can't be changed any more")

-- model:remove
wrong("model:remove", "model:remove()",
  "deck.lua:1: remove: argument 'row': expected an integer or a table {kind, set, what}, got nil (missing, or a misspelt variable)")
wrong("model:remove", "model:remove('x')",
  "deck.lua:1: remove: argument 'row': expected an integer or a table {kind, set, what}, got 'x'")
wrong("model:remove", "model:remove{ kind=5, set='top' }",
  "deck.lua:1: remove: field 'row.kind': expected a string, got 5")

-- planes of symmetry, and names of layers
wrong("model:symmetry", "fabric.static{ model=model:symmetry('bottom', 'x'), duration=1 }",
  "deck.lua:1: static: symmetry: set 'bottom': expected nodes in a plane normal to x, got x from 0 to 0.0254 m")
wrong("model:symmetry", "fabric.static{ model=fabric.model{ mesh=mesh, card=card, warp=20 }:symmetry('left', 'x'), duration=1 }",
  "deck.lua:1: static: symmetry: set 'left': the cloth of element 1 is not symmetric about the plane, whose normal lies at 20 degrees to the warp: expected warp and weft along and across the plane; or the whole model")
wrong("fabric.model", "fabric.model{ mesh=mesh, card=card, folds='elements' }",
  "deck.lua:1: model: field 'folds': expected 'resolved' or 'within elements' or 'free', got 'elements'")
wrong("fabric.model", "fabric.model{ mesh=mesh, card=card:with{ folds='free', law='thesis' } }",
  "deck.lua:1: model: card 'blend': field 'folds': expected \"resolved\", or law = \"potential\", got \"free\"")
wrong("fabric.model", "fabric.model{ mesh=mesh, card=card, yarns='ful' }",
  "deck.lua:1: model: field 'yarns': expected 'eased' or 'full', got 'ful', did you mean 'full'?")
wrong("fabric.model", "fabric.model{ mesh=mesh, card=card, membrane=7 }",
  "deck.lua:1: model: field 'membrane': expected true or false, got 7")
wrong("fabric.model", "fabric.model{ mesh=mesh, card=card, offset=1, membrane=true }",
  "deck.lua:1: model: field 'membrane': expected a card without layers and offset, of which a membrane knows nothing")
wrong("fabric.model", "fabric.model{ mesh=mesh, layers={ { card=card, name='ply2' } } }",
  "deck.lua:1: model: field 'layers[1].name': expected a name without blanks and full stops, other than ply1, ply2, ..., got 'ply2'")
wrong("fabric.model", "fabric.model{ mesh=mesh, layers={ { card=card, name='face' }, { card=card, name='face' } } }",
  "deck.lua:1: model: field 'layers[2].name': expected a name of its own, got 'face' twice")
wrong("fabric.model", "fabric.model{ mesh=mesh, layers={ { card=card, name=7 } } }",
  "deck.lua:1: model: field 'layers[1].name': expected a string, got 7")
