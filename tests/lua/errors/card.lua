-- Wrong calls and their messages: card. Read by tests/lua/errors.lua.
-- card:check
wrong("card:check", "card:check('1')",
  "deck.lua:1: check: argument 'element_size': expected a positive number in m or a table {element_size}, got '1'")
wrong("card:check", "card:check(-1)",
  "deck.lua:1: check: argument 'element_size': expected a positive number in m or a table {element_size}, got -1")
wrong("card:check", "card:check({ element_size='1' })",
  "deck.lua:1: check: field 'element_size.element_size': expected a positive number in m, got '1'")

-- card:sample
wrong("card:sample", "card:sample()",
  "deck.lua:1: sample: argument 'n': expected an integer from 1 to 100000, got nil (missing, or a misspelt variable)")
wrong("card:sample", "card:sample(2.5)",
  "deck.lua:1: sample: argument 'n': expected an integer from 1 to 100000, got 2.5")
wrong("card:sample", "card:sample(0)",
  "deck.lua:1: sample: argument 'n': expected an integer from 1 to 100000, got 0")

-- card:with
wrong("card:with", "card:with()",
  "deck.lua:1: with: argument 'changes': expected a table, got nil (missing, or a misspelt variable)")
wrong("card:with", "card:with(5)",
  "deck.lua:1: with: argument 'changes': expected a table, got 5")

-- card:write
wrong("card:write", "card:write()",
  "deck.lua:1: write: argument 'path': expected a string, got nil (missing, or a misspelt variable)")
wrong("card:write", "card:write(7)",
  "deck.lua:1: write: argument 'path': expected a string, got 7")

-- fabric.card
wrong("fabric.card", "fabric.card()",
  "deck.lua:1: card: argument 'name': expected a string or a card, got nil (missing, or a misspelt variable)")
wrong("fabric.card", "fabric.card(7)",
  "deck.lua:1: card: argument 'name': expected a string or a card, got 7")

-- fabric.linear
wrong("fabric.linear", "fabric.linear{ naem='x' }",
  "deck.lua:1: linear: unknown field 'naem', did you mean 'name'?")
wrong("fabric.linear", "fabric.linear{ name=7 }",
  "deck.lua:1: linear: field 'name': expected a string, got 7")
wrong("fabric.linear", "fabric.linear{ density=density_ }",
  "deck.lua:1: linear: field 'density': expected a positive number in kg/m^3, got nil (missing, or a misspelt variable)")
wrong("fabric.linear", "fabric.linear{ density='1' }",
  "deck.lua:1: linear: field 'density': expected a positive number in kg/m^3, got '1'")
wrong("fabric.linear", "fabric.linear{ density=-1 }",
  "deck.lua:1: linear: field 'density': expected a positive number in kg/m^3, got -1")
wrong("fabric.linear", "fabric.linear{ density=500, thickness=0.01, bending=5 }",
  "deck.lua:1: linear: field 'bending': expected a table {warp, weft, twist, friction_warp, friction_weft, tested}, got 5")
wrong("fabric.linear", "fabric.linear{ density=500, thickness=0.01, warp=1000000, weft=1000000, shear=1000000, poisson='1' }",
  "deck.lua:1: linear: field 'poisson': expected a number above -1 to 10 or a table of numbers above -1 to 10, got '1'")

-- fabric.svk
wrong("fabric.svk", "fabric.svk{ naem='x' }",
  "deck.lua:1: svk: unknown field 'naem', did you mean 'name'?")
wrong("fabric.svk", "fabric.svk{ name=7 }",
  "deck.lua:1: svk: field 'name': expected a string, got 7")
wrong("fabric.svk", "fabric.svk{ density=density_ }",
  "deck.lua:1: svk: field 'density': expected a positive number in kg/m^3, got nil (missing, or a misspelt variable)")
wrong("fabric.svk", "fabric.svk{ density='1' }",
  "deck.lua:1: svk: field 'density': expected a positive number in kg/m^3, got '1'")
wrong("fabric.svk", "fabric.svk{ density=-1 }",
  "deck.lua:1: svk: field 'density': expected a positive number in kg/m^3, got -1")
wrong("fabric.svk", "fabric.svk{ density=500, thickness=0.01, bending=5 }",
  "deck.lua:1: svk: field 'bending': expected a table {warp, weft, twist, friction_warp, friction_weft, tested}, got 5")
wrong("fabric.svk", "fabric.svk{ density=500, thickness=0.01, poisson='1' }",
  "deck.lua:1: svk: field 'poisson': expected a number above -1 to 10 or a table of numbers above -1 to 10, got '1'")
wrong("fabric.svk", "fabric.svk{ density=500, thickness=0.01, poisson=0.01, transverse={1, 'two'} }",
  "deck.lua:1: svk: field 'transverse': expected a table of numbers above 0 in Pa, got 'two' at place 2")

-- fabric.woven
wrong("fabric.woven", "fabric.woven{ naem='x' }",
  "deck.lua:1: woven: unknown field 'naem', did you mean 'name'?")
wrong("fabric.woven", "fabric.woven{ name=7 }",
  "deck.lua:1: woven: field 'name': expected a string, got 7")
wrong("fabric.woven", "fabric.woven{ density=density_ }",
  "deck.lua:1: woven: field 'density': expected a positive number in kg/m^3, got nil (missing, or a misspelt variable)")
wrong("fabric.woven", "fabric.woven{ density='1' }",
  "deck.lua:1: woven: field 'density': expected a positive number in kg/m^3, got '1'")
wrong("fabric.woven", "fabric.woven{ density=-1 }",
  "deck.lua:1: woven: field 'density': expected a positive number in kg/m^3, got -1")
wrong("fabric.woven", "fabric.woven{ density=500, thickness=0.01, bending=5 }",
  "deck.lua:1: woven: field 'bending': expected a table {warp, weft, twist, friction_warp, friction_weft, tested}, got 5")
wrong("fabric.woven", "fabric.woven{ density=500, thickness=0.01, warp={ loading=5 } }",
  "deck.lua:1: woven: field 'warp.loading': expected a table, got 5")
wrong("fabric.woven", "fabric.woven{ density=500, thickness=0.01, warp={ loading={}, unloading=1000000, poisson=0.01 }, weft={ loading={}, unloading=1000000, poisson=0.01 }, shear={ loading={}, unloading=1000000, measure='tensro' } }",
  "deck.lua:1: woven: field 'shear.measure': expected 'tensor' or 'engineering', got 'tensro', did you mean 'tensor'?")
wrong("fabric.woven", "fabric.woven{ density=500, thickness=0.01, warp={ loading={}, unloading=1000000, poisson=0.01 }, weft={ loading={}, unloading=1000000, poisson=0.01 }, shear={ loading={}, unloading=1000000 }, shear_hysteresis='yes' }",
  "deck.lua:1: woven: field 'shear_hysteresis': expected true or false, got 'yes'")
wrong("fabric.woven", "fabric.woven{ density=500, thickness=0.01, warp={ loading={}, unloading=1000000, poisson=0.01 }, weft={ loading={}, unloading=1000000, poisson=0.01 }, shear={ loading={}, unloading=1000000 }, bands={ warp={ low={1, 'two'} } } }",
  "deck.lua:1: woven: field 'bands.warp.low': expected a table of numbers, got 'two' at place 2")

-- impossible cards
wrong("fabric.card", "fabric.card('blend', 5)",
  "deck.lua:1: card: argument 'options': expected a table {bending}, got 5")
wrong("fabric.card", "fabric.card('blend', { bendign='estimated' })",
  "deck.lua:1: card: unknown field 'options.bendign', did you mean 'options.bending'?")
wrong("fabric.card", "fabric.card('blend', { bending='estimate' })",
  "deck.lua:1: card: field 'options.bending': expected 'estimated' or 'thickness', got 'estimate', did you mean 'estimated'?")
wrong("fabric.card", "fabric.card 'denm'",
  "deck.lua:1: card: unknown fabric 'denm', did you mean 'denim'?")
wrong("fabric.card", "fabric.card './no-such-card.lua'",
  "deck.lua:1: card: cannot read './no-such-card.lua': No such file or directory")
wrong("object", "return card.warpp",
  "deck.lua:1: card: unknown field 'warpp', did you mean 'warp'?")
wrong("object", "card.thickness = 1",
  "deck.lua:1: card: field 'thickness' cannot be assigned")
wrong("card:with", "card:with{ warp={poison=1} }",
  "deck.lua:1: with: unknown field 'warp.poison', did you mean 'warp.poisson'?")
wrong("card:with", "card:with{ warp={poisson=-0.1} }",
  "deck.lua:1: with: field 'warp.poisson': expected a number of at least 0, got -0.1")
wrong("card:with", "card:with{ warp={loading={}} }",
  "deck.lua:1: with: field 'warp.loading': expected a table of numbers in Pa, got an empty table")
wrong("card:with", "card:with{ warp={loading={ {0, 0}, {0.1} }} }",
  "deck.lua:1: with: field 'warp.loading': expected {strain, stress} at point 2, got a table")
wrong("card:with", "card:with{ warp={loading={ {0, 0}, {0.1, 5}, {0.1, 6} }} }",
  "deck.lua:1: with: field 'warp.loading': expected strain and stress to increase, at point 3 they do not")
wrong("card:with", "card:with{ warp={loading={ {0.1, 0}, {0.2, 6} }} }",
  "deck.lua:1: with: field 'warp.loading': expected the first point to be {0, 0}, got {0.1, 0}")
wrong("card:with", "card:with{ shear={measure='tenser'} }",
  "deck.lua:1: with: field 'shear.measure': expected 'tensor' or 'engineering', got 'tenser', did you mean 'tensor'?")
wrong("card:with", "card:with{ bands={ warp={low={1}, high={1}, covariance={1}} } }",
  "deck.lua:1: with: field 'bands.warp.low': expected 4 numbers, got 1")
wrong("card:with", "card:with{ bending={warp=1e-5, weft=1e-5, twist=5e-6}, bands={ bending={low={1e-6, 1e-6}, high={1e-5, 1e-5, 1e-5}, covariance={0}} } }",
  "deck.lua:1: with: field 'bands.bending.low': expected 3 numbers, got 2")
wrong("card:with", "card:with{ bands={ biaxial={low={1}, high={1}, covariance={1}} } }",
  "deck.lua:1: with: field 'bands.biaxial': expected a card with biaxial of its own, got one without")
wrong("card:sample", "card:sample(3)",
  "deck.lua:1: sample: expected a woven card with bands, got one without")
wrong("card:write", "card:write '/dev/null/x.lua'",
  "deck.lua:1: write: cannot make the folder '/dev/null': Not a directory")
wrong("fabric.svk", "fabric.svk{ young=1e6, poisson=1, density=500, thickness=0.5e-3 }",
  "deck.lua:1: svk: field 'poisson': expected nu12 nu21 < 1, got 1 x 1 = 1")
wrong("fabric.svk", "fabric.svk{ young=1e6, warp=1e6, poisson=0.3, density=500, thickness=0.5e-3 }",
  "deck.lua:1: svk: field 'warp': expected either young or warp, weft and shear, got both")
wrong("fabric.svk", "fabric.svk{ warp=1e6, poisson=0.3, density=500, thickness=0.5e-3 }",
  "deck.lua:1: svk: field 'weft': expected a positive number in Pa (or young for an isotropic sheet), got nil")
wrong("fabric.svk", "fabric.svk{ young=1e6, poisson={0.1, 0.2, 0.3}, density=500, thickness=0.5e-3 }",
  "deck.lua:1: svk: field 'poisson': expected {nu12, nu21}, got 3 numbers")
wrong("fabric.svk", "fabric.svk{ young=1e6, poisson=0.3, density=500, thickness=0.5e-3, transverse={1e6} }",
  "deck.lua:1: svk: field 'transverse': expected {G13, G23}, got 1 number")
wrong("fabric.model", "fabric.model{ mesh=mesh, card=fabric.linear{ warp=2e6, weft=1e6, shear=5e5, poisson={0.2, 0.2}, density=500, thickness=0.5e-3 } }",
  "deck.lua:1: model: the card: field 'poisson': expected nu12 / E1 = nu21 / E2 (a symmetric law), got nu12 = 0.2, nu21 = 0.2 with E1 = 2 MPa, E2 = 1 MPa; nu21 = 0.1 would do")
wrong("fabric.model", "fabric.model{ mesh=mesh, card=card:with{ warp={loading={-8e6, 826e6}} } }",
  "deck.lua:1: model: card 'blend': field 'warp.loading': expected a positive modulus D up to the tested E11 = 0.2641, got D = -8 MPa at E11 = 0 (P/Du = 0)")
wrong("fabric.model", "fabric.model{ mesh=mesh, card=card:with{ warp={poisson=3} } }",
  "deck.lua:1: model: card 'blend': field 'warp.poisson': expected nu12 nu21 < 1, got 3 x 0.42 = 1.26")
wrong("fabric.model", "fabric.model{ mesh=mesh, card=card:with{ warp={unloading=1e6} } }",
  "deck.lua:1: model: card 'blend': field 'warp.loading': expected a modulus D not above unloading (1 MPa) up to the tested E11 = 0.2641, got D = 8 MPa at E11 = 0 (P/Du = 0)")

-- provenance of a card
for _, kind in ipairs { "woven", "svk", "linear" } do
  wrong("fabric." .. kind, "fabric." .. kind .. "{ density=500, thickness=4e-4, provenance='typed' }",
    "deck.lua:1: " .. kind .. ": field 'provenance': expected a table, got 'typed'")
end
wrong("card:with", "card:with{ provenance={ ['warp.loadign']='typed' } }",
  "deck.lua:1: with: field 'provenance': unknown field 'warp.loadign', did you mean 'warp.loading'?")
for _, kind in ipairs { "woven", "svk", "linear" } do
  wrong("fabric." .. kind, "fabric." .. kind .. "{ density=500, thickness=4e-4, ranges=3 }", "deck.lua:1: " .. kind .. ": field 'ranges': expected a table, got 3")
end
wrong("card:with", "card:with{ ranges={ ['warp.poison']={0, 1} } }", "deck.lua:1: with: field 'ranges': unknown field 'warp.poison', did you mean 'warp.poisson'?")
wrong("card:with", "card:with{ provenance={ ['warp.poisson']='assumed: 0.3' }, ranges={ ['warp.poisson']={0.4, 0.1} } }",
  "deck.lua:1: with: field 'ranges': expected {lowest, highest} from 0 on, ascending, for 'warp.poisson', got {0.4, 0.1}")
wrong("card:with", "card:with{ provenance={ ['warp.poisson']='assumed: 0.3' }, ranges={ ['warp.poisson']='0.1 to 0.4' } }",
  "deck.lua:1: with: field 'ranges': expected {lowest, highest} from 0 on, ascending, for 'warp.poisson', got '0.1 to 0.4'")
wrong("card:with", "card:with{ ranges={ ['warp.poisson']={0.1, 0.4} } }",
  "deck.lua:1: with: field 'ranges': expected fields whose provenance begins with assumed, got 'warp.poisson'")
wrong("card:with", "card:with{ provenance={ ['warp.loading']='guessed' } }",
  "deck.lua:1: with: field 'provenance': expected words that begin with fitted, measured, copied, typed or assumed for 'warp.loading', got 'guessed'")
wrong("fabric.woven", "fabric.woven{ density=500, thickness=0.01, through_thickness='yes' }",
  "deck.lua:1: woven: field 'through_thickness': expected true or false, got 'yes'")
wrong("fabric.woven", "fabric.woven{ density=500, thickness=4e-4, law='thesis', warp={ loading={1e6}, unloading=2e6, poisson=0, loop={ friction=0.3 } },"
  .. " weft={ loading={1e6}, unloading=2e6, poisson=0 }, shear={ loading={1e5}, unloading=3e5 } }",
  "deck.lua:1: woven: field 'warp.loop': expected law = \"potential\", the only one that takes it, got law = \"thesis\"")
wrong("fabric.woven", "fabric.woven{ density=500, thickness=0.01, bending={ warp='1' } }",
  "deck.lua:1: woven: field 'bending.warp': expected a number of at least 0 in N.m or a table, got '1'")
wrong("fabric.woven", "fabric.woven{ density=500, thickness=0.01, bending={ warp=1e-5, weft=1e-5, twist=1e-5, friction_warp={ moment=1e-4, curvature=5, memory='fade' } } }",
  "deck.lua:1: woven: field 'bending.friction_warp.memory': expected 'slip' or 'fading', got 'fade'")
wrong("fabric.svk", "fabric.svk{ density=500, thickness=0.01, through_thickness='yes' }",
  "deck.lua:1: svk: field 'through_thickness': expected true or false, got 'yes'")
wrong("fabric.svk", "fabric.svk{ density=500, thickness=0.01, bending={ warp='1' } }",
  "deck.lua:1: svk: field 'bending.warp': expected a number of at least 0 in N.m or a table, got '1'")
wrong("fabric.svk", "fabric.svk{ density=500, thickness=0.01, bending={ warp=1e-5, weft=1e-5, twist=1e-5, friction_warp={ moment=1e-4, curvature=5, memory='fade' } } }",
  "deck.lua:1: svk: field 'bending.friction_warp.memory': expected 'slip' or 'fading', got 'fade'")
wrong("fabric.linear", "fabric.linear{ density=500, thickness=0.01, through_thickness='yes' }",
  "deck.lua:1: linear: field 'through_thickness': expected true or false, got 'yes'")
wrong("fabric.linear", "fabric.linear{ density=500, thickness=0.01, bending={ warp='1' } }",
  "deck.lua:1: linear: field 'bending.warp': expected a number of at least 0 in N.m or a table, got '1'")
wrong("fabric.linear", "fabric.linear{ density=500, thickness=0.01, bending={ warp=1e-5, weft=1e-5, twist=1e-5, friction_warp={ moment=1e-4, curvature=5, memory='fade' } } }",
  "deck.lua:1: linear: field 'bending.friction_warp.memory': expected 'slip' or 'fading', got 'fade'")

-- compression, and the density of fibres
for _, kind in ipairs { "woven", "svk", "linear" } do
  local start = "fabric." .. kind .. "{ density=500, thickness=4e-4, "
  wrong("fabric." .. kind, start .. "compression=5 }",
    "deck.lua:1: " .. kind .. ": field 'compression': expected a table, got 5")
  wrong("fabric." .. kind, start .. "fibre_density='1540' }",
    "deck.lua:1: " .. kind .. ": field 'fibre_density': expected a positive number in kg/m^3, got '1540'")
end
for value, words in pairs {
  ["{ 5 }"] = "expected {gap, pressure} at point 1, got 5",
  ["{ {3e-4, 5000} }"] = "expected at least two points {gap, pressure}, got 1",
  ["{ {3e-4, 5000}, {6e-4, 6000} }"] =
    "expected a pressure that falls as the gap grows, got {0.0003, 5000} and {0.0006, 6000}",
  ["{ {3e-4, 5000}, {6e-4, -50} }"] = "expected positive gaps in m and pressures in Pa, got {0.0006, -50}",
} do
  wrong("card:with", "card:with{ compression=" .. value .. " }",
    "deck.lua:1: with: field 'compression': " .. words)
end
wrong("fabric.model", "fabric.model{ mesh=mesh, card=card:with{ fibre_density=550 } }",
  "deck.lua:1: model: card 'blend': field 'fibre_density': expected more than the cloth's own density of 590 kg/m^3, got 550 kg/m^3")
wrong("fabric.model", "fabric.model{ mesh=mesh, card=card:with{ compression={ {0.3, 5000}, {0.6, 50} } } }",
  "deck.lua:1: model: card 'blend': field 'compression': expected gaps in m that are near the thickness of 0.00038 m, got from 0.3 m to 0.6 m")
