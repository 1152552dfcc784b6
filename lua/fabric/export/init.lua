-- fabric.export: cards, meshes and whole models for other programs; fabric.import: the reverse.
local later = require "fabric.define".later
later("fabric.export.card", "export.card")
later("fabric.export.model", "export.model")
later("fabric.export.import", "import.card")
later("fabric.export.mesh", "export.mesh")
