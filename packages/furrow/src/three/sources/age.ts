import { AgeActivation } from '../../drivers/age.ts'
import { driversOf } from '../../drivers/types.ts'
import type { SourceType } from './source.ts'

/** Reads `wrinkles.age`. */
export const ageSource: SourceType = {
  types: ['age'],
  create(wrinkles, drivers) {
    const driver = new AgeActivation(driversOf('age', drivers))
    return { driver, update: () => driver.update(wrinkles.age) }
  },
}
