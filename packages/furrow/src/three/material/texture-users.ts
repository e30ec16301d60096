import type { Texture } from 'three'

const users = new WeakMap<Texture, number>()

/** Increments the user count of a texture. */
export function retain(texture: Texture): void {
  users.set(texture, (users.get(texture) ?? 0) + 1)
}

/** Decrements the user count of a texture, and disposes of the texture if it has no users. */
export function release(texture: Texture): void {
  const left = (users.get(texture) ?? 1) - 1
  users.set(texture, left)
  if (left === 0) texture.dispose()
}
