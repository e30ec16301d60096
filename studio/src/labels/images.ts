/** Dialog that asks what dropped images are. */
export const IMAGE = {
  question: 'What is this image?',
  questions: 'What are these images?',
  mask: 'Region (mask)',
  normal: 'Normal map',
  height: 'Height map',
  baseColor: 'Colour map',
  add: 'Add',
} as const
