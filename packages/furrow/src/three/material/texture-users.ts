import type { Texture } from 'three'

const users = new WeakMap<Texture, number>()

/** Adds a user of a texture. */
export function retain(texture: Texture): void {
  users.set(texture, (users.get(texture) ?? 0) + 1)
}

/** Removes a user of a texture, and frees it with the last one. */
export function release(texture: Texture): void {
  const left = (users.get(texture) ?? 1) - 1
  users.set(texture, left)
  if (left === 0) texture.dispose()
}
