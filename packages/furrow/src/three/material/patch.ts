/** An edit of a material's shader. Whoever changes it has the material built anew. */
export interface Patch {
  /** Whether it is in effect, as it is at first; else the material's own program is built, as if it had never been edited. */
  setShown(isShown: boolean): void
  undo(): void
}
