import type { Texture } from 'three'

const users = new WeakMap<Texture, number>()

/** Counts one user more of a texture. */
export function retain(texture: Texture): void {
  users.set(texture, (users.get(texture) ?? 0) + 1)
}

/** Counts one user less, and frees the texture after the last. */
export function release(texture: Texture): void {
  const left = (users.get(texture) ?? 1) - 1
  users.set(texture, left)
  if (left === 0) texture.dispose()
}
