/** Fields and commands of a region, which the file calls an area. */
export const REGION = {
  name: 'Name in the file',
  layer: 'Layer',
  overlap: 'Overlap',
  rest: 'Always visible',
  record: 'This pose fully shows this region',
  duplicate: 'Duplicate',
  mirror: 'Copy to the other side',
  fromImage: 'From image…',
  remove: 'Delete',
  add: 'New region',
  addImage: 'Add from image…',
  paper: 'White = no wrinkles',
  reset: 'Reset',
} as const

/** Headings and texts of the tab that tells when a region shows. */
export const WHEN = {
  expressions: 'Expressions that show it',
  noExpression: 'No expression of this avatar shows it.',
  strongest: 'Strongest drivers',
  noDriver: 'No driver shows it, only its slider.',
} as const
