import { type AutoOptions, type AutoProgress, autoWrinkles } from '../author/auto/auto.ts'
import { chooseSkin } from '../author/auto/surface/choose-skin.ts'
import { autoWrinkleSet } from '../author/auto/wrinkle-set.ts'
import { type CharacterData, skinOf } from './character.ts'
import { keep, keyOf, recall } from './kept.ts'

/** Wrinkles for the skin of a character. */
export interface CharacterWrinkles {
  /** Index of the mesh that is the skin. */
  mesh: number
  set: ReturnType<typeof autoWrinkleSet>
}

/**
 * Makes wrinkles for the skin of a character, which is chosen as `furrow auto` chooses it, or finds those that were kept of an earlier time.
 *
 * @param made is called with them, and may take their buffers.
 * @returns when they are kept, where that is possible.
 */
export async function makeCharacterWrinkles(
  character: CharacterData,
  options: AutoOptions,
  version: string,
  progress: AutoProgress,
  made: (wrinkles: CharacterWrinkles) => void,
): Promise<void> {
  const candidates = character.map((mesh) => {
    const { isLit, frame } = mesh
    return { skin: skinOf(mesh), isLit, frame }
  })
  const key = await keyOf({ version, options, candidates })
  const known = await recall<CharacterWrinkles>(version, key)
  if (known) return made(known)
  const { index } = chooseSkin(candidates)!
  const { skin, frame } = candidates[index]
  const wrinkles = autoWrinkles(skin, { frame, ...options }, progress)
  const result = { mesh: index, set: autoWrinkleSet(wrinkles) }
  await keep(version, key, result, () => made(result))
}
