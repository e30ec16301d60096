import type { Variant } from '../variant.ts'

/** The face with its normal map and no wrinkles. */
export const variant: Variant = {
  canShow: () => true,
  apply: () => ({ setActivation() {}, dispose() {} }),
}
