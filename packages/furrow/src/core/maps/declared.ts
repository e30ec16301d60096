import { FurrowError } from '../error.ts'

/** Name of the glTF material extension specified in docs/FURROW_wrinkle_maps.md. */
export const WRINKLE_MAPS = 'FURROW_wrinkle_maps'

/**
 * Checks that a file declares the extension, as glTF requires: tools drop what is not declared.
 *
 * @param json of the file.
 * @throws FurrowError when it does not.
 */
export function checkDeclared({ extensionsUsed }: { extensionsUsed?: unknown }, who: string): void {
  if (Array.isArray(extensionsUsed) && extensionsUsed.includes(WRINKLE_MAPS)) return
  throw new FurrowError({
    who,
    problem: `extensionsUsed lacks ${WRINKLE_MAPS}`,
    remedy: 'add it: tools drop extensions that are not declared',
  })
}
