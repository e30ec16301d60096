import { FurrowError } from '../core/error.ts'

/** Name of the caller in errors about a character. */
export const LOADER = 'WrinkleLoaderPlugin'

/**
 * Returns the error for a character without a surface that can wrinkle.
 *
 * @param aside reason in parentheses, see `emptyAside`.
 */
export function nothingToWrinkle(
  aside = '',
  remedy = 'export the face with its blendshapes or the body with its skeleton, or load the file without the option auto',
): FurrowError {
  const problem = `no wrinkles can be made: no mesh has blendshapes, and joints of a humanoid move no skin or cloth with texture coordinates${aside}`
  return new FurrowError({ who: LOADER, problem, remedy })
}

/** Returns the error for a surface on which no wrinkles can be drawn. */
export function withoutAreas(reason: string): FurrowError {
  return new FurrowError({
    who: LOADER,
    problem: `no wrinkles can be made: ${reason}`,
    remedy: 'draw wrinkles with `npx furrow strokes`, or load the file without the `auto` option',
  })
}
