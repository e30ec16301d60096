/** Page as a whole. */
export const PAGE = {
  title: 'Furrow studio',
  mode: 'Mode',
  tools: 'Tools',
  cancel: 'Cancel',
  dismiss: 'Dismiss',
} as const

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
  erase: 'Delete lines',
  paint: 'Paint',
  polygon: 'Polygon',
  sculpt: 'Sculpt',
  mirror: 'Mirror',
} as const

export const PLACES = {
  inspector: 'Selection',
  expressions: 'Expressions',
  sliders: 'Sliders',
  targets: 'Blendshapes',
  shapes: 'Recognised blendshapes',
  layers: 'Layers',
  drivers: 'Drivers',
  live: 'Live',
  takes: 'Takes',
  animations: 'Animations of the file',
  brush: 'Brush',
  deselect: 'Deselect',
  newLine: 'New wrinkle',
  lines: 'Lines',
  look: 'Look',
  when: 'When',
  maps: 'Maps',
  meshes: 'Meshes',
  regions: 'Regions',
  advanced: 'Advanced',
} as const

export const PREFERENCES = {
  page: 'Theme',
  system: 'System',
  systemHint: 'Follows the system',
  light: 'Light',
  dark: 'Dark',
  renderer: 'Renderer',
  webgl: 'WebGL',
  webgpu: 'WebGPU',
  wrinkles: 'Shading of wrinkles',
  default: 'Default',
  defaultHint: 'Mixes normals, computes the lighting once',
  paper: 'Paper',
  paperHint: 'Lights twice, mixes colours, is slower',
  off: 'Off',
  statistics: 'Speed and graphics card',
} as const

/** List of the avatar's meshes. */
export const MESHES = {
  show: 'Show on the stage',
  hide: 'Hide on the stage; the exported file keeps it',
  skin: 'Wrinkles on',
  unnamed: 'mesh',
} as const

/** Hints at the right while nothing can be edited. */
export const INSPECTOR = {
  making: 'The wrinkles are being made.',
  noWrinkles: 'This avatar has no wrinkles.',
  fromFile: 'These wrinkles came with the file.',
  fromFileEditable: 'These wrinkles came with the file. Select a region or a line to change it.',
  noBlendshapes: 'This mesh has no blendshapes. Select a region to see and change what shows it.',
  lineShows: 'A line shows when its region does.',
} as const

/** Message below an avatar that has no expressions and no poses, with buttons that let its joints fold it. */
export const NO_SHAPES = {
  none: 'This avatar has no blendshapes.',
  hard: 'Its joints do not fold this mesh, because it looks hard. Is it something else?',
  skeleton: 'Drag its skeleton to pose it.',
  regions: 'The sliders of its regions show its wrinkles, and so do its animations.',
  lines: 'Lines that you draw are always visible, until you let a joint show their region.',
} as const

/** Returns the sentence about a mesh that cannot get wrinkles. @param problem reason, and a remedy. */
export function cannotWrinkleLabel(mesh: string, problem: string | null): string {
  return `${mesh} cannot wrinkle: ${problem}.`
}

/** Returns the name of the button that shows or hides a mesh, for screen readers. */
export function showMeshLabel(mesh: string): string {
  return `Show ${mesh}`
}

/** Returns the label of older messages that are not shown: `and 2 more`. */
export function moreLabel(count: number): string {
  return `and ${count} more`
}

/** Returns the tooltip of a button for undo or redo: `Undo: Depth`. @param step step that the button reverts or repeats. */
export function historyLabel(command: string, step: string | undefined): string {
  return step ? `${command}: ${step}` : command
}

/** Returns the label for no selection, which means all wrinkles of the surface. @param isFace whether blendshapes move the surface. */
export function wholeLabel(isFace: boolean): string {
  return isFace ? 'Whole face' : 'All regions'
}
