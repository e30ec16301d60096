/** Ways to combine the inputs of a driver. */
export const RULES = {
  together: 'Together',
  sum: 'Added',
  max: 'The largest',
  min: 'The smallest: all are needed',
  product: 'Multiplied',
} as const

/** Form of a driver by age. */
export const AGE = {
  input: 'Age, years',
  now: 'Age now',
} as const

/** Form of a driver by a joint. */
export const BONE = {
  joint: 'Joint',
  relativeTo: 'Relative to',
  from: 'From',
  measure: 'Measure',
  angle: 'Angle',
  distance: 'Distance',
  about: 'About',
  anyAxis: 'Any axis',
  oneAxis: 'One axis',
  axis: 'Axis at rest',
} as const

/** Form of an expression that shows a region. */
export const EXPRESSION = {
  name: 'Name',
  activation: 'Shows it by',
  neutral: 'The face at rest',
  takePose: 'Take the present pose',
} as const

/** Form of a driver by a number of the application. */
export const INPUT = {
  name: 'Name',
  hint: 'The application sets this number while it runs.',
  try: 'Try',
} as const

/** Form of a virtual muscle. */
export const MUSCLE = {
  name: 'Name',
  hint: 'Pulls the skin, and shows the area as it contracts. It is one of the blendshapes.',
  fibres: 'Fibres',
  linear: 'Fan',
  sheet: 'Sheet',
  sphincter: 'Ring',
  strength: 'Strength',
  inner: 'Peak at',
  outer: 'Ends at',
  angle: 'Opens by',
  width: 'Half its width',
  bone: 'Bone',
  skin: 'Skin',
  centre: 'Centre',
  edge: 'Edge',
} as const

/** Form of a driver by the tension of the skin. */
export const TENSION = {
  shortened: 'Shortened by',
  lengthened: 'Lengthened by',
  measure: 'Skin is',
  compression: 'Pushed together',
  stretch: 'Stretched',
  along: 'Along',
  anyDirection: 'Any direction',
  oneDirection: 'One direction of the texture',
  angle: 'Angle',
} as const

/** Form of a delay. */
export const DELAY = {
  attack: 'Rises in, s',
  release: 'Falls in, s',
  hint: 'Skin creases quickly and relaxes slowly. Here the area follows at once; the delay plays in the exported file.',
} as const
