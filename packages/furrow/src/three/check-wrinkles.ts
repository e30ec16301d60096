import { wrongArgument } from '../core/argument.ts'
import type { WrinklesBase } from './wrinkles-base.ts'

/** @throws FurrowError when a caller without types passes something else than wrinkles. */
export function checkWrinkles(wrinkles: WrinklesBase, who: string): void {
  if (!wrinkles?.mesh) throw wrongArgument(who, 'wrinkles', wrinkles, 'an object of class Wrinkles')
}
