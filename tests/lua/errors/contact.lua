-- Wrong calls and their messages: contact and rigid bodies. Read by tests/lua/errors.lua.
-- fabric.rigid.sphere
wrong("fabric.rigid.sphere", "fabric.rigid.sphere{ wrong=1 }",
  "deck.lua:1: sphere: unknown field 'wrong' (known: radius centre mass name)")
wrong("fabric.rigid.sphere", "fabric.rigid.sphere{}",
  "deck.lua:1: sphere: field 'radius': expected a positive number in m, got nil (missing, or a misspelt variable)")
wrong("fabric.rigid.sphere", "fabric.rigid.sphere{ radius='1' }",
  "deck.lua:1: sphere: field 'radius': expected a positive number in m, got '1'")
wrong("fabric.rigid.sphere", "fabric.rigid.sphere{ radius=-1 }",
  "deck.lua:1: sphere: field 'radius': expected a positive number in m, got -1")
wrong("fabric.rigid.sphere", "fabric.rigid.sphere{ radius=1, centre=5 }",
  "deck.lua:1: sphere: field 'centre': expected a table of numbers in m, got 5")
wrong("fabric.rigid.sphere", "fabric.rigid.sphere{ radius=1, centre={0,0,0}, mass='1' }",
  "deck.lua:1: sphere: field 'mass': expected a positive number in kg, got '1'")
wrong("fabric.rigid.sphere", "fabric.rigid.sphere{ radius=1, centre={0,0,0}, mass=-1 }",
  "deck.lua:1: sphere: field 'mass': expected a positive number in kg, got -1")
wrong("fabric.rigid.sphere", "fabric.rigid.sphere{ radius=1, centre={0,0,0}, name=5 }",
  "deck.lua:1: sphere: field 'name': expected a string, got 5")
wrong("fabric.rigid.sphere", "fabric.rigid.sphere{ radius=1, centre={0,0} }",
  "deck.lua:1: sphere: field 'centre': expected {x, y, z}, got 2 numbers")

-- fabric.rigid.plane
wrong("fabric.rigid.plane", "fabric.rigid.plane{ wrong=1 }",
  "deck.lua:1: plane: unknown field 'wrong' (known: point normal name)")
wrong("fabric.rigid.plane", "fabric.rigid.plane{}",
  "deck.lua:1: plane: field 'point': expected a table of numbers in m, got nil (missing, or a misspelt variable)")
wrong("fabric.rigid.plane", "fabric.rigid.plane{ point=5 }",
  "deck.lua:1: plane: field 'point': expected a table of numbers in m, got 5")
wrong("fabric.rigid.plane", "fabric.rigid.plane{ point={0,0,0}, normal=5 }",
  "deck.lua:1: plane: field 'normal': expected a table of numbers, got 5")
wrong("fabric.rigid.plane", "fabric.rigid.plane{ point={0,0,0}, normal={0,0,1}, name=5 }",
  "deck.lua:1: plane: field 'name': expected a string, got 5")
wrong("fabric.rigid.plane", "fabric.rigid.plane{ point={0,0,0}, normal={0,0,0} }",
  "deck.lua:1: plane: field 'normal': expected a direction {x, y, z}, got (0, 0, 0)")

-- fabric.rigid.cylinder
wrong("fabric.rigid.cylinder", "fabric.rigid.cylinder{ wrong=1 }",
  "deck.lua:1: cylinder: unknown field 'wrong' (known: radius from to mass name)")
wrong("fabric.rigid.cylinder", "fabric.rigid.cylinder{}",
  "deck.lua:1: cylinder: field 'radius': expected a positive number in m, got nil (missing, or a misspelt variable)")
wrong("fabric.rigid.cylinder", "fabric.rigid.cylinder{ radius='1' }",
  "deck.lua:1: cylinder: field 'radius': expected a positive number in m, got '1'")
wrong("fabric.rigid.cylinder", "fabric.rigid.cylinder{ radius=-1 }",
  "deck.lua:1: cylinder: field 'radius': expected a positive number in m, got -1")
wrong("fabric.rigid.cylinder", "fabric.rigid.cylinder{ radius=1, from=5 }",
  "deck.lua:1: cylinder: field 'from': expected a table of numbers in m, got 5")
wrong("fabric.rigid.cylinder", "fabric.rigid.cylinder{ radius=1, from={0,0,0}, to={0,0,1}, mass='1' }",
  "deck.lua:1: cylinder: field 'mass': expected a positive number in kg, got '1'")
wrong("fabric.rigid.cylinder", "fabric.rigid.cylinder{ radius=1, from={0,0,0}, to={0,0,1}, mass=0 }",
  "deck.lua:1: cylinder: field 'mass': expected a positive number in kg, got 0")
wrong("fabric.rigid.cylinder", "fabric.rigid.cylinder{ radius=1, from={0,0,0}, to={0,0,1}, name=5 }",
  "deck.lua:1: cylinder: field 'name': expected a string, got 5")
wrong("fabric.rigid.cylinder", "fabric.rigid.cylinder{ radius=1, from={0,0,0}, to={0,0,0} }",
  "deck.lua:1: cylinder: field 'to': expected another place than 'from'")

-- fabric.rigid.disc
wrong("fabric.rigid.disc", "fabric.rigid.disc{ wrong=1 }",
  "deck.lua:1: disc: unknown field 'wrong' (known: radius centre normal edge mass name)")
wrong("fabric.rigid.disc", "fabric.rigid.disc{}",
  "deck.lua:1: disc: field 'radius': expected a positive number in m, got nil (missing, or a misspelt variable)")
wrong("fabric.rigid.disc", "fabric.rigid.disc{ radius='1' }",
  "deck.lua:1: disc: field 'radius': expected a positive number in m, got '1'")
wrong("fabric.rigid.disc", "fabric.rigid.disc{ radius=-1 }",
  "deck.lua:1: disc: field 'radius': expected a positive number in m, got -1")
wrong("fabric.rigid.disc", "fabric.rigid.disc{ radius=1, centre=5 }",
  "deck.lua:1: disc: field 'centre': expected a table of numbers in m, got 5")
wrong("fabric.rigid.disc", "fabric.rigid.disc{ radius=1, centre={0,0,0}, normal=5 }",
  "deck.lua:1: disc: field 'normal': expected a table of numbers, got 5")
wrong("fabric.rigid.disc", "fabric.rigid.disc{ radius=1, centre={0,0,0}, normal={0,0,1}, edge='1' }",
  "deck.lua:1: disc: field 'edge': expected a positive number in m, got '1'")
wrong("fabric.rigid.disc", "fabric.rigid.disc{ radius=1, centre={0,0,0}, normal={0,0,1}, edge=0.1, mass='1' }",
  "deck.lua:1: disc: field 'mass': expected a positive number in kg, got '1'")
wrong("fabric.rigid.disc", "fabric.rigid.disc{ radius=1, centre={0,0,0}, normal={0,0,1}, edge=0.1, mass=-1 }",
  "deck.lua:1: disc: field 'mass': expected a positive number in kg, got -1")
wrong("fabric.rigid.disc", "fabric.rigid.disc{ radius=1, centre={0,0,0}, normal={0,0,1}, edge=0.1, name=5 }",
  "deck.lua:1: disc: field 'name': expected a string, got 5")
wrong("fabric.rigid.disc", "fabric.rigid.disc{ radius=1, centre={0,0,0}, normal={0,0,1}, edge=2 }",
  "deck.lua:1: disc: field 'edge': expected a length in m above 0 and below the radius of 1 m, got 2")

-- fabric.rigid.surface
wrong("fabric.rigid.surface", "fabric.rigid.surface{ wrong=1 }",
  "deck.lua:1: surface: unknown field 'wrong' (known: mesh file closed mass name)")
wrong("fabric.rigid.surface", "fabric.rigid.surface{}",
  "deck.lua:1: surface: field 'mesh': expected either a mesh or file=, got neither")
wrong("fabric.rigid.surface", "fabric.rigid.surface{ mesh=5 }",
  "deck.lua:1: surface: field 'mesh': expected a mesh, got 5")
wrong("fabric.rigid.surface", "fabric.rigid.surface{ mesh=mesh, file='a.msh' }",
  "deck.lua:1: surface: field 'mesh': expected either a mesh or file=, got both")
wrong("fabric.rigid.surface", "fabric.rigid.surface{ file=5 }",
  "deck.lua:1: surface: field 'file': expected a string, got 5")
wrong("fabric.rigid.surface", "fabric.rigid.surface{ mesh=mesh, closed=5 }",
  "deck.lua:1: surface: field 'closed': expected true or false, got 5")
wrong("fabric.rigid.surface", "fabric.rigid.surface{ mesh=mesh, mass='1' }",
  "deck.lua:1: surface: field 'mass': expected a positive number in kg, got '1'")
wrong("fabric.rigid.surface", "fabric.rigid.surface{ mesh=mesh, mass=-1 }",
  "deck.lua:1: surface: field 'mass': expected a positive number in kg, got -1")
wrong("fabric.rigid.surface", "fabric.rigid.surface{ mesh=mesh, name=5 }",
  "deck.lua:1: surface: field 'name': expected a string, got 5")
wrong("fabric.rigid.surface", "fabric.rigid.surface{ mesh=mesh, closed=true }",
  "deck.lua:1: surface: field 'closed': rigid body: expected a closed surface, whose every edge two triangles walk in opposite senses; 8 edges are not, one of them about (0.0127, 0, 0) m")

-- fabric.rigid.motion
wrong("fabric.rigid.motion", "fabric.rigid.motion{ wrong=1 }",
  "deck.lua:1: motion: unknown field 'wrong' (known: files meshes times closed name)")
wrong("fabric.rigid.motion", "fabric.rigid.motion{}",
  "deck.lua:1: motion: field 'times': expected a table of numbers in s, got nil (missing, or a misspelt variable)")
wrong("fabric.rigid.motion", "fabric.rigid.motion{ files=5, times={0} }",
  "deck.lua:1: motion: field 'files': expected a table { 'file', ... }, got 5")
wrong("fabric.rigid.motion", "fabric.rigid.motion{ files={5}, times={0} }",
  "deck.lua:1: motion: field 'files': expected a list of file names, got 5 at place 1")
wrong("fabric.rigid.motion", "fabric.rigid.motion{ meshes=5, times={0} }",
  "deck.lua:1: motion: field 'meshes': expected a table { mesh, ... }, got 5")
wrong("fabric.rigid.motion", "fabric.rigid.motion{ meshes={5}, times={0} }",
  "deck.lua:1: motion: field 'meshes': expected a list of meshes, got 5 at place 1")
wrong("fabric.rigid.motion", "fabric.rigid.motion{ meshes={mesh}, times=5 }",
  "deck.lua:1: motion: field 'times': expected a table of numbers in s, got 5")
wrong("fabric.rigid.motion", "fabric.rigid.motion{ meshes={mesh}, times={0}, name=5 }",
  "deck.lua:1: motion: field 'name': expected a string, got 5")
wrong("fabric.rigid.motion", "fabric.rigid.motion{ meshes={mesh}, times={0}, closed=5 }",
  "deck.lua:1: motion: field 'closed': expected true or false, got 5")
wrong("fabric.rigid.motion", "fabric.rigid.motion{ meshes={mesh, mesh}, times={0} }",
  "deck.lua:1: motion: field 'times': expected as many times as shapes, got 1 and 2")
wrong("fabric.rigid.motion", "fabric.rigid.motion{ meshes={mesh, mesh}, times={1, 0} }",
  "deck.lua:1: motion: field 'times': expected finite times in s that ascend, got 0 as number 2")
wrong("fabric.rigid.motion", "fabric.rigid.motion{ times={0} }",
  "deck.lua:1: motion: field 'files': expected either files or meshes={...}, got neither")

-- model:contact
wrong("model:contact", "model:contact{ wrong=1 }",
  "deck.lua:1: contact: unknown field 'wrong' (known: between self friction film thickness stiffness restitution settle)")
wrong("model:contact", "model:contact{  }",
  "deck.lua:1: contact: field 'between': expected either between={...} or self=, got neither")
wrong("model:contact", "model:contact{ between=5 }",
  "deck.lua:1: contact: field 'between': expected a table { body or set, ... }, got 5")
wrong("model:contact", "model:contact{ between={5, 'all'} }",
  "deck.lua:1: contact: field 'between': expected a rigid body or the name of a set, got 5 at place 1")
wrong("model:contact", "model:contact{ between={'all'} }",
  "deck.lua:1: contact: field 'between': expected two sides or more, got 1")
wrong("model:contact", "model:contact{ between={'al', 'top'} }",
  "deck.lua:1: contact: unknown set 'al', did you mean 'all'? known sets: all, bottom, boundary, corners, left, right, top")
wrong("model:contact", "model:contact{ self=5 }",
  "deck.lua:1: contact: field 'self': expected a string, got 5")
wrong("model:contact", "model:contact{ self='top' }",
  "deck.lua:1: contact: set 'top' holds no whole element, and so no surface")
wrong("model:contact", "model:contact{ self='all', friction='1' }",
  "deck.lua:1: contact: field 'friction': expected a number of at least 0 or a table {static, kinetic, warp, weft}, got '1'")
wrong("model:contact", "model:contact{ self='all', friction=-1 }",
  "deck.lua:1: contact: field 'friction': expected a number of at least 0 or a table {static, kinetic, warp, weft}, got -1")
wrong("model:contact", "model:contact{ self='all', friction={ static=0.2, kinetic=0.3 } }",
  "deck.lua:1: contact: field 'friction.static': expected at least the kinetic friction of 0.3, got 0.2")
wrong("model:contact", "model:contact{ self='all', friction={ static=0.2 } }",
  "deck.lua:1: contact: field 'friction': expected static and kinetic, got only static")
wrong("model:contact", "model:contact{ self='all', friction={ weft=0.2 } }",
  "deck.lua:1: contact: field 'friction': expected warp and weft, got only weft")
wrong("model:contact", "model:contact{ self='all', friction={} }",
  "deck.lua:1: contact: field 'friction': expected either static and kinetic or warp and weft, got neither")
wrong("model:contact", "model:contact{ self='all', friction={ static=0.3, kinetic=0.2, warp=0.2, weft=0.3 } }",
  "deck.lua:1: contact: field 'friction': expected either static and kinetic or warp and weft, got both")
wrong("model:contact", "model:contact{ self='all', friction={ warp=0, weft=0.3 } }",
  "deck.lua:1: contact: field 'friction.warp': expected a positive number, got 0")
wrong("model:contact", "model:contact{ self='all', film=5 }",
  "deck.lua:1: contact: field 'film': expected a table {viscosity, thickness, speed, exponent}, got 5")
wrong("model:contact", "model:contact{ self='all', film={ viscosity=1 } }",
  "deck.lua:1: contact: field 'film.thickness': expected a positive number in m, got nil (missing, or a misspelt variable)")
wrong("model:contact", "model:contact{ self='all', film={ viscosity=-1, thickness=1e-4 } }",
  "deck.lua:1: contact: field 'film.viscosity': expected a positive number in Pa s, got -1")
wrong("model:contact", "model:contact{ self='all', film={ viscosity=1, thickness=1e-4, speed=0.1 } }",
  "deck.lua:1: contact: field 'film': expected speed and exponent, or none of them, got only speed")
wrong("model:contact", "model:contact{ self='all', film={ viscosity=1, thickness=1e-4, exponent=0.5 } }",
  "deck.lua:1: contact: field 'film': expected speed and exponent, or none of them, got only exponent")
wrong("model:contact", "model:contact{ self='all', film={ viscosity=1, thickness=1e-4, speed=0, exponent=0.5 } }",
  "deck.lua:1: contact: field 'film.speed': expected a positive number in m/s, got 0")
wrong("model:contact", "model:contact{ self='all', film={ viscosity=1, thickness=1e-4, speed=0.1, exponent=1.4 } }",
  "deck.lua:1: contact: field 'film.exponent': expected a number above 0 to 1, got 1.4")
wrong("model:contact", "fabric.static{ model=held:contact{ self='all', film={ viscosity=1, thickness=1e-4 } }, duration=1 }",
  "deck.lua:1: static: contact: field 'film': nothing slides with a speed in a static run, so that a film would do nothing: expected none, or fabric.dynamic")
wrong("model:contact", "local ball = fabric.rigid.sphere{ radius=0.01, centre={0, 0, 0.02}, mass=0.1 } local plane = fabric.rigid.plane{ point={0, 0, -0.1}, normal={0, 0, 1} } "
  .. "model:contact{ between={ball, plane}, film={ viscosity=1, thickness=1e-4 } }",
  "deck.lua:1: contact: field 'film': the sphere and the plane meet each other without friction and without a film (give cloth that touches them a contact of its own)")
wrong("model:contact", "fabric.dynamic{ model=held:contact{ self='all', film={ viscosity=100, thickness=1e-4 } }, duration=1e-3 }",
  "deck.lua:1: dynamic: contact: field 'film': the cloth on itself: explicit steps of 1.12556e-05 s carry a viscosity over thickness of at most 1991.89 Pa s/m, got 1e+06: "
  .. "a run that is faster than the process by a factor needs a viscosity that is smaller by it (or scheme=\"implicit\")")
wrong("model:contact", "model:contact{ self='all', thickness='1' }",
  "deck.lua:1: contact: field 'thickness': expected a positive number in m, got '1'")
wrong("model:contact", "model:contact{ self='all', thickness=0 }",
  "deck.lua:1: contact: field 'thickness': expected a positive number in m, got 0")
wrong("model:contact", "model:contact{ self='all', stiffness='1' }",
  "deck.lua:1: contact: field 'stiffness': expected a positive number in Pa/m, got '1'")
wrong("model:contact", "model:contact{ self='all', stiffness=-1 }",
  "deck.lua:1: contact: field 'stiffness': expected a positive number in Pa/m, got -1")
wrong("model:contact", "model:contact{ self='all', settle='1' }",
  "deck.lua:1: contact: field 'settle': expected a positive number in s, got '1'")
wrong("model:contact", "model:contact{ self='all', settle=0 }",
  "deck.lua:1: contact: field 'settle': expected a positive number in s, got 0")

-- analysis:body
wrong("analysis:body", "run:body()",
  "deck.lua:1: body: argument 'body': expected a body, got nil (missing, or a misspelt variable)")
wrong("analysis:body", "run:body(5)",
  "deck.lua:1: body: argument 'body': expected a body, got 5")
wrong("analysis:body", "run:body(card)",
  "deck.lua:1: body: argument 'body': expected a body, got a card")
wrong("analysis:body", "run:body(fabric.rigid.sphere{ radius=1, centre={0,0,0} })",
  "deck.lua:1: body: nothing touches in this model: expected m:contact{...} before the run")

-- analysis:gap
wrong("analysis:gap", "run:gap()",
  "deck.lua:1: gap: nothing touches in this model: expected m:contact{...} before the run")

-- model:move
wrong("model:move", "model:move(fabric.rigid.plane{ point={0,0,0}, normal={0,0,1} }, { turn={ axis={0,0,1}, angle=1, centre=5 } })",
  "deck.lua:1: move: field 'components.turn.centre': expected a table of numbers, got 5")
wrong("model:move", "model:move(fabric.rigid.plane{ point={0,0,0}, normal={0,0,1} }, {})",
  "deck.lua:1: move: expected at least one of x, y, z, turn, got none")
wrong("model:move", "model:move(fabric.rigid.sphere{ radius=1, centre={0,0,0}, mass=1 }, { z=1 })",
  "deck.lua:1: move: the sphere has a mass and moves freely: expected a body without a mass (m:velocity gives a free one its start)")
wrong("model:move", "model:move('top', { turn=5 })",
  "deck.lua:1: move: field 'components.turn': expected a table {axis, angle, centre}, got 5")

-- model:velocity
wrong("model:velocity", "model:velocity(fabric.rigid.sphere{ radius=1, centre={0,0,0} }, { z=1 })",
  "deck.lua:1: velocity: the sphere has no mass: expected a free body (m:move drives one that is not)")

-- refusals of a run
wrong("fabric.dynamic", "fabric.dynamic{ model=model:contact{ between={fabric.rigid.sphere{ radius=0.005, centre={0.0127, 0.0381, 0.001} }, 'all'} }, duration=1e-3 }",
  "deck.lua:1: dynamic: contact: 2 pairs overlap at the start: nodes 3, 4, 5 and the sphere, one through the other; nodes 4, 6, 5 and the sphere, one through the other; expected all of it apart")
wrong("fabric.dynamic", "fabric.dynamic{ model=model:contact{ between={fabric.rigid.plane{ point={0, 0, -0.01}, normal={0, 0, 1} }, 'all'}, stiffness=1e14 }, duration=1e-3, step=1e-6 }",
  "deck.lua:1: dynamic: field 'step': expected at most 2.11755e-08 s, the largest step that contact allows (0.6 to 0.7 of the stable step of mesh and card, 1.87594e-05 s, and less where contact is stiff), got 1e-06 s (where contact is stiff, a smaller 'stiffness' of m:contact allows more; force=true uses this step all the same)")
wrong("fabric.dynamic", "fabric.dynamic{ model=model:move(fabric.rigid.plane{ point={0,0,-0.01}, normal={0,0,1} }, { z=1 }), duration=1e-3 }",
  "deck.lua:1: dynamic: model: the plane that is moved touches nothing: expected m:contact{between={it, ...}}")
wrong("fabric.dynamic", "local ball = fabric.rigid.sphere{ radius=0.005, centre={0.0127, 0.0381, 0.006} } fabric.dynamic{ model=model:contact{ between={ball, 'all'} }:move(ball, { z=function() return 0/0 end }), duration=1e-3 }",
  "deck.lua:1: dynamic: move: the sphere: field 'z': expected the history to return a finite number at t = 0 s, got nan")
wrong("fabric.static", "fabric.static{ model=model:contact{ between={fabric.rigid.sphere{ radius=0.005, centre={0.0127, 0.0381, 0.006}, mass=0.1 }, 'all'} }, duration=1, stabilise=true }",
  "deck.lua:1: static: a rigid body that forces place (a mass, m:force, m:spring, m:fix of a part) is sought by Newton's method alone: expected control=\"load\", no stabilise and no method=\"relaxation\"")
wrong("analysis:reaction", "fabric.dynamic{ model=model:contact{ self='all', thickness=1e-4 }, duration=1e-4 }:reaction(fabric.rigid.sphere{ radius=1, centre={0,0,2} })",
  "deck.lua:1: reaction: the sphere touches nothing in the model of this run")
wrong("model:contact", "model:contact{ between={fabric.rigid.plane{ point={0,0,0}, normal={0,0,1} }, fabric.rigid.sphere{ radius=1, centre={0,0,2} }} }",
  "deck.lua:1: contact: field 'between': expected cloth or a body with a mass on one side at least: bodies whose places are given do not meet each other")
wrong("model:contact", "model:contact{ self='al' }",
  "deck.lua:1: contact: unknown set 'al', did you mean 'all'? known sets: all, bottom, boundary, corners, left, right, top")
wrong("model:contact", "model:contact{ between={fabric.rigid.plane{ point={0,0,-1}, normal={0,0,1} }, 'all'}, self='all' }",
  "deck.lua:1: contact: field 'between': expected either between={...} or self=, got both")
wrong("model:move", "local plane = fabric.rigid.plane{ point={0,0,-0.01}, normal={0,0,1} } model:move(plane, { z=1 }):move(plane, { x=1 })",
  "deck.lua:1: move: the plane is moved already: expected one call with x, y, z and turn (a copy of a model leaves out the move it has with m:copy{without=\"move plane\"})")
wrong("model:velocity", "model:velocity(fabric.rigid.sphere{ radius=1, centre={0,0,2}, mass=1 }, function() return { z=1 } end)",
  "deck.lua:1: velocity: argument 'velocity': expected {x=, y=, z=, spin=} of a rigid body, got a function")
wrong("fabric.rigid.surface", "fabric.rigid.surface{ mesh=mesh, mass=1 }",
  "deck.lua:1: surface: field 'mass': rigid body: expected a closed surface, whose every edge two triangles walk in opposite senses; 8 edges are not, one of them about (0.0127, 0, 0) m")
wrong("fabric.rigid.surface", "fabric.rigid.surface{ file='no-such.msh' }",
  "deck.lua:1: surface: cannot read 'no-such.msh': No such file or directory")
wrong("fabric.rigid.sphere", "fabric.rigid.sphere{ radius=1, centre={0, 0/0, 0} }",
  "deck.lua:1: sphere: field 'centre': expected a table of numbers in m, got nan at place 2")

-- fabric.lab.ball_drop
wrong("fabric.lab.ball_drop", "fabric.lab.ball_drop{ wrong=1 }",
  "deck.lua:1: ball_drop: unknown field 'wrong' (known: card side radius mass height friction stiffness cells duration step scheme points damping every out)")
wrong("fabric.lab.ball_drop", "fabric.lab.ball_drop{}",
  "deck.lua:1: ball_drop: field 'card': expected a card, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.ball_drop", "fabric.lab.ball_drop{ card='blend' }",
  "deck.lua:1: ball_drop: field 'card': expected a card, got 'blend'")
wrong("fabric.lab.ball_drop", "fabric.lab.ball_drop{ card=card, radius='1' }",
  "deck.lua:1: ball_drop: field 'radius': expected a positive number in m, got '1'")
wrong("fabric.lab.ball_drop", "fabric.lab.ball_drop{ card=card, radius=-1 }",
  "deck.lua:1: ball_drop: field 'radius': expected a positive number in m, got -1")
wrong("fabric.lab.ball_drop", "fabric.lab.ball_drop{ card=card, cells=2.5 }",
  "deck.lua:1: ball_drop: field 'cells': expected an integer of at least 4, got 2.5")

-- fabric.lab.capstan
wrong("fabric.lab.capstan", "fabric.lab.capstan{ wrong=1 }",
  "deck.lua:1: capstan: unknown field 'wrong' (known: card radius wrap friction tension width around lead draw step stiffness)")
wrong("fabric.lab.capstan", "fabric.lab.capstan{}",
  "deck.lua:1: capstan: field 'card': expected a card, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.capstan", "fabric.lab.capstan{ card='blend' }",
  "deck.lua:1: capstan: field 'card': expected a card, got 'blend'")
wrong("fabric.lab.capstan", "fabric.lab.capstan{ card=card, radius='1' }",
  "deck.lua:1: capstan: field 'radius': expected a positive number in m, got '1'")
wrong("fabric.lab.capstan", "fabric.lab.capstan{ card=card, radius=-1 }",
  "deck.lua:1: capstan: field 'radius': expected a positive number in m, got -1")
wrong("fabric.lab.capstan", "fabric.lab.capstan{ card=card, draw=0.3, lead=2 }",
  "deck.lua:1: capstan: field 'lead': expected at least 12, got 2: the held edge comes onto the cylinder")
wrong("fabric.lab.capstan", "fabric.lab.capstan{ card=card, draw=0.5 }",
  "deck.lua:1: capstan: field 'draw': expected less than 0.5, got 0.5: the held edge comes onto the cylinder")
wrong("fabric.lab.capstan", "fabric.lab.capstan{ card=card, around=2.5 }",
  "deck.lua:1: capstan: field 'around': expected an integer of at least 4, got 2.5")

-- fabric.lab.ball_drop
wrong("fabric.lab.ball_drop", "fabric.lab.ball_drop{ card=card, scheme='explicti' }",
  "deck.lua:1: ball_drop: field 'scheme': expected 'explicit' or 'implicit', got 'explicti', did you mean 'explicit'?")
wrong("fabric.lab.ball_drop", "fabric.lab.ball_drop{ card=card, out=7 }",
  "deck.lua:1: ball_drop: field 'out': expected a string, got 7")
wrong("fabric.lab.ball_drop", "fabric.lab.ball_drop{ card=card, height=1e-5 }",
  "deck.lua:1: ball_drop: field 'height': expected at least the clearance of 0.0001 m, got 1e-05 m")

-- forces, springs and supports of rigid bodies
local ball = "local ball = fabric.rigid.sphere{ radius=0.005, centre={0.0127, 0.0381, 0.006} } "
wrong("model:fix", ball .. "model:fix(ball, 5)", "deck.lua:1: fix: argument 'freedoms': expected a string, got 5")
wrong("model:fix", ball .. "model:fix(ball, 'rx')",
  "deck.lua:1: fix: the sphere would turn about two axes: expected all of rx ry rz (\"rotation\"), two of them or none")
wrong("model:fix", ball .. "model:move(ball, { z=1e-3 }):fix(ball, 'x')",
  "deck.lua:1: fix: the sphere is moved by m:move, which gives its whole place: expected a body that is not moved")
wrong("model:force", ball .. "model:force(ball, { z=1 }):move(ball, { z=1e-3 })",
  "deck.lua:1: move: the sphere has forces, springs or supports of its own, which decide where it is: expected these, or m:move, which gives its whole place")
wrong("model:force", ball .. "model:force(ball, {})", "deck.lua:1: force: expected at least one of x, y, z, got none")
wrong("model:force", ball .. "fabric.dynamic{ model=model:contact{ between={ball, 'all'} }:force(ball, { z=1 }), duration=1e-4 }",
  "deck.lua:1: dynamic: forces, springs or supports place the sphere, which has no mass: expected mass= where it is made (fabric.static needs none)")
wrong("model:spring", ball .. "model:spring(ball, { z=10 }, { to=5 })", "deck.lua:1: spring: field 'options.to': expected a table of numbers or a body, got 5")
wrong("model:spring", ball .. "model:spring(ball, { z=10 }, { to={1, 2} })", "deck.lua:1: spring: field 'options.to': expected {x, y, z}, got 2 numbers")
wrong("model:spring", ball .. "model:spring(ball, { z=10 }, { to=ball })", "deck.lua:1: spring: the sphere: field 'to': expected another body than itself")
wrong("model:spring", "model:spring('top', { z=10 }, { to={0, 0, 1} })",
  "deck.lua:1: spring: field 'options.to': expected a rigid body as what is tied, got the set 'top', whose springs go to the ground")
wrong("model:damper", "model:damper()", "deck.lua:1: damper: argument 'set': expected a body, got nil (missing, or a misspelt variable)")
wrong("model:damper", "model:damper('top', { z=1 })", "deck.lua:1: damper: argument 'set': expected a body, got 'top'")
wrong("model:damper", ball .. "model:damper(ball, 5)", "deck.lua:1: damper: argument 'rate': expected a table {x, y, z}, got 5")
wrong("model:damper", ball .. "model:damper(ball)", "deck.lua:1: damper: argument 'rate': expected a table {x, y, z}, got nil (missing, or a misspelt variable)")
wrong("model:damper", ball .. "model:damper(ball, { z='1' })", "deck.lua:1: damper: field 'rate.z': expected a number of at least 0 in N s/m, got '1'")
wrong("model:damper", ball .. "model:damper(ball, { z=-1 })", "deck.lua:1: damper: field 'rate.z': expected a number of at least 0 in N s/m, got -1")
wrong("model:damper", ball .. "model:damper(ball, {})", "deck.lua:1: damper: expected at least one of x, y, z above 0, got none")
wrong("model:damper", ball .. "model:damper(ball, { z=1 }, { wrong=1 })", "deck.lua:1: damper: unknown field 'options.wrong', did you mean 'options.to'?")
wrong("model:damper", ball .. "model:damper(ball, { z=1 }, { to=5 })", "deck.lua:1: damper: field 'options.to': expected a table of numbers or a body, got 5")
wrong("model:damper", ball .. "model:damper(ball, { z=1 }, { to={0, 0, 1} })",
  "deck.lua:1: damper: field 'options.to': a damper has no place at which it is slack: expected a rigid body")
