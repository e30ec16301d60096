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
