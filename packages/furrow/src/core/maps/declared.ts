import { FurrowError } from '../error.ts'

/** Name of Furrow's glTF material extension, specified in `docs/FURROW_wrinkle_maps.md`. */
export const WRINKLE_MAPS = 'FURROW_wrinkle_maps'

/**
 * Checks that a file declares `WRINKLE_MAPS` in `extensionsUsed`, as glTF requires.
 *
 * @throws FurrowError if the declaration is missing.
 */
export function checkDeclared({ extensionsUsed }: { extensionsUsed?: unknown }, who: string): void {
  if (Array.isArray(extensionsUsed) && extensionsUsed.includes(WRINKLE_MAPS)) return
  throw new FurrowError({
    who,
    problem: `extensionsUsed lacks ${WRINKLE_MAPS}`,
    remedy: 'add the name, because tools drop undeclared extensions',
  })
}
