import type { DriverDefinition } from '../definition.ts'

/** Delays an area's activation: skin creases quickly and relaxes slowly. */
export interface TimeDriver {
  type: 'time'
  /** Name of the area. */
  area: string
  /** Time constant of a rising activation, seconds, 0..60: the time to cover 63% of the difference. */
  attack: number
  /** Time constant of a falling activation, seconds, 0..60. */
  release: number
}

/** Maximum attack or release, seconds. */
const MAX_TIME = 60

/** Exponential decay, independent of the frame rate: ten steps of 10 ms equal one of 100 ms. */
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
