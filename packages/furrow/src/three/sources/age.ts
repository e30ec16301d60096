import { driversOf } from '../../core/driver-types.ts'
import { AgeActivation } from '../../drivers/age.ts'
import type { SourceType } from './source.ts'

/** Reads `wrinkles.age`. */
export const ageSource: SourceType = {
  types: ['age'],
  create(wrinkles, drivers) {
    const driver = new AgeActivation(driversOf('age', drivers))
    return { driver, update: () => driver.update(wrinkles.age) }
  },
}
