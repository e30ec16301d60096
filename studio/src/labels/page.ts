export const MODES = {
  look: 'Look',
  lines: 'Lines',
  paint: 'Paint',
  motion: 'Motion',
} as const

export const TOOLS = {
  select: 'Select',
  draw: 'Draw a wrinkle',
  bend: 'Bend',
  smooth: 'Smooth',
  erase: 'Erase',
  paint: 'Paint',
  polygon: 'Polygon',
  mirror: 'Mirror',
} as const

export const PLACES = {
  inspector: 'Selection',
  expressions: 'Expressions',
  sliders: 'Sliders',
  targets: 'Blendshapes',
  shapes: 'Shapes',
  layers: 'Layers',
  drivers: 'Drivers',
  animation: 'Animation',
  brush: 'Brush',
  wholeFace: 'Whole face',
  newLine: 'New wrinkle',
  look: 'Look',
  when: 'When',
  maps: 'Maps',
  meshes: 'Meshes',
  regions: 'Regions',
  advanced: 'Advanced',
} as const

export const PREFERENCES = {
  renderer: 'Renderer',
  wrinkles: 'Wrinkles',
  page: 'Theme',
  statistics: 'Statistics',
} as const
