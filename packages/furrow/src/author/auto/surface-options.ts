import type { ChosenSurface } from './character/choose-surfaces.ts'
import type { AutoOptions } from './options.ts'

/**
 * Returns the options of `autoWrinkles` for a surface of a character. Only the first surface of a character gets fine furrows.
 *
 * @param options options of the character.
 */
export function surfaceOptions(
  { tubes = false, cloth }: Partial<Pick<ChosenSurface<unknown>, 'tubes' | 'cloth'>>,
  { furrows = false, cloth: _, ...options }: AutoOptions,
  isFirst: boolean,
): AutoOptions {
  if (cloth === undefined) return { ...options, tubes, furrows: furrows && isFirst }
  return { ...options, tubes, furrows: false, cloth }
}
