import { driversOf } from '../../core/driver-types.ts'
import { AgeActivation } from '../../drivers/age.ts'
import type { SourceType } from './source.ts'

/** Reads `wrinkles.age`. */
export const ageSource: SourceType = {
  type: 'age',
  create(wrinkles, drivers) {
    const driver = new AgeActivation(driversOf('age', drivers))
    return { type: 'age', driver, update: () => driver.update(wrinkles.age) }
  },
}
