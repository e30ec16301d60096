import type { DriverDefinition } from '../definition.ts'

/** Lets an area follow its drivers with a delay: skin creases quickly and relaxes slowly. */
export interface TimeDriver {
  type: 'time'
  area: string
  /** Seconds in which it covers 63% of the remaining difference, as it grows and as it fades. */
  attack: number
  release: number
}

/** Longest attack or release, seconds. */
const SLOWEST = 60

/**
 * What remains shrinks exponentially, so that ten steps of a hundredth of a second and one of a tenth give the same. Of
 * several for one area the last one counts.
 */
export const time: DriverDefinition<TimeDriver> = {
  type: 'time',
  read: (fields) => ({
    area: fields.area(),
    attack: fields.number('attack', 0, SLOWEST, 0),
    release: fields.number('release', 0, SLOWEST, 0),
  }),
  describe: ({ area, attack, release }) => `${area} follows in ${attack} s, fades in ${release} s`,
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
