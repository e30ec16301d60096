/** Maximum number of areas of a character, and maximum size of its maps as PNG files in bytes. */
export const CHARACTER_LIMITS = { areas: 160, bytes: 12 * 1024 * 1024 } as const

/** Counts the areas and maps that a character gets. */
export class CharacterBudget {
  #areas = 0
  #bytes = 0

  /**
   * Counts the wrinkles of one more surface. The first surface always fits.
   *
   * @param areas number of areas.
   * @param bytes size of all maps as PNG files.
   * @returns the reason, a clause for a message, if they would exceed a limit. They are not counted then.
   */
  add(areas: number, bytes: number): string | undefined {
    const [allAreas, allBytes] = [this.#areas + areas, this.#bytes + bytes]
    if (this.#areas > 0 && allAreas > CHARACTER_LIMITS.areas)
      return `larger surfaces use most of the ${CHARACTER_LIMITS.areas} areas of a character`
    if (this.#areas > 0 && allBytes > CHARACTER_LIMITS.bytes)
      return `larger surfaces use most of the ${CHARACTER_LIMITS.bytes >> 20} MB for the maps of a character; choose a smaller size`
    ;[this.#areas, this.#bytes] = [allAreas, allBytes]
    return undefined
  }
}
