import type { DriverDefinition } from '../definition.ts'

/** Driver that delays the activation of an area (a group of wrinkles), because skin creases quickly and relaxes slowly. */
export interface TimeDriver {
  type: 'time'
  /** Name of the area. */
  area: string
  /** Time constant of a rising activation in seconds, 0..60. If the target jumps, the activation covers 63% of the jump in this time. */
  attack: number
  /** Time constant of a falling activation in seconds, 0..60. */
  release: number
}

/** Maximum of `attack` and `release`, in seconds. */
const MAX_TIME = 60

/** The activation approaches its target exponentially. The result does not depend on the frame rate: ten steps of 10 ms equal one of 100 ms. */
export const time: DriverDefinition<TimeDriver> = {
  type: 'time',
  read: (fields) => ({
    area: fields.area(),
    attack: fields.number('attack', 0, MAX_TIME, 0),
    release: fields.number('release', 0, MAX_TIME, 0),
  }),
  describe: ({ area, attack, release }) => `time: ${area} rises in ${attack} s, falls in ${release} s`,
  filterActivation: ({ area, attack, release }) => ({
    area,
    bind: (index) => (activations, previous, seconds) => {
      const difference = activations[index] - previous[index]
      const constant = difference > 0 ? attack : release
      if (constant > 0) previous[index] += difference * (1 - Math.exp(-seconds[0] / constant))
      else previous[index] = activations[index]
      activations[index] = previous[index]
    },
  }),
}
