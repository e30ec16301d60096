/** Bytes on the GPU of the maps that faces in the mode `auto` have made. */
let allocated = 0

/** Takes bytes for a map if no more than the budget is then allocated. */
export function allocate(bytes: number, budget: number): boolean {
  if (allocated + bytes > budget) return false
  allocated += bytes
  return true
}

/** Gives them back. */
export function free(bytes: number): void {
  allocated -= bytes
}

/** Bytes of a map with mipmaps, which take a third. */
export function bytesOfMap(
  { width, height }: { width: number; height: number },
  bytesOfTexel: number,
): number {
  return Math.ceil((width * height * bytesOfTexel * 4) / 3)
}
