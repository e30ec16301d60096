/** Page that draws faces in Godot. `run.mjs` and `picture.mjs` open it. */
import { command, type Json, startGodot } from '../../test/godot/start-godot.ts'

declare global {
  interface Window {
    /** Loads copies of a face into a new scene. Returns the number of faces with wrinkles. */
    openFaces(id: number, address: string, copies: number): Promise<number>
    /** Calls a method of `test/godot/project/face_scene.gd`. */
    callGodot(method: string, args: Json): Promise<unknown>
  }
}

// Godot itself complains about sparse accessors with padding, but reads them.
await startGodot((text) => /furrow|res:/i.test(text) && console.error(text))

window.openFaces = async (id, address, copies) => {
  const bytes = await (await fetch(address)).arrayBuffer()
  const { faces, error } = await command<{ faces: number; error?: string }>(
    'open',
    { id, copies, is_face: true },
    bytes,
  )
  if (error) throw new Error(`bench: Godot cannot load the face, got "${error}"`)
  return faces
}

window.callGodot = command
